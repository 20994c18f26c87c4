/* SPDX-License-Identifier: MIT */
/* A program that was compiled before: abi.sh compiles it with the headers of a
 * soname's first release, and runs it with the library of today.  It prints,
 * in hexadecimal, what it reads through every struct. */
#include "headers.h"

#include <stdio.h>
#include <string.h>

typedef void any_function(void);

/* All that those headers declare: a symbol that is gone shows at the start. */
#define CALL(name) (any_function *)name,
static any_function *const all[] = {
#include "calls.h"
};

enum { SAMPLES = 4 };

static void print_state(const coin_state *s)
{
    printf("%a %a %a %a %a %a %a %a\n", s->theta, s->phi, s->psi, s->x, s->z,
           s->wX, s->wY, s->wZ);
}

/* The reserved members too, whatever they are called. */
static void print_params(const coin_params *p)
{
    double member[8];
    memcpy(member, p, sizeof member);
    for (int i = 0; i < 8; ++i)
        printf("%a\n", member[i]);
}

static int32_t roll(const coin_params *p)
{
    coin_state path[SAMPLES], s = {0.3, 0, 0, 0, 0, 0, 5, 40};
    size_t done;
    int32_t status =
        coin_sample(&s, p, COIN_RK8, 1.0 / 120, 40, SAMPLES, path, &done);
    for (size_t k = 0; k < done; ++k)
        print_state(&path[k]);
    status |= coin_run(&s, p, COIN_SYMPLECTIC4, 1e-3, 100, NULL);
    print_state(&s);
    return status;
}

static int32_t look(const coin_params *p)
{
    const coin_state s = {0.3, 0.2, 0.1, 0, 0, 0, 5, 40};
    coin_force f;
    const int32_t status = coin_reaction(&s, p, &f);
    printf("%a %a %a %a %a %a\n", f.R[0], f.R[1], f.R[2], f.normal, f.friction,
           f.ratio);
    printf("%d\n", (int)coin_check(&s, p, COIN_RK4, 1e-3, 0.01));
    return status;
}

static int32_t toss(const coin_params *p)
{
    coin_table table = {.mu_static = 0.4,
                        .mu_kinetic = 0.3,
                        .restitution = 0.4,
                        .losses = {.dry = 1e-5, .spin = 1e-8, .flat = 1e-5}};
    coin_body b = {.s = {.theta = 1, .wX = 90, .wY = 5, .wZ = 5},
                   .y = 0.05,
                   .vx = 0.1,
                   .vy = 1.2};
    double reached = 0;
    int32_t status = coin_move(&b, p, &table, 0.02, 1e-6, 0, &reached);
    print_state(&b.s);
    printf("%a %a %a %a %d\n", b.y, b.vx, b.vy, b.vz, (int)status);
    table.pull[0] = 0.5;
    status = coin_move(&b, p, &table, 5, 1e-6, COIN_TOUCHES, &reached);
    printf("%a %d %d\n", reached, (int)coin_body_face(&b, p), (int)status);
    status = coin_losses_fit(&table.losses, &b.s, p, 1);
    printf("%a %d\n", table.losses.dry, (int)status);
    return COIN_OK;
}

static int32_t orbit(const coin_params *p)
{
    static coin_orbit o;
    const coin_state start = {0.3, 0, 0, 0, 0, 0, 5, 40};
    coin_state s;
    int32_t status = coin_orbit_init(&o, &start, p);
    printf("%a %a %a %a %a %a %a %a %a %a\n", o.period, o.heading_per_period,
           o.roll_per_period, o.theta_min, o.theta_max, o.center[1],
           o.radius_min, o.radius_max, o.drift[0], o.conditioning);
    status |= coin_orbit_at(&o, 1, &s);
    print_state(&s);
    return status;
}

int main(void)
{
    coin_params p;
    const int32_t status = coin_params_disc(&p, 0.00567, 0.01213, 9.80665);
    size_t known = 0;

    while (known < sizeof all / sizeof *all && all[known])
        ++known;
    print_params(&p);
    printf("%u %u\n",
           (unsigned)(coin_sizeof("coin_state") - sizeof(coin_state)),
           (unsigned)(coin_sizeof("coin_params") - sizeof(coin_params)));
    return (status | roll(&p) | look(&p) | toss(&p) | orbit(&p)) != COIN_OK ||
           known < sizeof all / sizeof *all;
}
