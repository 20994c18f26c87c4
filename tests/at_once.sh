# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# at_once COMMAND...: runs COMMAND... NUMBER LINE for each line of the input, as
# many at once as there are processors; fails if one did.
at_once()
{
    taken=$(mktemp -d) running="" result=0
    cat >"$taken/lines"
    while test "$(echo "$running" | wc -w)" -lt "$(nproc)"; do
        each_not_taken "$@" &
        running="$running $!"
    done
    for one in $running; do wait "$one" || result=1; done
    rm -r "$taken"
    return $result
}

# Who makes a line's folder takes the line.
each_not_taken()
{
    number=0 result=0
    while read -r line; do
        number=$((number + 1))
        mkdir "$taken/$number" 2>"$taken/errors" || continue
        "$@" $number "$line" &
        wait $! || result=1
    done <"$taken/lines"
    return $result
}
