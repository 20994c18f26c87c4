/* SPDX-License-Identifier: MIT */
/* What the search climbs: a table of laws.  A row says what is called and what
 * its bound is; its law calls it, and holds what comes out against the truth.
 */
#ifndef ROLLCOIN_ADVERSARY_ROW_HPP
#define ROLLCOIN_ADVERSARY_ROW_HPP

#include "scene.hpp"
#include "truth.hpp"

#include <initializer_list>
#include <vector>

/* No claim: the call was refused or warned, or the law does not reach. */
constexpr double NO_CLAIM = -1;
constexpr double BROKEN = std::numeric_limits<double>::infinity();

/* A scene's arguments in the type of the function, the moment that they mean,
 * and the largest error of several outputs in parts of their bounds. */
template <class T, class R> struct trial {
    const scene &s;
    int kind;      /* of the row */
    double enough; /* not more need be known of the answer: what is dear to
                      compute may be left out where it is below that */
    typename T::params p;
    typename T::state y;
    moment<R> at;
    R u = R(T::u), least = R(T::least), normal = R(T::normal);
    double worst = 0;

    trial(const scene &of, int which, double known)
        : s(of), kind(which), enough(known), p(params_of<T>(of)),
          y(state_of<T>(of)), at(p, y)
    {
    }

    /* The arguments where the function has made the state. */
    template <class S> trial &made(const S &state)
    {
        at = moment<R>(p, state);
        return *this;
    }

    /* Whether every product in a term is a normal number, as the laws ask. */
    bool is_normal() const
    {
        const R w[] = {at.wX, at.wY, at.wZ};
        const R few[] = {at.s, at.sph, at.cph, at.k1, at.k2, at.IX / at.J};
        R product = 1, part = 1;
        for (R x : w)
            for (R other : {R(1), w[0], w[1], w[2]})
                product = x * other == 0
                              ? product
                              : lesser(product, magnitude(x * other));
        for (R x : few)
            part *= x == 0 ? R(1) : lesser(R(1), magnitude(x));
        return product * part >= normal;
    }
    bool reads(bool answered) const
    {
        return answered && is_normal();
    }

    void hold(R output, R truth, R allowed)
    {
        const R off = magnitude(output - truth);
        double ratio = off <= 0 ? 0 : double(off / allowed);
        if (!(magnitude(truth) < R(1e300) * R(1e300)))
            return; /* the truth itself is no number */
        if (!(ratio >= 0) || !(magnitude(output) <= R(DBL_MAX)))
            ratio = BROKEN;
        worst = ratio > worst ? ratio : worst;
    }
    /* Within so many u of its terms; below the normal numbers within as many of
     * the smallest. */
    void hold(typename T::real output, const terms<R> &truth, int ulps)
    {
        hold(R(output), truth.value, ulps * (u * truth.size + least));
    }
    /* So of several outputs of a call that was done. */
    bool holds(bool done, const typename T::real *outputs, int ulps,
               std::initializer_list<terms<R>> truths)
    {
        for (const terms<R> &truth : truths)
            hold(*outputs++, truth, ulps);
        return reads(done);
    }
    bool near(bool done, const typename T::real *outputs, int ulps,
              std::initializer_list<R> truths)
    {
        for (R truth : truths)
            hold(R(*outputs++), truth, ulps * u);
        return done;
    }
    /* Within so many u of it. */
    void near(typename T::real output, R truth, int ulps)
    {
        hold(R(output), truth, ulps * u * magnitude(truth));
    }
    void equal(bool same)
    {
        worst = same ? worst : BROKEN;
    }
    /* The answer of a law that is one ratio. */
    bool is(double ratio)
    {
        worst = ratio > worst ? ratio : ratio == ratio ? worst : BROKEN;
        return ratio != NO_CLAIM;
    }
};

using judge = double (*)(const scene &s, int kind, double enough);

struct row {
    const char *function;
    const char *bound; /* the documented bound, in words */
    int share;         /* one evaluation in so many, in a short search: what
                          one costs */
    bool narrow;       /* scenes within the range of floats */
    int kind;          /* what of the law; a method */
    void (*edge)(scene *, const double *genes, int kind); /* leads to the row's
                                                 own edge; may be null */
    judge quick, exact; /* the truth in 64 and in 113 bits */
};

/* A law is false where it claims nothing. */
template <class T, class R, bool (*law)(trial<T, R> &)>
double judged(const scene &s, int kind, double enough)
{
    trial<T, R> q(s, kind, enough);
    return law(q) ? q.worst : NO_CLAIM;
}

#define LAW(T, name, bound, share, edge, kind, law)                            \
    row                                                                        \
    {                                                                          \
        name, bound, share, (T::u > 1e-10), kind, edge,                        \
            judged<T, long double, law<T, long double>>,                       \
            judged<T, quad, law<T, quad>>                                      \
    }

/* A row of a function of coin.h. */
#define ROW(name, bound, share, edge, kind, law)                               \
    LAW(doubles, "coin_" name, bound, share, edge, kind, law)

std::vector<row> observables();
std::vector<row> exact_motions();
std::vector<row> steps();
std::vector<row> rolling_motions();
std::vector<row> slips();
std::vector<row> throws();

#endif
