#!/bin/sh
# SPDX-License-Identifier: MIT
# A program pays for what it calls: bytes of code and constants that one call
# adds to it, linked to the static library as anyone would.  Of those without a
# limit coin_run() holds all methods, from which it chooses as it runs.
# docs/design.md names each object of more than 8 kB, with its reason.
# From `make lint`: CC SRC OUT.
set -eu
work=$OUT/lint
status=0
mkdir -p "$work"

# Bytes of the program whose main() is the input.
program()
{
    { echo '#include <coin.h>'; echo 'coin_state s; coin_params p;'
      echo 'coin_force f; coin_losses l; coin_table table; coin_body b;'
      echo "int main(void) { return $1; }"
    } >"$work/pay.c"
    $CC -O2 -I"$SRC/include" "$work/pay.c" "$OUT/librollcoin.a" -lm \
        -o "$work/pay"
    bytes "$work/pay"
}

bytes()
{
    size -A "$1" | awk '$1 ~ /^\.(text|rodata)/ {n += $2} END {print n + 0}'
}

none=$(program 0)
while read -r most call; do
    added=$(($(program "$call") - none))
    echo "$added bytes for $call"
    test "$most" = - || test "$added" -le "$most" ||
        { echo "more than $most"; status=1; }
done <<END
10000 coin_step(&s, &p, .01)
7000 coin_check(&s, &p, COIN_RK8, .01, .3)
5000 coin_energy(&s, &p)
7000 coin_reaction(&s, &p, &f)
40000 coin_settle(&s, &p, &l, 1, 1e-9, 0)
75000 coin_move(&b, &p, &table, 1, 1e-9, 0, 0)
- coin_run(&s, &p, COIN_RK4, .01, 9, 0)
45000 coin_advance(&s, &p, 1, 1e-9, 0)
- coin_batch_run(&s, 1, &p, COIN_RK4, .01, 9, 0)
END

for object in "$OUT"/objects/*.o; do
    name=$(basename "$object" .o)
    test "$(bytes "$object")" -le 8000 || grep -q "\`$name\.c\`" \
        "$SRC/docs/design.md" || {
        echo "docs/design.md does not say why $name.c takes" \
            "$(bytes "$object") bytes"
        status=1
    }
done
exit $status
