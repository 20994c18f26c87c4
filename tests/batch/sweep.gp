# SPDX-License-Identifier: MIT
# sweep.png: what sweep.c wrote, with axes.  Its colours keep four bits of
# eight: bands, as on a map, and two fifths less to store.
#     gnuplot -e "from='...'" -e "to='...'" sweep.gp
set terminal pngcairo size 760,760 font "sans,12" background rgb "white"
set output to."/sweep.png"
set size ratio 1
set xrange [-90:90]
set yrange [-180:180]
set xtics 30 out nomirror
set ytics 45 out nomirror
set xlabel "lean at the start [degrees]"
set ylabel "direction of the spin, atan2(wY, wZ) [degrees]"
unset key
set label "falls" at 62,-42 center front tc rgb "white"
set label "rolls on" at 0,0 center front tc rgb "white"
plot from."/sweep.ppm" binary array=(1000,1000) skip=17 flipy \
     format="%uchar%uchar%uchar" origin=(-89.91,-179.82) dx=0.18 dy=0.36 \
     using (int($1) & 240):(int($2) & 240):(int($3) & 240) with rgbimage
