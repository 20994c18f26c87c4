/* SPDX-License-Identifier: MIT */
/* A coin that is let go nearly flat, heads up, and does not turn: from which
 * heights does it land heads, and from which tails?  A problem of the
 * International Young Physicists' Tournament of 1997.
 *
 * Its lower edge hits first, which sets it turning; the faster the higher it
 * fell.  Heights are those of the centre above the table, in radii. */
#include "luck.h"

#include <math.h>
#include <stdlib.h>

/* A lean from flat, rad, and what it hits with. */
static struct luck_end dropped(double height, double lean, double restitution)
{
    const coin_params p = luck_disc();
    const coin_table table = luck_table(restitution);
    coin_body b = luck_flat(height + sin(lean), 0);
    b.s.theta += lean;
    return luck_toss(b, &p, &table, 1e-6);
}

static struct luck_end cell(const void *of, double height, double restitution)
{
    (void)of;
    return dropped(height, 2 * LUCK_FLAT / 90, restitution);
}

/* ------------------------------------------------------------------- bands */
/* The heights at which the side changes, of a lean of 2 degrees: each is
 * bisected. */
static double border(double low, double high, double lean, double restitution)
{
    const int heads = dropped(low, lean, restitution).heads;
    for (int k = 0; k < 25; ++k) {
        const double middle = (low + high) / 2;
        if (dropped(middle, lean, restitution).heads == heads)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static void bands(struct luck *l, double lean, double restitution, double step)
{
    int heads = 1, count = 0;
    for (double height = 0; height < 100; height += step) {
        const int now = dropped(height + step, lean, restitution).heads;
        if (now != heads) {
            if (++count <= 6)
                luck_number("border, radii", restitution, count,
                            border(height, height + step, lean, restitution), 0,
                            1);
        }
        heads = now;
    }
    luck_number("borders to 100 radii", restitution, lean, count, 0,
                (int)(100 / step));
    luck_claim(l, dropped(0.5, lean, restitution).heads,
               "heads where it cannot stand up");
}

/* ------------------------------------------------------------------- hands */
struct hand {
    int *heads;
    double height, restitution;
    unsigned draw;
};

/* A hand that does not hold it quite flat: a lean to 5 degrees. */
static void let_go(void *of, int i)
{
    struct hand *h = of;
    const double lean = luck_random(i, h->draw, 0, LUCK_FLAT / 18);
    const double height = h->height * luck_random(i, h->draw + 1, 0.95, 1.05);
    h->heads[i] = dropped(height, lean, h->restitution).heads;
}

static void hands(struct luck *l, int n)
{
    struct hand h = {malloc((size_t)n * sizeof(int)), 0, 0.5, 0};
    if (!h.heads)
        exit(1);
    for (h.height = 0.5; h.height < 300; h.height *= 1.4142135623730951) {
        int heads = 0;
        h.draw += 2;
        luck_each(n, let_go, &h);
        for (int i = 0; i < n; ++i)
            heads += h.heads[i];
        /* One that cannot stand up shows heads. */
        luck_share(l, "let go within 5 degrees of flat", h.height, 0.5, heads,
                   n, h.height < 0.8 ? 1 : (double)NAN);
    }
    free(h.heads);
}

void luck_study(struct luck *l)
{
    static const struct luck_map map = {"restitution", 600,  300, 0, 100, 0,
                                        0.9,           cell, NULL};
    if (l->map) {
        luck_draw(&map);
        return;
    }
    const double degree = LUCK_FLAT / 90;
    bands(l, 2 * degree, 0.3, l->small ? 0.1 : 0.01);
    bands(l, 2 * degree, 0.5, l->small ? 0.1 : 0.01);
    bands(l, 2 * degree, 0.7, l->small ? 0.1 : 0.01);
    hands(l, luck_count(l, 20000, 1000));
}
