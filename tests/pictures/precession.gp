# SPDX-License-Identifier: MIT
# precession.svg: the turn of the heading in a period of the lean against the
# energy, from precession.csv.
load style
set datafile separator ","
set terminal svg size 800,440 font "sans,12" background rgb "white"
set output to."/precession.svg"
file = from."/precession.csv"
set margins 9, 3, 3.2, 1
set logscale x
set xrange [4e-5:1500]
set format x "10^{%T}"
set xlabel "energy above the steady motion's, in M g a" offset 0,0.3
set ylabel "turn of the heading per period" offset 0,0
set yrange [-0.8:15.6]
flat = 2 * pi * sqrt(5)
set ytics ("0" 0, "360°" 2*pi, "720°" 4*pi, "2π√5" flat)
set arrow 1 from 4e-5,flat to 1500,flat nohead lc rgb "#A0A0A0" dt 3 lw 1.4
set label 1 "0.45, 0.3" at 2e-2,8.5 center tc ls 3
set label 2 "K_Y, K_Z = 0.8, 0.3" noenhanced at 2e-2,6.5 center tc ls 2
set label 3 "-0.2, 0.7" at 2e-2,2.7 center tc ls 6
set label 4 "-0.35, 1" at 2e-2,0.2 center tc ls 4
set label 5 "small nods:\nλ alone" at 5e-5,10 left tc rgb "#404040"
set label 6 "near flat on both sides, the same way" at 1200,9.3 right tc rgb "#404040"
set label 7 "opposite ways" at 1200,1.1 right tc rgb "#404040"
plot for [k=0:3] file index 2*k+1 using 4:5 with lines ls word("2 3 4 6", k+1), \
    for [k=0:3] file index 2*k using (5e-5):5 with points pt 7 ps 0.7 lc rgb "#222222"
