/* SPDX-License-Identifier: MIT */
/* A CSV file of tests/reference: '#' lines, a line of names, rows of numbers.
 */
#ifndef ROLLCOIN_TESTS_TABLE_H
#define ROLLCOIN_TESTS_TABLE_H

#include <stddef.h>

enum { TABLE_COLUMNS = 72, TABLE_CELLS = 8000, TABLE_LINE = 4096 };

struct table {
    size_t rows, columns;
    char names[TABLE_COLUMNS][16];
    double cells[TABLE_CELLS];
    char header[TABLE_LINE]; /* the '#' lines */
};

/* Fails the test unless the file is there, well formed and has rows. */
void table_load(struct table *t, const char *file);

int table_has(const struct table *t, const char *column);

/* Fails the test if there is no such column or row. */
double table_at(const struct table *t, size_t row, const char *column);

#endif
