# SPDX-License-Identifier: MIT
# batch.svg: the time of a batch of 64 coins over that of a loop, against the
# length of a step, for 64 steps in a call and for one.
#     gnuplot -e "results='...'" -e "to='...'" batch.gp
load results."/../style.gpi"
set terminal svg size 800,420 font "sans,12" background rgb "white"
set output to."/batch.svg"
set multiplot
set logscale x
set xrange [0.018:1.1]
set yrange [0:1.2]
set xtics (0.02, 0.05, 0.1, 0.2, 0.5, 1)
set ytics 0.2
set xlabel "abs(dt) W where the coins start" offset 0,0.5
rows(build, coins, method, steps) = sprintf( \
    "<grep '^%s,%s,%s,%d,' '%s/batch.csv' | tr , ' '", \
    build, coins, method, steps, results)
array shown[2] = ["portable", "native"]
array flags[2] = ["gcc -O2", "gcc -O3 -march=native"]
do for [i = 1:2] {
    build = shown[i]
    left = i == 1 ? 0.085 : 0.565
    unset label
    set title build.": ".flags[i] noenhanced offset 0,-0.4
    set lmargin at screen left
    set rmargin at screen left + 324.0 / 800
    set tmargin at screen 0.9
    set bmargin at screen 0.34
    set ylabel i == 1 ? "time of a batch / time of a loop" : "" offset 1.2,0
    set label "a loop of coin\\_run()" at graph 0.02, first 1.06 font ",11" \
        textcolor rgb "#606060"
    if (i == 1) {
        set key at screen 0.53, 0.1 center vertical maxrows 2 Left reverse \
            samplen 3 width -8 font ",11" noenhanced
    } else {
        unset key
    }
    plot 1 with lines lw 1.2 dt 2 lc rgb "#606060" notitle, \
         for [k = 2:3] rows(build, "quarter", "rk".(4 * k - 4), 64) \
             using 5:($7 / $6) with linespoints ls k \
             title sprintf("rk%d, quarters, 64 steps", 4 * k - 4), \
         for [k = 2:3] rows(build, "quarter", "rk".(4 * k - 4), 1) \
             using 5:($7 / $6) with linespoints ls k lw 1.1 dt 3 \
             title sprintf("rk%d, quarters, 1 step", 4 * k - 4), \
         for [k = 2:3] rows(build, "any", "rk".(4 * k - 4), 64) \
             using 5:($7 / $6) with linespoints ls k lw 1.1 dt 2 \
             title sprintf("rk%d, coins of any kind, 64 steps", 4 * k - 4)
}
unset multiplot
