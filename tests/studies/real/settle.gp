# SPDX-License-Identifier: MIT
# settle.svg: a quarter's life by coin_settle() and by fixed steps, error against
# cost, from settle.csv.
load style
set datafile separator ","
set terminal svg size 900,400 font "sans,12" background rgb "white"
set output to."/settle.svg"
file = from."/settle.csv"
array method[3] = ["settle", "rk8", "rk4"]
array hue[3] = [0x009E73, 0xD55E00, 0x0072B2]
array mark[3] = [7, 5, 9]
is(k) = strcol(1) eq method[k]
fails(how) = strcol(7) eq how
# Where a life has no error to show: it failed.
lost = 8
set multiplot layout 1,3
set margins 8, 1, 3.6, 2.4
set logscale xy
set format "10^{%T}"
set xrange [1e-16:60]
set yrange [1000:1e6]
set xtics 1e-15,1e5,1
set grid
set object 1 rectangle from 1.5,1000 to 60,1e6 fc rgb "#FBEFEA" fs solid noborder behind
set ylabel "cost in textbook steps" offset 1,0
set xlabel "error of the heading [rad]" offset 0,0.4

set title "after nine tenths of the life" offset 0,-0.6
set label 1 "coin\\_settle" at 3e-9,2200 right tc rgb hue[1]
set label 2 "order 8" at 2e-12,1.3e5 right tc rgb hue[2]
set label 3 "order 4" at 2e-10,2.9e5 left tc rgb hue[3]
plot for [k=1:3] file using (is(k) ? $4 : NaN):3 with linespoints pt mark[k] \
    ps 0.5 lw 1.8 lc rgb hue[k]

unset ylabel
set format y ""
unset label
set title "13 ms before its end"
set label 4 "failed" at 55,5200 right tc rgb "#404040"
plot for [k=1:3] file using (is(k) ? $5 : NaN):3 with linespoints pt mark[k] \
    ps 0.5 lw 1.8 lc rgb hue[k], \
    for [k=2:3] file using (is(k) && strcol(5) eq "nan" ? lost : NaN):3 with points pt 2 \
    ps 0.8 lw 1.5 lc rgb hue[k]

set title "at rest"
set xlabel "error of the time of rest [s]"
unset label
set label 5 "through the table" at 1e-2,6e5 right tc rgb "#404040" point pt 10 \
    ps 0.8 lc rgb "#404040" offset -2.4,0
set label 6 "energy gained" at 1e-2,3.6e5 right tc rgb "#404040" point pt 2 \
    ps 0.8 lc rgb "#404040" offset -2.4,0
plot file using (is(1) ? $6 : NaN):3 with linespoints pt mark[1] ps 0.5 lw 1.8 \
    lc rgb hue[1], \
    for [k=2:3] file using (is(k) && fails("through the table") ? lost : NaN):3 \
    with points pt 10 ps 0.8 lw 1.5 lc rgb hue[k], \
    for [k=2:3] file using (is(k) && fails("energy gained") ? lost : NaN):3 \
    with points pt 2 ps 0.8 lw 1.5 lc rgb hue[k]
unset multiplot
