/* SPDX-License-Identifier: MIT */
/* GSL's Dormand-Prince 8(5,3) under its own control of the step. */
#include "rates.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <string.h>

static struct {
    const scene *c;
    int free; /* of sines */
    struct peer_body b;
    gsl_odeiv2_system system;
    gsl_odeiv2_driver *driver;
    double setting, t, y[PEER_FREE_SIZE];
} at;

static int rates(double t, const double y[], double d[], void *body)
{
    (void)t;
    peer_rates(body, y, d);
    return GSL_SUCCESS;
}

static int free_rates(double t, const double y[], double d[], void *body)
{
    (void)t;
    peer_free_rates(body, y, d);
    return GSL_SUCCESS;
}

static void begin(const solver *self, const scene *c, double setting)
{
    if (at.driver && (setting != at.setting || self->which != at.free)) {
        gsl_odeiv2_driver_free(at.driver);
        at.driver = NULL;
    }
    at.c = c;
    at.b = peer_body_of(c);
    at.free = self->which;
    at.system.function = at.free ? free_rates : rates;
    at.system.dimension = at.free ? PEER_FREE_SIZE : PEER_SIZE;
    at.system.params = &at.b;
    at.setting = setting;
    at.t = 0;
    if (at.free)
        peer_free_start(c, at.y);
    else
        scene_to_natural(c, at.y);
    if (!at.driver)
        at.driver = gsl_odeiv2_driver_alloc_y_new(
            &at.system, gsl_odeiv2_step_rk8pd, 1e-3, setting, setting);
    gsl_odeiv2_driver_reset_hstart(at.driver, 1e-3);
}

static int go(double t, unsigned long steps)
{
    (void)steps;
    return gsl_odeiv2_driver_apply(at.driver, &at.t, at.t + t / at.c->unit,
                                   at.y) == GSL_SUCCESS
               ? 0
               : -1;
}

static coin_state state(void)
{
    return at.free ? peer_free_state(at.c, at.y)
                   : scene_from_natural(at.c, at.y);
}

int main(int argc, char **argv)
{
    static const solver list[] = {
        {"GSL rk8pd", 0, 0, PEER_TOLERANCES, 20e6, 0, begin, go, state},
        {"sine-free GSL rk8pd", 1, 0, PEER_TOLERANCES, 20e6, 0, begin, go,
         state},
    };
    gsl_set_error_handler_off();
    const int mapped = argc > 1 && strcmp(argv[1], "atlas") == 0;
    return workprec(list, mapped ? 1 : 2, argc, argv);
}
