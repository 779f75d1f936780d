# What a tolerance buys in waves: errors, and what they cost.
#
#   rows   of the demo wave_accuracy (--csv)

height = 780
load 'style.gp'

first = ''; last = ''
stats rows using (last = strcol('sea'), first = first eq '' ? last : first, 0) nooutput
seas = first eq last ? 1 : 2

stats rows using 'us' nooutput
fastest = STATS_min; slowest = STATS_max

array hull[4] = ['box', 'Wigley hull', 'capsule', 'icosphere']
array colour[4] = [orange, blue, green, purple]
array point[4] = [5, 7, 9, 13]
isOf(sea, i) = strcol('sea') eq sea && strcol('hull') eq hull[i]

# A tolerance of 0 has no place on the axis.
tolerance(sea, i) = isOf(sea, i) && column('tolerance') > 0 ? column('tolerance') : NaN
looks = "ps 1.1 lw 2 lc rgb colour[i]"

set logscale xy
set xrange [0.2:5e-6]
set format x '10^{%L}'
unset key
do for [col = 1:seas] {
    sea = col == 1 ? first : last
    left = col == 1 ? 0.095 : 0.57; right = left + 0.38
    set format y '10^{%L}'
    set xlabel ''
    set yrange [1e-7:1]
    set ylabel (col == 1 ? 'error / weight of displacement' : '')
    bottom = 0.61; top = 0.93
    heading = 'Error of the force: largest'
    subheading = sea
    load 'panel.gp'
    set label 3 'tolerance' at 1.5e-1, 3.5e-1 left textcolor rgb ink
    plot x with lines lw 1.5 lc rgb ink, \
         for [i = 1:4] rows using (tolerance(sea, i)):'median_bound' with lines lw 1.5 dt (5, 4) lc rgb colour[i], \
         for [i = 1:4] rows using (tolerance(sea, i)):'largest_error' with linespoints pt point[i] @looks
    unset label 3

    set format y '%g'
    set xlabel 'tolerance / weight of displacement'
    set yrange [10**floor(log10(fastest)):10**ceil(log10(slowest))]
    bottom = 0.155; top = 0.475
    heading = 'Time of an evaluation'
    subheading = ''
    set ylabel (col == 1 ? 'time (μs)' : '')
    load 'panel.gp'
    plot for [i = 1:4] rows using (tolerance(sea, i)):'us' with linespoints pt point[i] @looks
}

load 'key.gp'
set tmargin at screen 0.07
set key maxrows 1
plot for [i = 1:4] NaN with linespoints pt point[i] @looks title hull[i], \
     NaN with lines lw 1.5 dt (5, 4) lc rgb ink title 'bound stated, median'
unset multiplot
