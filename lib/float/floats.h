/* SPDX-License-Identifier: MIT */
/* Makes a source of lib/ one for floats: included before it.
 *
 * coinf_motion.c and coinf_observe.c are sources of those folders once more:
 * the same text, compiled for floats (motion/kind.h), with these names in place
 * of those of doubles.
 *
 * A coinf_X.c with code of its own does in another way what X.c does.  What it
 * shares with other files has a name that no double has.  Its static functions
 * may have the names of those in X.c that do the same part of the work. */
#ifndef ROLLCOIN_FLOATS_H
#define ROLLCOIN_FLOATS_H

#define COIN_PRIV_FLOAT

#include <coin.h>
#include <coinf.h>

#define coin_angular_velocity coinf_angular_velocity
#define coin_axes coinf_axes
#define coin_center coinf_center
#define coin_check coinf_check
#define coin_contact coinf_contact
#define coin_energy coinf_energy
#define coin_fastest_rate coinf_fastest_rate
#define coin_force coinf_force
#define coin_integrals coinf_integrals
#define coin_matrix coinf_matrix
#define coin_params coinf_params
#define coin_params_body coinf_params_body
#define coin_params_check coinf_params_check
#define coin_params_disc coinf_params_disc
#define coin_params_ring coinf_params_ring
#define coin_quaternion coinf_quaternion
#define coin_rates coinf_rates
#define coin_reaction coinf_reaction
#define coin_state coinf_state
#define coin_state_check coinf_state_check
#define coin_state_from_motion coinf_state_from_motion
#define coin_velocity coinf_velocity

#define coin_priv_admit_each coinf_priv_admit_each
#define coin_priv_admit_start coinf_priv_admit_start
#define coin_priv_admit_step coinf_priv_admit_step
#define coin_priv_angle coinf_priv_angle
#define coin_priv_angles_hold coinf_priv_angles_hold
#define coin_priv_are_zero coinf_priv_are_zero
#define coin_priv_axes coinf_priv_axes
#define coin_priv_bits coinf_priv_bits
#define coin_priv_body coinf_priv_body
#define coin_priv_body_of coinf_priv_body_of
#define coin_priv_central coinf_priv_central
#define coin_priv_check coinf_priv_check
#define coin_priv_check_body coinf_priv_check_body
#define coin_priv_check_inline coinf_priv_check_inline
#define coin_priv_choose coinf_priv_choose
#define coin_priv_coarse_limit coinf_priv_coarse_limit
#define coin_priv_copy_state coinf_priv_copy_state
#define coin_priv_drift_slopes coinf_priv_drift_slopes
#define coin_priv_drift_slopes_of coinf_priv_drift_slopes_of
#define coin_priv_every coinf_priv_every
#define coin_priv_fall_slope coinf_priv_fall_slope
#define coin_priv_field coinf_priv_field
#define coin_priv_field_of coinf_priv_field_of
#define coin_priv_flat coinf_priv_flat
#define coin_priv_hypot coinf_priv_hypot
#define coin_priv_is_ordinary coinf_priv_is_ordinary
#define coin_priv_larger coinf_priv_larger
#define coin_priv_lean_within coinf_priv_lean_within
#define coin_priv_legendre_central coinf_priv_legendre_central
#define coin_priv_legendre_change coinf_priv_legendre_change
#define coin_priv_legendre_flat coinf_priv_legendre_flat
#define coin_priv_lesser coinf_priv_lesser
#define coin_priv_lies_flat coinf_priv_lies_flat
#define coin_priv_limits coinf_priv_limits
#define coin_priv_limits_of coinf_priv_limits_of
#define coin_priv_magnitude coinf_priv_magnitude
#define coin_priv_method_is_known coinf_priv_method_is_known
#define coin_priv_normalize coinf_priv_normalize
#define coin_priv_of_bits coinf_priv_of_bits
#define coin_priv_over coinf_priv_over
#define coin_priv_params_hold coinf_priv_params_hold
#define coin_priv_path_rates coinf_priv_path_rates
#define coin_priv_polynomials coinf_priv_polynomials
#define coin_priv_pose coinf_priv_pose
#define coin_priv_pose_plus coinf_priv_pose_plus
#define coin_priv_pose_slopes coinf_priv_pose_slopes
#define coin_priv_rate2 coinf_priv_rate2
#define coin_priv_reaction coinf_priv_reaction
#define coin_priv_reduced coinf_priv_reduced
#define coin_priv_refusal coinf_priv_refusal
#define coin_priv_refusal_limit coinf_priv_refusal_limit
#define coin_priv_rest coinf_priv_rest
#define coin_priv_sc coinf_priv_sc
#define coin_priv_sincos coinf_priv_sincos
#define coin_priv_sine_cosine coinf_priv_sine_cosine
#define coin_priv_sine_cosine_reduced coinf_priv_sine_cosine_reduced
#define coin_priv_slopes_at coinf_priv_slopes_at
#define coin_priv_some_state_holds coinf_priv_some_state_holds
#define coin_priv_state_holds coinf_priv_state_holds
#define coin_priv_state_within coinf_priv_state_within
#define coin_priv_step coinf_priv_step
#define coin_priv_step_end coinf_priv_step_end
#define coin_priv_time_holds coinf_priv_time_holds
#define coin_priv_truth coinf_priv_truth
#define coin_priv_turn_adds coinf_priv_turn_adds
#define coin_priv_turn_both coinf_priv_turn_both
#define coin_priv_turn_rates coinf_priv_turn_rates
#define coin_priv_turned coinf_priv_turned
#define coin_priv_turned_a_little coinf_priv_turned_a_little
#define coin_priv_variables coinf_priv_variables
#define coin_priv_variables_after coinf_priv_variables_after
#define coin_priv_variables_at coinf_priv_variables_at
#define coin_priv_variables_inline coinf_priv_variables_inline
#define coin_priv_variables_of coinf_priv_variables_of
#define coin_priv_variables_plus coinf_priv_variables_plus
#define coin_priv_velocity_of coinf_priv_velocity_of

#endif
