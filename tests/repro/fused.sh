#!/bin/sh
# SPDX-License-Identifier: MIT
# No multiplication may be fused with an addition, neither by the Makefile's
# flags nor by those of a user who drops the sources into a project: where the
# processor can fuse, the objects are searched for such instructions.  Equal
# hashes alone could be luck: multiplying by 2 or 0.5, fusing changes no bit.
# From `make repro`: MAKE SRC OUT.
set -eu
work=$OUT/fused
rm -rf "$work"
mkdir -p "$work"
. "$SRC/tests/at_once.sh"
failed=0

case $(uname -m) in
x86_64) can_fuse=-march=native ;;
*) can_fuse= ;;
esac

fused_in()
{
    objdump -d --no-show-raw-insn "$@" |
        grep -cE '\<v?fn?m(add|sub|la|ls|acc|sac)' || :
}

# The search must find what it is looking for.
echo 'double f(double a, double b, double c) { return a * b + c; }' |
    gcc -x c -O2 -ffp-contract=fast $can_fuse -c - -o "$work/control.o"
test "$(fused_in "$work/control.o")" = 1 ||
    { echo "this processor cannot fuse: take another"; exit 1; }

report()
{
    count=$(fused_in "$work"/objects/*.o)
    $cc -O1 -I"$SRC/include" "$SRC/tests/repro/hash.c" "$work"/objects/*.o \
        -o "$work/hash" -lm
    echo "$count fused  $1"
    test "$count" = 0 && "$work/hash" | cmp "$SRC/tests/repro/expected.txt" - ||
        failed=1
}

# as_a_user NUMBER FILE: what a user's flags make of a source.
as_a_user()
{
    # shellcheck disable=SC2086
    $cc -std=gnu11 -O3 $can_fuse -I"$SRC/include" -c "$2" \
        -o "$work/objects/$(basename "$2" .c).o"
}

for cc in gcc clang; do
    $MAKE --no-print-directory -f "$SRC/Makefile" "O=$work/make-$cc" "CC=$cc" \
        "CFLAGS=-O3 $can_fuse -ffp-contract=fast" all >/dev/null
    ln -sfn "$work/make-$cc/objects" "$work/objects"
    report "make CC=$cc CFLAGS='-O3 $can_fuse -ffp-contract=fast'"
    rm "$work/objects"
    mkdir "$work/objects"
    ls "$SRC"/lib/*/*.c >"$work/sources"
    at_once as_a_user <"$work/sources"
    report "$cc -std=gnu11 -O3 $can_fuse"
    rm -r "$work/objects"
done

# Flags by which no source may be compiled, whoever passes them.
for cc in gcc clang; do
    for flag in -ffast-math -ffinite-math-only; do
        for source in "$SRC"/lib/*/*.c; do
            ! $cc $flag -fsyntax-only -I"$SRC/include" "$source" 2>/dev/null ||
                { echo "not refused: $cc $flag, $source"; failed=1; }
        done
        echo "refused  $cc $flag"
    done
done
exit $failed
