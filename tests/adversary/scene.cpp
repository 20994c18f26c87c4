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

namespace
{
constexpr double FLAT = 1.5707963267948966;

double power_of_ten(double gene, double low, double high)
{
    return std::pow(10, low + gene * (high - low));
}

/* Either sign, even in the logarithm; 0 once in fifty. */
double either(double gene, double low, double high)
{
    const double part = gene < 0.5 ? 2 * gene : 2 * gene - 1;
    const double size = part < 0.02 ? 0 : power_of_ten(part, low, high);
    return gene < 0.5 ? size : -size;
}

int kind(double gene, int kinds)
{
    const int k = int(gene * kinds);
    return k < 0 ? 0 : k < kinds ? k : kinds - 1;
}

void choose_units(scene *s, const double *g, bool narrow)
{
    const double wide = narrow ? 4 : 6, extreme = narrow ? 8 : 15;
    const double units[][3] = {
        {1, 1, 1},
        {0.00567, 0.01213, 9.80665},
        {narrow ? 1e-6 : 1e-14, narrow ? 1e-3 : 1e-9, 9.81},
        {narrow ? 1e6 : 1e14, narrow ? 1e3 : 1e9, 1e-3},
        {power_of_ten(g[1], -wide, wide), power_of_ten(g[2], -wide, wide),
         power_of_ten(g[3], -wide, wide)},
        {power_of_ten(g[1], -extreme, extreme),
         power_of_ten(g[2], narrow ? -4 : -15, narrow ? 4 : 15),
         power_of_ten(g[3], narrow ? -4 : -15, narrow ? 4 : 15)},
    };
    const int choice[] = {0, 0, 0, 0, 1, 2, 3, 4, 4, 5};
    const double *of = units[choice[kind(g[0], 10)]];
    s->M = of[0];
    s->a = of[1];
    s->g = of[2];
}

void choose_inertia(scene *s, const double *g)
{
    const double m = s->M * s->a * s->a;
    switch (kind(g[0], 8)) {
    case 0:
    case 1:
    case 2: /* a disc */
        s->IX = m / 4;
        s->IZ = 2 * s->IX;
        return;
    case 3: /* a hoop */
        s->IX = m / 2;
        s->IZ = m;
        return;
    case 4: /* a ring */
        s->IX = m * (1 + g[1] * g[1]) / 4;
        s->IZ = 2 * s->IX;
        return;
    case 5:
    case 6: /* a body */
        s->IX = m * power_of_ten(g[1], -2, 1);
        s->IZ = 2 * s->IX * (0.01 + 0.99 * g[2]);
        return;
    default: /* one far from a disc */
        s->IX = m * power_of_ten(g[1], -3, 3);
        s->IZ = 2 * s->IX * power_of_ten(g[2], -3, 0);
    }
}

double lean(const double *g)
{
    switch (kind(g[0], 10)) {
    case 0:
    case 1:
    case 2:
        return 3 * g[1] - 1.5;
    case 3:
    case 4: /* upright */
        return either(g[1], -20, 0);
    case 5:
    case 6: { /* flat */
        const double off = either(g[1], -15.6, 0);
        return off < 0 ? -FLAT - off : FLAT - off;
    }
    case 7: /* where series change: sin theta = 0.7 */
        return (g[2] < 0.5 ? -1 : 1) *
               (0.7753974966107530 + either(g[1], -16, -1));
    case 8: /* where sines change, and cos theta = 0.01 */
        return (g[2] < 0.5 ? 1.5607961601207294 : 0.7853981633974483) +
               either(g[1], -16, -1);
    default:
        return 0;
    }
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
    const double w = std::sqrt(s->g / s->a);
    const double slowest[] = {-3, -3, -3, -3, -3, -3, -3, -12, -20, -3};
    const double fastest[] = {0.7, 0.7, 0.7, 0.7, 0.7, 0.7, 0.7, 0, 0, 6};
    const int k = kind(g[0], 10);
    s->wX = w * either(g[1], slowest[k], fastest[k]);
    s->wY = w * either(g[2], slowest[k], fastest[k]);
    s->wZ = w * either(g[3], slowest[k], fastest[k]);
    const int what = kind(g[4], 12);
    if (what < 5)
        s->wX = w * either(g[1], -17, -1);
    if (what == 5) /* dropped */
        s->wX = 0;
    if (what < 2)
        on_a_circle(s, g + 5);
    if (what < 2 || what > 4)
        return;
    /* A spin; about the critical roll; about the critical spin. */
    const double Mga = s->M * s->g * s->a, m = s->M * s->a * s->a;
    const double critical[] = {
        std::sqrt(Mga / s->IX * std::cos(s->theta)),
        std::sqrt(Mga * s->IX / s->IZ / (s->IZ + m)),
        std::sqrt(Mga / (s->IX + m)),
    };
    const bool rolls = what == 3;
    (rolls ? s->wY : s->wZ) = w * either(g[rolls ? 2 : 3], -17, -1);
    (rolls ? s->wZ : s->wY) = critical[what - 2] * (1 + either(g[6], -17, 0));
}

double heading(double gene)
{
    const int k = kind(gene, 4);
    const double part = 4 * gene - k;
    return k == 0   ? 0
           : k == 1 ? either(part, -9, 9)
           : k == 2 ? (kind(part, 9) - 4) * FLAT
                    : 6.283185307179586 * part - FLAT;
}
} // namespace

double fastest_of(const scene &s)
{
    const double c = std::cos(s.theta);
    return std::sqrt((s.wX * s.wX + s.wY * s.wY) / (c * c) + s.wZ * s.wZ +
                     s.g / (s.a * c));
}

void near_pose(scene *s, const double *genes)
{
    s->phi = 6 * genes[18] - 3;
    s->psi = 6 * genes[19] - 3;
    s->x = s->a * (6 * genes[20] - 3);
    s->z = s->a * (6 * genes[21] - 3);
}

void horizon(scene *s, const double *g, int)
{
    const double unit = std::sqrt(s->a / s->g);
    const double part = g[22] < 0.5 ? 2 * g[22] : 2 * g[22] - 1;
    s->t = unit * (g[22] < 0.5 ? 1 : -1) * std::pow(10, 3.8 * part - 2);
    near_pose(s, g);
}

scene scene_of(const genome &genes, bool narrow)
{
    const double *g = genes.data();
    scene s = {};
    choose_units(&s, g, narrow);
    choose_inertia(&s, g + 4);
    s.theta = lean(g + 7);
    choose_rates(&s, g + 10);
    s.phi = narrow ? 6 * g[18] - 3 : heading(g[18]);
    s.psi = narrow ? 6 * g[19] - 3 : heading(g[19]);
    s.x = s.a * either(g[20], -3, 2);
    s.z = s.a * either(g[21], -3, 2);
    s.t = either(g[22], -3, 0.1) / fastest_of(s);
    s.steps = std::floor(power_of_ten(g[23], 0, 2));
    s.tol = power_of_ten(g[24], -13, -2);
    s.method = kind(g[25], 4);
    for (int i = 0; i < 4; ++i)
        s.q[i] = either(g[26 + i], -17, 0);
    return s;
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
