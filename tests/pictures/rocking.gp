# SPDX-License-Identifier: MIT
# rocking.svg: a nickel rocks to rest on its edge, from rocking.csv.  Two
# blocks: its lean in time, its rate at each pass.
load style
set datafile separator ","
file = from."/rocking.csv"
set terminal svg size 800,360 font "sans,12" background rgb "white"
set output to."/rocking.svg"
set multiplot

set margins at screen 0.075, screen 0.48, screen 0.15, screen 0.96
set xrange [0:1.5]
set yrange [-6.5:6.5]
set xtics 0.5
set ytics 2
set xlabel "time [s]" offset 0,0.3
set ylabel "lean [degrees]" offset 1,0
array h[1] = [1.95/2/10.605]
edge = atan(h[1])*180/pi
set arrow 1 from 0,edge to 1.5,edge nohead lc rgb "#A0A0A0" dt 3 lw 1.4
set arrow 2 from 0,-edge to 1.5,-edge nohead lc rgb "#A0A0A0" dt 3 lw 1.4
set label 1 "beyond this it falls" at 1.48,5.85 right tc rgb "#606060"
plot file index 0 using 2:3 with lines ls 2
unset arrow
unset label

set margins at screen 0.58, screen 0.98, screen 0.15, screen 0.96
set logscale y
set xrange [0:350]
set yrange [0.02:4]
set xtics 100
set ytics ("3" 3, "1" 1, "0.3" 0.3, "0.1" 0.1, "0.03" 0.03)
set xlabel "pass through upright" offset 0,0.3
set ylabel "rate there [rad/s]" offset 1,0
IX = 0.25 + h[1]**2/3
ratio = (IX + 1 - h[1]**2)/(IX + 1 + h[1]**2)
stats file index 1 every ::0::0 using 3 nooutput
first = STATS_max
stands = h[1]/100*sqrt(9.80665/0.010605)
set arrow 3 from 0,stands to 350,stands nohead lc rgb "#A0A0A0" dt 3 lw 1.4
set label 3 "slower than this it stands" at 5,stands*1.18 left tc rgb "#606060"
set label 4 "Housner's ratio" at 150,0.55 left tc rgb "#606060"
set samples 2
plot first*ratio**x with lines lw 1 lc rgb "#A0A0A0", \
    file index 1 every 12 using (12*$0):3 with points pt 7 ps 0.5 lc rgb colour[3]
unset multiplot
