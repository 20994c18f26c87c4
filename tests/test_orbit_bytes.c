/* SPDX-License-Identifier: MIT */
/* What coin_orbit_at() makes of bytes that coin_orbit_init() of this version
 * did not write. */
#include "support/check.h"
#include "support/orbits.h"

#include "orbit.h"

#include <math.h>
#include <string.h>

static coin_orbit wobbling(void)
{
    const coin_state s = {0.1, 0, 0, 0, 0, 0, 0, 1};
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    return orbit_of(&s, &p);
}

/* Whatever its bytes, an orbit is not read beyond its end. */
TEST(bytes_that_are_no_orbit_do_no_harm)
{
    const coin_orbit o = wobbling();
    const double count = o.private_frame[COIN_PRIV_COUNT];
    const double bad[][2] = {
        {0, 0},      {-1, 0},        {43, 0},    {(double)NAN, 0},     {1e9, 0},
        {count, -1}, {count, count}, {1e9, 1e9}, {count, (double)NAN},
    };
    coin_state out, before;
    memset(&out, 0xa5, sizeof out);
    before = out;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        coin_orbit other = o;
        other.private_frame[COIN_PRIV_COUNT] = bad[i][0];
        other.private_frame[COIN_PRIV_BEFORE] = bad[i][1];
        check_note("%g pieces, %g of them back", bad[i][0], bad[i][1]);
        check_status(coin_orbit_at(&other, 1, &out), COIN_EARG);
        check_same(&out, &before, sizeof out);
    }
    coin_orbit noise;
    memset(&noise, 0xff, sizeof noise); /* all NaN */
    check_status(coin_orbit_at(&noise, 1, &out), COIN_EARG);
    noise.period = 0;
    check_status(coin_orbit_at(&noise, 1, &out), COIN_EARG);
    noise.private_frame[0] = o.private_frame[0];
    check_status(coin_orbit_at(&noise, 1, &out), COIN_ESTEP);
    noise = o; /* edges that no count goes with */
    memset(noise.private_edges, 0, sizeof noise.private_edges);
    noise.private_frame[COIN_PRIV_COUNT] = 20;
    noise.private_frame[COIN_PRIV_BEFORE] = 0;
    noise.private_terms[19 * COIN_PRIV_PIECE] = 0.25; /* of the last one */
    check_status(coin_orbit_at(&noise, 1, &out), COIN_OK);
    check(out.theta == 0.25);
}

/* The tag is that of the version: one release, major, minor or patch, later it
 * is another. */
TEST(an_orbit_of_another_version_is_refused)
{
    const int later[] = {1, 1 << 8, 1 << 16};
    const coin_orbit o = wobbling();
    const double version = coin_version(), all = 1 << 24;
    check(o.private_frame[0] == 2.2073158e-107 * (all + version));
    for (int i = 0; i < 3; ++i) {
        coin_orbit other = o;
        coin_state out, before;
        memset(&out, 0xa5, sizeof out);
        before = out;
        other.private_frame[0] *= (all + version + later[i]) / (all + version);
        check_status(coin_orbit_at(&other, 1, &out), COIN_EARG);
        check_same(&out, &before, sizeof out);
    }
}

/* A later version may give reserved members a meaning, if they are 0 today. */
TEST(spare_members_are_zero)
{
    static const coin_orbit zero;
    const coin_orbit o = wobbling();
    check_same(o.reserved, zero.reserved, sizeof o.reserved);
    check_same(o.private_spare, zero.private_spare, sizeof o.private_spare);
}
