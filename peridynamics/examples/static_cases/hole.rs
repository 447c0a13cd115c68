//! A plate with a round hole in tension: plane stress, the displacements of Kirsch's solution on an outer layer one horizon
//! deep, a square of ten radii.
//!
//! ```text
//! u_x = Sa/(8μ) [ (r/a)(κ+1) cos θ + (2a/r)((1+κ) cos θ + cos 3θ) − (2a³/r³) cos 3θ ]      κ = (3 − ν)/(1 + ν)
//! u_y = Sa/(8μ) [ (r/a)(κ−3) sin θ + (2a/r)((1−κ) sin θ + sin 3θ) − (2a³/r³) sin 3θ ]              [timoshenko1951]
//! ```

use std::error::Error;
use std::f64::consts::FRAC_PI_2;

use implicit_statics::{Equilibrium, linear_response};
use peridynamics::{Correction, Elastic, Law, Space};
use sph_core::{CutOut, Vec3};

use crate::blocks::{formulation, lattice, moved, nodes, parts, system};

const YOUNG: f64 = 200e9;
const RADIUS: f64 = 1.0;
/// Remote stress over E.
const STRAIN: f64 = 1e-6;

/// How far the plate is from Kirsch's solution.
#[derive(Clone, Copy, Debug)]
pub struct Holed {
    /// L2 error of the displacement beyond one horizon from the hole.
    pub displacement: f64,
    /// Hoop strain at the nodes nearest to the top of the hole, over that of the solution there.
    pub strain: f64,
    /// Where that was read, over the radius.
    pub at: f64,
}

/// The plate with so many spacings a radius.
///
/// # Errors
/// A body or a system that is refused.
pub fn holed(
    law: Law,
    correction: Correction,
    horizon: f64,
    resolution: usize,
) -> Result<Holed, Box<dyn Error>> {
    let dx = RADIUS / resolution as f64;
    let poisson = if law == Law::BondBased { 1.0 / 3.0 } else { 0.3 };
    let material = Elastic { young: YOUNG, poisson, density: 7850.0 };
    let (side, delta) = (10.0 * RADIUS, horizon * dx);
    let corner = Vec3::new(-0.5 * side, -0.5 * side, 0.0);
    let disc = CutOut::Ball { centre: Vec3::zeros(), radius: RADIUS };
    let block = lattice(2, corner, [side, side, 1.0], dx).block()?.without(&[disc]);
    let outer = nodes(&block, |x| x.x.abs().max(x.y.abs()) > 0.5 * side - delta);
    let mut formulation = formulation(Space::PlaneStress, law, correction);
    formulation.horizon = horizon;
    let mut parts = parts(block.clone(), material, formulation);
    for &node in &outer {
        let u = kirsch(&block.positions[node as usize], poisson);
        for axis in [Vec3::x(), Vec3::y()] {
            parts.supports.push(moved(vec![node], axis, u.dot(&axis)));
        }
    }
    let mut system = system(parts)?;
    let answer = linear_response(&mut system, 0.0)?;
    system.update(&answer);
    system.evaluate(1.0);
    let u = |node: usize| system.solid().displacement(node);
    let (mut error, mut size) = (0.0, 0.0);
    for (node, x) in block.positions.iter().enumerate() {
        if x.norm() > RADIUS + delta && x.x.abs().max(x.y.abs()) <= 0.5 * side - delta {
            let exact = kirsch(x, poisson);
            error += (u(node) - exact).norm_squared();
            size += exact.norm_squared();
        }
    }
    let first = block.positions.iter().filter(|x| x.x.abs() < 0.6 * dx && x.y > 0.0);
    let y = first.fold(f64::INFINITY, |least, x| least.min(x.y));
    let pair = nodes(&block, |x| x.x.abs() < 0.6 * dx && (x.y - y).abs() < 0.1 * dx);
    let [left, right] = pair[..] else { return Err("the hole lies between two columns".into()) };
    let [left, right] = [left as usize, right as usize];
    let [from, to] = [&block.positions[left], &block.positions[right]];
    let strain = (u(right) - u(left)).x / (kirsch(to, poisson) - kirsch(from, poisson)).x;
    Ok(Holed { displacement: (error / size).sqrt(), strain, at: y / RADIUS })
}

/// Kirsch's displacement of the plate under tension along x.
fn kirsch(x: &Vec3, poisson: f64) -> Vec3 {
    let (a, r) = (RADIUS, x.norm());
    let t = if x.x == 0.0 { FRAC_PI_2.copysign(x.y) } else { x.y.atan2(x.x) };
    let kappa = (3.0 - poisson) / (1.0 + poisson);
    let mu = YOUNG / (2.0 * (1.0 + poisson));
    let scale = STRAIN * YOUNG * a / (8.0 * mu);
    let (near, far, third) = (2.0 * a / r, r / a, 2.0 * (a / r).powi(3));
    let ux = far * (kappa + 1.0) * t.cos() + near * ((1.0 + kappa) * t.cos() + (3.0 * t).cos());
    let uy = far * (kappa - 3.0) * t.sin() + near * ((1.0 - kappa) * t.sin() + (3.0 * t).sin());
    Vec3::new(ux - third * (3.0 * t).cos(), uy - third * (3.0 * t).sin(), 0.0) * scale
}
