/* SPDX-License-Identifier: MIT */
/* A coin falls almost flat, whirls and gets up: how far its heading turns,
 * against how near to the table it comes.
 *
 *   cc nearly_flat.c $(pkg-config --cflags --libs rollcoin) -lm
 *
 * Dropped from rest in its lean with ever less spin it comes ever nearer, and
 * the turn tends to pi sqrt(1 + M a^2/I_X): Eq. (51). */
#include "turning.h"

enum { POINTS = 60 };

static void drop(double inner, double spin)
{
    coin_params p;
    coin_state s = {0.3, 0, 0, 0, 0, 0, spin, spin};

    demand(coin_params_ring(&p, 1, 1, inner, 1));
    coin_state lowest = s;
    to_turn(&lowest, &p, 1);
    one_period(&s, &p);
    printf("%g,%.6e,%.7e,%.8f\n", inner, spin, acos(0) - lowest.theta, s.phi);
}

int main(void)
{
    const double inner[] = {0, 0.5, 1};

    printf("inner,spin,distance,turn\n");
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k <= POINTS; ++k)
            drop(inner[i], pow(10, -6 + 5.3 * k / POINTS));
        printf("\n\n");
    }
    return EXIT_SUCCESS;
}
