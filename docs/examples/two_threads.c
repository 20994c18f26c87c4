/* SPDX-License-Identifier: MIT */
/* Two threads roll half of a batch each.
 *
 *   cc two_threads.c $(pkg-config --cflags --libs rollcoin) -lpthread
 *
 * The library starts no threads and shares nothing between calls, so that a
 * batch is cut wherever the caller likes: no coin has other bits for it. */
#define _POSIX_C_SOURCE 200809L
#include <coin.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { COINS = 20000, STEPS = 500 };

typedef struct share {
    coin_state *coins;
    size_t count;
    const coin_params *p;
    int32_t status;
} share;

static void *roll(void *of)
{
    share *s = of;
    s->status =
        coin_batch_run(s->coins, s->count, s->p, COIN_RK4, 0.02, STEPS, NULL);
    return NULL;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Seconds that so many threads take, 1 or 2; negative on failure. */
static double roll_by(int threads, coin_state *coins, const coin_params *p)
{
    const size_t half = COINS / 2;
    share first = {coins, threads == 1 ? COINS : half, p, 0};
    share second = {coins + half, half, p, 0};
    pthread_t other;
    const double begin = now();

    if (threads == 2 && pthread_create(&other, NULL, roll, &second) != 0)
        return -1;
    roll(&first);
    if (threads == 2)
        pthread_join(other, NULL);
    return first.status == COIN_OK && second.status == COIN_OK ? now() - begin
                                                               : -1;
}

int main(void)
{
    static coin_state start[COINS], one[COINS], two[COINS];
    coin_params p;

    if (coin_params_disc(&p, 1, 1, 1) != COIN_OK)
        return EXIT_FAILURE;
    for (size_t i = 0; i < COINS; ++i) {
        start[i].theta = 0.1 + 0.4 * (double)i / COINS;
        start[i].wY = 0.5;
        start[i].wZ = 1.5;
    }
    double least[2] = {1e9, 1e9};
    for (int k = 0; k < 5; ++k) { /* the shortest of five, by turns */
        memcpy(one, start, sizeof one);
        memcpy(two, start, sizeof two);
        const double by_one = roll_by(1, one, &p), by_two = roll_by(2, two, &p);
        if (by_one < 0 || by_two < 0 || memcmp(one, two, sizeof one) != 0)
            return EXIT_FAILURE;
        least[0] = by_one < least[0] ? by_one : least[0];
        least[1] = by_two < least[1] ? by_two : least[1];
    }
    printf("%d coins, %d steps: %.0f ms by one thread, %.0f ms by two, "
           "%.2f times as fast, the same bits\n",
           COINS, STEPS, 1e3 * least[0], 1e3 * least[1], least[0] / least[1]);
    return EXIT_SUCCESS;
}
