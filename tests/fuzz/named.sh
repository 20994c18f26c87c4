#!/bin/sh
# SPDX-License-Identifier: MIT
# Every public function has a row in a fuzz target, and every row is one.
#     named.sh SRC
set -eu
src=$1
named=$(sed -n 's/^FUNCTION(\(coinf*_[a-z_A-Z0-9]*\),.*/\1/p' \
    "$src"/tests/fuzz/fuzz_*.c | LC_ALL=C sort)
public=$(sed -n '/global:/,/local:/s/^ *\(coinf*_[A-Za-z_0-9]*\);.*/\1/p' \
    "$src/lib/about/rollcoin.map" | LC_ALL=C sort)
test -n "$public"
status=0
for name in $public; do
    case " $(echo $named) " in
    *" $name "*) ;;
    *) echo "$name: no row in tests/fuzz/fuzz_*.c (see tests/fuzz/fuzz.h)"
       status=1 ;;
    esac
done
for name in $named; do
    case " $(echo $public) " in
    *" $name "*) ;;
    *) echo "$name: fuzzed, but not in lib/about/rollcoin.map"; status=1 ;;
    esac
done
test "$(echo "$named" | uniq -d)" = "" || { echo "fuzzed twice"; status=1; }
exit $status
