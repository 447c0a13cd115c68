//! Roll-up: a shell built by hand from its parts, marched in time, drawn.
//!
//! A strip is clamped at one end and bent by a couple M at the other. Moment and curvature are uniform, whatever the
//! size of the rotation: the strip lies on a circle, and at M = 2πEI/L its tip meets the clamp.
//!
//! ```text
//! κ = M/EI,   φ = κL,   x(L) = L sin φ/φ,   z(L) = L (1 − cos φ)/φ
//! ```
//!
//! Nothing is solved: a ramp carries the couple up to each level, damping lets the motion die, and what is left is an
//! equilibrium. A [`March`] of a [`QuasiStatic`] plan does that with any system that offers forces, record by record. It passes
//! limit points by itself, where the equilibrium at the next load lies far away.
//!
//! `cargo run --release -p coque --example 3_roll_up` writes `out/3_roll_up/shapes.svg`; before: `2_cantilever`,
//! next: `4_own_load`.

use std::error::Error;
use std::f64::consts::TAU;
use std::fs;

use coque::{Array, Picture, Sheet, picture_svg};
use explicit_dynamics::{Amplitude, Damping, March, QuasiStatic, Record};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{EndWeights, Plate, Side, Vec3, lattice};
use sph_shell::{
    AppliedLoad, Clamped, CoupleAxis, EdgeCouple, Formulation, Parts, Reach, Shell, Supported, SymmetryPlane,
};

/// Length, width and thickness \[cm\]; Young's modulus \[N/cm²\]; ν = 0, so that no edge curls. EI = 100 N cm².
const LENGTH: f64 = 10.0;
const WIDTH: f64 = 1.0;
const THICKNESS: f64 = 1.0;
const YOUNG: f64 = 1200.0;
/// Period of the lowest bending mode, 2π/(3.516 √(EI/ρA) / L²) with ρ = 1 \[s\]: the unit of ramp and hold.
const PERIOD: f64 = 17.9;
/// Distance of the tip from the circle over L. The circle is an exact solution of the shell; 25 particles along it
/// leave 5e-4, four times less for twice as many.
const TOLERANCE: f64 = 1e-3;

fn main() -> Result<(), Box<dyn Error>> {
    let (mut shell, tip) = strip()?;
    let path = QuasiStatic {
        levels: (1..=8).map(|i| f64::from(i) / 8.0).collect(),
        period: Some(PERIOD),
        ramp: 1.0,
        hold: 30.0,
        damping: Damping::Ratio(0.7),
        tolerance: 1e-9,
        accuracy: 5e-3,
        safety: 0.9,
    };
    let mut film = Film { tip, settled: 0, worst: 0.0, shapes: Sheet::default() };
    println!("{:>6} {:>9} {:>9} {:>9} {:>9} {:>9}", "M/M₁", "x/L", "exact", "z/L", "exact", "off");
    let mut march = March::start(path, &mut shell)?;
    while let Some(record) = march.next_record(&mut shell)? {
        film.take(&shell, &record);
    }
    let clock = march.clock();
    println!("{} steps, the last of {:.4} s", clock.steps, clock.dt);

    let title = "A strip rolled into a circle, by eighths of the couple";
    let svg = picture_svg(
        &film.shapes,
        &Picture { field: Some("level"), view: [-70.0, 15.0], ..Picture::new(title) },
    )?;
    fs::create_dir_all("out/3_roll_up")?;
    fs::write("out/3_roll_up/shapes.svg", svg)?;
    println!("out/3_roll_up/shapes.svg");

    if film.settled != 9 {
        return Err(format!("{} of 9 records are at rest; hold longer", film.settled).into());
    }
    if film.worst > TOLERANCE {
        return Err(format!("off by {:.1e} of L, at most {TOLERANCE:.0e} is allowed", film.worst).into());
    }
    Ok(())
}

/// The strip: particles, section, formulation, supports, loads. This is what a scene is turned into. Also the
/// particle in the middle of the loaded edge.
fn strip() -> Result<(Shell, usize), Box<dyn Error>> {
    let cloud = lattice(&Plate { lengths: [LENGTH, WIDTH] }, [25, 3], EndWeights::Trapezoid)?;
    let (Some(sides), Some(rows)) = (&cloud.sides, &cloud.lattice) else {
        return Err("a lattice has sides and rows".into());
    };
    let supported = |particles: &[u32], support| Supported { particles: particles.to_vec(), support };
    let supports = vec![
        supported(sides.edge(Side::U0), Box::new(Clamped)),
        // The free strip buckles sideways under a couple: its middle row is kept in the plane of bending.
        supported(&rows.row(1), Box::new(SymmetryPlane { normal: Vec3::y() })),
    ];
    // The two corners stand for half as much of the edge as the particle between them.
    let edge = sides.edge(Side::U1).iter().copied().zip([0.25, 0.5, 0.25].map(|part| part * WIDTH)).collect();
    let stiffness = YOUNG * WIDTH * THICKNESS.powi(3) / 12.0;
    let tip = sides.edge(Side::U1)[1] as usize;
    let axis = CoupleAxis::Fixed(-Vec3::y());
    let couple = EdgeCouple { edge, moment: TAU * stiffness / LENGTH, axis };
    let shell = Shell::builder(Parts {
        supports,
        loads: vec![AppliedLoad { load: Box::new(couple), amplitude: Amplitude::Constant }],
        section: Box::new(IsotropicSection::new(Isotropic::new(YOUNG, 0.0)?, THICKNESS)?),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation: Formulation::StressPoint(Reach::Cell),
        threads: 1,
        cloud,
    })
    .build()?;
    Ok((shell, tip))
}

/// Compares every record with the circle and keeps all shapes in one sheet.
struct Film {
    tip: usize,
    settled: usize,
    worst: f64,
    shapes: Sheet,
}

impl Film {
    fn take(&mut self, shell: &Shell, record: &Record) {
        let level = record.at.level;
        self.settled += usize::from(record.settled);
        let tip = shell.position(self.tip) / LENGTH;
        let turn = TAU * level.max(1e-9);
        let exact = [libm::sin(turn) / turn, (1.0 - libm::cos(turn)) / turn];
        let off = libm::hypot(tip.x - exact[0], tip.z - exact[1]);
        println!("{level:>6} {:>9.5} {:>9.5} {:>9.5} {:>9.5} {off:>9.1e}", tip.x, exact[0], tip.z, exact[1]);
        self.worst = self.worst.max(off);

        let first = self.shapes.points.len();
        self.shapes.points.extend((0..shell.len()).map(|a| <[f64; 3]>::from(shell.position(a))));
        let cells = &shell.reference().cloud.cells;
        let corners = |cell: &sph_core::Cell| cell.particles().iter().map(|&a| first + a as usize).collect();
        self.shapes.cells.extend(cells.iter().map(corners));
        let levels =
            self.shapes.cell_data.entry("level".into()).or_insert(Array { width: 1, ..Array::default() });
        levels.numbers.extend(cells.iter().map(|_| level));
    }
}
