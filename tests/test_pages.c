/* SPDX-License-Identifier: MIT */
/* The programs of two pages print what the pages show.  docs/games.md shows
 * parts of docs/examples/game.c and engine.h, docs/answers.md whole programs.
 */
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

/* Compiles a program, without optimising: that is faster; and compares what it
 * prints. */
static void check_prints(const char *program, const char *shown)
{
    static char output[TEXT];
    char command[2048], folder[] = "/tmp/test_pages.XXXXXX";
    check(mkdtemp(folder) != NULL);
    snprintf(command, sizeof command, "%s/program.c", folder);
    FILE *out = fopen(command, "w");
    check(out != NULL);
    fputs(program, out);
    fclose(out);
    snprintf(command, sizeof command,
             "cd %s && %s -O0 -std=c99 -Wall -Wextra -Wpedantic -Werror "
             "-I%s/include -I%s/docs/examples -o program program.c %s -lm && "
             "timeout 20 ./program && rm -r %s",
             folder, TEST_CC, TEST_ROOT, TEST_ROOT, TEST_LIB, folder);
    fflush(NULL);
    FILE *in = popen(command, "r");
    check(in != NULL);
    output[fread(output, 1, TEXT - 1, in)] = 0;
    check_note("%s\n%s\nprinted\n%s", command, program, output);
    check(pclose(in) == 0);
    check(shown != NULL);
    check(strcmp(output, shown) == 0);
}

static void each_part_shown_is_the_game_s(void **unused)
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

static void the_game_prints_what_the_page_shows(void **unused)
{
    (void)unused;
    static char page[TEXT], program[TEXT];
    char *at = page;
    read_text("docs/examples/game.c", program);
    read_text("docs/games.md", page);
    check_prints(program, block(&at, "It prints\n\n```\n"));
}

static void each_answer_s_program_prints_what_the_page_shows(void **unused)
{
    (void)unused;
    static char page[TEXT];
    char *at = page;
    int programs = 0;
    read_text("docs/answers.md", page);
    for (const char *code; (code = block(&at, "\n```c\n")) != NULL; ++programs)
        check_prints(code, block(&at, "\n```\n"));
    check(programs >= 7);
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
        TEST(each_part_shown_is_the_game_s),
        TEST(the_game_prints_what_the_page_shows),
        TEST(each_answer_s_program_prints_what_the_page_shows),
        TEST(the_check_of_a_coin_at_rest_says_more_than_that),
    };
    return RUN_TESTS(tests);
}
