/* SPDX-License-Identifier: MIT */
/* luck.c: how a toss ends, for the map of luck. */
#include "page.h"

/* How the coin of the start ends, let go at y and turning at wX: COIN_HEADS,
 * COIN_TAILS or COIN_EDGE; or an error.  It takes the steps that the trail
 * takes, so that the page plays this very toss, until the end is decided. */
int32_t PAGE(page_luck)(double y, double wX)
{
    const double frame = page_frame();
    coin_body b = page.start;
    int32_t status = COIN_OK;

    b.y = y;
    b.s.wX = wX;
    for (int32_t k = 0; k < KNOTS && status >= 0 && !(status & COIN_MORE);
         ++k) {
        if (status & (COIN_RESTS | COIN_DECIDED))
            return coin_body_face(&b, &page.params);
        status = coin_move(&b, &page.params, &page.table, frame, TOLERANCE_REAL,
                           COIN_DECIDED, NULL);
    }
    return COIN_ESTEP;
}
