/* SPDX-License-Identifier: MIT */
/* What the search climbs: a table of laws.  A row says what is called and what
 * its bound is; its law calls it, and holds what comes out against the truth.
 */
#ifndef ROLLCOIN_ADVERSARY_LAW_HPP
#define ROLLCOIN_ADVERSARY_LAW_HPP

#include "scene.hpp"
#include "truth.hpp"

#include <coinf.h>

#include <cfloat>
#include <cstring>
#include <functional>
#include <limits>

/* No claim: the call was refused or warned, or the law does not reach. */
constexpr double NO_CLAIM = -1;
constexpr double BROKEN = std::numeric_limits<double>::infinity();

/* A type of numbers: half the distance of 1 to the next, the least number, and
 * the least that is normal. */
template <class N> struct numbers {
    using number = N;
    using limits = std::numeric_limits<N>;
    static constexpr bool is_single = std::is_same_v<N, float>;
    static constexpr real u = limits::epsilon() / 2;
    static constexpr real least = limits::denorm_min(), normal = limits::min();
};

/* What coin.h and coinf.h name alike, so that one text judges both. */
#define TWINS(PREFIX)                                                          \
    using params = PREFIX##_params;                                            \
    using state = PREFIX##_state;                                              \
    using force = PREFIX##_force;                                              \
    static constexpr auto disc = PREFIX##_params_disc;                         \
    static constexpr auto ring = PREFIX##_params_ring;                         \
    static constexpr auto from_motion = PREFIX##_state_from_motion;            \
    static constexpr auto step = PREFIX##_step;                                \
    static constexpr auto run = PREFIX##_run;                                  \
    static constexpr auto check = PREFIX##_check

struct doubles : numbers<double> {
    TWINS(coin);
};
struct floats : numbers<float> {
    TWINS(coinf);
};

/* A scene's arguments in the type of the function, the moment that they mean,
 * and the largest error of several outputs in parts of their bounds. */
template <class T> struct trial : T {
    using number = typename T::number;

    const scene &s;
    double enough; /* not more need be known of the answer: what is dear to
                      compute may be left out where it is below that */
    typename T::params p;
    typename T::state y;
    coin_body b;
    coin_losses losses;
    coin_table table;
    moment at;
    typename T::state made = {}; /* by the function */
    typename T::force force = {};
    double worst = 0;

    trial(const scene &of, double known)
        : s(of), enough(known), p(params_of<typename T::params>(of)),
          y(state_of<typename T::state>(of)), b(body_of(of)),
          losses(losses_of(of)), table(table_of(of)), at(p, y)
    {
    }

    /* Whether every product in a term is a normal number, as the laws ask. */
    bool is_normal() const
    {
        real slowest = 1, part = 1;
        for (real w : {at.wX, at.wY, at.wZ})
            slowest = w == 0 ? slowest : std::min(slowest, std::fabs(w));
        for (real f : {at.s, at.sph, at.cph, at.k1, at.k2, at.IX / at.J})
            part *= f == 0 ? real(1) : std::min(real(1), std::fabs(f));
        return slowest * slowest * part >= T::normal;
    }

    void hold(real output, real truth, real allowed)
    {
        const real off = std::fabs(output - truth);
        is(off == 0 ? 0 : double(off / allowed));
    }
    /* Within so many u of its terms; below the normal numbers within as many of
     * the smallest. */
    void within(real output, const terms &truth, int ulps)
    {
        hold(output, truth.value, ulps * (T::u * truth.size + T::least));
    }
    /* The answer of a law that is one ratio. */
    bool is(double ratio)
    {
        worst = ratio > worst ? ratio : ratio == ratio ? worst : BROKEN;
        return ratio != NO_CLAIM;
    }

    /* A body moves on the scene's table. */
    int32_t move(coin_body *body, double t, int32_t stop = COIN_LIFTS,
                 double *reached = nullptr) const
    {
        return coin_move(body, &p, &table, t, s.tol, stop, reached);
    }
    bool roll()
    {
        return coin_body_from_state(&b, &y, &p) == COIN_OK;
    }
    /* Whether a call with t = 0 says the same of a body again, and changes
     * nothing. */
    bool says(int32_t status, const coin_body &of) const
    {
        coin_body again = of;
        return move(&again, 0) == status &&
               !std::memcmp(&again, &of, sizeof of);
    }
};

using judge = std::function<double(const scene &s, double enough)>;
using edge = std::function<void(scene *s, const double *genes)>;

struct row {
    std::string function;
    std::string bound; /* the documented bound, in words */
    int share;         /* one evaluation in so many, in a short search: what
                          one costs */
    edge draw;         /* leads to the row's own edge; may be null */
    judge law;
    int genes = GENES;   /* that it has, the first of all */
    bool narrow = false; /* scenes within the range of floats */
};

/* A law is false where it claims nothing. */
template <class T = doubles, class L> judge judged(L law)
{
    return [law](const scene &s, double enough) {
        trial<T> q(s, enough);
        return law(q) ? q.worst : NO_CLAIM;
    };
}

extern const std::vector<row> FORMULAS, MOTIONS, EVENTS, THROWS, THICK;

#endif
