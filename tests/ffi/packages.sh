#!/bin/sh
# SPDX-License-Identifier: MIT
# The other two ways to Python's package: linked to an installed library, and
# from an sdist, which needs no clone.  Each rolls the quarter.
#     packages.sh WORK PYTHON
# From ffi.sh: SRC OUT MAKE.
set -eu
work=$1
python=$2
folder=$SRC/docs/examples/python

# installs NAME WHAT: into a folder of its own, of which quarter.py prints.
installs()
{
    "$python" -m pip -q --disable-pip-version-check install --no-index \
        --no-deps --target "$work/$1" "$2"
    (cd / && PYTHONPATH="$work/$1" "$python" -P "$folder/quarter.py") \
        >"$work/$1.txt"
    "$OUT/quarter" | cmp - "$work/$1.txt"
}

# coin_run is in the package, or is not.
defines() { nm -D "$work/$1/rollcoin/_native.so" | grep -q ' T coin_run'; }

${MAKE:-make} -s -f "$SRC/Makefile" O="$OUT" FILLED="$work" install \
    PREFIX="$work/stage"
ROLLCOIN_SYSTEM=1 PKG_CONFIG_PATH="$work/stage/lib/pkgconfig" \
    installs system "$folder"
! defines system || { echo "the library is compiled twice"; exit 1; }

cd "$folder"
"$python" -c "import sys, backend; backend.build_sdist(sys.argv[1])" "$work"
cd "$work"
installs sdist rollcoin-*.tar.gz
defines sdist || { echo "an sdist without the library"; exit 1; }
echo "Python's package: the installed library, and an sdist"
