/* SPDX-License-Identifier: MIT */
/* The main program of each test: runs the tests of its file, or those whose
 * claims contain the first argument. */
#include "check.h"

#include <stdio.h>
#include <string.h>

enum { MOST = 64 };

static struct CMUnitTest tests[MOST];
static size_t count;

void test_add(const char *claim, void (*test)(void **unused))
{
    if (count == MOST)
        _fail(__FILE__, __LINE__);
    tests[count] = (struct CMUnitTest)cmocka_unit_test_setup(test, check_begin);
    tests[count++].name = claim;
}

int main(int argc, char **argv)
{
    size_t chosen = 0;
    for (size_t i = 0; i < count; ++i)
        if (argc < 2 || strstr(tests[i].name, argv[1]))
            tests[chosen++] = tests[i];
    if (chosen == 0) {
        fprintf(stderr, "%s: no such test\n", argv[0]);
        return 1;
    }
    return _cmocka_run_group_tests(argv[0], tests, chosen, NULL, NULL);
}
