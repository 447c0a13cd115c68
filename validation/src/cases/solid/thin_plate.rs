//! The plate 300 × 200 × 2 mm of two sheets, its ends hinged and drawn together or apart, its sides held in their plane: for
//! studies that no scene can say, as cracks through one sheet.

use std::error::Error;
use std::ops::ControlFlow;

use implicit_statics::{BucklingOptions, Equilibrium, Newton, NewtonOptions, linear_buckling};
use peridynamics::{
    Correction, Elastic, Formulation, Idealisation, Law, Parts, Sheets, Solid, Space, StaticSolid, Supported,
};
use sph_core::{Block, BlockLattice, NodePlaces, Vec3};

use crate::support::solids::{formulation, moved, parts};

/// Edges of the plate and its thickness \[mm\].
pub const LENGTHS: [f64; 3] = [300.0, 200.0, 2.0];
/// How far the ends are moved at level one \[mm\].
pub const WAY: f64 = 1.2;
/// Critical force of the plate without a crack by the closed form \[kN\].
pub const CRITICAL: f64 = 6.863;
/// Aluminium in millimetres, kilonewtons and milliseconds.
const ALUMINIUM: Elastic = Elastic { young: 69.0, poisson: 0.33, density: 2.7e-6 };
/// Part of the way at which the plate is still linear to six digits.
const SMALL: f64 = 1e-4;

/// Columns on the edges, with a spacing along each edge.
///
/// # Errors
/// Lengths and spacings that make no lattice.
pub fn columns(spacing: [f64; 2]) -> Result<Block, Box<dyn Error>> {
    let lattice = BlockLattice {
        dimensions: 2,
        lengths: LENGTHS,
        spacing: [spacing[0], spacing[1], LENGTHS[2]],
        origin: Vec3::zeros(),
        nodes: NodePlaces::Edges,
        grading: [1.0; 3],
        disorder: 0.0,
        seed: 0,
    };
    Ok(lattice.block()?)
}

/// The plate without cracks, whose end x = 300 moves by so much at level one.
pub fn plate(block: Block, way: f64) -> Parts {
    use peridynamics::Support::Held;
    let (x, y, z) = (Vec3::x(), Vec3::y(), Vec3::z());
    let on = |face: usize| -> Vec<u32> { block.faces[face].iter().map(|&(node, _)| node).collect() };
    let held = |face: usize, displacement: &[Vec3], director: Vec3| Supported {
        nodes: on(face),
        support: Held { displacement: displacement.to_vec(), director: vec![director] },
    };
    let mut supports =
        vec![held(0, &[x, y, z], y), held(1, &[y, z], y), held(2, &[y, z], x), held(3, &[y, z], x)];
    supports.push(moved(on(1), x, way));
    let bonds =
        Formulation { horizon: 1.5, ..formulation(Space::PlaneStress, Law::StateBased, Correction::Even) };
    let plate = parts(block, ALUMINIUM, bonds);
    Parts {
        formulation: Idealisation::Sheets(Sheets { thickness: LENGTHS[2], formulation: bonds }),
        supports,
        ..plate
    }
}

/// What the end x = 300 bears along x \[kN\], for the forces last evaluated.
pub fn end_force(solid: &Solid) -> f64 {
    solid.block().faces[1].iter().map(|&(node, _)| solid.reaction(node as usize).x).sum()
}

/// The first critical force.
pub struct Critical {
    /// \[kN\].
    pub force: f64,
    /// Deflections of the mode, the largest one.
    pub shape: Vec<f64>,
}

/// The first critical force of a flat plate.
///
/// # Errors
/// A plate that is refused, a balance that is not found.
pub fn critical(parts: &Parts) -> Result<Critical, Box<dyn Error>> {
    let mut flat = StaticSolid::new(Solid::new(parts.clone())?);
    Newton::new(&flat, &NewtonOptions::default())?.at_level(&mut flat, SMALL)?;
    flat.evaluate(SMALL);
    let force = end_force(flat.solid()).abs() / SMALL;
    let mut plate = StaticSolid::new(Solid::new(parts.clone())?);
    let modes =
        linear_buckling(&mut plate, 0.0, &BucklingOptions::new(1), &mut |_| ControlFlow::Continue(()))?;
    let mode = modes.modes.first().ok_or("no mode")?;
    plate.update(&mode.shape);
    let deflections: Vec<f64> =
        (0..plate.solid().len()).map(|node| plate.solid().displacement(node).z).collect();
    let most = deflections.iter().fold(0.0_f64, |most, &w| if w.abs() > most.abs() { w } else { most });
    Ok(Critical { force: mode.level * force, shape: deflections.iter().map(|w| w / most).collect() })
}

/// Of each column the one opposite across the plate, by the mirror y → 200 − y.
pub fn opposite(block: &Block) -> Vec<usize> {
    let near = |x: &Vec3| {
        let there = Vec3::new(x.x, LENGTHS[1] - x.y, 0.0);
        let distance =
            |&node: &usize| (Vec3::new(block.positions[node].x, block.positions[node].y, 0.0) - there).norm();
        (0..block.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
    };
    block.positions.iter().map(near).collect()
}
