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
set yrange [7.6:-0.6]
set lmargin 13
set rmargin 3
set border 1
unset ytics
set ytics scale 0
set grid xtics
file = "<grep -v '^#' '".results."/costs.csv' | tail -n +2"
set key at graph 0.98,0.98 right top reverse Left samplen 1 spacing 1.2
plot file using 2:0:ytic(1) with points pt 7 ps 0.9 lc rgb "#0072B2" \
         title "measured", \
     '' using 3:($0+0.26) with points pt 2 ps 0.8 lw 1.6 lc rgb "#D55E00" \
         title "its longest chain of operations", \
     '' using 4:($0+0.26) with points pt 6 ps 0.8 lw 1.6 lc rgb "#009E73" \
         title "its operations, two abreast, at the best rate"
