/* SPDX-License-Identifier: MIT */
/* What an orbit costs: the power series that are computed for it.  The source
 * is compiled once more, so that they can be counted. */
#include "support/check.h"
#include "support/methods.h"
#include "support/orbits.h"
#include "support/random.h"

#include "series.h"

static int expansions;
static void counted_expand(coin_priv_series *s, const coin_priv_field *f);

#define coin_priv_series_expand counted_expand
#define coin_priv_half_period_begin counted_begin
#define coin_priv_half_period_solve counted_solve
#define coin_priv_point_variables counted_point_variables
#include "half_period.c"
#undef coin_priv_series_expand

static void counted_expand(coin_priv_series *s, const coin_priv_field *f)
{
    ++expansions;
    coin_priv_series_expand(s, f);
}

/* One series for the start, one or two for each other piece, and some for a
 * centre that is tried in vain.  Found: 1.79 for a piece, 7.2 pieces.  Without
 * the estimate of begin_beyond() 2.3 for a piece; with REACH_MARGIN 1.0001
 * 1.92. */
TEST(a_piece_takes_fewer_than_two_series)
{
    struct random r = random_begin(103);
    const int orbits = 600;
    int pieces = 0;
    expansions = 0;
    for (int i = 0; i < orbits; ++i) {
        coin_params p;
        coin_state s;
        coin_orbit o = random_orbit(&r, &p, &s);
        const coin_priv_constants b = coin_priv_constants_of(&p);
        coin_priv_half_period h;
        counted_begin(&h, &o, &s, &b);
        check(counted_solve(&h));
        check((double)h.count == o.private_frame[COIN_PRIV_COUNT]);
        pieces += h.count;
    }
    check_within((double)expansions / pieces, 1, 1.9);
    check_within((double)pieces / orbits, 1, 7.6);
}
