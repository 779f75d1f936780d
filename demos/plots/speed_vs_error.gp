# Time of an evaluation against the error of its force.
#
#   rows   of the demo speed_vs_error (--csv)

height = 900
load 'style.gp'

# The first and the last water, in each the simplest hull and the finest mesh that both know.
sea = ''; flat = ''; hull = ''; triangles = 0; finest = 0
stats rows using (sea = strcol('water'), flat eq '' ? (flat = sea, hull = strcol('hull'), triangles = column('triangles')) : 0) nooutput
stats rows using (strcol('water') eq sea && strcol('hull') eq 'mesh' && column('triangles') > finest ? (finest = column('triangles'), 0) : 0) nooutput

# Families of evaluators: name, colour, point: those of the library, and what games take (open: in float).
array name[9] = ['exact', 'batch', 'batch in float', 'clustered', 'clustered in float', 'closed form in float', 'centroids', 'pontoons', 'voxels']
array colour[9] = [orange, sky, sky, blue, blue, ink, red, purple, green]
array point[9] = [5, 9, 8, 7, 6, 2, 1, 11, 13]

# A logarithmic axis has no zero.
shownError(e) = e > 1e-17 ? e : 1e-17
isOf(w, h, n, i) = strcol('water') eq w && strcol('hull') eq h && column('triangles') == n && strcol('family') eq name[i]

set logscale xy
set format xy '10^{%L}'
set grid
unset key

waters = flat eq sea ? 1 : 2
hulls = finest > 0 ? 2 : 1
do for [row = 1:waters] {
    do for [col = 1:hulls] {
        w = row == 1 ? flat : sea
        h = col == 1 ? hull : 'mesh'
        n = col == 1 ? triangles : finest
        left = col == 1 ? 0.085 : 0.585; right = left + 0.39
        bottom = row == 1 ? 0.61 : 0.165; top = bottom + 0.325
        heading = w
        subheading = h.' of '.sprintf('%.0f', n).' triangles'.(row == 1 ? '' : '; alone: tolerance 0')
        load 'panel.gp'
        if (row == 1) { set xrange [1e-17:1]; set xtics 1e4 } else { set xrange [1e-7:1]; set xtics 10 }
        set xlabel (row < waters ? '' : 'force error / weight of displacement, median')
        if (col == 1) { set ylabel 'time of an evaluation (ns)' } else { set ylabel '' }
        # A tolerance of 0 is not the limit of small ones, and stands alone.
        plot for [i = 1:9] rows using (isOf(w, h, n, i) && strcol('tolerance') ne '0' ? shownError(column('median_force_error')) : NaN):'ns_a_body' with linespoints pt point[i] ps 1.3 lw 2 lc rgb colour[i], \
             for [i = 1:9] rows using (isOf(w, h, n, i) && strcol('tolerance') eq '0' ? shownError(column('median_force_error')) : NaN):'ns_a_body' with points pt point[i] ps 1.3 lw 2 lc rgb colour[i]
    }
}

load 'key.gp'
plot for [i = 1:9] NaN with linespoints pt point[i] ps 1.3 lw 2 lc rgb colour[i] title name[i]
unset multiplot
