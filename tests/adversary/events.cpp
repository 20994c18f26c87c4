/* SPDX-License-Identifier: MIT */
/* When a slip begins and ends, when a coin lifts off, and the force of the
 * table on a coin that may slip. */
#include "growth.hpp"
#include "row.hpp"
#include "slip_growth.hpp"

namespace
{
/* A time in natural units is wrong by so much if the state is by `error`, and
 * what is 0 then moves by `moves` times an error and at `slope`. */
template <class R> R blurred(R error, R moves, R slope)
{
    return error * moves / magnitude(slope);
}

/* What coin_move() may err by until a natural time. */
template <class R> R allowed(R tol, R natural)
{
    return (tol + R(1e-14)) * (1 + natural) + 64 * R(doubles::u);
}

/* Times that are determined worse than this are no claim. */
constexpr double BLURRED = 1e-3;

/* The slip speed below which a coin rolls.  The truth takes what remains of a
 * slip from there on as a straight line. */
constexpr double ROLLS = 1e-10;

/* How far from a true time the status changes from one to another, in parts of
 * `bound`: halved from the first of `enough` parts, twice as many and so on
 * before and behind which it is known; REACH where that is beyond.  Half of
 * enough, where it is less than enough.  A coin that begins to slip may lift
 * off at once.  No claim if a call says COIN_ESTEP: its trials were not enough,
 * and it tells neither. */
constexpr double REACH = 32;

double distance(const asked &q, double tol, double when, double bound,
                int32_t before, int32_t after, double enough)
{
    bool tells = true;
    const auto status = [&](double t) {
        coin_body d = q.d;
        const int32_t is = q.advance(&d, larger(t, 0.0), tol);
        tells = tells && is != COIN_ESTEP;
        return before == COIN_OK && is == COIN_LIFTS ? after : is;
    };
    double far = enough > 0 ? enough : 1 / REACH;
    while (status(when - far * bound) != before ||
           status(when + far * bound) != after)
        if (!tells)
            return NO_CLAIM;
        else if ((far *= 2) > REACH)
            return REACH;
    if (far == enough)
        return enough / 2;
    double low = larger(when - far * bound, 0.0), high = when + far * bound;
    for (int i = 0; i < 8; ++i) {
        const double middle = (low + high) / 2;
        (status(middle) == before ? low : high) = middle;
    }
    return std::fabs((low + high) / 2 - when) / bound;
}

/* How far from a true time a call ends that `stop` is to end there, in parts of
 * `bound`. */
double stopped(const asked &q, double tol, double when, double bound,
               int32_t stop)
{
    coin_body b = q.d;
    double reached = 0;
    const int32_t is = q.advance(&b, when + REACH * bound, tol, stop, &reached);
    if (is == COIN_ESTEP)
        return NO_CLAIM;
    return is & stop ? std::fabs(reached - when) / bound : REACH;
}

/* ------------------------------------------------------- from roll to slip */
template <class R> class rolling
{
  public:
    path<R> at;

    rolling(const asked &q, const coin_state &s)
        : at(q.p, s), IX(R(q.p.inertia_X) / m_of(q.p)),
          IZ(R(q.p.inertia_Z) / m_of(q.p)), mu(q.f.mu_static),
          mu_kinetic(q.f.mu_kinetic)
    {
    }
    /* What is left of the cone of friction. */
    R left() const
    {
        const held<R> f(IX, IZ, sine(at.lean()), at.cos_theta(), &at.at()[5]);
        return mu * f.N - f.friction();
    }

    /* Goes on to where nothing is left; how long that took, or -1 if it stays
     * in the cone, or nearly leaves it before. */
    R leave(R t)
    {
        R took = 0, before = left(), last = before;
        for (int i = 0; took < t && i < 2000; ++i) {
            const rolling from = *this;
            const R h = lesser(t - took, R(0.05) / (at.fastest() * at.w));
            if (!at.follow(h))
                return -1;
            const R now = left();
            if (now < 0)
                return took + crossed(from, h);
            if (last < before && last < now && last < R(0.05))
                return -1;
            before = last;
            last = now;
            took += h;
        }
        return -1;
    }

    /* How long a slip from here counts as rolling, at most, in natural time: by
     * what rolling needs beyond the friction of a slip. */
    R unseen() const
    {
        const held<R> f(IX, IZ, sine(at.lean()), at.cos_theta(), &at.at()[5]);
        const R least =
            R(ROLLS) + 16 * R(doubles::u) *
                           (magnitude(at.at()[5]) + magnitude(at.at()[7]));
        return least / (f.friction() - mu_kinetic * f.N);
    }

    /* How fast what is left changes, in natural time; and how much errors of
     * the lean and of the rates change it. */
    R slope() const
    {
        rolling later = *this;
        const R h = R(1e-6) / at.w;
        return later.at.follow(h) ? (later.left() - left()) / R(1e-6) : R(0);
    }
    R moves() const
    {
        R sum = 1;
        for (int which = 0; which < 4; ++which) {
            rolling other = *this;
            other.at.nudge(which, R(1e-7));
            sum += magnitude(other.left() - left()) / R(1e-7);
        }
        return sum;
    }

  private:
    R IX, IZ, mu, mu_kinetic;

    static R m_of(const coin_params &p)
    {
        return R(p.mass) * p.radius * p.radius;
    }
    R crossed(const rolling &from, R h)
    {
        R low = 0, high = h;
        for (int i = 0; i < 60; ++i) {
            const R middle = (low + high) / 2;
            *this = from;
            (void)at.follow(middle);
            (left() < 0 ? high : low) = middle;
        }
        return high;
    }
};

template <class R> double begins(const scene &s, double enough)
{
    asked q(s);
    const double tol = s.q[3];
    if (coin_body_from_state(&q.d, &q.d.s, &q.p) != COIN_OK ||
        q.advance(&q.d, 0, tol) != COIN_OK)
        return NO_CLAIM;
    rolling<R> truth(q, q.d.s);
    if (!(truth.left() > R(1e-3)) || truth.at.is_long(R(s.t)))
        return NO_CLAIM;
    const R when = truth.leave(R(s.t));
    if (!(when > 0))
        return NO_CLAIM;
    const R natural = when * truth.at.w;
    const double bound =
        double(blurred(allowed(R(tol), natural), truth.moves(), truth.slope()) /
               truth.at.w);
    if (!(bound * double(truth.at.w) < BLURRED / double(truth.at.fastest())))
        return NO_CLAIM;
    const double ratio =
        larger(distance(q, tol, double(when),
                        bound + double(truth.unseen() / truth.at.w), COIN_OK,
                        COIN_SLIPS, enough),
               stopped(q, tol, double(when), bound, COIN_SLIPS | COIN_LIFTS));
    return unamplified(ratio, enough, [&](double most) {
        return growth(q.p, q.d.s, double(when) / 8, 8, most);
    });
}

/* ----------------------------------------------------------- ends of slips */
/* Whether a coin slips, on a table that is accepted. */
bool slips(const asked &q, double tol)
{
    coin_body d = q.d;
    return q.advance(&d, 0, tol) == COIN_SLIPS;
}

template <class R> double ends(const scene &s, double enough)
{
    const asked q(s);
    const double tol = s.q[3];
    slide<R> truth(q);
    if (!slips(q, tol) || !(truth.speed(truth.y) > R(1e-2)) ||
        truth.follow(R(s.t), R(ROLLS)) != slide<R>::STOPS)
        return NO_CLAIM;
    const R slope = truth.speed_slope(), F = truth.sticking();
    if (!(slope < 0 && F >= 0 && F < R(0.95) * q.f.mu_static))
        return NO_CLAIM;
    const R natural = truth.took - truth.speed(truth.y) / slope;
    /* u is a sum of two velocities, and one that theta changes. */
    const R moves = 2 + magnitude(truth.y[5]);
    const double w = double(truth.w);
    const double bound =
        double(blurred(allowed(R(tol), natural) + R(ROLLS), moves, slope)) / w;
    if (!(bound * w < BLURRED))
        return NO_CLAIM;
    const double when = double(natural) / w;
    const double ratio =
        larger(distance(q, tol, when, bound, COIN_SLIPS, COIN_OK, enough),
               stopped(q, tol, when, bound, COIN_ROLLS));
    return unamplified(ratio, enough, [&](double most) {
        return growth(q, 0.9L * when, most);
    });
}

template <class R> double lifts(const scene &s, double enough)
{
    const asked q(s);
    const double tol = s.q[3];
    slide<R> truth(q);
    if (!slips(q, tol) ||
        !(truth.speed(truth.y) > R(1e-2) && truth.pressed() > R(1e-3)) ||
        truth.follow(R(s.t)) != slide<R>::LIFTS)
        return NO_CLAIM;
    const double w = double(truth.w);
    const R bound =
        blurred(allowed(R(tol), truth.took), truth.pull(), truth.lightening());
    if (!(bound < R(BLURRED)))
        return NO_CLAIM;
    coin_body d = q.d;
    double reached;
    if (q.advance(&d, double(truth.took) / w * 1.01, tol, COIN_LIFTS,
                  &reached) != COIN_LIFTS)
        return BROKEN;
    const double ratio =
        double(magnitude(R(reached) * truth.w - truth.took) / bound);
    return unamplified(ratio, enough, [&](double most) {
        return growth(q, 0.9L * truth.took / truth.w, most);
    });
}

/* --------------------------------------------------------------- reaction */
/* The terms of a quotient a/b. */
template <class R> terms<R> over(const terms<R> &a, const terms<R> &b)
{
    terms<R> r;
    r.value = a.value / b.value;
    r.size = (a.size + magnitude(r.value) * b.size) / magnitude(b.value);
    return r;
}

/* Of a coin that slips; M = 1 is the unit of the masses. */
template <class R> double reaction(const scene &s, double)
{
    const asked q(s);
    const moment<R> y(q.p, q.d.s);
    const slipping<R> u(y, q.d);
    coin_force f;
    if (coin_body_reaction(&q.d, &q.p, &q.f, &f) != COIN_OK ||
        !slips(q, 1e-2) || !(u.speed() > R(1e-3) * u.size()) ||
        !(u.speed() > R(1e-9) * y.a))
        return NO_CLAIM;
    const R nX = u.X.value / u.speed(), nh = u.h.value / u.speed();
    const R lever = y.m / y.IX, mu = q.f.mu_kinetic;
    terms<R> weight, D;
    weight.add(y.g).add(-y.a * y.wX * y.wX * y.c);
    weight.add(y.a * y.s * y.k1 * y.wY * y.wZ);
    weight.add(y.a * y.s * y.wY * y.wY * y.T); /* (78) */
    D.add(R(1)).add(lever * y.s * y.s).add(lever * mu * nh * y.s * y.c);
    D.size += lever * mu * magnitude(y.s * y.c) * u.size() / u.speed();
    const terms<R> N = over(weight, D);           /* (80) */
    if (!(N.value > 32 * R(doubles::u) * N.size)) /* it lifts off */
        return f.normal <= double(y.M * N.size) * 64 * doubles::u ? NO_CLAIM
                                                                  : BROKEN;
    const R turned = magnitude(N.value) * mu * u.size() / u.speed();
    const R least = 1024 * R(doubles::normal);
    const R normal = 32 * R(doubles::u) * y.M * N.size / y.c + least;
    const R friction =
        32 * R(doubles::u) * y.M * (mu * N.size + turned) / y.c + least;
    const R FX = -mu * y.M * N.value * nX, Fh = -mu * y.M * N.value * nh;
    verdict<R> v;
    v.hold(R(f.normal), y.M * N.value, normal);
    v.hold(R(f.R[1]), y.M * N.value, normal);
    v.hold(R(f.R[0]), FX * y.cph + Fh * y.sph, friction);
    v.hold(R(f.R[2]), Fh * y.cph - FX * y.sph, friction);
    v.hold(R(f.friction), mu * y.M * magnitude(N.value), friction);
    return v.worst;
}

/* Longer than a slip takes. */
void thrown_far(scene *s, const double *g)
{
    thrown(s, g);
    s->t = 8 * std::sqrt(s->a / s->g);
}
} // namespace

void add_slide_events(std::vector<row> *rows)
{
    const char *law = "tol (1 + natural time) over the rate; before "
                      "amplification";
    rows->push_back({"coin_move_begins", law, 5, false, thrown_far,
                     begins<long double>, begins<quad>});
    rows->push_back({"coin_move_ends", law, 100, false, thrown_far,
                     ends<long double>, ends<quad>});
    rows->push_back({"coin_move_lifts", law, 25, false, thrown_far,
                     lifts<long double>, lifts<quad>});
    rows->push_back({"coin_body_reaction",
                     "32 u of the terms over cos theta; slipping", 1, false,
                     thrown, reaction<long double>, reaction<quad>});
}
