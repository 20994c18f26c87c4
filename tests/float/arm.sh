#!/bin/sh
# SPDX-License-Identifier: MIT
# The sources of coinf.h, compiled for a Cortex-M4F, whose unit knows floats
# only: they call nothing but each other, sqrtf and logf of libm, and what moves
# 64 bits or bytes; so no double arithmetic, which would be a call of
# __aeabi_d*.  And what a step takes of code; make firmware has its stack.
# From `make float-check`: ARM SRC OUT.
set -eu
work=$OUT/float/arm
rm -rf "$work"
mkdir -p "$work"

# Bytes of code of the stepping core by -Os: what docs/embedding.md says.
CORE_MOST=2560

# compile LEVEL
compile()
{
    for file in "$SRC"/lib/float/*.c; do
        # shellcheck disable=SC2086
        $ARM -mthumb -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard \
            $1 -std=c99 -ffp-contract=off -fno-tree-vectorize -fno-math-errno \
            -ffunction-sections -Werror -I"$SRC/include" \
            -c "$file" -o "$work/$(basename "$file" .c).o"
    done
    arm-none-eabi-nm -g --defined-only "$work"/*.o | sed -n 's/.* [A-Z] //p' |
        LC_ALL=C sort -u >"$work/defined"
    arm-none-eabi-nm -u "$work"/*.o | sed -n 's/^ *U //p' |
        LC_ALL=C sort -u | LC_ALL=C comm -23 - "$work/defined" >"$work/needed"
    echo "$1: needs $(tr '\n' ' ' <"$work/needed")"
    if grep -vxE 'logf|sqrtf|memcpy|memset|__aeabi_(u?l2f|f2u?lz|lmul)' \
        "$work/needed"; then
        echo "no float object may need that"
        exit 1
    fi
}

# code FUNCTION...: bytes of their sections in coinf_step.o.
code()
{
    for name in "$@"; do
        arm-none-eabi-size -A "$work/coinf_step.o" |
            awk -v name=".text.$name" '$1 == name {print $2; found = 1}
                END {exit !found}' >>"$work/sizes" ||
            { echo "no function $name" >&2; exit 1; }
    done
    awk '{n += $1} END {print n}' "$work/sizes"
}

# The search must find what it is looking for.
echo 'double f(double a, double b) { return a * b; }' |
    $ARM -mthumb -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard -O2 -x c \
        -c - -o "$work/control.o"
arm-none-eabi-nm -u "$work/control.o" | grep -q __aeabi_dmul
rm "$work/control.o"

compile -Os
core=$(code coinf_priv_step_from coinf_priv_residue \
    coinf_priv_sine_cosine_with_low coinf_priv_variables_with_low \
    coinf_priv_reduce coinf_priv_finish_step)
echo "-Os: the stepping core is $core bytes, at most $CORE_MOST"
compile -O2
test "$core" -le $CORE_MOST
