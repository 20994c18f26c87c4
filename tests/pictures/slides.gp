# SPDX-License-Identifier: MIT
# slides.svg: coins thrown in five directions, from slides.csv.  Two blocks for
# each direction: it slips, it rolls.
load style
set datafile separator ","
set datafile missing NaN
file = from."/slides.csv"
slips = 0xD55E00
rolls = 0x0072B2
set terminal svg size 800,480 font "sans,12" background rgb "white"
set output to."/slides.svg"
set multiplot

# From above, z down; a radius is as long both ways.
set margins at screen 0.06, screen 0.40, screen 0.08, screen 0.97
set size ratio -1
set xrange [-12:8]
set yrange [22.5:-13.5]
set xtics 5
set ytics 5
set label 1 "x, in radii" at graph 1, graph 0.03 right tc rgb "#606060"
set label 2 "z" at graph 0.02, graph 0.985 left tc rgb "#606060"
set label 3 "slips" at 2.4,-8 left tc rgb slips
set label 4 "rolls" at -7.6,-11 center tc rgb rolls
set label 5 "rolls" at -7.6,17 right tc rgb rolls
set label 6 "thrown here" at -0.7,0.2 right tc rgb "#404040"
plot for [k=0:4] file index 2*k using 3:4 with lines lw 2.4 dt (8,4) \
        lc rgb slips, \
    for [k=0:4] file index 2*k + 1 using 3:4 with lines lw 2.4 lc rgb rolls, \
    for [k=0:4] file index 2*k + 1 every ::0::0 using 3:4 with points pt 7 \
        ps 0.7 lc rgb rolls
unset label

set margins at screen 0.49, screen 0.97, screen 0.10, screen 0.97
set size noratio
set xrange [0:14]
set yrange [0:9]
set xtics 2
set ytics 2
set xlabel "time, in sqrt(a/g)" offset 0,0.3
set label 1 "slip speed, in sqrt(g a)" at graph 0.5, graph 0.94 left tc rgb "#404040"
set label 2 "direction 60" at 5.4,3.1 right tc rgb "#404040"
set label 3 "direction -30" at 9.4,1.6 left tc rgb "#404040"
set label 4 "rolls" at 12,0.45 center tc rgb rolls
set arrow 1 from 9.2274,0 to 14,0 nohead lw 2.4 lc rgb rolls front
plot for [k=0:4] file index 2*k using \
        (int($0 + (k ? 0 : 2))%3 == 0 || $5 == 0 ? $2 : NaN):5 with lines lw 1.8 lc rgb slips, \
    for [k=0:4] file index 2*k + 1 every ::0::0 using 2:5 with points pt 7 \
        ps 0.7 lc rgb rolls
unset multiplot
