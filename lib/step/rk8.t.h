/* SPDX-License-Identifier: MIT */
/* The 12-stage formula of order 8 of Dormand and Prince, as in DOP853 (Hairer,
 * Norsett, Wanner, Solving Ordinary Differential Equations I), without its
 * error estimate; test_rk8 holds it against the conditions of order.
 *
 * For either form of the equations of motion: its users define RATES and
 * POSE_RATES, the slopes times h of the variables and of the pose, and
 * EACH_POSE(F), the members of the latter, and get rk8_sums().  Who defines
 * ERROR_TO(f, e5, e3) too is given, variable by variable, the two sums of
 * slopes that estimate a step's error (ibid., II.5). */
#include "progress.h"

#include "../motion/kind.h"

#ifndef RATES
#define RATES PRIV(rates)
#define POSE_RATES PRIV(pose_rates)
#define EACH_POSE(F) F(theta) F(phi) F(psi) F(x) F(z)
#endif

/* Rows of the tableau without their zeros: A5 holds a_51, a_53, a_54; from A6
 * on a_i1, a_i4, a_i5, ...; B holds b_1, b_6, ..., b_12. */
/* clang-format off */
static const scalar A2[] = {
    5.26001519587677318785587544488e-2,
};
static const scalar A3[] = {
    1.97250569845378994544595329183e-2,
    5.91751709536136983633785987549e-2,
};
static const scalar A4[] = {
    2.95875854768068491816892993775e-2,
    8.87627564304205475450678981324e-2,
};
static const scalar A5[] = {
    2.41365134159266685502369798665e-1,
    -8.84549479328286085344864962717e-1,
    9.24834003261792003115737966543e-1,
};
static const scalar A6[] = {
    3.7037037037037037037037037037e-2,
    1.70828608729473871279604482173e-1,
    1.25467687566822425016691814123e-1,
};
static const scalar A7[] = {
    3.7109375e-2,
    1.70252211019544039314978060272e-1,
    6.02165389804559606850219397283e-2,
    -1.7578125e-2,
};
static const scalar A8[] = {
    3.70920001185047927108779319836e-2,
    1.70383925712239993810214054705e-1,
    1.07262030446373284651809199168e-1,
    -1.53194377486244017527936158236e-2,
    8.27378916381402288758473766002e-3,
};
static const scalar A9[] = {
    6.24110958716075717114429577812e-1,
    -3.36089262944694129406857109825e0,
    -8.68219346841726006818189891453e-1,
    2.75920996994467083049415600797e1,
    2.01540675504778934086186788979e1,
    -4.34898841810699588477366255144e1,
};
static const scalar A10[] = {
    4.77662536438264365890433908527e-1,
    -2.48811461997166764192642586468e0,
    -5.90290826836842996371446475743e-1,
    2.12300514481811942347288949897e1,
    1.52792336328824235832596922938e1,
    -3.32882109689848629194453265587e1,
    -2.03312017085086261358222928593e-2,
};
static const scalar A11[] = {
    -9.3714243008598732571704021658e-1,
    5.18637242884406370830023853209e0,
    1.09143734899672957818500254654e0,
    -8.14978701074692612513997267357e0,
    -1.85200656599969598641566180701e1,
    2.27394870993505042818970056734e1,
    2.49360555267965238987089396762e0,
    -3.0467644718982195003823669022e0,
};
static const scalar A12[] = {
    2.27331014751653820792359768449e0,
    -1.05344954667372501984066689879e1,
    -2.00087205822486249909675718444e0,
    -1.79589318631187989172765950534e1,
    2.79488845294199600508499808837e1,
    -2.85899827713502369474065508674e0,
    -8.87285693353062954433549289258e0,
    1.23605671757943030647266201528e1,
    6.43392746015763530355970484046e-1,
};
static const scalar B[] = {
    5.42937341165687622380535766363e-2,
    4.45031289275240888144113950566e0,
    1.89151789931450038304281599044e0,
    -5.8012039600105847814672114227e0,
    3.1116436695781989440891606237e-1,
    -1.52160949662516078556178806805e-1,
    2.01365400804030348374776537501e-1,
    4.47106157277725905176885569043e-2,
};
#ifdef ERROR_TO
static const scalar E5[] = {
    1.312004499419488073250102996e-2,
    -1.225156446376204440720569753e0,
    -4.957589496572501915214079952e-1,
    1.664377182454986536961530415e0,
    -3.503288487499736816886487290e-1,
    3.341791187130174790297318841e-1,
    8.192320648511571246570742613e-2,
    -2.235530786388629525884427845e-2,
};
static const scalar E3[] = {
    2.44094488188976377952755905512e-1,
    7.33846688281611857341361741547e-1,
    2.20588235294117647058823529412e-2,
};
#endif
/* clang-format on */

/* The variables that slopes move, side by side: a row of the tableau
 * is the same sum for each, which gcc and clang then take in pairs, by the
 * baseline of every 64-bit processor, and to the same bits. */
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
typedef real lane;
#define AT(row, k) (row).v[k]
#define EACH(F) F(0) F(1) F(2) F(3) F(4) F(5) F(6) F(7)
#endif

/* With AVX the slopes of a row but the newest are summed in vectors of four, w,
 * before the newest is known.  The newest is added in pairs: moving it into
 * vectors of four and back would take longer than it saves. */
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
    lane v[8 * sizeof(real) / sizeof(lane)];
};
#define PART(d, m) (d).v[m]
#define WIDEN(r) (void)0
#define SUM_OLD(i) (void)0
#define OLD(i, m) (y0.v[m] + OLD##i(m))
#endif

/* The order was found by measurement: the members needed first come first. */
COIN_PRIV_INLINE struct row row_of(const PRIV(variables) * s)
{
    struct row r;
    AT(r, 0) = s->wX;
    AT(r, 1) = s->wZ;
    AT(r, 2) = s->cth;
    AT(r, 3) = s->sth;
    AT(r, 4) = s->q;
    AT(r, 5) = s->wY;
    AT(r, 6) = s->sph;
    AT(r, 7) = s->cph;
    WIDEN(r);
    return r;
}

COIN_PRIV_INLINE PRIV(variables) variables_of_row(const struct row *r)
{
    const PRIV(variables) s = {
        AT(*r, 0),
        AT(*r, 5),
        AT(*r, 1),
        AT(*r, 3),
        AT(*r, 2),
        AT(*r, 4),
        AT(*r, 4) * AT(*r, 3), /* q sin theta */
        AT(*r, 6),
        AT(*r, 7),
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

#define SUM_POSE(m)                                                            \
    adds->m = (B[0] * v1.m + B[1] * v6.m + B[2] * v7.m + B[3] * v8.m +         \
               B[4] * v9.m + B[5] * v10.m + B[6] * v11.m) +                    \
              B[7] * v12.m;

/* Stage i, where 13 is the end: its variables by row i, and its slopes; and the
 * sum of the older slopes of row j, the next.  PATH only where b_i is not 0. */
#define STAGE(i, j)                                                            \
    EACH(ROW##i)                                                               \
    SUM_OLD(j);                                                                \
    const PRIV(variables) s##i = variables_of_row(&y), k##i = RATES(f, &s##i); \
    const struct row d##i = row_of(&k##i);                                     \
    low = PRIV(lesser)(low, s##i.cth)
#define PATH(i) const PRIV(pose) v##i = POSE_RATES(f, &s##i)

#ifdef ERROR_TO
#define SUM_E5(m)                                                              \
    e5.v[m] = E5[0] * d1.v[m] + E5[1] * d6.v[m] + E5[2] * d7.v[m] +            \
              E5[3] * d8.v[m] + E5[4] * d9.v[m] + E5[5] * d10.v[m] +           \
              E5[6] * d11.v[m] + E5[7] * d12.v[m];
#define SUM_E3(m)                                                              \
    e3.v[m] = (y.v[m] - y0.v[m]) -                                             \
              (E3[0] * d1.v[m] + E3[1] * d9.v[m] + E3[2] * d12.v[m]);
#endif

/* One step h from *y1: the variables *end, each by its own sum, and what the
 * step adds to the pose; returns the least cos theta of its stages.  In each
 * row the newest slope is added last: the older part does not wait for it. */
COIN_PRIV_INLINE real rk8_sums(PRIV(variables) * end, PRIV(pose) * adds,
                               const PRIV(variables) * y1,
                               const PRIV(field) * f)
{
    const PRIV(variables) s1 = *y1, k1 = RATES(f, &s1);
    const struct row y0 = row_of(&s1), d1 = row_of(&k1);
    struct row y;
    real low = s1.cth;
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
#ifdef ERROR_TO
    struct row e5, e3;
    EACH(SUM_E5)
    EACH(SUM_E3)
    const PRIV(variables) by5 = variables_of_row(&e5);
    const PRIV(variables) by3 = variables_of_row(&e3);
    ERROR_TO(f, &by5, &by3);
#endif
    EACH_POSE(SUM_POSE)
    *end = variables_of_row(&y);
    return low;
}
