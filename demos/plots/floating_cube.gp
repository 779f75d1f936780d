# How a square log and a cube float.
#
#   logs   of the demo floating_cube (--logs)
#   fall   of the cube, likewise (--fall)

height = 960
load 'style.gp'

left = 0.09; right = 0.98

# The sections of some logs on the axis of density ratios, the same scale both ways.
side = 0.09
band = (right - left) * width / (0.145 * height)  # of the axes: width over height of the panel
halfHeight = 0.5 / band
heading = 'How a square log floats (sections, as simulated)'; bottom = 0.82; top = 0.965
load 'panel.gp'
set angles degrees
turnedX(x, y) = r + side * (cos(t) * x - sin(t) * y)
turnedY(x, y) = side * (h + sin(t) * x + cos(t) * y)
do for [i = 1:7] {
    nearest = 9
    stats logs using (abs(column('density_ratio') - (0.11 + 0.13 * (i - 1))) < nearest ? (nearest = abs(column('density_ratio') - (0.11 + 0.13 * (i - 1))), r = column('density_ratio'), t = column('tilt_deg'), h = column('centre_height_sides')) : 0) nooutput
    set object i polygon from turnedX(-0.5, -0.5), turnedY(-0.5, -0.5) to turnedX(0.5, -0.5), turnedY(0.5, -0.5) \
        to turnedX(0.5, 0.5), turnedY(0.5, 0.5) to turnedX(-0.5, 0.5), turnedY(-0.5, 0.5) to turnedX(-0.5, -0.5), turnedY(-0.5, -0.5) \
        fc rgb wood fs transparent solid 0.8 border lc rgb '#6b4a24'
}
set object 8 rectangle from 0, -halfHeight to 1, 0 fc rgb water fs solid noborder behind
set xrange [0:1]
set yrange [-halfHeight:halfHeight]
unset border
unset tics
unset grid
plot 0 with lines lw 1.5 lc rgb blue notitle
unset object

heading = 'Tilt of its face'; bottom = 0.52; top = 0.77
load 'panel.gp'
set border 3
set xtics 0.1 @tics
set ytics 15 @tics
set grid
set yrange [-2:50]
set xlabel 'density of the log / density of the water'
set ylabel 'degrees'
set key bottom center Left reverse
set samples 4000

# Reid (1963), Gilbert (1991).
mirrored(s) = s < 0.5 ? s : 1 - s
wallSided(s) = atan(sqrt(12 * s * (1 - s) - 2))
oneEdgeWet(s) = atan((3 - sqrt(9 - 32 * s)) / (3 + sqrt(9 - 32 * s)))
tiltOf(s) = s <= (3 - sqrt(3)) / 6 ? 0 : s >= 9.0 / 32 ? 45 : s <= 0.25 ? wallSided(s) : oneEdgeWet(s)
plot tiltOf(mirrored(x)) with lines lw 2 lc rgb blue title 'closed form', \
     logs using 'density_ratio':'tilt_deg' with points pt 7 ps 0.7 lc rgb red title 'simulated in Bullet'

heading = 'A cube dropped into water: height of its centre'; bottom = 0.27; top = 0.42
load 'panel.gp'
set xrange [0:15]
set autoscale y
set xtics autofreq @tics
set ytics autofreq @tics
set format x ''
set xlabel ''
set ylabel 'edges'
unset key
plot fall using 'time_s':'centre_height_edges' with lines lw 2 lc rgb blue

heading = 'Its tilt from face up'; bottom = 0.065; top = 0.215
load 'panel.gp'
set yrange [0:60]
set ytics 15 @tics
set format x '%g'
set xlabel 'time (s)'
set ylabel 'degrees'
plot fall using 'time_s':'tilt_deg' with lines lw 2 lc rgb red
unset multiplot
