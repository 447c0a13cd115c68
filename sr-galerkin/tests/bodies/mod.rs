//! Bodies that the tests share.

#![allow(dead_code)] // no test uses all of it

pub mod cylinder;
pub mod derivatives;

use implicit_statics::{Newton, NewtonOptions};
use solid_kinematics::{Formulation, Material, Moduli, StressMeasure, Tangent, Tensor, Update};
use sph_core::{Basis, BlockLattice, Hexahedra, NodePlaces, Support, Vec3, Weight};
use sr_galerkin::{Condition, Essential, Galerkin, Load, Parts, Step, Volumes, lead};

/// Midpoint increments of Kirchhoff's stress.
pub const MIDPOINT: Formulation =
    Formulation::StrainRotation { update: Update::Midpoint, measure: StressMeasure::Kirchhoff };
/// Increments by the decomposition to the letter.
pub const STEP_START: Formulation =
    Formulation::StrainRotation { update: Update::StepStart, measure: StressMeasure::Kirchhoff };

/// Planes that divide a length.
pub fn planes(length: f64, nodes: usize) -> Vec<f64> {
    (0..nodes).map(|i| length * i as f64 / (nodes - 1) as f64).collect()
}

/// A box of nodes in rows on its own cells, E = 1, ν = 0.3, nothing held.
pub fn block(lengths: [f64; 3], counts: [usize; 3], disorder: f64) -> Parts {
    let spacing = [0, 1, 2].map(|k| lengths[k] / (counts[k] - 1) as f64);
    let lattice = BlockLattice {
        dimensions: 3,
        lengths,
        spacing,
        origin: Vec3::zeros(),
        nodes: NodePlaces::Edges,
        grading: [1.0; 3],
        disorder,
        seed: 11,
    };
    Parts {
        nodes: lattice.block().expect("a block").positions,
        cells: Hexahedra::between(&[0, 1, 2].map(|k| planes(lengths[k], counts[k]))).expect("planes"),
        rule: 3,
        cut: None,
        basis: Basis::Quadratic,
        support: Support::ellipsoid(spacing.map(|s| 2.5 * s)),
        weight: Weight::Csrbf2,
        material: Material {
            moduli: Moduli::isotropic(1.0, 0.3).expect("moduli"),
            formulation: MIDPOINT,
            plastic: None,
        },
        axes: Tensor::identity(),
        density: 1.0,
        mirrors: Vec::new(),
        conditions: Vec::new(),
        essential: Essential::Collocation,
        loads: Vec::new(),
        tangent: Tangent::Continuum,
        volumes: Volumes::Shared,
        threads: 1,
    }
}

/// Nodes where something holds.
pub fn nodes(parts: &Parts, holds: impl Fn(&Vec3) -> bool) -> Vec<u32> {
    (0..parts.nodes.len() as u32).filter(|&node| holds(&parts.nodes[node as usize])).collect()
}

/// How the cantilever is loaded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum On {
    /// Dead traction on the upper face.
    Top,
    /// A force per volume.
    Volume,
    /// Pressure that follows the upper face.
    Follower,
}

pub const LENGTH: f64 = 254.0;

/// The cantilever of the design's §10.1, `K = q L³/(E I)` one at level one; sections of height L/slenderness.
pub fn cantilever(columns: usize, slenderness: f64, on: On) -> Parts {
    let h = LENGTH / slenderness;
    let mut parts = block([LENGTH, h, h], [columns, 3, 3], 0.0);
    let young = 82.74;
    parts.material.moduli = Moduli::isotropic(young, 0.2).expect("moduli");
    let clamped = nodes(&parts, |x| x.x == 0.0);
    parts.conditions.extend(Condition::fixed(&clamped));
    let line = young * h.powi(4) / 12.0 / LENGTH.powi(3);
    let faces = parts.cells.faces[5].clone();
    parts.loads.push(match on {
        On::Top => Load::Traction { faces, traction: Vec3::new(0.0, 0.0, -line / h) },
        On::Volume => Load::Body(Vec3::new(0.0, 0.0, -line / (h * h))),
        On::Follower => Load::Pressure { faces, pressure: line / h },
    });
    parts
}

/// The source's linear basis on balls.
pub fn as_in_the_source(parts: &mut Parts, largest_spacing: f64) {
    parts.basis = Basis::Linear;
    parts.support = Support::sphere(2.5 * largest_spacing);
}

/// A body.
pub fn body(parts: Parts) -> Galerkin {
    Galerkin::new(parts).expect("a body")
}

/// Newton's method as the design has it: 1e-8, 30 iterations, whole steps.
pub fn newton(body: &Galerkin) -> Newton {
    let options =
        NewtonOptions { tolerance: 1e-8, iterations: 30, line_search: false, ..NewtonOptions::default() };
    Newton::new(body, &options).expect("options")
}

/// Leads a body through levels and reads a number at each; the steps that were made.
pub fn curve(body: &mut Galerkin, levels: &[f64], read: impl Fn(&Galerkin) -> f64) -> (Vec<f64>, Vec<Step>) {
    let mut newton = newton(body);
    let (mut values, mut steps) = (Vec::new(), Vec::new());
    let mut from = 0.0;
    for &level in levels {
        lead(body, &mut newton, (from, level), |step, _| steps.push(step.clone())).expect("equilibrium");
        values.push(read(body));
        from = level;
    }
    (values, steps)
}

/// Deflection of the axis at the tip of the cantilever over its length.
pub fn tip(body: &Galerkin) -> f64 {
    let x = body.rest();
    let h = x.iter().fold(0.0, |most: f64, x| most.max(x.z));
    let axis = |x: &Vec3| x.x == LENGTH && (x.y - h / 2.0).abs() < 1e-9 && (x.z - h / 2.0).abs() < 1e-9;
    let node = x.iter().position(axis).expect("a node on the axis");
    -body.displacement(node).z / LENGTH
}
