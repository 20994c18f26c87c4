#!/bin/sh
# SPDX-License-Identifier: MIT
# Versions that no build has today, each made by `make release` in a copy of the
# sources: all that carries a version or a soname then carries the new one.
# From `make versions`: MAKE CC CXX CARGO BINDGEN PKG_CONFIG PYTHON SRC OUT
# VERSION SOVERSION TARBALL.
set -eu
work=$OUT/versions
rm -rf "$work"
mkdir -p "$work"
tar -xJf "$TARBALL" -C "$work"
source=$work/rollcoin-$VERSION
old=$VERSION old_soname=$SOVERSION
abi=$(sed -n 's/^ABI_NUMBER := //p' "$SRC/Makefile")
export MAKE CC CXX PKG_CONFIG PYTHON CFLAGS='-O0 -g'
unset DESTDIR MAKEFLAGS
. "$SRC/tests/at_once.sh"

die() { echo "versions: $VERSION: $*" >&2; exit 1; }
quiet() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; die "$*"; }; }

# is WHAT FOUND WANT
is() { test "$2" = "$3" || die "$1 is '$2', not '$3'"; }

version() # NUMBER VERSION
{
    export VERSION="$2" SOVERSION="$abi" SRC="$work/$2" OUT="$work/$2/build"
    cp -a "$source" "$SRC"
    work=$OUT/made
    mkdir -p "$work"
    cd "$SRC"
    make="$MAKE --no-print-directory -j2 O=build"
    released
    quiet $make
    libraries
    installed
    packages
    bindings
    quiet $make abi
    quiet $make site
    is "the site's version" "$(grep -o 'projectnumber">[^<]*' \
        "$OUT/site/index.html")" "projectnumber\">&#160;$VERSION"
    test "$1" != 1 || after
    echo "versions: $VERSION is librollcoin.so.$SOVERSION wherever it is named"
}

# As contributing.md says, from a clone: a commit that is clean, and a section of
# CHANGELOG.md that is not released.
released()
{
    sed -i '0,/^## /s/^## .*/## [Unreleased]/' CHANGELOG.md
    export GIT_AUTHOR_NAME=test GIT_AUTHOR_EMAIL=test
    export GIT_COMMITTER_NAME=test GIT_COMMITTER_EMAIL=test
    git init -q
    refuses "changes without a commit" "$VERSION"
    git add -A
    git commit -qm test
    refuses "is no version" 1.0
    refuses "is older than $old" 0.8.9
    release "$VERSION"
    test "$SOVERSION" = "$old_soname" || ! grep -rnE \
        "(librollcoin[-.so]*|ROLLCOIN_)$old_soname\>|rollcoin[- (]*$old\>" . \
        --exclude=CHANGELOG.md --exclude-dir=build --exclude-dir=.git \
        --exclude=changelog || die "left behind; lint/version.sh does not name the place"
    git add -A
    git commit -qm "Release $VERSION"
    refuses "should be marked unreleased" "$VERSION"
}

release() { quiet $make release VERSION="$1" BINDGEN="$BINDGEN"; }

# refuses WHY VERSION
refuses()
{
    ! $make release VERSION="$2" >"$work/log" 2>&1 && grep -q "^release: .*$1" \
        "$work/log" || { cat "$work/log"; die "is made, though $1"; }
    git status --porcelain | grep -q '^ M' && die "is refused too late: $1" || :
}

# What the next patch and the next minor version may bring.
after()
{
    next=${VERSION%.*}.$((${VERSION##*.} + 1))
    minor=${VERSION#*.}
    minor=${VERSION%%.*}.$((${minor%.*} + 1))
    change "a section" CHANGELOG.md '0,/^## /s/^## /## [Unreleased]\n\n&/'
    change "other bits" tests/repro/expected.txt '1s/.$/x/'
    refuses "motions have other bits: not in a patch" "$next"
    refuses "motions have other bits, and CHANGELOG.md has no" "$minor.0"
    git reset -q --hard HEAD^
    change "a constant" include/coin.h 's|COIN_TAILS = 2,|COIN_NEW = 9, /**< new */ &|'
    refuses "constants have grown" "$next"
    sed -i 's/^COIN_API uint32_t coin_version/COIN_API int32_t coin_new(void);\n&/' \
        include/coin.h
    echo 'int32_t coin_new(void) { return 0; }' >>lib/about/version.c
    change "a function" lib/about/rollcoin.map \
        "\$a ROLLCOIN_$minor { coin_new; } ROLLCOIN_$abi.0;"
    refuses "ROLLCOIN_$minor in rollcoin.map is newer" "$next"
    release "$minor.0"
    is "the symbols' versions" "$(sed -n 's/.*symver)//p' \
        docs/examples/debian/*.symbols | paste -sd' ')" \
        "ROLLCOIN_$abi.0 $abi.0.0 ROLLCOIN_$minor $minor.0"
}

# change WHAT FILE SED: a commit, with the baselines.
change()
{
    cp "$2" "$work/before"
    sed -i "$3" "$2"
    ! cmp -s "$2" "$work/before" || die "no change: $1"
    quiet $make abi-update
    git commit -qam "$1"
}

# By make, and what CMake would call them.
libraries()
{
    is "the link" "$(readlink "$OUT/librollcoin.so.$SOVERSION")" \
        "librollcoin.so.$VERSION"
    is "the soname" "$(readelf -d "$OUT/librollcoin.so.$VERSION" |
        sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')" "librollcoin.so.$SOVERSION"
    quiet cmake -S pkgconfig/cmake -B "$work/cmake" -DBUILD_SHARED_LIBS=ON
    is "CMake's soname and file" "$(sed 's/.*-soname,\([^ ]* -o [^ ]*\).*/\1/' \
        "$work/cmake/CMakeFiles/rollcoin.dir/link.txt")" \
        "librollcoin.so.$SOVERSION -o librollcoin.so.$VERSION"
    is "the node of coin_version" "$(nm -D --with-symbol-versions \
        "$OUT/librollcoin.so" | sed -n 's/.* coin_version@@//p')" \
        "ROLLCOIN_$SOVERSION.0"
    quiet $make check TESTS=tests/test_about.c
}

# The client, by pkg-config, CMake and Meson.
installed()
{
    quiet sh tests/install/install.sh
    quiet sh tests/install/consumers.sh installed
    is "the manual page" "$(sed -n 's/^\.TH .*rollcoin \([0-9.]*\).*/\1/p' \
        "$OUT/rollcoin.3")" "$VERSION"
}

# Debian's tool compares its list of symbols with the library.
packages()
{
    cp -r docs/examples/debian .
    is "Debian's version" "$(dpkg-parsechangelog -S Version)" "$VERSION-1"
    quiet dpkg-gensymbols -c4 "-plibrollcoin$SOVERSION" "-v$VERSION-1" \
        "-e$OUT/librollcoin.so.$VERSION" "-O$work/symbols"
    rm -r debian
}

bindings()
{
    cd docs/examples/python
    is "Python's package" "$("$PYTHON" -c "import backend
print(backend.prepare_metadata_for_build_wheel('$work'))")" \
        "rollcoin-$VERSION.dist-info"
    cd ../rust
    ROLLCOIN_LIB="$OUT" CARGO_TARGET_DIR="$work/cargo" \
        quiet "$CARGO" test --offline -q --lib the_library_is_of_this_crates
    grep -q '1 passed' "$work/log" || die "Rust has no such test"
    cd ../../..
}

at_once version <<END
1.0.0
2.3.4
END
