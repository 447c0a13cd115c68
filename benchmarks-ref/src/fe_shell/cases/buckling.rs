//! Linearised buckling: a cantilever column, and a simply supported plate pressed along its length.

use super::{CaseError, Solved, numbered};
use crate::fe_shell::{Load, Mesh, Model, Section, Side, Support, Turning};
use implicit_statics::{BucklingOptions, Equilibrium, linear_buckling, unwatched};
use nalgebra::Vector3;
use std::f64::consts::PI;
use std::time::Instant;

fn lowest_two(mut model: Model) -> Result<Solved, CaseError> {
    let start = Instant::now();
    let found = linear_buckling(&mut model, 0.0, &BucklingOptions::new(2), &mut unwatched)?;
    let mut levels: Vec<f64> = found.modes.iter().map(|mode| mode.level).collect();
    levels.sort_by(f64::total_cmp);
    Ok(Solved {
        columns: vec!["mode [-]", "level [-]"],
        rows: numbered(levels),
        nodes: model.nodes(),
        spacing: model.spacing(),
        unknowns: model.unknowns(),
        iterations: 1,
        seconds: start.elapsed().as_secs_f64(),
    })
}

/// First and second critical force of a cantilever column over π²EI/(4L²): 1 and 9; n elements along.
pub fn column_buckling(n: usize) -> Result<Solved, CaseError> {
    let (length, thickness, young) = (10.0, 0.1_f64, 1.2e6);
    let mesh = Mesh::plate(n, 1, length, 1.0);
    let supports = [Support::clamp(mesh.side(Side::XiStart))];
    let euler = PI * PI * (young * thickness.powi(3) / 12.0) / (4.0 * length * length);
    let loads = [Load::Edge(mesh.side(Side::XiEnd), -Vector3::x() * euler)];
    let section = Section::isotropic(young, 0.0, thickness, 1.0);
    let model = Model::new(&mesh, section, Vector3::x(), &supports, &loads)?;
    lowest_two(model)
}

/// First and second critical force \[kN\] of the plate 300 × 200 × 2 mm of `plate_stability`, all edges simply
/// supported: 11.057 (two half-waves) and 11.959 (one) with the sides free in the plane, 6.863 (one) and 9.325 (two)
/// with the sides held across it.
///
/// 3n × 2n elements, n even.
pub fn plate_buckling(n: usize, sides_held: bool) -> Result<Solved, CaseError> {
    let mesh = Mesh::plate(3 * n, 2 * n, 300.0, 200.0);
    let edge = |side: Side, along: Vector3<f64>| Support {
        nodes: mesh.side(side),
        held: vec![Vector3::z()],
        director: Turning::InPlane(along),
    };
    let (low, high) = (mesh.side(Side::EtaStart), mesh.side(Side::EtaEnd));
    let mut supports = vec![
        edge(Side::XiStart, Vector3::y()),
        edge(Side::XiEnd, Vector3::y()),
        edge(Side::EtaStart, Vector3::x()),
        edge(Side::EtaEnd, Vector3::x()),
        Support::roller((0..=2 * n).map(|j| mesh.node(3 * n / 2, j)).collect(), Vector3::x()),
    ];
    if sides_held {
        supports.push(Support::roller([low, high].concat(), Vector3::y()));
    } else {
        supports.push(Support::roller((0..=3 * n).map(|i| mesh.node(i, n)).collect(), Vector3::y()));
    }
    let loads = [
        Load::Edge(mesh.side(Side::XiStart), Vector3::x() * 1000.0),
        Load::Edge(mesh.side(Side::XiEnd), -Vector3::x() * 1000.0),
    ];
    let section = Section::isotropic(69000.0, 0.33, 2.0, 1.0);
    let model = Model::new(&mesh, section, Vector3::x(), &supports, &loads)?;
    lowest_two(model)
}
