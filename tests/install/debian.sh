#!/bin/sh
# SPDX-License-Identifier: MIT
# The files of docs/examples/debian make packages of a release that lintian has
# nothing to say about, and whose test passes against them.
# From `make debian-check`: OUT VERSION SOVERSION TARBALL.
set -eu
work=$OUT/debian
top=$work/rollcoin-$VERSION
rm -rf "$work"
mkdir -p "$work"

die() { echo "debian: $*" >&2; exit 1; }

for tool in dpkg-buildpackage dh lintian; do
    command -v $tool >/dev/null || die "needs $tool"
done
tar -xJf "$TARBALL" -C "$work"
cp -r "$top/docs/examples/debian" "$top/debian"

# The tests are those of `make check`.
unset MAKEFLAGS MFLAGS MAKELEVEL DESTDIR CFLAGS CPPFLAGS LDFLAGS
(
    cd "$top"
    test "$(dpkg-parsechangelog -S Version)" = "$VERSION-1" ||
        die "debian/changelog is not of $VERSION"
    DEB_BUILD_OPTIONS="nocheck parallel=2" DEB_BUILD_PROFILES=nocheck \
        dpkg-buildpackage -us -uc -b
) >"$work/log" 2>&1 || { tail -20 "$work/log"; die "the packages do not build"; }
# There is no request for packaging in Debian that a first upload would close.
# An example has a file that is empty, and a page of its own for browsers.
lintian --allow-root --fail-on error,warning,info --display-info \
    --suppress-tags initial-upload-closes-no-bugs \
    --suppress-tags zero-byte-file-in-doc-directory \
    --suppress-tags possible-documentation-but-no-doc-base-registration \
    "$work"/rollcoin_*.changes || die "lintian objects"

# What is in each, and the test against both.
root=$work/root
for package in "librollcoin$SOVERSION" librollcoin-dev; do
    dpkg-deb -x "$work/${package}_$VERSION"-1_*.deb "$root" ||
        die "there is no $package"
    dpkg-deb -c "$work/${package}_$VERSION"-1_*.deb >"$work/$package"
done
runtime=$work/librollcoin$SOVERSION
grep -q "librollcoin.so.$VERSION" "$runtime" &&
    ! grep -q 'include\|librollcoin.so$\|librollcoin.a' "$runtime" &&
    grep -q 'librollcoin.a' "$work/librollcoin-dev" || die "the split is wrong"
dpkg-deb --ctrl-tarfile "$work/librollcoin${SOVERSION}_$VERSION"-1_*.deb |
    tar -xO ./symbols | grep -q "coin_step@ROLLCOIN_" || die "no symbols"
lib=$(dirname "$(find "$root/usr/lib" -name librollcoin.a)")
mkdir "$work/tmp"
AUTOPKGTEST_TMP=$work/tmp PKG_CONFIG_SYSROOT_DIR=$root LD_LIBRARY_PATH=$lib \
    PKG_CONFIG_PATH=$lib/pkgconfig sh "$top/debian/tests/toss" ||
    die "the packages' test fails"
echo "debian: librollcoin$SOVERSION and librollcoin-dev, clean, and their test passes"
