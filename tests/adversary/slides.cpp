/* SPDX-License-Identifier: MIT */
/* Coins that slip: what is read off a body, and its way while it slips, by the
 * equations of Newton and Euler in time. */
#include "growth.hpp"
#include "row.hpp"
#include "slip_growth.hpp"

#include <cstring>

namespace
{
template <class R> double energy(const scene &s, double)
{
    const asked q(s);
    const moment<R> y(q.p, q.d.s);
    const double E = coin_body_energy(&q.d, &q.p);
    if (E != E)
        return NO_CLAIM;
    terms<R> want;
    want.add(y.M * q.d.vx * q.d.vx / 2).add(y.M * q.d.vz * q.d.vz / 2);
    want.add(y.M * q.d.vy * q.d.vy / 2).add(y.IX * y.wX * y.wX / 2);
    want.add(y.IX * y.wY * y.wY / 2).add(y.IZ * y.wZ * y.wZ / 2);
    want.add(y.M * y.g * q.d.y); /* (88) */
    verdict<R> v;
    v.hold(R(E), want.value,
           12 * R(doubles::u) * want.size + 16 * R(doubles::normal));
    return v.worst;
}

template <class R> double velocity(const scene &s, double)
{
    const asked q(s);
    const moment<R> y(q.p, q.d.s);
    double u[2];
    if (coin_body_slip(&q.d, &q.p, u) != COIN_OK)
        return NO_CLAIM;
    const slipping<R> of(y, q.d);
    const R allowed = 8 * R(doubles::u) * of.size() + 16 * R(doubles::normal);
    verdict<R> v;
    v.hold(R(u[0]), of.X.value * y.cph + of.h.value * y.sph, allowed);
    v.hold(R(u[1]), of.h.value * y.cph - of.X.value * y.sph, allowed);
    return v.worst;
}

template <class R> double from_state(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    const coin_state y = state_of<doubles>(s);
    coin_body d;
    if (coin_body_from_state(&d, &y, &p) != COIN_OK)
        return NO_CLAIM;
    terms<R> want[8];
    rates_of(moment<R>(p, y), want);
    verdict<R> v;
    for (int i = 3; i < 5; ++i)
        v.hold(R(i == 3 ? d.vx : d.vz), want[i].value,
               8 * R(doubles::u) * want[i].size + 16 * R(doubles::normal));
    return v.worst;
}

/* ------------------------------------------------------------ while it slips
 */
/* One call, or `count` of them, each of which has to say that it slips, and
 * nothing else when it is asked again. */
int32_t slipped(const asked &q, coin_body *b, const scene &s, int count)
{
    int32_t status = COIN_OK;
    for (int i = 0; i < count; ++i) {
        status = q.advance(b, s.t / count, s.q[3]);
        coin_body again = *b;
        if (status < 0)
            return status;
        if (q.advance(&again, 0, s.q[3]) != status ||
            std::memcmp(&again, b, sizeof again))
            return COIN_EARG;
        if ((status == COIN_OK || status == COIN_SLIPS) &&
            !is_on_table(*b, q.p))
            return COIN_EARG;
        if (status == COIN_RESTS || status == COIN_LIFTS)
            return status;
    }
    return status;
}

template <class R>
double slip(const asked &q, const scene &s, double enough, int count = 1)
{
    const double tol = s.q[3];
    coin_body end = q.d;
    slide<R> truth(q);
    const bool on_ice = !(q.f.mu_kinetic > 0);
    if (!(on_ice || truth.speed(truth.y) > R(1e-2)))
        return NO_CLAIM;
    /* The truth first: it gives up sooner than a call whose trials run out. */
    if (truth.follow(R(s.t)) != slide<R>::SLIPS)
        return NO_CLAIM;
    const int32_t status = slipped(q, &end, s, count);
    if (status == COIN_EARG && tol >= 1e-12 && tol <= 1e-2)
        return BROKEN;
    if (!(status == COIN_SLIPS || (on_ice && status == COIN_OK)))
        return NO_CLAIM;
    const R natural = R(s.t) * truth.w;
    /* A slip that begins counts as 0 below 2e-10, and so does what it changes
     * of the rates until then. */
    const R begun = R(on_ice ? 4e-10 : 0);
    const R bound =
        R(tol) * (1 + natural) + R(1e-14) * (1 + natural) + begun +
        64 * R(doubles::u) *
            (1 + magnitude(truth.y[3]) + magnitude(truth.y[4])) +
        R(count > 1 ? 8 * count * doubles::u : 0) / cosine(truth.y[0]);
    const double ratio = double(truth.apart(end) / bound);
    return unamplified(ratio, enough,
                       [&](double most) { return growth(q, s.t, most); });
}

template <class R> double advance(const scene &s, double enough)
{
    return slip<R>(asked(s), s, enough);
}

/* In up to 64 calls, of losses too. */
template <class R> double in_calls(const scene &s, double enough)
{
    return slip<R>(asked(s, int(s.steps) % 2 > 0), s, enough,
                   2 + int(s.method) % 63);
}

/* From where the coin rolls, without friction. */
template <class R> double on_ice(const scene &s, double enough)
{
    asked q(s);
    q.f = {};
    return coin_body_from_state(&q.d, &q.d.s, &q.p) == COIN_OK
               ? slip<R>(q, s, enough)
               : NO_CLAIM;
}

template <class R> double with_losses(const scene &s, double enough)
{
    return slip<R>(asked(s, true), s, enough);
}

/* Losses of 1e-8 to 0.01; half of the throws 1e-5 to 0.3 from flat, and slow.
 */
void thrown_with_losses(scene *s, const double *g)
{
    thrown(s, g);
    s->steps = std::floor(128 * g[23]);
    s->q[2] = std::pow(10, 6 * g[28] - 8);
    if (std::fabs(g[7] - 0.5) > 0.25)
        return;
    const double w = std::sqrt(s->g / s->a);
    const double angle = std::pow(10, 4.5 * g[8] - 5);
    s->theta = (g[7] < 0.5 ? 1 : -1) * (1.5707963267948966 - angle);
    s->wX = w * std::sqrt(angle) * (4 * g[11] - 2);
    s->wY = w * angle * (2 * g[12] - 1) * std::pow(10, 4 * g[15] - 2);
    s->wZ = w * (2 * g[13] - 1) * std::pow(10, 5 * g[16] - 5);
    s->t = std::sqrt(angle * s->a / s->g) * std::pow(10, 3 * g[22] - 2);
}

void thrown_in_calls(scene *s, const double *g)
{
    thrown_with_losses(s, g);
    s->method = std::floor(63 * g[9]);
    s->q[3] = std::pow(10, 7 * g[29] - 9);
}
} // namespace

void add_slides(std::vector<row> *rows)
{
    rows->push_back({"coin_body_energy", "12 u of the terms", 1, false, nullptr,
                     energy<long double>, energy<quad>});
    rows->push_back({"coin_body_slip", "8 u of the terms", 1, false, nullptr,
                     velocity<long double>, velocity<quad>});
    rows->push_back({"coin_body_from_state", "8 u of the terms", 1, false,
                     nullptr, from_state<long double>, from_state<quad>});
    rows->push_back({"coin_move_slips",
                     "tol (1 + natural time) before amplification; slipping",
                     25, false, thrown, advance<long double>, advance<quad>});
    rows->push_back({"coin_move_ice",
                     "tol (1 + natural time) before amplification; slipping",
                     25, false, thrown, on_ice<long double>, on_ice<quad>});
    rows->push_back({"coin_move_slip_calls",
                     "tol (1 + natural time) before amplification; slipping",
                     25, false, thrown_in_calls, in_calls<long double>,
                     in_calls<quad>});
    rows->push_back({"coin_move_losses",
                     "tol (1 + natural time) before amplification; slipping",
                     25, false, thrown_with_losses, with_losses<long double>,
                     with_losses<quad>});
}
