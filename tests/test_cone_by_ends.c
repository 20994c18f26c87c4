/* SPDX-License-Identifier: MIT */
/* The test of a rolling step by polynomials, which finds most steps to be
 * within the cone of friction, is not wrong; with losses and without. */
#include "cone.h"
#include "control.h"
#include "dopri8.h"
#include "lossy.h"
#include "sundman.h"

#include "support/check.h"
#include "support/coins.h"
#include "support/peaks.h"

#include <math.h>

enum { LOOKS = 32, STEPS = 300 };

/* A step of tau from a state, by many short steps. */
struct path {
    coin_priv_contact contact;
    coin_priv_slip y[LOOKS + 1];
    double tau, stride, unit; /* tau = stride unit */
    coin_priv_losses losses;
    int lossy;
};

static double ratio(const coin_priv_contact *contact, const coin_priv_slip *y)
{
    const coin_priv_push need = coin_priv_static(contact, y);
    return need.N > 0 ? hypot(need.X, need.h) / need.N : INFINITY;
}

/* Moves *y by one step. */
static void move(coin_priv_slip *y, const coin_priv_contact *contact, double h)
{
    double d[COIN_PRIV_SLIP_SIZE];
    coin_priv_estimates e;
    coin_priv_roll_slopes(d, (const double *)y, contact);
    coin_priv_dopri8((double *)y, d, coin_priv_roll_slopes, contact, h, &e);
}

/* The largest F/N between the places before and after y, by thirds. */
static double peak_near(const struct path *w, const coin_priv_slip *before)
{
    double low = 0, high = 2 * w->tau / LOOKS, most = 0;
    for (int i = 0; i < 25; ++i) {
        const double third = (high - low) / 3;
        double r[2];
        for (int k = 0; k < 2; ++k) {
            coin_priv_slip at = *before;
            move(&at, &w->contact, low + (k + 1) * third);
            r[k] = ratio(&w->contact, &at);
            most = fmax(most, r[k]);
        }
        if (r[0] < r[1])
            low += third;
        else
            high -= third;
    }
    return most;
}

/* The first step of a state of any body; if wide also near flat, slow or fast.
 */
static struct path path_any(struct random *r, int wide, int lossy)
{
    struct path w;
    coin_params p;
    coin_priv_run run;
    const double k = pow(10, random_between(r, -3, 1));
    const double fast = pow(10, random_between(r, -2, 1.5));
    const coin_friction f = {pow(10, random_between(r, -1, 1)), 0};
    check_status(
        coin_params_body(&p, 1, 1, 1, k, k * random_between(r, 0.3, 2)),
        COIN_OK);
    coin_state s = random_state(r, &p, wide ? 1.57 : 1.3);
    s.wX *= wide ? fast * pow(10, random_between(r, -1, 1)) : 1;
    s.wY *= wide ? fast * pow(10, random_between(r, -1, 1)) : 1;
    s.wZ *= wide ? fast * pow(10, random_between(r, -1, 1)) : 1;
    const coin_losses losses = {
        .dry = pow(10, random_between(r, -4, -1)),
        .viscous = pow(10, random_between(r, -4, -1)),
        .spin = pow(10, random_between(r, -4, -1)),
    };
    check_status(
        coin_priv_contact_of(&w.contact, &p, &f, lossy ? &losses : NULL),
        COIN_OK);
    run.b = coin_priv_body_of(&p);
    const coin_losses none = {.dry = 0};
    check_status(
        coin_priv_losses_of(&w.losses, lossy ? &losses : &none, &run.b),
        COIN_OK);
    coin_priv_run_unlimited(&run, &s);
    w.lossy = lossy;
    const coin_priv_variables *y = &run.g.y;
    const coin_priv_slip start = {
        y->wX, y->wY, y->wZ, y->sth, y->cth, 0, 0, 0, 1, 0, 0, 0, 0, 0,
    };
    w.unit = coin_priv_sundman_tau(&run.b, y, 1);
    w.stride = random_between(r, 0.1, lossy ? COIN_PRIV_LONGEST_STRIDE : 1.65);
    w.tau = w.stride * w.unit;
    if (lossy) { /* as roll.c chooses it */
        coin_priv_lossy slowed = {.l = w.losses, .run = run};
        const double bound = coin_priv_lossy_bound(&slowed, 1e-3);
        w.unit = 1 / coin_priv_lossy_rate(&slowed);
        w.tau = fmin(w.stride * w.unit, bound);
        w.stride = w.tau / w.unit;
    }
    w.y[0] = start;
    for (int i = 0; i < LOOKS; ++i) {
        w.y[i + 1] = w.y[i];
        move(&w.y[i + 1], &w.contact, w.tau / LOOKS);
    }
    return w;
}

/* The largest F/N of a step; 0 if it is at an end, or too large for a cone. */
static double peak_of(const struct path *w)
{
    double most = ratio(&w->contact, &w->y[0]);
    int at = 0;
    for (int i = 1; i <= LOOKS; ++i) {
        const double here = ratio(&w->contact, &w->y[i]);
        if (here > most) {
            most = here;
            at = i;
        }
    }
    const int within = at != 0 && at != LOOKS && most < 10;
    return within ? peak_near(w, &w->y[at - 1]) : 0;
}

/* As coin_priv_end_of() has it. */
static coin_priv_end end_at(const struct path *w, const coin_priv_slip *y)
{
    const coin_priv_field f = coin_priv_field_of(&w->contact.b, 1);
    const coin_priv_variables v = {
        y->wX, y->wY, y->wZ, y->sth, y->cth, 0, 0, 0, 0,
    };
    coin_priv_end e;
    coin_priv_end_of(&e, &w->contact, &f, &w->losses, &v, w->unit);
    return e;
}

static int is_plain(struct path *w, double mu)
{
    const coin_priv_field f = coin_priv_field_of(&w->contact.b, 1);
    w->contact.mu_static = mu;
    const coin_priv_end a = end_at(w, &w->y[0]), b = end_at(w, &w->y[LOOKS]);
    return coin_priv_surely_in_cone(&w->contact, &f, &w->losses, &a, &b, w->tau,
                                    w->stride);
}

static void no_step_that_leaves_the_cone_is_plain(void **unused)
{
    (void)unused;
    struct random r = random_begin(5); /* has a contact that turns round */
    const int count = tries_asked(STEPS);
    int tried = 0, plain = 0;
    while (tried < count) {
        struct path w = path_any(&r, 1, tried % 2);
        const double peak = peak_of(&w);
        if (peak == 0)
            continue;
        ++tried;
        check_note("step %d", tried);
        for (double excess = 1e-6; excess < 0.1; excess *= 6)
            check(!is_plain(&w, peak * (1 - excess)));
        plain += is_plain(&w, 1.5 * peak);
    }
    check(plain > 0.4 * count);
}

/* Hermite's polynomial of degree 3 at a part x of the way, by the values f and
 * slopes d at both ends; of degree 4, by the value in the middle as well. */
static double curve3(const double f[2], const double d[2], double x)
{
    const double y = 1 - x;
    return y * y * ((1 + 2 * x) * f[0] + x * d[0]) +
           x * x * ((1 + 2 * y) * f[1] - y * d[1]);
}

static double curve4(const double f[2], const double d[2], double mid, double x)
{
    const double y = 1 - x;
    return curve3(f, d, x) + 16 * x * x * y * y * (mid - curve3(f, d, 0.5));
}

/* Of degree 5, by the second derivatives as well. */
static double curve5(const double f[2], const double d[2], const double dd[2],
                     double x)
{
    const double y = 1 - x, x2 = x * x, y2 = y * y;
    return y2 * y *
               ((1 + 3 * x + 6 * x2) * f[0] + (x + 3 * x2) * d[0] +
                x2 / 2 * dd[0]) +
           x2 * x *
               ((1 + 3 * y + 6 * y2) * f[1] - (y + 3 * y2) * d[1] +
                y2 / 2 * dd[1]);
}

/* By how much the curves of degree 3 and 4 miss the force, and by how much the
 * margin of the motion interpolated by degree 5 errs, over what cone.h states.
 */
struct misses {
    double by3, by4, by5;
};

static void note_misses(struct misses *most, const struct path *w)
{
    coin_priv_end e[LOOKS + 1];
    for (int k = 0; k <= LOOKS; ++k)
        e[k] = end_at(w, &w->y[k]);
    const coin_priv_end *a = &e[0], *b = &e[LOOKS];
    const double size = a->force.size + b->force.size, stride = w->stride;
    const double by3 = COIN_PRIV_MISS3 * pow(stride, 4) * size;
    const double by4 = COIN_PRIV_MISS4 * pow(stride, 5) * size;
    for (int k = 1; k < LOOKS; ++k) {
        const double x = (double)k / LOOKS, tau = w->tau;
        double y[COIN_PRIV_SLIP_SIZE] = {0};
        for (int j = 0; j < 3; ++j) {
            const double f[] = {(&a->force.N)[j], (&b->force.N)[j]};
            const double d[] = {tau * (&a->slope.N)[j], tau * (&b->slope.N)[j]};
            const double mid = (&e[LOOKS / 2].force.N)[j];
            const double is = (&e[k].force.N)[j];
            most->by3 = fmax(most->by3, fabs(curve3(f, d, x) - is) / by3);
            most->by4 = fmax(most->by4, fabs(curve4(f, d, mid, x) - is) / by4);
        }
        for (int j = 0; j < 5; ++j) {
            const double f[] = {a->y[j], b->y[j]};
            const double d[] = {tau * a->d[j], tau * b->d[j]};
            const double dd[] = {tau * tau * a->dd[j], tau * tau * b->dd[j]};
            y[j] = curve5(f, d, dd, x);
        }
        const coin_priv_slip at = {y[0], y[1], y[2], y[3], y[4], 0, 0,
                                   0,    1,    0,    0,    0,    0, 0};
        const coin_priv_end near = end_at(w, &at);
        const double terms = fmax(a->weight, fmax(b->weight, near.weight));
        const double by5 = COIN_PRIV_MISS * pow(stride, 6) * terms;
        most->by5 = fmax(most->by5,
                         fabs(near.square_margin - e[k].square_margin) / by5);
    }
}

static void the_curves_miss_the_force_by_no_more_than_stated(void **unused)
{
    (void)unused;
    struct random r = random_begin(187);
    const int count = tries_asked(STEPS);
    struct misses wide = {0}, narrow = {0};
    for (int i = 0; i < count; ++i) {
        const struct path w = path_any(&r, i % 2, 0);
        note_misses(i % 2 ? &wide : &narrow, &w);
    }
    check_within(wide.by3, 0.1, 0.5);
    check_within(wide.by4, 0.1, 0.5);
    check_within(narrow.by3, 0.02, 0.5);
    check_within(narrow.by4, 0.02, 0.5);
    check_within(narrow.by5, 0.02, 0.2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(no_step_that_leaves_the_cone_is_plain),
        TEST(the_curves_miss_the_force_by_no_more_than_stated),
    };
    return RUN_TESTS(tests);
}
