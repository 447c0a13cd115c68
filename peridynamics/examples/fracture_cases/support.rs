//! Lattices, bodies and marches that the cases share.

use std::ops::ControlFlow;

use explicit_dynamics::{Observer, Record, Transient};
use peridynamics::{Carrier, Correction, Elastic, Formulation, Influence, Law, Parts, Solid, Space, Volumes};
use sph_core::{Block, Vec3};

use crate::measure::Damaged;

/// A lattice of cell centres; in a plane one node across, and the last spacing is the thickness.
pub fn lattice(dimensions: usize, counts: [usize; 3], spacing: [f64; 3], origin: Vec3) -> Block {
    let mut block = Block { dimensions, spacing, ..Block::default() };
    for i in 0..counts[0] {
        for j in 0..counts[1] {
            for k in 0..counts[2] {
                let centre = |n: usize, dx: f64| (n as f64 + 0.5) * dx;
                let z = if dimensions == 3 { centre(k, spacing[2]) } else { 0.0 };
                let place = Vec3::new(centre(i, spacing[0]), centre(j, spacing[1]), z);
                block.positions.push(origin + place);
                block.volumes.push(spacing.iter().product());
            }
        }
    }
    block
}

/// Nodes at places that `within` holds for.
pub fn nodes(block: &Block, within: impl Fn(&Vec3) -> bool) -> Vec<u32> {
    (0..block.len() as u32).filter(|&node| within(&block.positions[node as usize])).collect()
}

pub fn formulation(space: Space, law: Law, horizon: f64, correction: Correction) -> Formulation {
    Formulation { space, law, horizon, volumes: Volumes::Partial, influence: Influence::Inverse, correction }
}

pub fn parts(block: Block, material: Elastic, formulation: Formulation) -> Parts {
    Parts {
        block,
        material,
        formulation: Carrier::Bonds(formulation),
        fracture: None,
        cracks: Vec::new(),
        contact: None,
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 2,
    }
}

struct Watch<F>(F);

impl<F: FnMut(&mut Solid, &Record) -> ControlFlow<()>> Observer<Solid> for Watch<F> {
    fn record(&mut self, system: &mut Solid, record: &Record) -> ControlFlow<()> {
        (self.0)(system, record)
    }
}

/// Marches a body and shows it at equal intervals; at 0.9 of the stable step.
pub fn march(
    body: &mut Solid,
    duration: f64,
    record_every: f64,
    damping: f64,
    show: impl FnMut(&mut Solid, &Record) -> ControlFlow<()>,
) -> Result<(), Box<dyn std::error::Error>> {
    Transient { duration, record_every, damping, safety: 0.9 }.march(body, &mut Watch(show))?;
    Ok(())
}

/// Damage of all nodes.
pub fn damage(body: &Solid) -> Vec<f64> {
    (0..body.len()).map(|node| body.damage(node)).collect()
}

/// Measures the damage of a body.
pub fn with_damage<T>(body: &Solid, measure: impl FnOnce(&Damaged<'_>) -> T) -> T {
    measure(&Damaged { positions: &body.block().positions, damage: &damage(body) })
}

/// Energy of all broken bonds.
pub fn fracture_energy(body: &Solid) -> f64 {
    (0..body.len()).map(|node| body.fracture_energy(node)).sum()
}
