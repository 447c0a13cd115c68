//! Own load: water in a tank. The library has pressure, but none that grows with the depth; a [`Load`] is three
//! functions: what it adds, how that changes with the motion, and what it refuses.
//!
//! A cylindrical steel tank stands clamped on its base, full to the rim. The water pulls the wall outward by its hoop
//! stiffness, the clamp holds it back, and a boundary layer as thick as 1/β lies between:
//!
//! ```text
//! p = γ (d − y),   β⁴ = 3(1 − ν²)/(R t)²
//! w = γR²/(Et) · { d − y − e^(−βy) [ d cos βy + (d − 1/β) sin βy ] }          [timoshenko1959] §117
//! Σ f = ½ γ d² · 2R sin φ₀ on a wedge of the angle 2φ₀;   about the base  Σ f y = ⅓ d Σ f
//! ```
//!
//! A load that follows the motion reads positions from the state, a dead one from the reference. Here the water stands
//! against the wall where it is now. Marching asks for nothing else. Newton's method and buckling need the derivatives
//! of the load too: without them a ring under pressure buckles at 4 EI/R³ instead of 3.
//!
//! `cargo run --release -p coque --example 4_own_load`; before: `3_roll_up`, next: `5_own_section`.

use std::error::Error;

use explicit_dynamics::Amplitude;
use implicit_statics::{Newton, NewtonOptions};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Cylinder, EndWeights, Side, SpaceError, Vec3, lattice};
use sph_shell::{
    AppliedLoad, Block, Body, Clamped, Formulation, Load, Parts, Reach, Reference, Shell, ShellError,
    StaticShell, Supported, SymmetryPlane, place_block,
};

/// Water at rest on the inner side of a wall, its surface at a height y \[L\]: pressure γ times the depth, along the
/// present normal, on the present area.
struct Water {
    /// Weight per volume γ \[F/L³\].
    weight: f64,
    /// Height of the surface \[L\].
    surface: f64,
}

impl Load for Water {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        let place = |a: u32| Vec3::from_column_slice(&body.state[a as usize][..3]);
        for cell in &body.reference.cloud.cells {
            // Half the product of the diagonals is the area vector; a triangle repeats its last corner.
            let [p, q, r, s] = cell.corners.map(place);
            let area = (r - p).cross(&(s - q)) * 0.5;
            let corners = cell.particles();
            let depth = |a: u32| (self.surface - place(a).y).max(0.0);
            let total: f64 = corners.iter().map(|&a| depth(a)).sum();
            for &a in corners {
                // Two thirds by the mean depth, a third by its own: exact in force and moment where p is linear.
                let share = (2.0 * total / corners.len() as f64 + depth(a)) / (3.0 * corners.len() as f64);
                let force = area * (scale * self.weight * share);
                forces[a as usize][..3].iter_mut().zip(force.iter()).for_each(|(sum, part)| *sum += part);
            }
        }
    }

    /// The product rule on `f_a = A γ share_a`: the area vector A turns with the diagonals, the share with the depths.
    fn stiffness(&self, scale: f64, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
        let place = |a: u32| Vec3::from_column_slice(&body.state[a as usize][..3]);
        for cell in &body.reference.cloud.cells {
            let [p, q, r, s] = cell.corners.map(place);
            let (u, v) = (r - p, s - q);
            let area = u.cross(&v) * (0.5 * scale * self.weight);
            let turn = |d: Vec3| d.cross_matrix() * (0.5 * scale * self.weight);
            let corners = cell.particles();
            let n = corners.len() as f64;
            let depth = |a: u32| (self.surface - place(a).y).max(0.0);
            let total: f64 = corners.iter().map(|&a| depth(a)).sum();
            for &a in corners {
                let share = (2.0 * total / n + depth(a)) / (3.0 * n);
                for (&b, turned) in cell.corners.iter().zip([turn(v), -turn(u), -turn(v), turn(u)]) {
                    put(a, b, &place_block(0, 0, &(turned * share)));
                }
                for &b in corners.iter().filter(|&&b| depth(b) > 0.0) {
                    let sinks = -(2.0 / n + if a == b { 1.0 } else { 0.0 }) / (3.0 * n);
                    put(a, b, &place_block(0, 0, &(area * sinks * Vec3::y().transpose())));
                }
            }
        }
    }

    fn check(&self, reference: &Reference) -> Result<(), ShellError> {
        if reference.cloud.cells.is_empty() {
            return Err(ShellError::EmptySet("water"));
        }
        let refuse = |what, value, bound| Err(SpaceError::OutOfRange { what, value, bound }.into());
        match (self.weight, self.surface) {
            (weight, _) if !(weight > 0.0 && weight.is_finite()) => {
                refuse("weight of water", weight, "(0, ∞)")
            }
            (_, surface) if !surface.is_finite() => refuse("surface of water", surface, "(−∞, ∞)"),
            _ => Ok(()),
        }
    }
}

/// Tank \[m, N\], water, and half the angle of the wedge.
const RADIUS: f64 = 10.0;
const HEIGHT: f64 = 10.0;
const THICKNESS: f64 = 0.02;
const YOUNG: f64 = 2.1e11;
const POISSON: f64 = 0.3;
const WEIGHT: f64 = 9810.0;
const HALF_ANGLE: f64 = 0.01;
/// Of the greatest w. Transverse shear, which the closed form leaves out, counts for β²D/(κGt) = 9e-4: four times finer
/// clouds end at 1.1e-3. The 201 particles, seven to a boundary layer, add as much again at most.
const TOLERANCE: f64 = 3e-3;
/// Of force and moment: straight cells hold the resultant of a linear pressure exactly, round-off is left.
const ROUND_OFF: f64 = 1e-12;

fn main() -> Result<(), Box<dyn Error>> {
    let mut system = StaticShell::new(tank()?);
    let cloud = system.shell().reference().cloud.clone();

    // Before anything moves: does the load say what the integral says?
    system.evaluate(1.0);
    let force = |a: usize| system.shell().external_force(a)[2];
    let total: f64 = (0..cloud.len()).map(force).sum();
    let moment: f64 = (0..cloud.len()).map(|a| force(a) * cloud.positions[a].y).sum();
    let exact = 0.5 * WEIGHT * HEIGHT * HEIGHT * 2.0 * RADIUS * libm::sin(HALF_ANGLE);
    let off = [total / exact - 1.0, moment / (exact * HEIGHT / 3.0) - 1.0];
    println!(
        "force {total:.3} N, exact {exact:.3} N; relative errors of force and moment {:.1e}, {:.1e}",
        off[0], off[1]
    );

    let solved = Newton::new(&system, &NewtonOptions::default())?.at_level(&mut system, 1.0)?;
    println!("{} iterations\n{:>6} {:>9} {:>9}", solved.iterations, "y [m]", "w [mm]", "exact");
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    let middle = cloud.lattice.as_ref().map(|lattice| lattice.column(1));
    for (i, a) in middle.ok_or("a lattice has columns")?.into_iter().enumerate() {
        let (y, w) = (cloud.positions[a as usize].y, system.shell().displacement(a as usize).z);
        if i % 10 == 0 && y < 2.6 {
            println!("{y:>6.2} {:>9.4} {:>9.4}", 1e3 * w, 1e3 * deflection(y));
        }
        worst = worst.max((w - deflection(y)).abs());
        largest = largest.max(deflection(y));
    }
    println!("largest error {:.1e} of the largest w", worst / largest);
    if off.iter().any(|off| off.abs() > ROUND_OFF) || worst > TOLERANCE * largest {
        return Err(format!("at most {ROUND_OFF:.0e} in force, {TOLERANCE:.0e} in w is allowed").into());
    }
    Ok(())
}

/// The wall moves outward by this much at a height \[m\].
fn deflection(y: f64) -> f64 {
    let beta = libm::pow(3.0 * (1.0 - POISSON * POISSON), 0.25) / (RADIUS * THICKNESS).sqrt();
    let (sin, cos) = libm::sincos(beta * y);
    let held = libm::exp(-beta * y) * (HEIGHT * cos + (HEIGHT - 1.0 / beta) * sin);
    WEIGHT * RADIUS * RADIUS / (YOUNG * THICKNESS) * (HEIGHT - y - held)
}

/// A wedge of the tank between two planes of symmetry: every other one moves alike.
fn tank() -> Result<Shell, Box<dyn Error>> {
    let patch = Cylinder { radius: RADIUS, angles: [-HALF_ANGLE, HALF_ANGLE], length: HEIGHT };
    let cloud = lattice(&patch, [3, 201], EndWeights::Trapezoid)?;
    let sides = cloud.sides.clone().ok_or("a lattice has sides")?;
    let plane = |side, angle: f64| {
        let normal = Vec3::new(libm::cos(angle), 0.0, -libm::sin(angle));
        Supported { particles: sides.edge(side).to_vec(), support: Box::new(SymmetryPlane { normal }) }
    };
    let base = Supported { particles: sides.edge(Side::V0).to_vec(), support: Box::new(Clamped) };
    let water = Water { weight: WEIGHT, surface: HEIGHT };
    Ok(Shell::builder(Parts {
        supports: vec![base, plane(Side::U0, -HALF_ANGLE), plane(Side::U1, HALF_ANGLE)],
        loads: vec![AppliedLoad { load: Box::new(water), amplitude: Amplitude::Constant }],
        section: Box::new(IsotropicSection::new(Isotropic::new(YOUNG, POISSON)?, THICKNESS)?),
        strain: &StretchCorrected,
        material_axis: None,
        density: 7850.0,
        formulation: Formulation::StressPoint(Reach::Cell),
        threads: 1,
        cloud,
    })
    .build()?)
}
