# SPDX-License-Identifier: MIT
# rest.svg, face.svg, hum.svg: how a spinning coin comes to rest, from rest.csv.
# Blocks: dry, viscous, layer, gap, rolling, damping, for the disc and then for
# the quarter.
load style
set datafile separator ","
file = from."/rest.csv"
array law[6] = ["dry", "viscous", "layer", "gap", "rolling", "damping"]
array hue[6] = [0xD55E00, 0x0072B2, 0x009E73, 0xCC79A7, 0x606060, 0xB07C00]
array mark[6] = [7, 5, 9, 13, 6, 4]
e0 = 0.1

# Eq. (75), solved for e/e0 at a part of the time that is left.
array power[6] = [2./3, 1./2, 4./9, 1./3, 2, 2]
array rest[6]
do for [k=1:6] { stats file index k-1 using 2 nooutput; rest[k] = STATS_max }

set terminal svg size 800,480 font "sans,12" background rgb "white"
set output to."/rest.svg"
set margins 10, 14, 3.4, 1.5
set logscale xy
set xrange [1:7e-5] reverse
set yrange [1e-7:1]
set format "10^{%T}"
set xlabel "part of the time that is left, (t_0 - t)/t_0" offset 0,0.3
set ylabel "angle from flat, over that at the start"
set label 1 "gap, 1/3" at graph 1.01, first 0.06 left tc rgb hue[4]
set label 2 "layer, 4/9" at graph 1.01, first 0.0195 left tc rgb hue[3]
set label 3 "viscous, 1/2" at graph 1.01, first 0.0072 left tc rgb hue[2]
set label 4 "dry, 2/3" at graph 1.01, first 0.002 left tc rgb hue[1]
set label 6 "rolling and damping, 2:" at 1.2e-3,1.6e-4 left tc rgb hue[5]
set label 7 "they lie down at 1e-6 rad" at 1.2e-3,7e-5 left tc rgb "#606060"
set samples 2
plot for [k=1:6] x**power[k] with lines lw 1 lc rgb "#A0A0A0", \
    for [k=1:6] file index k-1 using ($2/rest[k]):($3/e0) with points \
    pt mark[k] ps 0.5 lc rgb hue[k]

unset label
unset logscale
set output to."/face.svg"
set terminal svg size 800,400 font "sans,12" background rgb "white"
set format "%g"
set margins 10, 3, 3.4, 1.5
set xrange [1:0]
set yrange [-0.8:2.2]
set xtics 0.2
set xlabel "angle from flat, over that at the start"
set ylabel "turn of the face, over e_0^{3/2}"
set object 1 rectangle from graph 0, first 0 to graph 1, graph 0 fc rgb "#F3F3F3" \
    fs solid noborder behind
back = (5./23)**(2./3)
set arrow 1 from back,0 to back,-0.8 nohead lc rgb "#808080" dt 3
set label 1 "the face turns backward" at 0.98,-0.3 left tc rgb "#404040"
set label 2 "from e = (5/23)^{2/3} e_0 on" at 0.98,-0.58 left tc rgb "#404040"
set label 3 "(23 (e/e_0)^{3/2} - 5)/9" at 0.66,1.05 left tc rgb "#404040"
do for [k=1:4] {
    set label 10+k law[k] at graph 0.75, first 2.15 - 0.22*k tc rgb hue[k] \
        point pt mark[k] ps 0.7 lc rgb hue[k] offset 1,0
}
set samples 60
plot (23*x**1.5 - 5)/9 with lines lw 1 lc rgb "#A0A0A0", \
    for [k=1:4] file index k-1 using ($3/e0):($4/e0**1.5) with points \
    pt mark[k] ps 0.7 lc rgb hue[k]

unset label
unset object
unset arrow
set output to."/hum.svg"
set terminal svg size 800,420 font "sans,12" background rgb "white"
set margins 10, 3, 3.4, 1.5
set xrange [10:8e-4] reverse
set yrange [8:2000]
set logscale xy
set xtics ("8 s" 8, "1 s" 1, "100 ms" 0.1, "10 ms" 0.01, "1 ms" 0.001)
set ytics ("10" 10, "30" 30, "100" 100, "300" 300, "1000" 1000)
set xlabel "time left until rest: less to the right"
set ylabel "the contact's turns per second"
set label 1 "dry" at 4e-3,230 center tc rgb hue[1]
set label 2 "viscous" at 1.7e-3,90 center tc rgb hue[2]
set label 3 "layer" at 7e-3,47 center tc rgb hue[3]
set label 4 "gap" at 1.6e-2,26 center tc rgb hue[4]
set label 5 "rolling, until it rattles" at 0.27,130 left tc rgb hue[5]
set label 6 "damping" at 0.14,1000 right tc rgb hue[6]
set label 7 "the contact stops" at 3.8e-3,9.3 right tc rgb "#404040"
plot for [k=1:6] file index k+5 using \
    ($2 > (k == 5 ? 0.2 : 0) ? $2 : NaN):(abs($5)/2/pi) with linespoints \
    pt mark[k] ps 0.4 lw 1.6 lc rgb hue[k]
