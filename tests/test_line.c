/* SPDX-License-Identifier: MIT */
/* A coin with a thickness on both of its rims, against Newton's and Euler's
 * equations of a body with two point contacts. */
#include "support/check.h"
#include "support/random.h"
#include "support/thrown.h"

#include <line.h>

#include <float.h>
#include <math.h>
#include <string.h>

/* ------------------------------------------------------------- reference */
enum { UNKNOWNS = 12, V = 0, TURN = 3, F_PLUS = 6, F_MINUS = 9 };

/* x, z, phi, psi; the velocity of the centre, and wY, wZ. */
struct place {
    double x, z, phi, psi, vx, vz, wY, wZ;
};

/* How a rim meets the table: it sticks; it slips against mu N along -n; or it
 * does both a little, by -mu N u/sqrt(u^2 + width^2). */
struct meeting {
    int sticks;
    double width;
};

struct forces {
    double plus[3], minus[3]; /* along x, y, z */
    struct place slope;
};

static void solve(double A[UNKNOWNS][UNKNOWNS + 1])
{
    for (int c = 0; c < UNKNOWNS; ++c) {
        int best = c;
        for (int r = c; r < UNKNOWNS; ++r)
            best = fabs(A[r][c]) > fabs(A[best][c]) ? r : best;
        for (int k = 0; k <= UNKNOWNS; ++k) {
            const double swap = A[c][k];
            A[c][k] = A[best][k];
            A[best][k] = swap;
        }
        for (int r = 0; r < UNKNOWNS; ++r) {
            const double by = r == c ? 0 : A[r][c] / A[c][c];
            for (int k = c; k <= UNKNOWNS; ++k)
                A[r][k] -= by * A[c][k];
        }
    }
    for (int r = 0; r < UNKNOWNS; ++r)
        A[r][UNKNOWNS] /= A[r][r];
}

static void cross(double out[3], const double a[3], const double b[3])
{
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

/* Adds a x F = ... to three rows, for the unknown F at `column`. */
static void add_moment(double (*row)[UNKNOWNS + 1], int column,
                       const double a[3], double sign)
{
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        row[i][column + k] += sign * a[j];
        row[i][column + j] -= sign * a[k];
    }
}

/* The axis, the turn and its slope but for w', of a place. */
struct axes {
    double n[3], dn[3], w[3], X[3];
};

static struct axes axes_of(const struct place *p)
{
    const double s = sin(p->phi), c = cos(p->phi);
    const struct axes a = {{s, 0, c},
                           {p->wY * c, 0, -p->wY * s},
                           {p->wZ * s, p->wY, p->wZ * c},
                           {c, 0, -s}};
    return a;
}

/* Newton and Euler: I w' + ... = the torques. */
static void body_rows(double (*A)[UNKNOWNS + 1], const coin_priv_law *l,
                      const struct place *p, const struct axes *a)
{
    const double d = l->IZ - l->IX, spin = p->wZ;
    double turned = 0, along = 0;
    for (int i = 0; i < 3; ++i) {
        turned += a->w[i] * a->dn[i];
        along += a->w[i] * a->n[i];
    }
    const double roll = l->dry * spin / hypot(spin, l->soft) +
                        l->viscous * spin + l->layer * spin * sqrt(fabs(spin));
    for (int i = 0; i < 3; ++i) {
        A[V + i][V + i] = 1;
        A[V + i][F_PLUS + i] = A[V + i][F_MINUS + i] = -1;
        A[V + i][UNKNOWNS] = i == 0 ? l->pull[0] : i == 2 ? l->pull[1] : -1;
        for (int j = 0; j < 3; ++j)
            A[TURN + i][TURN + j] = (i == j) * l->IX + d * a->n[i] * a->n[j];
        const double L = l->IX * a->w[i] + d * along * a->n[i];
        A[TURN + i][UNKNOWNS] = -d * (turned * a->n[i] + along * a->dn[i]) -
                                roll * a->n[i] - l->angular * L -
                                (i == 1 ? l->spin * p->wY : 0);
    }
}

/* What a rim is to do along the table. */
static void rim_rows(double (*row)[UNKNOWNS + 1], const coin_priv_law *l,
                     const struct place *p, const struct axes *a, double side,
                     int column, struct meeting how)
{
    double d[3], dd[3], u[3], bend[3];
    for (int i = 0; i < 3; ++i) {
        d[i] = side * l->half * a->n[i] - (i == 1);
        dd[i] = side * l->half * a->dn[i];
    }
    cross(u, a->w, d);
    cross(bend, a->w, dd);
    u[0] += p->vx;
    u[2] += p->vz;
    const double size = sqrt(u[0] * u[0] + u[2] * u[2] + how.width * how.width);
    for (int r = 0; r < 2; ++r) {
        const int i = 2 * r;
        if (!how.sticks) {
            row[r][column + i] = 1;
            row[r][column + 1] = l->mu_kinetic * u[i] / size;
            continue;
        }
        const int j = (i + 1) % 3, k = (i + 2) % 3; /* w' x d */
        row[r][V + i] = 1;
        row[r][TURN + j] = d[k];
        row[r][TURN + k] = -d[j];
        row[r][UNKNOWNS] = -bend[i];
    }
}

static struct forces forces_of(const coin_priv_law *l, const struct place *p,
                               struct meeting plus, struct meeting minus)
{
    static double A[UNKNOWNS][UNKNOWNS + 1];
    const struct axes a = axes_of(p);
    memset(A, 0, sizeof A);
    body_rows(A, l, p, &a);
    A[6][V + 1] = 1; /* the centre stays at its height, the axis level */
    for (int i = 0; i < 3; ++i)
        A[7][TURN + i] = a.X[i];
    A[7][UNKNOWNS] = p->wY * p->wZ;
    add_moment(A + TURN, F_PLUS,
               (double[]){l->half * a.n[0], -1, l->half * a.n[2]}, -1);
    add_moment(A + TURN, F_MINUS,
               (double[]){-l->half * a.n[0], -1, -l->half * a.n[2]}, -1);
    rim_rows(A + 8, l, p, &a, 1, F_PLUS, plus);
    rim_rows(A + 10, l, p, &a, -1, F_MINUS, minus);
    if (plus.sticks && minus.sticks) { /* share what is along the axis */
        double(*row)[UNKNOWNS + 1] = A + 10;
        for (int k = 0; k <= UNKNOWNS; ++k) { /* the slip along X alone */
            row[0][k] = a.X[0] * row[0][k] + a.X[2] * row[1][k];
            row[1][k] = 0;
        }
        for (int i = 0; i < 3; ++i) {
            row[1][F_PLUS + i] = a.n[i];
            row[1][F_MINUS + i] = -a.n[i];
        }
    }
    solve(A);
    struct forces f;
    for (int i = 0; i < 3; ++i) {
        f.plus[i] = A[F_PLUS + i][UNKNOWNS];
        f.minus[i] = A[F_MINUS + i][UNKNOWNS];
    }
    const struct place slope = {p->vx, p->vz, p->wY, p->wZ, A[V][UNKNOWNS],
                                A[V + 2][UNKNOWNS], A[TURN + 1][UNKNOWNS],
                                /* wZ' = w'.n + w.n' */
                                A[TURN][UNKNOWNS] * a.n[0] +
                                    A[TURN + 2][UNKNOWNS] * a.n[2] +
                                    a.w[0] * a.dn[0] + a.w[2] * a.dn[2]};
    f.slope = slope;
    return f;
}

static struct place moved(const struct place *p, const struct place *d,
                          double h)
{
    const struct place r = {
        p->x + h * d->x,     p->z + h * d->z,   p->phi + h * d->phi,
        p->psi + h * d->psi, p->vx + h * d->vx, p->vz + h * d->vz,
        p->wY + h * d->wY,   p->wZ + h * d->wZ,
    };
    return r;
}

/* RK4. */
static struct place integrate(const coin_priv_law *l, struct place p,
                              struct meeting plus, struct meeting minus,
                              double t, int steps)
{
    const double h = t / steps;
    for (int i = 0; i < steps; ++i) {
        const struct place a = forces_of(l, &p, plus, minus).slope;
        struct place q = moved(&p, &a, h / 2);
        const struct place b = forces_of(l, &q, plus, minus).slope;
        q = moved(&p, &b, h / 2);
        const struct place c = forces_of(l, &q, plus, minus).slope;
        q = moved(&p, &c, h);
        const struct place d = forces_of(l, &q, plus, minus).slope;
        p = moved(&p, &a, h / 6);
        p = moved(&p, &b, h / 3);
        p = moved(&p, &c, h / 3);
        p = moved(&p, &d, h / 6);
    }
    return p;
}

/* ------------------------------------------------------------------ cases */
#define TOL 1e-9

static coin_priv_law law_of(double half, double mu_static, double mu_kinetic)
{
    coin_priv_law l;
    memset(&l, 0, sizeof l);
    l.half = half;
    l.IX = 0.25 + half * half / 3;
    l.IZ = 0.5;
    l.J[0] = l.IX + 1 + half * half;
    l.J[1] = l.IX;
    l.K[0] = l.IZ + 1;
    l.K[1] = l.IZ;
    for (int i = 0; i < 2; ++i) {
        l.perJ[i] = 1 / l.J[i];
        l.perK[i] = 1 / l.K[i];
    }
    l.soft = 1.0 / 1024;
    l.flat = 1e-6;
    l.mu_static = mu_static;
    l.mu_kinetic = mu_kinetic;
    return l;
}

static coin_priv_law random_law(struct random *r, double mu_static)
{
    coin_priv_law l = law_of(random_between(r, 0.05, 1.5), mu_static,
                             random_between(r, 0.02, 0.5));
    l.lossy = 1;
    l.dry = random_between(r, 0, 0.01);
    l.viscous = random_between(r, 0, 0.01);
    l.layer = random_between(r, 0, 0.01);
    l.spin = random_between(r, 0, 0.02);
    l.angular = random_between(r, 0, 0.02);
    l.pull[0] = random_between(r, -0.05, 0.05);
    l.pull[1] = random_between(r, -0.05, 0.05);
    return l;
}

static coin_body standing(const struct place *p)
{
    const coin_body b = {.s = {.phi = p->phi,
                               .psi = p->psi,
                               .x = p->x,
                               .z = p->z,
                               .wY = p->wY,
                               .wZ = p->wZ},
                         .y = 1,
                         .vx = p->vx,
                         .vz = p->vz};
    return b;
}

/* A place whose middle of the line slips at uX, uh. */
static struct place place_of(double phi, double wY, double wZ, double uX,
                             double uh)
{
    const double vX = uX - wZ, s = sin(phi), c = cos(phi);
    const struct place p = {0,  0, phi, 0, vX * c + uh * s, uh * c - vX * s,
                            wY, wZ};
    return p;
}

static double distance(const coin_body *b, const struct place *p)
{
    const double d[] = {b->s.x - p->x,     b->s.z - p->z,  b->s.phi - p->phi,
                        b->s.psi - p->psi, b->vx - p->vx,  b->vz - p->vz,
                        b->s.wY - p->wY,   b->s.wZ - p->wZ};
    double sum = 0;
    for (int i = 0; i < 8; ++i)
        sum += d[i] * d[i];
    return sqrt(sum);
}

/* By so many steps that twice as many change nothing: 1; or 0, after a slip so
 * near to its end that this would take more than 32,000. */
static int integrate_finely(struct place *to, const coin_priv_law *l,
                            const struct place *p, struct meeting plus,
                            struct meeting minus, double t)
{
    double off = 1;
    *to = integrate(l, *p, plus, minus, t, 250);
    for (int steps = 500; off > TOL / 4 && steps <= 32000; steps *= 2) {
        const coin_body before = standing(to);
        *to = integrate(l, *p, plus, minus, t, steps);
        off = distance(&before, to);
    }
    return off <= TOL / 4;
}

/* Moves for t, or until a mode ends; returns why. */
static int move_once(coin_body *b, const coin_priv_law *l, double t,
                     double *reached)
{
    static coin_priv_moving g;
    int why = -1, over;
    g.law = *l;
    coin_priv_begin_call(&g, t, TOL, 11000);
    g.c = coin_of(b, l->half);
    check_status(coin_priv_move_on_line(&g, &why, &over), COIN_OK);
    *b = body_of(&g.c);
    *reached = g.moved.sum + g.moved.low;
    return why;
}

/* Moves for t, until it tips, rests or has made so many steps. */
static int move_within(coin_body *b, const coin_priv_law *l, double t,
                       double tol, double *reached, int tries)
{
    static coin_priv_moving g;
    int why = COIN_PRIV_LINE_CHANGES, over;
    g.law = *l;
    coin_priv_begin_call(&g, t, tol, tries);
    g.c = coin_of(b, l->half);
    while (why == COIN_PRIV_LINE_CHANGES && g.tries > 0)
        check_status(coin_priv_move_on_line(&g, &why, &over), COIN_OK);
    *b = body_of(&g.c);
    *reached = g.moved.sum + g.moved.low;
    return g.tries > 0 ? why : -1;
}

static int move_all(coin_body *b, const coin_priv_law *l, double t,
                    double *reached, int tries)
{
    return move_within(b, l, t, TOL, reached, tries);
}

static int tips(const coin_body *b, const coin_priv_law *l)
{
    const coin_priv_coin c = coin_of(b, l->half);
    return coin_priv_tips(&c, l);
}

static int line_mode(const coin_body *b, const coin_priv_law *l)
{
    const coin_priv_coin c = coin_of(b, l->half);
    return coin_priv_line_mode(&c, l);
}

/* The energy, with that of the pull. */
static double energy(const coin_body *b, const coin_priv_law *l)
{
    const double turn = l->IX * b->s.wY * b->s.wY + l->IZ * b->s.wZ * b->s.wZ;
    return (b->vx * b->vx + b->vz * b->vz + turn) / 2 - l->pull[0] * b->s.x -
           l->pull[1] * b->s.z;
}

static const struct meeting sticks = {1, 0}, slips = {0, 0};

/* ------------------------------------------------------------------ tests */
/* Mode 0: both rims slip; 1, 2: the coin pivots; 3: it rolls. */
static struct place random_place(struct random *r, const coin_priv_law *l,
                                 int mode)
{
    const double phi = random_between(r, -3, 3);
    const double wZ = random_between(r, -1, 1);
    const double wY = mode == 3 ? 0 : random_between(r, -1, 1);
    if (mode == 3)
        return place_of(phi, 0, wZ, 0, 0);
    if (mode)
        return place_of(phi, wY, wZ, (mode == 1 ? -1 : 1) * l->half * wY, 0);
    return place_of(phi, wY, wZ, random_between(r, -1, 1),
                    random_between(r, -1, 1));
}

/* The force of the reference agrees to 1e-11 where friction nearly makes it
 * tip; the motion to 2e-9, of which the bound TOL is half. */
TEST(each_mode_is_that_of_newton_and_euler)
{
    struct random r = random_begin(611);
    const int n = tries_asked(400);
    int moved_on = 0;
    for (int i = 0; i < n; ++i) {
        const int mode = i % 4;
        const coin_priv_law l = random_law(&r, (double)INFINITY);
        const struct place p = random_place(&r, &l, mode);
        coin_body b = standing(&p);
        double reached;
        check_note("case %d of seed %llu", i, (unsigned long long)r.seed);
        const struct meeting plus = mode & 1 ? sticks : slips;
        const struct meeting minus = mode & 2 ? sticks : slips;
        const struct forces f = forces_of(&l, &p, plus, minus);
        if (!(f.plus[1] > 0 && f.minus[1] > 0))
            continue;
        check(tips(&b, &l) == 0);
        const coin_priv_coin coin = coin_of(&b, l.half);
        const coin_priv_push F = coin_priv_line_push(&coin, &l);
        const double s = sin(p.phi), c = cos(p.phi);
        const double Fx = f.plus[0] + f.minus[0], Fz = f.plus[2] + f.minus[2];
        check_near(F.N, f.plus[1] + f.minus[1], 1e-11);
        check_near(F.X, Fx * c - Fz * s, 1e-11);
        check_near(F.h, Fx * s + Fz * c, 1e-11);
        check(line_mode(&b, &l) == (mode != 3));
        struct place q;
        if (move_once(&b, &l, 0.1, &reached) != COIN_PRIV_LINE_GOES ||
            !integrate_finely(&q, &l, &p, plus, minus, 0.1))
            continue;
        check_near(distance(&b, &q), 0, 2 * TOL);
        ++moved_on;
    }
    check_share(moved_on, n, 0.4);
}

/* Unless a rim that sticks is the one that would pull: it slips then. */
TEST(a_coin_tips_over_the_rim_that_takes_all_its_weight)
{
    struct random r = random_begin(612);
    const int n = tries_asked(400);
    int over[3] = {0, 0, 0};
    for (int i = 0; i < n; ++i) {
        const int mode = i % 4;
        coin_priv_law l = random_law(&r, (double)INFINITY);
        l.half = random_between(&r, 0.02, 0.3);
        l.pull[0] *= 4;
        const struct place p = random_place(&r, &l, mode);
        const coin_body b = standing(&p);
        const struct forces f = forces_of(&l, &p, mode & 1 ? sticks : slips,
                                          mode & 2 ? sticks : slips);
        const int over_rim = tips(&b, &l);
        check_note("case %d of seed %llu", i, (unsigned long long)r.seed);
        if (f.plus[1] >= 0 && f.minus[1] >= 0)
            check(over_rim == 0);
        else if (mode == (f.minus[1] < 0 ? 1 : 2))
            check(over_rim == (f.minus[1] < 0 ? 1 : -1));
        else if (!mode)
            check(over_rim != 0);
        ++over[over_rim + 1];
    }
    check_share(over[0], n, 0.1);
    check_share(over[1], n, 0.1);
    check_share(over[2], n, 0.1);
}

TEST(a_spin_upright_ends_by_the_friction_of_its_ends)
{
    const double h = 0.0721, mu = 0.2;
    const coin_priv_law l = law_of(h, mu, mu);
    const struct place p = place_of(0.3, 2, 0, 0, 0);
    coin_body b = standing(&p);
    double t;
    check(move_all(&b, &l, 100, &t, 11000) == COIN_PRIV_LINE_RESTS);
    const double stop = l.IX * 2 / (mu * h);
    check_near(t, stop, TOL * stop);
    check_near(b.s.phi, 0.3 + stop, TOL * stop);
    check(b.s.theta == 0 && b.y == 1 && b.s.wY == 0 && b.s.wZ == 0);
    check_near(hypot(b.s.x, b.s.z), 0, TOL);
}

TEST(a_coin_that_slides_sideways_tips_if_mu_exceeds_its_half_thickness)
{
    for (int i = -1; i <= 1; i += 2) {
        const struct place p = place_of(1, 0, 0, 0, i);
        const coin_body b = standing(&p);
        coin_priv_law l = law_of(0.3, 0.301, 0.301);
        check(tips(&b, &l) == i);
        l = law_of(0.3, 0.299, 0.299);
        check(tips(&b, &l) == 0);
    }
}

TEST(a_coin_rolls_down_a_slope)
{
    coin_priv_law l = law_of(0.1, 0.5, 0.4);
    l.pull[0] = 0.3;
    const struct place p = place_of(0, 0, 0, 0, 0);
    coin_body b = standing(&p);
    double t;
    check(move_all(&b, &l, 5, &t, 99) == COIN_PRIV_LINE_GOES && t == 5);
    check_near(b.vx, 1, TOL);
    check_near(b.s.x, 2.5, TOL);
    check_near(b.s.wZ, -1, TOL);
    check_near(b.s.psi, -2.5, TOL);
    check(!line_mode(&b, &l));
}

TEST(a_coin_rests_on_a_slope_that_dry_friction_and_its_ends_hold)
{
    static const struct {
        double mu, dry, x, z;
        int why;
    } cases[] = {
        {0.3, 0.02, 0.019, 0, COIN_PRIV_LINE_RESTS},
        {0.3, 0.02, 0.021, 0, COIN_PRIV_LINE_GOES},
        {0.3, 0, 0, 0.19, COIN_PRIV_LINE_RESTS},
        {0.3, 0, 0, 0.21, COIN_PRIV_LINE_TIPS},
        {0.1, 0, 0, 0.099, COIN_PRIV_LINE_RESTS},
        {0.1, 0, 0, 0.101, COIN_PRIV_LINE_GOES},
        /* the lighter end holds a tenth of the weight */
        {0.1, 0.1, 0.0199, 0.08, COIN_PRIV_LINE_RESTS},
        {0.05, 0.1, 0.0401, 0.04, COIN_PRIV_LINE_GOES},
        /* of the sides of two cones */
        {0.1, 0.5, 0.06, 0.07, COIN_PRIV_LINE_RESTS},
        {0.1, 0.5, 0.06, 0.075, COIN_PRIV_LINE_GOES},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_priv_law l = law_of(0.2, cases[i].mu, cases[i].mu);
        const struct place p = place_of(0, 0, 0, 0, 0);
        coin_body b = standing(&p);
        double t;
        l.lossy = 1;
        l.dry = cases[i].dry;
        l.pull[0] = cases[i].x;
        l.pull[1] = cases[i].z;
        check_note("case %zu", i);
        check(move_all(&b, &l, 0.5, &t, 9999) == cases[i].why);
    }
}

TEST(a_rest_is_where_the_rolling_speed_has_vanished)
{
    coin_priv_law l = law_of(0.2, 0.3, 0.3);
    const struct place p = place_of(0, 0, 1, 0, 0);
    coin_body b = standing(&p);
    double t;
    l.lossy = 1;
    l.viscous = 0.3; /* wZ = exp(-t/5), to TOL */
    check(move_all(&b, &l, INFINITY, &t, 9999) == COIN_PRIV_LINE_RESTS);
    check_within(exp(-t / 5), 0, TOL);
    check_near(b.s.psi, 5, 100 * TOL);
    check(b.s.wZ == 0 && b.vx == 0);
}

/* The slip of a rim along x and z. */
static void slip_of(double u[2], const coin_priv_law *l, const struct place *p,
                    double side)
{
    const double turn = p->wZ + side * l->half * p->wY; /* along e_X */
    u[0] = p->vx + turn * cos(p->phi);
    u[1] = p->vz - turn * sin(p->phi);
}

static struct place place_at(const coin_body *b)
{
    const struct place p = {b->s.x, b->s.z, b->s.phi, b->s.psi,
                            b->vx,  b->vz,  b->s.wY,  b->s.wZ};
    return p;
}

static int sticks_at(const coin_priv_law *l, const coin_body *b, double side)
{
    const struct place p = place_at(b);
    double u[2];
    slip_of(u, l, &p, side);
    return hypot(u[0], u[1]) < 1e-12;
}

/* Whether a rim slips, and ever faster in one direction. */
static int begins_to_slip(const coin_priv_law *l, const coin_body *b,
                          double side)
{
    const struct place p = place_at(b);
    const struct place d = forces_of(l, &p, slips, slips).slope;
    const struct place q = moved(&p, &d, 1e-7);
    double u[2], to[2];
    slip_of(u, l, &p, side);
    slip_of(to, l, &q, side);
    const double du[2] = {to[0] - u[0], to[1] - u[1]};
    const double size = hypot(u[0], u[1]) * hypot(du[0], du[1]);
    return fabs(u[0] * du[1] - u[1] * du[0]) < 0.03 * size &&
           u[0] * du[0] + u[1] * du[1] > 0;
}

TEST(a_pivot_ends_where_it_has_stopped_or_takes_too_much_friction)
{
    struct random r = random_begin(614);
    const int n = tries_asked(1600);
    int lost = 0, stopped = 0;
    for (int i = 0; i < n; ++i) {
        coin_priv_law l = random_law(&r, 1);
        const int mode = 1 + i % 2;
        const struct meeting plus = mode & 1 ? sticks : slips;
        const struct meeting minus = mode & 2 ? sticks : slips;
        l.mu_static = 1.3 * l.mu_kinetic;
        const struct place p = random_place(&r, &l, mode);
        coin_body b = standing(&p);
        double t;
        check_note("case %d of seed %llu", i, (unsigned long long)r.seed);
        if (move_once(&b, &l, 3, &t) != COIN_PRIV_LINE_CHANGES || t < 1e-3)
            continue;
        const struct place q = place_at(&b);
        const struct forces f = forces_of(&l, &q, plus, minus);
        const double *F = mode & 1 ? f.plus : f.minus;
        const double over = hypot(F[0], F[2]) - l.mu_static * F[1];
        if (q.wY == 0 || fabs(q.wY) < 1e-10) {
            ++stopped;
        } else if (f.plus[1] > TOL && f.minus[1] > TOL) { /* or it tips */
            check_near(over, 0, TOL);
            /* what it is given back may hold for TOL more */
            for (int k = 0; k < 3 && sticks_at(&l, &b, mode & 1 ? 1 : -1); ++k)
                check(move_once(&b, &l, 1, &t) == COIN_PRIV_LINE_CHANGES);
            check(begins_to_slip(&l, &b, mode & 1 ? 1 : -1));
            ++lost;
        }
    }
    check_share(stopped, n, 0.1);
    check(lost > 0);
    check_share(lost, n, 0.008);
}

/* Two pivot down a slope, ever faster; the friction of one that slides turns
 * across it. */
TEST(a_coin_tips_where_an_end_would_have_to_pull)
{
    static const struct {
        int mode;
        double mu, wY, wZ, uX, pull;
    } cases[] = {
        {0, 0.15, 0.3, -0.6, 0.6, 0},
        {1, 0.02, 0.3, -0.2, -0.06, 0.2},
        {2, 0.02, -0.3, -0.2, -0.06, 0.2},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const int mode = cases[i].mode;
        const struct meeting plus = mode & 1 ? sticks : slips;
        const struct meeting minus = mode & 2 ? sticks : slips;
        coin_priv_law l = law_of(0.2, (double)INFINITY, cases[i].mu);
        const struct place p =
            place_of(0, cases[i].wY, cases[i].wZ, cases[i].uX, 0);
        coin_body b = standing(&p);
        double t;
        l.pull[0] = cases[i].pull;
        check_note("case %zu", i);
        check(tips(&b, &l) == 0);
        check(move_all(&b, &l, 9, &t, 9999) == COIN_PRIV_LINE_TIPS);
        const struct place q = place_at(&b);
        const struct forces f = forces_of(&l, &q, plus, minus);
        check_near(f.plus[1] < f.minus[1] ? f.plus[1] : f.minus[1], 0, TOL);
    }
}

/* Both rims would slip, but one of them would have to pull: it tips over the
 * other, on which it rolls.  That is its mode, and its force, before it has
 * moved. */
TEST(a_coin_that_tips_at_once_is_on_one_rim)
{
    const coin_params p = {1, 1, 1, 0.25, 0.5, 1.25e-4, {0, 0}};
    const coin_table f = {0.22, 0.22, 0.2, .pull = {0.3767, 0.375}};
    const coin_state s = {.wZ = 2};
    const int32_t stop = COIN_SLIPS | COIN_LIFTS | COIN_ROLLS | COIN_TOUCHES;
    coin_body b;
    coin_force at_once, soon;
    double reached;
    check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
    check_status(coin_move(&b, &p, &f, 0, 1e-9, stop, NULL), COIN_OK);
    check_status(coin_body_reaction(&b, &p, &f, &at_once), COIN_OK);
    check_status(coin_move(&b, &p, &f, 1e-9, 1e-9, stop, &reached), COIN_OK);
    check_status(coin_body_reaction(&b, &p, &f, &soon), COIN_OK);
    check(reached == 1e-9 && b.s.theta > 0);
    check_near(at_once.normal, soon.normal, 1e-7);
    for (int i = 0; i < 3; ++i)
        check_near(at_once.R[i], soon.R[i], 1e-7);
}

/* So is the force where that rim slips. */
TEST(a_coin_that_slips_may_tip_at_once)
{
    const coin_params p = cylinder(0.05);
    const coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.3};
    coin_body b = rolling(&(coin_state){.wZ = 0}, &p);
    coin_force F, soon;
    b.vz = 0.5; /* across, and mu is more than h */
    check_status(coin_body_reaction(&b, &p, &f, &F), COIN_OK);
    check_near(F.ratio, 0.3, 4 * U);
    check(F.normal > 1 + 1e-3 && F.R[2] < 0); /* pressed down by friction */
    check_status(coin_move(&b, &p, &f, 1e-7, 1e-9, 0, NULL), COIN_SLIPS);
    check(fabs(b.s.theta) > 0);
    check_status(coin_body_reaction(&b, &p, &f, &soon), COIN_OK);
    check_near(soon.normal, F.normal, 1e-5);
}

/* Rolling, it needs friction against the losses alone. */
TEST(the_force_on_both_rims_is_what_slows_a_roll)
{
    const coin_params p = cylinder(0.4);
    const coin_table f = {
        .mu_static = 0.3, .mu_kinetic = 0.3, .losses = {.dry = 0.05}};
    const coin_body b = rolling(&(coin_state){.wZ = 2}, &p);
    coin_force F;
    check_status(coin_body_reaction(&b, &p, &f, &F), COIN_OK);
    check_near(F.normal, 1, 4 * U);
    check_near(F.R[0], 0.05 / (1 + p.inertia_Z), 1e-7);
    check_near(F.R[2], 0, 4 * U);
}

/* At rest it needs what holds it, as a coin on one rim does. */
TEST(the_force_on_both_rims_at_rest_holds_the_pull)
{
    const coin_params p = cylinder(0.4);
    const coin_table f = {.mu_static = 0.3,
                          .mu_kinetic = 0.3,
                          .losses = {.rolling = 0.05},
                          .pull = {0.03, 0.04}};
    for (double phi = -3; phi < 4; ++phi) {
        coin_body b = rolling(&(coin_state){.phi = phi}, &p);
        coin_force F;
        check_status(coin_move(&b, &p, &f, 0, 1e-9, 0, NULL), COIN_RESTS);
        check_status(coin_body_reaction(&b, &p, &f, &F), COIN_OK);
        check_near(F.R[0], -0.03, 4 * U);
        check_near(F.normal, 1, 4 * U);
        check_near(F.R[2], -0.04, 4 * U);
    }
}

TEST(what_is_left_of_a_pivot_at_rest_is_0)
{
    const coin_params p = cylinder(0.4);
    const coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.3};
    coin_body b = rolling(&(coin_state){.wY = 5e-11, .wZ = 5e-11}, &p);
    check_status(coin_move(&b, &p, &f, 1, 1e-9, 0, NULL), COIN_RESTS);
    check(b.s.wY == 0 && b.s.wZ == 0 && b.vx == 0 && b.vz == 0);
}

/* All but a little weight is on one rim: the other cannot hold its half of the
 * force that makes the coin roll down the slope. */
TEST(a_rim_slips_that_has_too_little_weight_to_roll)
{
    const coin_params p = cylinder(0.1);
    for (int side = -1; side <= 1; side += 2) {
        coin_table f = {0.5, 0.4, .pull = {0.3, side * 0.0999}};
        coin_body b = rolling(&(coin_state){0}, &p);
        check_status(coin_move(&b, &p, &f, 0, 1e-9, 0, NULL), COIN_SLIPS);
        f.pull[0] = 4e-4;
        check_status(coin_move(&b, &p, &f, 0, 1e-9, 0, NULL), COIN_OK);
    }
}

/* Whichever way it heads, nothing holds it. */
TEST(on_ice_a_slope_moves_a_coin_on_both_rims)
{
    const coin_params p = cylinder(0.5);
    for (double phi = -3; phi < 3; phi += 0.0123) {
        const coin_table ice = {.losses = {.dry = 0.01},
                                .pull = {0.2 * sin(phi), 0.2 * cos(phi)}};
        coin_body b = rolling(&(coin_state){.phi = phi}, &p);
        check_note("phi %g", phi);
        check_status(coin_move(&b, &p, &ice, 1, 1e-9, 0, NULL), COIN_SLIPS);
        check_near(hypot(b.vx, b.vz), 0.2, 1e-9);
    }
}

TEST(a_coin_on_ice_slides_on_its_edge_as_it_does)
{
    const coin_params p = cylinder(0.3);
    const coin_table ice = {0};
    for (double v = 1e-3; v < 1; v *= 10) {
        coin_body b = rolling(&(coin_state){.phi = 1, .wZ = 0.5}, &p);
        b.vx += v;
        const coin_body before = b;
        check_status(coin_move(&b, &p, &ice, 2, 1e-2, 0, NULL), COIN_SLIPS);
        check_near(b.vx, before.vx, 4 * U);
        check_near(b.vz, before.vz, 4 * U);
        check(b.s.theta == 0 && b.s.wZ == 0.5);
    }
}

TEST(a_coin_on_its_edge_does_not_roll_out_of_range)
{
    const coin_params p = cylinder(0.3);
    const coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.3};
    coin_body b = rolling(&(coin_state){.x = 1e9 - 0.5, .wZ = -1}, &p);
    const coin_body before = b;
    double t = 0;
    check_status(coin_move(&b, &p, &f, 0.25, 1e-6, 0, &t), COIN_OK);
    b = before;
    check_status(coin_move(&b, &p, &f, 1, 1e-6, 0, &t), COIN_ERANGE);
    check(b.s.x <= 1e9 && t < 1);
}

/* What ends a motion, of starts on a level table, on one with losses and on a
 * slope. */
TEST(all_motions_end_and_none_gains_energy)
{
    struct random r = random_begin(613);
    const int n = tries_asked(4000);
    int ends[5] = {0, 0, 0, 0, 0};
    for (int i = 0; i < n; ++i) {
        coin_priv_law l = random_law(&r, 1);
        l.mu_static = l.mu_kinetic * (1 + i % 3 * 0.2);
        if (i % 4)
            l.pull[0] = l.pull[1] = 0;
        const struct place p = random_place(&r, &l, 0);
        coin_body b = standing(&p);
        const double before = energy(&b, &l);
        double t;
        check_note("case %d of seed %llu", i, (unsigned long long)r.seed);
        const int why = move_all(&b, &l, 100, &t, 11000);
        check(energy(&b, &l) - before <= TOL);
        ++ends[why + 1];
    }
    check(ends[0] + ends[1] + ends[3] + ends[4] == n);
    check_note("%d of %d need more than one call", ends[0], n);
    check(ends[0] <= n / 1000);
    check_share(ends[3], n, 0.1);
    check_share(ends[4], n, 0.1);
}

/* A pivot whose end lets go.  How fast the end begins to slip depends on its
 * normal force, which depends on that. */
TEST(a_slip_begins_alike_at_any_tolerance)
{
    coin_priv_law l = law_of(0.12, 0.46, 0.46);
    const struct place p = place_of(0.195, -0.7662, 0.1257, 0.12 * 0.7662, 0);
    const double tols[] = {1e-6, TOL};
    coin_body b[2];
    l.lossy = 1;
    l.spin = 0.0159;
    l.pull[0] = 0.0233;
    l.pull[1] = -0.0432;
    for (int k = 0; k < 2; ++k) {
        double t;
        b[k] = standing(&p);
        check(move_within(&b[k], &l, 1.2, tols[k], &t, 9999) ==
              COIN_PRIV_LINE_GOES);
    }
    const struct place q = place_at(&b[1]);
    check(!sticks_at(&l, &b[1], 1) && !sticks_at(&l, &b[1], -1));
    check_near(distance(&b[0], &q), 0, 10 * tols[0]);
}

/* Coulomb's friction is the limit of one with a width; the difference is of its
 * first order. */
TEST(a_motion_through_the_modes_is_that_of_nearly_rigid_friction)
{
    static const struct {
        double h, mu, wY, wZ, uX, uh, x, z;
    } cases[] = {
        {0.4, 0.2, 0.8, 0.1, 0.2, 0.1, 0, 0},
        {0.9, 0.3, -0.7, 0.4, 0, 0.3, 0, 0},
        {0.7, 0.1, 0.3, -0.3, -0.2, -0.1, 0.03, -0.02},
        {1.2, 0.25, 0.9, 0.2, 0.3, 0, -0.05, 0.1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_priv_law l = law_of(cases[i].h, cases[i].mu, cases[i].mu);
        const struct place p =
            place_of(0.5, cases[i].wY, cases[i].wZ, cases[i].uX, cases[i].uh);
        coin_body b = standing(&p);
        double t, off[2];
        l.pull[0] = cases[i].x;
        l.pull[1] = cases[i].z;
        check_note("case %zu", i);
        check(move_all(&b, &l, 3, &t, 11000) == COIN_PRIV_LINE_GOES);
        for (int k = 0; k < 2; ++k) {
            const struct meeting near = {0, k ? 1e-4 : 4e-4};
            const struct place q =
                integrate(&l, p, near, near, 3, k ? 24000 : 6000);
            off[k] = distance(&b, &q);
        }
        check_within(off[0] / off[1], 3, 5.5);
        check_within(off[1], 0, 2e-2);
    }
}
