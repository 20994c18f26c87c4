/* SPDX-License-Identifier: MIT */
/* SUNDIALS CVODE: Adams of variable order, fixed-point iteration. */
#include "rates.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

static struct {
    const scene *c;
    struct peer_body b;
    void *cvode;
    N_Vector y;
    double t;
} at;

static int rates(double t, N_Vector y, N_Vector d, void *body)
{
    (void)t;
    peer_rates(body, N_VGetArrayPointer(y), N_VGetArrayPointer(d));
    return 0;
}

static void must(int failed)
{
    if (failed) {
        fprintf(stderr, "cvode: set-up failed\n");
        exit(1);
    }
}

static void set_up(void)
{
    SUNContext context;
    must(SUNContext_Create(NULL, &context));
    at.y = N_VNew_Serial(8, context);
    scene_to_natural(at.c, N_VGetArrayPointer(at.y));
    at.cvode = CVodeCreate(CV_ADAMS, context);
    must(!at.y || !at.cvode || CVodeInit(at.cvode, rates, 0, at.y));
    must(CVodeSetUserData(at.cvode, &at.b));
    must(CVodeSetMaxNumSteps(at.cvode, 10000000));
    must(CVodeSetNonlinearSolver(at.cvode,
                                 SUNNonlinSol_FixedPoint(at.y, 0, context)));
    /* A refused step is reported as a row, not on the terminal. */
    must(CVodeSetErrFile(at.cvode, NULL));
}

static void begin(const solver *self, const scene *c, double setting)
{
    (void)self;
    at.c = c;
    at.b = peer_body_of(c);
    at.t = 0;
    if (!at.cvode)
        set_up();
    scene_to_natural(c, N_VGetArrayPointer(at.y));
    must(CVodeReInit(at.cvode, 0, at.y));
    must(CVodeSStolerances(at.cvode, setting, setting));
}

static int go(double t, unsigned long steps)
{
    (void)steps;
    const double end = at.t + t / at.c->unit;
    return CVode(at.cvode, end, at.y, &at.t, CV_NORMAL);
}

static coin_state state(void)
{
    return scene_from_natural(at.c, N_VGetArrayPointer(at.y));
}

int main(int argc, char **argv)
{
    static const solver list[] = {
        {"CVODE Adams", 0, 0, PEER_TOLERANCES, 20e6, 0, begin, go, state},
    };
    return workprec(list, 1, argc, argv);
}
