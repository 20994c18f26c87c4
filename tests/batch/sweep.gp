# SPDX-License-Identifier: MIT
# sweep.png: what sweep.c wrote, with axes and the scales of its colours, in
# bands, as on a map.
#     gnuplot -e "from='...'" -e "to='...'" sweep.gp
# The lower half of the directions; at the others, -wY and -wZ, the motion is
# the same.
# Ink that is read on a light and on a dark ground.
ink = "#777777"
set terminal png notruecolor nocrop transparent size 600,450 \
    font "DejaVuSans,9"
set output to."/sweep.png"

# The scales of sweep.c, in thirds: red, green and blue of either.
falls = "60 150 213 255 10 50 94 210 0 0 0 170"
rolls = "10 0 86 245 20 114 180 240 70 178 233 170"
third(x) = x < 0.9999 ? int(3 * x) : 2
knot(row, i, k) = real(word(row, 4 * i + k + 1))
mix(row, i, k, x) = knot(row, i, k) \
    + (3 * x - k) * (knot(row, i, k + 1) - knot(row, i, k))
channel(row, i, x) = int(mix(row, i, third(x), x))

# From a colour back to its place on the scale, by a channel that rises all the
# way, and the middle of the band that holds it.
bands = 12.
from_knots(row, i, k, c) = \
    (k + (c - knot(row, i, k)) / (knot(row, i, k + 1) - knot(row, i, k))) / 3
place(row, i, c) = from_knots(row, i, \
    c < knot(row, i, 1) ? 0 : c < knot(row, i, 2) ? 1 : 2, c)
band(x) = (floor(bands * (x < 0.9999 ? x : 0.9999)) + 0.5) / bands
fell(r, b) = r > b
paint(i, r, g, b) = fell(r, b) ? channel(falls, i, band(place(falls, 0, r))) \
                               : channel(rolls, i, band(place(rolls, 1, g)))
rgb(row, x) = 65536 * channel(row, 0, x) + 256 * channel(row, 1, x) \
              + channel(row, 2, x)

set border lc rgb ink
set tics textcolor rgb ink
set multiplot
set lmargin at screen 0.09
set rmargin at screen 0.84
set bmargin at screen 0.1
set tmargin at screen 0.97
set xrange [-90:90]
set yrange [-90:90]
set xtics 30 out nomirror
set ytics 30 out nomirror
set xlabel "lean at the start [degrees]" textcolor rgb ink
set ylabel "spin, atan2(wY, wZ) [degrees]" offset 1,0 textcolor rgb ink
unset key
set label "falls" at 62,-42 center front tc rgb "white"
set label "rolls on" at 0,0 center front tc rgb "white"
plot from."/sweep.ppm" binary array=(1000,1000) skip=17 flipy \
     format="%uchar%uchar%uchar" origin=(-89.91,-179.82) dx=0.18 dy=0.36 \
     using (paint(0, $1, $2, $3)):(paint(1, $1, $2, $3)): \
           (paint(2, $1, $2, $3)) with rgbimage

# A call of sweep.c is 0.6 units, and its 40 calls go by the root.
unset label
unset xlabel
unset xtics
set lmargin at screen 0.86
set rmargin at screen 0.88
set xrange [0:1]
unset ytics
set yrange [0:1]
do for [k=1:2] {
    set bmargin at screen (k == 1 ? 0.58 : 0.1)
    set tmargin at screen (k == 1 ? 0.97 : 0.49)
    set ylabel ""
    if (k == 1) {
        set y2tics ("0" 0, "1" sqrt(1./24), "3" sqrt(3./24), \
                    "6" sqrt(6./24), "12" sqrt(12./24), "24" 1)
        set y2label "falls after [units of time]" offset 0.8,0 textcolor rgb ink
    } else {
        set y2tics ("0" 0, "45" 0.25, "90" 0.5, "135" 0.75, "180" 1)
        set y2label "rolls on: swing of the lean [degrees]" offset 0.8,0 textcolor rgb ink
    }
    set y2range [0:1]
    plot sample [i=0:bands-1:1] '+' using (0.5):((i + 0.5) / bands):(0.5): \
         (0.5 / bands):(rgb(k == 1 ? falls : rolls, (i + 0.5) / bands)) \
         with boxxyerror fillstyle solid noborder linecolor rgb variable
}
unset border lc rgb ink
set tics textcolor rgb ink
set multiplot
