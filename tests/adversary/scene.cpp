/* SPDX-License-Identifier: MIT */
#include "scene.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

void circles_of(const scene &s, double *large, double *slow)
{
    const double K = s.IZ + s.M * s.a * s.a, Mga = s.M * s.g * s.a;
    const double T = std::tan(s.theta), sth = std::sin(s.theta), b = K * s.wZ;
    const double r = std::sqrt(b * b + 4 * s.IX * Mga * sth * T);
    const double q = -(b + (b < 0 ? -r : r)) / 2;
    *large = q / (s.IX * T);
    *slow = -Mga * sth / q;
}

double power_of_ten(double gene, double low, double high)
{
    return std::pow(10, low + gene * (high - low));
}

double fastest_of(const scene &s)
{
    const double c = std::cos(s.theta);
    return std::sqrt((s.wX * s.wX + s.wY * s.wY) / (c * c) + s.wZ * s.wZ +
                     s.g / (s.a * c));
}

double unit_of(const scene &s)
{
    return std::sqrt(s.a / s.g);
}

namespace
{
constexpr double FLAT = 1.5707963267948966;

/* Either sign, even in the logarithm; 0 once in fifty. */
double either(double gene, double low, double high)
{
    const double part = gene < 0.5 ? 2 * gene : 2 * gene - 1;
    const double size = part < 0.02 ? 0 : power_of_ten(part, low, high);
    return gene < 0.5 ? size : -size;
}

/* Natural, a quarter's, any, far. */
void choose_units(scene *s, const double *g, bool narrow)
{
    const int k = int(10 * g[0]);
    const double far = k < 5 ? 0 : k < 8 ? 6 : 15;
    const double size = narrow ? far / 3 : far;
    s->M = k == 4 ? 0.00567 : power_of_ten(g[1], -size, size);
    s->a = k == 4 ? 0.01213 : power_of_ten(g[2], -size, size);
    s->g = k == 4 ? 9.80665 : power_of_ten(g[3], -size, size);
}

/* Discs, hoops, rings; bodies, some far from a disc. */
void choose_inertia(scene *s, const double *g)
{
    const double m = s->M * s->a * s->a;
    const int k = int(8 * g[0]);
    const double b = k < 3 ? 0 : k < 4 ? 1 : g[1], far = k < 7 ? 2 : 3;
    s->IX =
        k < 5 ? m * (1 + b * b) / 4 : m * power_of_ten(g[1], -far, 2 * far - 3);
    s->IZ = 2 * s->IX * (k < 5 ? 1 : power_of_ten(g[2], -far, 0));
}

/* Where series change, sin theta = 0.7; where sines change; cos theta = 0.01.
 */
constexpr double SERIES = 0.7753974966107530, SINES = 0.7853981633974483;
constexpr double NEARLY_FLAT = 1.5607961601207294;

/* Any; about upright; about flat; about where a formula changes; upright. */
double lean(const double *g)
{
    const int k = int(10 * g[0]);
    const double near = either(g[1], -16, -1), off = either(g[1], -15.6, 0);
    return k < 3   ? 3 * g[1] - 1.5
           : k < 5 ? either(g[1], -20, 0)
           : k < 7 ? (off < 0 ? -FLAT : FLAT) - off
           : k < 8 ? (g[2] < 0.5 ? -1 : 1) * (SERIES + near)
           : k < 9 ? (g[2] < 0.5 ? NEARLY_FLAT : SINES) + near
                   : 0;
}

/* A circle at the lean of *s, off by a part. */
void on_a_circle(scene *s, const double *g)
{
    double large, slow;
    circles_of(*s, &large, &slow);
    const double wY = g[0] < 0.3 ? large : slow;
    s->wY = std::isfinite(wY) ? wY * (1 + either(g[1], -18, 0)) : 0;
}

void choose_rates(scene *s, const double *g)
{
    const double w = 1 / unit_of(*s), Mga = s->M * s->g * s->a;
    const double m = s->M * s->a * s->a, c = std::cos(s->theta);
    const int k = int(10 * g[0]), what = int(12 * g[4]);
    const double slow = k < 7 ? -3 : k < 8 ? -12 : k < 9 ? -20 : -3;
    const double fast = k < 7 ? 0.7 : k < 9 ? 0 : 6;
    s->wX = w * either(g[1], slow, fast);
    s->wY = w * either(g[2], slow, fast);
    s->wZ = w * either(g[3], slow, fast);
    if (what < 5)
        s->wX = w * either(g[1], -17, -1);
    switch (what) {
    case 0:
    case 1:
        on_a_circle(s, g + 5);
        break;
    case 2: /* a spin */
        s->wZ = w * either(g[3], -17, -1);
        s->wY = std::sqrt(Mga / s->IX * c) * (1 + either(g[6], -17, 0));
        break;
    case 3: /* about the critical roll */
        s->wY = w * either(g[2], -17, -1);
        s->wZ = std::sqrt(Mga * s->IX / s->IZ / (s->IZ + m)) *
                (1 + either(g[6], -17, 0));
        break;
    case 4: /* about the critical spin */
        s->wZ = w * either(g[3], -17, -1);
        s->wY = std::sqrt(Mga / (s->IX + m)) * (1 + either(g[6], -17, 0));
        break;
    case 5: /* dropped */
        s->wX = 0;
        break;
    case 6: /* the contact soon turns round */
        s->wZ = 0.2 * s->wZ - s->wY * std::tan(s->theta);
        break;
    case 7: /* it falls, hardly spinning */
        s->wY *= power_of_ten(g[5], -10, 0);
        s->wZ *= power_of_ten(g[6], -10, 0);
        break;
    case 8: /* slow near flat */
        s->wX *= std::sqrt(c);
        s->wY *= c * power_of_ten(g[5], -2, 2);
        break;
    default:
        break;
    }
}

double heading(double gene)
{
    const int k = int(4 * gene);
    const double part = 4 * gene - k;
    return k == 0   ? 0
           : k == 1 ? either(part, -9, 9)
           : k == 2 ? (int(9 * part) - 4) * FLAT
                    : 6.283185307179586 * part - FLAT;
}

/* None, or any. */
void choose_losses(scene *s, const double *g)
{
    s->which = g[0] < 0.3 ? 0 : std::floor(1024 * (g[0] - 0.3) / 0.7);
    for (int i = 0; i < 4; ++i)
        s->loss[i] = power_of_ten(g[1 + i], -7.5, -1);
    s->soft = power_of_ten(g[5], -9, 0);
    s->flat = power_of_ten(g[4], -4, -2);
}

/* No friction; equal coefficients; one that never lets a slip begin. */
void choose_table(scene *s, const double *g)
{
    s->mu_kinetic = g[0] < 0.2 ? 0 : 1.2 * g[0];
    s->mu_static = g[0] < 0.2   ? 0
                   : g[1] > 0.7 ? double(INFINITY)
                                : s->mu_kinetic * (1 + g[1]);
    s->restitution = g[2];
}
} // namespace

scene scene_of(const genome &genes, bool narrow)
{
    const double *g = genes.data();
    scene s = {};
    choose_units(&s, g, narrow);
    choose_inertia(&s, g + 4);
    s.theta = lean(g + LEANS);
    choose_rates(&s, g + RATES);
    s.phi = narrow ? 6 * g[POSE] - 3 : heading(g[POSE]);
    s.psi = narrow ? 6 * g[POSE + 1] - 3 : heading(g[POSE + 1]);
    s.x = s.a * either(g[POSE + 2], -3, 2);
    s.z = s.a * either(g[POSE + 3], -3, 2);
    s.t = either(g[TIME], -3, 0.1) / fastest_of(s);
    s.count = std::floor(power_of_ten(g[COUNT], 0, 2));
    s.tol = power_of_ten(g[TOL], -12, -2);
    s.method = int(4 * g[METHOD]);
    for (int i = 0; i < 4; ++i)
        s.q[i] = either(g[QUAD + i], -17, 0);
    choose_table(&s, g + TABLE);
    choose_losses(&s, g + LOSS);
    s.above = power_of_ten(g[BODY], -3, 2);
    s.vx = 6 * g[BODY + 1] - 3;
    s.vy = 6 * g[BODY + 2] - 3;
    s.vz = 6 * g[BODY + 3] - 3;
    for (double *number = &s.M; narrow && number <= &s.vz; ++number)
        *number = double(float(*number));
    return s;
}

void set_on_table(coin_body *b, const coin_params &p)
{
    const double s = std::sin(b->s.theta), c = std::cos(b->s.theta);
    const double lower = s != 0 ? s : b->s.wX, half = p.thickness / 2;
    const double eta = lower > 0 ? half : lower < 0 ? -half : 0;
    b->y = p.radius * c + half * std::fabs(s);
    b->vy = (eta * c - p.radius * s) * b->s.wX;
}

coin_body body_of(const scene &s)
{
    const double v = std::sqrt(s.g * s.a);
    const double y = s.a * (std::cos(s.theta) + s.above) +
                     s.thickness / 2 * std::fabs(std::sin(s.theta));
    coin_body b = {
        state_of<coin_state>(s), y, s.vx * v, s.vy * v, s.vz * v, {}};
    if (s.above == 0)
        set_on_table(&b, params_of<coin_params>(s));
    return b;
}

/* The losses in parts of the coin's own torques. */
coin_losses losses_of(const scene &s)
{
    const double w = 1 / unit_of(s), torque = s.M * s.g * s.a;
    const double unit[] = {
        1,          torque, torque / w, torque / w / std::sqrt(w),
        torque / w, torque, torque / w};
    coin_losses l = {};
    const auto asks = [&s](int bit) { return int(s.which) >> bit & 1; };
    for (int i = 0; i < 7; ++i)
        (&l.damping)[i] = asks(i) * unit[i] * s.loss[i / 2];
    l.soft = asks(7) * w * s.soft;
    l.angular = asks(8) * w * s.loss[3];
    l.flat = asks(9) * s.flat;
    return l;
}

/* Without damping, which only a coin has that rolls. */
coin_table table_of(const scene &s)
{
    coin_losses l = losses_of(s);
    l.damping = 0;
    const double X = s.g * s.pull[0], Z = s.g * s.pull[1];
    return {s.mu_static, s.mu_kinetic, s.restitution, {X, Z}, {}, l};
}

void near_pose(scene *s, const double *g)
{
    s->phi = 6 * g[POSE] - 3;
    s->psi = 6 * g[POSE + 1] - 3;
    s->x = s->a * (6 * g[POSE + 2] - 3);
    s->z = s->a * (6 * g[POSE + 3] - 3);
}

void horizon(scene *s, const double *g, double low, double high)
{
    s->t = unit_of(*s) * power_of_ten(g[TIME], low, high);
    near_pose(s, g);
}

std::string text_of(const scene &s)
{
    std::string text;
    const double *numbers = &s.M;
    for (int i = 0; i < SCENE_NUMBERS; ++i) {
        char number[40];
        std::snprintf(number, sizeof number, i ? " %a" : "%a", numbers[i]);
        text += number;
    }
    return text;
}

bool scene_from(const char *text, scene *s)
{
    double *numbers = &s->M;
    for (int i = 0; i < SCENE_NUMBERS; ++i) {
        char *end;
        numbers[i] = std::strtod(text, &end);
        if (end == text)
            return false;
        text = end;
    }
    return true;
}
