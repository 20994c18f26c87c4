#!/bin/sh
# SPDX-License-Identifier: MIT
# count.sh QEMU PROGRAM WORK...: for each its instructions per step, and how
# deep the stack went, in the form that counts.c prints on a board.
# qemu-user translates one instruction at a time here and writes a line for
# each that is run; what begins and ends the program is in both numbers.
set -eu
qemu=$1 program=$2
shift 2

# A multiple of 64: a run of doubles does something of its own so often.
few=64 many=128
traced() { "$qemu" -singlestep -d exec,nochain "$program" "$1" "$2" 2>&1 |
               grep -c ^Trace; }

for work; do
    deep=$("$qemu" "$program" "$work" 1)
    of_few=$(traced "$work" $few)
    of_many=$(traced "$work" $many)
    per_step=$(((of_many - of_few + (many - few) / 2) / (many - few)))
    test "$per_step" -gt 0
    echo "$work $per_step $deep"
done
