/* SPDX-License-Identifier: MIT */
/* A body off the table by Newton and Euler: a quaternion, Euler's equations in
 * the axes of the body, Taylor series in steps; an impulse at the lowest point
 * by its matrix in the table's frame.  Natural units. */
#ifndef ROLLCOIN_ADVERSARY_NEWTON_HPP
#define ROLLCOIN_ADVERSARY_NEWTON_HPP

#include "number.hpp"

#include <coin.h>

template <class R> class newton
{
  public:
    R IX, IZ, w[3], r[3], v[3]; /* w along the body's axes */
    R A[3][3];                  /* body to table */

    newton(const coin_params &p, const coin_body &b)
    {
        const R a = p.radius, w0 = root(p.gravity / a), m = R(p.mass) * a * a;
        IX = p.inertia_X / m;
        IZ = p.inertia_Z / m;
        turn_from(b.s);
        const R cps = cosine(R(b.s.psi)), sps = sine(R(b.s.psi));
        const R wX = b.s.wX / w0, wY = b.s.wY / w0;
        w[0] = cps * wX + sps * wY;
        w[1] = cps * wY - sps * wX;
        w[2] = b.s.wZ / w0;
        const R at[] = {b.s.x, b.y, b.s.z}, by[] = {b.vx, b.vy, b.vz};
        for (int i = 0; i < 3; ++i) {
            r[i] = at[i] / a;
            v[i] = by[i] / (a * w0);
        }
    }

    void fly(R t)
    {
        while (t > 0) {
            const R h = lesser(t, R(0.5) / (1 + speed()));
            step(h);
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
        const R *const n[] = {&A[0][2], &A[1][2], &A[2][2]};
        const R h = root(*n[0] * *n[0] + *n[2] * *n[2]);
        R om[3];
        d[0] = *n[1] * *n[0] / h;
        d[1] = -h;
        d[2] = *n[1] * *n[2] / h;
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
    static constexpr int ORDER = 28; /* 0.5^28/28! is 1e-38 */

    void turn_from(const coin_state &s)
    {
        const R sth = sine(R(s.theta)), cth = cosine(R(s.theta));
        const R sph = sine(R(s.phi)), cph = cosine(R(s.phi));
        const R sps = sine(R(s.psi)), cps = cosine(R(s.psi));
        const R X[] = {cph, 0, -sph}, Y[] = {sth * sph, cth, sth * cph};
        const R Z[] = {cth * sph, -sth, cth * cph};
        for (int i = 0; i < 3; ++i) {
            A[i][0] = cps * X[i] + sps * Y[i];
            A[i][1] = cps * Y[i] - sps * X[i];
            A[i][2] = Z[i];
        }
    }

    /* The series of w, and of each row of A: A' = A times w. */
    void step(R h)
    {
        R cw[3][ORDER + 1], cA[3][3][ORDER + 1];
        for (int i = 0; i < 3; ++i) {
            cw[i][0] = w[i];
            for (int j = 0; j < 3; ++j)
                cA[i][j][0] = A[i][j];
        }
        const R part = (IX - IZ) / IX;
        const auto times = [](const R *a, const R *b, int k) {
            R sum = 0;
            for (int i = 0; i <= k; ++i)
                sum += a[i] * b[k - i];
            return sum;
        };
        for (int k = 0; k < ORDER; ++k) {
            cw[0][k + 1] = part * times(cw[1], cw[2], k) / (k + 1);
            cw[1][k + 1] = -part * times(cw[0], cw[2], k) / (k + 1);
            cw[2][k + 1] = 0;
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) {
                    const int l = (j + 1) % 3, m = (j + 2) % 3;
                    cA[i][j][k + 1] = (times(cA[i][l], cw[m], k) -
                                       times(cA[i][m], cw[l], k)) /
                                      (k + 1);
                }
        }
        const auto at = [h](const R *c) {
            R sum = c[ORDER];
            for (int k = ORDER - 1; k >= 0; --k)
                sum = sum * h + c[k];
            return sum;
        };
        for (int i = 0; i < 3; ++i) {
            w[i] = at(cw[i]);
            for (int j = 0; j < 3; ++j)
                A[i][j] = at(cA[i][j]);
            r[i] += v[i] * h - (i == 1 ? h * h / 2 : 0);
        }
        v[1] -= h;
    }
};

#endif
