/* SPDX-License-Identifier: MIT */
/* What the library says of itself: version, sizes, statuses, methods. */
#include "support/check.h"

#include <coinf.h>

#include <stdio.h>
#include <string.h>

/* ------------------------------------------------------------------ version */
TEST(the_number_is_that_of_the_header)
{
    const uint32_t v = coin_version();
    check(v >> 16 == COIN_VERSION_MAJOR);
    check((v >> 8 & 0xff) == COIN_VERSION_MINOR);
    check((v & 0xff) == COIN_VERSION_PATCH);
}

TEST(the_text_says_the_same)
{
    char want[32];
    snprintf(want, sizeof want, "%d.%d.%d", COIN_VERSION_MAJOR,
             COIN_VERSION_MINOR, COIN_VERSION_PATCH);
    check(strcmp(coin_version_string(), want) == 0);
}

/* -------------------------------------------------------------------- sizes */
TEST(the_sizes_are_those_of_the_headers)
{
    const struct {
        const char *type;
        size_t stated, compiled;
    } of[] = {
        {"coin_params", 64, sizeof(coin_params)},
        {"coin_state", 64, sizeof(coin_state)},
        {"coin_force", 48, sizeof(coin_force)},
        {"coin_losses", 96, sizeof(coin_losses)},
        {"coin_table", 160, sizeof(coin_table)},
        {"coin_body", 128, sizeof(coin_body)},
        {"coin_orbit", 32768, sizeof(coin_orbit)},
        {"coinf_params", 32, sizeof(coinf_params)},
        {"coinf_state", 64, sizeof(coinf_state)},
        {"coinf_force", 24, sizeof(coinf_force)},
    };
    for (size_t i = 0; i < sizeof of / sizeof *of; ++i) {
        check_note("%s", of[i].type);
        check(coin_sizeof(of[i].type) == of[i].stated);
        check(of[i].compiled == of[i].stated);
    }
}

TEST(what_is_no_type_has_no_size)
{
    check(coin_sizeof(NULL) == 0);
    check(coin_sizeof("") == 0);
    check(coin_sizeof("coin_stat") == 0);
    check(coin_sizeof("coin_states") == 0);
    check(coin_sizeof("COIN_STATE") == 0);
}

/* ----------------------------------------------------------------- statuses */
enum { ALL_WARNINGS = 15 };

static const struct {
    int32_t bit;
    const char *word;
} warnings[] = {
    {COIN_SLIPS, "SLIPS"},
    {COIN_LIFTS, "LIFTS"},
    {COIN_COARSE, "COARSE"},
    {COIN_NEARLY_FLAT, "NEARLY_FLAT"},
};

static int same(int32_t a, int32_t b)
{
    return strcmp(coin_status_string(a), coin_status_string(b)) == 0;
}

TEST(every_status_has_a_text_of_its_own)
{
    for (int32_t a = COIN_ERANGE; a <= COIN_RESTS; ++a)
        for (int32_t b = COIN_ERANGE; b < a; ++b) {
            check_note("%d and %d", (int)a, (int)b);
            check(!same(a, b));
        }
}

/* A line of a terminal. */
TEST(texts_are_short_and_have_no_full_stop)
{
    for (int32_t status = COIN_ERANGE; status <= COIN_RESTS + 1; ++status) {
        const char *text = coin_status_string(status);
        const size_t n = strlen(text);
        check_note("%d: \"%s\"", (int)status, text);
        check(n > 3 && n < 80 && text[n - 1] != '.');
    }
}

TEST(a_set_of_warnings_names_each_of_them)
{
    for (int32_t set = 1; set < ALL_WARNINGS; ++set) {
        if ((set & (set - 1)) == 0)
            continue; /* a single one is put in plain words */
        for (size_t i = 0; i < 4; ++i) {
            const char *text = coin_status_string(set);
            check_note("\"%s\" and %s", text, warnings[i].word);
            check(!strstr(text, warnings[i].word) == !(set & warnings[i].bit));
        }
    }
}

TEST(texts_say_what_they_are_about)
{
    const struct {
        int32_t status;
        const char *word;
    } about[] = {
        {COIN_OK, "done"},          {COIN_EPARAMS, "parameter"},
        {COIN_ESTATE, "state"},     {COIN_EARG, "argument"},
        {COIN_EFLAT, "flat"},       {COIN_EBUILD, "build"},
        {COIN_ROLLS, "roll"},       {COIN_SLIPS, "slip"},
        {COIN_LIFTS, "lift"},       {COIN_COARSE, "coarse"},
        {COIN_NEARLY_FLAT, "flat"}, {ALL_WARNINGS, "all"},
        {COIN_RESTS, "flat"},       {COIN_ERANGE, "range"},
        {COIN_TOUCHES, "table"},    {COIN_TOUCHES | COIN_LIFTS, "come down"},
        {COIN_MORE, "not all"},     {COIN_MORE | COIN_SLIPS, "call again"},
        {COIN_ROLLS | 15, "roll"},  {COIN_RESTS | 15, "flat"},
    };
    for (size_t i = 0; i < sizeof about / sizeof *about; ++i) {
        const char *text = coin_status_string(about[i].status);
        check_note("\"%s\" lacks \"%s\"", text, about[i].word);
        check(strstr(text, about[i].word) != NULL);
    }
}

/* What coin.h says of each function's statuses, in a word of the text. */
static const struct {
    const char *function, *status;
    int32_t number;
    const char *word;
} cases[] = {
#define CASE(function, status, word)                                           \
    {                                                                          \
#function, #status, status, word                                       \
    }
    CASE(coin_run, COIN_COARSE, "coarse"),
    CASE(coin_run, COIN_EARG, "method"),
    CASE(coin_run, COIN_ESTEP, "dt"),
    CASE(coin_run, COIN_ESTEP, "too long"),
    CASE(coin_run, COIN_ERANGE, "x"),
    CASE(coin_batch_run, COIN_EARG, "method"),
    CASE(coin_batch_run, COIN_EPARAMS, "parameters"),
    CASE(coin_advance, COIN_EARG, "tol"),
    CASE(coin_advance, COIN_ESTEP, "t out of range"),
    CASE(coin_advance, COIN_MORE, "call again"),
    CASE(coin_advance, COIN_ERANGE, "phi"),
    CASE(coin_advance, COIN_EFLAT, "the coin falls flat"),
    CASE(coin_params_ring, COIN_EPARAMS, "parameters"),
    CASE(coin_state_from_motion, COIN_ESTATE, "state or body out of range"),
    CASE(coin_check, COIN_SLIPS, "or a real one would"),
    CASE(coin_check, COIN_LIFTS, "or would lift off"),
    CASE(coin_check, COIN_COARSE, "the step is coarse"),
    CASE(coin_check, COIN_NEARLY_FLAT, "nearly flat"),
    CASE(coin_check, COIN_EARG, "method"),
    CASE(coin_check, COIN_EARG, "mu"),
    CASE(coin_check, COIN_ESTEP, "dt or t out of range"),
    CASE(coin_steady_circle, COIN_EARG, "branch"),
    CASE(coin_steady_circle, COIN_EDOMAIN, "no such steady motion"),
    CASE(coin_steady_turn, COIN_EARG, "radius"),
    CASE(coin_steady_turn, COIN_EDOMAIN, "no such steady motion"),
    CASE(coin_steady_ride, COIN_EARG, "speed"),
    CASE(coin_steady_ride, COIN_EDOMAIN, "no such steady motion"),
    CASE(coin_steady_radii, COIN_EDOMAIN, "not steady"),
    CASE(coin_steady_at, COIN_ESTEP, "t out of range"),
    CASE(coin_steady_at, COIN_ERANGE, "psi"),
    CASE(coin_steady_at, COIN_EDOMAIN, "not steady"),
    CASE(coin_orbit_init, COIN_EDOMAIN, "no such steady motion, orbit"),
    CASE(coin_orbit_at, COIN_EARG, "orbit"),
    CASE(coin_orbit_at, COIN_ESTEP, "too long"),
    CASE(coin_orbit_at, COIN_ERANGE, "z"),
    CASE(coin_settle, COIN_RESTS, "lies flat"),
    CASE(coin_settle, COIN_EARG, "tol"),
    CASE(coin_settle, COIN_ESTEP, "t out of range"),
    CASE(coin_settle, COIN_MORE, "call again"),
    CASE(coin_settle, COIN_ERANGE, "phi"),
    CASE(coin_losses_fit, COIN_OK, "done"),
    CASE(coin_losses_fit, COIN_EARG, "time"),
    CASE(coin_losses_fit, COIN_EDOMAIN, "orbit or losses"),
    CASE(coin_body_from_state, COIN_ESTATE, "body out of range"),
    CASE(coin_body_from_motion, COIN_ESTATE, "below the table"),
    CASE(coin_body_strike, COIN_ESTATE, "body out of range"),
    CASE(coin_move, COIN_SLIPS, "the coin slips"),
    CASE(coin_move, COIN_LIFTS, "is off the table"),
    CASE(coin_move, COIN_RESTS, "stays"),
    CASE(coin_move, COIN_NEARLY_FLAT, "nearly flat"),
    CASE(coin_move, COIN_ROLLS, "roll"),
    CASE(coin_move, COIN_TOUCHES, "come down"),
    CASE(coin_move, COIN_DECIDED, "decided"),
    CASE(coin_move, COIN_EARG, "stop"),
    CASE(coin_move, COIN_ESTATE, "below the table"),
    CASE(coin_move, COIN_ESTEP, "t out of range"),
    CASE(coin_move, COIN_MORE, "call again"),
    CASE(coin_move, COIN_ERANGE, "y or z"),
    CASE(coin_selftest, COIN_OK, "done"),
    CASE(coin_selftest, COIN_EBUILD, "this build"),
#undef CASE
};
enum { CASES = sizeof cases / sizeof *cases };

TEST(a_text_fits_every_function_that_returns_it)
{
    for (size_t i = 0; i < CASES; ++i) {
        const char *text = coin_status_string(cases[i].number);
        check_note("%s: \"%s\" lacks \"%s\"", cases[i].function, text,
                   cases[i].word);
        check(strstr(text, cases[i].word) != NULL);
    }
}

/* It does not know by which function it was returned. */
TEST(no_text_names_a_function_to_call)
{
    for (int32_t status = COIN_ERANGE; status <= 2 * COIN_DECIDED; ++status) {
        check_note("\"%s\"", coin_status_string(status));
        check(strstr(coin_status_string(status), "coin_") == NULL);
    }
}

static int is_among_the_cases(const char *function, const char *status)
{
    size_t i = 0;
    while (i < CASES && (strcmp(cases[i].function, function) != 0 ||
                         strcmp(cases[i].status, status) != 0))
        ++i;
    return i < CASES;
}

/* Each status that a function's @return names must be among the cases; a method
 * is no status. */
static int read_returns(const char *function, char *text)
{
    char *end = strstr(text, "Accuracy:"), *cost = strstr(text, "Cost:");
    int count = 0;
    if (end || cost)
        *(end ? end : cost) = 0;
    for (char *at = text; (at = strstr(at, "COIN_")) != NULL; ++at) {
        char name[32];
        check(sscanf(at, "%31[A-Z0-9_]", name) == 1);
        if (strncmp(name, "COIN_SYMPLECTIC", 15) == 0)
            continue;
        check_note("%s returns %s", function, name);
        check(is_among_the_cases(function, name));
        ++count;
    }
    return count;
}

TEST(every_status_that_coin_h_documents_is_among_the_cases)
{
    static char text[1 << 17];
    FILE *in = fopen(TEST_ROOT "/include/coin.h", "r");
    check(in != NULL);
    const size_t n = fread(text, 1, sizeof text - 1, in);
    fclose(in);
    check(n > 0 && n < sizeof text - 1);
    int count = 0;
    for (char *at = text, *end; (at = strstr(at, " * @return ")) != NULL;) {
        char function[64];
        check((end = strstr(at, "*/")) != NULL);
        *end = 0;
        check(sscanf(end + 1, "/ COIN_API int32_t %63[a-z_](", function) == 1);
        count += read_returns(function, at);
        at = end + 1;
    }
    check(count >= 50);
}

/* Of moments and modes together the text is that of the first of these. */
TEST(what_ends_a_loop_is_said_whatever_else_holds)
{
    static const int32_t first[] = {COIN_RESTS, COIN_MORE, COIN_DECIDED,
                                    COIN_ROLLS, COIN_TOUCHES};
    enum { FIRST = sizeof first / sizeof *first };
    for (int k = 0; k < FIRST; ++k) {
        int32_t others = 2 * COIN_NEARLY_FLAT - 1;
        for (int i = k + 1; i < FIRST; ++i)
            others |= first[i];
        for (int32_t with = 0; with <= others; ++with) {
            check_note("%d with %d", (int)first[k], (int)with);
            if ((with & others) == with)
                check(strcmp(coin_status_string(first[k] | with),
                             coin_status_string(first[k])) == 0);
        }
        check(k == 0 || strcmp(coin_status_string(first[k]),
                               coin_status_string(first[k - 1])) != 0);
    }
}

TEST(any_other_number_is_unknown)
{
    const int32_t others[] = {COIN_ERANGE - 1,  -1000, INT32_MIN,
                              2 * COIN_DECIDED, 1000,  INT32_MAX};
    for (size_t i = 0; i < sizeof others / sizeof *others; ++i) {
        check_note("%d", (int)others[i]);
        check(strcmp(coin_status_string(others[i]), "unknown status") == 0);
    }
}

/* ------------------------------------------------------------------ methods */
TEST(each_method_has_its_name)
{
    const struct {
        int32_t method;
        const char *name;
    } of[] = {
        {COIN_RK4, "rk4"},
        {COIN_RK8, "rk8"},
        {COIN_SYMPLECTIC2, "symplectic2"},
        {COIN_SYMPLECTIC4, "symplectic4"},
    };
    for (size_t i = 0; i < sizeof of / sizeof *of; ++i) {
        check_note("%s", of[i].name);
        check(strcmp(coin_method_name(of[i].method), of[i].name) == 0);
    }
}

TEST(other_numbers_are_no_methods)
{
    const int32_t absurd[] = {-1, 4, 1000, INT32_MIN, INT32_MAX};
    for (size_t i = 0; i < sizeof absurd / sizeof *absurd; ++i) {
        check_note("method %d", (int)absurd[i]);
        check(coin_method_name(absurd[i]) == NULL);
    }
}
