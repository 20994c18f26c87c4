/* SPDX-License-Identifier: MIT */
/* Turning a pair of sine and cosine: for one double, for pairs of doubles and
 * for lanes. */
#include "angles.h"
#if COIN_PRIV_WIDTH
#define COIN_PRIV_ABREAST
#include "number.t.h"

#include "angles.t.h"
#undef COIN_PRIV_ABREAST
#include "kind.h"
#endif

#include "support/check.h"
#include "support/random.h"

#include <math.h>

enum { TRIED = 100000 };

/* The pair of an angle, as far as doubles hold it. */
static coin_priv_sc pair_of(double angle)
{
    const coin_priv_sc r = {sin(angle), cos(angle)};
    return r;
}

/* How far a pair is from *from turned by d: the distance in the plane, in u.
 * Long double has 11 bits more, and under valgrind none. */
static double off_by(coin_priv_sc got, coin_priv_sc from, double d)
{
    const long double s = sinl(d), c = cosl(d);
    const long double ds = got.s - (from.s * c + from.c * s);
    const long double dc = got.c - (from.c * c - from.s * s);
    return (double)hypotl(ds, dc) / U;
}

/* In u of the norm: what lib/motion/angles.t.h states. */
TEST(a_pair_is_turned_to_a_few_u)
{
    check_long_double();
    const struct {
        double most, least_seen, bound;
    } turns[] = {{0.5, 1.2, 2}, {1, 2, 3}, {1.5707963, 3, 5}};
    struct random r = random_begin(301);
    for (int k = 0; k < 3; ++k) {
        double worst = 0;
        for (int i = 0; i < TRIED; ++i) {
            const coin_priv_sc from = pair_of(random_between(&r, -3.15, 3.15));
            const double size = i % 2 ? pow(10, random_between(&r, -20, 0)) : 1;
            const double d = size * turns[k].most * random_between(&r, -1, 1);
            worst = fmax(worst, off_by(coin_priv_turned(from, d), from, d));
        }
        check_note("turns of up to %g", turns[k].most);
        check_within(worst, turns[k].least_seen, turns[k].bound);
    }
}

/* The first term left out, d^6/720, is 0.6 u where its range ends, and 37 u at
 * twice as much. */
TEST(a_little_turn_is_as_good_up_to_its_limit_and_not_beyond)
{
    check_long_double();
    struct random r = random_begin(302);
    const double limit = COIN_PRIV_LITTLE_TURN;
    double worst = 0, beyond = 0;
    for (int i = 0; i < TRIED; ++i) {
        const coin_priv_sc from = pair_of(random_between(&r, -3.15, 3.15));
        const double d = limit * random_between(&r, -1, 1);
        worst =
            fmax(worst, off_by(coin_priv_turned_a_little(from, d), from, d));
        beyond = fmax(beyond, off_by(coin_priv_turned_a_little(from, 2 * d),
                                     from, 2 * d));
    }
    check_within(worst, 0.5, 2);
    check_within(beyond, 20, 40);
}

/* Backward is forward mirrored, and 0 is no turn, to the bit. */
TEST(turns_are_odd_and_a_turn_of_0_changes_nothing)
{
    struct random r = random_begin(303);
    for (int i = 0; i < 10000; ++i) {
        const coin_priv_sc from = pair_of(random_between(&r, -3.15, 3.15));
        const coin_priv_sc mirrored = {-from.s, from.c};
        const double d = random_between(&r, -1.5, 1.5);
        const coin_priv_sc a = coin_priv_turned(from, d);
        const coin_priv_sc b = coin_priv_turned(mirrored, -d);
        const coin_priv_sc e = coin_priv_turned_a_little(from, d / 300);
        const coin_priv_sc f = coin_priv_turned_a_little(mirrored, -d / 300);
        check(a.s == -b.s && a.c == b.c && e.s == -f.s && e.c == f.c);
        const coin_priv_sc same = coin_priv_turned(from, 0);
        const coin_priv_sc still = coin_priv_turned_a_little(from, 0);
        check(same.s == from.s && same.c == from.c);
        check(still.s == from.s && still.c == from.c);
    }
}

/* ------------------------------------------------------------------- widths */
#if COIN_PRIV_WIDTH
static coin_lanes all(double x)
{
    const coin_lanes none = {0};
    return none + x;
}

static void same_bits(coin_priv_sc one, coin_pair_sc two, coin_lanes_sc many)
{
    const coin_priv_sc b = {two.s[1], two.c[1]};
    const coin_priv_sc c = {many.s[COIN_PRIV_LANES - 1],
                            many.c[COIN_PRIV_LANES - 1]};
    check_same(&b, &one, sizeof b);
    check_same(&c, &one, sizeof c);
}

/* Angles of all sizes up to 2^31, multiples of pi/2 and zeros. */
static double any_angle(struct random *r, int i)
{
    const double side = i % 2 ? 1 : -1;
    if (i < 4)
        return i < 2 ? side * 0.0 : side * 0x1p31;
    if (i % 5 == 0)
        return side * floor(random_between(r, 0, 1e6)) * COIN_PRIV_HALF_PI;
    return side * 0x1p31 * pow(10, random_between(r, -25, 0));
}

TEST(pairs_and_lanes_have_the_bits_of_one_double)
{
    struct random r = random_begin(304);
    for (int i = 0; i < 50000; ++i) {
        const double x = any_angle(&r, i), d = random_between(&r, -1.5, 1.5);
        const coin_priv_sc one = coin_priv_sine_cosine(x);
        const coin_pair_sc two = coin_pair_sine_cosine(coin_pair_of(1, x));
        const coin_lanes_sc many = coin_lanes_sine_cosine(all(x));
        const double e = d * COIN_PRIV_LITTLE_TURN;
        check_note("x = %a, d = %a", x, d);
        same_bits(one, two, many);
        same_bits(coin_priv_turned(one, d),
                  coin_pair_turned(two, coin_pair_of(0, d)),
                  coin_lanes_turned(many, all(d)));
        same_bits(coin_priv_turned_a_little(one, e),
                  coin_pair_turned_a_little(two, coin_pair_of(0, e)),
                  coin_lanes_turned_a_little(many, all(e)));
    }
}
#endif

/* Out of line and inline, and two turned at once. */
TEST(every_form_of_one_double_has_the_same_bits)
{
    struct random r = random_begin(305);
    for (int i = 0; i < 20000; ++i) {
        const double x = random_between(&r, -10, 10);
        const double d = random_between(&r, -1.5, 1.5), e = 1 - d;
        const coin_priv_sc a = coin_priv_sincos(x);
        const coin_priv_sc b = coin_priv_sine_cosine(x);
        coin_priv_sc c = a, f = {a.c, -a.s};
        const coin_priv_sc want_c = coin_priv_turned(c, d);
        const coin_priv_sc want_f = coin_priv_turned(f, e);
        check_same(&a, &b, sizeof a);
        coin_priv_turn_both(&c, &f, d, e);
        check_same(&c, &want_c, sizeof c);
        check_same(&f, &want_f, sizeof f);
    }
}
