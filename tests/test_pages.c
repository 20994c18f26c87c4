/* SPDX-License-Identifier: MIT */
/* The programs that README.md, coin.h and the pages of docs/ show: they compile
 * without a warning, link against the static library and print what is shown.
 * docs/games.md shows parts of docs/examples/game.c and engine.h. */
#define _POSIX_C_SOURCE 200809L

#include "../docs/examples/engine.h"

#include "support/check.h"
#include "support/scene.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
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

TEST(the_readme_s_program_prints_what_the_readme_shows)
{
    static char text[TEXT];
    char *end;
    read_text("README.md", text);
    const char *program =
        between(strstr(text, "## A whole program"), "```c\n", "```", &end);
    check_prints(program, between(end, "```", "```", &end));
}

/* In frames of a sixtieth of a second, to rest. */
TEST(the_header_s_loop_moves_a_toss_to_rest)
{
    static char text[TEXT], output[TEXT];
    char *end;
    int frames, rests;
    read_text("include/coin.h", text);
    char *code = between(text, "moment of a frame:", " *   below", &end);
    uncomment(code);
    compile("#include <coin.h>\n#include <stdio.h>\nint main(void)\n{\n"
            "coin_params p; coin_body b = {.y = 0.3, .vy = 1};\n"
            "coin_table table = {.mu_static = 0.4, .mu_kinetic = 0.3,"
            " .restitution = 0.5, .losses = {.dry = 1e-6}};\n"
            "const int32_t stop = COIN_TOUCHES; int32_t status = 0; int k;\n"
            "double left, moved, tol = 1e-6, frame = 1 / 60.0;\n"
            "coin_params_disc(&p, 0.00567, 0.01213, 9.80665); b.s.wX = 60;\n"
            "for (k = 0; k < 6000 && status >= 0 && !(status & COIN_RESTS);"
            " ++k)\n",
            code, "printf(\"%d %d\\n\", k, (status & COIN_RESTS) != 0);\n}\n");
    run_program(output);
    check(sscanf(output, "%d %d", &frames, &rests) == 2);
    check_within(frames, 30, 1200);
    check(rests);
}

/* The first is docs/examples/game.c.  What is no program is of engine.h. */
TEST(the_programs_of_games_print_what_the_page_shows)
{
    static char page[TEXT], game[TEXT], engine[TEXT];
    char *at = page;
    int parts = 0, programs = 0;
    read_text("docs/examples/game.c", game);
    read_text("docs/examples/engine.h", engine);
    read_text("docs/games.md", page);
    for (const char *code; (code = block(&at, "\n```c\n")) != NULL;) {
        check_note("docs/games.md shows\n%s", code);
        if (strncmp(code, "#include", 8) != 0) {
            check(strstr(engine, code) != NULL);
            ++parts;
            continue;
        }
        check((strstr(game, code) != NULL) == (programs++ == 0));
        check_prints(code, block(&at, "\n```\n"));
    }
    check(parts >= 1 && programs >= 2);
}

/* An engine's coin with z up that touches the table at rest, at a lean. */
static struct rigid_body standing(double lean, double radius, double thickness)
{
    const coin_state s = {.theta = lean, .phi = 0.7, .psi = 2};
    struct rigid_body e = {{1, 2, 0}, {0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    double q[4];
    check_status(coin_quaternion(&s, q), COIN_OK);
    e.q[0] = q[0] - q[1]; /* docs/answers.md, from here to z up */
    e.q[1] = q[1] + q[0];
    e.q[2] = q[2] - q[3];
    e.q[3] = q[2] + q[3];
    e.position[2] =
        radius * cos(lean) + thickness / 2 * fabs(sin(lean)); /* its rim's 0 */
    return e;
}

/* The last lean before pi/2. */
#define FLAT 1.5707963267948963

/* A rounding of each of the two terms, and those of q. */
#define HEIGHT_ERROR (8 * DBL_EPSILON)

static void stands_there_and_back(double lean, double radius, double thickness)
{
    const struct rigid_body e = standing(lean, radius, thickness);
    const coin_table table = {.mu_static = 0.4, .mu_kinetic = 0.3};
    coin_params p;
    coin_body b;
    float m[16];
    check_note("lean %g, radius %g, thickness %g", lean, radius, thickness);
    check_status(coin_params_cylinder(&p, 0.005, radius, thickness, 9.80665),
                 COIN_OK);
    check_status(from_engine(&b, &p, e), COIN_OK);
    check_near(b.s.theta, lean, HEIGHT_ERROR);
    check_near(b.y, e.position[2], HEIGHT_ERROR * radius);
    check(!(coin_move(&b, &p, &table, 0, 1e-6, 0, NULL) & COIN_LIFTS));
    check_status(draw(&b, &p, m), COIN_OK);
    for (int i = 0; i < 3; ++i)
        check_near((double)m[12 + i], e.position[i],
                   FLT_EPSILON * e.position[i]);
}

/* A quarter, a euro, a pound and a poker chip, from upright to flat. */
TEST(an_engine_s_coin_stands_on_the_table_there_and_back)
{
    static const double sizes[][2] = {{0.01213, 0.00175},
                                      {0.011625, 0.00233},
                                      {0.011715, 0.0028},
                                      {0.0195, 0.0033}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i)
        for (int k = -16; k <= 16; ++k)
            stands_there_and_back(k * FLAT / 16, sizes[i][0], sizes[i][1]);
}

/* The engine's z is y here, its y is -z: docs/answers.md. */
TEST(an_engine_s_velocities_are_the_table_s)
{
    const struct rigid_body e = {
        {0, 0, 0.4}, {0.6, 0.8, 0, 0}, {-0.2, 0.3, 1}, {60, 20, 4}};
    const double lean = 2 * atan2(0.8, 0.6) - FLAT;
    double omega[3];
    coin_params p;
    coin_body b;
    check_status(coin_params_disc(&p, 0.005, 0.012, 9.80665), COIN_OK);
    check_status(from_engine(&b, &p, e), COIN_OK);
    check_near(b.vx, -0.2, 0);
    check_near(b.vy, 1, 0);
    check_near(b.vz, -0.3, 0);
    check_status(coin_angular_velocity(&b.s, omega), COIN_OK);
    check_near(omega[0], 60, 60 * HEIGHT_ERROR);
    check_near(omega[1], 4, 60 * HEIGHT_ERROR);
    check_near(omega[2], -20, 60 * HEIGHT_ERROR);
    check_near(b.s.theta, lean, HEIGHT_ERROR);
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

static int begins_a_status(const char *text, size_t length)
{
    int32_t status = COIN_OK;
    while (status >= COIN_ERANGE &&
           strncmp(coin_status_string(status), text, length) != 0)
        --status;
    return status >= COIN_ERANGE;
}

TEST(a_text_that_the_first_hour_quotes_is_that_of_a_status)
{
    static char page[TEXT];
    int quotes = 0;
    read_text("docs/first-hour.md", page);
    for (char *at = page; (at = strstr(at, "\n| \"")) != NULL; ++quotes) {
        at += 4;
        check_note("%.60s", at);
        check(begins_a_status(at, strcspn(at, "\"")));
    }
    check(quotes >= 3);
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
    check_within(coin_time_to_rest(&lower, &p, &l, 1e-6), 7.305, 7.315);
    check_within(coin_time_to_rest(&higher, &p, &l, 1e-6), 9.155, 9.165);
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

/* docs/embedding.md: the sources refuse what takes NaN for a number, too. */
TEST(no_source_compiles_with_fast_math)
{
    const char *const flags[] = {"-ffast-math", "-Ofast", "-ffinite-math-only",
                                 ""};
    for (int i = 0; i < 4; ++i) {
        char command[1024];
        snprintf(command, sizeof command,
                 "cd %s && %s %s -fsyntax-only -I%s/include "
                 "%s/lib/about/version.c 2>/dev/null",
                 folder, TEST_CC, flags[i], TEST_ROOT, TEST_ROOT);
        check_note("%s", command);
        check((shell(command) != 0) == (i < 3));
    }
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
