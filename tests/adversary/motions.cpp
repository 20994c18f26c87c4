/* SPDX-License-Identifier: MIT */
/* What moves a state or a body, beside the true motion: fixed steps, to a
 * tolerance, by one call or many, and orbits.  What a call returns has to mean
 * to the next what its status says. */
#include "motion.hpp"

namespace
{
double ratio_of(real error, real bound)
{
    return error <= 1e30L ? double(error / bound) : BROKEN;
}

/* -------------------------------------------------------------- fixed steps */

/* C (|dt| W)^(order + 1) a step, before the motion's own amplification. */
constexpr struct method {
    int order;
    double C, limit;
} METHODS[] = {{4, 0.1, 0.35}, {8, 2e-4, 1}, {2, 0.6, 0.08}, {4, 0.04, 0.16}};

/* The largest difference of the members in radians, radii and parts of W. */
template <class T>
real apart(const motion &truth, const typename T::state &s, real W)
{
    scene whole = {};
    for (int i = 0; i < 8; ++i) {
        (&whole.theta)[i] = (&s.theta)[i];
        if constexpr (T::is_single)
            (&whole.theta)[i] += s.low[i];
    }
    real off[8], worst = 0;
    truth.apart(whole, W, off);
    for (int i = 0; i < 8; ++i) {
        /* Heading and roll of floats lie within half a turn. */
        if (T::is_single && (i == motion::PHI || i == motion::PSI))
            off[i] = std::remainder(off[i], 4 * HALF_PI);
        worst = std::max(worst, std::fabs(off[i]));
    }
    return worst;
}

/* The law's bodies: those whose mass lies within the rim, up to the hoop's
 * I_X = M a^2/2 and its rounding. */
constexpr double RIM = 0.500001;

template <class T, int kind> bool runs(trial<T> &q)
{
    constexpr method law = METHODS[kind];
    const auto dt = decltype(q.p.mass)(q.s.t);
    const int steps = int(q.s.count);
    const bool is_step = steps == 1 && kind == COIN_RK4;
    const motion start(q.p, q.y);
    motion truth = start;
    q.made = q.y;
    if (!(start.IX < RIM) ||
        (is_step ? T::step(&q.made, &q.p, dt)
                 : T::run(&q.made, &q.p, kind, dt, uint64_t(steps), nullptr)) !=
            COIN_OK)
        return false;
    real sum = 0, W = truth.fastest(), last = W, least = truth.at(truth.C);
    for (int k = 0; k < steps; ++k) {
        if (!truth.follow(dt))
            return false;
        least = std::min(least, truth.at(truth.C));
        W = std::max(last, truth.fastest());
        last = truth.fastest();
        sum += std::pow(std::fabs(dt) * truth.w * W, real(law.order + 1));
    }
    const real rounds = 4 * T::u * steps;
    const bool is_symplectic = kind > COIN_RK8;
    const real bound = law.C * sum + (is_symplectic ? rounds / least : rounds) +
                       16 * T::u * truth.largest_of_pose();
    const double ratio = ratio_of(apart<T>(truth, q.made, W), bound);
    /* Growth is that of errors of cos theta in the lean; one of its rounding is
     * that of a radian. */
    const real lean = is_symplectic ? 0 : rounds * (1 / least - 1);
    const double more = steps > 1 ? double(1 + lean / bound) : 1;
    q.is(steps == 1 || ratio <= UNAMPLIFIED
             ? ratio
             : unamplified(ratio / more, q.enough, start, dt * real(steps)));
    return bound < 1;
}

/* dt W at and below the method's limit, where the law has least to spare; half
 * of one step. */
template <int kind> void near_the_limit(scene *s, const double *g)
{
    const double part = 2 * g[TIME] - 1, limit = METHODS[kind].limit;
    s->t = (part < 0 ? -limit : limit) * std::pow(10, -2 * part * part) /
           fastest_of(*s);
    if (g[MORE] < 0.5)
        s->count = 1;
}

/* --------------------------------------------- one call, or many short ones */

enum mover { ADVANCE, SETTLE, ROLLS, SLIPS };

/* What it may err by: so many tol a radius of speed, of a slip a natural time;
 * and u, so many in a natural time and at once. */
constexpr struct claim {
    double tol, in_time, at_once;
} CLAIMS[] = {{2, 9, 0}, {2, 90, 90}, {2, 90, 90}, {1, 90, 138}};

/* Of a single call of coin_settle() more; of many, u in each over cos theta;
 * of a slip that begins on ice, what counts as none. */
constexpr double SETTLES = 20, EACH = 8, BEGUN = 4e-10;

/* What it may err by on the way of a truth. */
real bound_of(const trial<doubles> &q, mover kind, const motion &truth,
              real turned)
{
    const scene &s = q.s;
    const claim &may = CLAIMS[kind];
    const real natural = std::fabs(s.count * s.t) * truth.w;
    const bool is_alone = s.count == 1;
    return (kind == SETTLE && is_alone ? SETTLES : may.tol) * s.tol *
               (1 + (kind == SLIPS ? natural : turned)) +
           q.u * (may.at_once + may.in_time * natural +
                  16 * truth.largest_of_pose() +
                  (is_alone ? 0 : EACH * s.count / truth.least_c)) +
           (kind == SLIPS && s.mu_static == 0 ? BEGUN : 0);
}

/* Moves the body.  Beyond the time asked, whatever the status, is BROKEN. */
int32_t call(trial<doubles> &q, mover kind)
{
    coin_state *s = &q.b.s;
    double reached = 0;
    const int32_t status =
        kind == ADVANCE ? coin_advance(s, &q.p, q.s.t, q.s.tol, &reached)
        : kind == SETTLE
            ? coin_settle(s, &q.p, &q.losses, q.s.t, q.s.tol, &reached)
            : q.move(&q.b, q.s.t, COIN_LIFTS, &reached);
    if (!(std::fabs(reached) <= std::fabs(q.s.t)))
        q.is(BROKEN);
    return status;
}

/* Whether a returned body is what it is said to be, on the table to the
 * rounding of two cosines, and of two sines and four products: BROKEN, or the
 * slip of one that rolls, in parts of what rounding may leave. */
double untrue(const trial<doubles> &q, int32_t status)
{
    const coin_body &b = q.b;
    coin_body on = b;
    double u[3];
    set_on_table(&on, q.p);
    if (!q.says(status, b) || std::fabs(on.y - b.y) > 0x1p-52 * q.p.radius ||
        std::fabs(on.vy - b.vy) > 0x1p-50 * std::fabs(on.vy) ||
        coin_body_contact(&b, &q.p, u) != COIN_OK)
        return BROKEN;
    const double size = std::fabs(b.vx) + std::fabs(b.vz) +
                        q.p.radius * (std::fabs(b.s.wX) + std::fabs(b.s.wZ));
    return status == COIN_OK && q.s.mu_static > 0
               ? std::hypot(u[0], u[2]) / (8 * doubles::u * size + DBL_MIN)
               : 0;
}

template <mover kind> bool moves(trial<doubles> &q)
{
    const bool on_ice = kind == SLIPS && q.s.mu_static == 0;
    if ((kind == ROLLS || on_ice) && !q.roll())
        return false;
    motion truth =
        kind == SLIPS ? motion(q.p, q.b, q.table.mu_kinetic) : motion(q.p, q.y);
    if (kind > ADVANCE)
        truth.slow_by(kind == SETTLE ? q.losses : q.table.losses, q.p);
    const motion start = truth;
    motion tightest = truth;
    const real t = q.s.count * real(q.s.t), mu = q.table.mu_static;
    const auto left = [mu](const motion &m) { return m.left(mu); };
    const auto cone = [&](const motion &m) {
        if (left(m) < left(tightest))
            tightest = m;
        return left(tightest) - 1e-3L;
    };
    if (kind == SLIPS && !on_ice && !(truth.speed() > 1e-2L))
        return false;
    if (kind == ROLLS ? truth.is_long(t) || !(cone(truth) > 0) ||
                            truth.until(t, cone, 0.1) != motion::GOES
                      : !truth.follow(t))
        return false;
    const real bound = bound_of(q, kind, truth, start.turned(t));
    for (int i = 0; i < q.s.count; ++i) {
        const int32_t status = call(q, kind);
        if (kind == ROLLS && (status == COIN_SLIPS || status == COIN_LIFTS)) {
            const real near = left(tightest) / tightest.moves(left) / bound;
            return near > 1 && start.growth(t, near) < near && q.is(BROKEN);
        }
        if (status != COIN_OK && !(kind == SLIPS && status == COIN_SLIPS))
            return q.worst == BROKEN;
        if (kind >= ROLLS)
            q.is(untrue(q, status));
        const bool lies = q.b.s.wX == 0 && q.b.s.wY == 0; /* no truth of that */
        if (kind == SLIPS && (lies || (status == COIN_OK && !on_ice)))
            return q.worst == BROKEN;
    }
    return q.is(unamplified(ratio_of(truth.off(q.b), bound), q.enough, start,
                            t)) &&
           bound < 1;
}

/* Up to 25 natural units; often many calls of what is 1/1000 to 1/30 s to a
 * quarter. */
void calls(scene *s, const double *g)
{
    horizon(s, g, -2, 1.4);
    s->above = 0;
    s->count = 1;
    if (g[COUNT] < 0.4)
        return;
    s->count = std::floor(2 + 104 * (g[COUNT] - 0.4));
    s->t = unit_of(*s) * power_of_ten(g[TIME], -1.6, 0);
    s->tol = power_of_ten(g[TOL], -9, -2);
}

void either_way(scene *s, const double *g)
{
    calls(s, g);
    s->t *= g[MORE] < 0.5 ? 1 : -1;
}

void slips(scene *s, const double *g)
{
    calls(s, g);
    s->t = unit_of(*s) * power_of_ten(g[TIME], -2.5, 1) / s->count;
}

/* ------------------------------------------------------------------ orbits */

/* From a time on, about a period, to that at which lean and rates are again
 * those of the beginning, by Newton's rule along the motion; 0 if that is not
 * found. */
real period_of(const motion &begin, real guess, motion *whole)
{
    constexpr int LONGEST = 4 * motion::MOST_TURN;
    const real W = begin.fastest(), X = begin.at(begin.WX) / W,
               P = begin.slopes()[begin.WX] / (W * W);
    real period = 0, step = guess, before;
    *whole = begin;
    do {
        before = std::fabs(step);
        if (!whole->follow(step, LONGEST))
            return 0;
        period += step;
        const real speed = (whole->at(begin.WX) - begin.at(begin.WX)) / W;
        step = -(whole->lean_apart(begin) * X + speed * P) /
               ((X * X + P * P) * W * begin.w);
    } while (std::fabs(step) < before / 2);
    real off = std::fabs(whole->lean_apart(begin)) / begin.at(begin.C);
    for (int i = begin.WX; i <= begin.WZ; ++i)
        off = std::max(off, std::fabs(whole->at(i) - begin.at(i)) / W);
    return off < 0x1p-53L && std::fabs(period - guess) < std::fabs(guess) / 2
               ? period
               : 0;
}

/* As follow(), for any time: lean and rates of a swing return after a period,
 * and each period turns and moves the coin as the one before.  The guess is of
 * a period. */
bool follow_far(motion *now, real t, real guess)
{
    if (!now->is_long(t))
        return now->follow(t);
    motion whole = *now;
    const real period = period_of(*now, std::copysign(guess, t), &whole);
    const real times = period == 0 ? 0 : std::trunc(t / period);
    if (times == 0 || !now->follow(t - times * period, 4 * motion::MOST_TURN))
        return false;
    now->repeat(whole, times);
    return true;
}

/* What the residue of a steady motion, up to 8 u of its terms, does to the
 * lean, and to the heading in a natural time. */
real residue_of(const moment &y, real W, real time)
{
    const real L = std::fabs(lambda2_of(y).value);
    const real lean = 16 * doubles::u * std::max(dwX_of(y).size, L) / L;
    return lean * (1 + 4 * W * time / y.c);
}

/* A state that an orbit tells of a time t, over the law of coin_orbit_at(): an
 * error e in the angles is one of e (1 + radius_max/a) radii in the place and
 * of e W in the rates; of e over the heading of a period in the place, where
 * each period nearly repeats the last; and what the truth rounds of the heading
 * of a period.  `far` is that radius, or less than 0 to leave out the place. */
bool told(trial<doubles> &q, const coin_orbit &o, double t,
          const coin_state &out, real far)
{
    const motion start(q.p, q.y);
    motion truth = start;
    if (!follow_far(&truth, t, o.period))
        return false;
    const bool is_orbit = o.period > 0, is_far = start.is_long(t);
    const real periods = is_orbit ? std::fabs(t) / o.period : 0;
    const real time = (std::fabs(t) + o.period) * truth.w;
    const real swing = (o.theta_max - o.theta_min) * std::fabs(t) * truth.w;
    const real heading = std::remainder(o.heading_per_period, 4 * HALF_PI);
    const real rounds = 0x1p-58L * periods * start.fastest() * time;
    real W = truth.most_W, amplified = 0;
    const real residue = is_orbit ? 0 : residue_of(q.at, W, time);
    const auto ratio = [&] {
        const real bound = 1e-14L + 1e-15L * o.conditioning * periods +
                           4 * doubles::u * W * time + residue + amplified;
        const real drift =
            is_orbit ? std::min(1 / std::fabs(heading), swing * W / bound) : 0;
        real off[8], worst = 0;
        truth.apart(out, W, off);
        for (int i = 0; i < 8; ++i)
            if (i < motion::PX || i > motion::PZ)
                worst = std::max(worst, std::fabs(off[i]));
            else if (far >= 0)
                worst = std::max(worst, std::fabs(off[i]) /
                                            (1 + far + drift + rounds / bound));
        return bound < 1 ? ratio_of(worst, bound) : NO_CLAIM;
    };
    if (ratio() > UNAMPLIFIED) {
        motion ahead = truth;
        ahead.follow(o.period);
        W = ahead.most_W;
    }
    if (ratio() > std::max(q.enough, UNAMPLIFIED))
        amplified = 4 * doubles::u * (is_far ? 1 + periods : 1) *
                    start.growth(is_far ? o.period : t, 1e30L);
    return q.is(ratio());
}

/* At a time; and after a period, when lean and rates are those of the start,
 * and heading and roll have gained what the orbit states. */
bool orbit(trial<doubles> &q)
{
    coin_orbit o;
    coin_state turned = q.y;
    if (coin_orbit_init(&o, &q.y, &q.p) != COIN_OK ||
        coin_orbit_at(&o, q.s.t, &q.made) != COIN_OK)
        return false;
    turned.phi += o.heading_per_period;
    turned.psi += o.roll_per_period;
    const real far = o.radius_max > 0 ? o.radius_max / q.at.a : 0;
    const bool tells = told(q, o, q.s.t, q.made, far);
    return (o.period > 0 && told(q, o, o.period, turned, -1)) || tells;
}

/* Most beside a steady circle: the leans and rolls between which some are
 * unstable.  Half up to 1e6 natural units. */
void about_circles(scene *s, const double *g)
{
    horizon(s, g, -2, g[METHOD] < 0.5 ? 6 : 1.8);
    const double w = 1 / unit_of(*s);
    double large, slow;
    if (g[MORE] < 0.7) {
        s->theta = 0.01 + 0.4 * g[LEANS + 1];
        s->wX = w * (g[MORE + 1] < 0.5 ? 0 : power_of_ten(g[MORE + 2], 0, -16));
        s->wZ = w * 0.7 * g[LEANS + 2];
        circles_of(*s, &large, &slow);
        s->wY = slow;
        if (g[MORE + 3] > 0.5)
            s->wY *= 1 + power_of_ten(g[QUAD], 0, -17);
    }
    s->t *= g[COUNT] < 0.5 ? 1 : -1;
}

const char *const RK4 = "0.1 (dt W)^5 a step + rounding";
} // namespace

const std::vector<row> MOTIONS = {
    {"coin_run_rk4", RK4, 2, near_the_limit<COIN_RK4>,
     judged(runs<doubles, COIN_RK4>), LOSS},
    {"coin_run_rk8", "2e-4 (dt W)^9 a step + rounding", 2,
     near_the_limit<COIN_RK8>, judged(runs<doubles, COIN_RK8>), LOSS},
    {"coin_run_symplectic2", "0.6 (dt W)^3 a step + rounding", 2,
     near_the_limit<COIN_SYMPLECTIC2>, judged(runs<doubles, COIN_SYMPLECTIC2>),
     LOSS},
    {"coin_run_symplectic4", "0.04 (dt W)^5 a step + rounding", 2,
     near_the_limit<COIN_SYMPLECTIC4>, judged(runs<doubles, COIN_SYMPLECTIC4>),
     LOSS},
    {"coinf_run_rk4", RK4, 2, near_the_limit<COIN_RK4>,
     judged<floats>(runs<floats, COIN_RK4>), LOSS, true},
    {"coin_advance", "2 tol a radius of speed + rounding", 8, either_way,
     judged(moves<ADVANCE>), LOSS},
    {"coin_settle", "20 tol a radius of speed; 2 of many calls; + rounding", 16,
     calls, judged(moves<SETTLE>)},
    {"coin_move_rolls",
     "2 tol a radius of speed + rounding; rolls where the truth does", 32,
     calls, judged(moves<ROLLS>)},
    {"coin_move_slips", "tol (1 + natural time) before amplification; slipping",
     8, slips, judged(moves<SLIPS>)},
    {"coin_orbit_at",
     "1e-14 + 1e-15 conditioning a period + 4 u W (abs(t) + period) + 4 u "
     "amplified",
     5, about_circles, judged(orbit), LOSS},
};
