# SPDX-License-Identifier: MIT
# potential.svg: the effective potential, from potential.csv.
load style
set datafile separator ","
set terminal svg size 800,400 font "sans,12" background rgb "white"
set output to."/potential.svg"
file = from."/potential.csv"
deg(x) = x * 180 / pi
set multiplot layout 1,2
set margins 8, 1, 3.2, 2.2
set xlabel "lean" offset 0,0.5
set ylabel "potential above upright, in M g a" offset 1,0
set xtics ("-80°" -80, "-40°" -40, "0" 0, "40°" 40, "80°" 80)
set xrange [-88:88]

set title "Rolling straight: fast enough, and upright is a valley" offset 0,-0.5
set yrange [-0.16:0.16]
set ytics 0.05
# V upright: K wZ^2/2 + M g a.
up(w) = 0.75 * w**2 + 1
speeds = "0.3 0.45 0.57735026918962576 0.7"
set label 1 "wZ = 0.3" at 0,-0.115 center tc ls 3
set label 2 "0.45" at 0,-0.04 center tc ls 6
set label 3 "0.577" at 0,0.022 center tc ls 1
set label 4 "0.7" at 2,0.075 center tc ls 2
set arrow 4 from 6,0.068 to 20,0.042 nohead lc rgb "#808080" lw 0.8
plot for [k=1:4] file index k-1 using (deg($2)):($3 - up(real(word(speeds, k)))) \
    with lines ls (k == 1 ? 3 : k == 2 ? 6 : k == 3 ? 1 : 2)
unset label
unset arrow

set title "Where the lean turns back" offset 0,-0.5
set ylabel "potential, in M g a" offset 1,0
set yrange [1.6:2.7]
set ytics 0.2
set label 1 "steady circle" at -12,1.66 left offset 0.8,0 tc ls 3
set label 2 "three energies" at -6,2.42 center tc ls 2
plot file index 4 using (deg($2)):3 with lines ls 1, \
    for [k=6:8] file index k using (deg($2)):3 with linespoints ls 2 pt 7 ps 0.6, \
    file index 5 using (deg($2)):3 with points pt 7 ps 0.8 lc rgb "#D55E00"
unset multiplot
