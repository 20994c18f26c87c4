# SPDX-License-Identifier: MIT
# The comments of coin.h as Doxygen reads them: the parts of its head, Accuracy
# and Cost have titles, and the tables of its head stay as they stand.
/^#ifndef ROLLCOIN/ { past = 1 }
!past {
    gsub(/@return/, "list of results")
    if (/^ \*   / && !table++)
        print " * @verbatim"
    if (/^ \*   /) {
        print substr($0, 4)
        next
    }
    if (table)
        print " * @endverbatim"
    table = 0
    if (match($0, /^ \* [A-Z]+\. /)) {
        print " * @par " substr($0, 4, RLENGTH - 5)
        print " * " substr($0, RLENGTH + 1)
        next
    }
}
/^ \* (Accuracy|Cost): / {
    print " * @par " substr($2, 1, length($2) - 1)
    sub(/(Accuracy|Cost): /, "")
}
{ print }
