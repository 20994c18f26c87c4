# SPDX-License-Identifier: MIT
# batch.svg: coins times steps per second among many, beside the limits.
#     gnuplot -e "from='...'" -e "results='...'" -e "to='...'" batch.gp
load results."/../style.gpi"
set terminal svg size 800,420 font "sans,12" background rgb "white"
set output to."/batch.svg"
set multiplot
set logscale xy
set xrange [1:1e6]
set yrange [4:220]
set format x "10^{%T}"
set ytics (5, 10, 20, 50, 100, 200)
set xlabel "coins" offset 0,0.5
set bmargin 3.2
set tmargin 2.6
rows(build, way) = sprintf( \
    "<grep '^%s,%s,' '%s/batch.csv' | cut -d, -f3-", build, way, results)
# What all operations of a step take at the best rate [million per second].
operations(method) = real(system(sprintf( \
    "awk -F, '$1 == \"%s\" {print $6 + $7 + $8}' '%s/costs.csv'", \
    method, results)))
best(build) = real(system(sprintf( \
    "awk -F, '$1 == \"%s\" && $2 == \"operation at best\" {print 1e3 / $4}' \
    '%s/batch.csv'", build, results)))
lanes(build) = int(system(sprintf( \
    "awk -F, '$1 == \"%s\" && $2 == \"operation at best\" {print $3}' \
    '%s/batch.csv'", build, results)))
say(text, x, y, which) = sprintf("set label '%s' at %g,%g tc rgb '#%06x'", \
    text, x, y, which)
set datafile separator comma
array shown[2] = ["portable", "native"]
do for [i = 1:2] {
    build = shown[i]
    unset label
    set title sprintf("%s: %d doubles or %d floats abreast", build, \
        lanes(build), 2 * lanes(build)) offset 0,-0.4
    set lmargin at screen i == 1 ? 0.085 : 0.565
    set rmargin at screen i == 1 ? 0.49 : 0.97
    set ylabel i == 1 ? "million steps of a coin per second" : "" offset 1.2,0
    rk4 = best(build) / operations("rk4")
    rk8 = best(build) / operations("rk8")
    eval(say("rk4 abreast", i == 1 ? 30 : 1e3, i == 1 ? 39 : 98, colour[2]))
    eval(say("rk4 alone", 3e3, 31, colour[2]))
    eval(say("rk8 abreast", 3e4, rk8 * (i == 1 ? 0.73 : 0.6), colour[3]))
    eval(say("rk8 alone", i == 1 ? 1.5 : 200, i == 1 ? 5.9 : 9.2, colour[3]))
    eval(say("textbook", i == 1 ? 2e3 : 1.4e5, i == 1 ? 8.3 : 5.5, colour[1]))
    eval(say(i == 1 ? "rk4 of floats, alone" : "floats", \
        i == 1 ? 1.5 : 1.4e5, i == 1 ? 14 : 6.9, colour[4]))
    eval(say("rk4 of floats", i == 1 ? 2e4 : 1e3, i == 1 ? 39 : 78, \
        colour[4]))
    eval(say("all operations at the best rate", 1.5, rk4 * 1.12, 0x606060))
    plot rk4 with lines dt 3 lw 1.2 lc rgb colour[2], \
         rk8 with lines dt 3 lw 1.2 lc rgb colour[3], \
         rows(build, "textbook rk4") using 1:3 with linespoints ls 1, \
         rows(build, "rk4 alone") using 1:3 with linespoints ls 2 lw 1.1, \
         rows(build, "rk4 abreast") using 1:3 with linespoints ls 2, \
         rows(build, "rk8 alone") using 1:3 with linespoints ls 3 lw 1.1, \
         rows(build, "rk8 abreast") using 1:3 with linespoints ls 3, \
         rows(build, "rk4 of floats") using 1:3 with linespoints ls 4 lw 1.1, \
         rows(build, "rk4 of floats abreast") using 1:3 with linespoints ls 4
}
unset multiplot
