/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "number.h"
#include "root.h"

double coin_priv_root(coin_priv_function *f, const void *of, coin_priv_place a,
                      coin_priv_place b, double width)
{
    int before = 0;
    /* Each fourth time the interval is halved, whatever the function does; and
     * where both its values have become 0 by underflow. */
    for (int i = 0; b.x - a.x > width; ++i) {
        double x = (a.x + b.x) / 2;
        if (i % 4 != 3 && a.at > b.at)
            x = a.x + (b.x - a.x) * (a.at / (a.at - b.at));
        x = x > a.x + width / 2 ? x : a.x + width / 2;
        x = coin_priv_lesser(x, b.x - width / 2);
        const double at = f(of, x);
        const int side = at < 0 ? -1 : 1;
        const coin_priv_place c = {x, at};
        if (side < 0) {
            a.at *= before == side ? 0.5 : 1; /* Illinois */
            b = c;
        } else {
            b.at *= before == side ? 0.5 : 1;
            a = c;
        }
        before = side;
    }
    return b.x;
}
