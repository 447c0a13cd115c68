//! Bodies, supports and loads of the shells that questions lead to, in metres, newtons and seconds.

pub(super) const PLATE: &str = "\
[geometry.plate]
lengths = [L(1.0), L(1.0)]   # along x (edges u0, u1) and y (v0, v1)
particles = [21, 21]

[material.elastic]   # steel
young = P(2.1e11)
poisson = 0.3
density = D(7850.0)

[section.homogeneous]
thickness = L(0.01)

[sets]
centre = { nearest = [L(0.5), L(0.5), 0.0] }
";

pub(super) const CLAMPED: &str = "\
[[supports]]
on = \"u0\"
clamped = {}

[[supports]]
on = \"u1\"
clamped = {}

[[supports]]
on = \"v0\"
clamped = {}

[[supports]]
on = \"v1\"
clamped = {}

[[loads]]
on = \"all\"
pressure = { value = P(2000.0) }

[[curve]]   # a column of the results
name = \"w\"
of = \"displacement\"
on = \"centre\"
direction = [0.0, 0.0, 1.0]
";

pub(super) const BUCKLED: &str = "\
[geometry.plate]
lengths = [L(0.3), L(0.2)]
particles = [31, 21]

[material.elastic]   # aluminium
young = P(6.9e10)
poisson = 0.33
density = D(2700.0)

[section.homogeneous]
thickness = L(0.002)
";

pub(super) const PUSHED: &str = "\
[[supports]]
on = \"u0\"   # against a wall, free to spread along it
held = { displacement = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], director = [[0.0, 1.0, 0.0]] }

[[supports]]
on = \"u1\"
held = { displacement = [[0.0, 0.0, 1.0]], director = [[0.0, 1.0, 0.0]] }

[[supports]]
on = \"v0\"
held = { displacement = [[0.0, 0.0, 1.0]], director = [[1.0, 0.0, 0.0]] }

[[supports]]
on = \"v1\"
held = { displacement = [[0.0, 0.0, 1.0]], director = [[1.0, 0.0, 0.0]] }

[[supports]]
on = \"u0v0\"   # against sliding along the wall
held = { displacement = [[0.0, 1.0, 0.0]] }

[[loads]]   # buckling levels are multiples of it
on = \"u1\"
force = { total = [-1000.0, 0.0, 0.0] }
";

pub(super) const PANEL: &str = "\
[geometry.cylinder]   # about the y axis, its crown at +z
radius = L(2.54)
angles = [-5.729577951308232, 5.729577951308232]   # ± 0.1 rad
length = L(0.508)
particles = [21, 21]

[material.elastic]
young = P(3.10275e9)
poisson = 0.3
density = D(1200.0)

[section.homogeneous]
thickness = L(0.0127)

[sets]
crown = { nearest = [0.0, L(0.254), L(2.54)] }
";

pub(super) const HINGED: &str = "\
[[supports]]
on = \"u0\"
hinged = {}

[[supports]]
on = \"u1\"
hinged = {}

[[loads]]
on = \"crown\"
force = { total = [0.0, 0.0, -1000.0] }

[[curve]]
name = \"w\"
of = \"displacement\"
on = \"crown\"
direction = [0.0, 0.0, -1.0]
";

pub(super) const CYLINDER: &str = "\
[geometry.cylinder]   # a quarter of the tube, by symmetry: half round, half long
radius = L(0.1)
angles = [0.0, 180.0]
length = L(0.125)
particles = [49, 21]

[material.elastic]   # steel
young = P(2.1e11)
poisson = 0.3
density = D(7850.0)

[section.homogeneous]
thickness = L(0.001)

[sets]
side = { nearest = [L(0.1), L(0.125), 0.0] }
";

pub(super) const SQUEEZED: &str = "\
[[supports]]
on = \"u0\"
symmetry = { normal = [1.0, 0.0, 0.0] }

[[supports]]
on = \"u1\"
symmetry = { normal = [1.0, 0.0, 0.0] }

[[supports]]   # an end that stays round
on = \"v0\"
diaphragm = { axis = [0.0, 1.0, 0.0] }

[[supports]]   # the middle of the tube
on = \"v1\"
symmetry = { normal = [0.0, 1.0, 0.0] }

[[loads]]
on = \"all\"
pressure = { value = P(-1e5), follower = true }

[[curve]]
name = \"u\"
of = \"displacement\"
on = \"side\"
direction = [-1.0, 0.0, 0.0]
";

pub(super) const MESH: &str = "\
[geometry.mesh]
file = \"flanged-bracket.msh\"   # put your own here; `coque mesh FILE` prints its sets, and what is wrong with it
scale = L(0.001)               # lengths of the file are in mm

[material.elastic]   # steel
young = P(2.1e11)
poisson = 0.3
density = D(7850.0)

[section.homogeneous]
thickness = L(0.002)

[sets]
tip = { nearest = [L(-0.03), L(0.04), L(0.12)] }
";

pub(super) const BOLTED: &str = "\
[[supports]]
on = \"bolted\"   # a set of the file
clamped = {}

[[loads]]
on = \"upright\"
pressure = { value = P(1000.0) }   # along the normals

[[curve]]
name = \"u\"
of = \"displacement\"
on = \"tip\"
direction = [1.0, 0.0, 0.0]
";
