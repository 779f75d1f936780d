# Begins a panel of the picture: `heading` and `subheading` above it, and `left`, `right`, `bottom` and `top` as
# shares of the picture.

set lmargin at screen left
set rmargin at screen right
set bmargin at screen bottom
set tmargin at screen top
set label 1 '{/:Bold '.heading.'}' at graph 0, 1 left offset 0, (subheading eq '' ? 0.9 : 2) textcolor rgb ink
set label 2 subheading at graph 0, 1 left offset 0, 0.8 textcolor rgb ink
