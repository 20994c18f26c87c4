# SPDX-License-Identifier: MIT
# nearly_flat.svg: the turn of a nearly flat pass against its closest approach,
# from nearly_flat.csv.
load style
set datafile separator ","
set terminal svg size 800,400 font "sans,12" background rgb "white"
set output to."/nearly_flat.svg"
file = from."/nearly_flat.csv"
set margins 11, 3, 3.2, 1
set logscale x
set xrange [8e-7:0.5]
set format x "10^{%T}"
set xlabel "closest approach to flat [rad]" offset 0,0.3
set ylabel "turn of the heading"
set yrange [5.2:8.2]
set ytics ("π√3" pi*sqrt(3), "π√5" pi*sqrt(5), "450°" 2.5*pi, "360°" 2*pi)
limit(b) = pi*sqrt(1 + 4/(1 + b**2))
do for [k=0:2] { set arrow k+1 from 8e-7,limit(k/2.0) to 0.5,limit(k/2.0) \
    nohead lc rgb "#A0A0A0" dt 3 lw 1.4 }
set label 1 "disc" at 3e-6,limit(0)+0.13 tc ls 2
set label 2 "ring, b/a = 1/2" at 3e-6,limit(0.5)+0.13 tc ls 3
set label 3 "hoop" at 3e-6,limit(1)+0.13 tc ls 4
plot for [k=0:2] file index k using 3:4 with lines ls k+2
