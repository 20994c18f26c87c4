/* SPDX-License-Identifier: MIT */
#include "functions.h"

#include "floats.h"
#include "random.h"

#include <math.h>
#include <string.h>

struct function functions[MOST_FUNCTIONS];
size_t function_count;

/* A function, what its pointers are, and a call of it. */
#define FUNCTION(name, kinds, expression)                                      \
    static int32_t call_##name(void *const a[], const struct numbers *c)       \
    {                                                                          \
        (void)a, (void)c;                                                      \
        return expression;                                                     \
    }                                                                          \
    __attribute__((constructor)) static void add_##name(void)                  \
    {                                                                          \
        functions[function_count++] =                                          \
            (struct function){#name, kinds, call_##name};                      \
    }

/* The same of one that returns a number. */
#define VALUE(name, kinds, expression)                                         \
    FUNCTION(name, kinds, isnan(expression) ? NOT_A_NUMBER : COIN_OK)

/* ----------------------------------------------------- constants, parameters
 */
VALUE(coin_version, "", (double)coin_version())
VALUE(coin_version_string, "", (double)coin_version_string()[0])
VALUE(coin_status_string, "", (double)coin_status_string(-3)[0])
VALUE(coin_sizeof, "", (double)coin_sizeof("coin_state"))
VALUE(coin_method_name, "", (double)coin_method_name(1)[0])
/* Once is enough.  What they return is asked in test_selftest alone, so that a
 * mutant is noticed by what it breaks and not by its bits. */
VALUE(coin_selftest, "", c->s.wZ == 1 ? (double)coin_selftest() : 0)
FUNCTION(coin_params_disc, "P",
         coin_params_disc(a[0], c->p.mass, c->p.radius, c->p.gravity))
FUNCTION(coin_params_ring, "P",
         coin_params_ring(a[0], c->p.mass, c->p.radius, c->p.radius / 2,
                          c->p.gravity))
FUNCTION(coin_params_body, "P",
         coin_params_body(a[0], c->p.mass, c->p.radius, c->p.gravity,
                          c->p.inertia_X, c->p.inertia_Z))
FUNCTION(coin_params_cylinder, "P",
         coin_params_cylinder(a[0], c->p.mass, c->p.radius, c->p.radius / 4,
                              c->p.gravity))
FUNCTION(coin_params_check, "p", coin_params_check(a[0]))
VALUE(coin_critical_roll, "p", coin_critical_roll(a[0]))
VALUE(coin_critical_spin, "p", coin_critical_spin(a[0]))

/* -------------------------------------------------------------- observables */
FUNCTION(coin_state_check, "sp", coin_state_check(a[0], a[1]))
FUNCTION(coin_state_from_motion, "opqw",
         coin_state_from_motion(a[0], a[1], a[2], a[3], c->s.x, c->s.z))
FUNCTION(coin_angular_velocity, "so", coin_angular_velocity(a[0], a[1]))
VALUE(coin_energy, "sp", coin_energy(a[0], a[1]))
VALUE(coin_fastest_rate, "sp", coin_fastest_rate(a[0], a[1]))
FUNCTION(coin_integrals, "spo", coin_integrals(a[0], a[1], a[2]))
FUNCTION(coin_reaction, "spo", coin_reaction(a[0], a[1], a[2]))
FUNCTION(coin_rates, "spo", coin_rates(a[0], a[1], a[2]))
FUNCTION(coin_center, "spo", coin_center(a[0], a[1], a[2]))
FUNCTION(coin_velocity, "spo", coin_velocity(a[0], a[1], a[2]))
FUNCTION(coin_contact, "spoo", coin_contact(a[0], a[1], a[2], a[3]))
FUNCTION(coin_axes, "so", coin_axes(a[0], a[1]))
FUNCTION(coin_quaternion, "so", coin_quaternion(a[0], a[1]))
FUNCTION(coin_matrix, "spo", coin_matrix(a[0], a[1], a[2]))
FUNCTION(coin_check, "sp", coin_check(a[0], a[1], COIN_RK8, c->dt, c->mu))

/* ------------------------------------------------------------------- movers */
/* So short that a call comes to an end: no more than ten radians of any of its
 * rates, near flat too. */
static double some_time(const struct numbers *c)
{
    const double wX = c->s.wX, wY = c->s.wY, wZ = c->s.wZ;
    const double cth = cos(c->s.theta);
    const double w = sqrt((wX * wX + wY * wY) / (cth * cth) + wZ * wZ +
                          c->p.gravity / (c->p.radius * cth));
    return fmin(c->t, 10 / w);
}

/* As many coins as the widest vector holds, and one by itself; a block of
 * steps, or less. */
static int32_t batch(const coin_state *s, const coin_params *p, int32_t method,
                     double dt)
{
    coin_state coins[9];
    for (int i = 0; s && i < 9; ++i)
        coins[i] = *s;
    return coin_batch_run(s ? coins : NULL, 9, p, method, dt,
                          method == COIN_RK4 ? 70 : 7, NULL);
}

FUNCTION(coin_step, "Sp", coin_step(a[0], a[1], c->dt))
FUNCTION(coin_run_rk4, "Spn", coin_run(a[0], a[1], COIN_RK4, c->dt, 70, a[2]))
FUNCTION(coin_run_rk8, "Spn", coin_run(a[0], a[1], COIN_RK8, c->dt, 70, a[2]))
FUNCTION(coin_run_symplectic2, "Spn",
         coin_run(a[0], a[1], COIN_SYMPLECTIC2, c->dt, 70, a[2]))
FUNCTION(coin_run_symplectic4, "Spn",
         coin_run(a[0], a[1], COIN_SYMPLECTIC4, c->dt, 70, a[2]))
FUNCTION(coin_batch_run, "Sp",
         coin_batch_run(a[0], 1, a[1], COIN_RK4, c->dt, 3, NULL))
FUNCTION(coin_batch_run_rk4, "sp", batch(a[0], a[1], COIN_RK4, c->dt))
FUNCTION(coin_batch_run_rk8, "sp", batch(a[0], a[1], COIN_RK8, c->dt))
FUNCTION(coin_sample, "spon",
         coin_sample(a[0], a[1], COIN_RK4, c->dt, 5, 3, a[2], a[3]))
FUNCTION(coin_advance, "Spn",
         coin_advance(a[0], a[1], some_time(c), 1e-6, a[2]))
FUNCTION(coin_orbit_init, "osp", coin_orbit_init(a[0], a[1], a[2]))
FUNCTION(coin_orbit_at, "bo", coin_orbit_at(a[0], c->t, a[1]))

/* ----------------------------------------------------------- steady motions */
FUNCTION(coin_steady_roll, "op", coin_steady_roll(a[0], a[1], c->s.wZ))
FUNCTION(coin_steady_spin, "op", coin_steady_spin(a[0], a[1], c->s.theta))
FUNCTION(coin_steady_upright_spin, "op",
         coin_steady_upright_spin(a[0], a[1], c->s.wY))
FUNCTION(coin_steady_circle, "op",
         coin_steady_circle(a[0], a[1], c->s.theta, c->s.wZ,
                            c->dt > 0 ? 1 : -1))
FUNCTION(coin_steady_turn, "op",
         coin_steady_turn(a[0], a[1], c->s.theta, fabs(c->s.x)))
FUNCTION(coin_steady_ride, "op",
         coin_steady_ride(a[0], a[1], fabs(c->s.wZ) * c->p.radius, c->p.radius))
FUNCTION(coin_steady_radii, "cpoo", coin_steady_radii(a[0], a[1], a[2], a[3]))
FUNCTION(coin_steady_at, "cpo", coin_steady_at(a[0], a[1], c->t, a[2]))
FUNCTION(coin_stability, "cpo", coin_stability(a[0], a[1], a[2]))

/* ------------------------------------------------------- losses, and bodies */
/* What settles a coin to rest, once or up to a hundred times: in one case of
 * 72, none of them upright, which never rests. */
#define NOW_AND_THEN(call) (c->index % 72 != 71 ? COIN_OK : (call))

FUNCTION(coin_losses_check, "lp", coin_losses_check(a[0], a[1]))
VALUE(coin_losses_power, "spl", coin_losses_power(a[0], a[1], a[2]))
FUNCTION(coin_losses_rates, "splo", coin_losses_rates(a[0], a[1], a[2], a[3]))
FUNCTION(coin_losses_reaction, "splo",
         coin_losses_reaction(a[0], a[1], a[2], a[3]))
FUNCTION(coin_settle, "Spln",
         coin_settle(a[0], a[1], a[2], fabs(some_time(c)), 1e-6, a[3]))
VALUE(coin_time_to_rest, "spl",
      NOW_AND_THEN(coin_time_to_rest(a[0], a[1], a[2], 1e-6)))
FUNCTION(coin_losses_fit, "Lsp",
         NOW_AND_THEN(coin_losses_fit(a[0], a[1], a[2],
                                      some_time(c) > 0 ? c->t : 1)))
FUNCTION(coin_table_check, "tp", coin_table_check(a[0], a[1]))
FUNCTION(coin_body_from_state, "osp", coin_body_from_state(a[0], a[1], a[2]))
FUNCTION(coin_body_from_motion, "opqww",
         coin_body_from_motion(a[0], a[1], a[2], a[3],
                               a[4] ? (const double[]){0, 9 * c->p.radius, 0}
                                    : NULL,
                               a[4]))
FUNCTION(coin_move, "Gptn",
         coin_move(a[0], a[1], a[2], fabs(some_time(c)), 1e-6,
                   c->mu > 0.5 ? COIN_SLIPS | COIN_ROLLS : 0, a[3]))
/* Which side is up is no status. */
static int32_t face_of(int32_t answer)
{
    return answer < 0 ? answer : COIN_OK;
}

VALUE(coin_body_energy, "gp", coin_body_energy(a[0], a[1]))
FUNCTION(coin_body_reaction, "gpto", coin_body_reaction(a[0], a[1], a[2], a[3]))
FUNCTION(coin_body_contact, "gpo", coin_body_contact(a[0], a[1], a[2]))
FUNCTION(coin_body_matrix, "gpo", coin_body_matrix(a[0], a[1], a[2]))
FUNCTION(coin_body_strike, "Gpww", coin_body_strike(a[0], a[1], a[2], a[3]))
FUNCTION(coin_body_face, "gp", face_of(coin_body_face(a[0], a[1])))

/* ------------------------------------------------------------------- floats */
#define F(value) ((float)(value))

VALUE(coinf_selftest, "", c->s.wZ == 1 ? (double)coinf_selftest() : 0)
FUNCTION(coinf_params_disc, "P",
         coinf_params_disc(a[0], F(c->p.mass), F(c->p.radius), F(c->p.gravity)))
FUNCTION(coinf_params_ring, "P",
         coinf_params_ring(a[0], F(c->p.mass), F(c->p.radius),
                           F(c->p.radius / 2), F(c->p.gravity)))
FUNCTION(coinf_params_body, "P",
         coinf_params_body(a[0], F(c->p.mass), F(c->p.radius), F(c->p.gravity),
                           F(c->p.inertia_X), F(c->p.inertia_Z)))
FUNCTION(coinf_params_check, "p", coinf_params_check(a[0]))
FUNCTION(coinf_state_check, "sp", coinf_state_check(a[0], a[1]))
FUNCTION(coinf_state_from_motion, "opqw",
         coinf_state_from_motion(a[0], a[1], a[2], a[3], F(c->s.x), F(c->s.z)))
FUNCTION(coinf_angular_velocity, "so", coinf_angular_velocity(a[0], a[1]))
VALUE(coinf_energy, "sp", coinf_energy(a[0], a[1]))
VALUE(coinf_fastest_rate, "sp", coinf_fastest_rate(a[0], a[1]))
FUNCTION(coinf_integrals, "spo", coinf_integrals(a[0], a[1], a[2]))
FUNCTION(coinf_reaction, "spo", coinf_reaction(a[0], a[1], a[2]))
FUNCTION(coinf_rates, "spo", coinf_rates(a[0], a[1], a[2]))
FUNCTION(coinf_center, "spo", coinf_center(a[0], a[1], a[2]))
FUNCTION(coinf_velocity, "spo", coinf_velocity(a[0], a[1], a[2]))
FUNCTION(coinf_contact, "spoo", coinf_contact(a[0], a[1], a[2], a[3]))
FUNCTION(coinf_axes, "so", coinf_axes(a[0], a[1]))
FUNCTION(coinf_quaternion, "so", coinf_quaternion(a[0], a[1]))
FUNCTION(coinf_matrix, "spo", coinf_matrix(a[0], a[1], a[2]))
FUNCTION(coinf_check, "sp",
         coinf_check(a[0], a[1], COIN_RK4, F(c->dt), F(c->mu)))
FUNCTION(coinf_step, "Sp", coinf_step(a[0], a[1], F(c->dt)))
FUNCTION(coinf_run, "Spn", coinf_run(a[0], a[1], COIN_RK4, F(c->dt), 130, a[2]))

int function_is_single(const struct function *f)
{
    return strncmp(f->name, "coinf", 5) == 0;
}

/* ---------------------------------------------------------------- arguments */
#define PLACE(a, value) memcpy((a)->bytes, &(value), sizeof(value))

/* Some of each: a hundredth of the weight's torque, and less on a body of so
 * little inertia that it would take many steps. */
static coin_losses losses(const struct numbers *c)
{
    const double a = c->p.radius, w0 = sqrt(c->p.gravity / a);
    const double m = c->p.mass * a * a;
    const double torque = 1e-2 * fmin(m, 4 * c->p.inertia_X) * w0 * w0;
    const coin_losses l = {.damping = 1e-2,
                           .dry = torque,
                           .viscous = torque / w0,
                           .layer = torque / (w0 * sqrt(w0)),
                           .gap = torque / w0,
                           .rolling = torque,
                           .spin = torque / w0,
                           .angular = 1e-2 * w0,
                           .flat = 1e-3};
    return l;
}

/* With losses back in time. */
static coin_table table(const struct numbers *c)
{
    coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.25};
    if (c->t < 0)
        f.losses = losses(c);
    f.losses.damping = 0;
    return f;
}

/* Rolls if dt is negative, else it slips; if t is small it flies. */
static coin_body body(const coin_state *s, const coin_params *p,
                      const struct numbers *c)
{
    coin_body b = {.s = *s};
    if (coin_body_from_state(&b, s, p) != COIN_OK)
        return b;
    b.vx += c->dt < 0 ? 0 : 0.3 * sqrt(p->gravity * p->radius);
    b.y += fabs(c->t) < 1e-6 ? p->radius : 0;
    return b;
}

/* A quaternion of any norm, and the angular velocity. */
static void place_motion(union argument *a, char kind, const coin_state *s,
                         double size, int single)
{
    double v[4] = {0.5, 0.1, 0.2, 0.3};
    float narrow[4];
    (void)(kind == 'q' ? coin_quaternion(s, v) : coin_angular_velocity(s, v));
    for (int i = 0; i < 4; ++i) {
        v[i] *= kind == 'q' ? size : 1;
        narrow[i] = (float)v[i];
    }
    if (single)
        PLACE(a, narrow);
    else
        PLACE(a, v);
}

static void place_double(union argument *a, char kind, const coin_state *s,
                         const coin_params *p, const struct numbers *c)
{
    coin_state steady = *s;
    coin_orbit o;
    const coin_losses l = losses(c);
    const coin_table f = table(c);
    const coin_body b = body(s, p, c);
    if (strchr("sS", kind))
        PLACE(a, *s);
    else if (kind == 'p')
        PLACE(a, *p);
    else if (strchr("lL", kind))
        PLACE(a, l);
    else if (kind == 't')
        PLACE(a, f);
    else if (strchr("gG", kind))
        PLACE(a, b);
    else if (kind == 'c') {
        (void)coin_steady_circle(&steady, p, s->theta, s->wZ, 1);
        PLACE(a, steady);
    } else if (kind == 'b') {
        memset(&o, 0, sizeof o); /* which is none */
        (void)coin_orbit_init(&o, s, p);
        PLACE(a, o);
    }
}

static void place_single(union argument *a, char kind, const coin_state *s,
                         const coin_params *p)
{
    const coinf_state narrow = floats_state(s);
    const coinf_params body_of = floats_params(p);
    if (strchr("sS", kind))
        PLACE(a, narrow);
    else if (kind == 'p')
        PLACE(a, body_of);
}

void function_arguments(union argument a[POINTERS], const struct function *f,
                        const coin_state *s, const coin_params *p,
                        const struct numbers *c)
{
    const int single = function_is_single(f);
    for (size_t i = 0; f->kinds[i]; ++i)
        if (strchr("qw", f->kinds[i]))
            place_motion(&a[i], f->kinds[i], s,
                         c->mu > 0 ? 1
                         : single  ? 1e30
                                   : 1e200,
                         single);
        else if (single)
            place_single(&a[i], f->kinds[i], s, p);
        else
            place_double(&a[i], f->kinds[i], s, p, c);
}
