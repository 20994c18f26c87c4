# SPDX-License-Identifier: MIT
# The comments of coin.h as Doxygen reads them: its sections are groups, each
# argument is listed, the parts of its head, Accuracy and Cost have titles, and
# tables, indented by three blanks, stay as they stand.

BEGIN {
    joined["parameters"] = joined["state"] = "parameters and states"
    joined["observables"] = joined["validity"] = "what can be read off a state"
    says["p"] = "the parameters"
    says["s"] = "the state"
    says["b"] = "the body"
    says["l"] = "the losses"
    says["o"] = "the orbit"
    says["table"] = "the table"
    says["out"] = "the result"
    says["mass"] = "[M]"
    says["radius"] = "[L]"
    says["gravity"] = "[L/T^2]"
    says["dt"] = "length of a step [T]"
    says["method"] = "COIN_RK4 and the like"
    says["m"] = "[16] the matrix"
    says["status"] = "what a function returned"
    says["type"] = "the name of a struct"
}

# The sections of coin.h as groups.
function section(line)
{
    gsub(/^\/\* -+ | -+ \*\/$/, "", line)
    if (line == "types" || FILENAME !~ /coin\.h$/)
        return
    line = line in joined ? joined[line] : line
    if (line == group)
        return
    if (group)
        print "/** @} */"
    group = line
    gsub(/[^a-z]+/, "_", line)
    print "/** @defgroup " line " " toupper(substr(group, 1, 1)) substr(group, 2)
    print " * @{ */"
}

# The arguments that the comment of a function does not name.
function unnamed(comment, declaration, of, count, k, name, lines)
{
    sub(/^[^(]*\(/, "", declaration)
    sub(/\);.*/, "", declaration)
    count = split(declaration, of, /, */)
    for (k = 1; k <= count; ++k) {
        name = of[k]
        sub(/\[.*/, "", name)
        sub(/.*[ *]/, "", name)
        if (name != "void" && comment !~ "@param[^ ]* +([a-z]+,)*" name "[ ,]")
            lines = lines " * @param" (name ~ /^(out|m)$/ || \
                of[k] ~ /^ *coin_params \*/ ? "[out]" : "") " " name "  " \
                says[name] "\n"
    }
    return lines
}

# A comment and what it stands before.
function release(lines, k, comment, declaration, more)
{
    for (k = 1; k <= held; ++k)
        if (k <= ends)
            comment = comment line[k] "\n"
        else
            declaration = declaration " " line[k]
    if (declaration ~ /^ COIN_API/ && FILENAME ~ /coin\.h$/)
        more = unnamed(comment, declaration)
    for (k = 1; k <= held; ++k) {
        if (more && k <= ends && line[k] ~ /^ \* (@param|@return|Accuracy|Cost)/) {
            printf "%s", more
            more = ""
        }
        if (more && k == ends) {
            sub(/ *\*\/$/, "", line[k])
            line[k] = line[k] "\n" more " */"
        }
        show(line[k])
    }
    held = 0
}

# The lines of a comment wait for its end.
function put(text)
{
    if (inside)
        line[++held] = text
    else
        show(text)
}

function show(text)
{
    if (text ~ /^ \* (Accuracy|Cost): /) {
        print " * @par " (text ~ /Accuracy/ ? "Accuracy" : "Cost")
        sub(/(Accuracy|Cost): /, "", text)
    }
    print text
}

/^#ifndef ROLLCOIN/ { past = 1 }
past && /^\/\* -+ .* -+ \*\/$/ {
    section($0)
    next
}
/^#ifdef __cplusplus/ && group {
    print "/** @} */"
    group = ""
}
past && /^\/\*\* / {
    inside = 1
    ends = 0
}
/^ \*   [^ ]/ && !table {
    put(" * @verbatim")
    table = 1
}
table && /^ \*   / {
    put(substr($0, 4))
    next
}
table {
    put("@endverbatim")
    table = 0
}
!past {
    gsub(/@return/, "list of results")
    if (match($0, /^ \* [A-Z]+\. /)) {
        print " * @par " substr($0, 4, RLENGTH - 5)
        print " * " substr($0, RLENGTH + 1)
        next
    }
}
{ put($0) }
inside && !ends && /\*\/$/ {
    ends = held
    next
}
inside && ends && (/[;{]/ || /^$/) {
    inside = 0
    release()
}
