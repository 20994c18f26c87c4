/* SPDX-License-Identifier: MIT */
/* Bodies and tables of a scene. */
#ifndef ROLLCOIN_ADVERSARY_BODY_HPP
#define ROLLCOIN_ADVERSARY_BODY_HPP

#include "losses.hpp"

#include <cstring>

/* A body and what moves it. */
struct given {
    coin_params p;
    coin_body b;
    coin_table table;
    double tol;

    explicit given(const scene &s, double accuracy)
        : p(params_of<doubles>(s)), b(), table(), tol(accuracy)
    {
        b.s = state_of<doubles>(s);
    }
    int32_t move(coin_body *at, double t, int32_t stop = COIN_LIFTS,
                 double *reached = nullptr) const
    {
        return coin_move(at, &p, &table, t, tol, stop, reached);
    }
    bool roll()
    {
        return coin_body_from_state(&b, &b.s, &p) == COIN_OK;
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

/* The height and the normal velocity of a body that touches the table. */
inline void set_on_table(coin_body *b, const coin_params &p)
{
    b->y = p.radius * std::cos(b->s.theta);
    b->vy = -p.radius * std::sin(b->s.theta) * b->s.wX;
}

/* Whether that is so of a returned body, to the rounding of two cosines; and of
 * two sines and four products. */
inline bool is_on_table(const coin_body &b, const coin_params &p)
{
    coin_body on = b;
    set_on_table(&on, p);
    return std::fabs(on.y - b.y) <= 0x1p-52 * p.radius &&
           std::fabs(on.vy - b.vy) <= 0x1p-50 * std::fabs(on.vy);
}

#endif
