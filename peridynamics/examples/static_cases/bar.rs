//! A bar in tension: 1 × 0.1 × 0.1 m, E = 200 GPa, 2 MN; three layers beyond one end are held, the load acts on the last
//! layer at the other.

use std::error::Error;

use implicit_statics::{Equilibrium, linear_response};
use peridynamics::{Correction, Elastic, Influence, Law, Space};
use sph_core::Vec3;

use crate::blocks::{formulation, held, lattice, nodes, parts, pulled, system};

const YOUNG: f64 = 200e9;
const FORCE: f64 = 2e6;
const LENGTH: f64 = 1.0;
const WIDTH: f64 = 0.1;

/// What the bar does, over what a rod does.
#[derive(Clone, Copy, Debug)]
pub struct Stretched {
    /// Displacement of the last layer over `F l/(EA)`.
    pub tip: f64,
    /// Mean strain of the middle fifth over `F/(EA)`.
    pub gauge: f64,
    /// Lateral over axial strain there.
    pub poisson: f64,
}

/// The bar with so many nodes across.
///
/// # Errors
/// A body or a system that is refused.
pub fn stretched(law: Law, correction: Correction, across: usize) -> Result<Stretched, Box<dyn Error>> {
    let dx = WIDTH / across as f64;
    let poisson = if law == Law::BondBased { 0.25 } else { 0.3 };
    let material = Elastic { young: YOUNG, poisson, density: 7850.0 };
    let origin = Vec3::new(-3.0 * dx, -0.5 * WIDTH, -0.5 * WIDTH);
    let block = lattice(3, origin, [LENGTH + 3.0 * dx, WIDTH, WIDTH], dx).block()?;
    let ghosts = nodes(&block, |x| x.x < 0.0);
    let last = nodes(&block, |x| x.x > LENGTH - dx);
    // Ghosts hold the bar along itself only; what keeps it from moving aside bears nothing.
    let line = |axis: usize| nodes(&block, |x| x.x < -2.5 * dx + 0.1 * dx && x[axis].abs() < 0.6 * dx);
    let (in_y, in_z) = (line(1), line(2));
    let mut formulation = formulation(Space::Solid, law, correction);
    if law == Law::StateBased {
        formulation.influence = Influence::Linear;
    }
    let mut parts = parts(block.clone(), material, formulation);
    parts.supports = vec![held(ghosts, &[Vec3::x()]), held(in_y, &[Vec3::y()]), held(in_z, &[Vec3::z()])];
    parts.loads = vec![pulled(&last, Vec3::new(FORCE, 0.0, 0.0))];
    let mut system = system(parts)?;
    let answer = linear_response(&mut system, 0.0)?;
    // The displacements of the linear answer, at a load too small for second-order terms.
    let small = 1e-9;
    system.update(&answer.iter().map(|u| small * u).collect::<Vec<_>>());
    let u = |node: u32| system.solid().displacement(node as usize) / small;
    let mean = |set: &[u32], axis: usize| set.iter().map(|&a| u(a)[axis]).sum::<f64>() / set.len() as f64;
    let layer = |x: f64| nodes(&block, |at| (at.x - x).abs() < 0.6 * dx);
    let (from, to) = (layer(0.4 * LENGTH), layer(0.6 * LENGTH));
    let centre =
        |set: &[u32]| set.iter().map(|&a| block.positions[a as usize].x).sum::<f64>() / set.len() as f64;
    let axial = (mean(&to, 0) - mean(&from, 0)) / (centre(&to) - centre(&from));
    // The slope of the lateral displacement over the whole section.
    let middle = nodes(&block, |x| (x.x - 0.5 * LENGTH).abs() < 0.1 * LENGTH);
    let (mut above, mut below) = (0.0, 0.0);
    for &a in &middle {
        let y = block.positions[a as usize].y;
        (above, below) = (above + y * u(a).y, below + y * y);
    }
    let lateral = above / below;
    let strain = FORCE / (YOUNG * WIDTH * WIDTH);
    Ok(Stretched {
        tip: mean(&last, 0) / (strain * LENGTH),
        gauge: axial / strain,
        poisson: -lateral / axial,
    })
}
