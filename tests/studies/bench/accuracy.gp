# SPDX-License-Identifier: MIT
# accuracy.svg: cost against error, a panel per scene and one for engines;
# speed.svg: a second of a US quarter; frame_loop.svg: a call per frame;
# engine_frames.svg: a frame beside physics engines.
#     gnuplot -e "from='...'" -e "results='...'" -e "to='...'" accuracy.gp
load results."/../style.gpi"

# What the motion makes of one rounding: amp 1.1e-16 at the end of the scene.
floor_wobble = 43; floor_generic = 83; floor_tumble = 1300
floor_ring = 66; floor_quarter = 73; floor_nearflat = 27; floor_engines = 73

# Curves of a panel in the lines of style.gpi, and its labels.
is_mark(style) = style eq "14"
curves = "for [i=1:words(lines)] stem.'.dat' index i-1 using \
        (is_mark(word(lines, i)) ? NaN : $1):2 with lines \
        ls int(word(lines, i)) notitle, \
    for [i=1:words(lines)] stem.'.dat' index i-1 using \
        (is_mark(word(lines, i)) ? $1 : NaN):2 with points \
        ls int(word(lines, i)) notitle"
labels(stem, side) = ", '".stem.".labels' using 1:2:3:(colour[int($4)]) \
    with labels ".side." noenhanced textcolor rgb variable notitle"

key = ", keyentry with lines ls 1 title 'the textbook''s RK4', \
    keyentry with lines ls 2 title 'rk4', \
    keyentry with lines ls 3 title 'rk8', \
    keyentry with lines ls 4 title 'coin_advance', \
    keyentry with points ls 14 title 'an orbit, solved and asked', \
    keyentry with lines ls 7 title 'the best other solver', \
    keyentry with lines ls 8 title 'others with our equations', \
    keyentry with lines lw 12 lc rgb '#E8E8E8' \
        title 'what the motion makes of one rounding'"

# The band of what rounding does.
band(edge) = sprintf("set object 1 rectangle from graph 0,0 to first %g, \
    graph 1 behind fillcolor rgb '#F3F3F3' fillstyle solid noborder", edge)

set logscale xy
unset mxtics
unset mytics
set terminal svg size 960,1560 font "sans,12" background rgb "white"
set output to."/accuracy.svg"
set xrange [1e-15:1]
set yrange [20:1e7]
set xtics 1e-15,1e3,1 format "10^{%T}" offset 0,0.3
set ytics 1e-9,10 format "10^{%T}" offset 0.5,0
set multiplot
panels = "wobble generic tumble ring quarter nearflat engines"
do for [k=1:7] {
    scene = word(panels, k)
    stem = from."/ns_".scene
    lines = system("cat ".stem.".styles")
    column = (k - 1) % 2
    row = (k - 1) / 2
    set lmargin at screen 0.065 + 0.5 * column
    set rmargin at screen 0.065 + 0.5 * column + 400.0 / 960
    set tmargin at screen 0.98 - 0.247 * row
    set bmargin at screen 0.98 - 0.247 * row - 330.0 / 1560
    eval(band(value("floor_".scene) * 1.1e-16))
    set title (k == 7 ? "quarter, beside engines" : scene) offset 0,-0.8
    set xlabel (k > 5 ? "largest error [rad, radii]" : "") offset 0,0.6
    set ylabel (k % 2 == 0 ? "" : "CPU ns per natural unit of time") offset 1,0
    # The key stands in the place of the eighth panel.
    if (k == 7) {
        set key at screen 0.6,0.17 left top Left reverse samplen 3 \
            spacing 1.5 font ",13" noenhanced
    }
    eval("plot ".curves.(k == 7 ? labels(stem, "center").key : ""))
}
unset multiplot
unset key

# A second of a quarter.  Its text has 11 pixels on a phone.
set terminal svg size 480,520 font "sans,15" background rgb "white"
set output to."/speed.svg"
stem = from."/second"
lines = system("cat ".stem.".styles")
set lmargin at screen 0.22
set rmargin at screen 0.97
set tmargin at screen 0.935
set bmargin at screen 0.215
set title "one core of an AMD EPYC, gcc -O2" offset 0,-0.6
set xrange [1e-14:1]
set yrange [1e3:1e9]
set xtics 1e-12,1e4,1 format "10^{%T}" offset 0,0.2
set ytics ("1 µs" 1e3, "10 µs" 1e4, "100 µs" 1e5, "1 ms" 1e6, "10 ms" 1e7, \
    "100 ms" 1e8, "1 s" 1e9)
unset object 1
set xlabel "largest error within it [rad, radii]\n{/*0.93 grey: \
the best of GSL, Boost, CVODE and heyoka;}\n{/*0.93 brown: \
the better of MuJoCo and ODE}" offset -2,0.3
set ylabel "time for a second of motion" offset 2,0
python = from."/python"
eval("plot ".curves.labels(stem, "left").", for [i=1:2] python.'.dat' \
    index i-1 with points pt 7 ps 0.9 lc rgb colour[i == 1 ? 7 : 4] notitle". \
    labels(python, "left offset 0.8,0"))

# A call per frame.
set output to."/frame_loop.svg"
set terminal svg size 800,440 font "sans,12" background rgb "white"
set xrange [50:7000]
set xtics (60, 120, 240, 1000) format "%g"
set xlabel "frames per second" offset 0,0.3
set tmargin at screen 0.93
set bmargin at screen 0.93 - 330.0 / 440
set multiplot
do for [column in "ns error"] {
    stem = from."/frame_".column
    lines = system("cat ".stem.".styles")
    left = column eq "ns" ? 0.085 : 0.59
    set lmargin at screen left
    set rmargin at screen left + 310.0 / 800
    if (column eq "ns") {
        set yrange [40:3000]
        set ytics (50, 100, 200, 500, 1000, 2000) format "%g"
        set ylabel "a call [ns]" offset 1,0
        set title "A call per frame takes less than a microsecond"
    } else {
        set yrange [1e-15:0.1]
        set ytics 1e-15,1e3,1 format "10^{%T}"
        set ylabel "error after a second [rad, radii]" offset 1,0
        set title "Calls with a tolerance of 1e-6 keep it"
        set label "a step of order 4 now\nsuffices, and is cheaper" \
            at 900,3e-10 left font ",11" textcolor rgb colour[4]
    }
    eval("plot for [i=1:words(lines)] stem.'.dat' index i-1 using 1:2 \
        with linespoints ls int(word(lines, i)) pt 7 ps 0.5 notitle". \
        labels(stem, "left"))
}
unset multiplot

# A frame beside engines.
set output to."/engine_frames.svg"
set terminal svg size 900,440 font "sans,12" background rgb "white"
set xrange [1e-12:1000]
set xtics 1e-12,1e3,1e3 format "10^{%T}"
set yrange [400:3e6]
set ytics ("1 us" 1e3, "10 us" 1e4, "100 us" 1e5, "1 ms" 1e6, "10 ms" 1e7)
set tmargin at screen 0.92
set bmargin at screen 0.92 - 345.0 / 440
set multiplot
do for [scene in "quarter disk"] {
    stem = from."/engines_".scene
    lines = system("cat ".stem.".styles")
    left = scene eq "quarter" ? 0.085 : 0.575
    set lmargin at screen left
    set rmargin at screen left + 360.0 / 900
    if (scene eq "quarter") {
        set title "a US quarter rolls for a second" offset 0,-0.7
        set xlabel "largest error of its path [radii]" offset 0,0.3
        set ylabel "a frame of 1/60 s" offset 1,0
    } else {
        set title "Euler's disk spins for ten seconds" offset 0,-0.7
        set xlabel "largest error of its energy, as a part of it" offset 0,0.3
        unset ylabel
    }
    eval("plot for [i=1:words(lines)] stem.'.dat' index i-1 using 1:2 \
        with linespoints ls int(word(lines, i)) ps 0.6 notitle". \
        labels(stem, "center"))
}
unset multiplot
