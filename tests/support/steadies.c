/* SPDX-License-Identifier: MIT */
#include "steadies.h"

#include "check.h"

struct circle circle_at(const struct table *t, size_t row)
{
    const double theta = table_at(t, row, "theta");
    const double wZ = table_at(t, row, "wZ");
    const double wY = table_at(t, row, "wY_double");
    const struct circle c = {
        {table_at(t, row, "mass"),
         table_at(t, row, "radius"),
         table_at(t, row, "gravity"),
         table_at(t, row, "inertia_X"),
         table_at(t, row, "inertia_Z"),
         0,
         {0, 0}},
        theta,
        wZ,
        table_at(t, row, "branch") > 0 ? 1 : -1,
        wY,
        {theta, 0, 0, 0, 0, 0, wY, wZ},
    };
    check_note("row %zu of circles.csv", row);
    return c;
}
