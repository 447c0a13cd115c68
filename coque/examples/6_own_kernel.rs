//! Own kernel: Wendland's C⁶ function as weight of a wide support, asked what the library asks of its own kernels.
//!
//! A [`Kernel`] is a shape w(q) of q = r/h with a finite support, normalised on the surface:
//!
//! ```text
//! w = 39/(14π) · (1 − u)⁸ (1 + 8u + 25u² + 32u³),   w' = −39/(28π) · 22u (1 − u)⁷ (1 + 7u + 16u²),   u = q/2 < 1
//! ∫ w(q) 2πq dq = 1                                                                        [wendland1995, dehnen2012]
//! ```
//!
//! Nothing else depends on it: the correction makes gradients of linear fields exact whatever the weights are, and the
//! divergence-consistent change balances constant stress. What the kernel decides is how the error of everything else
//! is spread. The last column measures it: a plate on four simple supports under a pressure q sin(πx/a) sin(πy/a) sinks
//! in the middle by `w = q a⁴/(4π⁴D)` (Navier's solution, exact for the thin plate) [timoshenko1959].
//!
//! `cargo run --release -p coque --example 6_own_kernel`; before: `5_own_section`, next: `7_own_body`.

use std::error::Error;
use std::f64::consts::PI;

use explicit_dynamics::Amplitude;
use implicit_statics::{Equilibrium, linear_response};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{
    Cloud, EndWeights, Kernel, Plate, Side, Vec3, jittered_lattice, kernel_operator, kernels, lattice,
    make_divergence_consistent,
};
use sph_shell::{
    AppliedLoad, Force, Formulation, Held, Parts, Reach, Shell, StaticShell, Supported, SymmetryPlane,
};

struct WendlandC6;

impl Kernel for WendlandC6 {
    fn name(&self) -> &'static str {
        "wendland-c6"
    }

    fn describe(&self) -> &'static str {
        "Wendland's C6 kernel, support 2 h"
    }

    fn support(&self) -> f64 {
        2.0
    }

    fn value(&self, q: f64) -> f64 {
        let u = 0.5 * q;
        39.0 / (14.0 * PI) * (1.0 - u).max(0.0).powi(8) * (1.0 + u * (8.0 + u * (25.0 + u * 32.0)))
    }

    fn slope(&self, q: f64) -> f64 {
        let u = 0.5 * q;
        -39.0 / (28.0 * PI) * 22.0 * u * (1.0 - u).max(0.0).powi(7) * (1.0 + u * (7.0 + u * 16.0))
    }
}

/// Reach of the stencils over the distance to the fourth nearest particle: 2.1 spacings on a lattice, twelve particles.
/// Below 2.2 the plate would see the four of a cell alone, and all kernels would agree.
const REACH: f64 = 3.0;

fn main() -> Result<(), Box<dyn Error>> {
    let cloud = jittered_lattice(&Plate { lengths: [2.0, 1.0] }, [17, 9], 0.25, 1)?;
    println!(
        "{:<15}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}",
        "kernel", "∫w − 1", "w'", "∇f", "flux", "changed", "plate"
    );
    let mut wrong = Vec::new();
    for kernel in kernels().into_iter().chain([&WendlandC6 as &'static dyn Kernel]) {
        let mut operator = kernel_operator(&cloud, kernel, REACH)?;
        let report = make_divergence_consistent(&mut operator, &cloud, &[1])?;
        // What, how much, and how much is allowed.
        let row = [
            ("integral", integral(kernel) - 1.0, 1e-9), // Simpson's rule at steps of h/1000
            ("slope", slope(kernel), 1e-8),             // differences over 1e-5: truncation 1e-10 of w'''
            ("gradient", gradient(&operator, &cloud), 1e-12), // round-off
            ("flux", report.residual_before, f64::INFINITY), // before the change; what it is there for
            ("flux, changed", report.residual_after, 1e-9), // where the iteration stops
            ("plate", deflection(kernel)?, 0.015),      // 13 × 13 particles; a cell alone leaves .003
        ];
        print!("{:<15}", kernel.name());
        row.iter().for_each(|(_, off, _)| print!("{off:>9.1e}"));
        println!();
        let missed = row.iter().filter(|(_, off, most)| off.is_nan() || off.abs() > *most);
        wrong.extend(
            missed.map(|(what, off, most)| format!("{}: {what} {off:.1e}, not {most:.0e}", kernel.name())),
        );
    }
    if wrong.is_empty() { Ok(()) } else { Err(wrong.join("; ").into()) }
}

/// `∫ w(q) 2πq dq` by Simpson's rule.
fn integral(kernel: &dyn Kernel) -> f64 {
    let steps = (1000.0 * kernel.support()) as usize;
    let weight = |i: usize| if i == 0 || i == steps { 1.0 } else { [2.0, 4.0][i % 2] };
    let at = |q: f64| kernel.value(q) * 2.0 * PI * q;
    (0..=steps).map(|i| weight(i) * at(i as f64 / 1000.0)).sum::<f64>() / 3000.0
}

/// Largest difference of w' from central differences of w.
fn slope(kernel: &dyn Kernel) -> f64 {
    let step = 1e-5;
    let off = |q: f64| kernel.slope(q) - (kernel.value(q + step) - kernel.value(q - step)) / (2.0 * step);
    (1..100).map(|i| off(0.01 * f64::from(i) * kernel.support()).abs()).fold(0.0, f64::max)
}

/// Root mean square error of the gradient of f = 3x − 2y.
fn gradient(operator: &sph_core::SamplingOperator, cloud: &Cloud) -> f64 {
    let a = Vec3::new(3.0, -2.0, 0.0);
    let field: Vec<f64> = cloud.positions.iter().map(|x| a.dot(x)).collect();
    let errors = operator.gradient(&field).into_iter().zip(&operator.points).map(|(found, point)| {
        (found[0] - a.dot(&point.frame.t1)).powi(2) + (found[1] - a.dot(&point.frame.t2)).powi(2)
    });
    (errors.sum::<f64>() / operator.points.len() as f64).sqrt()
}

/// Relative error of the deflection in the middle of the plate, by a quarter of it from the corner to the middle.
fn deflection(kernel: &'static dyn Kernel) -> Result<f64, Box<dyn Error>> {
    let (young, poisson, thickness) = (1e6, 0.3, 0.01);
    let cloud = lattice(&Plate { lengths: [0.5, 0.5] }, [13, 13], EndWeights::Trapezoid)?;
    let sides = cloud.sides.clone().ok_or("a lattice has sides")?;
    let held = |side, support| Supported { particles: sides.edge(side).to_vec(), support };
    let simple = |along| Box::new(Held { displacement: vec![Vec3::z()], director: Some(along) });
    let share = |(x, area): (&Vec3, &f64)| area * libm::sin(PI * x.x) * libm::sin(PI * x.y);
    let shares: Vec<(u32, f64)> = (0..).zip(cloud.positions.iter().zip(&cloud.areas).map(share)).collect();
    // A pressure of one in the middle: the shares are the forces.
    let force = Force { total: Vec3::z() * shares.iter().map(|share| share.1).sum::<f64>(), shares };
    let shell = Shell::builder(Parts {
        supports: vec![
            held(Side::U0, simple(Vec3::y())),
            held(Side::V0, simple(Vec3::x())),
            held(Side::U1, Box::new(SymmetryPlane { normal: Vec3::x() })),
            held(Side::V1, Box::new(SymmetryPlane { normal: Vec3::y() })),
        ],
        loads: vec![AppliedLoad { load: Box::new(force), amplitude: Amplitude::Constant }],
        section: Box::new(IsotropicSection::new(Isotropic::new(young, poisson)?, thickness)?),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation: Formulation::StressPoint(Reach::Kernel(kernel, REACH)),
        threads: 1,
        cloud,
    })
    .build()?;
    let mut system = StaticShell::new(shell);
    let response = linear_response(&mut system, 0.0)?;
    system.update(&response);
    let middle = sides.corner(Side::U1, Side::V1).ok_or("two sides meet in a corner")?;
    let stiffness = young * thickness.powi(3) / (12.0 * (1.0 - poisson * poisson));
    Ok(system.shell().displacement(middle as usize).z * 4.0 * PI.powi(4) * stiffness - 1.0)
}
