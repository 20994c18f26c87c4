/* SPDX-License-Identifier: MIT */
/* State out, state in: what a mover returns means to the next call what the
 * returned status says, so that many short calls are one long one. */
#include "support/check.h"
#include "support/coins.h"
#include "support/losses.h"
#include "support/methods.h"
#include "support/slides.h"

#include <math.h>

/* ----------------------------------------------------------------- movers */
/* A coin as each mover keeps it. */
struct coin {
    coin_params p;
    coin_table f;
    coin_losses l;
    coin_body d;
};

static struct coin coin_of(const coin_params *p, const coin_body *d,
                           coin_table f, coin_losses l)
{
    const struct coin c = {*p, f, l, *d};
    return c;
}

static struct coin rolling_coin(const coin_params *p, const coin_state *s,
                                coin_table f, coin_losses l)
{
    coin_body d;
    check_status(coin_body_from_state(&d, s, p), COIN_OK);
    return coin_of(p, &d, f, l);
}

typedef int32_t move(struct coin *c, double t, double tol, double *reached);

/* Times are multiples of STEP. */
#define STEP 0.02
static int32_t by_run(struct coin *c, double t, double tol, double *reached)
{
    (void)tol;
    *reached = t;
    return coin_run(&c->d.s, &c->p, COIN_RK8, STEP, (uint64_t)lround(t / STEP),
                    NULL);
}

static int32_t by_advance(struct coin *c, double t, double tol, double *reached)
{
    return coin_advance(&c->d.s, &c->p, t, tol, reached);
}

static int32_t by_settle(struct coin *c, double t, double tol, double *reached)
{
    return coin_settle(&c->d.s, &c->p, &c->l, t, tol, reached);
}

static int32_t by_slide(struct coin *c, double t, double tol, double *reached)
{
    double moved;
    *reached = 0;
    for (;;) { /* a call is bounded */
        const int32_t status =
            slide(&c->d, &c->p, &c->f, &c->l, t - *reached, tol, &moved);
        *reached += moved;
        if (status < 0 || !(status & COIN_MORE))
            return status;
    }
}

static const struct mover {
    const char *name;
    move *by;
    int takes_losses;
    double u, least_tol;
} movers[] = {
    {"coin_run", by_run, 0, U, 0},
    {"coin_advance", by_advance, 0, U, 0},
    {"coin_settle", by_settle, 1, U, 0},
    {"coin_move", by_slide, 1, U, 0},
};
enum { MOVERS = sizeof movers / sizeof *movers, SLIDE = MOVERS - 1 };

/* Calls of dt until the time t, or until one says more than that the coin rolls
 * or slips: the last status, and *reached. */
static int32_t in_calls(const struct mover *m, struct coin *c, double t,
                        double dt, double tol, double *reached)
{
    int32_t status = COIN_OK;
    double sum = 0, moved;
    while (sum < t - dt / 2 && (status == COIN_OK || status == COIN_SLIPS)) {
        status = m->by(c, dt, tol, &moved);
        sum += moved;
    }
    *reached = sum;
    return status;
}

/* Frames in natural units; in those of a quarter, 1/1400 s to 1/30 s. */
static const double frames[] = {STEP, 4 * STEP, 20 * STEP, 50 * STEP};
enum { FRAMES = sizeof frames / sizeof *frames };

/* ------------------------------------------------- many calls, or one call */
/* Poses up to whole turns. */
static double apart(coin_state s, const coin_state *want, const coin_params *p)
{
    s.phi = want->phi + remainder(s.phi - want->phi, 6.283185307179586);
    s.psi = want->psi + remainder(s.psi - want->psi, 6.283185307179586);
    return states_apart(&s, want, p);
}

/* A circle that is stable, and so adds no error of its own. */
TEST(short_calls_are_one_call)
{
    const coin_losses losses[] = {{0}, {.dry = 1e-3, .layer = 1e-4}};
    const coin_table f = {.mu_static = 0.6, .mu_kinetic = 0.5};
    const coin_params p = disc();
    const double t = 10, tols[] = {1e-2, 1e-4, 1e-6, 1e-9};
    coin_state start = circle(&p, 0.5, -2, -1);
    start.wX += 0.1;
    for (int i = 0; i < MOVERS * 2 * FRAMES * 4; ++i) {
        const struct mover *m = &movers[i % MOVERS];
        const int lossy = i / MOVERS % 2;
        const double dt = frames[i / MOVERS / 2 % FRAMES];
        const double tol = fmax(tols[i / MOVERS / 2 / FRAMES], m->least_tol);
        double reached;
        if (lossy > m->takes_losses)
            continue;
        struct coin c = rolling_coin(&p, &start, f, losses[lossy]);
        coin_state want = start;
        check_note("%s, dt %g, tol %g, losses %d", m->name, dt, tol, lossy);
        check_status(coin_settle(&want, &p, &c.l, t, 1e-12, NULL), COIN_OK);
        check_status(in_calls(m, &c, t, dt, tol, &reached), COIN_OK);
        check_near(apart(c.d.s, &want, &p), 0, (tol + 90 * m->u) * (1 + t));
    }
}

/* --------------------------------------------------------------- statuses */
/* The states that one coin comes to: the next call says the same, if it has no
 * time to move.  The moment at which a coin lifts off is located to within tol.
 * said[-status] or said[status] is counted. */
static void check_repeats(const struct mover *m, struct coin c, double dt,
                          double tol, int said[])
{
    int32_t status = COIN_OK;
    double moved;
    for (int i = 0; i < 20 && (status == COIN_OK || status == COIN_SLIPS);
         ++i) {
        status = m->by(&c, dt, tol, &moved);
        if (status == COIN_ESTEP || status == COIN_COARSE)
            return; /* coin_run() says it of its steps, not of the state */
        struct coin again = c;
        const double none = status == COIN_LIFTS ? tol : 0;
        check_status(m->by(&again, none, tol, &moved), status);
        if (m->by == by_slide && status == COIN_OK)
            check_near(slip_speed(&c.d, &c.p), 0,
                       8 * U * (fabs(c.d.s.wX) + fabs(c.d.s.wZ)));
        ++said[status < 0 ? -status : status & ~COIN_MORE];
    }
}

TEST(a_call_of_no_time_says_what_the_last_said)
{
    const int count = tries_asked(150);
    const coin_state falling = {.theta = 1.4};
    struct random r = random_begin(701);
    int said[MOVERS][COIN_RESTS + 1] = {{0}};
    for (int i = 0; i < count; ++i) {
        const coin_params p = i % 2 ? disc() : ring(random_between(&r, 0, 1));
        const double mu = random_between(&r, 0, 0.8);
        const double rough[] = {mu, 1.3 * mu, INFINITY};
        const double tol = pow(10, random_between(&r, -6, -2));
        const coin_losses l = one_loss(i / 2 % 5, i % 4 < 2 ? 1e-2 : 0);
        coin_body d = random_launch(&r, &p);
        if (i % 10 == 0)
            check_status(coin_body_from_state(&d, &falling, &p), COIN_OK);
        const struct coin c = coin_of(
            &p, &d, (coin_table){.mu_static = rough[i % 3], .mu_kinetic = mu},
            l);
        for (int k = 0; k < MOVERS; ++k)
            check_repeats(&movers[k], c, frames[i / 4 % FRAMES], tol, said[k]);
    }
    for (int k = 0; k < MOVERS; ++k)
        check(said[k][COIN_OK] > count);
    check(said[1][-COIN_EFLAT] > 0 && said[2][COIN_RESTS] > 0);
    check(said[SLIDE][COIN_RESTS] > 0);
    check(said[SLIDE][COIN_SLIPS] > count && said[SLIDE][COIN_LIFTS] > 0);
}

/* So near to flat the rounding of theta shifts the force by more than an event
 * is located to. */
TEST(a_slip_that_begins_next_to_flat_begins_in_the_next_call_too)
{
    struct random r = random_begin(871);
    int begun = 0;
    for (int i = 0; i < 400; ++i) {
        const coin_table f = {.mu_static = pow(3, random_between(&r, -1, 1)),
                              .mu_kinetic = 0.3};
        const coin_state s = {.theta = acos(random_between(&r, 5e-6, 3e-5)),
                              .wX = random_between(&r, 0.03, 0.25),
                              .wY = random_between(&r, 0, 1e-5),
                              .wZ = random_between(&r, -0.2, 0)};
        const coin_params p = disc();
        coin_body b;
        check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
        if (coin_move(&b, &p, &f, 1, 1e-10, COIN_SLIPS, NULL) != COIN_SLIPS)
            continue;
        check_note("mu_static %.17g, cos theta %g", f.mu_static,
                   cos(b.s.theta));
        check_status(coin_move(&b, &p, &f, 0, 1e-10, COIN_SLIPS, NULL),
                     COIN_SLIPS);
        ++begun;
    }
    check(begun > 200);
}

/* --------------------------------------------------- slips that do not exist
 */
/* The largest F/N of a coin that rolls, at each frame; infinite where N <= 0.
 */
static double friction_needed(const struct coin *c, double t)
{
    coin_state s = c->d.s;
    double most = 0;
    for (double at = 0; at < t; at += 0.05) {
        coin_force force;
        check_status(coin_losses_reaction(&s, &c->p, &c->l, &force), COIN_OK);
        most = fmax(most, force.ratio);
        if (coin_settle(&s, &c->p, &c->l, 0.05, 1e-9, NULL) != COIN_OK)
            return INFINITY;
    }
    return most;
}

TEST(a_coin_that_friction_holds_rolls_in_every_frame)
{
    const double tols[] = {1e-3, 1e-5, 1e-7}, t = 12;
    const int count = tries_asked(60);
    struct random r = random_begin(702);
    int rolled = 0;
    for (int i = 0; i < count; ++i) {
        const coin_params p = i % 4 ? disc() : ring(random_between(&r, 0, 1));
        const coin_state s = {
            .theta = random_between(&r, -0.7, 0.7),
            .wY = random_between(&r, -1.5, 1.5),
            .wZ = random_between(&r, -2, 2),
        };
        const coin_losses l = {.dry = i % 2 ? 1e-3 : 0};
        struct coin c =
            rolling_coin(&p, &s, (coin_table){.mu_kinetic = 0.3}, l);
        const double needed = friction_needed(&c, t);
        double reached;
        if (!(needed < 1))
            continue;
        c.f.mu_static = i % 3 ? fmax(1.2 * needed, 0.3) : INFINITY;
        check_note("seed %llu, launch %d", (unsigned long long)r.seed, i);
        check_status(in_calls(&movers[SLIDE], &c, t, frames[1 + i % 3],
                              tols[i / 3 % 3], &reached),
                     COIN_OK);
        ++rolled;
    }
    check_share(rolled, count, 0.6);
}

/* ------------------------------------------------------------------ to rest */
/* Euler's disk, on a table that lets it slip and on one that does not.  */
TEST(a_disk_rests_at_one_time_whatever_the_calls)
{
    const coin_table tables[] = {{.mu_static = INFINITY, .mu_kinetic = 0.3},
                                 {.mu_static = 0.35, .mu_kinetic = 0.3}};
    const double tol = 1e-6, calls[] = {0.016, 0.13, 0.26, 1.1};
    const coin_params p = disc();
    coin_state start;
    check_status(coin_steady_spin(&start, &p, 1.35), COIN_OK);
    start.wX += 0.02;
    for (int i = 0; i < 5 * 2 * 2; ++i) {
        const int law = i % 5, is_rough = i / 5 % 2;
        const struct mover *m = &movers[2 + i / 10];
        const coin_losses l = one_loss(law, law == GAP ? 1e-4 : 1e-2);
        const struct coin start_of =
            rolling_coin(&p, &start, tables[is_rough], l);
        struct coin one = start_of;
        double when, by_parts;
        check_status(m->by(&one, 1e3, fmax(1e-9, m->least_tol), &when),
                     COIN_RESTS);
        for (int k = 0; k < 4; ++k) {
            struct coin c = start_of;
            check_note("%s, %s, table %d, calls of %g", m->name,
                       loss_names[law], is_rough, calls[k]);
            check_status(in_calls(m, &c, 1e3, calls[k], tol, &by_parts),
                         COIN_RESTS);
            check_near(by_parts, when, tol * (1 + when));
        }
    }
}
