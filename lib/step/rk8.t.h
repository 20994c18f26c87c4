/* SPDX-License-Identifier: MIT */
/* The 12-stage formula of order 8 of Dormand and Prince, as in DOP853 (Hairer,
 * Norsett, Wanner, Solving Ordinary Differential Equations I), without its
 * error estimate; test_rk8 holds it against the conditions of order. */
#include "../motion/equations.h"

#include "../motion/kind.h"

#include "tableau.t.h"

/* The variables that have slopes, in one array.  A row of the tableau is the
 * same sum for each of them.  gcc and clang compute two such sums by one
 * instruction, which every 64-bit processor has, with the same bits. */
#if COIN_PRIV_WIDTH && !defined(COIN_PRIV_ABREAST)
typedef coin_pair lane;
#define AT(row, k) (row).v[(k) / 2][(k) % 2]
#define EACH(F) F(0) F(1) F(2) F(3)
#if defined(__AVX__) && defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define FOURS
#endif
#endif
#else
typedef number lane;
#define AT(row, k) (row).v[k]
#define EACH(F) F(0) F(1) F(2) F(3) F(4) F(5) F(6) F(7)
#endif

/* With AVX all slopes of a row but the newest are summed in vectors of four,
 * w[], before the newest is known.  The newest is added in vectors of two:
 * moving it into vectors of four and back would take longer than it saves. */
#ifdef FOURS
typedef double four COIN_PRIV_VECTOR(32);
struct row {
    lane v[4];
    four w[2];
};
#define PART(d, m) (d).w[m]
#define FOUR(r, m)                                                             \
    __builtin_shufflevector((r).v[2 * (m)], (r).v[2 * (m) + 1], 0, 1, 2, 3)
#define PAIR(f, k) __builtin_shufflevector(f, f, k, (k) + 1)
#define WIDEN(r) (r).w[0] = FOUR(r, 0), (r).w[1] = FOUR(r, 1)
#define SUM_OLD(i) y.w[0] = y0.w[0] + OLD##i(0), y.w[1] = y0.w[1] + OLD##i(1)
#define OLD(i, m) PAIR(y.w[(m) / 2], (m) % 2 * 2)
#else
struct row {
    lane v[8 * sizeof(number) / sizeof(lane)];
};
#define PART(d, m) (d).v[m]
#define WIDEN(r) (void)0
#define SUM_OLD(i) (void)0
#define OLD(i, m) (y0.v[m] + OLD##i(m))
#endif

/* The members needed first come first. */
COIN_PRIV_INLINE struct row row_of(const coin_priv_variables *s)
{
    struct row r;
    AT(r, 0) = s->wX;
    AT(r, 1) = s->wZ;
    AT(r, 2) = s->cth;
    AT(r, 3) = s->sth;
    AT(r, 4) = s->q;
    AT(r, 5) = s->wY;
    AT(r, 6) = s->cph;
    AT(r, 7) = s->sph;
    WIDEN(r);
    return r;
}

COIN_PRIV_INLINE coin_priv_variables variables_of_row(const struct row *r)
{
    const coin_priv_variables s = {
        AT(*r, 0),
        AT(*r, 5),
        AT(*r, 1),
        AT(*r, 3),
        AT(*r, 2),
        AT(*r, 4),
        AT(*r, 4) * AT(*r, 3), /* q sin theta */
        AT(*r, 7),
        AT(*r, 6),
    };
    return s;
}

#define OLD3(m) (A3[0] * PART(d1, m))

#define OLD4(m) (A4[0] * PART(d1, m))

#define OLD5(m) (A5[0] * PART(d1, m) + A5[1] * PART(d3, m))

#define OLD6(m) (A6[0] * PART(d1, m) + A6[1] * PART(d4, m))

#define OLD7(m)                                                                \
    (A7[0] * PART(d1, m) + A7[1] * PART(d4, m) + A7[2] * PART(d5, m))

#define OLD8(m)                                                                \
    (A8[0] * PART(d1, m) + A8[1] * PART(d4, m) + A8[2] * PART(d5, m) +         \
     A8[3] * PART(d6, m))

#define OLD9(m)                                                                \
    (A9[0] * PART(d1, m) + A9[1] * PART(d4, m) + A9[2] * PART(d5, m) +         \
     A9[3] * PART(d6, m) + A9[4] * PART(d7, m))

#define OLD10(m)                                                               \
    (A10[0] * PART(d1, m) + A10[1] * PART(d4, m) + A10[2] * PART(d5, m) +      \
     A10[3] * PART(d6, m) + A10[4] * PART(d7, m) + A10[5] * PART(d8, m))

#define OLD11(m)                                                               \
    (A11[0] * PART(d1, m) + A11[1] * PART(d4, m) + A11[2] * PART(d5, m) +      \
     A11[3] * PART(d6, m) + A11[4] * PART(d7, m) + A11[5] * PART(d8, m) +      \
     A11[6] * PART(d9, m))

#define OLD12(m)                                                               \
    (A12[0] * PART(d1, m) + A12[1] * PART(d4, m) + A12[2] * PART(d5, m) +      \
     A12[3] * PART(d6, m) + A12[4] * PART(d7, m) + A12[5] * PART(d8, m) +      \
     A12[6] * PART(d9, m) + A12[7] * PART(d10, m))

#define OLD13(m)                                                               \
    (B[0] * PART(d1, m) + B[1] * PART(d6, m) + B[2] * PART(d7, m) +            \
     B[3] * PART(d8, m) + B[4] * PART(d9, m) + B[5] * PART(d10, m) +           \
     B[6] * PART(d11, m))

#define ROW2(m) y.v[m] = y0.v[m] + A2[0] * d1.v[m];
#define ROW3(m) y.v[m] = OLD(3, m) + A3[1] * d2.v[m];
#define ROW4(m) y.v[m] = OLD(4, m) + A4[1] * d3.v[m];
#define ROW5(m) y.v[m] = OLD(5, m) + A5[2] * d4.v[m];
#define ROW6(m) y.v[m] = OLD(6, m) + A6[2] * d5.v[m];
#define ROW7(m) y.v[m] = OLD(7, m) + A7[3] * d6.v[m];
#define ROW8(m) y.v[m] = OLD(8, m) + A8[4] * d7.v[m];
#define ROW9(m) y.v[m] = OLD(9, m) + A9[5] * d8.v[m];
#define ROW10(m) y.v[m] = OLD(10, m) + A10[6] * d9.v[m];
#define ROW11(m) y.v[m] = OLD(11, m) + A11[7] * d10.v[m];
#define ROW12(m) y.v[m] = OLD(12, m) + A12[8] * d11.v[m];
#define SUM(m) y.v[m] = OLD(13, m) + B[7] * d12.v[m];

#define POSE_SUM(V, m)                                                         \
    ((B[0] * V(1, m) + B[1] * V(6, m) + B[2] * V(7, m) + B[3] * V(8, m) +      \
      B[4] * V(9, m) + B[5] * V(10, m) + B[6] * V(11, m)) +                    \
     B[7] * V(12, m))
#define NUMBER(i, m) v##i.m
#define SUM_POSE(m) adds->m = POSE_SUM(NUMBER, m);
#ifdef COIN_PRIV_TURN_BY_PAIRS
#define POINT(i, m) coin_pair_of(v##i.z, v##i.x)
#define SUM_PATH                                                               \
    const coin_pair path = POSE_SUM(POINT, );                                  \
    adds->z = path[0];                                                         \
    adds->x = path[1];
#else
#define SUM_PATH SUM_POSE(x) SUM_POSE(z)
#endif

/* Stage i: s##i are its variables, by row i of the tableau, and k##i their
 * slopes.  Row 13 is the end of the step.  With AVX the stage also sums all
 * slopes of row j, the next one, but the newest.  PATH is used only for stages
 * whose weight b_i is not 0. */
#define STAGE(i, j)                                                            \
    EACH(ROW##i)                                                               \
    SUM_OLD(j);                                                                \
    const coin_priv_variables s##i = variables_of_row(&y),                     \
                              k##i = coin_priv_slopes_at(f, &s##i);            \
    const struct row d##i = row_of(&k##i)
#define PATH(i) const coin_priv_pose v##i = coin_priv_pose_slopes(f, &s##i)

/* One step h from *y1.  Sets *end to the variables at its end, each by the sum
 * of its own slopes, and *adds to what the step adds to the pose.  In each row
 * the newest slope is added last, so that the sum of the others does not wait
 * for it. */
COIN_PRIV_INLINE void rk8_sums(coin_priv_variables *end, coin_priv_pose *adds,
                               const coin_priv_variables *y1,
                               const coin_priv_field *f)
{
    const coin_priv_variables s1 = *y1, k1 = coin_priv_slopes_at(f, &s1);
    const struct row y0 = row_of(&s1), d1 = row_of(&k1);
    struct row y;
    PATH(1);
    STAGE(2, 3);
    STAGE(3, 4);
    STAGE(4, 5);
    STAGE(5, 6);
    STAGE(6, 7);
    PATH(6);
    STAGE(7, 8);
    PATH(7);
    STAGE(8, 9);
    PATH(8);
    STAGE(9, 10);
    PATH(9);
    STAGE(10, 11);
    PATH(10);
    STAGE(11, 12);
    PATH(11);
    STAGE(12, 13);
    PATH(12);
    EACH(SUM)
    SUM_POSE(theta)
    SUM_POSE(phi)
    SUM_POSE(psi)
    SUM_PATH
    *end = variables_of_row(&y);
}

COIN_PRIV_INLINE void coin_priv_rk8_step(coin_priv_step_end *end,
                                         coin_priv_variables *next,
                                         const coin_priv_variables *y,
                                         const void *field)
{
    coin_priv_variables sums;
    rk8_sums(&sums, &end->adds, y, (const coin_priv_field *)field);
    end->wX = sums.wX;
    end->wY = sums.wY;
    end->wZ = sums.wZ;
    *next = coin_priv_variables_after(y, end);
}
