#!/bin/sh
# SPDX-License-Identifier: MIT
# What came out of test files: of each that failed the name of its log, and
# the log without the tests that say nothing but OK; in the last line how many
# tests passed and failed.  Fails if one did, or none ran.
#     report.sh NAME...    from `make check`; each has a .log or a .failed
set -eu
passed=0 failed=0 status=0
for name; do
    log=$name.log
    if test -e "$name.failed"; then
        log=$name.failed
        echo "FAILED: ${name##*/}: $log"
        sed '/^\[ RUN  /{ $!N; /\n\[       OK /d; }; /^\[\(       OK\|==\)/d' "$log"
        echo # the last line of cmocka has no end
        # A test that fails is named twice, and one that crashes not at all.
        names=$(grep -c '^\[  FAILED  \] [a-z]' "$log" || :)
        failed=$((failed + (names > 1 ? names / 2 : 1)))
        status=1
    fi
    passed=$((passed + $(grep -c '^\[       OK ' "$log" || :)))
done
test $# -gt 0 || { echo "FAILED: no test file"; status=1; }
echo "$passed passed, $failed failed"
exit $status
