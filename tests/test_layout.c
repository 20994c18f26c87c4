/* SPDX-License-Identifier: MIT */
/* The layout that programs are compiled against: eight doubles each, in this
 * order, no padding. */
#include "support/check.h"

#define D sizeof(double)

#define AT(type, member, place)                                                \
    {                                                                          \
#type "." #member, offsetof(type, member), (place)*D                   \
    }

static const struct {
    const char *name;
    size_t got, want;
} layout[] = {
    AT(coin_params, mass, 0),
    AT(coin_params, radius, 1),
    AT(coin_params, gravity, 2),
    AT(coin_params, inertia_X, 3),
    AT(coin_params, inertia_Z, 4),
    AT(coin_params, reserved, 5),
    AT(coin_state, theta, 0),
    AT(coin_state, phi, 1),
    AT(coin_state, psi, 2),
    AT(coin_state, x, 3),
    AT(coin_state, z, 4),
    AT(coin_state, wX, 5),
    AT(coin_state, wY, 6),
    AT(coin_state, wZ, 7),
    AT(coin_force, R, 0),
    AT(coin_force, normal, 3),
    AT(coin_force, friction, 4),
    AT(coin_force, ratio, 5),
    AT(coin_losses, damping, 0),
    AT(coin_losses, dry, 1),
    AT(coin_losses, viscous, 2),
    AT(coin_losses, layer, 3),
    AT(coin_losses, gap, 4),
    AT(coin_losses, rolling, 5),
    AT(coin_losses, spin, 6),
    AT(coin_losses, angular, 7),
    AT(coin_losses, soft, 8),
    AT(coin_losses, flat, 9),
    AT(coin_losses, reserved, 10),
    AT(coin_table, mu_static, 0),
    AT(coin_table, mu_kinetic, 1),
    AT(coin_table, restitution, 2),
    AT(coin_table, reserved, 3),
    AT(coin_table, losses, 8),
    AT(coin_body, s, 0),
    AT(coin_body, y, 8),
    AT(coin_body, vx, 9),
    AT(coin_body, vy, 10),
    AT(coin_body, vz, 11),
    AT(coin_body, reserved, 12),
    {"sizeof(coin_losses)", sizeof(coin_losses), 12 * D},
    {"sizeof(coin_table)", sizeof(coin_table), 20 * D},
    {"sizeof(coin_body)", sizeof(coin_body), 16 * D},
    {"sizeof(coin_params)", sizeof(coin_params), 8 * D},
    {"sizeof(coin_state)", sizeof(coin_state), 8 * D},
    {"sizeof(coin_force)", sizeof(coin_force), 6 * D},
};

TEST(every_member_has_its_place)
{
    for (size_t i = 0; i < sizeof layout / sizeof *layout; ++i) {
        check_note("%s: %zu, not %zu", layout[i].name, layout[i].got,
                   layout[i].want);
        check(layout[i].got == layout[i].want);
    }
}

static const struct {
    const char *name;
    int32_t got, want;
} constants[] = {
    {"COIN_OK", COIN_OK, 0},
    {"COIN_EPARAMS", COIN_EPARAMS, -1},
    {"COIN_ESTATE", COIN_ESTATE, -2},
    {"COIN_ESTEP", COIN_ESTEP, -3},
    {"COIN_EARG", COIN_EARG, -4},
    {"COIN_EDOMAIN", COIN_EDOMAIN, -5},
    {"COIN_EFLAT", COIN_EFLAT, -6},
    {"COIN_EBUILD", COIN_EBUILD, -7},
    {"COIN_ERANGE", COIN_ERANGE, -9},
    {"COIN_SLIPS", COIN_SLIPS, 1},
    {"COIN_LIFTS", COIN_LIFTS, 2},
    {"COIN_COARSE", COIN_COARSE, 4},
    {"COIN_NEARLY_FLAT", COIN_NEARLY_FLAT, 8},
    {"COIN_RESTS", COIN_RESTS, 16},
    {"COIN_ROLLS", COIN_ROLLS, 32},
    {"COIN_TOUCHES", COIN_TOUCHES, 64},
    {"COIN_RK4", COIN_RK4, 0},
    {"COIN_RK8", COIN_RK8, 1},
    {"COIN_SYMPLECTIC2", COIN_SYMPLECTIC2, 2},
    {"COIN_SYMPLECTIC4", COIN_SYMPLECTIC4, 3},
};

TEST(every_constant_has_its_number)
{
    for (size_t i = 0; i < sizeof constants / sizeof *constants; ++i) {
        check_note("%s: %d, not %d", constants[i].name, (int)constants[i].got,
                   (int)constants[i].want);
        check(constants[i].got == constants[i].want);
    }
}
