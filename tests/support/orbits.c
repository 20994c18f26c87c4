/* SPDX-License-Identifier: MIT */
#include "orbits.h"

#include "check.h"

#include <math.h>

const char *far_scene(const struct table *t, size_t row)
{
    static const char *const scenes[] = {
        "generic",  "wobble",    "ring",     "quarter",
        "negative", "si_washer", "ring_b05", "nearflat",
    };
    return scenes[(size_t)table_at(t, row, "scene")];
}

coin_orbit orbit_of(const coin_state *s, const coin_params *p)
{
    coin_orbit o;
    check_status(coin_orbit_init(&o, s, p), COIN_OK);
    return o;
}

coin_orbit random_orbit(struct random *r, coin_params *p, coin_state *s)
{
    coin_orbit o;
    for (int tries = 0; tries < 10; ++tries) {
        *p = random_coin(r);
        *s = random_state(r, p, 1);
        if (coin_orbit_init(&o, s, p) == COIN_OK)
            return o;
    }
    check(0);
    return o;
}

double orbit_error(const coin_orbit *o, double t, double W)
{
    const double periods = o->period > 0 ? fabs(t) / o->period : 0;
    return 1e-14 + 1e-15 * o->conditioning * periods +
           4 * U * W * (fabs(t) + o->period);
}

void check_pose(const coin_orbit *o, double t, double W, const coin_state *want,
                const coin_params *p)
{
    const double e = orbit_error(o, t, W), a = p->radius;
    const double path = e * (a + (o->radius_max > 0 ? o->radius_max : 0));
    coin_state at;
    check_status(coin_orbit_at(o, t, &at), COIN_OK);
    check_near(at.theta, want->theta, e);
    check_near(at.phi, want->phi, e);
    check_near(at.psi, want->psi, e);
    check_near(at.x, want->x, path);
    check_near(at.z, want->z, path);
}
