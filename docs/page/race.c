/* SPDX-License-Identifier: MIT */
/* race.c: a textbook's RK4 and a method of the library, by equal steps. */
#include "page.h"

#include "../../tests/support/textbook.h"

#include <math.h>

enum { LOOKS = 400, RACERS = 2, TEXTBOOK = -1, THROUGH = -100, SINKING = 9 };

/* A coin moved by fixed steps. */
typedef struct racer {
    coin_state state;    /* after the whole steps */
    int32_t method, age; /* age: of the trail that it runs on */
    double dt, steps;
    double status; /* < 0: it went no further; COIN_COARSE: a step was coarse */
    double pose_error, energy_error;
    coin_state shown; /* at the time of the page, by a shorter last step */
} racer;

static racer racers[RACERS];

/* A coin of RK4 on its way to where the trail begins. */
static struct {
    coin_state state;
    int32_t age; /* of the trail */
    double steps;
} far;

static double looks[LOOKS + 1][5];

racer *PAGE(page_racers)(void)
{
    return racers;
}

static int32_t textbook_run(coin_state *s, double dt, double steps,
                            uint64_t *done)
{
    for (*done = 0; (double)*done < steps; ++*done) {
        coin_state next = *s;
        textbook_step(&next, &page.params, dt);
        if (!(fabs(next.theta) < acos(0)))
            return THROUGH;
        *s = next;
    }
    return COIN_OK;
}

static int32_t steps_of(const racer *r, coin_state *s, double dt, double steps,
                        uint64_t *done)
{
    if (r->method == TEXTBOOK)
        return textbook_run(s, dt, steps, done);
    return coin_run(s, &page.params, r->method, dt, (uint64_t)steps, done);
}

/* Takes that coin up to count steps further, from the start of the motion until
 * base, where the trail begins.  Returns how many it has taken; it is there
 * once that is at least base / dt. */
double PAGE(page_far)(double base, double dt, double count)
{
    const double whole = floor(base / dt);
    uint64_t done = 0;

    if (far.age != page.age) {
        far.state = page.start.s;
        far.age = page.age;
        far.steps = 0;
    } else if (far.steps < whole)
        coin_run(&far.state, &page.params, COIN_RK4, dt,
                 (uint64_t)fmin(count, whole - far.steps), &done);
    else if (far.steps == whole)
        coin_run(&far.state, &page.params, COIN_RK4, base - whole * dt, 1,
                 &done);
    far.steps += (double)done;
    return far.steps;
}

/* Angles are apart by half a turn at most. */
static double apart(double a, double b)
{
    return fabs(remainder(a - b, 4 * acos(0)));
}

static double pose_error(const coin_state *a, const coin_state *b)
{
    const double angles =
        fmax(fabs(a->theta - b->theta),
             fmax(apart(a->phi, b->phi), apart(a->psi, b->psi)));
    return fmax(angles, hypot(a->x - b->x, a->z - b->z) / page.taken.radius);
}

/* Goes on with the textbook's coin, which is through the table, by steps and a
 * part of one, as long as it sinks by steps that can be drawn. */
static void sink(coin_state *s, double dt, double steps)
{
    for (; steps > 0; --steps) {
        const double part = fmin(steps, 1);
        coin_state next = *s;
        textbook_step(&next, &page.params, dt);
        if (!(fabs(next.theta) < 2 * acos(0) &&
              hypot(next.x - s->x, next.z - s->z) < page.taken.radius))
            return;
        if (part == 1) {
            *s = next;
            continue;
        }
        s->theta += part * (next.theta - s->theta);
        s->phi += part * (next.phi - s->phi);
        s->x += part * (next.x - s->x);
        s->z += part * (next.z - s->z);
    }
}

/* Brings a racer to the time of truth: whole steps from the start, and one
 * shorter.  It goes on from where it was if that is before; fresh: it does
 * not, but takes all steps in one call. */
int32_t PAGE(page_race)(int32_t which, int32_t method, double dt, int32_t knot,
                        int32_t fresh)
{
    racer *r = &racers[which];
    const moment *truth = knot < 0 ? &page.now : &page.knots[knot];
    double steps = floor(truth->t / dt);
    uint64_t done = 0;

    if (steps * dt > truth->t)
        --steps;
    if (fresh || r->age != page.age || r->dt != dt || r->method != method ||
        r->steps > steps) {
        const int on = far.age == page.age && which == 0;
        const coin_state *s = on ? &far.state : &page.knots[0].body.s;
        const racer begin = {*s, method, page.age, dt, 0, 0, 0, 0, *s};
        *r = begin;
    }
    if (r->status >= 0 && steps > r->steps) {
        const int32_t status =
            steps_of(r, &r->state, dt, steps - r->steps, &done);
        r->steps += (double)done;
        if (status != COIN_OK)
            r->status = status;
    }
    r->shown = r->state;
    if (r->status >= 0) {
        const int32_t status =
            steps_of(r, &r->shown, truth->t - steps * dt, 1, &done);
        if (status != COIN_OK && r->status >= 0)
            r->status = status;
    }
    if (r->status == THROUGH)
        sink(&r->shown, dt, fmin(truth->t / dt - r->steps, SINKING));
    r->pose_error = pose_error(&r->shown, &truth->body.s);
    r->energy_error =
        coin_energy(&r->shown, &page.params) / page.knots[0].energy - 1;
    return (int32_t)r->status;
}

/* Both racers at up to LOOKS knots, as rows of time, errors of pose and
 * energies in units of the first; NaN once a racer is out.  Returns how many.
 */
int32_t PAGE(page_races)(int32_t method, double dt)
{
    const int every = page.count / LOOKS + 1;
    int count = 0;

    for (int k = 0; k < page.count; k += every) {
        double *row = looks[count++];
        row[0] = page.knots[k].t;
        for (int32_t which = 0; which < RACERS; ++which) {
            const int out =
                page_race(which, which ? method : TEXTBOOK, dt, k, 0) < 0;
            row[1 + which] = out ? (double)NAN : racers[which].pose_error;
            row[3 + which] = out ? (double)NAN : 1 + racers[which].energy_error;
        }
    }
    return count;
}

const double *PAGE(page_looks)(void)
{
    return looks[0];
}
