/* SPDX-License-Identifier: MIT */
/* page.h: what the sources of the page share. */
#ifndef ROLLCOIN_PAGE_H
#define ROLLCOIN_PAGE_H

#include <coin.h>

/* A function that the page calls. */
#if defined(__wasm__)
#define PAGE(name) __attribute__((export_name(#name))) name
#else
#define PAGE(name) name
#endif

/* Of a real coin: what coin_move() is asked for. */
#define TOLERANCE_REAL 1e-6

enum { KNOTS = 60000, IMPACTS = 4000 };

/* What the page chooses.  y = 0: the coin begins by rolling, and vx, vy, vz are
 * not used.  mu is infinite for the ideal coin, which rolls whatever it needs;
 * any other is a real one, which slips, flies and bounces. */
typedef struct inputs {
    coin_state start;
    double y, vx, vy, vz;
    double mass, radius, inner_radius, gravity;
    coin_losses losses;
    double mu, restitution;
    double thickness; /* > 0: of a real coin without a hole */
} inputs;

/* A moment of the motion, and what is observed there. */
typedef struct moment {
    double t;
    coin_body body;
    double contact[2]; /* x, z of the lowest point */
    double R[3], normal, friction, ratio;
    double energy;
    double slip; /* the speed of the rim where it touches, or of the face */
    double bits; /* of coin_move() and coin_check(); COIN_RESTS at the end */
} moment;

/* The rim comes down on the table: when, and how fast. */
typedef struct impact {
    double t, speed;
} impact;

/* The motion on the page: what the library took, its body and its orbit, the
 * present, and the trail. */
extern struct motion {
    inputs taken;
    coin_params params;
    coin_table table;
    coin_body start;
    int lossy, real; /* whether it loses energy; whether mu is finite */
    coin_orbit orbit;
    int32_t orbit_status;
    moment now, knots[KNOTS];
    int count;
    impact impacts[IMPACTS];
    int32_t impact_count;
    int32_t age; /* of the trail: how many there have been */
} page;

int32_t page_scene_count(void);
inputs *page_asked(void);
double page_scene_number(int32_t k, int32_t which);
void page_scene(int32_t k);
int32_t page_take(void);
int32_t page_moved(coin_body *b, double t, double *reached);
double page_frame(void);
int32_t page_at(double base, double t);
void page_trail(double base);
int32_t page_trail_on(double end, int32_t count);

#endif
