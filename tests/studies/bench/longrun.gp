# SPDX-License-Identifier: MIT
# longrun_energy.svg, longrun_integrals.svg, longrun_phase.svg, damping.svg.
#     gnuplot -e "from='...'" -e "results='...'" -e "to='...'" longrun.gp
load results."/../style.gpi"
set terminal svg size 800,480 font "sans,12" background rgb "white"

# The methods of the runs, in the order of the CSV, as lines of style.gpi.
array line[8] = [2, 2, 3, 3, 4, 4, 5, 6]
array still[6] = [2, 2, 2, 3, 5, 6]

set logscale xy
set format "10^{%T}"
set xlabel "time [natural units]" offset 0,0.4
set lmargin 8
set rmargin 1
set xrange [40:5e8]
set xtics 1e2,10,1e7

# Dashed guides through (100, y).
guide(t, y, power) = y * (t / 100.0)**power
set style line 20 lc rgb "#B0B0B0" dt 2 lw 1

do for [name in "energy integrals phase"] {
    set output to."/longrun_".name.".svg"
    unset label
    if (name eq "energy") {
        set yrange [1e-18:1]
        set ylabel "|energy error|, relative" offset 1.5,0
    }
    if (name eq "integrals") {
        set yrange [1e-18:1]
        set ylabel "error of KY or KZ, the larger, relative" offset 1.5,0
    }
    if (name eq "phase") {
        set yrange [1e-16:1e5]
        set ylabel "error of the nutation's phase [rad]" offset 1.5,0
    }
    first = name eq "phase" ? 1e-15 : 1e-17
    low = name eq "phase" ? 1 : 0.5
    high = name eq "phase" ? 2 : 1
    set label 1 (low == 1 ? "t" : "sqrt(t)") at 2e5,guide(2e5, first, low)*0.4 \
        tc rgb "#909090"
    set label 2 (high == 2 ? "t^2" : "t") at 2e4,guide(2e4, first, high)*0.2 \
        tc rgb "#909090"
    plot sample [50:1e7] '+' using 1:(guide($1, first, low)) \
            with lines ls 20, \
        [50:1e7] '+' using 1:(guide($1, first, high)) with lines ls 20, \
        for [i=1:8] from."/".name.".dat" index i-1 using 1:2 \
            with lines ls line[i], \
        from."/".name.".labels" using 1:2:3:(colour[int($4)]) \
            with labels left font ",11" textcolor rgb variable
}

# The nutation that a coarse RK4 damps.
set output to."/damping.svg"
unset label
set xrange [10:2e7]
set xtics 10,10,1e6
unset logscale y
set yrange [0:0.7]
set ytics 0.2 format "%.1f"
set ylabel "swing of the lean, largest less least [rad]" offset 0,0
set label "method, step" at 1.3e6,0.67 left font ",11" tc rgb "#606060"
plot for [i=1:6] from."/damping.dat" index i-1 using 1:2 \
        with lines ls still[i], \
    from."/damping.labels" using 1:2:3:(colour[int($4)]) \
        with labels left font ",11" textcolor rgb variable
