# A boat in a sea: how it lies in the highest waves, its motions about that time, and their spectra.
#
#   series    of the demo boat_in_waves (--csv)
#   spectra   likewise (--spectra)
#   moments   likewise (--moments)

height = 970
load 'style.gp'

left = 0.095; right = 0.98

# To scale, one moment below the other.
stats moments using (strcol('part') eq 'hull' ? column('ahead_m') : NaN) nooutput
length = STATS_max - STATS_min
stats moments using (strcol('part') eq 'water' ? column('ahead_m') : NaN) nooutput
reach = STATS_max
stats moments using 'time_s' nooutput
crest = STATS_min; period = 4 * (STATS_max - STATS_min) / 3
rowHeight = 0.5 * length
share = (right - left) * width * 3.95 * rowHeight / (2 * reach) / height
heading = 'In the highest waves, a quarter of a period apart; to scale, bow to the right'; top = 0.972; bottom = top - share
load 'panel.gp'
isOf(part, i) = strcol('part') eq part && column('moment') == i
aheadOf(part, i) = isOf(part, i) ? column('ahead_m') : NaN
heightIn(i) = column('height_m') - i * rowHeight
set xrange [-reach:reach]
set yrange [-3.5 * rowHeight:0.45 * rowHeight]
unset border
unset tics
unset grid
unset key
plot for [i = 0:3] moments using (aheadOf('hull', i)):(heightIn(i)) with filledcurves closed fc rgb wood fs solid border lc rgb '#6b4a24', \
     for [i = 0:3] moments using (aheadOf('bottom', i)):(heightIn(i)) with filledcurves closed fc rgb paint fs solid noborder, \
     for [i = 0:3] moments using (aheadOf('water', i)):(heightIn(i)):(-(i + 0.5) * rowHeight) with filledcurves fc rgb '#8ec4e8' fs transparent solid 0.5 noborder, \
     for [i = 0:3] moments using (aheadOf('water', i)):(heightIn(i)) with lines lw 2 lc rgb blue

# Few marks on the axes of low panels.
decade(most) = most > 0 ? 10**floor(log10(most)) : 1
marks(most) = most > 5 * decade(most) ? 5 * decade(most) : most > 2 * decade(most) ? 2 * decade(most) : decade(most)
set border 3
set xtics autofreq @tics
set grid
set autoscale y
stats series using 'time_s' nooutput
start = crest - 4 * period > STATS_min ? crest - 4 * period : STATS_min
set xrange [start:start + 8 * period]
set key at graph 1, 1 right bottom horizontal
heading = 'Water at the probe, and heave'; bottom = 0.545; top = 0.685
load 'panel.gp'
set format x ''
set ylabel 'm'
stats series using (abs(column('elevation_m'))) nooutput
set ytics marks(STATS_max) @tics
plot series using 'time_s':'elevation_m' every 5 with lines lw 2 lc rgb blue title 'water', \
     series using 'time_s':'heave_m' every 5 with lines lw 2 lc rgb red title 'heave'

heading = 'Slope of the water along the boat, pitch (bow up), roll'; bottom = 0.355; top = 0.495
load 'panel.gp'
set format x '%g'
set xlabel 'time (s)'
set ylabel 'degrees'
stats series using (abs(column('roll_deg')) > abs(column('pitch_deg')) ? abs(column('roll_deg')) : abs(column('pitch_deg'))) nooutput
set ytics marks(STATS_max) @tics
plot series using 'time_s':'slope_deg' every 5 with lines lw 2 lc rgb blue title 'slope', \
     series using 'time_s':'pitch_deg' every 5 with lines lw 2 lc rgb red title 'pitch', \
     series using 'time_s':'roll_deg' every 5 with lines lw 2 lc rgb green title 'roll'

# Of a regular wave no spectrum was asked for.
set xrange [0:3 / period]
set yrange [0:*]
set ytics autofreq @tics
set key at graph 1, 1 right top vertical
set xlabel 'frequency (Hz)'
heading = 'Spectra of water and heave'; right = 0.49; bottom = 0.062; top = 0.272
load 'panel.gp'
set ylabel 'm^2/Hz'
stats spectra using 'asked_m2_per_hz' nooutput
asked = STATS_max > 0
plot for [i = 1:asked] spectra using 'frequency_hz':'asked_m2_per_hz' with filledcurves y1=0 fc rgb water title 'water, asked for', \
     spectra using 'frequency_hz':'elevation_m2_per_hz' with lines lw 2 lc rgb blue title 'water', \
     spectra using 'frequency_hz':'heave_m2_per_hz' with lines lw 2 lc rgb red title 'heave'

heading = 'Spectra of pitch and roll'; left = 0.6; right = 0.98
load 'panel.gp'
set ylabel 'degrees^2/Hz'
plot spectra using 'frequency_hz':'pitch_deg2_per_hz' with lines lw 2 lc rgb red title 'pitch', \
     spectra using 'frequency_hz':'roll_deg2_per_hz' with lines lw 2 lc rgb green title 'roll'
unset multiplot
