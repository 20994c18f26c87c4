/* SPDX-License-Identifier: MIT */
/* docs/games.md shows what docs/examples/game.c and engine.h are, and what the
 * program prints. */
#define _POSIX_C_SOURCE 200809L

#include "support/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef TEST_LIB
#error "the Makefile says where the static library is: -DTEST_LIB"
#endif
#ifndef TEST_CC
#error "the Makefile says how to compile: -DTEST_CC"
#endif

enum { TEXT = 1 << 15 };

static void read_text(const char *name, char text[TEXT])
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", TEST_ROOT, name);
    check_note("%s", path);
    FILE *in = fopen(path, "r");
    check(in != NULL);
    const size_t n = fread(text, 1, TEXT - 1, in);
    fclose(in);
    check(n > 0 && n < TEXT - 1);
    text[n] = 0;
}

/* Cuts the next block between a line of that mark and one of ```; null if there
 * is none. */
static char *block(char **text, const char *mark)
{
    char *start = strstr(*text, mark);
    if (!start)
        return NULL;
    start += strlen(mark);
    char *const end = strstr(start, "\n```\n");
    check(end != NULL);
    end[1] = 0;
    *text = end + 2;
    return start;
}

static void each_function_shown_is_the_program_s(void **unused)
{
    (void)unused;
    static char page[TEXT], program[TEXT], engine[TEXT];
    char *at = page;
    int shown = 0;
    read_text("docs/examples/game.c", program);
    read_text("docs/examples/engine.h", engine);
    read_text("docs/games.md", page);
    for (const char *code; (code = block(&at, "\n```c\n")) != NULL; ++shown) {
        check_note("docs/games.md shows\n%s", code);
        check(strstr(program, code) || strstr(engine, code));
    }
    check(shown >= 6);
}

static void it_prints_what_the_page_shows(void **unused)
{
    (void)unused;
    static char page[TEXT], output[TEXT];
    char *at = page, command[2048], program[] = "/tmp/test_games.XXXXXX";
    const int file = mkstemp(program);
    check(file >= 0);
    fclose(fdopen(file, "w"));
    snprintf(command, sizeof command,
             "%s -std=c99 -Wall -Wextra -Wpedantic -Werror -I%s/include -o %s "
             "%s/docs/examples/game.c %s -lm && %s",
             TEST_CC, TEST_ROOT, program, TEST_ROOT, TEST_LIB, program);
    fflush(NULL);
    FILE *in = popen(command, "r");
    check(in != NULL);
    output[fread(output, 1, TEXT - 1, in)] = 0;
    check_note("%s printed\n%s", command, output);
    check(pclose(in) == 0);
    remove(program);
    read_text("docs/games.md", page);
    const char *shown = block(&at, "It prints\n\n```\n");
    check(shown != NULL);
    check_note("game.c printed\n%s", output);
    check(strcmp(output, shown) == 0);
}

static void the_check_of_a_coin_at_rest_says_more_than_that(void **unused)
{
    (void)unused;
    coin_params p;
    coin_state s = {.theta = 0.3};
    const coin_losses l = {.dry = 1e-6};
    check_status(coin_params_disc(&p, 0.00567, 0.01213, 9.80665), COIN_OK);
    check_status(coin_settle(&s, &p, &l, 1, 1e-6, NULL), COIN_RESTS);
    check_status(coin_check(&s, &p, COIN_RK4, 0, 0.3),
                 COIN_SLIPS | COIN_NEARLY_FLAT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(each_function_shown_is_the_program_s),
        TEST(it_prints_what_the_page_shows),
        TEST(the_check_of_a_coin_at_rest_says_more_than_that),
    };
    return RUN_TESTS(tests);
}
