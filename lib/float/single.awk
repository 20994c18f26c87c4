# SPDX-License-Identifier: MIT
# Writes the whole library as one header: LICENSE, the headers of include/ as
# they are, and the code behind COIN_IMPLEMENTATION.
#     awk -f lib/single.awk LICENSE include/*.h lib/*.c      from the top folder
#
# In the code every name of file scope is made one of its own: what is local to
# lib/rk4.c gets the prefix coin_priv_rk4_, so that neither two sources nor the
# user's file meet; what sources share, coin_priv_*, becomes COIN_PRIV, which
# is static.  A header with a guard is taken once, before the first source that
# needs it; one without (a template such as dop8.h) wherever it is included, and
# so is one whose guard a source lifts by #undef.

# ------------------------------------------------------------------- reading --
function load(file,    line, n, status)
{
    while ((status = (getline line < file)) > 0)
        text[file, ++n] = line
    close(file)
    if (status < 0 || n == 0)
        stop(file ": cannot be read")
    lines[file] = n
    for (n = 1; n <= lines[file]; ++n)
        if (text[file, n] ~ /^#include </)
            note_system(text[file, n])
        else
            included(text[file, n])
}

function note_system(line)
{
    if (line !~ /<coinf?\.h>/ && !(line in seen_system)) {
        seen_system[line] = 1
        systems = systems line "\n"
    }
}

# The file of lib/ that a line includes, or nothing.
function included(line)
{
    if (line !~ /^#include "/)
        return ""
    sub(/^#include "/, "", line)
    sub(/".*/, "", line)
    line = "lib/" line
    if (!(line in lines))
        load(line)
    return line
}

# The guard of a header, or nothing.
function guard_of(file,    n)
{
    for (n = 1; n <= lines[file]; ++n)
        if (text[file, n] ~ /^#/)
            return text[file, n] ~ /^#ifndef ROLLCOIN_/ ? \
                substr(text[file, n], 9) : ""
    return ""
}

function guarded(file)
{
    return guard_of(file) != ""
}

function stop(message)
{
    print "single.awk: " message > "/dev/stderr"
    failed = 1
    exit 1
}

# ------------------------------------------------------------------ scanning --
# A line, token by token; comments and text go through as they are.  Between
# lines the scanner remembers whether it is in a comment or a directive, and
# how deep in braces and parentheses.
function scan_begin()
{
    in_comment = in_directive = depth = enum_depth = 0
    before = ""
}

# With collect, notes the names of file scope; without, returns the line with
# these names, those in local, prefixed.
function scan(line, collect,    out, c, word, rest)
{
    if (!in_comment && !in_directive && line ~ /^#/)
        in_directive = 1
    directive = in_directive
    if (collect && directive && line ~ /^# *define /)
        note_macro(line)
    while (line != "") {
        if (in_comment) {
            if (!(c = index(line, "*/"))) {
                out = out line
                break
            }
            in_comment = 0
            out = out substr(line, 1, c + 1)
            line = substr(line, c + 2)
        } else if (substr(line, 1, 2) == "/*") {
            in_comment = 1
            out = out "/*"
            line = substr(line, 3)
        } else if (match(line, /^("([^"\\]|\\.)*"|'([^'\\]|\\.)*')/) ||
                   match(line, /^[.]?[0-9]([0-9A-Za-z_.]|[eEpP][-+])*/)) {
            out = out substr(line, 1, RLENGTH)
            line = substr(line, RLENGTH + 1)
            before = "0"
        } else if (match(line, /^[A-Za-z_][A-Za-z_0-9]*/)) {
            word = substr(line, 1, RLENGTH)
            rest = substr(line, RLENGTH + 1)
            if (collect && !directive)
                note_name(word, rest)
            out = out named(word, rest)
            line = rest
            before = word
        } else {
            c = substr(line, 1, 1)
            out = out c
            line = substr(line, 2)
            if (!directive)
                nest(c)
            if (c != " ")
                before = (c == ">" && before == "-") ? "->" : c
        }
    }
    in_directive = directive && out ~ /\\$/
    return out
}

function nest(c)
{
    if (c == "{" && enum_depth == -1)
        enum_depth = depth + 1
    if (c ~ /[{(]/)
        ++depth
    else if (c ~ /[})]/ && depth-- == enum_depth)
        enum_depth = 0
}

# The word as it is called in the single header.
function named(word, rest)
{
    if (before == "." || before == "->" || in_public(word))
        return word
    if (word in local || (rest ~ /^##/ && word in pasted))
        return prefix word
    return word
}

function in_public(word)
{
    return word ~ /^(coinf?_|COINF?_|__)/
}

# A name of file scope is followed by one of these; or it is a tag,
# or an enumerator.
function note_name(word, rest,    found)
{
    if (word == "enum" && depth == 0)
        enum_depth = -1
    if (in_public(word))
        return
    if (before == "struct" || before == "union")
        found = depth == 0 && rest ~ /^ *{/
    else if (depth == 0)
        found = rest ~ /^ *([(=;,[]|__attribute__)/
    else
        found = depth == enum_depth && before ~ /^[{,]$/
    if (found)
        local[word] = 1
}

function note_macro(line)
{
    sub(/^# *define /, "", line)
    match(line, /^[A-Za-z_0-9]+/)
    line = substr(line, 1, RLENGTH)
    # lanes.c makes vectors of numbers, and a function of them from fabsf.
    if (in_public(line) || line ~ /^(double|float|fabsf)$/)
        return
    local[line] = 1
    if (sub(/[0-9]+$/, "", line))
        pasted[line] = 1 # ROW12 is called as ROW##i
}

# ------------------------------------------------------------------- writing --
# The text of a source, with its templates, without licence and includes.
function body(file, collect,    n, inner, line)
{
    for (n = 1; n <= lines[file]; ++n) {
        line = text[file, n]
        inner = included(line)
        if (inner != "" && (!guarded(inner) || guard_of(inner) in lifted))
            body(inner, collect)
        if (line ~ /^#undef ROLLCOIN_/)
            lifted[substr(line, 8)] = 1
        if (line ~ /^#include / || line ~ /SPDX-License-Identifier/)
            continue
        line = scan(line, collect)
        if (!collect)
            put(line)
    }
}

# At most one empty line in a row.
function put(line)
{
    if (line != "" || !was_empty)
        print line
    was_empty = line == ""
}

function title(name)
{
    put("")
    put("/* " substr("----------------------------------------------------" \
        "---------------------", 1, 72 - length(name)) " " name " */")
}

# The guarded headers that a file needs, once each, the lowest first.
function bring(file,    n, inner)
{
    for (n = 1; n <= lines[file]; ++n) {
        inner = included(text[file, n])
        if (inner == "" || inner in brought)
            continue
        if (guarded(inner))
            brought[inner] = 1
        bring(inner)
        if (guarded(inner))
            header(inner)
    }
}

# A shared header: what it only declares becomes COIN_PRIV.
function header(file,    n, line, fresh)
{
    title(file)
    scan_begin()
    fresh = 1
    for (n = 1; n <= lines[file]; ++n) {
        line = text[file, n]
        if (line ~ /^#include / || line ~ /SPDX-License-Identifier/)
            continue
        fresh = depth == 0 && !in_comment && !in_directive &&
                before ~ /^(|;|})$/
        if (fresh && line ~ /^[a-z]/ &&
            line !~ /^(static|typedef|struct|enum|union|extern)[ \t]/)
            put("COIN_PRIV " line)
        else
            put(line)
        scan(line, 0)
        if (directive)
            before = fresh ? "" : before
    }
}

function source(file,    stem)
{
    bring(file)
    stem = file
    sub(/.*\//, "", stem)
    sub(/\.c$/, "", stem)
    if (stem in stems)
        stop(file " and " stems[stem] ": one name, and so one prefix")
    stems[stem] = file
    prefix = "coin_priv_" stem "_"
    split("", lifted)
    split("", local)
    split("", pasted)
    scan_begin()
    body(file, 1)
    title(file)
    gcc_only("push_options")
    scan_begin()
    body(file, 0)
    gcc_only("pop_options")
}

function gcc_only(pragma)
{
    put("#if defined(__GNUC__) && !defined(__clang__) && " \
        "!defined(__TINYC__)")
    put("#pragma GCC " pragma)
    put("#endif")
}

function as_comment(file,    n)
{
    put(" *")
    for (n = 1; n <= lines[file]; ++n)
        put(text[file, n] == "" ? " *" : " * " text[file, n])
}

function verbatim(file,    n)
{
    title(file)
    for (n = 1; n <= lines[file]; ++n)
        if (text[file, n] !~ /SPDX-License-Identifier|^#include <coin/)
            put(text[file, n])
}

function version(file,    n, found)
{
    for (n = 1; n <= lines[file]; ++n)
        if (text[file, n] ~ /^#define COIN_VERSION_(MAJOR|MINOR|PATCH) /)
            found = found "." substr(text[file, n],
                                     match(text[file, n], /[0-9]+$/))
    return substr(found, 2)
}

function introduction(    k)
{
    put("/* SPDX-License-Identifier: MIT */")
    put("/* librollcoin " version("include/coin.h") " as one header: the " \
        "motion of a coin that rolls without")
    put(" * slipping.  Include it wherever its functions are called, and " \
        "in one file, of")
    put(" * C99 or C++11 and later, write before that")
    put(" *")
    put(" *     #define COIN_IMPLEMENTATION")
    put(" *")
    put(" * Any flags will do but fast-math, and clang's explicit " \
        "-ffp-contract=fast,")
    put(" * which coin_selftest() reports.  With `#define COIN_API static` " \
        "the functions")
    put(" * stay in that file.  Needs sqrt and log of libm.  Written by " \
        "`make single`.")
    for (k = 1; k < ARGC; ++k)
        if (ARGV[k] == "LICENSE")
            as_comment(ARGV[k])
    put(" */")
}

BEGIN {
    for (k = 1; k < ARGC; ++k)
        load(ARGV[k])
    introduction()
    put("#ifndef COIN_API")
    put("#define COIN_API")
    put("#endif")
    for (k = 1; k < ARGC; ++k)
        if (ARGV[k] ~ /\.h$/)
            verbatim(ARGV[k])
    put("")
    put("#if defined(COIN_IMPLEMENTATION) && !defined(COIN_IMPLEMENTED)")
    put("#define COIN_IMPLEMENTED")
    put("")
    put("/* What the sources share; tests of it link to it. */")
    put("#ifndef COIN_PRIV")
    put("#define COIN_PRIV static")
    put("#endif")
    put("")
    printf "%s", systems
    put("")
    gcc_only("push_options")
    for (k = 1; k < ARGC; ++k)
        if (ARGV[k] ~ /\.c$/)
            source(ARGV[k])
    put("")
    put("/* What follows is the user's again. */")
    put("#if defined(__clang__)")
    put("#pragma STDC FP_CONTRACT DEFAULT")
    put("#endif")
    gcc_only("pop_options")
    put("#endif")
}

END {
    exit failed
}
