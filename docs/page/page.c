/* SPDX-License-Identifier: MIT */
/* page.c: what docs/page/index.html asks of the library: a coin, its motion and
 * its trail.
 *
 * The page loads it as WebAssembly, without imports.  Functions take and
 * return numbers; arrays of doubles are shared by their addresses.  A function
 * that can fail returns a status of coin.h. */
#include "page.h"

#include "../examples/scenes.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* The C listing of the page names the same tolerances: of an ideal coin, and of
 * a real one. */
#define TOLERANCE 1e-12
#define TOLERANCE_REAL 1e-6

/* The kinetic friction, as a part of the static one; the listing has the same.
 */
#define SLIPPING 0.9

/* The longest time between two knots of the trail, in natural units: the graphs
 * draw straight lines between them. */
#define LONGEST 0.06

static const coin_losses NO_LOSSES = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, {0, 0}};
struct motion page;
static inputs asked;
static double stride; /* of the trail */

/* ---------------------------------------------------------------- scenes -- */

int32_t PAGE(page_scene_count)(void)
{
    return SCENE_COUNT;
}

/* The words of scene k: its name, its story, its unit of time. */
const char *PAGE(page_scene_word)(int32_t k, int32_t which)
{
    const scene *s = &SCENES[k];
    const char *words[] = {s->name, s->story, s->body->in->time};
    return words[which];
}

/* Its numbers: step and duration. */
double PAGE(page_scene_number)(int32_t k, int32_t which)
{
    const scene *s = &SCENES[k];
    const double numbers[] = {s->dt, s->duration};
    return numbers[which];
}

/* Asks for scene k. */
void PAGE(page_scene)(int32_t k)
{
    const scene *s = &SCENES[k];
    const body *b = s->body;
    const inputs in = {s->start,   0,         0,         0,
                       0,          b->mass,   b->radius, b->inner_radius,
                       b->gravity, NO_LOSSES, INFINITY,  0.4};
    asked = in;
}

static double unit(void)
{
    return sqrt(page.taken.radius / page.taken.gravity);
}

/* The largest W of the trail, Eq. (47). */
static double fastest(void)
{
    double most = 0;

    for (int k = 0; k < page.count; ++k) {
        const coin_state *s = &page.knots[k].body.s;
        const double c = cos(s->theta);
        most = fmax(most, (s->wX * s->wX + s->wY * s->wY) / (c * c) +
                              s->wZ * s->wZ +
                              page.taken.gravity / page.taken.radius / c);
    }
    return sqrt(most);
}

/* ---------------------------------------------------------------- inputs -- */

inputs *PAGE(page_asked)(void)
{
    return &asked;
}

static int slowed(const coin_losses *l)
{
    return l->damping + l->dry + l->viscous + l->layer + l->gap + l->rolling +
               l->spin + l->angular >
           0;
}

/* Whether a real coin of these inputs can begin, and its body. */
static int32_t begun(coin_body *b, const coin_params *p,
                     const coin_table *table)
{
    const coin_body thrown = {asked.start, asked.y,  asked.vx,
                              asked.vy,    asked.vz, {0}};
    coin_body copy;

    *b = thrown;
    if (asked.y == 0) {
        const int32_t status = coin_body_from_state(b, &asked.start, p);
        if (status < 0 || !isfinite(asked.mu))
            return status;
    }
    copy = *b;
    return coin_move(&copy, p, table, 0, TOLERANCE_REAL, 0, NULL);
}

/* Takes what was asked, or leaves all as it was. */
int32_t PAGE(page_take)(void)
{
    const coin_table table = {
        asked.mu, SLIPPING * asked.mu, asked.restitution, {0}, asked.losses};
    coin_params p;
    coin_body b;
    int32_t status = coin_params_ring(&p, asked.mass, asked.radius,
                                      asked.inner_radius, asked.gravity);
    if (status >= 0)
        status = coin_losses_check(&asked.losses, &p);
    if (status >= 0)
        status = begun(&b, &p, &table);
    if (status < 0)
        return status;
    page.taken = asked;
    page.params = p;
    page.table = table;
    page.start = b;
    page.real = isfinite(asked.mu);
    page.lossy = slowed(&asked.losses);
    page.orbit_status = page.lossy || page.real
                            ? COIN_EDOMAIN
                            : coin_orbit_init(&page.orbit, &b.s, &p);
    return COIN_OK;
}

/* The orbit, or null if the motion has none. */
const coin_orbit *PAGE(page_orbit)(void)
{
    return page.orbit_status < 0 ? NULL : &page.orbit;
}

/* What coin_orbit_at() may be off by in angle after t, so many swings ahead. */
double PAGE(page_orbit_error)(double t, double swings)
{
    const double u = DBL_EPSILON / 2;

    return 1e-14 + 1e-15 * page.orbit.conditioning * swings +
           4 * u * fastest() * (t + page.orbit.period);
}

/* lambda^2 of the steady motion that is the start; NaN if it is none. */
double PAGE(page_lambda2)(void)
{
    double lambda2 = (double)NAN;

    coin_stability(&page.start.s, &page.params, &lambda2);
    return lambda2;
}

/* Scales the losses asked for so that the coin rests after a time. */
int32_t PAGE(page_rest_after)(double time)
{
    return coin_losses_fit(&asked.losses, &page.start.s, &page.params, time);
}

const char *PAGE(page_status_words)(int32_t status)
{
    return coin_status_string(status);
}

/* ------------------------------------------------------------- the coin -- */

/* Gives a coin that is held to the table the height of its lean. */
static void set_height(coin_body *b)
{
    double r[3] = {0};

    coin_center(&b->s, &page.params, r);
    b->y = r[1];
}

/* The velocity of a coin that is held to the table is not kept. */
static int32_t moved(coin_body *b, double t, double *reached)
{
    if (page.real)
        return coin_move(b, &page.params, &page.table, t, TOLERANCE_REAL, 0,
                         reached);
    const int32_t status =
        page.lossy ? coin_settle(&b->s, &page.params, &page.taken.losses, t,
                                 TOLERANCE, reached)
                   : coin_advance(&b->s, &page.params, t, TOLERANCE, reached);
    set_height(b);
    return status;
}

/* The mode of a real coin; where the table would have to pull at an ideal one,
 * COIN_LIFTS. */
static int32_t mode_of(const moment *m)
{
    coin_body b = m->body;

    if (page.real)
        return moved(&b, 0, NULL);
    return (m->normal <= 0 ? COIN_LIFTS : 0) |
           (coin_check(&b.s, &page.params, COIN_RK8, 0, INFINITY) &
            COIN_NEARLY_FLAT);
}

static void observe(moment *m, double t, const coin_body *b)
{
    double r[3] = {0}, v[3];
    coin_force f = {{0}, 0, 0, 0};

    m->t = t;
    m->body = *b;
    coin_contact(&b->s, &page.params, r, v);
    m->contact[0] = r[0];
    m->contact[1] = r[2];
    if (page.real)
        coin_body_reaction(b, &page.params, &page.table, &f);
    else if (page.lossy)
        coin_losses_reaction(&b->s, &page.params, &page.taken.losses, &f);
    else
        coin_reaction(&b->s, &page.params, &f);
    memcpy(m->R, f.R, sizeof f.R);
    m->normal = f.normal;
    m->friction = f.friction;
    m->ratio = f.ratio;
    m->energy = page.real ? coin_body_energy(b, &page.params)
                          : coin_energy(&b->s, &page.params);
    m->bits = mode_of(m);
}

moment *PAGE(page_now)(void)
{
    return &page.now;
}

/* The last knot of the trail that is not after t. */
int32_t PAGE(page_before)(double t)
{
    int low = 0, high = page.count;

    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (page.knots[middle].t <= t)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* The coin at t, from the knot before: quick, and equal to what is drawn. */
int32_t PAGE(page_near)(double t)
{
    const moment *from = &page.knots[page_before(t)];
    coin_body b = from->body;
    const int32_t status = moved(&b, t - from->t, NULL);

    if (status >= 0)
        observe(&page.now, t, &b);
    return status;
}

/* The coin at base + t as the C listing moves it: by one call from the start,
 * a real one by a call per knot.  base > 0 needs an orbit.  A coin that falls
 * flat is shown as it lies. */
int32_t PAGE(page_at)(double base, double t)
{
    coin_body b = page.start;
    int32_t status;

    if (page.real && page.count > 0)
        return page_near(t);
    if (base > 0) {
        status = page.orbit_status < 0
                     ? page.orbit_status
                     : coin_orbit_at(&page.orbit, base + t, &b.s);
        set_height(&b);
    } else
        status = moved(&b, t, NULL);
    if (status >= 0 || status == COIN_EFLAT)
        observe(&page.now, t, &b);
    return status;
}

/* Makes the coin of now, moved on by t, the start that is asked for. */
int32_t PAGE(page_start_here)(double t)
{
    coin_body b = page.now.body;
    const int32_t status = moved(&b, t, NULL);

    if (status < 0)
        return status;
    asked.start = b.s;
    asked.y = page.real ? b.y : 0;
    asked.vx = page.real ? b.vx : 0;
    asked.vy = page.real ? b.vy : 0;
    asked.vz = page.real ? b.vz : 0;
    return status;
}

/* ----------------------------------------------------------- the trail -- */

moment *PAGE(page_knots)(void)
{
    return page.knots;
}

int32_t PAGE(page_knot_count)(void)
{
    return page.count;
}

/* The time between the knots of a real coin: 0.01 to 0.1 natural units, a
 * power of ten. */
double PAGE(page_frame)(void)
{
    double frame = 1e9;

    while (frame > 0.1 * unit())
        frame /= 10;
    return frame;
}

/* Begins the trail at base, which page_at() must accept. */
void PAGE(page_trail)(double base)
{
    page.count = 0;
    if (page_at(base, 0) >= 0)
        page.knots[0] = page.now;
    page.count = 1;
    ++page.age;
    stride = 0.01 * unit();
}

/* Whether two moments are close enough for a straight line between them: the
 * contact, in radii, and the turns of heading and lean.  <= 1: they are. */
static double gap(const moment *m, const moment *next)
{
    const coin_state *a = &m->body.s, *b = &next->body.s;
    const double chord = hypot(next->contact[0] - m->contact[0],
                               next->contact[1] - m->contact[1]) /
                         page.taken.radius;
    const double turn = 0.25 * fabs(b->phi - a->phi);
    return fmax(chord / 0.12,
                fmax(turn / 0.12, fabs(b->theta - a->theta) / 0.05));
}

/* Lengthens the trail by up to count knots, until `end`.  COIN_OK: there is
 * more to come; COIN_RESTS: its last knot is where it ends. */
int32_t PAGE(page_trail_on)(double end, int32_t count)
{
    while (count-- > 0) {
        const moment *m = &page.knots[page.count - 1];
        const double left = end - m->t;
        if (!(left > 0) || page.count == KNOTS)
            return COIN_RESTS;
        coin_body b = m->body;
        const double frame = page_frame();
        double h =
            page.real ? frame : fmin(fmin(stride, LONGEST * unit()), left);
        const int32_t status = moved(&b, h, &h);
        if (status < 0 && status != COIN_EFLAT)
            return status;
        moment *next = &page.knots[page.count];
        observe(next, page.real && h == frame ? page.count * frame : m->t + h,
                &b);
        const double g = page.real ? 0 : gap(m, next);
        stride *= fmin(1.5, fmax(0.3, 0.8 / g));
        if (g > 1 && stride > 1e-12 * unit())
            continue;
        ++page.count;
        if (status == COIN_RESTS || status == COIN_EFLAT)
            return COIN_RESTS;
    }
    return COIN_OK;
}

/* The smallest and the largest of a member of the trail's knots, that is of
 * the doubles at `member` in a moment; infinities apart. */
double PAGE(page_extreme)(int32_t member, int32_t largest)
{
    double extreme = (double)NAN;

    for (int k = 0; k < page.count; ++k) {
        const double x = ((const double *)&page.knots[k])[member];
        if (isfinite(x) && !(largest ? x <= extreme : x >= extreme))
            extreme = x;
    }
    return extreme;
}
