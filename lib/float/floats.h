/* SPDX-License-Identifier: MIT */
/* Makes a source of lib/ one for floats: included before it.
 *
 * coinf_motion.c and coinf_observe.c are sources of those folders once more:
 * the same text, compiled for floats (motion/kind.h), with these names in place
 * of those of doubles: types and functions of coin.h, and functions that
 * sources share.
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

#define coin_priv_angle coinf_priv_angle
#define coin_priv_check coinf_priv_check
#define coin_priv_legendre_central coinf_priv_legendre_central
#define coin_priv_legendre_flat coinf_priv_legendre_flat
#define coin_priv_refusal coinf_priv_refusal
#define coin_priv_sincos coinf_priv_sincos
#define coin_priv_variables_of coinf_priv_variables_of

#endif
