# SPDX-License-Identifier: MIT
# Turns a source of lib/ into single precision, word by word and line by line:
# double becomes float, 1.0 becomes 1.0f, sqrt becomes sqrtf, coin_x becomes
# coinf_x, "x.h" becomes "coinf_x.h".  Comments stay as they are.
#     awk -f lib/float/float.awk FILE
BEGIN {
    split("sqrt fabs log floor", names)
    for (i in names)
        becomes[names[i]] = names[i] "f"
    becomes["double"] = "float"
}

# A name.
function word(w) {
    if (w in becomes)
        return becomes[w]
    if (w ~ /^coin_/ || w ~ /^COIN_PRIV_/)
        return substr(w, 1, 4) (w ~ /^c/ ? "f" : "F") substr(w, 5)
    sub(/^ROLLCOIN_/, "ROLLCOIN_COINF_", w)
    sub(/^DBL_/, "FLT_", w)
    return w
}

# A number: with a point or an exponent it is a double, unless hexadecimal.
function number(n) {
    return n ~ /^0[xX]/ || n ~ /f$/ || n !~ /[.eE]/ ? n : n "f"
}

# The code of a line up to a comment or a string; what is left goes to rest.
function code(line,    out) {
    out = ""
    while (line != "") {
        if (substr(line, 1, 2) == "/*" || substr(line, 1, 1) == "\"")
            break
        if (match(line, /^[A-Za-z_][A-Za-z_0-9]*/))
            out = out word(substr(line, 1, RLENGTH))
        else if (match(line, /^[0-9][0-9.]*([eE][-+]?[0-9]+)?[A-Za-z0-9]*/))
            out = out number(substr(line, 1, RLENGTH))
        else {
            match(line, /^./)
            out = out substr(line, 1, 1)
        }
        line = substr(line, RLENGTH + 1)
    }
    rest = line
    return out
}

# Moves from rest to the result what is up to the end of text.
function past(text, from,    at) {
    at = index(substr(rest, from), text)
    if (at == 0) {
        at = length(rest)
        inside = text == "*/"
    } else {
        at += from - 1 + length(text) - 1
        inside = 0
    }
    done = substr(rest, 1, at)
    rest = substr(rest, at + 1)
    return done
}

{
    rest = $0
    sub(/^#include <coin\.h>/, "#include <coinf.h>", rest)
    sub(/^#include "/, "#include \"coinf_", rest)
    result = inside ? past("*/", 1) : ""
    while (rest != "") {
        result = result code(rest)
        if (rest ~ /^\/\*/)
            result = result past("*/", 3)
        else if (rest != "")
            result = result past("\"", 2)
    }
    print result
}

NR == 1 {
    print "/* Made by lib/float/float.awk from lib/: do not edit. */"
}
