/* SPDX-License-Identifier: MIT */
/* Many short, loose calls beside the true motion: what a call returns has to
 * mean to the next what its status says. */
#include "growth.hpp"
#include "path.hpp"
#include "row.hpp"
#include "slides.hpp"

#include <algorithm>
#include <cstring>

namespace
{
/* The steps between which the truth looks at the cone of friction, in radians
 * of the fastest rate. */
constexpr double LOOK = 0.1;

struct calls {
    coin_params p;
    coin_table f;
    coin_losses l;
    coin_body at;
    int count;
    double dt, tol;

    calls(const scene &s, bool lossy)
        : p(params_of<doubles>(s)), f(), l(), at(), count(int(s.steps)),
          dt(s.t), tol(s.tol)
    {
        scene of = s;
        of.steps = lossy ? s.q[3] : 0;
        std::fill(of.q, of.q + 4, s.q[2]);
        l = losses_of(of);
        at.s = state_of<doubles>(s);
        f.mu_static = s.q[1];
        f.mu_kinetic = s.q[0];
        f.losses = l;
    }
    coin_state *state()
    {
        return &at.s;
    }
};

using mover = int32_t (*)(calls *, double t);

int32_t by_advance(calls *c, double t)
{
    return coin_advance(c->state(), &c->p, t, c->tol, nullptr);
}

int32_t by_settle(calls *c, double t)
{
    return coin_settle(c->state(), &c->p, &c->l, t, c->tol, nullptr);
}

int32_t by_move(calls *c, double t)
{
    return coin_move(&c->at, &c->p, &c->f, t, c->tol, COIN_LIFTS, nullptr);
}

/* The slip of a body that rolls, in parts of what rounding may leave; broken if
 * it is not on the table, or a call with t = 0 changes it. */
double slip_left(const calls &c)
{
    calls again = c;
    if (by_move(&again, 0) != COIN_OK ||
        std::memcmp(&again.at, &c.at, sizeof c.at) || !is_on_table(c.at, c.p))
        return BROKEN;
    double u[2];
    if (coin_body_slip(&c.at, &c.p, u) != COIN_OK)
        return BROKEN;
    const double size =
        std::fabs(c.at.vx) + std::fabs(c.at.vz) +
        c.p.radius * (std::fabs(c.at.s.wX) + std::fabs(c.at.s.wZ));
    return std::hypot(u[0], u[1]) / (8 * doubles::u * size + doubles::normal);
}

/* The true motion, and how near it comes to the edge of the cone. */
template <class R> class rolled
{
  public:
    path<R> at, tightest; /* tightest: where least is left of the cone */
    R left, least_c;      /* least_c: where calls begin and end */

    rolled(const calls &c, const losses<R> *slow)
        : at(c.p, c.at.s), tightest(at), mu(R(c.f.mu_static))
    {
        const R m = R(c.p.mass) * c.p.radius * c.p.radius;
        IX = c.p.inertia_X / m;
        IZ = c.p.inertia_Z / m;
        at.slow = tightest.slow = slow;
        left = left_at(at);
        least_c = at.cos_theta();
    }

    /* One call; false if that takes too long. */
    bool follow(R t, bool looks)
    {
        R gone = 0;
        for (; looks && gone < t; ++looked) {
            const R step = lesser(t - gone, R(LOOK) / (at.fastest() * at.w));
            if (looked > MOST_LOOKS || !at.follow(step))
                return false;
            gone = step < t - gone ? gone + step : t;
            const R now = left_at(at);
            if (now < left) {
                left = now;
                tightest = at;
            }
        }
        if (!looks && !at.follow(t))
            return false;
        least_c = lesser(least_c, at.cos_theta());
        return true;
    }

    /* How much errors of the lean and of the rates change what is left. */
    R moves() const
    {
        R sum = 1;
        for (int which = 0; which < 4; ++which) {
            path<R> other = tightest;
            other.nudge(which, R(1e-7));
            sum += magnitude(left_at(other) - left) / R(1e-7);
        }
        return sum;
    }

  private:
    static constexpr int MOST_LOOKS = 2000;
    R IX, IZ, mu;
    int looked = 0;

    /* mu N - F over Mg, and over mu where that is above 1. */
    R left_at(const path<R> &y) const
    {
        const R s = sine(y.lean()), c = y.cos_theta();
        held<R> f(IX, IZ, s, c, &y.at()[5]);
        if (y.slow) {
            const slowing<R> by = y.slow->at(IX, IZ, 1 + IX, 1 + IZ, s, c,
                                             y.at()[5], y.at()[6], y.at()[7]);
            f.N -= by.wX.value * s; /* (70) */
            f.X -= by.wZ.value;     /* (70) */
            f.h += by.wX.value * c; /* (70) */
        }
        if (mu > R(DBL_MAX))
            return f.N;
        return mu > 1 ? f.N - f.friction() / mu : mu * f.N - f.friction();
    }
};

/* By a mover that keeps the coin rolling, and by coin_move() where friction
 * does. */
template <class R, mover move, bool lossy, bool may_slip>
double rolls(const scene &s, double enough)
{
    const calls start(s, lossy);
    const R t = R(start.count) * start.dt;
    path<R> first(start.p, start.at.s);
    if (first.is_long(t))
        return NO_CLAIM;
    const double soft = softening(start.l, start.p);
    const losses<R> slow(start.l, soft, start.p.mass, start.p.radius,
                         1 / first.w);
    const losses<long double> by(start.l, soft, start.p.mass, start.p.radius,
                                 1 / (long double)first.w);
    rolled<R> truth(start, lossy ? &slow : nullptr);
    calls c = start;
    if (may_slip &&
        coin_body_from_state(&c.at, &start.at.s, &start.p) != COIN_OK)
        return NO_CLAIM;
    for (int i = 0; i < c.count; ++i)
        if (!truth.follow(R(c.dt), may_slip) ||
            (may_slip && !(truth.left > R(1e-3))))
            return NO_CLAIM;
    const R natural = t * first.w;
    const R turned = natural * root(2 * first.energy());
    const R rounding =
        R(doubles::u) * (90 * (1 + natural) + 16 * truth.at.largest_of_pose() +
                         8 * c.count / truth.least_c);
    const R bound = 2 * R(s.tol) * (1 + turned) + rounding;
    const auto grown = [&](double most) {
        return growth(start.p, start.at.s, double(t) / 16, 16, most,
                      lossy ? &by : nullptr);
    };
    if (bound >= 1)
        return NO_CLAIM;
    double worst = 0;
    for (int i = 0; i < c.count; ++i) {
        const int32_t status = move(&c, c.dt);
        if (may_slip && (status == COIN_SLIPS || status == COIN_LIFTS)) {
            const double near = double(truth.left / truth.moves() / bound);
            return near > 1 && grown(near) < near ? BROKEN : NO_CLAIM;
        }
        if (status != COIN_OK)
            return NO_CLAIM;
        worst = may_slip ? larger(worst, slip_left(c)) : worst;
    }
    R off[8], far = 0;
    truth.at.apart(c.at.s, truth.at.fastest(), off);
    for (int i = 0; i < 5; ++i)
        far = larger(far, magnitude(off[i]));
    const double ratio = far <= R(1e30) ? double(far / bound) : BROKEN;
    return larger(worst, unamplified(ratio, enough, grown));
}

/* Up to 64 calls of what is 1/1000 to 1/30 s to a quarter; mu_static from
 * mu_kinetic to infinity; half with losses, damping where
 * mu_static is infinite. */
void short_calls(scene *s, const double *g)
{
    s->t = std::sqrt(s->a / s->g) * std::pow(10, 1.6 * g[22] - 1.6);
    s->steps = 1 + std::floor(64 * g[23]);
    s->tol = std::pow(10, 7 * g[24] - 9);
    s->q[0] = 0.9 * g[26];
    s->q[1] = g[27] > 0.8 ? double(INFINITY) : s->q[0] / (1 - g[27]);
    s->q[2] = std::pow(10, 5 * g[28] - 6.5);
    const int which = int(512 * g[29] - 256); /* angular, damping too */
    s->q[3] = which < 0 ? 0 : which % 128 / 2 * 2 + which / 128 * 256;
    if (which > 0 && s->q[1] > DBL_MAX)
        s->q[3] += which % 2;
    s->phi = 6 * g[18] - 3;
    s->psi = 6 * g[19] - 3;
    s->x = s->a * (6 * g[20] - 3);
    s->z = s->a * (6 * g[21] - 3);
}

template <mover move, bool lossy, bool may_slip>
row row_of(const char *name, const char *law)
{
    return {name,
            law,
            25,
            false,
            short_calls,
            rolls<long double, move, lossy, may_slip>,
            rolls<quad, move, lossy, may_slip>};
}
} // namespace

void add_calls(std::vector<row> *rows)
{
    rows->push_back(row_of<by_advance, false, false>(
        "coin_advance_calls", "2 tol a radius of speed + rounding"));
    rows->push_back(row_of<by_settle, true, false>(
        "coin_settle_calls", "2 tol a radius of speed + rounding"));
    rows->push_back(row_of<by_move, true, true>(
        "coin_move_calls",
        "2 tol a radius of speed + rounding; rolls where the truth does"));
}
