#!/bin/sh
# SPDX-License-Identifier: MIT
# README.md's program after README.md's commands, in the system itself: make
# install, then its command line, prints what it says.  For .ci/run, which has a
# machine of its own; the library is removed again.
set -eu
cd "$(dirname "$0")/../.."
SRC=.
. tests/install/fenced.sh
root=
test "$(id -u)" = 0 || root=sudo
work=$(mktemp -d)
fenced c >"$work/toss.c"
fenced text >"$work/expected"
test -s "$work/expected"
command=$(fenced sh)
$root make install
status=0
(cd "$work" && sh -ec "$command" | diff expected -) || status=1
$root make uninstall
rm -r "$work"
exit $status
