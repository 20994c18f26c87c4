/* SPDX-License-Identifier: MIT */
/* live.h: plays a motion in a terminal, on a grid of braille dots (POSIX). */
#include <signal.h>
#include <time.h>
#include <unistd.h>

enum { ACROSS = 78, DOWN = 19 }; /* characters of 2 x 4 dots each */
enum { FRAMES = 30 };            /* in a second */
enum { SLOWER = 4 };             /* than a quarter is */

/* What a character shows: of several, the last of these. */
enum { TABLE, SHADOW, OLD, TRAIL, TAILS, HEADS };
static const char *const COLOURS[] = {"90", "90", "34", "36", "37", "33"};

typedef struct screen {
    int dots[DOWN][ACROSS], shows[DOWN][ACROSS];
    svg_panel view;
    double left, right, far, near; /* of the table: x and z */
} screen;

/* An interrupt gives the cursor back. */
static void live_stop(int number)
{
    _exit(write(1, "\033[?2026l\033[m\033[?25h\n", 18) < 0 ? 1 : 128 + number);
}

/* Whether the terminal can do what live() asks of it. */
static int live_can(void)
{
    const char *term = getenv("TERM");

    return term == NULL || strcmp(term, "dumb") != 0;
}

static void centre_of(const motion *m, size_t k, double r[3])
{
    const coin_state *s = &m->at[k].state;

    r[0] = s->x;
    r[1] = m->slides ? m->at[k].y : m->params.radius * cos(s->theta);
    r[2] = s->z;
}

/* How far down a point is, seen from the front at a slant. */
static double live_down(const double r[3])
{
    return 0.6 * r[2] - 0.8 * r[1];
}

/* The table reaches half a coin beyond where the coins are. */
static void live_fit(screen *s, const motion *m)
{
    const double a = m->params.radius, beyond = 1.5 * a;
    svg_panel *v = &s->view;

    s->left = s->far = v->top = 9e9;
    s->right = s->near = -9e9;
    for (size_t k = 0; k < m->count; ++k) {
        double r[3];
        centre_of(m, k, r);
        s->left = fmin(s->left, r[0] - beyond);
        s->right = fmax(s->right, r[0] + beyond);
        s->far = fmin(s->far, r[2] - beyond);
        s->near = fmax(s->near, r[2] + beyond);
        v->top = fmin(v->top, live_down(r) - a);
    }
    v->left = s->left;
    v->right = s->right;
    v->top = fmin(v->top, 0.6 * s->far);
    v->bottom = 0.6 * s->near;
    svg_equal_aspect(v);
}

/* Lights the dot of a point, if it is one of those that `every` leaves: 1 all,
 * 2 every other, 3 one of four; 0 puts it out. */
static void live_dot(screen *s, const double r[3], int what, int every)
{
    static const int BIT[4][2] = {{1, 8}, {2, 16}, {4, 32}, {64, 128}};
    const int i = (int)svg_x(&s->view, r[0]);
    const int j = (int)svg_y(&s->view, live_down(r));
    const int left = every <= 1 || (every == 2 && (i + j) % 2 == 0) ||
                     (every == 3 && i % 2 == 0 && j % 2 == 0);

    if (!left || i < 0 || i >= 2 * ACROSS || j < 0 || j >= 4 * DOWN)
        return;
    s->dots[j / 4][i / 2] |= BIT[j % 4][i % 2];
    if (every == 0)
        s->dots[j / 4][i / 2] ^= BIT[j % 4][i % 2];
    if (s->shows[j / 4][i / 2] < what)
        s->shows[j / 4][i / 2] = what;
}

static void live_table(screen *s)
{
    for (int k = 0; k <= 400; ++k) {
        const double x = s->left + (s->right - s->left) * k / 400;
        const double z = s->far + (s->near - s->far) * k / 400;
        const double edges[4][3] = {
            {x, 0, s->far}, {x, 0, s->near}, {s->left, 0, z}, {s->right, 0, z}};
        for (int edge = 0; edge < 4; ++edge)
            live_dot(s, edges[edge], TABLE, 2);
    }
}

/* The newest sixth of the trail, and a third that fades. */
static void live_trail(screen *s, const motion *m, size_t now)
{
    const size_t part = m->count / 6 + 1;

    for (size_t k = now > 3 * part ? now - 3 * part : 0; k <= now; ++k) {
        const size_t age = (now - k) / part;
        double r[3] = {0, 0, 0}, xz[2];
        table_point(m, k, CONTACT, xz);
        r[0] = xz[0];
        r[2] = xz[1];
        if (flies(m, k))
            centre_of(m, k, r);
        live_dot(s, r, age == 0 ? TRAIL : OLD, 1 + (int)age);
    }
}

/* A circle on the coin; its shadow is straight below. */
static void live_circle(screen *s, const motion *m, size_t now, double radius,
                        int what, int every)
{
    double R[9];

    coin_axes(&m->at[now].state, R);
    for (int k = 0; k < 360; ++k) {
        double r[3];
        centre_of(m, now, r);
        for (int i = 0; i < 3; ++i)
            r[i] += radius *
                    (cos(k / DEGREES) * R[i] + sin(k / DEGREES) * R[3 + i]);
        if (what == SHADOW)
            r[1] = 0;
        live_dot(s, r, what, every);
    }
}

/* The coin: its rim, a radius that rolls, and a ring on heads, if that side is
 * seen.  It hides what is behind. */
static void live_coin(screen *s, const motion *m, size_t now)
{
    const double a = m->params.radius;
    const coin_state *state = &m->at[now].state;
    double R[9];

    coin_axes(state, R);
    const int heads = 0.8 * R[7] + 0.6 * R[8] > 0, what = heads ? HEADS : TAILS;
    for (int k = 1; k <= 30; ++k)
        live_circle(s, m, now, a * k / 30, SHADOW, 2);
    for (int k = 1; k <= 30; ++k)
        live_circle(s, m, now, a * k / 30, what, 0);
    live_circle(s, m, now, a, what, 1);
    if (heads)
        live_circle(s, m, now, 0.55 * a, what, 1);
    for (int k = 0; k < 60; ++k) {
        double r[3];
        centre_of(m, now, r);
        for (int i = 0; i < 3; ++i)
            r[i] += a * k / 60 *
                    (cos(state->psi) * R[i] + sin(state->psi) * R[3 + i]);
        live_dot(s, r, what, 1);
    }
}

static void live_show(const screen *s)
{
    const char *off = getenv("NO_COLOR");
    const int plain = off != NULL && *off != '\0';

    for (int j = 0; j < DOWN; ++j, puts(plain ? "\033[K" : "\033[m\033[K"))
        for (int i = 0, before = -1; i < ACROSS; ++i) {
            const int dots = s->dots[j][i];
            if (!plain && dots != 0 && s->shows[j][i] != before)
                printf("\033[%sm", COLOURS[before = s->shows[j][i]]);
            printf("\342%c%c", 0xA0 + dots / 64, 0x80 + dots % 64);
        }
}

static void live_frame(const motion *m, size_t now, const screen *empty)
{
    static screen s;

    s = *empty;
    live_table(&s);
    live_trail(&s, m, now);
    live_coin(&s, m, now);
    live_show(&s);
}

/* Plays it, below what print() writes: four lines, and how fast.  A frame is
 * written over the last, in one piece. */
static void live(const motion *m, const options *o,
                 void (*print)(const motion *, const options *, size_t now))
{
    const double second =
        m->scene->body->in == &SI ? 1 : sqrt(QUARTER.gravity / QUARTER.radius);
    const size_t frames =
        1 + (size_t)(m->at[m->count - 1].t / second * SLOWER * FRAMES);
    screen empty = {.view = {0, 0, 2 * ACROSS - 1, 4 * DOWN - 1, 0, 0, 0, 0}};

    live_fit(&empty, m);
    setvbuf(stdout, NULL, _IOFBF, 1 << 16);
    signal(SIGINT, live_stop);
    printf("\033[2J");
    for (size_t f = 0; f <= frames; ++f) {
        printf(
            "\033[?25l\033[?2026h\033[H\033[K\n\033[K\n\033[K\n\033[K\033[H");
        print(m, o, f * (m->count - 1) / frames);
        live_frame(m, f * (m->count - 1) / frames, &empty);
        printf("%d times slower than a quarter\033[K\033[?2026l\r", SLOWER);
        fflush(stdout);
        nanosleep(&(struct timespec){0, 1000000000 / FRAMES}, NULL);
    }
    printf("\033[K\033[?25h");
}
