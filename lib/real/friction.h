/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_FRICTION_H
#define ROLLCOIN_FRICTION_H

#include "../motion/state.h"

#include "contact.h"

/* Whether a slide of a body can be computed with: COIN_OK or COIN_ESTATE. */
int32_t coin_priv_check_slide(const coin_slide *d, const coin_priv_body *b);

/* The variables of a slide; *y are those of its state. */
coin_priv_slip coin_priv_slip_start(const coin_slide *d,
                                    const coin_priv_variables *y, double a);

/* Whether a coin slips: faster than COIN_PRIV_SLIP_LEAST, and than the rounding
 * of the speeds whose difference the slip is. */
int coin_priv_slips(const coin_priv_contact *t, const coin_priv_slip *y);

/* The velocity of the centre along x and z of a coin that slips by y->uX and
 * y->uh. */
void coin_priv_centre_velocity(double v[2], const coin_priv_slip *y, double a);

#endif
