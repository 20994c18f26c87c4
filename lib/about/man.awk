# SPDX-License-Identifier: MIT
# Writes the manual page rollcoin(3): the groups of coin.h, each type as it is
# declared, each function with the first paragraph of its documentation.
#     awk -v version=... -v date=... -v docs=FOLDER -f man.awk include/coin.h

# Text for roff: no line of it is a request, and a minus stays one.
function escape(line)
{
    gsub(/\\/, "\\e", line)
    gsub(/-/, "\\-", line)
    return line ~ /^[.']/ ? "\\&" line : line
}

function put(line)
{
    if (line != "")
        print escape(line)
}

# What is declared, as it stands in the header.
function put_code(line)
{
    print line == "" ? ".sp" : escape(line)
}

function heading(title)
{
    sub(/^\/\* -+ /, "", title)
    sub(/ -+ \*\/$/, "", title)
    print ".SH " toupper(title)
    after_heading = 1
}

function paragraph()
{
    if (!after_heading)
        print ".PP"
    after_heading = 0
}

# The first paragraph of the comment just read, up to what only coin.h says.
function summary(    n, line)
{
    for (n = 1; n <= comments; ++n) {
        line = comment[n]
        if (line == "" || line ~ /^(@|Accuracy|Cost|Cost:)/)
            return
        put(line)
    }
}

function begin_comment(line)
{
    comments = 0
    in_comment = 1
    add_comment(line)
}

function add_comment(line)
{
    if (line ~ /\*\/$/)
        in_comment = 0
    sub(/ *\*\/$/, "", line)
    sub(/^ *\/\*\*? */, "", line)
    sub(/^ \* ?/, "", line)
    comment[++comments] = line
}

# The first comment is the introduction: a paragraph for each of its own.  Its
# tables are indented.
function introduction(    n, table)
{
    print ".SH DESCRIPTION"
    for (n = 2; n <= comments; ++n) {
        if (table != (comment[n] ~ /^  /))
            print table ? ".fi" : ".nf"
        table = comment[n] ~ /^  /
        if (comment[n] == "")
            print ".PP"
        else
            put(comment[n])
    }
    introduced = 1
}

# A declaration goes on until its end: a prototype's ";" or a type's "}".
function declare(line)
{
    if (!in_code) {
        paragraph()
        is_type = line ~ /^(typedef|enum)/
        if (is_type) {
            summary()
            paragraph()
        }
        print ".nf"
    }
    in_code = 1
    if (!is_type)
        sub(/^(COIN_API |         )/, "", line)
    gsub(/\/\*\*< /, "/* ", line)
    put_code(line)
    if (line !~ (is_type ? "^}" : ";$"))
        return
    print ".fi"
    in_code = 0
    if (!is_type) {
        print ".RS 4"
        summary()
        print ".RE"
    }
}

BEGIN {
    print ".\\\" From coin.h, by lib/about/man.awk."
    print ".TH ROLLCOIN 3 \"" date "\" \"rollcoin " version "\" \"Library functions\""
    print ".SH NAME"
    print "rollcoin \\- the motion of a coin, a disc or a ring on a table"
    print ".SH SYNOPSIS"
    print ".nf"
    print "#include <coin.h>"
    print "#include <coinf.h>"
    print ".sp"
    print "cc program.c $(pkg\\-config \\-\\-cflags \\-\\-libs rollcoin)"
    print ".fi"
}

in_comment {
    add_comment($0)
    next
}
!introduced && /^#ifndef ROLLCOIN_COIN_H/ {
    introduction()
}
!introduced && !/^\/\*\*/ {
    next
}
/^\/\* -+ .* -+ \*\/$/ {
    heading($0)
    next
}
in_code || /^(typedef|enum|COIN_API) ?/ {
    declare($0)
    next
}
/^\/\*\*/ {
    begin_comment($0)
}

END {
    print ".SH FLOATS"
    print ".I coinf.h"
    print "has the functions that serve firmware once more, for floats: coinf_"
    print "for coin_."
    print ".SH FILES"
    print ".TP"
    print ".I " escape(docs)
    print "a first hour, the physics with the numbered equations, figures of"
    print "accuracy and cost, and what compiled programs may rely on"
    print ".SH SEE ALSO"
    print ".BR pkg\\-config (1)"
}
