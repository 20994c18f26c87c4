# SPDX-License-Identifier: MIT
# models_quasi.svg: the errors of the quasi-steady model against the angle that
# the contact rolls by, from models_quasi.csv.
load style
set datafile separator ","
set terminal svg size 800,440 font "sans,12" background rgb "white"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set output to."/models_quasi.svg"
file = from."/models_quasi.csv"
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
