/* SPDX-License-Identifier: MIT */
/* page.c: what docs/page/index.html asks of the library: a coin, its motion and
 * its trail.
 *
 * The page loads it as WebAssembly, without imports.  Functions take and
 * return numbers; arrays of doubles are shared by their addresses.  A function
 * that can fail returns a status of coin.h. */
#include "page.h"

#include "tosses.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Of an ideal coin.  The C listing of the page names this one and that of a
 * real one. */
#define TOLERANCE 1e-12

/* The kinetic friction, as a part of the static one; the listing has the same.
 */
#define SLIPPING 0.9

/* The longest time between two knots of the trail, in natural units: the graphs
 * draw straight lines between them. */
#define LONGEST 0.06

/* Of coin_move() at most, for one time: some seconds. */
enum { CALLS = 100 };

struct motion page;
static inputs asked;
static double stride; /* of the trail */

/* ---------------------------------------------------------------- scenes -- */

int32_t PAGE(page_scene_count)(void)
{
    return TOSS_COUNT + SCENE_COUNT;
}

/* Scene k: first those of tosses.h. */
static staged scene_of(int32_t k)
{
    if (k < TOSS_COUNT)
        return TOSSES[k];
    const staged ideal = {
        SCENES[k - TOSS_COUNT], 0, 0, 0, 0, INFINITY, 0.4, 0, 0, 0};
    return ideal;
}

/* The words of scene k: its name, its story, its unit of time. */
const char *PAGE(page_scene_word)(int32_t k, int32_t which)
{
    const scene s = scene_of(k).scene;
    const char *words[] = {s.name, s.story, s.body->in->time};
    return words[which];
}

/* Its numbers: step and duration. */
double PAGE(page_scene_number)(int32_t k, int32_t which)
{
    const scene s = scene_of(k).scene;
    const double numbers[] = {s.dt, s.duration};
    return numbers[which];
}

/* Asks for scene k. */
void PAGE(page_scene)(int32_t k)
{
    const staged s = scene_of(k);
    const body *b = s.scene.body;
    const double torque = b->mass * b->gravity * b->radius;
    const coin_losses l = {.dry = s.dry * torque,
                           .spin =
                               s.spin * torque * sqrt(b->radius / b->gravity)};
    const inputs in = {s.scene.start, s.y,     s.vx,      s.vy,
                       s.vz,          b->mass, b->radius, b->inner_radius,
                       b->gravity,    l,       s.mu,      s.restitution,
                       s.thickness};
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

/* A thin coin may have a hole; a real one may have a thickness instead. */
static int32_t params_of(coin_params *p)
{
    if (asked.thickness == 0)
        return coin_params_ring(p, asked.mass, asked.radius, asked.inner_radius,
                                asked.gravity);
    if (asked.inner_radius != 0 || !isfinite(asked.mu))
        return COIN_EPARAMS;
    return coin_params_cylinder(p, asked.mass, asked.radius, asked.thickness,
                                asked.gravity);
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
        asked.mu, SLIPPING * asked.mu, asked.restitution, {0},
        {0},      asked.losses};
    coin_params p;
    coin_body b;
    int32_t status = params_of(&p);
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

/* Scales the losses asked for so that the coin rests after a time, if it is
 * thin and only rolls. */
int32_t PAGE(page_rest_after)(double time)
{
    coin_params thin = page.params;

    thin.thickness = 0;
    return coin_losses_fit(&asked.losses, &page.start.s, &thin, time);
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

/* A real coin: of a time that takes more steps than one call makes, the rest
 * too, as the C listing does it. */
static int32_t real_moved(coin_body *b, double t, double *reached)
{
    double moved = 0, left = t;
    int32_t status = COIN_MORE;

    for (int calls = 0; status >= 0 && status & COIN_MORE && calls < CALLS;
         ++calls, left -= moved)
        status = coin_move(b, &page.params, &page.table, left, TOLERANCE_REAL,
                           0, &moved);
    if (reached)
        *reached = t - left;
    return status;
}

/* The velocity of a coin that is held to the table is not kept.  A time that
 * takes too many steps is refused. */
int32_t page_moved(coin_body *b, double t, double *reached)
{
    int32_t status;

    if (page.real)
        status = real_moved(b, t, reached);
    else if (page.lossy)
        status = coin_settle(&b->s, &page.params, &page.taken.losses, t,
                             TOLERANCE, reached);
    else
        status = coin_advance(&b->s, &page.params, t, TOLERANCE, reached);
    if (!page.real)
        set_height(b);
    return status >= 0 && status & COIN_MORE ? COIN_ESTEP : status;
}

/* The mode of a real coin; where the table would have to pull at an ideal one,
 * COIN_LIFTS. */
static int32_t mode_of(const moment *m)
{
    coin_body b = m->body;

    if (page.real)
        return page_moved(&b, 0, NULL);
    return (m->normal <= 0 ? COIN_LIFTS : 0) |
           (coin_check(&b.s, &page.params, COIN_RK8, 0, INFINITY) &
            COIN_NEARLY_FLAT);
}

/* The lowest point, on the lower rim: x, z.  Upright, that of the edge's
 * middle.
 */
static void find_contact(double contact[2], const coin_state *s)
{
    const double side = (s->theta > 0) - (s->theta < 0);
    const double h = side * page.taken.thickness / 2, a = page.taken.radius;
    double R[9] = {0};

    coin_axes(s, R);
    contact[0] = s->x - a * R[3] + h * R[6];
    contact[1] = s->z - a * R[5] + h * R[8];
}

static void observe(moment *m, double t, const coin_body *b)
{
    double v[3];
    coin_force f = {{0}, 0, 0, 0};

    m->t = t;
    m->body = *b;
    find_contact(m->contact, &b->s);
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
    coin_body_contact(b, &page.params, v);
    m->slip = page.real ? sqrt(v[0] * v[0] + v[2] * v[2]) : 0;
    m->bits = mode_of(m);
}

/* The side that is up now: COIN_HEADS, COIN_TAILS, COIN_EDGE. */
int32_t PAGE(page_face)(void)
{
    return coin_body_face(&page.now.body, &page.params);
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
    const int32_t status = page_moved(&b, t - from->t, NULL);

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
        status = page_moved(&b, t, NULL);
    if (status >= 0 || status == COIN_EFLAT)
        observe(&page.now, t, &b);
    return status;
}

/* Makes the coin of now, moved on by t, the start that is asked for. */
int32_t PAGE(page_start_here)(double t)
{
    coin_body b = page.now.body;
    const int32_t status = page_moved(&b, t, NULL);

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
    page.count = page.impact_count = 0;
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

impact *PAGE(page_impacts)(void)
{
    return page.impacts;
}

int32_t PAGE(page_impact_count)(void)
{
    return page.impact_count;
}

/* Keeps the impacts of a coin on its way from one knot to the next: a copy goes
 * from touch to touch, so that the trail's own steps stay as they are. */
static void keep_impacts(const moment *from, double h)
{
    coin_body b = from->body;
    double left = h, v[3], t = 0;
    int32_t status = COIN_TOUCHES;

    for (; left > 0 && status & COIN_TOUCHES; left -= t) {
        status = coin_move(&b, &page.params, &page.table, left, TOLERANCE_REAL,
                           COIN_TOUCHES, &t);
        if (status < 0 || !(status & COIN_TOUCHES) ||
            page.impact_count == IMPACTS)
            return;
        coin_body_contact(&b, &page.params, v);
        const impact i = {from->t + h - left + t, -v[1]};
        page.impacts[page.impact_count++] = i;
    }
}

/* Lengthens the trail by up to count knots, until `end`.  COIN_OK: there is
 * more to come; COIN_RESTS: its last knot is where it ends, at rest if that
 * says so. */
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
        const int32_t status = page_moved(&b, h, &h);
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
        if (page.real && ((int32_t)m->bits | (int32_t)next->bits) & COIN_LIFTS)
            keep_impacts(m, h);
        if (status == COIN_EFLAT || status & COIN_RESTS) {
            next->bits = (int32_t)next->bits | COIN_RESTS;
            return COIN_RESTS;
        }
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
