/* SPDX-License-Identifier: MIT */
/* The programs that README.md, coin.h and the pages of docs/ show: they compile
 * without a warning, link against the static library and print what is shown.
 * docs/games.md shows parts of docs/examples/game.c and engine.h. */
#define _POSIX_C_SOURCE 200809L

#include "support/check.h"
#include "support/scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifndef TEST_LIB
#error "the Makefile says where the static library is: -DTEST_LIB"
#endif
#ifndef TEST_CC
#error "the Makefile says how to compile: -DTEST_CC"
#endif

enum { TEXT = 1 << 17 };

static char folder[] = "/tmp/test_pages.XXXXXX";

/* ---------------------------------------------------------------- the texts */
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

/* Cuts what lies between two marks, from the line after the first; returns
 * where the second ends. */
static char *between(char *text, const char *from, const char *to, char **end)
{
    char *start = strstr(text, from);
    check_note("no %s", from);
    check(start != NULL);
    start = strchr(start, '\n') + 1;
    *end = strstr(start, to);
    check(*end != NULL);
    **end = 0;
    *end += strlen(to);
    return start;
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

/* Takes the " *" off the lines of a comment. */
static void uncomment(char *text)
{
    char *out = text;
    for (const char *in = text; *in;) {
        if (strncmp(in, " *", 2) == 0)
            in += 2;
        while (*in && *in != '\n')
            *out++ = *in++;
        if (*in)
            *out++ = *in++;
    }
    *out = 0;
}

/* -------------------------------------------------------------- the programs
 */
static int shell(const char *command)
{
    fflush(NULL);
    return system(command);
}

/* Without optimising: that is faster. */
static void compile(const char *before, const char *code, const char *after)
{
    char command[2048];
    snprintf(command, sizeof command, "%s/program.c", folder);
    FILE *out = fopen(command, "w");
    check(out != NULL);
    fprintf(out, "%s%s%s", before, code, after);
    fclose(out);
    snprintf(command, sizeof command,
             "%s -O0 -std=c99 -Wall -Wextra -Wpedantic -Werror -I%s/include "
             "-I%s/docs/examples -o %s/program %s/program.c %s -lm",
             TEST_CC, TEST_ROOT, TEST_ROOT, folder, folder, TEST_LIB);
    check_note("%s", command);
    check(shell(command) == 0);
}

static void run_program(char output[TEXT])
{
    char command[512];
    snprintf(command, sizeof command, "timeout 20 %s/program", folder);
    FILE *in = popen(command, "r");
    check(in != NULL);
    output[fread(output, 1, TEXT - 1, in)] = 0;
    check_note("%s printed \"%s\"", command, output);
    check(pclose(in) == 0);
}

static void check_prints(const char *program, const char *shown)
{
    static char output[TEXT];
    check(program != NULL && shown != NULL);
    compile("", program, "");
    run_program(output);
    check_note("%s\nprinted\n%s\nwhere the page has\n%s", program, output,
               shown);
    check(strcmp(output, shown) == 0);
}

/* The end of a program that prints the pose of s, and what reads it. */
#define PRINT_STATE                                                            \
    "\nprintf(\"%.17g %.17g %.17g %.17g %.17g\\n\","                           \
    " s.theta, s.phi, s.psi, s.x, s.z);\nreturn 0;\n}\n"

static void read_state(const char *output, coin_state *s)
{
    check(sscanf(output, "%lf %lf %lf %lf %lf", &s->theta, &s->phi, &s->psi,
                 &s->x, &s->z) == 5);
}

TEST(the_readme_s_program_prints_what_the_readme_shows)
{
    static char text[TEXT];
    char *end;
    read_text("README.md", text);
    const char *program =
        between(strstr(text, "## A whole program"), "```c\n", "```", &end);
    check_prints(program, between(end, "```", "```", &end));
}

/* 1000 steps in the quarter's first second. */
TEST(the_header_s_example_rolls_the_quarter)
{
    static char text[TEXT], output[TEXT];
    static struct scene quarter;
    coin_state s;
    char *end;
    read_text("include/coin.h", text);
    char *code = between(text, "@code", "@endcode", &end);
    uncomment(code);
    compile("#include <coin.h>\n#include <stdio.h>\nint main(void)\n{\n", code,
            PRINT_STATE);
    run_program(output);
    read_state(output, &s);
    scene_load(&quarter, "quarter");
    check(scene_at(&quarter, 6, "t") == 1);
    /* 5e-4 with 120 steps: 1e-7 with 1000. */
    check_within(scene_error(&quarter, 6, &s), 1e-8, 1e-6);
}

TEST(each_part_shown_is_the_game_s)
{
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
    check(shown >= 2);
}

TEST(the_game_prints_what_the_page_shows)
{
    static char page[TEXT], program[TEXT];
    char *at = page;
    read_text("docs/examples/game.c", program);
    read_text("docs/games.md", page);
    check_prints(program, block(&at, "It prints\n\n```\n"));
}

TEST(each_answer_s_program_prints_what_the_page_shows)
{
    static char page[TEXT];
    char *at = page;
    int programs = 0;
    read_text("docs/answers.md", page);
    for (const char *code; (code = block(&at, "\n```c\n")) != NULL; ++programs)
        check_prints(code, block(&at, "\n```\n"));
    check(programs >= 6);
}

/* Spun 0.3 rad from flat with a damping of 0.5, in steps of a millisecond. */
#define SPIN_UNTIL_NEARLY_FLAT                                                 \
    "int main(void)\n{\ncoinf_params p;\n"                                     \
    "coinf_state s = {.theta = 1.2708f, .wY = 30.914f};\nint n = 0;\n"         \
    "coinf_params_disc(&p, 0.00567f, 0.01213f, 9.80665f);\n"                   \
    "while (moves(&s, &p, 1e-3f, 0.5f))\n++n;\nprintf(\"%d\", n);\n}\n"

/* From 0.3 rad to COIN_NEARLY_FLAT, 0.01, by the law that the page states: of
 * the start, not quite near flat, it is 1e-3 off. */
TEST(the_toy_comes_to_rest_by_the_law_that_the_page_states)
{
    static char page[TEXT], output[TEXT];
    read_text("docs/embedding.md", page);
    char *at = strstr(page, "## A coin that comes to rest");
    check(at != NULL);
    compile("#include <coinf.h>\n#include <stdio.h>\n", block(&at, "\n```c\n"),
            SPIN_UNTIL_NEARLY_FLAT);
    run_program(output);
    const double law = 1.5 / 0.5 * log(0.3 / 0.01);
    check_within(atof(output) * 1e-3 / law, 1 - 5e-3, 1 + 5e-3);
}

/* docs/choosing.md: the launches of docs/examples/lean_map.c. */
TEST(a_lean_1e_4_larger_lets_the_quarter_roll_two_seconds_longer)
{
    coin_params p;
    coin_losses l = {.dry = 0};
    coin_state lower = {.theta = 0.3133, .wY = 1, .wZ = 12};
    coin_state higher = {.theta = 0.3134, .wY = 1, .wZ = 12};
    check_status(coin_params_disc(&p, 0.00567, 0.01213, 9.80665), COIN_OK);
    l.dry = 1e-3 * p.mass * p.gravity * p.radius;
    check_within(coin_time_to_rest(&lower, &p, &l), 7.305, 7.315);
    check_within(coin_time_to_rest(&higher, &p, &l), 9.155, 9.165);
}

static double rests_after(coin_state s, const coin_params *p,
                          const coin_losses *l, double call, double tol)
{
    double sum = 0, moved;
    while (coin_settle(&s, p, l, call, tol, &moved) == COIN_OK)
        sum += moved;
    return sum + moved;
}

/* docs/choosing.md, the table below that: errors of the time of rest. */
TEST(the_time_of_rest_errs_as_choosing_says)
{
    static const struct row {
        double lean, call, most[5];
    } rows[] = {
        {0.3, 1.0 / 60, {3e-5, 1e-5, 1e-7, 1e-9, 3e-12}},
        {0.3, (double)INFINITY, {5e-5, 5e-5, 1e-7, 1e-9, 3e-12}},
        {0.3133, 1.0 / 60, {3e-5, 1e-5, 1e-7, 1e-9, 3e-12}},
        {0.3133, (double)INFINITY, {2, 2, 2e-7, 1e-9, 3e-12}},
    };
    coin_params p;
    coin_losses l = {.dry = 0};
    check_status(coin_params_disc(&p, 0.00567, 0.01213, 9.80665), COIN_OK);
    l.dry = 1e-3 * p.mass * p.gravity * p.radius;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        const coin_state s = {.theta = rows[i].lean, .wY = 1, .wZ = 12};
        const double t = rests_after(s, &p, &l, (double)INFINITY, 1e-12);
        check_note("lean %g, calls of %g", rows[i].lean, rows[i].call);
        for (int k = 0; k < 5; ++k)
            check_near(
                rests_after(s, &p, &l, rows[i].call, pow(10, -3 - 2 * k)), t,
                rows[i].most[k]);
    }
}

TEST(the_check_of_a_coin_at_rest_says_more_than_that)
{
    coin_params p;
    coin_state s = {.theta = 0.3};
    const coin_losses l = {.dry = 1e-6};
    check_status(coin_params_disc(&p, 0.00567, 0.01213, 9.80665), COIN_OK);
    check_status(coin_settle(&s, &p, &l, 1, 1e-6, NULL), COIN_RESTS);
    check_status(coin_check(&s, &p, COIN_RK4, 0, 0.3),
                 COIN_SLIPS | COIN_NEARLY_FLAT);
}

static void remove_folder(void)
{
    char command[64];
    snprintf(command, sizeof command, "rm -r %s", folder);
    check(shell(command) == 0);
}

FIRST(make_folder)
{
    check(mkdtemp(folder) != NULL);
    atexit(remove_folder);
}
