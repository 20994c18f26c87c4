/* SPDX-License-Identifier: MIT */
/* coin_advance_until() against orbits, which take no steps: a fine search for
 * the first moment at which a bit holds. */
#include "support/check.h"
#include "support/peaks.h"

#include <math.h>

enum { TRIED = 150, NEAR = 20 };

/* Calls, and judges: nothing above mu by the excess was passed over, nothing
 * below by as much was stopped at, and the bits are those of coin_check(). */
static int32_t judged(const struct motion *m, double t, double tol, double mu)
{
    const int32_t bits = COIN_SLIPS | COIN_LIFTS;
    const double excess = excess_of(tol);
    double reached = NAN, at;
    coin_state s = m->s;
    const int32_t got =
        coin_advance_until(&s, &m->p, m->side * t, tol, mu, bits, &reached);
    check(got >= 0);
    check_status(coin_check(&s, &m->p, COIN_RK4, 0, mu) & bits, got);
    reached *= m->side;
    check(got == 0 ? reached == t : reached >= 0 && reached <= t);
    const double clear = reached - 2 * tol * m->unit;
    if (clear > 0)
        check(motion_largest(m, clear, &at) <= mu * (1 + excess));
    if (got != 0)
        check(motion_ratio(m, reached) > mu * (1 - excess));
    return got;
}

static void the_first_event_is_that_of_a_fine_search(void **unused)
{
    (void)unused;
    struct random r = random_begin(181);
    int found = 0, none = 0;
    const int count = tries_asked(TRIED);
    for (int i = 0; i < count; ++i) {
        const struct motion m = motion_any(&r);
        const double t = random_between(&r, 0, 6) * m.unit;
        const double mu = pow(10, random_between(&r, -1, 1));
        const double tols[] = {1e-11, 1e-9, 1e-6};
        const int32_t got = judged(&m, t, tols[i % 3], mu);
        *(got ? &found : &none) += 1;
    }
    check(found > count / 10 && none > count / 10);
}

static void an_excursion_is_found_that_hardly_exceeds_mu(void **unused)
{
    (void)unused;
    struct random r = random_begin(182);
    const int count = tries_asked(NEAR);
    for (int i = 0; i < count; ++i) {
        double t, most, at;
        const struct motion m = motion_with_peak(&r, &t, &most, &at);
        for (double tol = 1e-10; tol < 1e-5; tol *= 1e4) {
            const double beyond = 1 + 1.01 * excess_of(tol);
            check(judged(&m, t, tol, most / beyond) != 0);
            check(judged(&m, t, tol, most * beyond) == 0);
        }
    }
}

/* Half the time that F/N exceeds mu around a peak. */
static double half_width(const struct motion *m, double mu, double at)
{
    double inside = 0, outside = 0.05 * m->unit;
    for (int i = 0; i < 60; ++i) {
        const double d = (inside + outside) / 2;
        if (motion_ratio(m, at - d) > mu)
            inside = d;
        else
            outside = d;
    }
    return inside;
}

/* The call begins just before the excursion, or ends just within it. */
static void an_excursion_at_either_end_is_found(void **unused)
{
    (void)unused;
    struct random r = random_begin(183);
    const int count = tries_asked(NEAR);
    for (int i = 0; i < count; ++i) {
        double t, most, at;
        struct motion m = motion_with_peak(&r, &t, &most, &at);
        const double mu = most / (1 + 2 * excess_of(1e-10)),
                     w = half_width(&m, mu, at);
        const double part = random_between(&r, 1e-3, 1);
        check(judged(&m, at - w + (1e-3 + part) * w, 1e-10, mu) != 0);
        m.s = motion_after(&m, at - (1 + part) * w);
        if (coin_orbit_init(&m.o, &m.s, &m.p) != COIN_OK)
            continue;
        check(judged(&m, t, 1e-10, mu) != 0);
        check(judged(&m, 2 * w, 1e-10, mu) != 0);
    }
}

/* The search takes a long step in parts, here in three.  The excursion lies in
 * the second. */
static void an_excursion_in_the_middle_of_a_step_is_found(void **unused)
{
    (void)unused;
    const coin_state start = {.theta = -1.239, .wX = -0.0166, .wZ = 13.33};
    const double t = -0.1, mu = 0.691664;
    double most = 0, reached;
    coin_params p;
    coin_force f;
    check_status(coin_params_body(&p, 1, 1, 1, 30, 36), COIN_OK);
    coin_state s = start;
    for (int i = 0; i < 100; ++i) {
        check_status(coin_advance(&s, &p, t / 100, 1e-10, NULL), COIN_OK);
        check_status(coin_reaction(&s, &p, &f), COIN_OK);
        most = fmax(most, f.ratio);
    }
    check(most > mu * (1 + 1e-6) && f.ratio < mu * (1 - 1e-3));
    s = start;
    check_status(coin_advance_until(&s, &p, t, 1e-6, mu, COIN_SLIPS, &reached),
                 COIN_SLIPS);
    check_status(coin_reaction(&s, &p, &f), COIN_OK);
    check_near(f.ratio, mu, 1e-6 * mu);
    check(reached > t);
}

static void without_an_event_it_is_coin_advance(void **unused)
{
    (void)unused;
    const int count = tries_asked(80);
    struct random r = random_begin(184);
    for (int i = 0; i < count; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.5);
        const double t = random_between(&r, -9, 9) * natural_time(&p);
        const double tol = pow(10, random_between(&r, -13, -2));
        coin_state want = s, got = s;
        double to = 7, reached = 7;
        const int32_t status = coin_advance(&want, &p, t, fmin(tol, 1e-6), &to);
        const int32_t end = coin_advance_until(&got, &p, t, tol, INFINITY,
                                               COIN_SLIPS, &reached);
        check_status(end, status);
        check_same(&got, &want, sizeof got);
        check(reached == to);
    }
}

/* Where the series (54) leads far beyond the time, and where heading or roll
 * leave their range on the way or in the last bit of it. */
static void its_ends_are_those_of_coin_advance_too(void **unused)
{
    (void)unused;
    const double far = 2147483648.0;
    const struct {
        coin_state s;
        double t, tol;
    } of[] = {
        {{0x1.79f3cbf1f06d6p+0, 0, 0, 0, 0, 0x1.70a703047fd94p+2,
          -0x1.218a21df2d8bbp+3, -0x1.e1920540bab3dp+1},
         0x1.a64a0c7ea61d7p-1,
         0x1.715ba20886dfbp-13},
        {{0.3, far, 0, 0, 0, 0, 1, 1}, 1, 1e-9},
        {{0.3, far - 0.5, 0, 0, 0, 0, 1, 1}, 1, 1e-9},
        {{0.3, far, 0, 0, 0, 0, 1, 1}, 1e-3, 1e-9},
        {{0, 0, far - 2, 0, 0, 0, 0, 1}, 2 + 1e-5, 1e-6},
    };
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (size_t i = 0; i < sizeof of / sizeof *of; ++i) {
        coin_state want = of[i].s, got = of[i].s;
        double to = 7, reached = 7;
        check_note("case %zu", i);
        const double tol = fmin(of[i].tol, 1e-6);
        const int32_t status = coin_advance(&want, &p, of[i].t, tol, &to);
        check(status == (i == 0 ? COIN_OK : COIN_ERANGE));
        check_status(coin_advance_until(&got, &p, of[i].t, of[i].tol, INFINITY,
                                        COIN_SLIPS, &reached),
                     status);
        check_same(&got, &want, sizeof got);
        check(reached == to);
    }
}

/* Coins that turn fast enough to get up again, and do so next to cos theta =
 * 0.01, a little below it or a little above, within the call. */
static void a_brief_approach_to_the_table_is_found(void **unused)
{
    (void)unused;
    struct random r = random_begin(184);
    const double tols[] = {1e-11, 1e-9, 1e-6};
    for (int i = 0; i < 300; ++i) {
        const int below = i % 2;
        const double off = pow(10, random_between(&r, -4, -2));
        const double nearest = 0.01 * (below ? 1 - off : 1 + off);
        coin_state s = {
            .theta = acos(nearest),
            .wY = random_between(&r, 0.8, 2),
            .wZ = random_between(&r, 0, 1),
        };
        const double x = random_between(&r, 0.05, 0.6), tol = tols[i % 3];
        const double y = random_between(&r, 0.05, 0.6);
        coin_params p;
        double reached;
        check_note("coin %d", i);
        check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
        check_status(coin_advance(&s, &p, -x, 1e-13, NULL), COIN_OK);
        check(cos(s.theta) > 0.0102);
        const int32_t got = coin_advance_until(&s, &p, x + y, tol, INFINITY,
                                               COIN_NEARLY_FLAT, &reached);
        check_status(got, below ? COIN_NEARLY_FLAT : COIN_OK);
        if (below) {
            check(reached < x);
            check_near(cos(s.theta), 0.01, 1e-5);
        }
    }
}

static void a_bit_that_holds_at_the_start_is_returned_at_once(void **unused)
{
    (void)unused;
    const coin_state leans = {1.5, 0, 0, 0, 0, 0, 0, 0};
    const coin_state jumps = {0, 0, 0, 0, 0, 2, 0, 0};
    const coin_state flat = {1.565, 0, 0, 0, 0, 1, 0, 0};
    const struct {
        coin_state s;
        double mu;
        int32_t bits, want;
    } of[] = {
        {leans, 0.1, COIN_SLIPS, COIN_SLIPS},
        {leans, 0.1, COIN_SLIPS | COIN_LIFTS, COIN_SLIPS},
        {jumps, 0.1, COIN_LIFTS | COIN_SLIPS, COIN_LIFTS},
        {flat, 1e9, COIN_NEARLY_FLAT, COIN_NEARLY_FLAT},
    };
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (size_t i = 0; i < sizeof of / sizeof *of; ++i) {
        coin_state s = of[i].s;
        double reached = 7;
        check_note("case %zu", i);
        check_status(
            coin_advance_until(&s, &p, 1, 1e-9, of[i].mu, of[i].bits, &reached),
            of[i].want);
        check_same(&s, &of[i].s, sizeof s);
        check(reached == 0);
    }
}

static void bad_arguments_are_refused(void **unused)
{
    (void)unused;
    const struct {
        double t, tol, mu;
        int32_t bits, want;
    } bad[] = {
        {1, 0.5e-13, 1, 1, COIN_EARG},      {1, 2e-2, 1, 1, COIN_EARG},
        {1, NAN, 1, 1, COIN_EARG},          {1, 1e-9, -1, 1, COIN_EARG},
        {1, 1e-9, NAN, 1, COIN_EARG},       {1, 1e-9, 1, 0, COIN_EARG},
        {1, 1e-9, 1, 4, COIN_EARG},         {1, 1e-9, 1, 1 | 16, COIN_EARG},
        {1, 1e-9, 1, -1, COIN_EARG},        {NAN, 1e-9, 1, 1, COIN_ESTEP},
        {INFINITY, 1e-9, 1, 1, COIN_ESTEP}, {1e16, 1e-9, 1, 1, COIN_ESTEP},
    };
    const coin_state before = {0.1, 0, 0, 0, 0, 0, 0, 5};
    coin_state s = before;
    coin_params p, heavy;
    double reached = 7;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    heavy = p;
    heavy.mass = -1;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        check_note("case %zu", i);
        check_status(coin_advance_until(&s, &p, bad[i].t, bad[i].tol, bad[i].mu,
                                        bad[i].bits, &reached),
                     bad[i].want);
        check_same(&s, &before, sizeof s);
        check(reached == 7);
    }
    check_status(coin_advance_until(NULL, &p, 1, 1e-9, 1, 1, NULL), COIN_EARG);
    check_status(coin_advance_until(&s, NULL, 1, 1e-9, 1, 1, NULL), COIN_EARG);
    check_status(coin_advance_until(&s, &heavy, NAN, 1e-9, 1, 1, NULL),
                 COIN_EPARAMS);
    s.theta = 2;
    check_status(coin_advance_until(&s, &p, NAN, 1e-9, 1, 1, NULL),
                 COIN_ESTATE);
}

static void a_fall_and_a_rest_end_it_as_coin_advance(void **unused)
{
    (void)unused;
    coin_params p;
    coin_state falls = {0.3, 0, 0, 0, 0, 0, 0, 0}, rests = falls, same = falls;
    double reached, to;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    check_status(coin_advance(&same, &p, 10, 1e-9, &to), COIN_EFLAT);
    check_status(coin_advance_until(&falls, &p, 10, 1e-9, INFINITY, COIN_SLIPS,
                                    &reached),
                 COIN_EFLAT);
    check_same(&falls, &same, sizeof falls);
    check(reached == to);
    rests.theta = nextafter(1.5707963267948966, 0);
    check_status(
        coin_advance_until(&rests, &p, 1, 1e-9, INFINITY, COIN_SLIPS, &reached),
        COIN_EFLAT);
    check(reached == 0);
    check_status(
        coin_advance_until(&rests, &p, 1, 1e-9, 1, COIN_NEARLY_FLAT, &reached),
        COIN_NEARLY_FLAT);
}

static void a_time_of_0_changes_nothing(void **unused)
{
    (void)unused;
    const coin_state before = {0.1, 0, 0, 0, 0, 0.1, 0.2, 5};
    coin_state s = before;
    coin_params p;
    double reached = 7;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    check_status(coin_advance_until(&s, &p, 0, 1e-9, 9, COIN_SLIPS, &reached),
                 COIN_OK);
    check_same(&s, &before, sizeof s);
    check(reached == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(the_first_event_is_that_of_a_fine_search),
        TEST(an_excursion_is_found_that_hardly_exceeds_mu),
        TEST(an_excursion_at_either_end_is_found),
        TEST(an_excursion_in_the_middle_of_a_step_is_found),
        TEST(without_an_event_it_is_coin_advance),
        TEST(its_ends_are_those_of_coin_advance_too),
        TEST(a_brief_approach_to_the_table_is_found),
        TEST(a_bit_that_holds_at_the_start_is_returned_at_once),
        TEST(bad_arguments_are_refused),
        TEST(a_fall_and_a_rest_end_it_as_coin_advance),
        TEST(a_time_of_0_changes_nothing),
    };
    return RUN_TESTS(tests);
}
