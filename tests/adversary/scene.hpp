/* SPDX-License-Identifier: MIT */
/* What a public function is asked, as plain numbers, and how a search makes
 * it: from genes between 0 and 1, most of them logarithms, so that scenes next
 * to every edge are as near as any other. */
#ifndef ROLLCOIN_ADVERSARY_SCENE_HPP
#define ROLLCOIN_ADVERSARY_SCENE_HPP

#include <coin.h>

#include <array>
#include <string>

struct scene {
    double M, a, g, IX, IZ;
    double theta, phi, psi, x, z, wX, wY, wZ;
    double t;     /* a step, or the time of a call */
    double count; /* of steps or calls */
    double tol;
    double method; /* or the branch of a circle */
    double q[4];   /* a quaternion, or how a start differs from steady */
    double which, loss[4], soft, flat; /* losses: bits, and their sizes */
    double mu_kinetic, mu_static, restitution;
    double above, vx, vy, vz; /* a body, in parts of a and sqrt(g a) */
    double thickness, pull[2]; /* in parts of g */
    double blow[3], place[3];  /* in parts of M sqrt(g a) and a */
};
constexpr int SCENE_NUMBERS = sizeof(scene) / sizeof(double);

/* Of the genes that every scene draws from, those that a row draws anew. */
enum {
    LEANS = 7,
    RATES = 10,
    POSE = 18,
    TIME = 22,
    COUNT,
    TOL,
    METHOD,
    QUAD = 26,
    MORE = 30,
    LOSS = 34,
    TABLE = 40,
    BODY = 43,
    GENES = 48
};
using genome = std::array<double, GENES>;

/* The scene of a genome; narrow: within the range of floats. */
scene scene_of(const genome &genes, bool narrow);

/* 10 to a power between two. */
double power_of_ten(double gene, double low, double high);

/* wY of the two circles of a lean and a roll, (40). */
void circles_of(const scene &s, double *large, double *slow);

/* W of (47), and a natural unit of time. */
double fastest_of(const scene &s);
double unit_of(const scene &s);

template <class P> P params_of(const scene &s)
{
    P p = {};
    auto *to = &p.mass;
    for (double number : {s.M, s.a, s.g, s.IX, s.IZ, s.thickness})
        *to++ = decltype(p.mass)(number);
    return p;
}

template <class S> S state_of(const scene &s)
{
    S y = {};
    for (int i = 0; i < 8; ++i)
        (&y.theta)[i] = decltype(y.theta)((&s.theta)[i]);
    return y;
}

/* Its body, on the table if it is not above it; how one gets there.  Its losses
 * and its table. */
void set_on_table(coin_body *b, const coin_params &p);
coin_body body_of(const scene &s);
coin_losses losses_of(const scene &s);
coin_table table_of(const scene &s);

/* A pose of order one; a time of 10 to a power in natural units, either sign.
 */
void near_pose(scene *s, const double *genes);
void horizon(scene *s, const double *genes, double low, double high);

/* One line of hexadecimal numbers, and back; false if the line holds fewer. */
std::string text_of(const scene &s);
bool scene_from(const char *text, scene *s);

#endif
