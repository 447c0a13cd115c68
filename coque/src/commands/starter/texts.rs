//! The words of the scenes that questions lead to, in metres, newtons and seconds; marks stand where units matter.

use super::shells::{BOLTED, BUCKLED, CLAMPED, CYLINDER, HINGED, MESH, PANEL, PLATE, PUSHED, SQUEEZED};
use super::{Asked, What};

pub fn title(what: What, asked: Asked) -> &'static str {
    match (what, asked) {
        (What::Plate, Asked::Modes) => "A clamped plate: frequencies and modes",
        (What::Plate, Asked::Buckling) => "A plate pushed along its length: buckling loads",
        (What::Plate, Asked::Motion) => "A clamped plate under a sudden pressure",
        (What::Plate, _) => "A clamped plate under pressure",
        (What::Panel, Asked::Modes) => "A hinged panel: frequencies and modes",
        (What::Panel, Asked::Motion) => "A hinged panel under a sudden force at its crown",
        (What::Panel, Asked::LimitLoad) => "A hinged panel pushed at its crown until it snaps through",
        (What::Panel, _) => "A hinged panel under a force at its crown",
        (What::Cylinder, Asked::Modes) => "A tube: frequencies and modes",
        (What::Cylinder, Asked::Buckling) => "A tube under pressure from outside: buckling loads",
        (What::Cylinder, Asked::Motion) => "A tube under a sudden pressure from outside",
        (What::Cylinder, _) => "A tube under pressure from outside",
        (What::Mesh, Asked::Modes) => "A bracket from a mesh: frequencies and modes",
        (What::Mesh, Asked::Motion) => "A bracket from a mesh under a sudden pressure",
        (What::Mesh, _) => "A bracket from a mesh under pressure",
        (What::Bonds, Asked::Equilibrium) => "A plate of bonds, pulled",
        (What::Bonds, Asked::Modes) => "A plate of bonds: frequencies and modes",
        (What::Bonds, _) => "A glass plate with a notch, pulled until it breaks",
        (What::Fluid, _) => "A column of water breaks down in a tank",
        (What::Galerkin, Asked::Modes) => "A thick beam: frequencies and modes",
        (What::Galerkin, _) => "A thick beam under a load on its upper face",
    }
}

/// Geometry, material and section.
pub fn body(what: What, asked: Asked) -> &'static str {
    match what {
        What::Plate if asked == Asked::Buckling => BUCKLED,
        What::Plate => PLATE,
        What::Panel => PANEL,
        What::Cylinder => CYLINDER,
        What::Mesh => MESH,
        What::Bonds if asked == Asked::Motion => GLASS,
        What::Bonds => BONDS,
        What::Fluid => FLUID,
        What::Galerkin => GALERKIN,
    }
}

/// Supports, loads and what is measured.
pub fn conditions(what: What, asked: Asked) -> &'static str {
    match what {
        What::Plate if asked == Asked::Buckling => PUSHED,
        What::Plate => CLAMPED,
        What::Panel => HINGED,
        What::Cylinder => SQUEEZED,
        What::Mesh => BOLTED,
        What::Bonds if asked == Asked::Motion => NOTCHED,
        What::Bonds => PULLED,
        What::Fluid => GAUGES,
        What::Galerkin => LOADED,
    }
}

pub fn analysis(what: What, asked: Asked) -> &'static str {
    match (what, asked) {
        (_, Asked::Modes) => MODES,
        (_, Asked::Buckling) => BUCKLING,
        (_, Asked::LimitLoad) => PATH,
        (What::Panel, Asked::Motion) => {
            "# In time, from rest.\n[analysis.explicit.transient]\nduration = 0.05\nrecord_every = 0.0005\n"
        }
        (What::Cylinder | What::Mesh, Asked::Motion) => {
            "# In time, from rest.\n[analysis.explicit.transient]\nduration = 0.002\nrecord_every = 2e-5\n"
        }
        (What::Bonds, Asked::Motion) => {
            "# In time, from rest.\n[analysis.explicit.transient]\nduration = 5e-5\nrecord_every = 1e-6\n"
        }
        (What::Fluid, Asked::Motion) => {
            "# In time, from rest.\n[analysis.explicit.transient]\nduration = 0.4\nrecord_every = 0.01\n"
        }
        (_, Asked::Motion) => {
            "# In time, from rest.\n[analysis.explicit.transient]\nduration = 0.02\nrecord_every = 0.0002\n"
        }
        (_, Asked::Equilibrium) => LEVELS,
    }
}

const GLASS: &str = "\
[bodies.glass.solid]
geometry.block = { lengths = [L(0.1), L(0.04)], spacing = L(0.001) }
material.elastic = { young = P(7.2e10), poisson = 0.3333, density = D(2440.0) }
formulation.bond-based = { horizon = 3.015, plane = \"stress\", correction = \"none\" }
fracture.energy = G(135.0)
cracks = [{ from = [0.0, L(0.02)], to = [L(0.05), L(0.02)] }]
unbreakable = [\"lower\", \"upper\"]

# Where loads enter nothing breaks: layers as deep as the horizon.
[sets]
lower = { layer = { face = \"y0\", depth = L(0.003015) } }
upper = { layer = { face = \"y1\", depth = L(0.003015) } }
";

const NOTCHED: &str = "\
[[loads]]
on = \"y0\"
traction = { value = [0.0, P(-12e6), 0.0] }

[[loads]]
on = \"y1\"
traction = { value = [0.0, P(12e6), 0.0] }

[[curve]]
name = \"broken\"   # energy of the cracks, by a unit of thickness
of = \"fracture-energy\"
on = \"all\"
";

const BONDS: &str = "\
[bodies.plate.solid]
geometry.block = { lengths = [L(0.1), L(0.04)], spacing = L(0.002) }
material.elastic = { young = P(7.2e10), poisson = 0.3333, density = D(2440.0) }
formulation.bond-based = { plane = \"stress\" }
";

const PULLED: &str = "\
[[supports]]
on = \"x0\"
clamped = {}

[[loads]]
on = \"x1\"
traction = { value = [P(1e6), 0.0, 0.0] }

[[curve]]
name = \"u\"
of = \"displacement\"
on = \"x1\"
direction = [1.0, 0.0, 0.0]
";

const FLUID: &str = "\
[bodies.water.fluid]
geometry.block = { lengths = [L(0.146), L(0.292)], spacing = L(0.0073) }
material.liquid = { density = D(1000.0), sound_speed = L(34.0) }   # ten times 2√(gH)

[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0], max = [L(0.584), L(0.5)], open = [\"y1\"] }

[sets]
gauge = { of = \"tank\", nearest = [L(0.584), L(0.01), 0.0] }
";

const GAUGES: &str = "\
[[loads]]
on = \"all\"
gravity = { acceleration = [0.0, L(-9.81), 0.0] }

[[curve]]
name = \"front\"
of = \"position\"
on = \"water.all\"
take = \"max\"
direction = [1.0, 0.0, 0.0]

[[curve]]
name = \"p\"
of = \"pressure\"
on = \"gauge\"
";

const GALERKIN: &str = "\
[bodies.beam.solid]
geometry.block = { lengths = [L(0.25), L(0.025), L(0.025)], spacing = L(0.0125) }   # 21 × 3 × 3 nodes
material.elastic = { young = P(2.1e11), poisson = 0.3, density = D(7850.0) }
formulation.galerkin = { basis = \"quadratic\", support.ellipsoid = 2.5 }

[sets]
tip = { nearest = [L(0.25), L(0.0125), L(0.0125)] }   # on the axis
";

const LOADED: &str = "\
[[supports]]
on = \"x0\"
clamped = {}

[[loads]]
on = \"z1\"
traction = { value = [0.0, 0.0, P(-1e6)] }

[[curve]]
name = \"w\"
of = \"displacement\"
on = \"tip\"
direction = [0.0, 0.0, -1.0]
";

const LEVELS: &str = "\
# At rest under a fifth of the load, two fifths, …; large displacements are counted. [analysis.linear] is quicker.
[analysis.static]
levels = 5
";

const PATH: &str = "\
# Along the path of equilibria, through the limit and beyond it.
[analysis.arc-length]
stop = { column = \"w\", above = L(0.03) }
";

const MODES: &str = "\
[analysis.modal]
modes = 6
";

const BUCKLING: &str = "\
# Levels are multiples of the loads above.
[analysis.buckling]
modes = 2
";
