#!/bin/sh
# SPDX-License-Identifier: MIT
# The library needs nothing but a few functions of libm, and holds no writable
# data.
# From `make lint`: OUT.
set -eu
allowed="log logf sqrt sqrtf memcpy memset"
work=$OUT/lint
status=0
mkdir -p "$work"

for kind in static shared; do
    nm --defined-only "$OUT/$kind"/*.o | sed -n 's/.* [A-Z] //p' |
        LC_ALL=C sort -u >"$work/defined"
    nm -u "$OUT/$kind"/*.o | sed -n 's/^ *U //p' |
        grep -v '^_GLOBAL_OFFSET_TABLE_$' | LC_ALL=C sort -u |
        LC_ALL=C comm -23 - "$work/defined" >"$work/needed"
    echo "$kind objects need:" $(cat "$work/needed")
    for name in $(cat "$work/needed"); do
        case " $allowed " in
        *" $name "*) ;;
        *) echo "$kind: $name is not allowed"; status=1 ;;
        esac
    done

    # Sections that are written to, even if only by the dynamic linker.
    writable=$(size -A "$OUT/$kind"/*.o |
        awk '$1 ~ /^\.t?(data|bss)/ || $1 == "COMMON" {n += $2} END {print n+0}')
    text=$(size -A "$OUT/$kind"/*.o |
        awk '$1 ~ /^\.(text|rodata)/ {n += $2} END {print n+0}')
    echo "$kind objects hold $text bytes of code and constants," \
        "$writable of writable data"
    test "$writable" = 0 && test "$text" != 0 || status=1
done
exit $status
