#!/bin/sh
# SPDX-License-Identifier: MIT
# Each header of lib/, templates too, is a translation unit by itself, as every
# source is: it includes what it needs and nothing is redefined on the way.
# From `make lint`: SRC.
set -eu
status=0
count=0
for file in "$SRC"/lib/*/*.h; do
    # A main file's inline functions and tables may go unused.
    gcc -x c -std=c99 -Wall -Wextra -Wno-unused-function \
        -Wno-unused-const-variable -Werror -I"$SRC/include" -fsyntax-only \
        "$file" || status=1
    count=$((count + 1))
done
echo "$count headers, each by itself"
exit $status
