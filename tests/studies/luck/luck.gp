# SPDX-License-Identifier: MIT
# same_side.svg, neighbours.svg, remembers.svg, three_sided.svg: the curves of
# docs/luck.md, from luck_caught.csv, luck_dust.csv, luck_fair.csv and
# luck_edge.csv.
load style
set datafile separator ","
is(what) = strcol(1) eq what
set terminal svg size 800,400 font "sans,12" background rgb "white"
set samples 400

# The law: 1/2 + asin(cot^2)/pi.
set output to."/same_side.svg"
set margins 10, 3, 3.4, 1.5
set xrange [40:90]
set yrange [0.49:1.01]
set xlabel "angle between the coin's axis and its angular momentum, degrees"
set ylabel "share that shows the side it began with"
cot2(x) = 1/tan(x*pi/180)**2
law(x) = x < 45 ? 1 : 0.5 + asin(cot2(x))/pi
set label 1 "Diaconis, Holmes and Montgomery's law" at 49.5,0.83 left \
    tc rgb "#606060"
set label 2 "coin\\_move, 1,000,000 tosses a point" at 49.5,0.79 left \
    tc rgb "#0072B2" point pt 7 ps 0.6 lc rgb "#0072B2" offset 1.2,0
set label 3 "0.508 of 350,757 tosses by hand: 81 degrees" at 81,0.62 right \
    tc rgb "#D55E00"
set arrow 1 from 81,0.61 to 81,0.512 lc rgb "#D55E00" lw 1.4
plot law(x) with lines lw 1.4 lc rgb "#909090", \
    results."/luck_caught.csv" using (is("same side") ? $2 : NaN):5 \
    with points pt 7 ps 0.6 lc rgb "#0072B2"
unset label
unset arrow

set output to."/neighbours.svg"
set margins 10, 18, 3.4, 1.5
set logscale xy
set xrange [1.5e-2:7e-10] reverse
set yrange [2e-5:1]
set format "10^{%T}"
set xlabel "how much higher the neighbour is let go, radii"
set ylabel "share that ends with the other side"
array rest[6] = [0, 0.2, 0.4, 0.6, 0.7, 0.8]
array hue[6] = [0x606060, 0xB07C00, 0xCC79A7, 0x009E73, 0x0072B2, 0xD55E00]
array mark[6] = [4, 6, 13, 9, 5, 7]
do for [k=1:6] {
    set label k sprintf("restitution %g", rest[k]) at graph 1.03, \
        graph 0.17*k - 0.12 left tc rgb hue[k] \
        point pt mark[k] ps 0.7 lc rgb hue[k] offset 1.2,0
}
set label 7 "slope 1" at 1.4e-8,0.14 left tc rgb "#808080"
set arrow 2 from 1e-7,0.6 to 1e-9,6e-3 nohead dt 3 lc rgb "#808080"
plot for [k=1:6] results."/luck_dust.csv" using \
    (is("neighbour ends otherwise") && abs($2 - rest[k]) < 1e-9 && $5 > 0 ? \
     $3 : NaN):5:6 with yerrorbars pt mark[k] ps 0.7 lw 1 lc rgb hue[k], \
    for [k=1:6] results."/luck_dust.csv" using \
    (is("neighbour ends otherwise") && abs($2 - rest[k]) < 1e-9 && $5 > 0 ? \
     $3 : 1/0):5 with lines lw 1.2 lc rgb hue[k]
unset label
unset arrow

set output to."/remembers.svg"
set margins 10, 3, 3.4, 1.5
unset logscale
set logscale x 2
set xrange [1.0/360:1.4]
set yrange [0:1.02]
set format "%g"
set xtics ("1/256" 1.0/256, "1/128" 1.0/128, "1/64" 1.0/64, "1/32" 1.0/32, \
    "1/16" 1.0/16, "1/8" 0.125, "1/4" 0.25, "1/2" 0.5, "a hand" 1)
set xlabel "height and energy, over a hand's"
set ylabel "share that shows the side it began with"
plot 0.5 with lines lw 1 dt 3 lc rgb "#808080", \
    results."/luck_fair.csv" using \
    (is("same side of a gentle hand") ? $2 : NaN):5:(3*$6) \
    with yerrorbars pt 7 ps 0.7 lw 1.2 lc rgb "#0072B2"

# The static rule is h/sqrt(1 + h^2); that of the centre of mass, 1/sqrt(3).
set output to."/three_sided.svg"
set margins 10, 22, 3.4, 1.5
unset logscale
set datafile missing NaN
set xrange [0:0.9]
set yrange [0:0.92]
set xtics 0.1
set xlabel "thickness / diameter"
set ylabel "share that lands on its edge"
array slippery[3] = [0x0072B2, 0x009E73, 0xD55E00]
array loss[2] = ["dry", "angular"]
do for [m=1:3] {
    do for [k=1:2] {
        set label 3*k + m sprintf("friction 0.%d, %s", m, loss[k]) \
            at graph 1.03, graph 1.15 - 0.1*(3*k + m) left tc rgb slippery[m] \
            point pt (k == 1 ? 7 : 6) ps 0.7 lc rgb slippery[m] offset 1.2,0
    }
}
set label 1 "static rule" at 0.14,0.2 right tc rgb "#606060"
set label 2 "a third" at 0.01,0.36 left tc rgb "#808080"
set label 3 "1/sqrt(3)" at 0.57,0.88 right tc rgb "#808080"
set arrow 1 from 0.57735,0 to 0.57735,0.92 nohead dt 3 lc rgb "#808080"
plot x/sqrt(1 + x*x) with lines lw 1.4 lc rgb "#909090", \
    1/3.0 with lines lw 1 dt 3 lc rgb "#808080", \
    for [k=1:2] for [m=1:3] results."/luck_edge.csv" using \
    (is(loss[k]) && abs($3 - m/10.0) < 1e-9 ? $2 : NaN):5:(3*$6) \
    with yerrorbars pt (k == 1 ? 7 : 6) ps 0.5 lw 1.2 lc rgb slippery[m], \
    for [k=1:2] for [m=1:3] results."/luck_edge.csv" using \
    (is(loss[k]) && abs($3 - m/10.0) < 1e-9 ? $2 : NaN):5 \
    with lines lw 1.2 dt k lc rgb slippery[m], \
    results."/luck_edge.csv" using (is("static rule") ? $2 : NaN):5:(3*$6) \
    with yerrorbars pt 4 ps 0.8 lw 1 lc rgb "#606060"
