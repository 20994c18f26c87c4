/* SPDX-License-Identifier: MIT */
/* The flowers that a rolling coin's point of contact draws.
 *
 *   cc rosettes.c $(pkg-config --cflags --libs rollcoin) -lm
 *
 * In one period of its lean a coin turns its heading by some angle, and then
 * does the same again.  If that angle is turns/petals of a circle, the path
 * closes after so many petals; if it is a whole circle, the coin walks away.
 * Here wY is varied until it is that angle. */
#include "turning.h"

#define PI 3.14159265358979323846

typedef struct flower {
    const char *name;
    double inner; /* of the ring, over its radius */
    double theta, wZ;
    double wY_low, wY_high; /* between them the angle is met */
    int turns, petals;
    int drawn, points; /* how many petals, and points in each */
} flower;

static const flower FLOWERS[] = {
    {"four sevenths", 0, 0.5, 0.8, -0.6, -0.3, 4, 7, 7, 130},
    {"three eighths", 1, 0.2, 0.8, -1, -0.3, 3, 8, 8, 164},
    {"nine eighths", 0, 0.9, 0.3, 1, 1.5, 9, 8, 8, 60},
    {"three fifths", 0, 0.9, 0.8, -0.3, 0.3, 3, 5, 5, 72},
    {"four thirds", 0, 0.2, 0.3, 1, 1.5, 4, 3, 3, 72},
    {"whole", 1, 0.9, 0.3, 1, 1.5, 1, 1, 9, 60},
};

static coin_state start_of(const flower *f, double wY)
{
    const coin_state s = {f->theta, 0, 0, 0, 0, 0, wY, f->wZ};
    return s;
}

/* How far the heading turns beyond turns/petals of a circle in a period. */
static double excess(const flower *f, const coin_params *p, double wY)
{
    coin_state s = start_of(f, wY);

    one_period(&s, p);
    return s.phi - 2 * PI * f->turns / f->petals;
}

static double matched(const flower *f, const coin_params *p)
{
    double low = f->wY_low, high = f->wY_high;
    const double below = excess(f, p, low);

    for (int k = 0; k < 50; ++k) {
        const double middle = (low + high) / 2;
        *(excess(f, p, middle) * below > 0 ? &low : &high) = middle;
    }
    return low;
}

static void draw(const flower *f)
{
    coin_params p;

    demand(coin_params_ring(&p, 1, 1, f->inner, 1));
    coin_state s = start_of(f, matched(f, &p)), end = s;
    const double dt = one_period(&end, &p) / f->points;
    for (int k = 0; k <= f->drawn * f->points; ++k) {
        double r[3], v[3];
        demand(coin_contact(&s, &p, r, v));
        printf("%s,%.4f,%.4f\n", f->name, r[0], r[2]);
        roll_on(&s, &p, dt);
    }
    printf("\n\n"); /* gnuplot's end of a curve */
}

int main(void)
{
    printf("flower,x,z\n");
    for (size_t k = 0; k < sizeof FLOWERS / sizeof *FLOWERS; ++k)
        draw(&FLOWERS[k]);
    return EXIT_SUCCESS;
}
