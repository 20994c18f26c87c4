/* SPDX-License-Identifier: MIT */
/* What the search climbs: a row for each public function. */
#ifndef ROLLCOIN_ADVERSARY_ROW_HPP
#define ROLLCOIN_ADVERSARY_ROW_HPP

#include "number.hpp"
#include "scene.hpp"

#include <vector>

/* No claim: the call was refused or warned, or the law does not reach. */
constexpr double NO_CLAIM = -1;
constexpr double BROKEN = std::numeric_limits<double>::infinity();

/* Below this the motion's amplification, which is dear, is not taken out. */
constexpr double UNAMPLIFIED = 0.3;

/* Error over documented bound.  Not more than enough need be known: what is
 * dear to compute may be left out where the answer is below it already. */
using judge = double (*)(const scene &s, double enough);

struct row {
    const char *function;
    const char *law; /* the documented bound, in words */
    int share;       /* one evaluation in so many, in a search of a minute: what
                        one costs */
    bool narrow;     /* scenes within the range of floats */
    void (*edge)(scene *, const double *genes); /* leads to the row's own edge;
                                                   may be null */
    judge quick, exact; /* the truth in 64 and in 113 bits */
};

void add_observables(std::vector<row> *rows);
void add_steady(std::vector<row> *rows);
void add_steps(std::vector<row> *rows);
void add_motions(std::vector<row> *rows);
void add_losses(std::vector<row> *rows);
void add_slides(std::vector<row> *rows);
void add_slide_events(std::vector<row> *rows);
void add_calls(std::vector<row> *rows);
void add_thrown(std::vector<row> *rows);

/* Keeps the worst of several outputs. */
template <class R> struct verdict {
    double worst = 0;

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

    void equal(bool same)
    {
        worst = same ? worst : BROKEN;
    }
};

#endif
