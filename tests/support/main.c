/* SPDX-License-Identifier: MIT */
/* The main program of all tests: runs those of a file, or those of them whose
 * claims contain the second argument.
 *     run test_rk4 [CLAIM]  */
#include "check.h"

#include <stdio.h>
#include <string.h>

enum { MOST = 1024 };

/* What the files define.  One without a claim runs before the others. */
static struct {
    const char *file, *claim;
    void (*run)(void **unused);
} tests[MOST];
static size_t count;

void test_add(const char *file, const char *claim, void (*test)(void **unused))
{
    if (count == MOST)
        _fail(__FILE__, __LINE__);
    tests[count].file = file;
    tests[count].claim = claim;
    tests[count++].run = test;
}

/* Whether a path ends in /NAME.c. */
static int is_of(const char *path, const char *name)
{
    const char *const end = strrchr(path, '/');
    const size_t length = strlen(name);
    return end && strncmp(end + 1, name, length) == 0 &&
           strcmp(end + 1 + length, ".c") == 0;
}

int main(int argc, char **argv)
{
    static struct CMUnitTest chosen[MOST];
    const char *const file = argc > 1 ? argv[1] : "";
    const char *const claim = argc > 2 ? argv[2] : "";
    size_t n = 0;
    for (size_t i = 0; i < count; ++i) {
        if (!is_of(tests[i].file, file))
            continue;
        if (!tests[i].claim) {
            tests[i].run(NULL);
        } else if (strstr(tests[i].claim, claim)) {
            const struct CMUnitTest test =
                cmocka_unit_test_setup(tests[i].run, check_begin);
            chosen[n] = test;
            chosen[n++].name = tests[i].claim;
        }
    }
    if (n == 0) {
        fprintf(stderr, "%s: no such test: %s %s\n", argv[0], file, claim);
        return 1;
    }
    return _cmocka_run_group_tests(file, chosen, n, NULL, NULL);
}
