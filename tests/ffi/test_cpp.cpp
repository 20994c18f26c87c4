// SPDX-License-Identifier: MIT
// Errors become exceptions, outputs results.
#include "rollcoin.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <type_traits>
#include <vector>

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

// What a call throws.
#define THROWS(call, status) CHECK(thrown_by([&] { call; }) == (status))

static_assert(std::is_trivially_copyable<rollcoin::state>::value &&
                  std::is_standard_layout<rollcoin::state>::value,
              "the plain struct of coin.h");

using rollcoin::method;
static const auto p = rollcoin::disc(0.00567, 0.01213, 9.80665);
static const rollcoin::state start{0.3, 0, 0, 0, 0, 0, 5, 40};

static bool same(const rollcoin::state &a, const rollcoin::state &b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// A number that is NaN throws the status of the check that fails.
static void numbers()
{
    const rollcoin::params none{};
    const auto bad = [] {
        auto s = start;
        s.theta = 2;
        return s;
    }();
    rollcoin::losses dry{}, wrong{};
    dry.dry = 1e-7;
    wrong.dry = -1;

    THROWS(rollcoin::energy(start, none), COIN_EPARAMS);
    THROWS(rollcoin::critical_roll(none), COIN_EPARAMS);
    THROWS(rollcoin::critical_spin(none), COIN_EPARAMS);
    THROWS(rollcoin::losses_power(bad, p, wrong), COIN_EPARAMS);
    THROWS(rollcoin::time_to_rest(bad, p, wrong, 1e-6), COIN_EPARAMS);
    THROWS(rollcoin::time_to_rest(bad, p, dry, 1e-6), COIN_ESTATE);
    THROWS(rollcoin::time_to_rest(bad, p, wrong, 1), COIN_EARG);
    THROWS(rollcoin::check(none), COIN_EPARAMS);
    THROWS(rollcoin::check(bad, p), COIN_ESTATE);
    THROWS(rollcoin::check(wrong, p), COIN_EPARAMS);
}

static void batches()
{
    std::vector<rollcoin::state> coins(5, start);
    std::int32_t status[5];
    auto alone = start;

    coins[2].theta = 2;
    CHECK(thrown_by([&] {
              rollcoin::batch_run(coins, p, method::rk8, 1e-3, 9, status);
          }) == COIN_ESTATE);
    CHECK(status[2] == COIN_ESTATE && status[4] == 0);
    rollcoin::run(alone, p, method::rk8, 1e-3, 9);
    CHECK(same(coins[4], alone));
    CHECK(rollcoin::step(alone, p, 1e-2) == COIN_COARSE);
    coins = {};
    coins.shrink_to_fit();
    CHECK(rollcoin::batch_run(coins, p, method::rk8, 1e-3, 9) == 0);
    CHECK(rollcoin::sample(start, p, method::rk8, 1e-3, 5, 0).empty());
    CHECK(std::strcmp(rollcoin::name(method::rk8), "rk8") == 0);
}

static void observables()
{
    const auto q = rollcoin::rotation(start);
    const auto back =
        rollcoin::from_motion(p, q, rollcoin::angular_velocity(start), 0, 0);
    CHECK(std::fabs(back.theta - start.theta) < 1e-14);
    CHECK(std::fabs(back.wZ - start.wZ) < 1e-12);
    CHECK(rollcoin::rates(start, p).theta == start.wX);
    CHECK(rollcoin::contact(start, p).place[1] == 0);
    CHECK(std::fabs(rollcoin::axes(start)[7] + std::sin(start.theta)) < 1e-14);
    double K[2];
    CHECK(coin_integrals(&start, &p, K) == COIN_OK);
    CHECK(rollcoin::integrals(start, p)[1] == K[1]);
    CHECK(rollcoin::params_of(1, 1, 1, 0.25, 0.5).inertia_Z == 0.5);
}

static void games()
{
    auto s = start;
    double reached = 1;
    CHECK(rollcoin::matrix(s, p)[12] == s.x);
    const double most = rollcoin::reaction(s, p).ratio;
    rollcoin::advance(s, p, 0.05, 1e-9); // half a period of the lean
    rollcoin::table f{};
    f.mu_static = (most + rollcoin::reaction(s, p).ratio) / 2;
    auto b = rollcoin::body_of(s, p);
    CHECK(rollcoin::move(b, p, f, 1, 1e-9, COIN_SLIPS, &reached) == COIN_SLIPS);
    CHECK(reached < 0.06 &&
          std::fabs(rollcoin::reaction(b.s, p).ratio - f.mu_static) < 1e-6);
}

static void steady()
{
    const auto circle = rollcoin::steady_circle(p, 0.4, 30, 1);
    CHECK(rollcoin::stability(circle, p) < 0);
    CHECK(rollcoin::steady_radii(circle, p).contact >
          rollcoin::steady_radii(circle, p).center);
    CHECK(std::fabs(rollcoin::steady_at(circle, p, 0.1).theta - 0.4) < 1e-12);
    const auto turn = rollcoin::steady_turn(p, 0.4, 0.04);
    const auto ride = rollcoin::steady_ride(p, turn.wZ * p.radius, 0.04);
    CHECK(std::fabs(ride.theta - 0.4) < 1e-12);
    CHECK(rollcoin::steady_roll(p, 9).wZ == 9);
    CHECK(rollcoin::steady_upright_spin(p, 9).wY == 9);
    const double ratio =
        rollcoin::critical_spin(p) / rollcoin::critical_roll(p);
    CHECK(std::fabs(ratio * ratio - 2.4) < 1e-12);
}

static void orbits()
{
    static rollcoin::orbit o;
    auto s = start;
    THROWS(rollcoin::at(o, 0), COIN_EARG);
    rollcoin::init(o, s, p);
    rollcoin::advance(s, p, 0.5, 1e-13);
    CHECK(std::fabs(rollcoin::at(o, 0.5).theta - s.theta) < 1e-10);
}

static void rest()
{
    rollcoin::losses law{};
    law.viscous = 1e-9;
    auto s = rollcoin::steady_spin(p, 1.0);
    const auto l = rollcoin::losses_fit(law, s, p, 8);
    double reached = 0;
    CHECK(std::fabs(rollcoin::time_to_rest(s, p, l, 1e-6) - 8) < 0.08);
    CHECK(rollcoin::losses_power(s, p, l) > 0);
    CHECK(rollcoin::losses_rates(s, p, l).wY != rollcoin::rates(s, p).wY);
    CHECK(rollcoin::losses_reaction(s, p, l).R[0] !=
          rollcoin::reaction(s, p).R[0]);
    CHECK(rollcoin::settle(s, p, l, 60, 1e-6, &reached) == COIN_RESTS);
    CHECK(std::fabs(reached - 8) < 0.1);
}

static void bodies()
{
    rollcoin::table f{};
    f.mu_static = f.mu_kinetic = 0.5;
    rollcoin::check(f, p);
    auto d = rollcoin::body_of(start, p);
    CHECK(std::fabs(rollcoin::contact(d, p)[0]) < 1e-12);
    CHECK(rollcoin::matrix(d, p)[13] == d.y);
    CHECK(std::fabs(rollcoin::energy(d, p) - rollcoin::energy(start, p)) <
          1e-12);
    d.vx += 0.1;
    CHECK(std::fabs(rollcoin::reaction(d, p, f).ratio - 0.5) < 1e-9);
    CHECK(rollcoin::move(d, p, f, 1e-3, 1e-9) == COIN_SLIPS);
    CHECK(rollcoin::move(d, p, f, 1, 1e-9) == COIN_OK);
    CHECK(std::fabs(rollcoin::reaction(d, p, f).normal / (p.mass * p.gravity) -
                    1) < 0.5);
    d.s.theta = 2;
    THROWS(rollcoin::energy(d, p), COIN_ESTATE);
}

// A chip as thick as half its width: tossed, struck and on a slope.
static const auto chip = rollcoin::cylinder(0.005, 0.01, 0.01, 9.80665);

static rollcoin::table felt()
{
    rollcoin::table f{};
    f.mu_static = 0.4;
    f.mu_kinetic = 0.3;
    f.restitution = 0.2;
    f.losses.dry = f.losses.spin = 1e-2 * chip.mass * chip.gravity * 0.01;
    return f;
}

static rollcoin::body tossed(double theta, double wX)
{
    rollcoin::body b{};
    b.s.theta = theta;
    b.s.wX = wX;
    b.y = 0.03;
    b.vy = 0.5;
    return b;
}

static void ends_as(rollcoin::face face, double y, rollcoin::body b)
{
    const auto f = felt();
    const std::int32_t said =
        rollcoin::move(b, chip, f, HUGE_VAL, 1e-6, COIN_DECIDED);
    CHECK((said & COIN_DECIDED) != 0 && (said & COIN_RESTS) == 0);
    CHECK(rollcoin::face_of(b, chip) == face);
    CHECK(rollcoin::move(b, chip, f, HUGE_VAL, 1e-6) == COIN_RESTS);
    CHECK(rollcoin::face_of(b, chip) == face);
    CHECK(std::fabs(b.y - y) < 1e-12);
}

static void chips()
{
    CHECK(std::fabs(chip.inertia_X - 5e-7 / 3) < 1e-20);
    ends_as(rollcoin::face::heads, 0.005, tossed(-1, 0));
    ends_as(rollcoin::face::tails, 0.005, tossed(1, 0));
    ends_as(rollcoin::face::edge, 0.01, tossed(-1, 10));
    THROWS(rollcoin::cylinder(1, 1, 5, 1), COIN_EPARAMS);
    THROWS(rollcoin::energy(start, chip), COIN_EPARAMS);
    THROWS(rollcoin::fastest_rate(start, chip), COIN_EPARAMS);
    THROWS(rollcoin::critical_roll(chip), COIN_EPARAMS);
    THROWS(rollcoin::critical_spin(chip), COIN_EPARAMS);
    THROWS(rollcoin::face_of(tossed(2, 0), chip), COIN_ESTATE);
}

static void slope()
{
    auto f = felt();
    auto b = tossed(1, 0);
    rollcoin::move(b, chip, f, HUGE_VAL, 1e-6);
    f.pull[0] = 0.3 * chip.gravity;
    CHECK(rollcoin::move(b, chip, f, 0.1, 1e-9) == COIN_RESTS);
    f.pull[0] = 0.5 * chip.gravity;
    CHECK(rollcoin::move(b, chip, f, 0.1, 1e-9) == COIN_SLIPS);
    CHECK(std::fabs(b.vx - (0.5 - 0.3) * chip.gravity * 0.1) < 1e-9);
    THROWS(rollcoin::move(b, chip, f, 0.1, 1e-9, COIN_DECIDED), COIN_EARG);
}

static void blow()
{
    auto b = rollcoin::body_of(rollcoin::state{}, chip);
    rollcoin::strike(b, chip, {0, 0, 1e-3}, {0, chip.radius, 0});
    CHECK(std::fabs(b.vz - 1e-3 / chip.mass) < 1e-12);
    CHECK(std::fabs(b.s.wX - 1e-3 * chip.radius / chip.inertia_X) < 1e-9);
    const auto before = b;
    THROWS(rollcoin::strike(b, chip, {1e30, 0, 0}, {0, 0, 0}), COIN_ESTATE);
    CHECK(std::memcmp(&b, &before, sizeof b) == 0);
}

// Where one call of the library does not suffice, for a time and for ever.
static void far()
{
    rollcoin::losses l{};
    rollcoin::table f{};
    auto s = start;
    auto b = rollcoin::body_of(s, p);
    double reached = 0, part = 0;

    f.mu_static = HUGE_VAL;
    l.dry = 1e-15;
    CHECK(coin_move(&b, &p, &f, 1000, 1e-2, 0, &part) == COIN_MORE);
    CHECK(rollcoin::move(b, p, f, 1000, 1e-2, 0, &reached) == COIN_OK);
    CHECK(part < 900 && std::fabs(reached - 1000) < 1e-9);
    CHECK(rollcoin::move(b, p, f, HUGE_VAL, 1e-2, 0, &reached) == COIN_MORE);
    CHECK(reached > 90 * part && reached < 110 * part);
    CHECK(rollcoin::settle(s, p, l, 25000, 1e-2, &reached) == COIN_OK);
    CHECK(std::fabs(reached - 25000) < 1e-9);
    s = start;
    CHECK(coin_settle(&s, &p, &l, 25000, 1e-2, &part) == COIN_MORE);
    CHECK(rollcoin::advance(s, p, 40000, 1e-2, &reached) == COIN_OK);
    CHECK(std::fabs(reached - 40000) < 1e-9);
    s = start;
    CHECK(coin_advance(&s, &p, 40000, 1e-2, &part) == COIN_MORE);
    s.psi = 2147483647. - 20000;
    b = rollcoin::body_of(s, p);
    reached = 0;
    THROWS(rollcoin::move(b, p, f, 1000, 1e-2, 0, &reached), COIN_ERANGE);
    CHECK(reached > 400 && reached < 600);
}

int main()
{
    rollcoin::state s = start, bad = start;
    std::uint64_t done = 0;
    double reached = 0;
    bad.theta = 2;

    THROWS(rollcoin::disc(-1, 1, 1), COIN_EPARAMS);
    THROWS(rollcoin::ring(1, 1, 2, 1), COIN_EPARAMS);
    THROWS(rollcoin::run(s, p, method::rk4, 1, 1), COIN_ESTEP);
    CHECK(std::memcmp(&s, &start, sizeof s) == 0);
    THROWS(rollcoin::center(bad, p), COIN_ESTATE);
    THROWS(rollcoin::velocity(bad, p), COIN_ESTATE);
    THROWS(rollcoin::rotation(bad), COIN_ESTATE);
    THROWS(rollcoin::reaction(bad, p), COIN_ESTATE);
    THROWS(rollcoin::energy(bad, p), COIN_ESTATE);

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
    CHECK(rollcoin::fastest_rate(start, p) == coin_fastest_rate(&start, &p));
    numbers();
    batches();
    observables();
    games();
    steady();
    orbits();
    rest();
    bodies();
    chips();
    slope();
    blow();
    far();
    rollcoin::selftest();
    return failures != 0;
}
