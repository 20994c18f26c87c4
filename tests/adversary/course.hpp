/* SPDX-License-Identifier: MIT */
/* A while of a coin's motion as power series in time, of the equations of
 * docs/physics.md.  Natural units: M = a = g = 1. */
#ifndef ROLLCOIN_ADVERSARY_COURSE_HPP
#define ROLLCOIN_ADVERSARY_COURSE_HPP

#include "losses.hpp"
#include "series.hpp"

#include <optional>

/* A body, and where series begin: the lean's sine and cosine, the rates, and,
 * of a coin that slips, the velocity of its centre along e_X and e_h. */
struct outset {
    long double IX, IZ, s, c, wX, wY, wZ, vX, vh;
};

/* The changes for a while of N variables: lean, phi, psi, the way along and
 * aside in axes that turn with the heading, wX, wY, wZ, any others. */
template <int N> struct course {
    long double unit = 0;  /* of time */
    long double far = 0;   /* for how long */
    double ends = 0x1p-60; /* the last terms in parts of a variable's size */
    changes<N> by;

    /* Whether there is a motion from o on; time in units of `one`.  W is the
     * fastest rate of a coin that rolls. */
    template <class motion>
    bool begin(const outset &o, long double W, long double one, motion m)
    {
        unit = one;
        for (int n = 0; n < SHARP; ++n)
            m.template next<long double>(n, this);
        for (int n = SHARP; n < ORDER; ++n)
            m.template next<double>(n, this);
        const double w = double(W), c = double(o.c);
        const double sizes[] = {c, 1, 1, 1, 1, c * w, c * w, w, w, w};
        far = by.reach(sizes, ends, MOST_UNITS) * unit;
        return far > 0;
    }

    template <class V> void at(long double t, V &change) const
    {
        by.sum(t / unit, change);
    }

  private:
    static constexpr double MOST_UNITS = 4; /* the longest time */
};

/* What every motion multiplies. */
struct turning_series {
    long double IX, IZ;
    series s, c, wX, wY, wZ;
    series fall;       /* wX cos theta */
    series turn, spun; /* wY/cos theta, wY tan theta */
    series twist;      /* what wX has in (15) */
    series along, aside;

    explicit turning_series(const outset &o) : IX(o.IX), IZ(o.IZ)
    {
        s.set(0, o.s);
        c.set(0, o.c);
        wX.set(0, o.wX);
        wY.set(0, o.wY);
        wZ.set(0, o.wZ);
        along.set(0, 0.0L);
        aside.set(0, 0.0L);
    }

    /* The angles of order n + 1, and wY's slope of order n. */
    template <class T, class C> T angles(int n, C *to)
    {
        const T one = T(to->unit) / (n + 1);
        const T X = wX.at<T>(n), Z = wZ.at<T>(n);
        fall.set(n, series::product<T>(c, wX, n));
        turn.set(n, turn.quotient<T>(wY.at<T>(n), c, n));
        spun.set(n, series::product<T>(turn, s, n));
        twist.set(n, spun.at<T>(n) + T(IZ / IX) * Z);
        const T rise = series::product<T>(s, wX, n);
        s.set(n + 1, fall.at<T>(n) * one);
        c.set(n + 1, -rise * one);
        to->by.set(0, n + 1, X * one);                   /* (17) */
        to->by.set(1, n + 1, turn.at<T>(n) * one);       /* (18) */
        to->by.set(2, n + 1, (Z + spun.at<T>(n)) * one); /* (19) */
        return series::product<T>(wX, twist, n);         /* (15) */
    }

    /* The way and the rates of order n + 1, from the velocity along and aside
     * and the slopes. */
    template <class T, class C>
    void rates(int n, T ahead, T across, const T d[3], C *to)
    {
        ahead -= series::product<T>(turn, aside, n);
        across += series::product<T>(turn, along, n);
        grow(along, 3, n, ahead, to);
        grow(aside, 4, n, across, to);
        grow(wX, 5, n, d[0], to);
        grow(wY, 6, n, d[1], to);
        grow(wZ, 7, n, d[2], to);
    }

    template <class T, class C>
    static void grow(series &a, int i, int n, T slope, C *to)
    {
        const T value = slope * T(to->unit) / (n + 1);
        a.set(n + 1, value);
        to->by.set(i, n + 1, value);
    }
};

/* What slows the coin: the torques of struct losses.  The rate of roll has the
 * sign that it has at the outset. */
class losing_series
{
  public:
    losing_series(const losses<long double> &slow, const outset &o)
        : of(slow), side(o.wZ + o.wY * o.s / o.c < 0 ? -1 : 1)
    {
    }

    /* Adds to d(wX), d(wY), d(wZ)/dt of order n; of angular, whose part of wX
     * is the motion's, only the last two. */
    template <class T>
    void add(const turning_series &q, T IX, T IZ, T K, int n, T d[3])
    {
        const T Q = torque<T>(q, n);
        pull.set(n, Q);
        tangent.set(n, tangent.quotient<T>(q.s.at<T>(n), q.c, n));
        d[1] += series::product<T>(pull, tangent, n) / IX;
        d[2] += Q / K;
        d[1] -= T(of.angular) * q.wY.at<T>(n);
        d[2] -= T(of.angular) * IZ / K * q.wZ.at<T>(n);
        if (of.spin != 0) {
            upright.set(n, series::product<T>(q.wY, q.c, n) -
                               series::product<T>(q.wZ, q.s, n));
            const T spin = T(of.spin);
            d[1] -= spin * series::product<T>(upright, q.c, n) / IX;
            d[2] += spin * series::product<T>(upright, q.s, n) / K;
        }
        if (of.damping != 0) {
            const T fade = side * T(of.damping);
            d[0] -= fade * series::product<T>(roll, q.wX, n);
            d[1] -= fade * series::product<T>(roll, q.wY, n);
            d[2] -= fade * series::product<T>(roll, q.wZ, n);
        }
    }

    template <class T> T angular() const
    {
        return T(of.angular);
    }

  private:
    const losses<long double> &of;
    int side;
    series roll, grip, pull, tangent, upright, softened, dry, layer, gap;

    template <class T> T torque(const turning_series &q, int n)
    {
        const T one = n == 0, c = q.c.at<T>(n);
        roll.set(n, q.wZ.at<T>(n) + q.spun.at<T>(n));
        T sum = T(of.viscous) * one;
        if (of.dry != 0 || of.rolling != 0) {
            const T soft = T(of.soft) * T(of.soft) * one;
            const T square = series::product<T>(roll, roll, n) + soft;
            softened.set(n, softened.root_of<T>(square, n));
            const T held = T(of.dry) * one + T(of.rolling) * c;
            dry.set(n, dry.quotient<T>(held, softened, n));
            sum += dry.at<T>(n);
        }
        if (of.layer != 0) {
            layer.set(n, layer.root_of<T>(side * roll.at<T>(n), n));
            sum += T(of.layer) * layer.at<T>(n);
        }
        if (of.gap != 0) {
            gap.set(n, gap.quotient<T>(T(of.gap) * one, q.c, n));
            sum += gap.at<T>(n);
        }
        grip.set(n, sum);
        return -series::product<T>(roll, grip, n);
    }
};

/* A coin that rolls, slowed or not. */
struct rolling_series : turning_series {
    series gyro; /* what wY has in (14) */
    std::optional<losing_series> slow;

    rolling_series(const outset &o, const losses<long double> *l)
        : turning_series(o)
    {
        if (l)
            slow.emplace(*l, o);
    }

    template <class T> void next(int n, course<8> *to)
    {
        const T X = T(IX), Z = T(IZ), dwY = angles<T>(n, to);
        const T roll = wZ.at<T>(n), weight = s.at<T>(n);
        gyro.set(n, (1 + Z) * roll + X * spun.at<T>(n));
        T d[] = {(weight - series::product<T>(wY, gyro, n)) /
                     (1 + X),                                   /* (14) */
                 dwY, series::product<T>(wX, wY, n) / (1 + Z)}; /* (16) */
        if (slow) {
            d[0] -= slow->angular<T>() * X / (1 + X) * wX.at<T>(n);
            slow->add<T>(*this, X, Z, 1 + Z, n, d);
        }
        rates<T>(n, -roll, fall.at<T>(n), d, to); /* (20) */
    }
};

/* A coin that slips: vX and vh, the velocity of its centre along e_X and e_h,
 * are the last two variables. */
struct slipping_series : turning_series {
    long double mu;
    series vX, vh, uX, uh; /* of the centre; of the contact */
    series speed, nX, nh;  /* the slip's speed and direction */
    series gyro, still;    /* what wY has in (78), and (78) */
    series hinder, lever;  /* nh cos theta, and what sin theta has in (80) */
    series share, N;       /* N is 1/share of what (80) divides */
    std::optional<losing_series> slow;

    slipping_series(const outset &o, long double friction,
                    const losses<long double> *l)
        : turning_series(o), mu(friction)
    {
        vX.set(0, o.vX);
        vh.set(0, o.vh);
        if (l)
            slow.emplace(*l, o);
    }

    template <class T> void next(int n, course<10> *to)
    {
        const T X = T(IX), Z = T(IZ), dwY = angles<T>(n, to);
        press<T>(n);
        const T FX = -T(mu) * series::product<T>(N, nX, n);
        const T Fh = -T(mu) * series::product<T>(N, nh, n);
        force.set(n, Fh);
        const T turns =
            series::product<T>(N, s, n) - series::product<T>(force, c, n);
        T d[] = {still.at<T>(n) + turns / X, dwY, FX / Z};
        if (slow)
            slow->add<T>(*this, X, Z, Z, n, d);
        const T dX = FX - series::product<T>(turn, vh, n);
        const T dh = Fh + series::product<T>(turn, vX, n);
        rates<T>(n, vX.at<T>(n), vh.at<T>(n), d, to);
        grow(vX, 8, n, dX, to);
        grow(vh, 9, n, dh, to);
    }

  private:
    series force;

    /* The direction of the slip of order n; without friction it is 0. */
    template <class T> void direct(int n)
    {
        uX.set(n, vX.at<T>(n) + wZ.at<T>(n));
        uh.set(n, vh.at<T>(n) - fall.at<T>(n));
        speed.set(n, speed.root_of<T>(series::product<T>(uX, uX, n) +
                                          series::product<T>(uh, uh, n),
                                      n));
        nX.set(n, nX.quotient<T>(uX.at<T>(n), speed, n));
        nh.set(n, nh.quotient<T>(uh.at<T>(n), speed, n));
    }

    /* The normal force of order n. */
    template <class T> void press(int n)
    {
        const T X = T(IX), Z = T(IZ), one = n == 0;
        if (mu > 0)
            direct<T>(n);
        gyro.set(n, Z / X * wZ.at<T>(n) + spun.at<T>(n));
        const T slows = slow ? slow->angular<T>() * wX.at<T>(n) : T(0);
        still.set(n, -series::product<T>(wY, gyro, n) - slows); /* (78) */
        hinder.set(n, series::product<T>(nh, c, n));
        lever.set(n, s.at<T>(n) + T(mu) * hinder.at<T>(n));
        share.set(n, one + series::product<T>(s, lever, n) / X);
        const T weight = one - series::product<T>(wX, fall, n) -
                         series::product<T>(s, still, n);
        N.set(n, N.quotient<T>(weight, share, n)); /* (80) */
    }
};

#endif
