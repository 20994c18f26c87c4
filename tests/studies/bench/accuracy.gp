# SPDX-License-Identifier: MIT
# accuracy.svg and accuracy_rhs.svg: cost against error, a panel per scene;
# speed.svg: a second of a US quarter; frame_loop.svg: a call per frame.
#     gnuplot -e "from='...'" -e "results='...'" -e "to='...'" accuracy.gp
load results."/../style.gpi"

# What the motion makes of one rounding: amp 1.1e-16 at the end of the scene.
floor_wobble = 43; floor_generic = 83; floor_tumble = 1300
floor_ring = 66; floor_quarter = 73; floor_nearflat = 27

# Curves 1 to n of a panel in the lines of style.gpi, marks, labels.
times = "1 2 3 4 15 7 8 12 16 14"
slopes = "1 3 4 7 8 9 10 11"
is_mark(style) = style eq "16" || style eq "14"

# The band of what rounding does, and that of failed runs.
frame(edge, low, high) = sprintf("set object 1 rectangle from graph 0, \
    first %g to %g,%g behind fillcolor rgb '#F3F3F3' fillstyle solid noborder; \
    set object 2 rectangle from 12,%g to graph 1,first %g behind \
    fillcolor rgb '#FBEFEA' fillstyle solid noborder", \
    low, edge, high, low, high)

titles = "wobble generic tumble ring quarter nearflat"
set logscale xy
unset mxtics
unset mytics
do for [measure in "ns slopes"] {
    set terminal svg size 800,1140 font "sans,11" background rgb "white"
    set output to.(measure eq "ns" ? "/accuracy.svg" : "/accuracy_rhs.svg")
    low = measure eq "ns" ? 20 : 2
    high = measure eq "ns" ? 1e8 : 1e6
    lines = measure eq "ns" ? times : slopes
    set xrange [1e-16:1e4]
    set yrange [low:high]
    set xtics 1e-15,1e3,1 format "10^{%T}" offset 0,0.3
    set xtics add ("failed" 300)
    set ytics 1e-9,10 format "10^{%T}" offset 0.5,0
    set multiplot
    do for [k=1:6] {
        scene = word(titles, k)
        stem = from."/".measure."_".scene
        column = (k - 1) % 2
        row = (k - 1) / 2
        set lmargin at screen 0.0725 + 0.5 * column
        set rmargin at screen 0.0725 + 0.5 * column + 335.0 / 800
        set tmargin at screen 0.977 - 0.329 * row
        set bmargin at screen 0.977 - 0.329 * row - 312.0 / 1140
        unset label
        eval(frame(value("floor_".scene) * 1.1e-16, low, high))
        set title scene offset 0,-0.8 font ",12"
        set xlabel (k > 4 ? "largest error [rad, radii]" : "") offset 0,0.6
        set ylabel (k % 2 == 0 ? "" : measure eq "ns" ? \
            "CPU ns per natural unit of time" : \
            "right-hand sides per natural unit of time") offset 1.5,0
        plot for [i=1:words(lines)] stem.".dat" index i-1 using \
                 (is_mark(word(lines, i)) ? NaN : $1):2 \
                 with lines ls int(word(lines, i)), \
             for [i=1:words(lines)] stem.".dat" index i-1 using \
                 (is_mark(word(lines, i)) ? $1 : NaN):2 \
                 with points ls int(word(lines, i)), \
             stem.".failed" using (300):1:(colour[int($2)]) with points pt 2 \
                 ps 0.5 lc rgb variable, \
             stem.".leaders" using 1:2 with lines lw 0.5 lc rgb "#808080", \
             stem.".labels" using 1:2:3:(colour[int($4)]) with labels \
                 center noenhanced font ",11" textcolor rgb variable
    }
    unset multiplot
}

# A second of a quarter.
set terminal svg size 800,520 font "sans,12" background rgb "white"
set output to."/speed.svg"
stem = from."/second"
lines = times
set lmargin at screen 0.095
set rmargin at screen 0.095 + 690.0 / 800
set tmargin at screen 0.985
set bmargin at screen 0.985 - 440.0 / 520
unset label
unset title
unset object 2
set xrange [1e-15:5]
set yrange [1e3:1e9]
set xtics 1e-15,1e3,1 format "10^{%T}" offset 0,0.2
set ytics ("1 us" 1e3, "10 us" 1e4, "100 us" 1e5, "1 ms" 1e6, "10 ms" 1e7, \
    "100 ms" 1e8, "1 s" 1e9)
set object 1 rectangle from 1e-15,1e3 to 73*1.1e-16,1e9 behind \
    fillcolor rgb "#F3F3F3" fillstyle solid noborder
set xlabel "largest error within a second of motion [rad, radii]" offset 0,0.3
set ylabel "computing time for a second of motion" offset 1,0
plot for [i=1:words(lines)] stem.".dat" index i-1 using \
         (is_mark(word(lines, i)) ? NaN : $1):2 with lines \
         ls int(word(lines, i)), \
     for [i=1:words(lines)] stem.".dat" index i-1 using \
         (is_mark(word(lines, i)) ? $1 : NaN):2 with points \
         ls int(word(lines, i)), \
     stem.".leaders" using 1:2 with lines lw 0.5 lc rgb "#808080", \
     stem.".marks" using 1:2:(colour[int($3)]) with points pt 7 ps 0.7 \
         lc rgb variable, \
     stem.".labels" using 1:2:3:(colour[int($4)]) with labels center \
         noenhanced font ",12" textcolor rgb variable

# A call per frame.
set output to."/frame_loop.svg"
set terminal svg size 800,420 font "sans,12" background rgb "white"
unset object 1
set xrange [50:1200]
set xtics (60, 120, 240, 1000) format "%g"
set xlabel "frames per second" offset 0,0.3
set tmargin at screen 0.98
set bmargin at screen 0.98 - 330.0 / 420
set multiplot
do for [column in "ns error"] {
    stem = from."/frame_".column
    lines = system("cat ".stem.".styles")
    left = column eq "ns" ? 0.085 : 0.59
    set lmargin at screen left
    set rmargin at screen left + 310.0 / 800
    if (column eq "ns") {
        set yrange [40:700]
        set ytics (50, 100, 200, 500) format "%g"
        set ylabel "a call [ns]" offset 1,0
    } else {
        set yrange [1e-15:0.1]
        set ytics 1e-15,1e3,1 format "10^{%T}"
        set ylabel "error after a second [rad, radii]" offset 1,0
    }
    plot for [i=1:words(lines)] stem.".dat" index i-1 using 1:2 \
             with linespoints ls int(word(lines, i)) pt 7 ps 0.5, \
         stem.".leaders" using 1:2 with lines lw 0.5 lc rgb "#808080", \
         stem.".labels" using 1:2:3:(colour[int($4)]) with labels center \
             noenhanced font ",12" textcolor rgb variable
}
unset multiplot
