/* SPDX-License-Identifier: MIT */
/* Coins that slip: what is read off a body, its way while it slips, and when a
 * slip begins and ends or a coin lifts off. */
#include "body.hpp"
#include "motion.hpp"

namespace
{
/* A scene's velocity of the centre, in parts of sqrt(g a), and its friction;
 * its losses, all of the size q[2] in parts of the coin's own torques, where
 * the bits of steps ask for them. */
struct asked : given {
    explicit asked(const scene &s, bool lossy = false) : given(s, s.q[3])
    {
        const double v = std::sqrt(s.g * s.a);
        b.vx = s.q[0] * v;
        b.vz = s.q[1] * v;
        set_on_table(&b, p);
        table.mu_static = s.tol * 1.1;
        table.mu_kinetic = s.tol;
        if (lossy) {
            scene of = s;
            /* No damping; angular. */
            of.steps = 2 * (int(s.steps) % 64) + 256 * (int(s.steps) / 64 % 2);
            of.q[0] = of.q[1] = of.q[3] = s.q[2];
            table.losses = losses_of(of);
        }
    }
    /* Whether it slips, on a table that is accepted. */
    bool slips() const
    {
        coin_body at = b;
        return move(&at, 0) == COIN_SLIPS;
    }
    template <class R> motion<R> truth(bool lossy = false) const
    {
        motion<R> slides(p, b, table.mu_kinetic);
        if (lossy)
            slides.slow_by(table.losses, p);
        return slides;
    }
};

/* ---------------------------------------------------------- read off a body */

template <class T, class R> bool energy(trial<T, R> &q)
{
    const asked c(q.s);
    const coin_body &b = c.b;
    const moment<R> &y = q.at;
    const double E = coin_body_energy(&b, &c.p);
    terms<R> want;
    want.add(y.M * b.vx * b.vx / 2).add(y.M * b.vz * b.vz / 2);
    want.add(y.M * b.vy * b.vy / 2).add(y.IX * y.wX * y.wX / 2);
    want.add(y.IX * y.wY * y.wY / 2).add(y.IZ * y.wZ * y.wZ / 2);
    want.add(y.M * y.g * b.y); /* (88) */
    q.hold(R(E), want.value, 12 * q.u * want.size + 16 * q.normal);
    return E == E;
}

/* The slip velocity along e_X and e_h, (77). */
template <class R> struct slipping {
    terms<R> X, h;

    slipping(const moment<R> &y, const coin_body &d)
    {
        X.add(R(d.vx) * y.cph).add(-R(d.vz) * y.sph).add(y.a * y.wZ);
        h.add(R(d.vx) * y.sph).add(R(d.vz) * y.cph).add(-y.a * y.wX * y.c);
    }
    R speed() const
    {
        return root(X.value * X.value + h.value * h.value);
    }
    R size() const
    {
        return X.size + h.size;
    }
};

template <class T, class R> bool velocity(trial<T, R> &q)
{
    const asked c(q.s);
    const moment<R> &y = q.at;
    double u[2];
    if (coin_body_slip(&c.b, &c.p, u) != COIN_OK)
        return false;
    const slipping<R> of(y, c.b);
    const R allowed = 8 * q.u * of.size() + 16 * q.normal;
    q.hold(R(u[0]), of.X.value * y.cph + of.h.value * y.sph, allowed);
    q.hold(R(u[1]), of.h.value * y.cph - of.X.value * y.sph, allowed);
    return true;
}

template <class T, class R> bool from_state(trial<T, R> &q)
{
    coin_body d;
    terms<R> want[8];
    if (coin_body_from_state(&d, &q.y, &q.p) != COIN_OK)
        return false;
    rates_of(q.at, want);
    q.hold(R(d.vx), want[3].value, 8 * q.u * want[3].size + 16 * q.normal);
    q.hold(R(d.vz), want[4].value, 8 * q.u * want[4].size + 16 * q.normal);
    return true;
}

/* The terms of a quotient a/b. */
template <class R> terms<R> over(const terms<R> &a, const terms<R> &b)
{
    terms<R> r;
    r.value = a.value / b.value;
    r.size = (a.size + magnitude(r.value) * b.size) / magnitude(b.value);
    return r;
}

/* Of a coin that slips; M = 1 is the unit of the masses. */
template <class T, class R> bool reaction(trial<T, R> &q)
{
    asked c(q.s);
    c.tol = 1e-2;
    const moment<R> &y = q.at;
    const slipping<R> u(y, c.b);
    coin_force f;
    if (coin_body_reaction(&c.b, &c.p, &c.table, &f) != COIN_OK || !c.slips() ||
        !(u.speed() > R(1e-3) * u.size()) || !(u.speed() > R(1e-9) * y.a))
        return false;
    const R nX = u.X.value / u.speed(), nh = u.h.value / u.speed();
    const R lever = y.m / y.IX, mu = c.table.mu_kinetic;
    terms<R> weight, D;
    weight.add(y.g).add(-y.a * y.wX * y.wX * y.c);
    weight.add(y.a * y.s * y.k1 * y.wY * y.wZ);
    weight.add(y.a * y.s * y.wY * y.wY * y.T); /* (78) */
    D.add(R(1)).add(lever * y.s * y.s).add(lever * mu * nh * y.s * y.c);
    D.size += lever * mu * magnitude(y.s * y.c) * u.size() / u.speed();
    const terms<R> N = over(weight, D); /* (80) */
    if (!(N.value > 32 * q.u * N.size)) /* it lifts off */
        return !(f.normal <= double(y.M * N.size) * 64 * doubles::u) &&
               q.is(BROKEN);
    const R turned = magnitude(N.value) * mu * u.size() / u.speed();
    const R some = 1024 * q.normal, few = 32 * q.u * y.M / y.c;
    const R normal = few * N.size + some;
    const R friction = few * (mu * N.size + turned) + some;
    const R FX = -mu * y.M * N.value * nX, Fh = -mu * y.M * N.value * nh;
    q.hold(R(f.normal), y.M * N.value, normal);
    q.hold(R(f.R[1]), y.M * N.value, normal);
    q.hold(R(f.R[0]), FX * y.cph + Fh * y.sph, friction);
    q.hold(R(f.R[2]), Fh * y.cph - FX * y.sph, friction);
    q.hold(R(f.friction), mu * y.M * magnitude(N.value), friction);
    return true;
}

/* ----------------------------------------------------------- while it slips */

/* So many calls, each of which has to say that it slips, and nothing else when
 * it is asked again. */
int32_t slipped(const asked &c, coin_body *b, double t, int count)
{
    int32_t status = COIN_OK;
    for (int i = 0; i < count; ++i) {
        status = c.move(b, t / count);
        if (status < 0)
            return status;
        if (!c.says(status, *b))
            return COIN_EARG;
        if (status == COIN_RESTS || status == COIN_LIFTS)
            return status;
        if (!is_on_table(*b, c.p))
            return COIN_EARG;
    }
    return status;
}

/* In one call, or many, of losses too; from where the coin rolls, without
 * friction. */
enum { ONCE, CALLS, ICE, LOSSES };

template <class T, class R> bool slip(trial<T, R> &q)
{
    const scene &s = q.s;
    const bool lossy =
        q.kind == LOSSES || (q.kind == CALLS && int(s.steps) % 2 > 0);
    const int count = q.kind == CALLS ? 2 + int(s.method) % 63 : 1;
    asked c(s, lossy);
    if (q.kind == ICE) {
        c.table = {};
        if (!c.roll())
            return false;
    }
    const bool on_ice = !(c.table.mu_kinetic > 0);
    coin_body end = c.b;
    motion<R> truth = c.truth<R>(lossy);
    /* The truth first: it gives up sooner than a call whose trials run out. */
    if (!(on_ice || truth.speed() > R(1e-2)) || !truth.follow(R(s.t)))
        return false;
    const int32_t status = slipped(c, &end, s.t, count);
    if (status == COIN_EARG && c.tol >= 1e-12 && c.tol <= 1e-2)
        return q.is(BROKEN);
    if (!(status == COIN_SLIPS || (on_ice && status == COIN_OK)))
        return false;
    /* A slip that begins counts as 0 below 2e-10, and so does what it changes
     * of the rates until then. */
    const R begun = R(on_ice ? 4e-10 : 0), natural = R(s.t) * truth.w;
    const R bound =
        (R(c.tol) + R(1e-14)) * (1 + natural) + begun +
        64 * q.u *
            (1 + magnitude(truth.at(truth.PX) + c.b.s.x / c.p.radius) +
             magnitude(truth.at(truth.PZ) + c.b.s.z / c.p.radius)) +
        R(count > 1 ? 8 * count : 0) * q.u / truth.at(truth.C);
    return q.is(unamplified(double(truth.off(end) / bound), q.enough,
                            c.truth<long double>(lossy), s.t / 4, 4));
}

/* ----------------------------------------------------- where it changes mode
 */

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

double distance(const asked &c, double when, double bound, int32_t before,
                int32_t after, double enough)
{
    bool tells = true;
    const auto status = [&](double t) {
        coin_body d = c.b;
        const int32_t is = c.move(&d, larger(t, 0.0));
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
double stopped(const asked &c, double when, double bound, int32_t stop)
{
    coin_body b = c.b;
    double reached = 0;
    const int32_t is = c.move(&b, when + REACH * bound, stop, &reached);
    if (is == COIN_ESTEP)
        return NO_CLAIM;
    return is & stop ? std::fabs(reached - when) / bound : REACH;
}

/* Follows a coin that rolls to where nothing is left of the cone; how long that
 * took, or -1 if it stays in the cone, or nearly leaves it before. */
template <class R> R leave(motion<R> *at, R t, R mu)
{
    R took = 0, before = at->left(mu), last = before;
    for (int i = 0; took < t && i < 2000; ++i) {
        const motion<R> from = *at;
        const R h = lesser(t - took, R(0.05) / (at->fastest() * at->w));
        if (!at->follow(h))
            return -1;
        const R now = at->left(mu);
        if (now < 0)
            return took + at->cross(from, h * at->w, [mu](const motion<R> &m) {
                return !(m.left(mu) < 0);
            }) / at->w;
        if (last < before && last < now && last < R(0.05))
            return -1;
        before = last;
        last = now;
        took += h;
    }
    return -1;
}

template <class T, class R> bool begins(trial<T, R> &q)
{
    asked c(q.s);
    if (!c.roll() || !c.says(COIN_OK, c.b))
        return false;
    const R mu = c.table.mu_static;
    motion<R> truth(c.p, c.b.s);
    if (!(truth.left(mu) > R(1e-3)) || truth.is_long(R(q.s.t)))
        return false;
    const R when = leave(&truth, R(q.s.t), mu);
    if (!(when > 0))
        return false;
    const auto left = [mu](const motion<R> &m) { return m.left(mu); };
    const double w = double(truth.w), W = double(truth.fastest());
    const double bound =
        double(blurred(allowed(R(c.tol), when * truth.w), truth.moves(left),
                       truth.slope_of(left))) /
        w;
    if (!(bound * w < BLURRED / W))
        return false;
    /* How long a slip from here counts as rolling, at most: by what rolling
     * needs beyond the friction of a slip. */
    R N, F;
    truth.stuck(&N, &F);
    const R least = R(ROLLS) + 16 * q.u *
                                   (magnitude(truth.at(truth.WX)) +
                                    magnitude(truth.at(truth.WZ)));
    const double unseen = double(least / (F - c.table.mu_kinetic * N)) / w;
    const double ratio =
        larger(distance(c, double(when), bound + unseen, COIN_OK, COIN_SLIPS,
                        q.enough),
               stopped(c, double(when), bound, COIN_SLIPS | COIN_LIFTS));
    return q.is(
        unamplified(ratio, q.enough, {c.p, c.b.s}, double(when) / 8, 8));
}

template <class T, class R> bool ends(trial<T, R> &q)
{
    using truth_of = motion<R>;
    const asked c(q.s);
    truth_of truth = c.truth<R>();
    if (!c.slips() || !(truth.speed() > R(1e-2)) ||
        truth.go(R(q.s.t), R(ROLLS)) != truth_of::STOPS)
        return false;
    R N, F;
    truth.stuck(&N, &F);
    const R slope = truth.speed_slope();
    if (!(slope < 0 && N > 0 && F < R(0.95) * c.table.mu_static * N))
        return false;
    const R natural = truth.took - truth.speed() / slope;
    /* u is a sum of two velocities, and one that theta changes. */
    const R moves = 2 + magnitude(truth.at(truth.WX));
    const double w = double(truth.w), when = double(natural) / w;
    const double bound =
        double(blurred(allowed(R(c.tol), natural) + R(ROLLS), moves, slope)) /
        w;
    if (!(bound * w < BLURRED))
        return false;
    const double ratio =
        larger(distance(c, when, bound, COIN_SLIPS, COIN_OK, q.enough),
               stopped(c, when, bound, COIN_ROLLS));
    return q.is(unamplified(ratio, q.enough, c.truth<long double>(),
                            0.9L * when / 4, 4));
}

template <class T, class R> bool lifts(trial<T, R> &q)
{
    using truth_of = motion<R>;
    const asked c(q.s);
    truth_of truth = c.truth<R>();
    if (!c.slips() || !(truth.speed() > R(1e-2) && truth.pressed() > R(1e-3)) ||
        truth.go(R(q.s.t)) != truth_of::LIFTS)
        return false;
    const auto N = [](const truth_of &m) { return m.pressed(); };
    const R bound = blurred(allowed(R(c.tol), truth.took), truth.moves(N),
                            truth.lightening());
    if (!(bound < R(BLURRED)))
        return false;
    coin_body d = c.b;
    double reached = 0;
    const double when = double(truth.took / truth.w);
    if (c.move(&d, when * 1.01, COIN_LIFTS, &reached) != COIN_LIFTS)
        return q.is(BROKEN);
    return q.is(unamplified(
        double(magnitude(R(reached) * truth.w - truth.took) / bound), q.enough,
        c.truth<long double>(), 0.9L * when / 4, 4));
}

/* ------------------------------------------------------------------- edges */

/* Any velocity of the centre and friction; for an event longer than a slip
 * takes. */
enum { EVENT = -1 };
void thrown(scene *s, const double *g, int kind)
{
    near_pose(s, g);
    s->tol = 1.2 * g[24];
    s->t = std::sqrt(s->a / s->g) *
           (kind == EVENT ? 8 : std::pow(10, 3.5 * g[22] - 2.5));
    s->q[0] = 4 * g[26] - 2;
    s->q[1] = 4 * g[27] - 2;
    s->q[3] = std::pow(10, 9.9 * g[29] - 11.95);
}

/* Losses of 1e-8 to 0.01; half of the throws 1e-5 to 0.3 from flat, and slow.
 */
void thrown_with_losses(scene *s, const double *g, int kind)
{
    thrown(s, g, kind);
    s->steps = std::floor(128 * g[23]);
    s->q[2] = std::pow(10, 6 * g[28] - 8);
    if (kind == CALLS) {
        s->method = std::floor(63 * g[9]);
        s->q[3] = std::pow(10, 7 * g[29] - 9);
    }
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

} // namespace

std::vector<row> slips()
{
    const char *way = "tol (1 + natural time) before amplification; slipping";
    const char *when = "tol (1 + natural time) over the rate; before "
                       "amplification";
    return {
        ROW("body_energy", "12 u of the terms", 1, nullptr, 0, energy),
        ROW("body_slip", "8 u of the terms", 1, nullptr, 0, velocity),
        ROW("body_from_state", "8 u of the terms", 1, nullptr, 0, from_state),
        ROW("body_reaction", "32 u of the terms over cos theta; slipping", 1,
            thrown, 0, reaction),
        ROW("move_slips", way, 25, thrown, ONCE, slip),
        ROW("move_ice", way, 25, thrown, ICE, slip),
        ROW("move_slip_calls", way, 25, thrown_with_losses, CALLS, slip),
        ROW("move_losses", way, 25, thrown_with_losses, LOSSES, slip),
        ROW("move_begins", when, 10, thrown, EVENT, begins),
        ROW("move_ends", when, 100, thrown, EVENT, ends),
        ROW("move_lifts", when, 25, thrown, EVENT, lifts),
    };
}
