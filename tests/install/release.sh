#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes of the sources those of a release: writes the version into each place
# that has it, and keeps the ABI as a released one.  It asks first for all that
# stands against the release.  `make versions` tries it.
# From `make release VERSION=X.Y.Z`: MAKE CC SRC OUT VERSION SOVERSION PYTHON
# BINDGEN.
set -eu
cd "$SRC"
debian=docs/examples/debian
map=lib/about/rollcoin.map
baseline=tests/abi/$SOVERSION
work=$OUT/release
make="$MAKE --no-print-directory -s -f $SRC/Makefile O=$OUT"
unset MAKEFLAGS MFLAGS MAKELEVEL

die() { echo "release: $*" >&2; exit 1; }

# newer A B: A comes after B.
newer() { test "$(printf '%s\n' "$1" "$2" | sort -V | tail -1)" != "$2"; }

# ---------------------------------------------------------- what stands against
number='\(0\|[1-9][0-9]*\)'
test "$(echo "$VERSION" | sed "s/^$number\.$number\.$number\$//")" = "" ||
    die "'$VERSION' is no version: make release VERSION=1.0.0"
old=$(sed -n 's/^#define COIN_VERSION_[MP][A-Z]* //p' include/coin.h | paste -sd.)
! newer "$old" "$VERSION" || die "$VERSION is older than $old, that of coin.h"
for tool in gcc readelf abidiff clang wasm-ld wasm-opt zopfli "$PYTHON" \
    "$BINDGEN" rustfmt; do
    command -v "$tool" >/dev/null || die "needs $tool: sudo apt-get install gcc" \
        "make clang lld wasi-libc libclang-rt-14-dev-wasm32 binaryen zopfli" \
        "abigail-tools python3-pycparser bindgen rustfmt"
done
$make need-wasm || die "the page is built anew"
"$PYTHON" -c 'import pycparser' || die "needs Debian's python3-pycparser"
test ! -e .git || test -z "$(git status --porcelain)" ||
    die "there are changes without a commit: git status"
sed -n '/^## /{p;q}' CHANGELOG.md | grep -qi unreleased ||
    die "the newest section of CHANGELOG.md should be marked unreleased, and" \
        "say what $VERSION brings"
node=$(sed -n 's/^ROLLCOIN_\([0-9.]*\) {.*/\1/p' $map | tail -1)
! newer "$node" "${VERSION%.*}" ||
    die "ROLLCOIN_$node in rollcoin.map is newer than $VERSION"

# A patch adds nothing to a release, and keeps all bits; a minor version says
# which it changes.
rm -rf "$work"
mkdir -p "$work"
LC_ALL=C sort tests/repro/expected.txt >"$work/bits.txt"
if test -d "$baseline/released"; then
    is_patch=$(test "${VERSION##*.}" = 0 || echo yes)
    for list in ${is_patch:+symbols macros constants layout functions}; do
        diff "$baseline/released/$list.txt" "$baseline/$list.txt" ||
            die "$list have grown: not in a patch version, $VERSION"
    done
    if LC_ALL=C comm -23 "$baseline/released/bits.txt" "$work/bits.txt" | grep .; then
        test ! "$is_patch" ||
            die "motions have other bits: not in a patch version, $VERSION"
        sed '1,/^## /d; /^## /q' CHANGELOG.md | grep -q '^### Accuracy' ||
            die "motions have other bits, and CHANGELOG.md has no Accuracy that" \
                "says so"
    fi
fi

# ---------------------------------------------------------------------- writing
trap 'test $? = 0 || echo "release: half done. git restore . takes it back" >&2' 0
for part in MAJOR.1 MINOR.2 PATCH.3; do
    number=$(echo "$VERSION" | cut -d. -f"${part#*.}")
    sed -i "s/\(define COIN_VERSION_${part%.*}\) .*/\1 $number/" include/coin.h
done
sed -i "0,/^## /s/^## .*/## [$VERSION] - $(date -u +%F)/" CHANGELOG.md
grep -q "^rollcoin ($VERSION-" $debian/changelog || {
    printf 'rollcoin (%s-1) unstable; urgency=medium\n\n  * %s\n\n -- %s  %s\n\n' \
        "$VERSION" "New upstream release." \
        "$(sed -n 's/^Maintainer: //p' $debian/control)" "$(LC_ALL=C date -uR)"
    cat $debian/changelog
} >"$work/changelog"
test ! -s "$work/changelog" || cp "$work/changelog" $debian/changelog

# The other places are those that the lint names.  The symbols of a node are
# those of its minor version.
was=$(sed -n 's/^Package: librollcoin\([0-9]\)/\1/p' $debian/control)
case $SOVERSION in *.*) first=$SOVERSION ;; *) first=$SOVERSION.0 ;; esac
sed -i "0,/^ROLLCOIN_/s/^ROLLCOIN_.* {/ROLLCOIN_$first {/" $map
sh tests/lint/version.sh >"$work/places" || :
cut -d: -f1 "$work/places" | sort -u | while read -r place; do
    sed -i -e "s/\<$(echo "$old" | sed 's/\./\\./g')\>/$VERSION/g" \
        -e "s/\((rollcoin \)[0-9.]*[0-9]/\1${VERSION%.*}/" \
        -e "s/\(librollcoin[-.so]*\)$was\>/\1$SOVERSION/g" \
        -e "s/ROLLCOIN_[0-9.]*[0-9]/ROLLCOIN_$first/g" "$place"
    new=$(echo "$place" | sed "s/\(librollcoin\)$was\./\1$SOVERSION./")
    test "$place" = "$new" || mv "$place" "$new"
done
symbols=$debian/librollcoin$SOVERSION.symbols
{
    sed '/symver/d' "$symbols"
    sed -n 's/^ROLLCOIN_\([0-9.]*\) {.*/ (symver)ROLLCOIN_\1 \1.0/p' $map
} >"$work/symbols"
cp "$work/symbols" "$symbols"
sh tests/lint/version.sh || die "these places are left"

# What is compiled from the headers, and the baselines of this soname alone.
$make
$make abi-update bindings-update page
sh tests/abi/abi.sh release
find tests/abi -mindepth 1 -maxdepth 1 -type d ! -name "$SOVERSION" \
    -exec rm -r {} +
cp "$work/bits.txt" "$baseline/released"
echo "release: this is $VERSION, librollcoin.so.$SOVERSION: see contributing.md" \
    "for the commit and the tag"
