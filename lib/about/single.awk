# SPDX-License-Identifier: MIT
# Writes the whole library as one header: LICENSE, the headers of include/ as
# they are, and the code behind COIN_IMPLEMENTATION.
#     awk -f lib/about/single.awk LICENSE include/*.h lib/*/*.c
# from the top folder.
#
# An include is replaced by the file, as the preprocessor does it.  A header is
# written at its first inclusion, a template (*.t.h, kind.h) and a source at
# every one.  Floats come first; then the headers that depend on the kind of
# number are written once more, for doubles.
#
# Names of file scope: around each source macros give them a prefix, so that a
# static step() of lib/step/rk8.c becomes coin_in_rk8_step().  Macros of a
# source end with it.  What sources share, coin_priv_*, becomes COIN_PRIV, which
# is static.

function stop(message)
{
    print "single.awk: " message > "/dev/stderr"
    failed = 1
    exit 1
}

# Reads a file, and what it includes.
function load(file,    line, n, status)
{
    if (file in lines)
        return
    while ((status = (getline line < file)) > 0) {
        text[file, ++n] = line
        if (line ~ /COIN_PRIV_FLOAT|coin_priv_/)
            of_a_kind[file] = 1
        if (line ~ /^#ifndef ROLLCOIN_/)
            guarded[file] = 1
        if (line ~ /^#include </ && line !~ /<coinf?\.h>/)
            systems[line] = 1
    }
    close(file)
    if (status < 0 || n == 0)
        stop(file ": cannot be read")
    lines[file] = n
    for (n = 1; n <= lines[file]; ++n)
        if (text[file, n] ~ /^#include "/) {
            line = included(file, text[file, n])
            load(line)
            if (!(line in guarded) && line in of_a_kind)
                of_a_kind[file] = 1
        }
}

# The file that a line of `file` includes: its path from the top folder.
function included(file, line,    path)
{
    split(line, path, "\"")
    sub(/[^\/]*$/, "", file)
    file = file path[2]
    while (sub(/[^\/.]+\/\.\.\//, "", file))
        ;
    return file
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

# A file without licence and system headers.  What a header only declares
# becomes COIN_PRIV.  Before end_floats() each coin_priv_ is coinf_priv_.
function write(file,    n, line, begins)
{
    if (file in guarded) {
        if (file in written)
            return
        written[file] = 1
        title(file)
    }
    if (file ~ /\/kind\.h$/ && !kind_changed)
        return
    kind_changed = file !~ /\/kind\.h$/ && kind_changed
    begins = 1
    for (n = 1; n <= lines[file]; ++n) {
        line = text[file, n]
        if (line ~ /^#(define|undef) COIN_PRIV_(FLOAT|PAIR|ABREAST)$/)
            kind_changed = 1
        if (line ~ /^#include "/)
            write(included(file, line))
        else if (line !~ /^#include <|SPDX-License-Identifier/) {
            note_macro(file, line)
            if (begins && file in guarded &&
                line ~ /^[a-z]/ &&
                line !~ /^(static|typedef|struct|enum|union)[ \t]/)
                line = "COIN_PRIV " line
            if (floats_now)
                gsub(/coin_priv_/, "coinf_priv_", line)
            put(line)
        }
        begins = line ~ /^#|^$|[;}]$|\*\/$/
    }
}

# Macros of headers stay to the end of the kind, those of sources and templates
# to the end of the source.
function note_macro(file, line)
{
    if (line !~ /^# *define /)
        return
    sub(/^# *define /, "", line)
    sub(/[^A-Za-z_0-9].*/, "", line)
    if (file in guarded && file in of_a_kind)
        kind_macros[line] = 1
    else if (file ~ /\/kind\.h$/)
        kind_macros[line] = loose_macros[line] = 1
    else if (!(file in guarded))
        source_macros[line] = 1
}

# Writes a line for each name of a set, in order, so that every awk gives equal
# bytes: before, the name, after.
function put_each(before, set, after,    name, i, n, sorted)
{
    for (name in set) {
        for (i = n++; i > 0 && sorted[i] > name; --i)
            sorted[i + 1] = sorted[i]
        sorted[i + 1] = name
    }
    for (i = 1; i <= n; ++i)
        put(before sorted[i] (after == "" ? "" : after sorted[i]))
}

function undefine(macros)
{
    put("")
    put_each("#undef ", macros)
    split("", macros)
}

# Notes the names that a source gives at file scope.  They stand in lines that
# begin at the left: a tag, a type, an enumerator, a function, a table.
function note_names(file,    n, line)
{
    for (n = 1; n <= lines[file]; ++n) {
        line = text[file, n]
        if (line ~ /^#include "/ && !(included(file, line) in guarded))
            note_names(included(file, line))
        if (line ~ /^}? ?[a-z_]+;$/) # the end of a typedef or an object
            gsub(/[^a-z_]/, "", line)
        else if (line !~ /^(static|typedef|struct|enum|COIN_PRIV_[A-Z]+) / &&
                 line !~ /^PART /)
            continue
        sub(/ *\/\*.*/, "", line)
        note_name_of(line)
    }
}

function note_name_of(line,    words, n, k)
{
    if (sub(/^enum \{/, "", line)) {
        gsub(/=[^,]*/, "", line)
        n = split(line, words, /[^A-Za-z_0-9]+/)
        for (k = 1; k <= n; ++k)
            note_name(words[k])
        return
    }
    if (match(line, /(struct|enum) [a-z_]+ \{/)) {
        split(substr(line, RSTART), words, " ")
        note_name(words[2])
    }
    # A function, a table, a type: the word before the first of these.
    if (match(line, /[A-Za-z_0-9]+ ?(\(|\[|=|;| COIN_PRIV_VECTOR)/)) {
        line = substr(line, RSTART, RLENGTH)
        sub(/[^A-Za-z_0-9].*/, "", line)
        note_name(line)
    }
}

function note_name(name)
{
    if (name != "" && name !~ /^(coinf?_|COINF?_)/)
        names[name] = 1
}

# Static functions that nobody calls are no fault: COIN_API may be static.
function gcc_and_clang(pragma)
{
    put("#if defined(__GNUC__)")
    put("#pragma GCC diagnostic " pragma)
    put("#endif")
}

function gcc_only(pragma)
{
    put("#if defined(__GNUC__) && !defined(__clang__) && " \
        "!defined(__TINYC__)")
    put("#pragma GCC " pragma)
    put("#endif")
}

# The headers that a source includes are written before it, since its names and
# its pragmas are its own.
function source(file,    n, k, stem, inner)
{
    for (n = 1; n <= lines[file]; ++n)
        if (text[file, n] ~ /^#include "/)
            bring(included(file, text[file, n]))
    stem = file
    gsub(/.*\/|\.c$/, "", stem)
    split("", names)
    split("", source_macros)
    note_names(file)
    title(file)
    gcc_only("push_options")
    put_each("#define ", names, " coin_in_" stem "_")
    write(file)
    for (k in names)
        source_macros[k] = 1
    undefine(source_macros)
    gcc_only("pop_options")
}

# The headers of a source that another includes belong to the latter too.
function bring(file,    n)
{
    if (file in guarded)
        write(file)
    else
        for (n = 1; n <= lines[file]; ++n)
            if (text[file, n] ~ /^#include "/)
                bring(included(file, text[file, n]))
}

# Ends the floats: the headers are to be written for doubles.
function end_floats(    file)
{
    undefine(kind_macros)
    kind_changed = 1
    floats_now = 0
    for (file in of_a_kind)
        delete written[file]
}

function introduction(version,    n)
{
    put("/* SPDX-License-Identifier: MIT */")
    put("/* librollcoin " version " as one header: the motion of a coin on a " \
        "table.")
    put(" * Include it wherever its functions are called, and in one file, of")
    put(" * C99 or C++11 and later, write before that, and before any macro " \
        "of your own,")
    put(" *")
    put(" *     #define COIN_IMPLEMENTATION")
    put(" *")
    put(" * Any flags will do but fast-math, and clang's explicit " \
        "-ffp-contract=fast,")
    put(" * which coin_selftest() reports.  With `#define COIN_API static` " \
        "the functions")
    put(" * stay in that file.  Needs sqrt and log of libm.  Written by " \
        "`make single`.")
    put(" *")
    for (n = 1; n <= lines["LICENSE"]; ++n)
        put(text["LICENSE", n] == "" ? " *" : " * " text["LICENSE", n])
    put(" */")
}

function version(    n, line, found)
{
    for (n = 1; n <= lines["include/coin.h"]; ++n) {
        line = text["include/coin.h", n]
        if (sub(/^#define COIN_VERSION_[MP][A-Z]* /, "", line))
            found = found (found == "" ? "" : ".") line
    }
    return found
}

function public_header(file,    n)
{
    title(file)
    for (n = 1; n <= lines[file]; ++n)
        if (text[file, n] !~ /SPDX-License-Identifier|^#include <coin/)
            put(text[file, n])
}

# Names that the code takes for itself while it lasts.
function claim_names(    n, line)
{
    for (n = 1; n <= lines["lib/motion/kind.h"]; ++n) {
        line = text["lib/motion/kind.h", n]
        if (sub(/^#undef /, "", line)) {
            put("#ifdef " line)
            put("#error \"define " line " after the code of coin.h\"")
            put("#endif")
        }
    }
}

BEGIN {
    for (k = 1; k < ARGC; ++k)
        load(ARGV[k])
    introduction(version())
    put("#ifndef COIN_API")
    put("#define COIN_API")
    put("#endif")
    gcc_and_clang("push")
    gcc_and_clang("ignored \"-Wunused-function\"")
    for (k = 1; k < ARGC; ++k)
        if (ARGV[k] ~ /\.h$/)
            public_header(ARGV[k])
    put("")
    put("#if defined(COIN_IMPLEMENTATION) && !defined(COIN_IMPLEMENTED)")
    put("#define COIN_IMPLEMENTED")
    put("")
    claim_names()
    put("")
    put("/* What the sources share; tests of it link to it. */")
    put("#ifndef COIN_PRIV")
    put("#define COIN_PRIV static")
    put("#endif")
    put("")
    put_each("", systems)
    gcc_only("push_options")
    floats_now = 1
    for (k = 1; k < ARGC; ++k)
        if (ARGV[k] ~ /^lib\/float\/.*\.c$/)
            source(ARGV[k])
    end_floats()
    for (k = 1; k < ARGC; ++k)
        if (ARGV[k] ~ /\.c$/ && ARGV[k] !~ /^lib\/float\//)
            source(ARGV[k])
    undefine(loose_macros)
    put("")
    put("/* What follows is the user's again. */")
    put("#if defined(__clang__)")
    put("#pragma STDC FP_CONTRACT DEFAULT")
    put("#endif")
    gcc_only("pop_options")
    put("#endif")
    gcc_and_clang("pop")
}

END {
    exit failed
}
