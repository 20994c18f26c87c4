/* SPDX-License-Identifier: MIT */
/* The contact of a coin with a thickness, or with a pull: apart, so that a
 * program without coin_move() does not hold it. */
#include "../motion/pinned.h"

#include "contact.h"

coin_priv_push coin_priv_thick_contact(double *d, const double *y,
                                       const coin_priv_law *l, int mode,
                                       coin_priv_direction n, double by)
{
    return contact(d, y, l, mode, n, by, 0);
}
