/* SPDX-License-Identifier: MIT */
/* What libFuzzer calls: draws a function and its arguments, calls it twice
 * over different patterns, and demands what coin.h promises of any function.
 */
#include "fuzz.h"

#include <errno.h>
#include <fenv.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The calls of one examination; the outputs of each are filled with another
 * pattern, so that what is not written, or read before, shows. */
enum { GIVEN, FIRST, SECOND, SHARED, COPIES };
static const unsigned char pattern[COPIES] = {0xa5, 0xa5, 0x5a, 0xc3};

/* A function with the memory of its arguments: blocks of their own size each,
 * with the sanitizer's walls around them. */
struct subject {
    const struct function *f;
    const struct kind *kind[ARGUMENTS];
    size_t count;
    union argument a[COPIES][ARGUMENTS];
    uint64_t done, refused;
};

struct function fuzz_functions[MOST_FUNCTIONS];
size_t fuzz_count;

static struct subject *subjects;
static const struct subject *current;
static struct world world;

static void print_members(size_t i)
{
    const double *const x = current->a[GIVEN][i].p;
    fprintf(stderr, "argument %zu:", i);
    for (size_t k = 0; k < current->kind[i]->size / sizeof *x; ++k)
        fprintf(stderr, " %.17g,", x[k]);
    fprintf(stderr, "\n");
}

static void print_call(void)
{
    const coin_params *p = &world.p;
    const coin_state *s = &world.s;
    fprintf(stderr,
            "p = {%.17g, %.17g, %.17g, %.17g, %.17g, %.17g}\n"
            "s = {%.17g, %.17g, %.17g, %.17g, %.17g, %.17g, %.17g, %.17g}\n",
            p->mass, p->radius, p->gravity, p->inertia_X, p->inertia_Z,
            p->thickness, s->theta, s->phi, s->psi, s->x, s->z, s->wX, s->wY,
            s->wZ);
    for (size_t i = 0; i < current->count; ++i)
        if (current->kind[i]->role == SCALAR)
            fprintf(stderr, "argument %zu: %.17g or %d or %" PRIu64 "\n", i,
                    current->a[GIVEN][i].d, (int)current->a[GIVEN][i].i,
                    current->a[GIVEN][i].u);
        else if (strchr("=<%lL", current->kind[i]->letter))
            print_members(i);
}

void demand_that(int holds, const char *what, const char *file, int line)
{
    if (holds)
        return;
    fprintf(stderr, "%s:%d: %s: does not hold: %s\n", file, line,
            current ? current->f->name : "fuzz", what);
    if (current)
        print_call();
    abort();
}

int same(const void *a, const void *b, size_t size)
{
    return memcmp(a, b, size) == 0;
}

double reached_by(const struct outcome *o, int t, int progress)
{
    const double asked = o->given[t].d;
    double reached;
    memcpy(&reached, o->left[progress].p, sizeof reached);
    if (o->result < 0 && same(&reached, o->given[progress].p, sizeof reached)) {
        demand(same(o->left[0].p, o->given[0].p, sizeof(coin_state)));
        return (double)NAN;
    }
    demand(fabs(reached) <= fabs(asked) &&
           (asked < 0 ? reached <= 0 : reached >= 0));
    demand(coin_state_check(o->left[0].p, &o->world->p) == COIN_OK);
    return reached;
}

static int is_all(const void *of, unsigned char byte, size_t size)
{
    const unsigned char *const at = of;
    return size == 0 || (*at == byte && same(at, at + 1, size - 1));
}

/* ---------------------------------------------------------------- at the end
 * Every function was called, was done at least once and, where it has errors,
 * refused at least once: else the target is not worth its name. */
static int counted(void)
{
    int good = 1;
    for (size_t i = 0; i < fuzz_count; ++i) {
        const struct subject *s = &subjects[i];
        const int can_fail = s->f->errors || s->f->is_number;
        good &= s->done > 0 && (s->refused > 0 || !can_fail);
        fprintf(stderr,
                "count: %-26s %12" PRIu64 " done %12" PRIu64 " refused\n",
                s->f->name, s->done, s->refused);
    }
    return good;
}

static void report(void)
{
    current = NULL;
    const int good = counted();
    if (getenv("FUZZ_DEMANDS_ALL"))
        demand(good && "every function was done and was refused");
}

/* -------------------------------------------------------------- at the start
 */
static void *memory(size_t size)
{
    void *const m = calloc(1, size);
    demand(m);
    return m;
}

static void prepare(struct subject *s, const struct function *f)
{
    s->f = f;
    while (f->signature[s->count]) {
        const struct kind *k = kind_of(f->signature[s->count]);
        demand(k && s->count < ARGUMENTS);
        for (size_t c = 0; c < COPIES && k->role != SCALAR; ++c)
            s->a[c][s->count].p = memory(k->size);
        s->kind[s->count++] = k;
    }
}

static void prepare_all(void)
{
    subjects = memory(fuzz_count * sizeof *subjects);
    for (size_t i = 0; i < fuzz_count; ++i)
        prepare(&subjects[i], &fuzz_functions[i]);
    atexit(report);
}

/* ----------------------------------------------------------------- the calls
 */
static void take_arguments(struct subject *s, struct bytes *b,
                           const struct world *w)
{
    for (size_t i = 0; i < s->count; ++i) {
        const struct kind *k = s->kind[i];
        if (k->role == SCALAR)
            k->take(b, w, &s->a[GIVEN][i]);
        else if (k->take)
            k->take(b, w, s->a[GIVEN][i].p);
        else
            memset(s->a[GIVEN][i].p, pattern[GIVEN], k->size);
    }
}

/* The arguments of one call as they were drawn, outputs with its pattern. */
static void restore(struct subject *s, int copy)
{
    for (size_t i = 0; i < s->count; ++i) {
        const struct kind *k = s->kind[i];
        if (k->role == SCALAR)
            s->a[copy][i] = s->a[GIVEN][i];
        else if (k->take)
            memcpy(s->a[copy][i].p, s->a[GIVEN][i].p, k->size);
        else
            memset(s->a[copy][i].p, pattern[copy], k->size);
    }
}

#define TRAPPED (FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW)

/* Whether a rate or a velocity is 0 or not tiny, beside its natural unit. */
static int is_ordinary(double rate, double unit)
{
    return rate == 0 || fabs(rate) >= 1e-40 * unit;
}

/* Whether the motion lies in the range in which coin.h promises that no
 * exception is raised. */
static int moves_ordinarily(const struct subject *s)
{
    const double w0 = sqrt(world.p.gravity / world.p.radius);
    const double v0 = w0 * world.p.radius;
    int good = is_ordinary(world.s.wX, w0) && is_ordinary(world.s.wY, w0) &&
               is_ordinary(world.s.wZ, w0);
    if (*s->f->signature == '=') {
        const coin_body *d = s->a[GIVEN][0].p;
        good &= is_ordinary(d->vx, v0) && is_ordinary(d->vz, v0);
    }
    return good;
}

/* Whether coin.h lets a call with this result raise what is trapped. */
static int may_raise(const struct subject *s, double result)
{
    if (s->f->is_number
            ? isnan(result)
            : (result < 0 && result >= COIN_EARG) || result == COIN_ERANGE)
        return 1;
    const int in_floats = strncmp(s->f->name, "coinf", 5) == 0;
    return in_floats || !moves_ordinarily(s); /* test_traps */
}

/* Calls with the null-th argument null; none is if that is beyond the last. */
static double call(const struct subject *s, int copy, size_t null)
{
    union argument a[ARGUMENTS];
    memcpy(a, s->a[copy], sizeof a);
    if (null < s->count)
        a[null].p = NULL;
    errno = 1234;
    feclearexcept(TRAPPED);
    const double result = s->f->call(a);
    const int raised = fetestexcept(TRAPPED);
    demand(errno == 1234);
    demand(!raised || may_raise(s, result));
    demand(fegetround() == FE_TONEAREST);
    return result;
}

static int is_error(const struct function *f, double result)
{
    return f->is_number ? isnan(result) : result < 0;
}

/* ---------------------------------------------------------- what must hold */
static void is_untouched(const struct subject *s, int copy, size_t i)
{
    const struct kind *k = s->kind[i];
    if (k->role == SCALAR)
        return;
    if (k->take)
        demand(same(s->a[copy][i].p, s->a[GIVEN][i].p, k->size));
    else
        demand(is_all(s->a[copy][i].p, pattern[copy], k->size));
}

static void inputs_are_untouched(const struct subject *s, int copy)
{
    for (size_t i = 0; i < s->count; ++i)
        if (s->kind[i]->role == READ || s->kind[i]->role == OPTIONAL)
            is_untouched(s, copy, i);
}

static void all_is_untouched(const struct subject *s, int copy)
{
    for (size_t i = 0; i < s->count; ++i)
        is_untouched(s, copy, i);
}

/* After success: the same bits from both calls, and sound ones. */
static void outputs_are_sound(const struct subject *s, size_t null,
                              const struct world *w)
{
    for (size_t i = 0; i < s->count; ++i) {
        const struct kind *k = s->kind[i];
        if (i == null || k->role == SCALAR || !k->sound)
            continue;
        demand(same(s->a[FIRST][i].p, s->a[SECOND][i].p, k->size));
        demand(k->sound(s->a[FIRST][i].p, k->size, w));
    }
}

/* Whether a function computes coins with a thickness; others refuse one. */
static int takes_thickness(const char *name)
{
    static const char *const others[] = {
        "coin_move",         "coin_params_check", "coin_state_check",
        "coin_losses_check", "coin_table_check",  "coin_state_from_motion",
    };
    int is = strncmp(name, "coin_body", 9) == 0;
    for (size_t i = 0; i < sizeof others / sizeof *others; ++i)
        is |= strcmp(name, others[i]) == 0;
    return is;
}

/* Whether the i-th argument may be null; an array may if it is of no coins. */
static int may_be_null(const struct subject *s, size_t i)
{
    const struct kind *k = s->kind[i];
    for (size_t c = 0; c < s->count && strchr("XA", k->letter); ++c)
        if (s->kind[c]->letter == 'c')
            return s->a[GIVEN][c].u == 0;
    return k->role == PROGRESS || k->role == OPTIONAL;
}

/* With what to compare an outcome: whether arguments are good, by the public
 * checks; a function has its say only in what these leave open. */
static void the_right_error_is_returned(const struct subject *s, double result,
                                        size_t null, const struct world *w)
{
    const struct function *f = s->f;
    const int single = strncmp(f->name, "coinf", 5) == 0;
    const int knows = strpbrk(f->signature, "pf") != NULL;
    const int has_state = strpbrk(f->signature, "sSgHK") != NULL;
    const int thick = w->p.thickness != 0 && !takes_thickness(f->name);
    const int bad_params =
        knows && (single ? coinf_params_check(&w->pf) != 0
                         : thick || coin_params_check(&w->p) != 0);
    const int bad_state = knows && has_state && !bad_params &&
                          (single ? coinf_state_check(&w->sf, &w->pf)
                                  : coin_state_check(&w->s, &w->p)) != COIN_OK;
    const int null_counts = null < s->count && !may_be_null(s, null);
    if (f->is_number) {
        if (null_counts || bad_params || bad_state)
            demand(isnan(result));
        return;
    }
    if (null_counts)
        demand(result == COIN_EARG);
    else if (bad_params)
        demand(result == COIN_EARG || result == COIN_EPARAMS);
    else if (bad_state)
        demand(result == COIN_EARG || result == COIN_ESTATE ||
               (result == COIN_EPARAMS && strpbrk(f->signature, "l%")));
    else if (knows && has_state && !strpbrk(f->signature, "loK>"))
        demand(result != COIN_EPARAMS && result != COIN_ESTATE);
}

static void status_is_documented(const struct function *f, double result)
{
    if (f->is_number) {
        demand(f->is_number == 2 || !isinf(result));
        return;
    }
    const int32_t status = (int32_t)result;
    demand(status == result && status >= COIN_ERANGE);
    if (status < 0)
        demand(f->errors & BIT(status));
    else
        demand((status & ~f->warnings) == 0);
}

/* An output in the place of the input of its type gives the same bits. */
static void may_share(struct subject *s, double result)
{
    const char *const from = strpbrk(s->f->signature, "sg");
    const char *const to = strpbrk(s->f->signature, "ORhj");
    if (!from || !to)
        return;
    const size_t in = (size_t)(from - s->f->signature);
    const size_t out = (size_t)(to - s->f->signature);
    void *const kept = s->a[SHARED][out].p;
    restore(s, SHARED);
    s->a[SHARED][out].p = s->a[SHARED][in].p;
    const double shared = call(s, SHARED, s->count);
    demand(same(&shared, &result, sizeof result));
    if (is_error(s->f, result))
        is_untouched(s, SHARED, in);
    else
        demand(
            same(s->a[SHARED][in].p, s->a[FIRST][out].p, s->kind[out]->size));
    s->a[SHARED][out].p = kept;
}

/* -------------------------------------------------------------------- a call
 */
static void examine(struct subject *s, struct bytes *b)
{
    world = take_world(b);
    if (strncmp(s->f->name, "coinf", 5) == 0)
        take_single(&world, b);
    const struct world w = world;
    const uint8_t which = take_byte(b);
    const size_t null = which < 240 ? ARGUMENTS : which & 7;
    take_arguments(s, b, &w);
    if (null < s->count && s->kind[null]->role == SCALAR)
        return;
    restore(s, FIRST);
    restore(s, SECOND);
    const double result = call(s, FIRST, null);
    const double again = call(s, SECOND, null);
    const struct function *f = s->f;
    const int failed = is_error(f, result);
    ++*(failed ? &s->refused : &s->done);
    demand(same(&result, &again, sizeof result) || (failed && isnan(again)));
    inputs_are_untouched(s, FIRST);
    status_is_documented(f, result);
    the_right_error_is_returned(s, result, null, &w);
    const int progress =
        failed && !f->is_number && (f->progress & BIT((int32_t)result));
    if (!failed)
        outputs_are_sound(s, null, &w);
    else if (!progress)
        all_is_untouched(s, FIRST);
    if (null < s->count)
        return;
    const struct outcome o = {result, s->a[GIVEN], s->a[FIRST], &w};
    if (f->judge)
        f->judge(&o);
    may_share(s, result);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct bytes b = {data, data + size};
    if (!subjects)
        prepare_all();
    struct subject *const s = &subjects[take_byte(&b) % fuzz_count];
    current = s;
    /* Without arguments once is enough. */
    if (s->count > 0 || s->done == 0)
        examine(s, &b);
    return 0;
}
