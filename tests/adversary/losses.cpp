/* SPDX-License-Identifier: MIT */
/* Coins with losses: what is read off a state, and the way to rest. */
#include "losses.hpp"

#include "growth.hpp"
#include "path.hpp"
#include "row.hpp"
#include "truth.hpp"

namespace
{
/* --------------------------------------------------------- read off a state */
template <class R> struct asked {
    coin_params p;
    coin_state y;
    coin_losses l;
    moment<R> at;
    R u = R(doubles::u), least = 16 * R(doubles::normal);
    verdict<R> v;

    explicit asked(const scene &s)
        : p(params_of<doubles>(s)), y(state_of<doubles>(s)), l(losses_of(s)),
          at(p, y)
    {
    }

    slowing<R> slowed() const
    {
        const losses<R> of(l, softening(l, p), 1, 1, 1);
        return of.at(at.IX, at.IZ, at.J, at.K, at.s, at.c, at.wX, at.wY, at.wZ);
    }

    void hold(double output, const terms<R> &truth, int units = 16)
    {
        v.hold(R(output), truth.value, units * (u * truth.size + least));
    }
};

template <class R> double power(const scene &s, double)
{
    asked<R> q(s);
    const double P = coin_losses_power(&q.y, &q.p, &q.l);
    if (P != P)
        return NO_CLAIM;
    q.hold(P, q.slowed().power, 24);
    return q.v.worst;
}

template <class R> double rates(const scene &s, double)
{
    asked<R> q(s);
    coin_state d;
    if (coin_losses_rates(&q.y, &q.p, &q.l, &d) != COIN_OK)
        return NO_CLAIM;
    const slowing<R> by = q.slowed();
    terms<R> want[8];
    rates_of(q.at, want);
    q.hold(d.wX, want[5].add(by.wX, R(1)));
    q.hold(d.wY, want[6].add(by.wY, R(1)));
    q.hold(d.wZ, want[7].add(by.wZ, R(1)));
    return q.v.worst;
}

template <class R> double reaction(const scene &s, double)
{
    asked<R> q(s);
    coin_force f;
    if (coin_losses_reaction(&q.y, &q.p, &q.l, &f) != COIN_OK)
        return NO_CLAIM;
    const slowing<R> by = q.slowed();
    const moment<R> &y = q.at;
    const R Ma = y.M * y.a;
    table_force<R> F = force_of(y);
    /* M a (-dwZ e_X + dwX e_Z) */
    F.Rx.add(by.wZ, -Ma * y.cph).add(by.wX, Ma * y.c * y.sph);
    F.normal.add(by.wX, -Ma * y.s);
    F.Rz.add(by.wZ, Ma * y.sph).add(by.wX, Ma * y.c * y.cph);
    q.hold(f.R[0], F.Rx);
    q.hold(f.normal, F.normal);
    q.hold(f.R[2], F.Rz);
    return q.v.worst;
}

/* Any state, and losses from 1e-8 to 0.1; soft, where it is not the usual, from
 * 1e-9 to 1. */
void some_losses(scene *s, const double *g)
{
    s->steps = std::floor(512 * g[23]);
    for (int i = 0; i < 4; ++i)
        s->q[i] = std::pow(10, 7 * g[26 + i] - 8);
    s->tol = std::pow(10, 9 * g[24] - 9);
}

/* -------------------------------------------------------------- the way to
 * rest */
/* What a mover may err by. */
template <class R> R allowed(const path<R> &start, R t, R tol)
{
    const R natural = t * start.w;
    const R turned = natural * root(2 * start.energy());
    return 2 * tol * (1 + turned) + 90 * R(doubles::u) * (1 + natural) +
           16 * R(doubles::u) * start.largest_of_pose();
}

double without_growth(double ratio, double enough, double t,
                      const coin_params &p, const coin_state &start,
                      const coin_losses &l)
{
    const long double w = root((long double)p.gravity / p.radius);
    const losses<long double> by(l, softening(l, p), p.mass, p.radius, 1 / w);
    return unamplified(ratio, enough, [&](double most) {
        return growth(p, start, t / 16, 16, most, &by);
    });
}

/* Followed by the textbook's equations and torques for up to 80 rad. */
template <class R> double settle(const scene &s, double enough)
{
    const coin_params p = params_of<doubles>(s);
    const coin_losses l = losses_of(s);
    const coin_state start = state_of<doubles>(s);
    coin_state end = start;
    path<R> truth(p, start);
    if (truth.is_long(R(s.t)) ||
        coin_settle(&end, &p, &l, s.t, s.tol, nullptr) != COIN_OK)
        return NO_CLAIM;
    const losses<R> slow(l, softening(l, p), p.mass, p.radius, 1 / truth.w);
    const R bound = allowed(truth, R(s.t), 10 * R(s.tol));
    truth.slow = &slow;
    if (!truth.follow(R(s.t)) || bound >= 1)
        return NO_CLAIM;
    R off[8], worst = 0;
    truth.apart(end, truth.fastest(), off);
    for (int i = 0; i < 5; ++i)
        worst = larger(worst, magnitude(off[i]));
    const double ratio = worst <= R(1e30) ? double(worst / bound) : BROKEN;
    return without_growth(ratio, enough, s.t, p, start, l);
}

/* Follows a path for a time, or until cos theta comes below `flat`; how long.
 * *least: the smallest cos theta of a swing before; negative if that takes too
 * long. */
template <class R> R until_flat(path<R> *at, R t, R flat, R *least)
{
    R gone = 0, before = 1, last = 1;
    *least = 1;
    for (int i = 0; gone < t; ++i) {
        const path<R> from = *at;
        R h = lesser(t - gone, R(0.1) / (at->fastest() * at->w)), low = 0;
        if (i > 4000)
            return -1;
        if (at->follow(h) && !(at->cos_theta() < flat)) {
            const R now = at->cos_theta();
            if (last <= before && last <= now)
                *least = lesser(*least, last);
            before = last;
            last = now;
            gone += h;
            continue;
        }
        for (int k = 0; k < 50; ++k) {
            const R middle = (low + h) / 2;
            *at = from;
            const bool above = at->follow(middle) && !(at->cos_theta() < flat);
            (above ? low : h) = middle;
        }
        *at = from;
        return at->follow(low) ? gone + low : R(-1);
    }
    return gone;
}

/* What a time of rest errs by, in radians of the fall, where a coin falls
 * steeply through `flat`; no claim where an earlier swing nearly ended there.
 */
template <class R>
double rest_error(const coin_params &p, const coin_state &start,
                  const coin_losses &l, double when, R tol, double enough)
{
    path<R> truth(p, start);
    const losses<R> slow(l, softening(l, p), p.mass, p.radius, 1 / truth.w);
    const R flat = l.flat > 0 ? l.flat : 1e-6;
    const R bound = allowed(truth, R(when), tol);
    R least;
    truth.slow = &slow;
    if (!(when > 0) || truth.is_long(R(when)) || truth.cos_theta() < 2 * flat)
        return NO_CLAIM;
    const R took = until_flat(&truth, R(1.05) * R(when), flat, &least);
    const R fall = magnitude(truth.at()[5]);
    if (took < 0 || !(bound < R(1e-3) * flat) || least < 2 * flat)
        return NO_CLAIM;
    if (!(took < R(1.05) * R(when)))
        return BROKEN;
    const R off = magnitude(took - R(when)) * truth.w;
    return without_growth(double(off * fall / bound), enough, 0.999 * when, p,
                          start, l);
}

template <class R> double time_to_rest(const scene &s, double enough)
{
    const coin_params p = params_of<doubles>(s);
    const coin_losses l = losses_of(s);
    const coin_state start = state_of<doubles>(s);
    if (path<R>(p, start).is_long(R(s.t)))
        return NO_CLAIM;
    const double when = coin_time_to_rest(&start, &p, &l);
    if (!(when < 1e300))
        return NO_CLAIM;
    return rest_error<R>(p, start, l, when, R(1e-6), enough);
}

/* Forward, 0.01 to 30 natural units; losses up to 0.03.  Half roll slowly at
 * first, so that the contact soon turns round.  A fifth hardly spin. */
void launches(scene *s, const double *g)
{
    if (g[25] < 0.5)
        s->wZ = 0.2 * s->wZ - s->wY * std::tan(s->theta);
    if (g[25] > 0.8) {
        const double part = std::pow(10, -50 * (g[25] - 0.8));
        s->wY *= part;
        s->wZ *= part;
    }
    const int which = int(1024 * g[23]); /* with flat, also angular */
    s->steps = which % 128 + which / 128 % 4 * 256;
    s->method = std::pow(10, 2 * g[6] - 4);
    for (int i = 0; i < 4; ++i)
        s->q[i] = std::pow(10, 5 * g[26 + i] - 6.5);
    s->tol = std::pow(10, 9 * g[24] - 12);
    s->t = std::sqrt(s->a / s->g) * std::pow(10, 3.5 * g[22] - 2);
    s->phi = 6 * g[18] - 3;
    s->psi = 6 * g[19] - 3;
    s->x = s->a * (6 * g[20] - 3);
    s->z = s->a * (6 * g[21] - 3);
}

/* As many, that lie flat from 1e-4 to 1e-2 rad on, and often fall; with losses
 * from 1e-4 on, so that most rest soon. */
void falls(scene *s, const double *g)
{
    launches(s, g);
    s->steps = int(s->steps) % 512 + 512;
    s->method = std::pow(10, 2 * g[6] - 4);
    for (int i = 0; i < 4; ++i)
        s->q[i] = std::pow(10, 3 * g[26 + i] - 4);
    if (g[14] < 0.5) {
        s->wY *= 0.01 * g[17];
        s->wZ *= 0.01 * g[17];
    }
}
} // namespace

#define LOSSES(function, name, law, divisor, edge)                             \
    {                                                                          \
        name, law, divisor, false, edge, function<long double>, function<quad> \
    }

void add_losses(std::vector<row> *rows)
{
    const row made[] = {
        LOSSES(power, "coin_losses_power", "24 u of the terms", 1, some_losses),
        LOSSES(rates, "coin_losses_rates", "16 u of the terms", 1, some_losses),
        LOSSES(reaction, "coin_losses_reaction", "16 u of the terms", 1,
               some_losses),
        LOSSES(settle, "coin_settle", "20 tol a radius of speed + rounding", 25,
               launches),
        LOSSES(time_to_rest, "coin_time_to_rest",
               "2 tol a radius of speed, of the fall; tol = 1e-6", 1000, falls),
    };
    for (const row &r : made)
        rows->push_back(r);
}
