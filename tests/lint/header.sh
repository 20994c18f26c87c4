#!/bin/sh
# SPDX-License-Identifier: MIT
# coin.h alone and both headers, in every dialect that a user may compile them
# in.
#     header.sh INCLUDE
set -eu
status=0

try()
{
    # shellcheck disable=SC2086
    for header in coin.h coinf.h; do
        printf '#include <%s>\n#include <coin.h>\n' $header |
            $1 -Wall -Wextra -Werror -pedantic -I"$include" -fsyntax-only - ||
            { echo "$header: not clean under $1" >&2; status=1; }
    done
}

include=$1
for std in gnu89 c99 c11 c17 c2x; do
    try "gcc -x c -std=$std"
    try "clang -x c -std=$std"
done
for std in c++98 c++11 c++14 c++17 c++20; do
    try "g++ -x c++ -std=$std"
    try "clang++ -x c++ -std=$std"
done
test $status = 0 && echo "coin.h, coinf.h: clean in C89-gnu to C2x and C++98 to C++20"
exit $status
