/* SPDX-License-Identifier: MIT */
/* Every function against every bad pointer, by one table: what it returns, and
 * that it then leaves everything as it was.  A row of the table lists the kinds
 * of pointers of a function.  Scalar arguments are good here; bad ones are in
 * the test of the function. */
#include "support/check.h"
#include "support/functions.h"

#include <errno.h>
#include <fenv.h>
#include <math.h>
#include <string.h>

enum { BUFFER = 32768 }; /* what a coin_orbit has room in */

/* ---------------------------------------------------------------- arguments */
/* Upright and steady, so that every function accepts it. */
static const coin_state good_state = {0, 1, 2, 3, 4, 0, 0, 5};
static const coin_params good_params = {1, 1, 1, 0.25, 0.5, {0, 0, 0}};
static const coin_losses good_losses = {.dry = 1e-6, .viscous = 1e-3};
static const coin_table good_table = {.mu_static = 0.5, .mu_kinetic = 0.4};
static const double good_doubles[4] = {0.5, 0.1, 0.2, 0.3};

struct arguments {
    union {
        unsigned char bytes[BUFFER];
        double aligned;
    } memory[POINTERS];
    void *pointers[POINTERS];
};

static void place(struct arguments *a, size_t i, const void *value, size_t size)
{
    memcpy(a->memory[i].bytes, value, size);
}

static void place_orbit(struct arguments *a, size_t i)
{
    coin_orbit o;
    check_status(coin_orbit_init(&o, &good_state, &good_params), COIN_OK);
    place(a, i, &o, sizeof o);
}

/* Rolls as the good state does. */
static void place_body(struct arguments *a, size_t i, const coin_state *s)
{
    coin_body d;
    check_status(coin_body_from_state(&d, &good_state, &good_params), COIN_OK);
    d.s = *s;
    place(a, i, &d, sizeof d);
}

/* Outputs hold a pattern. */
static struct arguments arguments_for(const struct function *f,
                                      const coin_state *s, const coin_params *p)
{
    struct arguments a;
    memset(&a, 0xa5, sizeof a);
    for (size_t i = 0; f->kinds[i]; ++i) {
        if (f->kinds[i] == 'p')
            place(&a, i, p, sizeof *p);
        else if (f->kinds[i] == 's' || f->kinds[i] == 'S')
            place(&a, i, s, sizeof *s);
        else if (f->kinds[i] == 'd')
            place(&a, i, good_doubles, sizeof good_doubles);
        else if (f->kinds[i] == 'l')
            place(&a, i, &good_losses, sizeof good_losses);
        else if (f->kinds[i] == 't')
            place(&a, i, &good_table, sizeof good_table);
        else if (f->kinds[i] == 'g' || f->kinds[i] == 'G')
            place_body(&a, i, s);
        else if (f->kinds[i] == 'b')
            place_orbit(&a, i);
    }
    return a;
}

/* Calls with the null-th pointer null, or none if that is POINTERS; on an
 * error nothing may have changed. */
static int32_t call(const struct function *f, const coin_state *s,
                    const coin_params *p, size_t null)
{
    struct arguments a = arguments_for(f, s, p);
    const struct arguments before = a;
    for (size_t i = 0; i < POINTERS; ++i)
        a.pointers[i] = i == null ? NULL : a.memory[i].bytes;
    const int32_t status = f->call(a.pointers);
    if (status < 0)
        check_same(a.memory, before.memory, sizeof a.memory);
    return status;
}

/* ---------------------------------------------------------------- good ones */
static int changed(const struct arguments *a, const struct arguments *b,
                   size_t i)
{
    return memcmp(&a->memory[i], &b->memory[i], sizeof a->memory[i]) != 0;
}

/* The table's own check: each call succeeds, writes what it is said to write
 * and nothing else. */
TEST(good_arguments_are_accepted_and_outputs_written)
{
    for (size_t k = 0; k < function_count; ++k) {
        const struct function *f = &functions[k];
        struct arguments a = arguments_for(f, &good_state, &good_params);
        const struct arguments before = a;
        for (size_t i = 0; i < POINTERS; ++i)
            a.pointers[i] = a.memory[i].bytes;
        check_note("%s", f->name);
        check_status(f->call(a.pointers), COIN_OK);
        for (size_t i = 0; i < POINTERS; ++i) {
            const char kind = i < strlen(f->kinds) ? f->kinds[i] : '-';
            check_note("%s, pointer %zu", f->name, i);
            check(changed(&a, &before, i) == (strchr("SGPon", kind) != NULL));
        }
    }
}

TEST(only_progress_may_be_null)
{
    coin_params bad_params = good_params;
    coin_state bad_state = good_state;
    bad_params.mass = NAN;
    bad_state.theta = NAN;
    for (size_t k = 0; k < function_count; ++k) {
        const struct function *f = &functions[k];
        for (size_t i = 0; f->kinds[i]; ++i) {
            const int32_t want = f->kinds[i] == 'n' ? COIN_OK : COIN_EARG;
            check_note("%s, pointer %zu null", f->name, i);
            check_status(call(f, &good_state, &good_params, i), want);
            /* A null pointer comes before any other error. */
            if (want == COIN_EARG)
                check_status(call(f, &bad_state, &bad_params, i), want);
        }
    }
}

/* ----------------------------------------------------------------- bad ones */
static const struct {
    const char *what;
    coin_params p;
} bad_params[] = {
    {"mass negative", {-1, 1, 1, 0.25, 0.5, {0, 0, 0}}},
    {"mass NaN", {NAN, 1, 1, 0.25, 0.5, {0, 0, 0}}},
    {"radius 0", {1, 0, 1, 0.25, 0.5, {0, 0, 0}}},
    {"radius infinite", {1, INFINITY, 1, 0.25, 0.5, {0, 0, 0}}},
    {"gravity 0", {1, 1, 0, 0.25, 0.5, {0, 0, 0}}},
    {"gravity negative", {1, 1, -9.81, 0.25, 0.5, {0, 0, 0}}},
    {"I_X 0", {1, 1, 1, 0, 0.5, {0, 0, 0}}},
    {"I_Z NaN", {1, 1, 1, 0.25, NAN, {0, 0, 0}}},
    {"I_Z > 2 I_X", {1, 1, 1, 0.25, 0.51, {0, 0, 0}}},
    {"reserved[0]", {1, 1, 1, 0.25, 0.5, {1, 0, 0}}},
    {"reserved[2]", {1, 1, 1, 0.25, 0.5, {0, 0, NAN}}},
    {"mass 1e16", {1e16, 1, 1, 2.5e15, 5e15, {0, 0, 0}}},
};

TEST(bad_parameters_are_refused_by_all)
{
    size_t tried = 0;
    coin_state bad_state = good_state;
    bad_state.phi = NAN;
    for (size_t k = 0; k < function_count; ++k) {
        const struct function *f = &functions[k];
        if (!strchr(f->kinds, 'p'))
            continue;
        for (size_t i = 0; i < sizeof bad_params / sizeof *bad_params; ++i) {
            const coin_params *p = &bad_params[i].p;
            check_note("%s, %s", f->name, bad_params[i].what);
            check_status(call(f, &good_state, p, POINTERS), COIN_EPARAMS);
            check_status(call(f, &bad_state, p, POINTERS), COIN_EPARAMS);
            ++tried;
        }
    }
    check(tried > 200);
}

static const struct {
    const char *what;
    coin_state s;
    int needs_params; /* refused only where the parameters are known */
} bad_states[] = {
    {"theta pi/2", {1.5707963267948966, 1, 2, 3, 4, 0, 0, 5}, 0},
    {"theta -pi/2", {-1.5707963267948966, 1, 2, 3, 4, 0, 0, 5}, 0},
    {"theta NaN", {NAN, 1, 2, 3, 4, 0, 0, 5}, 0},
    {"theta infinite", {INFINITY, 1, 2, 3, 4, 0, 0, 5}, 0},
    {"phi 1e18", {0, 1e18, 2, 3, 4, 0, 0, 5}, 0},
    {"phi NaN", {0, NAN, 2, 3, 4, 0, 0, 5}, 0},
    {"psi -1e18", {0, 1, -1e18, 3, 4, 0, 0, 5}, 0},
    {"psi infinite", {0, 1, INFINITY, 3, 4, 0, 0, 5}, 0},
    {"x NaN", {0, 1, 2, NAN, 4, 0, 0, 5}, 0},
    {"z infinite", {0, 1, 2, 3, -INFINITY, 0, 0, 5}, 0},
    {"wX NaN", {0, 1, 2, 3, 4, NAN, 0, 5}, 0},
    {"wY infinite", {0, 1, 2, 3, 4, 0, INFINITY, 5}, 0},
    {"wZ NaN", {0, 1, 2, 3, 4, 0, 0, NAN}, 0},
    {"x 1e300", {0, 1, 2, 1e300, 4, 0, 0, 5}, 1},
    {"z -1e300", {0, 1, 2, 3, -1e300, 0, 0, 5}, 1},
    {"wX 1e200", {0, 1, 2, 3, 4, 1e200, 0, 5}, 1},
    {"wY -1e200", {0, 1, 2, 3, 4, 0, -1e200, 5}, 1},
    {"wZ 1e308", {0, 1, 2, 3, 4, 0, 0, 1e308}, 1},
};

TEST(bad_states_are_refused_by_all)
{
    size_t tried = 0;
    for (size_t k = 0; k < function_count; ++k) {
        const struct function *f = &functions[k];
        const int knows = strchr(f->kinds, 'p') != NULL;
        if (!strchr("sSgG", f->kinds[0]))
            continue;
        for (size_t i = 0; i < sizeof bad_states / sizeof *bad_states; ++i) {
            const int32_t want =
                bad_states[i].needs_params && !knows ? COIN_OK : COIN_ESTATE;
            check_note("%s, %s", f->name, bad_states[i].what);
            check_status(call(f, &bad_states[i].s, &good_params, POINTERS),
                         want);
            ++tried;
        }
    }
    check(tried > 200);
}

TEST(numbers_are_nan_where_a_status_would_be_an_error)
{
    check(isnan(coin_energy(NULL, &good_params)));
    check(isnan(coin_energy(&good_state, NULL)));
    check(isnan(coin_fastest_rate(NULL, &good_params)));
    check(isnan(coin_fastest_rate(&good_state, NULL)));
    check(isnan(coin_critical_roll(NULL)));
    check(isnan(coin_critical_spin(NULL)));
    check(!isnan(coin_energy(&good_state, &good_params)));
    for (size_t i = 0; i < sizeof bad_params / sizeof *bad_params; ++i) {
        check_note("%s", bad_params[i].what);
        check(isnan(coin_energy(&good_state, &bad_params[i].p)));
        check(isnan(coin_fastest_rate(&good_state, &bad_params[i].p)));
        check(isnan(coin_critical_roll(&bad_params[i].p)));
        check(isnan(coin_critical_spin(&bad_params[i].p)));
    }
    for (size_t i = 0; i < sizeof bad_states / sizeof *bad_states; ++i) {
        check_note("%s", bad_states[i].what);
        check(isnan(coin_energy(&bad_states[i].s, &good_params)));
        check(isnan(coin_fastest_rate(&bad_states[i].s, &good_params)));
    }
}

/* ----------------------------------------------------------- the environment
 */
TEST(nothing_changes_errno_or_the_rounding_mode)
{
    const int modes[] = {FE_TONEAREST, FE_UPWARD};
    for (size_t k = 0; k < function_count; ++k)
        for (size_t m = 0; m < 2; ++m) {
            struct arguments a =
                arguments_for(&functions[k], &good_state, &good_params);
            for (size_t i = 0; i < POINTERS; ++i)
                a.pointers[i] = a.memory[i].bytes;
            errno = 1234;
            check(fesetround(modes[m]) == 0);
            functions[k].call(a.pointers);
            const int error = errno, mode = fegetround();
            check(fesetround(FE_TONEAREST) == 0);
            check_note("%s", functions[k].name);
            check(error == 1234 && mode == modes[m]);
        }
}

/* Near flat and at the edge of the range, where libm might set errno. */
TEST(errno_is_unchanged_at_the_edge_of_the_range)
{
    const coin_state edge = {
        1.5707963267948963, 0x1p31, -0x1p31, 0, 0, 1e5, 1e5, 1e5};
    const double flat[4] = {1, 1, 0, 0}, omega[3] = {0, 0, 0};
    coin_state s, out;
    coin_force force;
    double K[2];
    errno = 1234;
    check_status(coin_integrals(&edge, &good_params, K), COIN_OK);
    check_status(coin_reaction(&edge, &good_params, &force), COIN_OK);
    check_status(coin_rates(&edge, &good_params, &out), COIN_OK);
    check_status(coin_state_from_motion(&s, &good_params, flat, omega, 0, 0),
                 COIN_ESTATE);
    s = edge;
    check_status(coin_step(&s, &good_params, 1), COIN_ERANGE);
    check(errno == 1234);
}

/* An output may be the input of the same type. */
TEST(rates_may_overwrite_their_state)
{
    const coin_state s = {0.5, 1, 2, 3, 4, 5, 6, 7};
    coin_state want, both = s;
    check_status(coin_rates(&s, &good_params, &want), COIN_OK);
    check_status(coin_rates(&both, &good_params, &both), COIN_OK);
    check_same(&both, &want, sizeof want);
}
