# SPDX-License-Identifier: MIT
# bifurcation.svg: steady motions and their stability, from bifurcation.csv.
load style
set datafile separator ","
set terminal svg size 800,400 font "sans,12" background rgb "white"
set output to."/bifurcation.svg"
file = from."/bifurcation.csv"
deg(x) = x * 180 / pi
set multiplot layout 1,2
set margins 7, 1.5, 3.2, 2.2

set title "Circles: which are unstable" offset 0,-0.5
set xlabel "rate of roll, in sqrt(g/a)" offset 0,0.5
set ylabel "lean" offset 1,0
set xrange [0:0.7]
set yrange [0:24]
set xtics 0.1
set ytics ("0" 0, "5°" 5, "10°" 10, "15°" 15, "20°" 20)
set label 1 "unstable" at 0.33,8 center font ",14" tc ls 3 front
set label 2 "stable" at 0.6,15 center font ",14" tc ls 2
set label 3 "disc" at 0.41,18.9 left tc ls 3
set label 4 "hoop" at 0.165,18.4 right tc rgb "#606060"
plot file index 0 using 2:(deg($3)) with filledcurves y1=0 fc rgb "#FBEFEA", \
    file index 0 using 2:(deg($3)) with lines ls 3, \
    file index 2 using 2:(deg($3)) with lines ls 8, \
    file index 1 using 2:(deg($3)) with points pt 7 ps 0.8 lc rgb "#D55E00", \
    file index 3 using 2:(deg($3)) with points pt 7 ps 0.6 lc rgb "#606060"
unset label

set title "Slower than 0.577 upright parts in two" offset 0,-0.5
set xlabel "rate of roll when upright, in sqrt(g/a)" offset 0,0.5
set yrange [-75:75]
set xrange [0:0.8]
set xtics 0.2
set ytics ("-60°" -60, "-30°" -30, "0" 0, "30°" 30, "60°" 60)
set label 1 "stable" at 0.33,52 left tc ls 2
set label 2 "unstable" at 0.2,-5 center tc ls 3
set label 3 "with wY = 0.05" at 0.52,-30 left tc rgb "#606060"
plot file index 5 using 2:(deg($3)) with points pt 7 ps 0.2 lc rgb "#909090", \
    file index 4 using 2:($4 < 0 ? deg($3) : NaN) with points pt 7 ps 0.3 \
        lc rgb "#0072B2", \
    file index 4 using 2:($4 >= 0 ? deg($3) : NaN) with points pt 7 ps 0.3 \
        lc rgb "#D55E00"
unset multiplot
