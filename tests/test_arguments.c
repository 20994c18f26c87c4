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

/* ---------------------------------------------------------------- arguments */
/* Rolls nearly upright, so that every function accepts it. */
static const coin_state good_state = {0.1, 1, 2, 3, 4, 0.1, 0.1, 2};
static const coin_params good_params = {1, 1, 1, 0.25, 0.5, 0, {0, 0}};
static const struct numbers good = {
    71,  {1, 1, 1, 0.25, 0.5, 0, {0, 0}}, {0.5, 1, 2, 1, 4, 0, 1, 1}, -0.01, 20,
    0.3,
};

/* Outputs hold a pattern. */
struct arguments {
    union argument memory[POINTERS];
    void *pointers[POINTERS];
};

static void begin(struct arguments *a, const struct function *f,
                  const coin_state *s, const coin_params *p)
{
    memset(a->memory, 0xa5, sizeof a->memory);
    function_arguments(a->memory, f, s, p, &good);
    for (size_t i = 0; i < POINTERS; ++i)
        a->pointers[i] = a->memory[i].bytes;
}

/* Calls with the null-th pointer null, or none if that is POINTERS; on an
 * error nothing may have changed. */
static int32_t call(const struct function *f, const coin_state *s,
                    const coin_params *p, size_t null)
{
    static struct arguments a, before;
    begin(&a, f, s, p);
    before = a;
    if (null < POINTERS)
        a.pointers[null] = NULL;
    const int32_t status = f->call(a.pointers, &good);
    if (status < 0)
        check_same(a.memory, before.memory, sizeof a.memory);
    return status;
}

/* An error is this status, or NaN. */
static void check_refused(const struct function *f, const coin_state *s,
                          const coin_params *p, size_t null, int32_t want)
{
    const int32_t status = call(f, s, p, null);
    if (status != NOT_A_NUMBER)
        check_status(status, want);
}

/* ---------------------------------------------------------------- good ones */
/* The table's own check: each call succeeds, writes what it is said to write
 * and nothing else. */
TEST(good_arguments_are_accepted_and_outputs_written)
{
    static struct arguments a, before;
    for (size_t k = 0; k < function_count; ++k) {
        const struct function *f = &functions[k];
        begin(&a, f, &good_state, &good_params);
        before = a;
        check_note("%s", f->name);
        check_status(f->call(a.pointers, &good), COIN_OK);
        for (size_t i = 0; i < POINTERS; ++i) {
            const char kind = i < strlen(f->kinds) ? f->kinds[i] : '-';
            check_note("%s, pointer %zu", f->name, i);
            check((memcmp(&a.memory[i], &before.memory[i], BUFFER) != 0) ==
                  (strchr("SGPLon", kind) != NULL));
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
            check_refused(f, &good_state, &good_params, i, want);
            /* A null pointer comes before any other error. */
            if (want == COIN_EARG)
                check_refused(f, &bad_state, &bad_params, i, want);
        }
    }
}

/* ----------------------------------------------------------------- bad ones */
static const struct {
    const char *what;
    coin_params p;
} bad_params[] = {
    {"mass negative", {-1, 1, 1, 0.25, 0.5, 0, {0, 0}}},
    {"mass NaN", {NAN, 1, 1, 0.25, 0.5, 0, {0, 0}}},
    {"radius 0", {1, 0, 1, 0.25, 0.5, 0, {0, 0}}},
    {"radius infinite", {1, INFINITY, 1, 0.25, 0.5, 0, {0, 0}}},
    {"gravity 0", {1, 1, 0, 0.25, 0.5, 0, {0, 0}}},
    {"gravity negative", {1, 1, -9.81, 0.25, 0.5, 0, {0, 0}}},
    {"I_X 0", {1, 1, 1, 0, 0.5, 0, {0, 0}}},
    {"I_Z NaN", {1, 1, 1, 0.25, NAN, 0, {0, 0}}},
    {"I_Z > 2 I_X", {1, 1, 1, 0.25, 0.51, 0, {0, 0}}},
    {"thickness", {1, 1, 1, 0.25, 0.5, 5, {0, 0}}},
    {"reserved[0]", {1, 1, 1, 0.25, 0.5, 0, {1, 0}}},
    {"reserved[1]", {1, 1, 1, 0.25, 0.5, 0, {0, NAN}}},
    {"mass 1e16", {1e16, 1, 1, 2.5e15, 5e15, 0, {0, 0}}},
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
            check_refused(f, &good_state, p, POINTERS, COIN_EPARAMS);
            check_refused(f, &bad_state, p, POINTERS, COIN_EPARAMS);
            ++tried;
        }
    }
    check(tried > 200);
}

/* What takes a coin with a thickness: coin_move() and what belongs to it. */
static const char *const thick[] = {
    "coin_move",         "coin_params_check", "coin_state_check",
    "coin_losses_check", "coin_table_check",  "coin_state_from_motion",
};

static int takes_thickness(const struct function *f)
{
    for (size_t i = 0; i < sizeof thick / sizeof *thick; ++i)
        if (strcmp(f->name, thick[i]) == 0)
            return 1;
    return strncmp(f->name, "coin_body_", 10) == 0;
}

TEST(a_thickness_is_refused_by_all_that_compute_a_thin_coin)
{
    coin_params p = good_params;
    size_t taken = 0, refused = 0;
    p.thickness = 0.1;
    for (size_t k = 0; k < function_count; ++k) {
        const struct function *f = &functions[k];
        if (!strchr(f->kinds, 'p'))
            continue;
        check_note("%s", f->name);
        if (takes_thickness(f)) {
            check_status(call(f, &good_state, &p, POINTERS), COIN_OK);
            ++taken;
        } else {
            const int32_t status = call(f, &good_state, &p, POINTERS);
            check(status == COIN_EPARAMS || status == NOT_A_NUMBER);
            ++refused;
        }
    }
    check(taken == 14 && refused > 50);
}

static const struct {
    const char *what;
    coin_state s;
} bad_states[] = {
    {"theta pi/2", {1.5707963267948966, 1, 2, 3, 4, 0, 0, 5}},
    {"theta -pi/2", {-1.5707963267948966, 1, 2, 3, 4, 0, 0, 5}},
    {"theta NaN", {NAN, 1, 2, 3, 4, 0, 0, 5}},
    {"theta infinite", {INFINITY, 1, 2, 3, 4, 0, 0, 5}},
    {"phi 1e18", {0, 1e18, 2, 3, 4, 0, 0, 5}},
    {"phi NaN", {0, NAN, 2, 3, 4, 0, 0, 5}},
    {"psi -1e18", {0, 1, -1e18, 3, 4, 0, 0, 5}},
    {"psi infinite", {0, 1, INFINITY, 3, 4, 0, 0, 5}},
    {"x NaN", {0, 1, 2, NAN, 4, 0, 0, 5}},
    {"z infinite", {0, 1, 2, 3, -INFINITY, 0, 0, 5}},
    {"wX NaN", {0, 1, 2, 3, 4, NAN, 0, 5}},
    {"wY infinite", {0, 1, 2, 3, 4, 0, INFINITY, 5}},
    {"wZ NaN", {0, 1, 2, 3, 4, 0, 0, NAN}},
    {"x 1e300", {0, 1, 2, 1e300, 4, 0, 0, 5}},
    {"z -1e300", {0, 1, 2, 3, -1e300, 0, 0, 5}},
    {"wX 1e200", {0, 1, 2, 3, 4, 1e200, 0, 5}},
    {"wY -1e200", {0, 1, 2, 3, 4, 0, -1e200, 5}},
    {"wZ 1e308", {0, 1, 2, 3, 4, 0, 0, 1e308}},
};

TEST(bad_states_are_refused_by_all)
{
    size_t tried = 0;
    for (size_t k = 0; k < function_count; ++k) {
        const struct function *f = &functions[k];
        if (!strpbrk(f->kinds, "sSgGc"))
            continue;
        for (size_t i = 0; i < sizeof bad_states / sizeof *bad_states; ++i) {
            check_note("%s, %s", f->name, bad_states[i].what);
            check_refused(f, &bad_states[i].s, &good_params, POINTERS,
                          COIN_ESTATE);
            ++tried;
        }
    }
    check(tried > 200);
}

/* ----------------------------------------------------------- the environment
 */
TEST(nothing_changes_errno_or_the_rounding_mode)
{
    static struct arguments a;
    const int modes[] = {FE_TONEAREST, FE_UPWARD};
    for (size_t k = 0; k < function_count; ++k)
        for (size_t m = 0; m < 2; ++m) {
            begin(&a, &functions[k], &good_state, &good_params);
            errno = 1234;
            check(fesetround(modes[m]) == 0);
            functions[k].call(a.pointers, &good);
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
