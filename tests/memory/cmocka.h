/* SPDX-License-Identifier: MIT */
/* The part of cmocka that the tests use, for `make msan`: the memory sanitizer
 * must see every write, and the library that is installed would hide its own.
 * The first failure ends the program. */
#ifndef ROLLCOIN_TESTS_MEMORY_CMOCKA_H
#define ROLLCOIN_TESTS_MEMORY_CMOCKA_H

#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>

struct CMUnitTest {
    const char *name;
    void (*test)(void **state);
    int (*setup)(void **state);
};

/* clang-format off */
#define cmocka_unit_test_setup(test, setup) {#test, test, setup}
/* clang-format on */

#define print_error(...) ((void)fprintf(stderr, __VA_ARGS__))

static inline void _fail(const char *file, int line)
{
    fprintf(stderr, "%s:%d: failed\n", file, line);
    exit(1);
}

/* Where a test that is skipped goes on: one for all files. */
__attribute__((common)) jmp_buf _test_skipped;
#define skip() longjmp(_test_skipped, 1)

typedef int fixture(void **state);

/* The sanitizer takes what setjmp() returns for what a function that it knows
 * returned last: this function is left out. */
__attribute__((no_sanitize("memory"))) static inline int
_cmocka_run_group_tests(const char *name, const struct CMUnitTest *tests,
                        size_t count, fixture *setup, fixture *teardown)
{
    void *state = NULL;
    (void)name, (void)setup, (void)teardown; /* no test has them */
    for (size_t i = 0; i < count; ++i) {
        if (tests[i].setup(&state) != 0)
            _fail(tests[i].name, 0);
        int skipped = setjmp(_test_skipped);
        if (!skipped)
            tests[i].test(&state);
        printf("[  %s ] %s\n", skipped ? "SKIPPED" : "     OK", tests[i].name);
    }
    return 0;
}

#endif
