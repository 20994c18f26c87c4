# SPDX-License-Identifier: MIT
# models.svg: the error of each model against the distance from steady, from
# models_errors.csv.
load style
set datafile separator ","
set terminal svg size 800,440 font "sans,12" background rgb "white"
set output to."/models.svg"
file = from."/models_errors.csv"
set margins 10, 3, 3.2, 1
set logscale xy
set xrange [1e-8:0.1]
set yrange [1e-15:10]
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "distance from a steady motion [rad]" offset 0,0.3
set ylabel "error of the pose over 30 units [rad, radii]" offset -0.5,0
set label 1 "steady" at 1e-6,1.2e-6 center rotate by 27 tc ls 3
set label 2 "small wobble" at 2.2e-5,3e-10 center rotate by 45 tc ls 2
set label 3 "orbit" at 1e-3,1.2e-14 center tc ls 4
set label 4 "largest of 100 dashed" at 0.09,3e-15 right tc rgb "#606060"
colours = "#D55E00 #0072B2 #009E73"
plot for [k=1:3] file using 1:2*k with lines lw 2.2 lc rgb word(colours, k), \
    for [k=1:3] file using 1:2*k+1 with lines lw 1 dt 2 \
        lc rgb word(colours, k)
