# SPDX-License-Identifier: MIT
# costs.svg: what a step takes, beside what its arithmetic must take.
#     gnuplot -e "from='...'" -e "results='...'" -e "to='...'" costs.gp
load results."/../style.gpi"
set terminal svg size 800,360 font "sans,12" background rgb "white"
set output to."/costs.svg"
set datafile separator comma
set datafile missing ""
set xlabel "ns per step" offset 0,0.4
set xrange [0:*]
set yrange [7.9:-0.6]
set lmargin 13
set rmargin 3
set border 1
unset ytics
set ytics scale 0
set grid xtics
file = "<grep -v '^#' '".results."/costs.csv' | tail -n +2"
set key bottom right reverse Left samplen 1 spacing 1.2
array style[6] = [1, 2, 3, 4, 5, 6] # the rows' methods, in their colours
of(row) = colour[style[int(row) + 1]]
plot file using 2:0:(of($0)):ytic(1) with points pt 7 ps 0.9 \
         lc rgb variable notitle, \
     '' using 3:($0+0.26):(of($0)) with points pt 2 ps 0.8 lw 1.6 \
         lc rgb variable notitle, \
     '' using 4:($0+0.26):(of($0)) with points pt 6 ps 0.8 lw 1.6 \
         lc rgb variable notitle, \
     NaN with points pt 7 ps 0.9 lc rgb "#404040" title "measured", \
     NaN with points pt 2 ps 0.8 lw 1.6 lc rgb "#404040" \
         title "its longest chain of operations", \
     NaN with points pt 6 ps 0.8 lw 1.6 lc rgb "#404040" \
         title "its operations, two abreast, at the best rate"
