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

/* The C listing of the page names the same tolerance. */
#define TOLERANCE 1e-12

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
    const inputs in = {s->start,   b->mass,   b->radius, b->inner_radius,
                       b->gravity, NO_LOSSES, 0.3};
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
        const coin_state *s = &page.knots[k].state;
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

/* Takes what was asked, or leaves all as it was. */
int32_t PAGE(page_take)(void)
{
    coin_params p;
    int32_t status = coin_params_ring(&p, asked.mass, asked.radius,
                                      asked.inner_radius, asked.gravity);
    if (status >= 0)
        status = coin_state_check(&asked.start, &p);
    if (status >= 0)
        status = coin_losses_check(&asked.losses, &p);
    if (status >= 0)
        status = coin_check(&asked.start, &p, COIN_RK8, 0, asked.mu);
    if (status < 0)
        return status;
    page.taken = asked;
    page.body = p;
    page.lossy = slowed(&asked.losses);
    page.orbit_status =
        page.lossy ? COIN_EDOMAIN
                   : coin_orbit_init(&page.orbit, &page.taken.start, &p);
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

    coin_stability(&page.taken.start, &page.body, &lambda2);
    return lambda2;
}

double PAGE(page_time_to_rest)(void)
{
    return coin_time_to_rest(&page.taken.start, &page.body, &page.taken.losses);
}

/* Scales the losses asked for so that the coin rests after a time. */
int32_t PAGE(page_rest_after)(double time)
{
    return coin_losses_fit(&asked.losses, &page.taken.start, &page.body, time);
}

const char *PAGE(page_status_words)(int32_t status)
{
    return coin_status_string(status);
}

/* ------------------------------------------------------------- the coin -- */

static int32_t moved(coin_state *s, double t, double *reached)
{
    if (page.lossy)
        return coin_settle(s, &page.body, &page.taken.losses, t, TOLERANCE,
                           reached);
    return coin_advance(s, &page.body, t, TOLERANCE, reached);
}

/* The bits of coin_check(), those of the force from the force with losses. */
static int32_t checked(const moment *m)
{
    const int32_t bits =
        coin_check(&m->state, &page.body, COIN_RK8, 0, page.taken.mu) &
        COIN_NEARLY_FLAT;

    if (m->normal <= 0)
        return bits | COIN_LIFTS;
    return bits | (m->ratio > page.taken.mu ? COIN_SLIPS : 0);
}

static void observe(moment *m, double t, const coin_state *s)
{
    double r[3] = {0}, v[3];
    coin_force f = {{0}, 0, 0, 0};

    m->t = t;
    m->state = *s;
    coin_contact(s, &page.body, r, v);
    m->contact[0] = r[0];
    m->contact[1] = r[2];
    if (page.lossy)
        coin_losses_reaction(s, &page.body, &page.taken.losses, &f);
    else
        coin_reaction(s, &page.body, &f);
    memcpy(m->R, f.R, sizeof f.R);
    m->normal = f.normal;
    m->friction = f.friction;
    m->ratio = f.ratio;
    m->energy = coin_energy(s, &page.body);
    m->bits = checked(m);
}

moment *PAGE(page_now)(void)
{
    return &page.now;
}

/* The coin at base + t by one call from the start: what the C listing gives.
 * base > 0 needs an orbit.  A coin that falls flat is shown as it lies. */
int32_t PAGE(page_at)(double base, double t)
{
    coin_state s = page.taken.start;
    int32_t status;

    if (base > 0)
        status = page.orbit_status < 0
                     ? page.orbit_status
                     : coin_orbit_at(&page.orbit, base + t, &s);
    else
        status = moved(&s, t, NULL);
    if (status >= 0 || status == COIN_EFLAT)
        observe(&page.now, t, &s);
    return status;
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

/* As page_at(), from the knot before: quick, and equal to what is drawn. */
int32_t PAGE(page_near)(double t)
{
    const moment *from = &page.knots[page_before(t)];
    coin_state s = from->state;
    const int32_t status = moved(&s, t - from->t, NULL);

    if (status >= 0)
        observe(&page.now, t, &s);
    return status;
}

/* Makes the coin of now, moved on by t, the start that is asked for. */
int32_t PAGE(page_start_here)(double t)
{
    coin_state s = page.now.state;
    const int32_t status = moved(&s, t, NULL);

    if (status >= 0)
        asked.start = s;
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

/* Begins the trail at base, which page_at() must accept. */
void PAGE(page_trail)(double base)
{
    if (page_at(base, 0) >= 0)
        page.knots[0] = page.now;
    page.count = 1;
    ++page.age;
    stride = 0.01 * unit();
}

/* Whether two moments are close enough for a straight line between them: the
 * contact, in radii, and the turns of heading and lean. */
static double gap(const moment *m, const moment *next)
{
    const coin_state *a = &m->state, *b = &next->state;
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
        coin_state s = m->state;
        double h = fmin(fmin(stride, LONGEST * unit()), left);
        const int32_t status = moved(&s, h, &h);
        if (status < 0 && status != COIN_EFLAT)
            return status;
        moment *next = &page.knots[page.count];
        observe(next, m->t + h, &s);
        const double g = gap(m, next);
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
