# SPDX-License-Identifier: MIT
# models.svg: the error of each model against the distance from steady, from
# models_errors.csv, and against what an answer costs, from models_costs.csv;
# models_quasi.svg: the errors of the quasi-steady model against the angle that
# the contact rolls by, from models_quasi.csv.
load style
set datafile separator ","
set terminal svg size 800,440 font "sans,12" background rgb "white"
set output to."/models.svg"
file = from."/models_errors.csv"
names = "steady wobble orbit"
calls = "coin_steady_at coin_wobble_at coin_orbit_at"
# Models have colours of their own, but for the orbit, which is a method too.
colours = "#606060 #882255 #E69F00"
set logscale xy
set yrange [1e-15:10]
set format x "10^{%T}"
set format y "10^{%T}"
set multiplot
set tmargin at screen 0.98
set bmargin at screen 0.13
set lmargin at screen 0.095
set rmargin at screen 0.53
set xrange [1e-8:0.1]
set xtics 1e-8,1e2
set xlabel "distance from a steady motion [rad]" offset 0,0.3
set ylabel "error of the pose over 30 units [rad, radii]" offset 0.5,0
set label 1 "steady" at 3e-7,3e-2 center tc rgb word(colours, 1)
set label 2 "small wobble" at 3e-4,1e-9 left tc rgb word(colours, 2)
set label 3 "orbit" at 1e-3,1.2e-14 center tc rgb "#B07C00"
set label 4 "largest of 100 dashed" at 0.09,3e-15 right tc rgb "#606060"
plot for [k=1:3] file using 1:2*k with lines lw 2.2 lc rgb word(colours, k), \
    for [k=1:3] file using 1:2*k+1 with lines lw 1 dt 2 \
        lc rgb word(colours, k)

# The same errors, from 1e-6 to 1e-2 off steady, over the cost of an answer.
unset label
set lmargin at screen 0.61
set rmargin at screen 0.985
set format x "%g"
set xrange [0.25:8]
set xtics (0.25, 0.5, 1, 2, 4, 8)
set xlabel "cost of an answer [textbook steps]" offset 0,0.3
set ylabel ""
set format y ""
cost(call) = real(system(sprintf( \
    "awk -F, '$1 == \"%s\" {print $3}' '%s/models_costs.csv'", call, from)))
do for [k=1:3] {
    set label k word(names, k) at cost(word(calls, k))*1.12,\
        (k == 1 ? 1e-4 : k == 2 ? 1e-9 : 1e-14) left \
        tc rgb (k == 3 ? "#B07C00" : word(colours, k))
}
plot for [k=1:3] file using (cost(word(calls, k))): \
         ($1 > 0.9e-6 && $1 < 1.1e-2 ? column(2*k) : NaN) \
         with linespoints pt 7 ps 0.4 lw 2.2 lc rgb word(colours, k)

# The quasi-steady model.
unset multiplot
set xtics autofreq
set ytics autofreq
set format x "10^{%T}"
set format y "10^{%T}"
set lmargin -1
set rmargin -1
set tmargin -1
set bmargin -1
set output to."/models_quasi.svg"
file = from."/models_quasi.csv"
unset label
set multiplot layout 1,2
set xrange [30:1e6]
set xlabel "roll in half of the life [rad]"
kind = "dry viscous layer gap rolling damping"
of(k) = sprintf("<grep '^%s,' %s", word(kind, k), file)
set margins 10, 2, 3.2, 1
set yrange [1e-9:0.1]
set ylabel "error of the time to rest, relative" offset -0.5,0
do for [k=1:6] { set label k word(kind, k) tc ls k+(k>1) }
set label 1 at 7e4,2.6e-8
set label 2 at 8e4,3.5e-7
set label 3 at 7e4,1.4e-6
set label 4 at 5.5e4,5e-6
set label 5 at 1.4e5,1.1e-4
set label 6 at 1.5e4,4e-9 right
plot for [k=1:6] of(k) using 4:5 with linespoints ls k+(k>1)
unset label
set yrange [1e-12:1]
set ylabel "error at half of it [rad]" offset -0.5,0
set label 1 "roll" at 2000,2e-2 tc rgb "#606060"
set label 2 "lean" at 700,2e-9 tc rgb "#606060"
plot for [k=1:6] of(k) using 4:7 with linespoints ls k+(k>1), \
    for [k=1:6] of(k) using 4:6 with linespoints ls k+(k>1)
unset multiplot
