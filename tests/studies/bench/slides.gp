# SPDX-License-Identifier: MIT
# models_slides.svg: coins that slip, cost against error, a panel per scene.
#     gnuplot -e "results='...'" -e "to='...'" slides.gp
load results."/../style.gpi"
set terminal svg size 900,380 font "sans,12" background rgb "white"
set output to."/models_slides.svg"
set datafile separator comma
file = "<grep -v '^#' '".results."/slides.csv' | tail -n +2"
array scene[3] = ["thrown", "tumble", "ring"]
array says[3] = ["thrown, slides and rolls", "rolls, slips, rolls", \
                 "a slip that nearly ends"]
array method[3] = ["located", "regularised BDF", "time stepping"]
array style[3] = [4, 7, 12]
is(k, m) = strcol(1) eq scene[k] && strcol(2) eq method[m]
set logscale xy
set xrange [1e-12:1]
set yrange [50:2e7]
set xtics 1e-9,1e3 format "10^{%T}" offset 0,0.3
set ytics 1e2,100 format "10^{%T}" offset 0.5,0
unset mxtics
unset mytics
set xlabel "largest error [rad, radii]" offset 0,0.6
set multiplot
do for [k=1:3] {
    set margins at screen 0.075 + 0.31*(k - 1), screen 0.36 + 0.31*(k - 1), \
        screen 0.15, screen 0.93
    set title says[k] offset 0,-0.7
    if (k == 1) {
        set ylabel "cost in textbook steps" offset 1.5,0
        set label 1 "coin\\_move" at 2e-11,4e2 left tc rgb colour[4]
        set label 2 "friction" at 3e-4,2e5 right tc rgb colour[7]
        set label 3 "regularised" at 3e-4,1e5 right tc rgb colour[7]
    } else {
        unset label
        unset ylabel
        set format y ""
    }
    if (k == 2) {
        set label 1 "time stepping" at 3e-4,1e5 right tc rgb colour[12]
    }
    plot for [m=1:3] file using (is(k, m) ? $5 : NaN):6 with lines \
        ls style[m]
}
unset multiplot
