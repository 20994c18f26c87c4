# SPDX-License-Identifier: MIT
# accuracy.svg and accuracy_rhs.svg: cost against error, a panel per scene.
#     gnuplot -e "from='...'" -e "results='...'" -e "to='...'" accuracy.gp
load results."/../style.gpi"

# What the motion makes of one rounding: amp 1.1e-16 at the end of the scene.
floor_wobble = 43; floor_generic = 83; floor_tumble = 1300
floor_ring = 66; floor_quarter = 73; floor_nearflat = 27

titles = "wobble generic tumble ring quarter nearflat"
set logscale xy
set xrange [4e-21:30]
unset mxtics
unset mytics
set xtics 1e-15,1e3,1 format "10^{%T}" offset 0,0.3
set ytics format "10^{%T}" offset 0.5,0
set margins 7, 0.5, 2, 1.4

do for [measure in "ns slopes"] {
    set terminal svg size 800,1180 font "sans,11" background rgb "white"
    set output to.(measure eq "ns" ? "/accuracy.svg" : "/accuracy_rhs.svg")
    low = measure eq "ns" ? 5e1 : 1
    high = measure eq "ns" ? 1e8 : 1e6
    set yrange [low:high]
    set multiplot layout 3,2
    do for [k=1:6] {
        scene = word(titles, k)
        stem = from."/".measure."_".scene
        edge = value("floor_".scene) * 1.1e-16
        unset label
        unset arrow
        unset object
        set object 1 rectangle from 1e-15,low to edge,high behind \
            fillcolor rgb "#F3F3F3" fillstyle solid noborder
        set object 2 rectangle from 2,low to 30,high behind \
            fillcolor rgb "#FBEFEA" fillstyle solid noborder
        set label 1 "failed" at 7,high*0.5 center font ",10" tc rgb "#804020"
        set label 4 "rounding" at 2e-15,low*1.6 rotate font ",10" \
            tc rgb "#909090"
        set title scene offset 0,-0.7 font ",12"
        set xlabel (k > 4 ? "largest error [rad, radii]" : "") offset 0,0.8
        set ylabel (k % 2 == 0 ? "" : measure eq "ns" ? \
            "CPU ns per natural unit of time" : \
            "right-hand sides per natural unit of time") offset 1.2,0
        # Slopes of orders 4 and 8 over four decades of error.
        foot = low * 1.5
        set arrow 1 from 4e-14,foot*10 to 4e-10,foot nohead lc rgb "#A0A0A0"
        set arrow 2 from 4e-14,foot*10 to 4e-14,foot nohead lc rgb "#A0A0A0"
        set arrow 3 from 4e-14,foot to 4e-10,foot nohead lc rgb "#A0A0A0"
        set arrow 4 from 4e-14,foot*3.162 to 4e-10,foot nohead \
            lc rgb "#A0A0A0"
        set label 2 "order 4" at 1.6e-13,foot*6.5 font ",10" tc rgb "#808080"
        set label 3 "8" at 7e-14,foot*1.7 font ",10" tc rgb "#808080"
        plot for [i=1:11] stem.".dat" index i-1 using 1:2 \
                 with lines ls i, \
             for [i=12:13] stem.".dat" index i-1 using 1:2 \
                 with linespoints ls i, \
             stem.".labels" using (1e-15):1:2:(colour[int($3)]) \
                 with labels right noenhanced font ",10" textcolor rgb variable, \
             stem.".labels" using (1.3e-15):1:($4*0.6-1.3e-15):($5-$1): \
                 (colour[int($3)]) with vectors nohead lw 0.4 dt 3 \
                 lc rgb variable, \
             stem.".failed" using (7):1:(colour[int($2)]) with points pt 2 \
                 ps 0.5 lc rgb variable
    }
    unset multiplot
}
