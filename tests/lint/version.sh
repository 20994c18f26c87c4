#!/bin/sh
# SPDX-License-Identifier: MIT
# The version has one home, coin.h, and the soname follows from it.  Here are the
# places that repeat one of them: `make release` writes them.
# From `make lint`: SRC VERSION SOVERSION.
set -eu
cd "$SRC"
debian=docs/examples/debian
# The first node of a soname is of the version that began it.
case $SOVERSION in *.*) node=$SOVERSION ;; *) node=$SOVERSION.0 ;; esac

# says PLACE WANT SED: all that SED prints of the input is WANT.
says()
{
    found=$(sed -n "$3" | sort -u | paste -sd' ')
    test "$found" = "$2" || echo "$1: '$found' should be '$2', by coin.h"
}

wrong=$(
    in=lib/about/rollcoin.map # the first node; later ones keep their names
    says $in "$node" '/^ROLLCOIN_/{s/.*_\(.*\) {/\1/p;q}' <$in
    nodes=$(sed -n 's/^ROLLCOIN_\(.*\) {.*/(symver)ROLLCOIN_\1 \1.0/p' $in | sort |
        paste -sd' ')
    in=CHANGELOG.md # the newest section with a number
    says $in "$VERSION" '/^## \[[0-9]/{s/.*\[\(.*\)\].*/\1/p;q}' <$in
    in=docs/examples/rust/Cargo.toml
    says $in "$VERSION" 's/^version = "\(.*\)"/\1/p' <$in
    in=docs/examples/js/package.json
    says $in "$VERSION" 's/^  "version": "\(.*\)",/\1/p' <$in
    in=docs/installing.md
    says $in "$VERSION" 's/.*rollcoin-\([0-9.]*\)\.tar.*/\1/p' <$in
    says $in "${VERSION%.*}" 's/.*find_package(rollcoin \([0-9.]*\).*/\1/p' <$in
    number='\([0-9.]*[0-9]\)'
    says $in "$SOVERSION" "s/.*librollcoin[-.so]*$number.*/\1/p" <$in
    says $in "$node" "s/.*ROLLCOIN_$number.*/\1/p" <$in
    in=$debian/changelog
    says $in "$VERSION" '1s/rollcoin (\(.*\)-.*/\1/p' <$in
    in=$debian/control
    says $in "$SOVERSION" "s/.*librollcoin$number.*/\1/p" <$in
    for in in "$debian"/librollcoin[0-9]*; do
        echo "$in" | says "$in" "$SOVERSION" "s/.*librollcoin$number\..*/\1/p"
    done
    for in in "$debian"/librollcoin[0-9]*.symbols; do
        says "$in" "$SOVERSION $SOVERSION" \
            '1s/librollcoin.so.\(.*\) librollcoin\(.*\) .*/\1 \2/p' <"$in"
        says "$in" "$nodes" 's/^ \((symver)\)/\1/p' <"$in"
    done
)
test -z "$wrong" || { echo "$wrong"; exit 1; }
