# SPDX-License-Identifier: MIT
# batch.svg: coins times steps per second among many, beside the limits.
#     gnuplot -e "from='...'" -e "results='...'" -e "to='...'" batch.gp
load results."/../style.gpi"
set terminal svg size 800,420 font "sans,12" background rgb "white"
set output to."/batch.svg"
set multiplot
set logscale xy
set xrange [1:1e6]
set yrange [4:500]
set format x "10^{%T}"
set ytics (5, 10, 20, 50, 100, 200, 500)
set xlabel "coins" offset 0,0.5
rows(build, way) = sprintf( \
    "<grep '^%s,%s,' '%s/batch.csv' | cut -d, -f3- | tr , ' '", build, way, results)
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
array shown[2] = ["portable", "native"]
do for [i = 1:2] {
    build = shown[i]
    unset label
    set title sprintf("%s: %d coins abreast", build, lanes(build)) \
        offset 0,-0.4
    set lmargin at screen i == 1 ? 0.085 : 0.565
    set rmargin at screen (i == 1 ? 0.085 : 0.565) + 324.0 / 800
    set tmargin at screen 0.9
    set bmargin at screen 0.9 - 320.0 / 420
    set ylabel i == 1 ? "million steps of a coin per second" : "" offset 1.2,0
    rk4 = best(build) / operations("rk4")
    rk8 = best(build) / operations("rk8")
    plot rk4 with lines dt 3 lw 1.2 lc rgb colour[2], \
         rk8 with lines dt 3 lw 1.2 lc rgb colour[3], \
         rows(build, "textbook rk4") using 1:3 with linespoints ls 1, \
         rows(build, "rk4 alone") using 1:3 with linespoints ls 2 lw 1.1, \
         rows(build, "rk4 abreast") using 1:3 with linespoints ls 2, \
         rows(build, "rk8 alone") using 1:3 with linespoints ls 3 lw 1.1, \
         rows(build, "rk8 abreast") using 1:3 with linespoints ls 3, \
         from."/batch_".build.".leaders" using 1:2 with lines lw 0.5 \
             lc rgb "#808080", \
         from."/batch_".build.".labels" using 1:2:3:(colour[int($4)]) \
             with labels center noenhanced font ",11" textcolor rgb variable
}
unset multiplot
