/* SPDX-License-Identifier: MIT */
/* A body off the table by Newton and Euler: its axes and Euler's equations in
 * them, extrapolated; an impulse at the lowest point in the table's frame.
 * Natural units. */
#ifndef ROLLCOIN_ADVERSARY_NEWTON_HPP
#define ROLLCOIN_ADVERSARY_NEWTON_HPP

#include "midpoint.hpp"
#include "truth.hpp"

#include <coin.h>

template <class R> class newton
{
  public:
    R IX, IZ, w[3], r[3], v[3]; /* w along the body's axes */
    R A[3][3];                  /* body to table */

    newton(const coin_params &p, const coin_body &b)
    {
        const moment<R> y(p, b.s);
        const R w0 = root(y.g / y.a), cps = cosine(y.psi), sps = sine(y.psi);
        const R at[] = {b.s.x, b.y, b.s.z}, by[] = {b.vx, b.vy, b.vz};
        const R X[] = {y.cph, 0, -y.sph};
        const R Y[] = {y.s * y.sph, y.c, y.s * y.cph};
        const R Z[] = {y.c * y.sph, -y.s, y.c * y.cph};
        IX = y.IX / y.m;
        IZ = y.IZ / y.m;
        w[0] = (cps * y.wX + sps * y.wY) / w0;
        w[1] = (cps * y.wY - sps * y.wX) / w0;
        w[2] = y.wZ / w0;
        for (int i = 0; i < 3; ++i) {
            A[i][0] = cps * X[i] + sps * Y[i];
            A[i][1] = cps * Y[i] - sps * X[i];
            A[i][2] = Z[i];
            r[i] = at[i] / y.a;
            v[i] = by[i] / (y.a * w0);
        }
    }

    void fly(R t)
    {
        while (t > 0) {
            const R h = lesser(t, R(0.5) / (1 + speed()));
            turn(h);
            for (int i = 0; i < 3; ++i)
                r[i] += v[i] * h - (i == 1 ? h * h / 2 : R(0));
            v[1] -= h;
            t -= h;
        }
    }

    R speed() const
    {
        return root(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    }

    /* The height of the lowest point of the rim. */
    R gap() const
    {
        return r[1] - root(A[0][2] * A[0][2] + A[2][2] * A[2][2]);
    }

    /* The angular velocity in the table's frame. */
    void omega(R to[3]) const
    {
        for (int i = 0; i < 3; ++i)
            to[i] = A[i][0] * w[0] + A[i][1] * w[1] + A[i][2] * w[2];
    }

    /* From the centre to the lowest point, and its velocity. */
    void lowest(R d[3], R u[3]) const
    {
        const R n[] = {A[0][2], A[1][2], A[2][2]};
        const R h = root(n[0] * n[0] + n[2] * n[2]);
        R om[3];
        d[0] = n[1] * n[0] / h;
        d[1] = -h;
        d[2] = n[1] * n[2] / h;
        omega(om);
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            u[i] = v[i] + om[j] * d[k] - om[k] * d[j];
        }
    }

    /* Column j of the matrix from an impulse at the lowest point to the change
     * of its velocity. */
    void answer(R column[3], int j) const
    {
        newton by = *this;
        R d[3], u0[3], u1[3], p[3] = {};
        p[j] = 1;
        lowest(d, u0);
        by.push(p);
        by.lowest(d, u1);
        for (int i = 0; i < 3; ++i)
            column[i] = u1[i] - u0[i];
    }

    /* An impulse at the lowest point. */
    void push(const R p[3])
    {
        const R I[] = {IX, IX, IZ};
        R d[3], u[3], torque[3];
        lowest(d, u);
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            v[i] += p[i];
            torque[i] = d[j] * p[k] - d[k] * p[j];
        }
        for (int i = 0; i < 3; ++i)
            w[i] += (A[0][i] * torque[0] + A[1][i] * torque[1] +
                     A[2][i] * torque[2]) /
                    I[i];
    }

  private:
    /* w, and the rows of A: A' = A times w.  In a step of half a radian of the
     * fastest rate the extrapolation ends. */
    void turn(R h)
    {
        using vector = std::array<R, 12>;
        vector y, sizes, change = {};
        sizes.fill(1);
        for (size_t i = 0; i < 12; ++i)
            y[i] = i < 3 ? w[i] : A[i / 3 - 1][i % 3];
        sizes[0] = sizes[1] = sizes[2] = 1 + speed();
        const auto rates = [&](const vector &by, vector &d) {
            vector q;
            for (size_t i = 0; i < 12; ++i)
                q[i] = y[i] + by[i];
            d[0] = (IX - IZ) / IX * q[1] * q[2];
            d[1] = (IZ - IX) / IX * q[0] * q[2];
            d[2] = 0;
            for (size_t i = 3; i < 12; ++i) {
                const size_t row = i / 3 * 3, l = (i + 1) % 3, m = (i + 2) % 3;
                d[i] = q[row + l] * q[m] - q[row + m] * q[l];
            }
        };
        extrapolated<R, 12>(rates, sizes, h, change);
        for (size_t i = 0; i < 12; ++i)
            (i < 3 ? w[i] : A[i / 3 - 1][i % 3]) += change[i];
    }
};

#endif
