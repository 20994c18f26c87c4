/* SPDX-License-Identifier: MIT */
/* The moments that `stop` names, by the loop of coin.h: frames of many lengths
 * and one long call tell the same ones. */
#include "support/check.h"
#include "support/thrown.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define END 20.0 /* natural units that a scene lasts */

enum { MOST = 4000, SETS = 11 };

static const int32_t sets[SETS] = {
    COIN_TOUCHES,
    COIN_SLIPS,
    COIN_LIFTS,
    COIN_NEARLY_FLAT,
    COIN_ROLLS,
    COIN_SLIPS | COIN_ROLLS,
    COIN_LIFTS | COIN_TOUCHES,
    COIN_NEARLY_FLAT | COIN_TOUCHES,
    COIN_NEARLY_FLAT | COIN_SLIPS,
    COIN_LIFTS | COIN_ROLLS,
    COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT | COIN_ROLLS | COIN_TOUCHES,
};

struct scene_of_moments {
    coin_params p;
    coin_table table;
    coin_body b;
    int32_t stop;
};

/* A toss, a slide or a roll. */
static struct scene_of_moments any_scene(struct random *r, int i)
{
    struct scene_of_moments m = {.stop = sets[i / 3 % SETS]};
    m.p = random_body(r);
    m.table = random_table(r, &m.p);
    m.b = random_throw(r, 3, 10);
    if (i % 3 > 0) {
        m.b.s.wX /= 20;
        m.b.s.wY /= 5;
        m.b.s.wZ /= 5;
        m.b.s.theta = random_between(r, -1.5, 1.5);
        check_status(coin_body_from_state(&m.b, &m.b.s, &m.p), COIN_OK);
    }
    if (i % 3 == 1) {
        m.b.vx += random_between(r, -0.5, 0.5);
        m.b.vz += random_between(r, -0.5, 0.5);
    }
    return m;
}

struct moment {
    int32_t bits;
    double t;
};

struct told {
    int count, by[8]; /* all, and of each bit */
    int32_t status;
    struct moment of[MOST];
};

static void tell(struct told *told, int32_t bits, double t)
{
    check(told->count < MOST);
    told->of[told->count].bits = bits;
    told->of[told->count++].t = t;
    for (int k = 0; k < 8; ++k)
        told->by[k] += bits >> k & 1;
}

/* What is asked of every call: that it made a moment, or moved to the end, or
 * rests, or needs more; and that its members mean what it says. */
static void check_call(const struct scene_of_moments *m, const coin_body *b,
                       int32_t status, double left, double moved)
{
    const int32_t mode = COIN_SLIPS | COIN_LIFTS | COIN_RESTS;
    check(status >= 0);
    check(moved >= 0 && moved <= left);
    if (moved < left)
        check(status & (m->stop | COIN_RESTS | COIN_MORE));
    coin_body same = *b;
    const int32_t now = coin_move(&same, &m->p, &m->table, 0, 1e-6, 0, NULL);
    check_same(&same, b, sizeof same);
    check((now & mode & ~status) == 0);
    check((status & mode & ~(now | m->stop)) == 0);
}

/* The loop of coin.h. */
static void run_frames(struct told *told, const struct scene_of_moments *m,
                       double frame, double tol)
{
    coin_body b = m->b;
    double t = 0, moved;
    int32_t status = COIN_OK;
    int still = 0;
    memset(told, 0, sizeof *told);
    for (double from = 0; from < END && !(status & COIN_RESTS); from += frame) {
        const double all = fmin(frame, END - from);
        for (double left = all; left > 0 && !(status & COIN_RESTS);
             left -= moved) {
            status =
                coin_move(&b, &m->p, &m->table, left, tol, m->stop, &moved);
            check_call(m, &b, status, left, moved);
            still = moved == 0 ? still + 1 : 0;
            check(still <= 1);
            t += moved;
            /* Where the call found no moment they are the mode. */
            const int ends = moved == left || status & COIN_MORE;
            const int32_t modes = COIN_SLIPS | COIN_LIFTS;
            const int32_t bits = status & m->stop & (ends ? ~modes : ~0);
            if (bits)
                tell(told, bits, t);
        }
    }
    told->status = status;
}

/* How many moments two runs share: the same bits, at times no farther apart
 * than `near`. */
static int shared(const struct told *a, const struct told *b, double near)
{
    int n = 0;
    while (n < a->count && n < b->count && a->of[n].bits == b->of[n].bits &&
           fabs(a->of[n].t - b->of[n].t) <= near * (1 + b->of[n].t))
        ++n;
    return n;
}

/* A fine run of one call for each moment, and one of a start that is changed by
 * as much as tol may change it: as long as these two share their moments, tol
 * decides none.  Up to there frames tell the moments of the fine run.  Of 1,000
 * excursions out of the cone of friction two may be missed (coin.h). */
TEST(frames_tell_the_moments_of_one_call)
{
    static struct told frames, fine, changed;
    const int count = tries_asked(33);
    struct random r = random_begin(2612);
    int same = 0, told[8] = {0};
    for (int i = 0; i < count; ++i) {
        struct scene_of_moments m = any_scene(&r, i);
        const double tol = pow(10, random_between(&r, -9, -3));
        const double frame = random_between(&r, 0.12, 1.5);
        check_note("scene %d of seed %llu, stop %d, tol %g, frame %g", i,
                   (unsigned long long)r.seed, (int)m.stop, tol, frame);
        run_frames(&frames, &m, frame, tol);
        run_frames(&fine, &m, END, fmax(tol / 100, 1e-12));
        m.b.s.wX += tol;
        m.b.s.wZ *= 1 + tol;
        m.b.y += fabs(tol) * (m.b.y > 1.1);
        run_frames(&changed, &m, END, fmax(tol / 100, 1e-12));
        const int decided = shared(&changed, &fine, 30 * tol);
        same += shared(&frames, &fine, 100 * tol) >= decided;
        for (int k = 0; k < 8; ++k)
            told[k] += fine.by[k];
    }
    check_share(same, count, 0.998);
    for (int k = 0; k < 8; ++k)
        if (sets[SETS - 1] >> k & 1)
            check(told[k] > count / 8);
}

/* A coin that falls through nearly flat and rises again tells each fall. */
TEST(each_fall_through_nearly_flat_is_told)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = INFINITY, .mu_kinetic = 0.3};
    const double falls[] = {0.3, 1, 3};
    for (int i = 0; i < 3; ++i) {
        const coin_state s = {.theta = 1.2, .wX = 0.2, .wZ = 0.02 * falls[i]};
        struct scene_of_moments m = {
            .p = p, .table = f, .stop = COIN_NEARLY_FLAT};
        static struct told long_one, frames;
        check_status(coin_body_from_state(&m.b, &s, &p), COIN_OK);
        run_frames(&long_one, &m, END, 1e-9);
        run_frames(&frames, &m, 0.05, 1e-9);
        check_note("roll %g", s.wZ);
        check(long_one.count >= 3);
        check(frames.count == long_one.count);
        check(shared(&frames, &long_one, 1e-6) == long_one.count);
    }
}

/* It falls at 1/J = 0.8 without a turn.  The crest of cos theta is above 0.01
 * for a small part of a step. */
TEST(a_rise_of_a_part_of_a_step_is_seen)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = INFINITY, .mu_kinetic = 0.3};
    for (double over = 1e-5; over > 1e-8; over /= 3) {
        const double c = 0.0095, rise = 0.01 + over - c;
        const coin_state s = {.theta = acos(c), .wX = -sqrt(2 * 0.8 * rise)};
        coin_body b;
        double moved;
        check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
        check_note("over %g", over);
        check_status(coin_move(&b, &p, &f, 1, 1e-6, COIN_NEARLY_FLAT, &moved),
                     COIN_NEARLY_FLAT);
        check(b.s.wX > 0);
        check_near(cos(b.s.theta), 0.01, 1e-7);
    }
}

/* It comes down within 0.01 of flat, sticks and rolls: two moments at once. */
TEST(only_moments_that_were_asked_for_are_told)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = INFINITY, .mu_kinetic = 0.3};
    const int32_t rolls = COIN_ROLLS, flat = COIN_NEARLY_FLAT;
    const int32_t stops[] = {rolls, flat, rolls | flat};
    for (int i = 0; i < 3; ++i) {
        coin_body b = {.s = {.theta = acos(0.005), .wZ = 0.1}, .vy = -0.5};
        b.y = 0.005 + 1e-3;
        check_note("stop %d", (int)stops[i]);
        check_status(coin_move(&b, &p, &f, 1, 1e-9, stops[i], NULL), stops[i]);
    }
}

TEST(a_coin_that_rests_has_not_begun_to_roll)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = 0.4, .mu_kinetic = 0.3};
    coin_body b = {.s = {.theta = nextafter(asin(1), 0)}, .vx = 1};
    b.y = cos(b.s.theta);
    check_status(coin_move(&b, &p, &f, 9, 1e-6, COIN_ROLLS, NULL), COIN_RESTS);
}

/* What a game's loop does with all but a number below 0. */
TEST(a_loop_until_it_rests_ends)
{
    const int count = tries_asked(8);
    struct random r = random_begin(2613);
    for (int i = 0; i < count; ++i) {
        struct scene_of_moments m = any_scene(&r, 3 * i);
        const double t = i % 2 ? INFINITY : 1;
        int32_t status = COIN_OK;
        long calls = 0;
        check_note("scene %d of seed %llu", i, (unsigned long long)r.seed);
        while (status >= 0 && !(status & COIN_RESTS) && calls < 1000000) {
            status = coin_move(&m.b, &m.p, &m.table, t, 1e-6, 0, NULL);
            ++calls;
        }
        check_status(status, COIN_RESTS);
        m.b.s.wZ = NAN;
        check(coin_move(&m.b, &m.p, &m.table, t, 1e-6, 0, NULL) < 0);
    }
}

/* An impact that ends in rolling leaves the velocity of rolling, to the bit. */
TEST(a_toss_that_rolls_has_the_velocity_of_rolling)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = INFINITY, .mu_kinetic = 0.3};
    struct random r = random_begin(2614);
    for (int i = 0; i < 16; ++i) {
        coin_body b = random_throw(&r, 1, 2);
        double v[3];
        check_status(coin_move(&b, &p, &f, INFINITY, 1e-9, COIN_ROLLS, NULL),
                     COIN_ROLLS);
        check_status(coin_velocity(&b.s, &p, v), COIN_OK);
        check_note("toss %d of seed %llu", i, (unsigned long long)r.seed);
        check(fabs(b.y - cos(b.s.theta)) <= DBL_EPSILON);
        check(b.vx == v[0] && b.vy == v[1] && b.vz == v[2]);
    }
}

/* A coin that falls exactly flat begins to touch with its face, and its impact
 * takes the energy to turn over. */
TEST(a_fall_on_the_face_tells_what_it_begins)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = 0.2, .mu_kinetic = 0.2};
    for (int slides = 0; slides < 2; ++slides) {
        const int32_t mode = slides ? COIN_SLIPS : COIN_RESTS;
        const int32_t stops[] = {COIN_NEARLY_FLAT, COIN_DECIDED};
        for (int i = 0; i < 2; ++i) {
            double t;
            coin_body b = {.s = {.theta = nextafter(asin(1), 0)},
                           .y = 1.125,
                           .vx = slides};
            check_note("slides %d, stop %d", slides, (int)stops[i]);
            check_status(coin_move(&b, &p, &f, 3, 1e-9, stops[i], &t),
                         stops[i] | mode);
            check_near(t, 1.5, 1e-9);
        }
    }
}

/* One that sticks has stopped when it rests. */
TEST(a_face_that_sticks_leaves_no_velocity)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = INFINITY, .mu_kinetic = 0.2};
    coin_body b = {
        .s = {.theta = nextafter(asin(1), 0)}, .y = 0.5, .vx = 1, .vz = -1};
    check_status(coin_move(&b, &p, &f, 3, 1e-9, 0, NULL), COIN_RESTS);
    check(b.vx == 0 && b.vy == 0 && b.vz == 0);
}
