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
        {COIN_TOUCHES, "table"},    {COIN_TOUCHES | COIN_LIFTS, "table"},
        {COIN_ROLLS | 15, "roll"},  {COIN_RESTS | 15, "flat"},
    };
    for (size_t i = 0; i < sizeof about / sizeof *about; ++i) {
        const char *text = coin_status_string(about[i].status);
        check_note("\"%s\" lacks \"%s\"", text, about[i].word);
        check(strstr(text, about[i].word) != NULL);
    }
}

/* COIN_ESTEP and COIN_EDOMAIN each have several cases: no word is wrong for
 * any of them, and each finds what helps. */
TEST(errors_of_several_cases_name_each_of_them)
{
    const struct {
        int32_t status;
        const char *word;
    } cases[] = {
        {COIN_ESTEP, "dt or t"},        {COIN_ESTEP, "not valid"},
        {COIN_ESTEP, "too long"},       {COIN_ESTEP, "shorten"},
        {COIN_ESTEP, "coin_advance()"}, {COIN_EDOMAIN, "steady motion"},
        {COIN_EDOMAIN, "not steady"},   {COIN_EDOMAIN, "orbit"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const char *text = coin_status_string(cases[i].status);
        check_note("\"%s\" lacks \"%s\"", text, cases[i].word);
        check(strstr(text, cases[i].word) != NULL);
    }
}

TEST(any_other_number_is_unknown)
{
    const int32_t others[] = {COIN_ERANGE - 1, -1000, INT32_MIN, 128, 1000,
                              INT32_MAX};
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
