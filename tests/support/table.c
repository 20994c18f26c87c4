/* SPDX-License-Identifier: MIT */
#include "table.h"

#include "check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void read_names(struct table *t, char *line)
{
    for (char *n = strtok(line, ",\n"); n; n = strtok(NULL, ",\n")) {
        check(t->columns < TABLE_COLUMNS && strlen(n) < sizeof *t->names);
        strcpy(t->names[t->columns++], n);
    }
}

static void read_row(struct table *t, const char *line)
{
    double *cells = t->cells + t->rows * t->columns;
    check((t->rows + 1) * t->columns <= TABLE_CELLS);
    for (size_t i = 0; i < t->columns; ++i) {
        char *end;
        cells[i] = strtod(line, &end);
        check(end != line && *end == (i + 1 < t->columns ? ',' : '\n'));
        line = end + 1;
    }
    ++t->rows;
}

static void read_comment(struct table *t, const char *line)
{
    check(strlen(t->header) + strlen(line) < sizeof t->header);
    strcat(t->header, line);
}

static void read_line(struct table *t, char *line)
{
    if (line[0] == '#')
        read_comment(t, line);
    else if (t->columns == 0)
        read_names(t, line);
    else
        read_row(t, line);
}

void table_load(struct table *t, const char *file)
{
    char path[512], line[TABLE_LINE];
    check_note("%s", file);
    snprintf(path, sizeof path, "%s/%s", TEST_DATA, file);
    memset(t, 0, sizeof *t);
    FILE *in = fopen(path, "r");
    check(in != NULL);
    while (fgets(line, sizeof line, in))
        read_line(t, line);
    fclose(in);
    check(t->rows > 0);
}

static size_t find(const struct table *t, const char *column)
{
    size_t i = 0;
    while (i < t->columns && strcmp(t->names[i], column))
        ++i;
    return i;
}

int table_has(const struct table *t, const char *column)
{
    return find(t, column) < t->columns;
}

double table_at(const struct table *t, size_t row, const char *column)
{
    const size_t i = find(t, column);
    check(row < t->rows && i < t->columns);
    return t->cells[row * t->columns + i];
}
