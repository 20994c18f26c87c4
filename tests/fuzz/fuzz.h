/* SPDX-License-Identifier: MIT */
/* Fuzzing of the public functions: bytes become arguments, and what a call
 * leaves behind is held against what coin.h promises of every call.
 *
 * A target is a file of functions.  For a new one: a row in the file of its
 * group, and a judge if it promises more than others do. */
#ifndef ROLLCOIN_TESTS_FUZZ_H
#define ROLLCOIN_TESTS_FUZZ_H

#include <coin.h>
#include <coinf.h>

#include <stddef.h>
#include <stdint.h>

enum { ARGUMENTS = 8, SAMPLES = 4, MOST_FUNCTIONS = 32 };

union argument {
    void *p;
    double d;
    int32_t i;
    uint64_t u;
};

/* What is left of the bytes; beyond the end all are 0. */
struct bytes {
    const uint8_t *at, *end;
};

/* A coin to call about, most often a good one, its fastest rate W, and the same
 * in single precision. */
struct world {
    coin_params p;
    coin_state s;
    double W;
    coinf_params pf;
    coinf_state sf;
};
void take_single(struct world *w, struct bytes *b);

struct world take_world(struct bytes *b);
uint8_t take_byte(struct bytes *b);

/* Any double at all, most often one where something happens: NaN, infinities,
 * zeros, the smallest and the largest, neighbours of pi/2 and of 2^31. */
double take_number(struct bytes *b);

/* Within +-1; a moderate value given, or now and then any number; a lean,
 * often near flat; a rate, of the size of unit or of any. */
double take_part(struct bytes *b);
double perhaps(struct bytes *b, double moderate);
double take_lean(struct bytes *b);
double take_rate(struct bytes *b, double unit);

/* What an argument is; the letters of a function's signature stand for one
 * each, in the table of kinds.c. */
enum role { SCALAR, READ, OPTIONAL, MOVED, WRITTEN, PROGRESS };

struct kind {
    char letter;
    enum role role;
    size_t size; /* of what it points to */
    void (*take)(struct bytes *b, const struct world *w, void *to);
    int (*sound)(const void *of, size_t size, const struct world *w);
};

const struct kind *kind_of(char letter);

/* A call that was made, with the arguments as given and as left behind. */
struct outcome {
    double result; /* the status, or the number */
    const union argument *given, *left;
    const struct world *world;
};

struct function {
    const char *name, *signature;
    double (*call)(const union argument *a);
    /* Statuses that it may return: bit -status of errors; bits of warnings.
     * Errors with which outputs may change, as its judge will say. */
    unsigned errors;
    int32_t warnings;
    unsigned progress;
    void (*judge)(const struct outcome *o); /* may be null */
    int is_number; /* NaN is its only error; 2: it may be infinite */
};

/* Errors as bits. */
#define BIT(status) (1u << -(status))
#define STOPS (BIT(COIN_ESTEP) | BIT(COIN_ERANGE))
#define USUAL (BIT(COIN_EARG) | BIT(COIN_EPARAMS) | BIT(COIN_ESTATE))
/* The rest of a row: nothing special; a number. */
#define PLAIN 0, NULL, 0
#define NUMBER 0, 0, 0, NULL, 1

/* A function: its name, what its arguments a[] are, a call, and the rest of its
 * row. */
#define FUNCTION(name, signature, value, ...)                                  \
    static double do_##name(const union argument *a)                           \
    {                                                                          \
        (void)a;                                                               \
        return (double)(value);                                                \
    }                                                                          \
    __attribute__((constructor)) static void add_##name(void)                  \
    {                                                                          \
        const struct function f = {#name, signature, do_##name, __VA_ARGS__};  \
        fuzz_functions[fuzz_count++] = f;                                      \
    }
extern struct function fuzz_functions[MOST_FUNCTIONS];
extern size_t fuzz_count;

/* Ends the program, and says of which function, unless it holds. */
#define demand(holds) demand_that((holds) ? 1 : 0, #holds, __FILE__, __LINE__)
void demand_that(int holds, const char *what, const char *file, int line);

/* How far a call came that moves a[0], asked for the time a[t]: not beyond it,
 * to a sound state.  NaN if it did not begin. */
double reached_by(const struct outcome *o, int t, int progress);

/* Bit for bit. */
int same(const void *a, const void *b, size_t size);

#endif
