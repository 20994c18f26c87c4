#!/bin/sh
# SPDX-License-Identifier: MIT
# make, make install and README.md's program work where git is missing or
# refuses a clone that belongs to another user, and where stat and date have no
# options of GNU's: here the three fail, whatever they are asked.  make dist,
# which needs more, says so before it begins.
# From `make installcheck`: MAKE SRC OUT.
set -eu
work=$OUT/plain
prefix=$work/prefix
rm -rf "$work"
mkdir -p "$work/bin" "$work/clone/.git"
. "$SRC/tests/install/fenced.sh"

die() { echo "installcheck: $*" >&2; exit 1; }

for tool in git stat date; do
    printf '#!/bin/sh\necho "no %s here" >&2\nexit 128\n' $tool >"$work/bin/$tool"
    chmod +x "$work/bin/$tool"
done
(cd "$SRC" && tar -cf - Makefile README.md CHANGELOG.md LICENSE include lib \
    pkgconfig docs) | tar -xf - -C "$work/clone"
chmod -R u+w "$work/clone" # where the sources are read-only
unset DESTDIR PKG_CONFIG_LIBDIR PKG_CONFIG_SYSROOT_DIR

echo "installcheck: without git, GNU's stat and GNU's date"
cd "$work/clone"
PATH="$work/bin:$PATH" $MAKE --no-print-directory O=build CFLAGS=-O0 LDCONFIG=: \
    "PREFIX=$prefix" install >"$work/log" 2>&1 && ! grep ' here$' "$work/log" ||
    { cat "$work/log"; die "it needs one of them"; }
grep -q '^\.TH .* "2[0-9]*-[0-9]*-[0-9]*" ' "$prefix/share/man/man3/rollcoin.3" ||
    die "rollcoin(3) has no date"
fenced c >"$work/toss.c"
fenced text >"$work/expected"
test -s "$work/expected"
(cd "$work" && PKG_CONFIG_PATH=$prefix/lib/pkgconfig LD_LIBRARY_PATH=$prefix/lib \
    sh -ec "$(fenced sh)" | diff expected -) || die "README's program fails"

make=$(command -v "${MAKE%% *}")
! PATH=$work/nothing "$make" O=none dist >"$work/log" 2>&1 &&
    grep -q 'make dist needs xz' "$work/log" ||
    { cat "$work/log"; die "make dist does not say that it needs xz"; }
