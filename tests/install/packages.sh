#!/bin/sh
# SPDX-License-Identifier: MIT
# The packages of other languages are built, into build/packages, and each is
# used as by a stranger: in an empty folder, without this clone and without a
# network, the toss of its README ends as that of docs/examples/toss.c.
#     packages.sh [NAME...]    these only: python rust js csharp cpp
# From `make packages`: MAKE CC CXX CARGO PYTHON SRC OUT VERSION.
set -eu
examples=$SRC/docs/examples
packages=$OUT/packages
rm -rf "$packages"
mkdir -p "$packages"
room=$(mktemp -d)
trap 'rm -r "$room"' 0
unset DESTDIR MAKEFLAGS MFLAGS PYTHONPATH ROLLCOIN_LIB ROLLCOIN_CLONE ROLLCOIN_SYSTEM
unset PKG_CONFIG_PATH LD_LIBRARY_PATH
# No library that is installed here is found instead.
export PKG_CONFIG_LIBDIR=/nowhere CC CXX PYTHONDONTWRITEBYTECODE=1

die() { echo "packages: $*" >&2; exit 1; }
quiet() { "$@" >"$room/log" 2>&1 || { cat "$room/log"; die "$*"; }; }

for tool in "$PYTHON" pip3 "$CARGO" node npm tsc chromium mcs mono; do
    command -v "$tool" >/dev/null || die "needs $tool"
done
want=$("$OUT/toss")
echo "$want" | grep -qE '^(heads|tails|edge) after 0\.[0-9]{6} s$' || die "toss.c: $want"

# section FOLDER LANGUAGE TITLE: the blocks of this language there in the README.
section()
{
    sed -n "/^## $3\$/,/^## /p" "$examples/$1/README.md" |
        sed -n "/^\`\`\`$2\$/,/^\`\`\`\$/{/^\`/d;p}" | grep . ||
        die "$1/README.md has no '$3'"
}

# toss FOLDER LANGUAGE: what the README says, and the program in it.
toss() { section "$1" "$2" "A toss"; }

# ends FOLDER COMMAND...: what it prints is as in its README, and as in C.
ends()
{
    folder=$1
    shift
    "$@" >"$room/said" 2>&1 && test "$(cat "$room/said")" = "$want" ||
        { cat "$room/said"; die "$folder: not '$want'"; }
    toss "$folder" text | grep -qxF "$want" ||
        die "$folder/README.md says something else than '$want'"
}

# Nothing is seen but one folder of tools.
alone() { env -i PATH="${tools:-/nowhere}" HOME="$room" "$@"; }

python()
{
    pip="$PYTHON -m pip -q --disable-pip-version-check"
    (
        cd "$examples/python"
        "$PYTHON" -c "import sys, backend; backend.build_sdist(sys.argv[1])" \
            "$packages"
    )
    quiet $pip wheel --no-index --no-deps --wheel-dir "$packages" \
        "$packages/rollcoin-$VERSION.tar.gz"
    wheel=$(echo "$packages/rollcoin-$VERSION"-py3-none-*.whl)
    # Not even numpy, and no compiler.
    "$PYTHON" -m venv --without-pip "$room/venv"
    toss python python >"$room/toss.py"
    cd "$room"
    quiet env PATH=/nowhere $pip --python "$room/venv/bin/python" install --no-index \
        "$wheel"
    ends python alone "$room/venv/bin/python" toss.py
}

rust()
{
    cp -r "$examples/rust" "$room/rust"
    mkdir "$room/rust/vendor"
    cp "$OUT/single/coin.h" "$room/rust/vendor"
    cp "$SRC/LICENSE" "$room/rust"
    cd "$room/rust"
    quiet "$CARGO" package --offline -q --target-dir "$room/cargo"
    cp "$room/cargo/package/rollcoin-$VERSION.crate" "$packages"
    # A registry that is a folder, which has this crate alone.
    mkdir -p "$room/crates" "$room/user/src" "$room/user/.cargo"
    tar -xzf "$packages/rollcoin-$VERSION.crate" -C "$room/crates"
    echo '{"files":{}}' >"$room/crates/rollcoin-$VERSION/.cargo-checksum.json"
    cd "$room/user"
    toss rust rust >src/main.rs
    printf '[package]\nname = "user"\nversion = "0.1.0"\nedition = "2021"\n%s\n' \
        "[dependencies]
rollcoin = \"$VERSION\"" >Cargo.toml
    printf '[source.crates-io]\nreplace-with = "crates"\n%s\n' "[source.crates]
directory = \"$room/crates\"" >.cargo/config.toml
    ends rust "$CARGO" run --offline -q --target-dir "$room/cargo"
}

js()
{
    mkdir "$room/page"
    cd "$room/page"
    quiet npm pack --silent --pack-destination "$packages" "$OUT/js"
    echo '{"type": "module"}' >package.json
    quiet npm install --offline --no-audit --no-fund "$packages/rollcoin-$VERSION.tgz"
    toss js js >toss.mjs
    ends js node toss.mjs
    # What goes on below the toss.
    { toss js js && section js js "Frame by frame"; } >frames.mjs
    { toss js text && section js text "Frame by frame"; } >"$room/expected"
    node frames.mjs | diff "$room/expected" - || die "js/README.md: other frames"
    # Its types: both have them, and a wrong call is refused.
    types="tsc --noEmit --strict --allowJs --checkJs --target es2022 --module nodenext"
    quiet $types toss.mjs frames.mjs
    sed 's/Infinity, 1e-6/Infinity, "1e-6"/' toss.mjs >wrong.mjs
    ! $types wrong.mjs >"$room/log" && grep -q "not assignable" "$room/log" ||
        die "rollcoin.d.ts lets a text pass for a number"
    # A page as it is written, without a bundler.
    cp "$SRC/tests/install/page.html" .
    ends js node "$SRC/tests/install/serve.mjs" page.html
}

csharp()
{
    mkdir "$room/csharp"
    cd "$room/csharp"
    toss csharp csharp >toss.cs
    cp "$examples/csharp/rollcoin.cs" "$SRC/tests/ffi/test_csharp.cs" .
    cp "$OUT/librollcoin.so.$VERSION" librollcoin.so
    quiet mcs -warnaserror toss.cs rollcoin.cs
    ends csharp env LD_LIBRARY_PATH=. mono toss.exe
    quiet mcs -warnaserror test_csharp.cs rollcoin.cs
    "$PYTHON" "$SRC/tests/ffi/header.py" "$SRC/include" layout | grep '^coin_' |
        LD_LIBRARY_PATH=. mono test_csharp.exe || die "the tests of C# fail"
}

cpp()
{
    quiet "$MAKE" -s -f "$SRC/Makefile" O="$OUT" FILLED="$room" LDCONFIG=: \
        PREFIX="$room/usr" install
    cd "$room"
    toss cpp cpp >toss.cpp
    quiet $CXX -std=c++17 -Wall -Wextra -Werror toss.cpp -o toss \
        $(PKG_CONFIG_LIBDIR=$room/usr/lib/pkgconfig pkg-config --cflags --libs rollcoin)
    ends cpp env LD_LIBRARY_PATH="$room/usr/lib" ./toss
}

for name in ${*:-python rust js csharp cpp}; do
    ("$name")
    echo "packages: $name"
done
echo "packages: $want, from each; $(ls "$packages" | paste -sd' ')"
