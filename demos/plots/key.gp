# A key in a row of its own at the foot of the picture, for all panels: plot NaN with the titles after it.

unset label
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0
set tmargin at screen 0.1
unset logscale
unset border
unset tics
unset grid
unset xlabel
unset ylabel
set xrange [0:1]
set yrange [0:1]
set key center center horizontal maxrows 3 width 2
