# SPDX-License-Identifier: MIT
# orbit.svg, orbit_phase.svg: an orbit beside steps.
#     gnuplot -e "from='...'" -e "results='...'" -e "to='...'" orbit.gp
load results."/../style.gpi"
set datafile separator ","
set datafile missing NaN # lines go on past it
set logscale xy
set format "10^{%T}"
costs = results."/orbit_costs.csv"

array way[6] = ["orbit", "rk4", "rk8", "coin_advance", "textbook RK4", \
                "GSL rk8pd"]
array look[6] = [14, 2, 3, 4, 1, 7]
only(k, column, value, x) = \
    strcol(1) eq way[k] && column(column) == value ? column(x) : NaN

set terminal svg size 800,430 font "sans,12" background rgb "white"
set output to."/orbit.svg"
set multiplot layout 1,2 margins 0.08,0.985,0.12,0.9 spacing 0.07
set xrange [1:1e6]
set yrange [1e-6:10]
set key top left Left reverse samplen 2 font ",11"
set xlabel "frames n, of 100 natural units in all" offset 0,0.4
set ylabel "cost [s]" offset 1.5,0
plot for [k=1:6] costs using (only(k, 2, 100, 3)):($5*1e-9) \
    with linespoints ls look[k] title way[k] noenhanced
unset key
unset ylabel
set format y ""
set xlabel "time T of 100 frames [natural units]" offset 0,0.4
plot for [k=1:6] costs using (only(k, 3, 100, 2)):($5*1e-9) \
    with linespoints ls look[k]
unset multiplot

set output to."/orbit_phase.svg"
set terminal svg size 800,400 font "sans,12" background rgb "white"
set margins 8, 1, 3, 1
set format "10^{%T}"
set xrange [1e3:1.2e7]
set xtics 1e3,10,1e6
set yrange [1e-11:1]
set xlabel "time [natural units]" offset 0,0.4
set ylabel "phase against the orbit's [rad]" offset 1.5,0
phases = results."/orbit_phase.csv"
array run[8] = ["textbook RK4 0.05", "rk4 0.05", "rk4 0.01", "rk8 0.1", \
    "rk8 0.05", "order 14 in tau 0.1", "symplectic2 0.01", "symplectic4 0.1"]
array line[8] = [1, 2, 2, 3, 3, 4, 5, 6]
is(k) = strcol(1)." ".strcol(2) eq run[k]
last(k) = system("awk -F, '$1\" \"$2 == \"".run[k]."\" {x = $3*1.2\",\"$4} ".\
    "END {print x}' ".phases)
do for [k=1:8] {
    at = last(k)
    comma = strstrt(at, ",")
    if (k > 1) {
        set label k run[k] at (at[1:comma-1]+0),(at[comma+1:*]+0) \
            left font ",11" tc rgb colour[line[k]]
    }
}
set label 1 "textbook RK4, rk4 0.05" at 1.2e4,0.5 left font ",11"
unset label 2
plot for [k=1:8] phases using (is(k) ? $3 : NaN):4 \
    with linespoints ls line[k]
