# What is measured in the hard cases over its limit, as most engines float bodies and by the library.
#
#   scores   of the demo hard_cases (--csv)

# Cases are gathered by what their group's name begins with, in the order of the table.
set datafile separator comma
set datafile columnheaders
upTo(s, mark) = strstrt(s, mark) > 0 ? s[1:strstrt(s, mark) - 1] : s
family(group) = upTo(upTo(upTo(group, '/ratio'), '/1/'), ',')
array families[100]
count = 0
rowOf(f) = count == 0 ? 0 : sum [k = 1:count] (families[k] eq f ? k : 0)
stats scores using (f = family(strcol('group')), rowOf(f) > 0 ? 0 : (count = count + 1, families[count] = f, 0)) nooutput

array all[count]
array peersFail[count]
array oursFail[count]
do for [k = 1:count] {
    n = 0; peers = 0; ours = 0
    stats scores using (rowOf(family(strcol('group'))) == k ? (n = n + 1, peers = peers + 1 - column('peers_pass'), ours = ours + 1 - column('ours_pass'), 0) : 0) nooutput
    all[k] = n; peersFail[k] = peers; oursFail[k] = ours
}

height = 120 + 21 * count
load 'style.gp'

left = 0.265; right = 0.76; bottom = 62.0 / height; top = 1 - 58.0 / height
heading = 'What is measured, over its limit: right of 1 it fails'
subheading = ' '
load 'panel.gp'
least = 1e-6; most = 1e12
shown(value) = value < least ? least : value < most ? value : most
isNumber(text) = strstrt(text, 'nan') == 0 && strstrt(text, 'inf') == 0
over(side) = column('limit') == 0 ? NaN : isNumber(strcol(side)) ? shown(column(side) / column('limit')) : most
set logscale x
set xrange [least / 3:most * 3]
set yrange [count + 0.6:0.4]
set xtics @tics ('≤ 10^{-6}' least, '10^{-3}' 1e-3, '1' 1, '10^3' 1e3, '10^6' 1e6, '10^9' 1e9, '≥ 10^{12}' most)
set xlabel 'measured / limit'
set ytics @tics (families[1] 1)
set for [k = 2:count] ytics add (families[k] k)
set key at graph 0, 1 left bottom horizontal Left reverse
set arrow 1 from 1, graph 0 to 1, graph 1 nohead lw 2 lc rgb ink back

# Conditions, whose limit is 0, are not drawn, but counted with the rest.
set label 3 '{/:Bold Fail}' at graph 1.06, 1 left offset 0, 2 textcolor rgb ink
set label 4 'impulses' at graph 1.2, 1 right offset 0, 0.8 textcolor rgb red
set label 5 'library' at graph 1.35, 1 right offset 0, 0.8 textcolor rgb blue
set for [k = 1:count] label 10 * k sprintf('%.0f', peersFail[k]) at graph 1.2, first k right textcolor rgb red
set for [k = 1:count] label 10 * k + 1 sprintf('%.0f', oursFail[k]) at graph 1.35, first k right textcolor rgb blue
set for [k = 1:count] label 10 * k + 2 sprintf('of %.0f', all[k]) at graph 1.37, first k left textcolor rgb '#666666'
plot scores using (over('peers')):(rowOf(family(strcol('group'))) - 0.16) with points pt 6 ps 0.8 lc rgb red title 'bare impulses', \
     scores using (over('ours')):(rowOf(family(strcol('group'))) + 0.16) with points pt 7 ps 0.7 lc rgb blue title 'the library'
unset multiplot
