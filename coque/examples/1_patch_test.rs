//! Patch test: what every formulation must do exactly before anything else is worth asking.
//!
//! A sheet of disordered particles is stretched uniformly, `x = F X` with `F = diag(1.3, 0.9)`. Three things follow for
//! any set of particles, however uneven:
//!
//! ```text
//! linear fields have exact gradients      Σ_b G_b f(x_b) = ∇f
//! a constant flux n balances at each b    Σ_p w_p n·G_b = n·r_b        (r_b: edge normal of b, zero inside)
//! and so does the shell that is built     ∂U/∂x_b = F N r_b,   N = C E,   E = (FᵀF − 1)/2
//! ```
//!
//! `r_b` is the outward normal of the edge at particle b times the length of edge that b stands for: inside the sheet
//! forces vanish, along its edges they are the tractions. Large stretch is no obstacle: the last line holds for any F.
//!
//! `cargo run --release -p coque --example 1_patch_test`; next: `2_cantilever`.

use std::error::Error;

use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Plate, Vec3, WendlandC2, jittered_lattice};
use sph_shell::{Formulation, Parts, Reach, Shell};

const YOUNG: f64 = 1000.0;
const POISSON: f64 = 0.3;
const THICKNESS: f64 = 0.1;
/// Stretches along x and y.
const STRETCH: [f64; 2] = [1.3, 0.9];
/// Relative. Divergence-consistent gradients come from an iteration that stops at 1e-9; the rest is round-off.
const TOLERANCE: f64 = 1e-8;

fn main() -> Result<(), Box<dyn Error>> {
    let formulations = [
        Formulation::StressPoint(Reach::Cell),
        Formulation::StressPoint(Reach::Kernel(&WendlandC2, 2.0)),
        Formulation::Nodal { order: 1, smoothing: 1.2, consistent: true, kernel: &WendlandC2 },
    ];
    println!("{:<20} {:>10} {:>10} {:>10}", "formulation", "gradient", "flux", "shell");
    for formulation in formulations {
        let mut shell = sheet(formulation)?;
        let errors = [gradient(&shell), flux(&shell), stretched(&mut shell)];
        let [first, second, third] = errors;
        println!("{:<20} {first:>10.1e} {second:>10.1e} {third:>10.1e}", formulation.method());
        if errors.iter().any(|error| error.is_nan() || *error > TOLERANCE) {
            return Err(
                format!("{}: {errors:?}, at most {TOLERANCE:.0e} is allowed", formulation.method()).into()
            );
        }
    }
    Ok(())
}

/// A free sheet of 2 × 1, its particles displaced at random by up to a quarter of their spacing.
fn sheet(formulation: Formulation) -> Result<Shell, Box<dyn Error>> {
    let section = IsotropicSection::new(Isotropic::new(YOUNG, POISSON)?, THICKNESS)?;
    Ok(Shell::builder(Parts {
        cloud: jittered_lattice(&Plate { lengths: [2.0, 1.0] }, [17, 9], 0.25, 1)?,
        section: Box::new(section),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation,
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 1,
    })
    .build()?)
}

/// Errors of the gradient of f = 3x − 2y over its size.
fn gradient(shell: &Shell) -> f64 {
    let (operator, slope) = (&shell.reference().operator, Vec3::new(3.0, -2.0, 0.0));
    let field: Vec<f64> = shell.reference().cloud.positions.iter().map(|x| slope.dot(x)).collect();
    let errors = operator.gradient(&field).into_iter().zip(&operator.points).map(|(found, point)| {
        libm::hypot(found[0] - slope.dot(&point.frame.t1), found[1] - slope.dot(&point.frame.t2))
    });
    norm(errors) / slope.norm()
}

/// Imbalances of the constant flux n = (1, 2) at the particles over |n| times the spacing.
fn flux(shell: &Shell) -> f64 {
    let (reference, n) = (shell.reference(), Vec3::new(1.0, 2.0, 0.0));
    let at = |frame: &sph_core::Frame| [0.0, n.dot(&frame.t1), n.dot(&frame.t2)];
    let constant: Vec<[f64; 3]> = reference.operator.points.iter().map(|point| at(&point.frame)).collect();
    let sums = reference.operator.gather(&constant);
    let errors = sums.iter().zip(&reference.cloud.edge_normals).map(|(sum, r)| sum - n.dot(r));
    norm(errors) / (n.norm() * reference.cloud.spacing())
}

/// Stretches the shell; differences between its forces and the edge tractions over |N| times the spacing.
fn stretched(shell: &mut Shell) -> f64 {
    let cloud = shell.reference().cloud.clone();
    for (b, x) in cloud.positions.iter().enumerate() {
        shell.set_state(b, Vec3::new(STRETCH[0] * x.x, STRETCH[1] * x.y, 0.0), Vec3::z());
    }
    shell.evaluate_internal(false);
    let c = YOUNG * THICKNESS / (1.0 - POISSON * POISSON);
    let [e11, e22] = STRETCH.map(|s| 0.5 * (s * s - 1.0));
    let force = [c * (e11 + POISSON * e22), c * (e22 + POISSON * e11)];
    let errors = cloud.edge_normals.iter().enumerate().map(|(b, r)| {
        let traction = Vec3::new(STRETCH[0] * force[0] * r.x, STRETCH[1] * force[1] * r.y, 0.0);
        let [x, y, z, ..] = shell.internal_force(b);
        (Vec3::new(x, y, z) - traction).norm()
    });
    norm(errors) / (libm::hypot(force[0], force[1]) * cloud.spacing())
}

/// Root of the sum of squares: no less than the largest.
fn norm(errors: impl Iterator<Item = f64>) -> f64 {
    errors.map(|error| error * error).sum::<f64>().sqrt()
}
