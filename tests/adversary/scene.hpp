/* SPDX-License-Identifier: MIT */
/* What a public function is asked, as plain numbers, and how a search makes
 * it: from genes between 0 and 1, most of them logarithms, so that scenes next
 * to every edge are as near as any other. */
#ifndef ROLLCOIN_ADVERSARY_SCENE_HPP
#define ROLLCOIN_ADVERSARY_SCENE_HPP

#include "api.hpp"

#include <array>
#include <string>

struct scene {
    double M, a, g, IX, IZ;
    double theta, phi, psi, x, z, wX, wY, wZ;
    double t;      /* a step, a horizon, a rate or a radius: as the row says */
    double steps;  /* how many */
    double tol;    /* a tolerance, or the friction coefficient */
    double method; /* or the branch of a circle */
    double q[4];   /* a quaternion, or how a start differs from steady */
};
constexpr int SCENE_NUMBERS = sizeof(scene) / sizeof(double);

constexpr int GENES = 32;
using genome = std::array<double, GENES>;

/* The scene of a genome; narrow: within the range of floats. */
scene scene_of(const genome &genes, bool narrow);

/* wY of the two circles of a lean and a roll, (40). */
void circles_of(const scene &s, double *large, double *slow);

/* W of (47) of a scene; the pose of order one; that, and a horizon of 0.01 to
 * 60 natural units. */
double fastest_of(const scene &s);
void near_pose(scene *s, const double *genes);
void horizon(scene *s, const double *genes, int kind);

/* One line of hexadecimal numbers, and back; false if the line holds fewer. */
std::string text_of(const scene &s);
bool scene_from(const char *text, scene *s);

template <class T> typename T::params params_of(const scene &s)
{
    using real = typename T::real;
    typename T::params p = {};
    p.mass = real(s.M);
    p.radius = real(s.a);
    p.gravity = real(s.g);
    p.inertia_X = real(s.IX);
    p.inertia_Z = real(s.IZ);
    return p;
}

template <class T> typename T::state state_of(const scene &s)
{
    using real = typename T::real;
    typename T::state y = {};
    y.theta = real(s.theta);
    y.phi = real(s.phi);
    y.psi = real(s.psi);
    y.x = real(s.x);
    y.z = real(s.z);
    y.wX = real(s.wX);
    y.wY = real(s.wY);
    y.wZ = real(s.wZ);
    return y;
}

#endif
