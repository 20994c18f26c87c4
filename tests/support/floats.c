/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "check.h"
#include "methods.h"

#include <math.h>

coinf_params floats_params(const coin_params *p)
{
    const coinf_params f = {
        (float)p->mass,
        (float)p->radius,
        (float)p->gravity,
        (float)p->inertia_X,
        (float)p->inertia_Z,
        (float)p->thickness,
        {(float)p->reserved[0], (float)p->reserved[1]},
    };
    return f;
}

coinf_state floats_state(const coin_state *s)
{
    const coinf_state f = {
        (float)s->theta, (float)s->phi, (float)s->psi, (float)s->x, (float)s->z,
        (float)s->wX,    (float)s->wY,  (float)s->wZ,  {0},
    };
    return f;
}

coin_params doubles_params(const coinf_params *p)
{
    coin_params d;
    check_status(coin_params_body(&d, p->mass, p->radius, p->gravity,
                                  p->inertia_X, p->inertia_Z),
                 COIN_OK);
    return d;
}

coin_state doubles_state(const coinf_state *s)
{
    const float *low = s->low;
    const coin_state d = {
        s->theta + (double)low[0], s->phi + (double)low[1],
        s->psi + (double)low[2],   s->x + (double)low[3],
        s->z + (double)low[4],     s->wX + (double)low[5],
        s->wY + (double)low[6],    s->wZ + (double)low[7],
    };
    return d;
}

/* An angle less the whole turns that bring it nearest to another. */
static double near(double angle, double other)
{
    const double turn = 6.283185307179586476925;
    return angle - turn * rint((angle - other) / turn);
}

double floats_error(const coinf_state *s, const coinf_state *start,
                    const coinf_params *p, double t)
{
    const coin_params d = doubles_params(p);
    coin_state want = doubles_state(start), got = doubles_state(s);
    check_status(coin_advance(&want, &d, t, 1e-13, NULL), COIN_OK);
    got.phi = near(got.phi, want.phi);
    got.psi = near(got.psi, want.psi);
    return path_apart(&got, &want, &d);
}
