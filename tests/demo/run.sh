#!/bin/sh
# SPDX-License-Identifier: MIT
# Tests the demo from outside: what it prints, draws and refuses.
#
#   tests/demo/run.sh build/rolling_quarter
#
# Needs python3 (PYTHON names another), for reading XML.
set -u

test $# -eq 1 || { echo "usage: run.sh PROGRAM" >&2; exit 2; }
root=$(cd "$(dirname "$0")/../.." && pwd)
demo=$(cd "$(dirname "$1")" && pwd)/${1##*/}
python=${PYTHON:-python3}
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
cd "$tmp" || exit 1
mkdir build out "an odd %s name"
failures=0
claims=0

# A claim, then the command that shows it.
claim()
{
    text=$1
    shift
    claims=$((claims + 1))
    "$@" && return
    failures=$((failures + 1))
    echo "FAILED: $text"
    sed 's/^/    | /' stderr
}

# exits CODE ARGUMENT...: what the demo says goes to stdout and stderr here.
exits()
{
    want=$1
    shift
    "$demo" "$@" >stdout 2>stderr
    got=$?
    test $got -eq "$want" || { echo "exit $got, not $want: $*"; return 1; }
}

# refuses CODE WORDS ARGUMENT...: fails so, and stderr explains it in WORDS.
refuses()
{
    code=$1 words=$2
    shift 2
    exits "$code" "$@" && grep -q -e "$words" stderr
}

# The scenes or methods that --list shows.
listed()
{
    "$demo" --list | awk -v part="$1:" '/:$/ { on = $0 == part; next }
                                        on { print $1 }'
}

# The table's rows: they begin with a time.
rows()
{
    grep -E '^ +[0-9]+\.[0-9]{3} ' stdout
}

# ------------------------------------------------------------ the first run
draws_three_pictures()
{
    exits 0 && test -s build/quarter.svg && test -s build/quarter_path.svg &&
        test -s build/quarter_lean.svg && test ! -s stderr
}
has_21_rows_in_80_columns()
{
    test "$(rows | wc -l)" -eq 21 && test -z "$(awk 'length > 80' stdout)"
}
claim "the first run draws three pictures into build" draws_three_pictures
claim "it prints 21 rows, nothing wider than 80" has_21_rows_in_80_columns
claim "a quarter rolls from start to end" \
    test "$(rows | grep -c ' rolls$')" -eq 21
claim "docs/figures shows what the program draws" \
    cmp build/quarter.svg "$root/docs/figures/rolling_quarter.svg"

# ----------------------------------------------------- against the references
# agrees SCENE TIME: the last row, to the last digit shown, is that of the
# reference trajectory.
agrees()
{
    exits 0 --scene "$1" --duration "$2" --out out || return
    rows | tail -n 1 >last
    awk -F, -v t="$2" -v lengths="$3" -v weight="$4" '
        FNR == NR && $1 + 0 == t && /^[0-9]/ {
            degrees = 45 / atan2(1, 1)
            n = split($2 * degrees " " $3 * degrees " " $5 * lengths " " \
                      $6 * lengths " 0 " $14 / weight " " $16 / $14, want, " ")
        }
        FNR != NR {
            split($0, got, " ")
            split("0.01 0.1 0.01 0.01 1e-6 0.001 0.001", unit, " ")
            for (k = 1; k <= n; ++k) {
                off = got[k + 1] - want[k]
                if (off * off > (0.501 * unit[k]) ^ 2) {
                    print "column " k + 1 ": " got[k + 1] ", not " want[k]
                    exit 1
                }
            }
            exit n != 7
        }' OFMT=%.12g CONVFMT=%.12g "$root/tests/reference/$1.csv" last
}
claim "quarter is right after 1 s" agrees quarter 1 100 0.0556037055
for scene in wobble generic circle tumble nearflat ring; do
    claim "$scene is right after 10 units" agrees $scene 10 1 1
done
claim "spin is right after 5 units" agrees spin 5 1 1

# The extremes of the quarter's nod, from its turning points and from the
# closed formulas for N and F there; the track is radius times roll.
sums_up()
{
    track=$(awk -F, '$1 + 0 == 1 && /^[0-9]/ { printf "%.2f", $4 * 1.213 }' \
        "$root/tests/reference/quarter.csv")
    exits 0 --duration 1 --out out &&
        grep -q '^lean  *15.46 to 17.19 degrees$' stdout &&
        grep -q "^track  *$track cm\$" stdout &&
        grep -q '^N/(Mg)  *0.984 at least$' stdout &&
        grep -q '^F/N  *0.196 at most$' stdout &&
        grep -q '^a real coin  *can do this with mu 0.3$' stdout
}
claim "the summary of a quarter's second is right" sums_up
# Dry friction takes as much energy for each radian, whatever the motion, (69):
# the energy at the start is (23).
comes_to_rest()
{
    exits 0 --out out && awk '
        /^And then/ { dry = $6; next }
        dry && NF == 5 && $1 + 0 > 0 {
            w2 = 0.01213 / 9.80665
            E = (25 / 4 + 1.5 * 1600) * w2 / 2 + cos(0.3)
            lost = dry * 8 * atan2(1, 1) * $3 / E
            # The last digits of energy and turns.
            if ((1 - $5 - lost) ^ 2 > 0.0006 ^ 2) { print $0, lost; exit 1 }
            rows++
        }
        / flat; / { flat = $1 > last }
        { last = $1 }
        END { exit rows != 7 || !flat }' stdout
}
claim "the quarter then comes to rest as dry friction has it" comes_to_rest
# energy_error EXPONENTS DT: of the summary's energy error at that step.
energy_error()
{
    exits 0 --dt "$2" --out out &&
        grep -q "^energy error  *[0-9]e-$1 at most\$" stdout
}
claim "steps of 10 ms lose energy" energy_error 0[456] 0.01
claim "steps of 1 ms lose 10^5 times less" energy_error '\(09\|1[01]\)' 0.001

# ------------------------------------------------------- scenes and methods
# draws SCENE METHOD: pictures that are XML, without a number that is none, and
# a table without -0.00.
draws()
{
    exits 0 --scene "$1" --method "$2" --out out || return
    grep -e ' -0\.0*\( \|$\)' stdout && return 1
    "$python" - "out/$1.svg" "out/$1_path.svg" "out/$1_lean.svg" <<'END'
import re
import sys
import xml.etree.ElementTree as xml

for name in sys.argv[1:]:
    root = xml.parse(name).getroot()
    tags = [e.tag.rpartition("}")[2] for e in root.iter()]
    wrong = [v for e in root.iter() for k, v in e.attrib.items()
             if re.search(r"nan|inf", v)]
    points = [e.get("points").split() for e in root.iter()
              if e.tag.endswith("polyline")]
    width, height = float(root.get("width")), float(root.get("height"))
    inside = all(0 <= x <= width and 0 <= y <= height
                 for p in points for x, y in (map(float, q.split(","))
                                              for q in p))
    coins = tags.count("ellipse")
    good = (tags[0] == "svg" and tags.count("title") == 1 and not wrong
            and inside and points and (coins > 0) != name.endswith("_lean.svg"))
    if not good:
        sys.exit(f"{name}: {len(points)} curves, {coins} coins, {wrong}")
END
}
claim "there is a scene to choose" test "$(listed scenes | wc -l)" -ge 8
claim "there is a method to choose" test "$(listed methods | wc -l)" -ge 1
for scene in $(listed scenes); do
    for method in $(listed methods); do
        claim "$scene by $method draws good pictures" draws "$scene" "$method"
    done
done

# --------------------------------------------------------------- validity
says() { exits 0 --out out "$@" && rows | grep -q "$word"; }
never_says() { exits 0 --out out "$@" && ! rows | grep -q "$word"; }
word=' slips'
claim "a coin slips on ice" says --mu 0.1
claim "enough friction never lets it slip" never_says --scene hoop --mu inf
word=' lifts'
claim "a coin that falls almost flat lifts off" says --scene nearflat
claim "the drawing shows where" grep -q "would slip or lift" out/nearflat.svg
claim "and that a quarter does neither" \
    test "$(grep -c 'would slip or lift' build/quarter.svg)" -eq 0
word=coarse
claim "a step of 10 ms is coarse for a quarter" says --dt 0.01
claim "one of 1 ms is not" never_says --dt 0.001

# ------------------------------------------------------------------ throws
# Friction of mu N slows the slip of an upright disc by 3 mu g.  The coin leans
# by 8 degrees at most, whose square is 2 %.
stops_slipping()
{
    exits 0 --scene throw --out out && awk -v slip=3.1 -v g=9.80665 -v mu=0.27 '
        /^from/ { changes++; when = $2 }
        /^ .* (slips|rolls)$/ {
            want = 100 * (slip - 3 * mu * g * $1)
            if (want < 0) want = 0
            off = $8 - want
            if (off ^ 2 > 6.2 ^ 2 || ($8 > 0) != ($9 == "slips") ||
                rows && $6 > energy) { print; exit 1 }
            energy = $6
            rows++
        }
        END { late = when / (slip / (3 * mu * g)) - 1
              exit rows != 21 || changes != 2 || late ^ 2 > 0.02 ^ 2 }' stdout
}
claim "a thrown quarter slips until friction has used that up" stops_slipping
claim "the drawing shows where" grep -q ">it slips<" out/throw.svg
# Before it lands its centre is a free point and its energy stays.
tosses()
{
    exits 0 --scene toss --mu 0.3 --out out && awk '
        / flies$/ && $1 < 0.14 {off += $6 != "1.0000"; n++}
        / (heads|tails)$/ {rests = 1}
        /^(heads|tails) after [0-9.]+ s$/ {said = 1}
        END {exit !(n >= 2 && off == 0 && rests && said)}' stdout
}
claim "a tossed quarter flies, and ends as heads or tails" tosses
claim "the drawing shows where" grep -q ">it slips or flies<" out/toss.svg
# Let go on the edge's inner side of its balance, atan(1.75/24.26), it stands in
# the end, and has lost no more than it had above that: cos + h sin - 1.
stands()
{
    exits 0 --scene edge --out out && awk '
        /^ .* (rolls|on its edge)$/ { if ($2 ^ 2 > 4.02 ^ 2) exit 1; rows++ }
        /^it lost/ { h = 1.75 / 24.26; least = cos(0.07) + h * sin(0.07)
                     off = $3 - 100 * (1 - 1 / least) }
        /^on its edge after 1[0-9.]* s$/ { said = 1 }
        END { exit !(rows == 21 && said && off ^ 2 <= 0.051 ^ 2) }' stdout
}
claim "a quarter that rocks stands on its edge in the end" stands
# 60 rad/s up the slope, and down by 2/3 of gravity along it.
rolls_down()
{
    exits 0 --scene slope --out out && awk '
        BEGIN { down = 9.80665 * sin(10 * atan2(1, 1) / 45) / 3 }
        /^ .* rolls$/ { off = $4 - 100 * (down * $1 - 60 * 0.01213) * $1
                        bad += off ^ 2 > 0.0051 ^ 2 || $6 != "1.0000"; rows++ }
        END { exit rows != 21 || bad }' stdout
}
claim "a quarter rolls up a slope and down again" rolls_down
# The columns that both tables have.
poses() { rows | cut -c 1-44; }
keeps_rolling()
{
    exits 0 --out out && poses >rolls.txt && exits 0 --slip --out out &&
        poses >slides.txt && cmp rolls.txt slides.txt &&
        test "$(rows | grep -c ' rolls$')" -eq 21
}
claim "with enough friction --slip changes nothing" keeps_rolling
word='  slips$'
claim "a quarter slips with --slip and mu 0.15" says --slip --mu 0.15
claim "and may have any grip" never_says --slip --mu inf
lands_again()
{
    exits 0 --slip --scene generic --mu 0.25 --out out &&
        rows | tail -1 | grep -q '^ *45\.000 '
}
claim "a coin that lifts off goes on" lands_again

# -------------------------------------------------------------------- csv
# writes_csv ROWS OPTION...: so many rows of 14 numbers; the last has the time,
# the lean and the N/(Mg) of the table's last row.
writes_csv()
{
    count=$1
    shift
    exits 0 --out out --csv out/run.csv "$@" || return
    rows | tail -n 1 >last
    awk -F, -v count="$count" -v weight=0.0556037055 '
        FNR == NR { split($0, want, " "); next }
        { bad += NF != 14 }
        FNR > 1 { for (k = 1; k <= 14; ++k) bad += $k != $k + 0 }
        { t = $1; lean = $2 * 45 / atan2(1, 1); normal = $11 / weight }
        END { off = (lean - want[2]) ^ 2 > 0.0051 ^ 2 ||
                    (normal - want[7]) ^ 2 > 0.00051 ^ 2 ||
                    (t - want[1]) ^ 2 > 1e-20
              exit bad || off || FNR != count + 1 }' last out/run.csv
}
claim "--csv writes every moment" writes_csv 1501
claim "of a coin that slips too" writes_csv 601 --scene throw
claim "a file that cannot be written fails" \
    refuses 1 "none/run.csv: No such" --csv none/run.csv --out out
claim "nor one on a full disk" refuses 1 "No space" --csv /dev/full --out out

# --------------------------------------------------------------- refusals
claim "a step through the table fails, and says so" \
    refuses 1 "smaller --dt" --scene nearflat --dt 0.2 --out out
claim "what came before is printed" test "$(rows | wc -l)" -ge 5
claim "a missing folder fails" refuses 1 "none/quarter.svg: No such" --out none
claim "a file is not a folder" refuses 1 "Not a directory" --out stdout
claim "a long name fails" \
    refuses 1 "too long" --out "$(printf '%9999d' 0 | tr ' ' x)"
ln -sf /dev/full out/circle_lean.svg
claim "a full disk fails" refuses 1 "No space" --scene circle --out out
full_output()
{
    "$demo" --out out >/dev/full 2>stderr
    test $? -eq 1 && grep -q "standard output: No space" stderr
}
claim "a table that does not get out fails" full_output

claim "an unknown option" refuses 2 "no option '--speed'" --speed 3
claim "a word that is no option" refuses 2 "no option 'quarter'" quarter
claim "an unknown scene lists the scenes" refuses 2 "^  nearflat$" --scene dime
claim "an unknown method lists the methods" refuses 2 "^  rk4$" --method rk5
for option in --scene --method --dt --duration --mu --out --csv; do
    claim "$option alone" refuses 2 "$option needs a value" $option
done
for number in 0 -1 nan inf 1e999 1e-3s ''; do
    claim "--dt '$number'" refuses 2 "finite number > 0" --dt "$number"
    claim "--duration '$number'" \
        refuses 2 "finite number > 0" --duration "$number"
done
for number in -0.1 nan ice ''; do
    claim "--mu '$number'" refuses 2 "number >= 0" --mu "$number"
done
claim "too many steps" refuses 2 "more than 1e+08" --dt 1e-9
claim "infinitely many steps" \
    refuses 2 "more than 1e+08" --dt 1e-300 --duration 1e300
claim "less than one step" refuses 2 "shorter" --dt 1 --duration 0.1

# -------------------------------------------------------- in the terminal
claim "--live plays a circle, stops when told, and wants a terminal" \
    "$python" "$root/tests/demo/live.py" "$demo"

# ------------------------------------------------------------------- the rest
claim "--help explains itself" exits 0 --help
claim "it names every option" test "$(grep -c -e ' --' stdout)" -eq 11
claim "a folder's name may be odd" exits 0 --out "an odd %s name"
claim "its pictures are there" test -s "an odd %s name/quarter_path.svg"
claim "a run of one step is drawn" exits 0 --duration 0.001 --out out
claim "it has two rows" test "$(rows | wc -l)" -eq 2

echo "demo: $claims claims, $failures failed"
test $failures -eq 0
