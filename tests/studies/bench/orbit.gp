# SPDX-License-Identifier: MIT
# orbit.svg: an orbit beside steps.
#     gnuplot -e "from='...'" -e "results='...'" -e "to='...'" orbit.gp
load results."/../style.gpi"
set datafile separator ","
set datafile missing NaN # lines go on past it
set logscale xy
set format "10^{%T}"
costs = results."/orbit_costs.csv"

array way[4] = ["orbit", "rk8", "coin_advance", "textbook RK4"]
array look[4] = [14, 3, 4, 1]
only(k, column, value, x) = \
    strcol(1) eq way[k] && column(column) == value ? column(x) : NaN

set terminal svg size 800,430 font "sans,12" background rgb "white"
set output to."/orbit.svg"
set multiplot layout 1,2 margins 0.08,0.985,0.12,0.9 spacing 0.07
set xrange [1:1e6]
set yrange [1e-6:10]
set key top left Left reverse samplen 2 font ",11"
set title "many frames of one motion" offset 0,-0.6
set xlabel "frames n, of 100 natural units in all" offset 0,0.4
set ylabel "cost [s]" offset 1.5,0
plot for [k=1:4] costs using (only(k, 2, 100, 3)):($5*1e-9) \
    with linespoints ls look[k] title way[k] noenhanced
unset key
unset ylabel
set format y ""
set title "frames of a later time" offset 0,-0.6
set xlabel "time T of 100 frames [natural units]" offset 0,0.4
plot for [k=1:4] costs using (only(k, 3, 100, 2)):($5*1e-9) \
    with linespoints ls look[k]
unset multiplot
