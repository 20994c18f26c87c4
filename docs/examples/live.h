/* SPDX-License-Identifier: MIT */
/* live.h: plays a motion in a terminal, on a grid of braille dots (POSIX). */
#include <signal.h>
#include <time.h>
#include <unistd.h>

enum { ACROSS = 78, DOWN = 19 }; /* characters of 2 x 4 dots each */

/* An interrupt gives the cursor back. */
static void live_stop(int number)
{
    _exit(write(1, "\033[m\033[?25h\n", 10) < 0 ? 1 : 128 + number);
}

static void centre_of(const motion *m, size_t k, double r[3])
{
    coin_center(&m->at[k].state, &m->params, r);
    if (m->slides)
        r[1] = m->at[k].y;
}

/* How far down a point is, seen from the front at a slant. */
static double live_down(const double r[3])
{
    return 0.6 * r[2] - 0.8 * r[1];
}

static void live_fit(svg_panel *v, const motion *m)
{
    const double a = m->params.radius;

    for (size_t k = 0; k < m->count; ++k) {
        double r[3];
        centre_of(m, k, r);
        v->left = fmin(v->left, r[0] - a);
        v->right = fmax(v->right, r[0] + a);
        v->top = fmin(v->top, live_down(r) - a);
        v->bottom = fmax(v->bottom, live_down(r) + a);
    }
    svg_equal_aspect(v);
}

static void live_dot(int dots[DOWN][ACROSS], const svg_panel *v,
                     const double r[3], int colour)
{
    static const int BIT[4][2] = {{1, 8}, {2, 16}, {4, 32}, {64, 128}};
    const int i = (int)svg_x(v, r[0]), j = (int)svg_y(v, live_down(r));

    dots[j / 4][i / 2] |= BIT[j % 4][i % 2] | colour;
}

/* The trail up to a moment, and the coin there with a radius that rolls. */
static void live_draw(const motion *m, size_t now, const svg_panel *v)
{
    const coin_state *s = &m->at[now].state;
    int dots[DOWN][ACROSS] = {{0}};
    double r[3], R[9];

    for (size_t k = 0; k <= now; ++k) {
        coin_contact(&m->at[k].state, &m->params, r, R);
        if (!flies(m, k))
            live_dot(dots, v, r, 0);
    }
    coin_axes(s, R);
    for (int k = 0; k < 420; ++k) {
        const double t = k < 360 ? k / DEGREES : s->psi;
        const double a = m->params.radius * (k < 360 ? 1 : (k - 360) / 60.0);
        centre_of(m, now, r);
        for (int i = 0; i < 3; ++i)
            r[i] += a * (cos(t) * R[i] + sin(t) * R[3 + i]);
        live_dot(dots, v, r, 256);
    }
    for (int j = 0; j < DOWN; ++j, puts("\033[m"))
        for (int i = 0; i < ACROSS; ++i)
            printf("\033[3%dm\342%c%c", dots[j][i] / 256 ? 3 : 6,
                   0xA0 + dots[j][i] % 256 / 64, 0x80 + dots[j][i] % 64);
}

/* Plays it, below what print() writes. */
static void live(const motion *m, const options *o,
                 void (*print)(const motion *, const options *, size_t now))
{
    const double unit = sqrt(m->params.radius / m->params.gravity);
    const size_t frames = 1 + (size_t)(5 * m->at[m->count - 1].t / unit);
    svg_panel v = {0, 0, 2 * ACROSS - 1, 4 * DOWN - 1, 9e9, -9e9, 9e9, -9e9};

    live_fit(&v, m);
    setvbuf(stdout, NULL, _IOFBF, 1 << 16);
    signal(SIGINT, live_stop);
    for (size_t f = 0; f <= frames; ++f) {
        printf("\033[?25l\033[2J\033[H");
        print(m, o, f * (m->count - 1) / frames);
        live_draw(m, f * (m->count - 1) / frames, &v);
        fflush(stdout);
        nanosleep(&(struct timespec){0, 33000000}, NULL);
    }
    puts("\033[?25h");
}
