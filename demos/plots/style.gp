# What all plots have in common. Each script begins with it, after it has set `height`.
#
#   picture   the .png or .svg file to draw into
#   height    of it, pixels

width = 900
if (strstrt(picture, '.svg') > 0) {
    set terminal svg size width, height background rgb 'white' font 'Sans,12'
} else {
    set terminal pngcairo size width, height background rgb 'white' font 'Sans,12'
}
set output picture
set encoding utf8
set datafile separator comma
set datafile columnheaders

# Colours that the colour-blind tell apart (Okabe and Ito 2008), and what they stand for.
blue = '#0072b2'; red = '#d55e00'; green = '#009e73'; purple = '#cc79a7'; orange = '#e69f00'; sky = '#56b4e9'
ink = '#222222'; faint = '#dddddd'; water = '#cfe6f5'; wood = '#d9a066'; paint = '#b5483a'

set border 3 lc rgb '#777777'
tics = "nomirror out scale 0.5 textcolor rgb '#222222'"
set tics @tics
set grid lt 1 lw 1 lc rgb faint
set xlabel textcolor rgb ink offset 0, 0.3
set ylabel textcolor rgb ink
set key textcolor rgb ink samplen 2 spacing 1.1 noopaque
subheading = ''
set multiplot
