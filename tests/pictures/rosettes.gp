# SPDX-License-Identifier: MIT
# rosettes.svg: the path of the point of contact, from rosettes.csv.
set datafile separator ","
set terminal svg size 800,600 font "sans,13" background rgb "white"
set output to."/rosettes.svg"
set size ratio -1
unset key; unset border; unset tics
set margins 1.2, 1.2, 3, 1
colours = "#0072B2 #D55E00 #009E73 #CC79A7 #E69F00 #56B4E9"
array says[6]
says[1] = "4/7 of a circle each time it nods"
says[2] = "3/8: a hoop, weaving"
says[3] = "9/8: more than once around"
says[4] = "3/5"
says[5] = "4/3, with cusps where it turns on the spot"
says[6] = "a whole circle: it walks away"
set multiplot layout 2,3
do for [k=1:6] {
    set label 1 says[k] at graph 0.5, screen (k < 4 ? 0.525 : 0.025) center
    plot from."/rosettes.csv" index k-1 using 2:3 with lines \
        lw 2 lc rgb word(colours, k)
}
unset multiplot
