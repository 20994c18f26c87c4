// SPDX-License-Identifier: MIT
// Errors become exceptions, outputs results.
#include "rollcoin.hpp"

#include <cstdio>
#include <cstring>
#include <type_traits>

static int failures;

static void check(bool holds, const char *what)
{
    if (!holds)
        std::fprintf(stderr, "does not hold: %s\n", what);
    failures += !holds;
}
#define CHECK(condition) check(condition, #condition)

template <class Call> static std::int32_t thrown_by(Call call)
{
    try {
        call();
    } catch (const rollcoin::error &e) {
        CHECK(std::strcmp(e.what(), coin_status_string(e.status())) == 0);
        return e.status();
    }
    return COIN_OK;
}

template <class Call> static bool refused(Call call)
{
    try {
        call();
    } catch (const std::invalid_argument &) {
        return true;
    }
    return false;
}

static_assert(std::is_trivially_copyable<rollcoin::state>::value &&
                  std::is_standard_layout<rollcoin::state>::value,
              "the plain struct of coin.h");

int main()
{
    using rollcoin::method;
    const auto p = rollcoin::disc(0.00567, 0.01213, 9.80665);
    const rollcoin::state start{0.3, 0, 0, 0, 0, 0, 5, 40};
    rollcoin::state s = start, bad = start;
    std::uint64_t done = 0;
    double reached = 0;
    bad.theta = 2;

    CHECK(thrown_by([] { rollcoin::disc(-1, 1, 1); }) == COIN_EPARAMS);
    CHECK(thrown_by([] { rollcoin::ring(1, 1, 2, 1); }) == COIN_EPARAMS);
    CHECK(thrown_by([&] { rollcoin::run(s, p, method::rk4, 1, 1); }) ==
          COIN_ESTEP);
    CHECK(std::memcmp(&s, &start, sizeof s) == 0);
    CHECK(thrown_by([&] { rollcoin::center(bad, p); }) == COIN_ESTATE);
    CHECK(thrown_by([&] { rollcoin::velocity(bad, p); }) == COIN_ESTATE);
    CHECK(thrown_by([&] { rollcoin::rotation(bad); }) == COIN_ESTATE);
    CHECK(thrown_by([&] { rollcoin::reaction(bad, p); }) == COIN_ESTATE);
    CHECK(refused([&] { rollcoin::energy(bad, p); }));

    CHECK(rollcoin::run(s, p, method::rk8, 1e-2, 10, &done) == 0);
    CHECK(done == 10);
    CHECK(rollcoin::run(s, p, method::rk4, 1e-2, 1) == COIN_COARSE);
    CHECK(rollcoin::advance(s, p, 0.01, 1e-9, &reached) == 0);
    CHECK(reached == 0.01);
    CHECK(rollcoin::validity(start, p, method::rk4, 1e-3, 0.01) == COIN_SLIPS);

    s = start;
    rollcoin::run(s, p, method::rk8, 1e-3, 10);
    const auto path = rollcoin::sample(start, p, method::rk8, 1e-3, 5, 3);
    CHECK(path.size() == 3);
    CHECK(std::memcmp(&path[2], &s, sizeof s) == 0);
    CHECK(rollcoin::center(start, p)[0] == start.x);
    CHECK(rollcoin::rotation(start)[0] > 0.9);
    CHECK(rollcoin::energy(start, p) == coin_energy(&start, &p));
    return failures != 0;
}
