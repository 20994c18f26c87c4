/* SPDX-License-Identifier: MIT */
/* Judges the truth by which silent.c judges: the same starts, by Boost.odeint's
 * Fehlberg 7(8) in 113 bits on the textbook's equations, so that neither
 * formula nor code nor precision is the library's.
 *     silent truth SEED RUNS | truth
 * Prints, by family, how large the truth's error is in parts of what silent.c
 * allows for it, and fails if that is exceeded. */
#include <array>
#include <boost/multiprecision/float128.hpp>
#include <boost/numeric/odeint/algebra/detail/extract_value_type.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

using real = boost::multiprecision::float128;

/* odeint would look for the value type of a number in the number. */
namespace boost::numeric::odeint::detail
{
template <> struct extract_value_type<real, void> {
    using type = real;
};
}

#include <boost/numeric/odeint.hpp>

namespace odeint = boost::numeric::odeint;

using vector = std::array<real, 8>; /* theta phi psi x z wX wY wZ */

/* A run in its own units. */
struct row {
    double M, a, g, IX, IZ, t;
    double start[8], end[8], amplified, rounding;
    std::string family;
};

static bool read(row &r)
{
    static char line[2048];
    char *at = line;
    if (!std::fgets(line, sizeof line, stdin))
        return false;
    for (double *v : {&r.M, &r.a, &r.g, &r.IX, &r.IZ, &r.t})
        *v = std::strtod(at, &at), ++at;
    for (double &v : r.start)
        v = std::strtod(at, &at), ++at;
    for (double &v : r.end)
        v = std::strtod(at, &at), ++at;
    char *comma = at;
    while (*comma != ',')
        ++comma;
    r.family.assign(at, comma);
    r.amplified = std::strtod(comma + 1, &at);
    r.rounding = std::strtod(at + 1, &at);
    return true;
}

/* The textbook's equations; lengths in radii. */
struct rates {
    real m, IX, IZ, Mga;

    explicit rates(const row &r)
        : m(real(r.M) * r.a * r.a), IX(r.IX), IZ(r.IZ),
          Mga(real(r.M) * r.g * r.a)
    {
    }

    void operator()(const vector &y, vector &d, real) const
    {
        const real wX = y[5], wY = y[6], wZ = y[7];
        const real s = sin(y[0]), c = cos(y[0]), t = s / c;
        const real sph = sin(y[1]), cph = cos(y[1]);
        d = {wX,
             wY / c,
             wZ + wY * t,
             -wZ * cph + wX * c * sph,
             wZ * sph + wX * c * cph,
             (-(IZ + m) * wY * wZ - IX * wY * wY * t + Mga * s) / (IX + m),
             wX * wY * t + IZ / IX * wZ * wX,
             m / (IZ + m) * wX * wY};
    }
};

/* W of Eq. (47). */
static real rate(const vector &y, const row &r)
{
    const real c = cos(y[0]);
    return sqrt((y[5] * y[5] + y[6] * y[6]) / (c * c) + y[7] * y[7] +
                real(r.g) / r.a);
}

/* The largest error of the end, as silent.c measures it. */
static double error(const row &r)
{
    vector y;
    for (int i = 0; i < 8; ++i)
        y[i] = i == 3 || i == 4 ? real(r.start[i]) / r.a : real(r.start[i]);
    auto stepper = odeint::make_controlled(
        real(1e-19), real(1e-19),
        odeint::runge_kutta_fehlberg78<vector, real>());
    const rates f(r);
    const real first = real(r.t < 0 ? -0.001 : 0.001) / rate(y, r);
    odeint::integrate_adaptive(
        stepper, f, y, real(0), real(r.t),
        abs(first) < abs(real(r.t)) ? first : real(r.t));
    real worst = 0;
    const real W = rate(y, r);
    for (int i = 0; i < 8; ++i) {
        const real end = i == 3 || i == 4 ? real(r.end[i]) / r.a : r.end[i];
        const real off = abs(y[i] - end) / (i < 5 ? real(1) : W);
        worst = off > worst ? off : worst;
    }
    return double(worst);
}

int main()
{
    struct tally {
        unsigned runs = 0, beyond = 0;
        double worst = 0, error = 0;
    };
    std::map<std::string, tally> tallies;
    bool good = true;
    char head[2048];
    if (!std::fgets(head, sizeof head, stdin))
        return 1;
    for (row r; read(r);) {
        tally &t = tallies[r.family];
        const double e = error(r), share = e / (r.amplified * r.rounding);
        ++t.runs;
        t.beyond += !(share <= 1);
        t.worst = std::fmax(t.worst, share);
        t.error = std::fmax(t.error, e / r.amplified);
        good = good && share <= 1;
    }
    std::puts("family,runs,beyond,worst_share,worst_error_before_amplification");
    for (const auto &[family, t] : tallies)
        std::printf("%s,%u,%u,%.2g,%.2g\n", family.c_str(), t.runs, t.beyond,
                    t.worst, t.error);
    return good && !tallies.empty() ? 0 : 1;
}
