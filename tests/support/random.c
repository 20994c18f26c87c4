/* SPDX-License-Identifier: MIT */
#include "random.h"

#include "check.h"

#include <math.h>
#include <stdlib.h>

struct random random_begin(uint64_t seed)
{
    const char *other = getenv("ROLLCOIN_SEED");
    const uint64_t s = other ? strtoull(other, NULL, 0) : seed;
    const struct random r = {s, s, 0};
    return r;
}

int tries_asked(int usual)
{
    const char *times = getenv("ROLLCOIN_TRIES");
    return times ? usual * atoi(times) : usual;
}

int all_asked(void)
{
    return tries_asked(1) > 1;
}

/* splitmix64, by Sebastiano Vigna. */
static uint64_t next(struct random *r)
{
    uint64_t z = r->state += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
}

double random_between(struct random *r, double low, double high)
{
    return low + (high - low) * ((double)(next(r) >> 11) * U);
}

double random_sized(struct random *r, double least, double most)
{
    const double beyond = random_between(r, least - most, most - least);
    return beyond + copysign(least, beyond);
}

coin_params random_coin(struct random *r)
{
    coin_params p;
    const double mass = pow(10, random_between(r, -3, 3));
    const double radius = pow(10, random_between(r, -3, 3));
    const double gravity = pow(10, random_between(r, -3, 3));
    const double inner = radius * random_between(r, 0, 1);
    check_status(coin_params_ring(&p, mass, radius, inner, gravity), COIN_OK);
    return p;
}

coin_state random_state(struct random *r, const coin_params *p,
                        double theta_max)
{
    const double w = 2 / natural_time(p), x = 3 * p->radius;
    coin_state s;
    s.theta = random_between(r, -theta_max, theta_max);
    s.phi = random_between(r, -3, 3);
    s.psi = random_between(r, -3, 3);
    s.x = random_between(r, -x, x);
    s.z = random_between(r, -x, x);
    s.wX = random_between(r, -w, w);
    s.wY = random_between(r, -w, w);
    s.wZ = random_between(r, -w, w);
    check_note("random scene %u of ROLLCOIN_SEED=%llu", ++r->drawn,
               (unsigned long long)r->seed);
    return s;
}

static int resolved(coin_state s, const coin_params *p, double dt,
                    uint64_t steps)
{
    return coin_run(&s, p, COIN_RK4, dt, steps, NULL) == COIN_OK;
}

coin_state random_motion(struct random *r, const coin_params *p, double dt,
                         uint64_t steps)
{
    const double h = dt * natural_time(p);
    for (int tries = 0; tries < 1000; ++tries) {
        const coin_state s = random_state(r, p, 1);
        if (resolved(s, p, h, steps) && resolved(s, p, -h, steps))
            return s;
    }
    check_note("no motion of seed %llu is resolved",
               (unsigned long long)r->seed);
    check(0);
    abort();
}

double natural_time(const coin_params *p)
{
    return sqrt(p->radius / p->gravity);
}
