/* SPDX-License-Identifier: MIT */
/* Threads that each step coins of their own, with one set of parameters: what
 * each gets has the bits that one thread alone gets, and the thread sanitizer
 * sees no race. */
#include <coin.h>

#include <pthread.h>
#include <stdio.h>
#include <string.h>

enum { THREADS = 4, ROUNDS = 50 };

static coin_params quarter;

/* All that the calls write. */
struct result {
    coin_state stepped, sampled[3], landed, rates, circle;
    coin_force force;
    double K[2], q[4], E;
    int32_t status;
};

struct job {
    int number;
    struct result result;
};

static int32_t step(struct result *r, int method, const coin_state *start)
{
    int32_t bad = 0;
    const coin_params *p = &quarter;
    coin_state *s = &r->stepped;
    bad |= coin_run(s, p, method, 1e-3, 40, NULL) < 0;
    bad |= coin_step(s, p, 1e-3) < 0;
    bad |= coin_sample(start, p, method, 1e-3, 5, 3, r->sampled, NULL) < 0;
    bad |= coin_advance(&r->landed, p, 0.02, 1e-9, NULL) < 0;
    return bad;
}

static int32_t look(struct result *r)
{
    int32_t bad = 0;
    const coin_params *p = &quarter;
    const coin_state *s = &r->stepped;
    bad |= coin_integrals(s, p, r->K) < 0;
    bad |= coin_reaction(s, p, &r->force) < 0;
    bad |= coin_rates(s, p, &r->rates) < 0;
    bad |= coin_quaternion(s, r->q) < 0;
    bad |= coin_check(s, p, COIN_RK4, 1e-3, 0.3) < 0;
    bad |= coin_steady_circle(&r->circle, p, 0.3, 20, 1) < 0;
    r->E += coin_energy(s, p) + coin_critical_roll(p);
    return bad;
}

static void *work(void *of)
{
    struct job *job = of;
    struct result *r = &job->result;
    memset(r, 0, sizeof *r);
    for (int i = 0; i < ROUNDS; ++i) {
        const coin_state start = {0.3, 0, 0, 0, 0, 0, 5 + i, 40 + job->number};
        r->stepped = r->landed = start;
        r->status |= step(r, i % 4, &start) | look(r);
    }
    r->status |= coin_selftest();
    return NULL;
}

int main(void)
{
    static struct job together[THREADS], alone[THREADS];
    pthread_t threads[THREADS];
    int wrong = coin_params_disc(&quarter, 0.00567, 0.01213, 9.80665);
    for (int i = 0; i < THREADS; ++i) {
        together[i].number = alone[i].number = i;
        if (pthread_create(&threads[i], NULL, work, &together[i]) != 0)
            return 2;
    }
    for (int i = 0; i < THREADS; ++i)
        wrong |= pthread_join(threads[i], NULL);
    for (int i = 0; i < THREADS; ++i) {
        work(&alone[i]);
        wrong |= alone[i].result.status;
        wrong |= memcmp(&alone[i], &together[i], sizeof *alone);
    }
    puts(wrong ? "threads: another result than one alone"
               : "threads: each as one alone");
    return wrong != 0;
}
