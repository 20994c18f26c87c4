#!/bin/sh
# SPDX-License-Identifier: MIT
# The library needs nothing but a few functions of libm, and holds no writable
# data.
#   objects.sh                 what `make lint` built: SRC OUT
#   objects.sh NAME OBJECT...  those of another processor: TOOLS, the prefix of
#                              its binutils, OUT, and LIBGCC, which may help
set -eu
allowed="log logf sqrt sqrtf memcpy memset"
tools=${TOOLS-}
work=$OUT/lint
status=0
mkdir -p "$work"

# What the linker makes, not the C library.
linkers='^(_GLOBAL_OFFSET_TABLE_|\.TOC\.|__stack_pointer)$'

defined() { "${tools}nm" --defined-only "$@" 2>"$work/errors" |
                sed -n 's/.* [A-Za-z] //p'; }

# Bytes of code and constants, and of sections that are written to, even if
# only by the dynamic linker; for wasm llvm-readobj knows these by name.
holds()
{
    if test "$tools" = llvm-; then
        llvm-readobj --sections "$@" | awk '
            $1 == "Size:" && n ~ /^\.t?(data|bss)/ {w += $2}
            $1 == "Size:" && (n ~ /^\.rodata/ || code) {r += $2}
            {n = $1 == "Name:" ? $2 : ""; code = /Type: CODE/}
            END {print r + 0, w + 0}'
    else
        "${tools}size" -A "$@" | awk '
            $1 ~ /^\.t?(data|bss)/ || $1 == "COMMON" {w += $2}
            $1 ~ /^\.(text|rodata)/ {r += $2} END {print r + 0, w + 0}'
    fi
}

# look NAME OBJECT...
look()
{
    name=$1
    shift
    test $# -gt 20 || { echo "$name: $# objects"; status=1; }
    { defined "$@"; test -z "${LIBGCC-}" || defined "$LIBGCC"; } |
        LC_ALL=C sort -u >"$work/defined"
    "${tools}nm" -u "$@" | sed -n 's/^ *U //p' | grep -Ev "$linkers" |
        LC_ALL=C sort -u | LC_ALL=C comm -23 - "$work/defined" >"$work/needed"
    test -s "$work/needed" || { echo "$name: needs nothing?"; status=1; }
    for symbol in $(cat "$work/needed"); do
        case " $allowed " in
        *" $symbol "*) ;;
        *) echo "$name: $symbol is not allowed"; status=1 ;;
        esac
    done
    set -- $(holds "$@")
    test "$1" != 0 && test "$2" = 0 || status=1
    echo "$name objects need" $(cat "$work/needed"), "hold $1 bytes of code" \
        "and constants, $2 of writable data"
}

if test $# -gt 0; then
    look "$@"
else
    # Those of the library: the folder may hold one of a source that is gone.
    set -- $(ar t "$OUT/librollcoin.a" | sed "s,^,$OUT/objects/,")
    look the "$@"
fi
exit $status
