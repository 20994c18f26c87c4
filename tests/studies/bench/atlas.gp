# SPDX-License-Identifier: MIT
# limits_FAMILY.svg: what becomes of each scene under each step or tolerance.
#     gnuplot -e "from='...'" -e "results='...'" -e "to='...'" atlas.gp
load results."/../style.gpi"
set terminal svg size 900,520 font "sans,12" background rgb "white"

array method[10] = ["rk4", "rk8", "symplectic2", "symplectic4", \
    "textbook RK4", "odeint rkf78 fixed", "coin_advance", "GSL rk8pd", \
    "odeint rkf78", "odeint dopri5"]
array outcome[6] = ["right", "place wrong, energy right", "energy lost", \
    "energy gained", "through the table, or no number", "refused"]
# Each stands out from a light and from a dark ground: scheme.py leaves it.  Eyes
# that see no red or no green tell right from every kind of wrong.
array shade[6] = ["#8CC5EA", "#F0E442", "#E8902C", "#8B68D2", "#DC4A50", \
    "#7A8490"]

# Of each family: what it is, what is across, the ends of that, the least step,
# and places to be marked: across, or steps.
families = "roll ring quarter pass"
array title[4] = [ \
    "Rolling upright at wZ, disturbed by 1e-3: falls below 0.577", \
    "A hoop, set going at every lean", \
    "A US quarter, leaning 0.3 rad, turning 5 rad/s, at every speed", \
    "Dropped from 0.3 rad with hardly any spin: near-flat passes"]
array across[4] = ["wZ", "lean at the start [rad]", "speed [m/s]", "closest approach [rad]"]
array left[4] = [0.02, -0.025, 0.01857, 3.758e-2]
array right[4] = [1.3, 1.575, 2.154, 0.812e-13]
array least[4] = [0.0091, 0.0091, 0.0091, 1e-4]
array marks[4] = ["0.577", "", "", ""]
rates = "60 240 1000" # of frames, at which the quarter's steps are marked
natural = 0.03517     # its unit of time [s]

set border 15 lc rgb "#808080" lw 0.6
set tics front scale 0.4 textcolor rgb "#404040"
set label 1 "" font ",12" center
unset grid
do for [f=1:4] {
    family = word(families, f)
    set output to."/limits_".family.".svg"
    set multiplot
    unset label
    unset object
    unset logscale
    set xtics 0.5,0.5,1 format "%g"
    set logscale y
    if (f > 2) {
        set logscale x
        if (f == 3) { set xtics (0.1, 1) }
        if (f == 4) { set xtics (1e-4, 1e-8, 1e-12) }
        set format x "10^{%T}"
    }
    set xrange [left[f]:right[f]]
    do for [m=1:10] {
        row = m > 6
        slot = row ? m - 7 : m - 1
        x0 = 0.075 + slot * 0.1455 + (slot > (row ? 0 : 3) ? 0.012 : 0)
        set lmargin at screen x0
        set rmargin at screen x0 + 0.1355
        set tmargin at screen (row ? 0.445 : 0.88)
        set bmargin at screen (row ? 0.115 : 0.55)
        if (row) { set yrange [0.56e-12:1.78e-2] } \
        else { set yrange [least[f]:3.48] }
        set ytics 1e-12,(row ? 1e2 : 10),10
        set format y (slot == 0 ? "10^{%T}" : "")
        set ylabel (slot > 0 ? "" : row ? "tolerance" : \
            "step [natural units]") offset 1.2,0
        set title method[m] noenhanced offset 0,-0.8 font ",11" \
            textcolor rgb (m < 5 || m == 7 ? "#000000" : "#606060")
        unset arrow
        do for [k=1:words(marks[f])] {
            set arrow from first word(marks[f], k),graph 0 \
                to first word(marks[f], k),graph 1 nohead front \
                dt 2 lw 0.8 lc rgb "#FFFFFF"
        }
        do for [k=1:(f == 3 && !row ? 3 : 0)] {
            h = 1.0 / word(rates, k) / natural
            set arrow from graph 0,first h to graph 1,first h nohead front \
                dt 2 lw 0.8 lc rgb "#FFFFFF"
            if (m == 6) {
                set label word(rates, k)."/s" at graph 1.03,first h font ",10"
            }
        }
        # All of its cells have one colour.
        if (m == 7) {
            set label "right at every tolerance" at graph 0.5,screen 0.035 \
                center font ",11"
        }
        # The first panel draws what belongs to all.
        if (m == 1) {
            set label title[f] at screen 0.075,0.965 font ",14"
            set label across[f] at screen 0.361,0.035 center font ",12"
            set label across[f] at screen 0.809,0.485 center font ",12"
            do for [k=1:7] {
                y = 0.43 - k * 0.042
                set object k rectangle from screen 0.69,y-0.014 \
                    to screen 0.725,y+0.014 fillstyle solid noborder \
                    fillcolor rgb shade[k < 7 ? k : 1]
                set label (k < 7 ? outcome[k] : "warned: COIN_COARSE") \
                    at screen 0.735,y noenhanced font ",11"
            }
            set object 8 rectangle from screen 0.69,y-0.014 \
                to screen 0.725,y+0.014 fillcolor rgb "#FFFFFF" \
                fillstyle transparent pattern 2 noborder
        }
        file = from."/atlas_".family."_".system("echo '".method[m]. \
            "' | tr ' ' _").".dat"
        plot for [k=1:6] file index k-1 with filledcurves closed \
                 fillcolor rgb shade[k] fillstyle solid 1 noborder, \
             file index 6 with filledcurves closed \
                 fillcolor rgb "#FFFFFF" fillstyle transparent pattern 2 \
                 noborder
        unset label
        unset object
    }
    unset multiplot
}
