//! Bare peridynamic bodies that cases share: blocks, formulations, supports and loads, and what a study leaves behind.

use std::time::Instant;

use explicit_dynamics::Amplitude;
use peridynamics::{
    AppliedLoad, Correction, Elastic, Formulation, Idealisation, Influence, Law, Parts, Solid, SolidError,
    Space, StaticSolid, Support, Supported, Volumes,
};
use sph_core::{Block, BlockLattice, NodePlaces, Vec3};

use crate::judge::{Outcome, Solver};

/// A formulation with the horizon of 3.015 spacings, partial volumes and the influence 1/r.
pub fn formulation(space: Space, law: Law, correction: Correction) -> Formulation {
    let (volumes, influence) = (Volumes::Partial, Influence::Inverse);
    Formulation { space, law, horizon: 3.015, volumes, influence, correction }
}

/// A formulation with partial volumes as a scene says it.
pub fn said(of: &Formulation) -> String {
    let law = if of.law == Law::BondBased { "bond-based" } else { "state-based" };
    let plane = match of.space {
        Space::Solid => "",
        Space::PlaneStress => "plane = \"stress\", ",
        Space::PlaneStrain => "plane = \"strain\", ",
    };
    let correction = match of.correction {
        Correction::None => "none",
        Correction::Even => "even",
        Correction::Balanced => "balanced",
        Correction::EnergyFactor => "energy-factor",
    };
    let influence = match of.influence {
        Influence::Constant => "constant",
        Influence::Inverse => "inverse",
        Influence::Linear => "linear",
    };
    let horizon = of.horizon;
    format!(
        "{{ {law} = {{ {plane}horizon = {horizon}, influence = \"{influence}\", correction = \"{correction}\" }} }}"
    )
}

/// A box of nodes at the centres of equal cells; of two dimensions where `lengths[2]` is a thickness.
pub fn lattice(dimensions: usize, origin: Vec3, lengths: [f64; 3], spacing: f64) -> BlockLattice {
    BlockLattice {
        dimensions,
        lengths,
        spacing: [spacing; 3],
        origin,
        nodes: NodePlaces::Centres,
        grading: [1.0; 3],
        disorder: 0.0,
        seed: 1,
    }
}

/// Numbers of the nodes at places of a kind.
pub fn nodes(block: &Block, here: impl Fn(&Vec3) -> bool) -> Vec<u32> {
    (0..block.len()).filter(|&a| here(&block.positions[a])).map(|a| a as u32).collect()
}

/// No displacement along directions.
pub fn held(nodes: Vec<u32>, displacement: &[Vec3]) -> Supported {
    Supported { nodes, support: Support::Held { displacement: displacement.to_vec(), director: Vec::new() } }
}

/// A displacement at level one.
pub fn moved(nodes: Vec<u32>, direction: Vec3, by: f64) -> Supported {
    Supported { nodes, support: Support::Moved { direction, by, amplitude: Amplitude::Constant } }
}

/// A force at level one, equal on all nodes of a set.
pub fn pulled(nodes: &[u32], total: Vec3) -> AppliedLoad {
    let share = total / nodes.len() as f64;
    AppliedLoad { forces: nodes.iter().map(|&a| (a, share)).collect(), amplitude: Amplitude::Constant }
}

/// A body without cracks or limits.
pub fn parts(block: Block, material: Elastic, formulation: Formulation) -> Parts {
    Parts {
        block,
        material,
        formulation: Idealisation::Bonds(formulation),
        plastic: None,
        fracture: None,
        cracks: Vec::new(),
        contact: None,
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 1,
    }
}

/// The system of a body.
///
/// # Errors
/// [`SolidError`] for the first invalid part.
pub fn system(parts: Parts) -> Result<StaticSolid, SolidError> {
    Ok(StaticSolid::new(Solid::new(parts)?))
}

/// What a study of a body without time leaves behind: one row of figures without a unit.
pub fn found(body: &Solid, started: Instant, figures: &[(&str, f64)]) -> Outcome {
    let figures: Vec<_> = figures.iter().map(|&(name, value)| (name, "-", value)).collect();
    Outcome {
        particles: body.len(),
        spacing: body.block().greatest_spacing(),
        dof: body.dof(),
        steps: 1,
        wall_seconds: started.elapsed().as_secs_f64(),
        ..Outcome::row(Solver::Static, &figures)
    }
}
