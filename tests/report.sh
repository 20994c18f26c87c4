#!/bin/sh
# SPDX-License-Identifier: MIT
# What came out of test programs: of each that failed the name of its log, and
# the log without the tests that say nothing but OK; in the last line how many
# tests passed and failed.  Fails if one did, or none ran.
#     report.sh PROGRAM...    from `make check`; each has a .log or a .failed
set -eu
passed=0 failed=0 status=0
for program; do
    log=$program.log
    if test -e "$program.failed"; then
        log=$program.failed
        echo "FAILED: ${program##*/}: $log"
        sed '/^\[ RUN  /{ $!N; /\n\[       OK /d; }; /^\[\(       OK\|==\)/d' "$log"
        echo # the last line of cmocka has no end
        # A test that fails is named twice, and one that crashes not at all.
        names=$(grep -c '^\[  FAILED  \] [a-z]' "$log" || :)
        failed=$((failed + (names > 1 ? names / 2 : 1)))
        status=1
    fi
    passed=$((passed + $(grep -c '^\[       OK ' "$log" || :)))
done
test $# -gt 0 || { echo "FAILED: no test program"; status=1; }
echo "$passed passed, $failed failed"
exit $status
