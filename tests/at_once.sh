# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# at_once COMMAND...: runs COMMAND... NUMBER LINE for each line of the input, as
# many at once as there are processors; fails if one did.
at_once()
{
    number=0 running="" result=0
    while read -r line; do
        number=$((number + 1))
        "$@" $number "$line" &
        running="$running $!"
        test $((number % $(nproc))) = 0 || continue
        finish_running
    done
    finish_running
    return $result
}

finish_running()
{
    for one in $running; do wait "$one" || result=1; done
    running=""
}
