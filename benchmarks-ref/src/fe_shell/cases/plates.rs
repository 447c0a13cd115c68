//! Square plates: central deflection under pressure and frequencies, all thicknesses and edges.

use super::{CaseError, Solved, numbered, solve_linear};
use crate::fe_shell::{Load, Mesh, Model, Section, Side, Support, Turning};
use implicit_statics::{Equilibrium, natural_modes, unwatched};
use nalgebra::Vector3;
use std::time::Instant;

/// How the four edges of a plate are held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlateEdges {
    /// SSSS, hard: no deflection, no turn along the edge.
    SimplySupported,
    /// CCCC: no deflection, no turn.
    Clamped,
    /// CFFF: one edge clamped.
    Cantilever,
    /// FFFF.
    Free,
}

const SIDES: [(Side, [f64; 3]); 4] = [
    (Side::XiStart, [0.0, 1.0, 0.0]),
    (Side::XiEnd, [0.0, 1.0, 0.0]),
    (Side::EtaStart, [1.0, 0.0, 0.0]),
    (Side::EtaEnd, [1.0, 0.0, 0.0]),
];

/// Poisson's ratio of all plates.
const POISSON: f64 = 0.3;

/// A plate of side one that only bends, with D = 1 and unit density.
fn plate(n: usize, slenderness: f64, edges: PlateEdges, loads: &[Load]) -> Result<(Mesh, Model), CaseError> {
    plate_on(n, slenderness, edges, loads, Vec::new())
}

/// The same with further supports.
fn plate_on(
    n: usize,
    slenderness: f64,
    edges: PlateEdges,
    loads: &[Load],
    further: Vec<Support>,
) -> Result<(Mesh, Model), CaseError> {
    let mesh = Mesh::plate(n, n, 1.0, 1.0);
    let all: Vec<usize> = (0..mesh.positions.len()).collect();
    let mut supports = vec![Support::roller(all.clone(), Vector3::x()), Support::roller(all, Vector3::y())];
    for (side, along) in SIDES {
        let director = match edges {
            PlateEdges::SimplySupported => Turning::InPlane(Vector3::from(along)),
            PlateEdges::Clamped => Turning::Held,
            PlateEdges::Cantilever if side == Side::XiStart => Turning::Held,
            PlateEdges::Cantilever | PlateEdges::Free => continue,
        };
        supports.push(Support { nodes: mesh.side(side), held: vec![Vector3::z()], director });
    }
    supports.extend(further);
    let young = 12.0 * (1.0 - POISSON * POISSON) / slenderness.powi(3);
    let section = Section::isotropic(young, POISSON, slenderness, 1.0);
    let model = Model::new(&mesh, section, Vector3::x(), &supports, loads)?;
    Ok((mesh, model))
}

/// Deflection of the middle in q a⁴/D under uniform pressure; n elements a side, n even, `slenderness` = h/a.
pub fn plate_deflection(n: usize, slenderness: f64, edges: PlateEdges) -> Result<Solved, CaseError> {
    let (mesh, model) = plate(n, slenderness, edges, &[Load::Area(Vector3::z())])?;
    let middle = mesh.node(n / 2, n / 2);
    solve_linear(model, &["w_centre [-]"], |model, motion| vec![model.displacement_in(motion, middle).z])
}

/// Deflection of the middle against the corners, in P a²/D, of a free plate under a force P there and −P/4 at each corner.
///
/// Three corners are held, which the balanced forces leave without reaction; n elements a side, n even.
pub fn plate_centre_against_corners(n: usize, slenderness: f64) -> Result<Solved, CaseError> {
    let nodes = Mesh::plate(n, n, 1.0, 1.0);
    let middle = nodes.node(n / 2, n / 2);
    let corners = [[0, 0], [n, 0], [0, n], [n, n]].map(|[i, j]| nodes.node(i, j));
    let mut loads = vec![Load::Node(middle, Vector3::z())];
    loads.extend(corners.map(|corner| Load::Node(corner, -0.25 * Vector3::z())));
    let held = Support::roller(corners[..3].to_vec(), Vector3::z());
    let (_, model) = plate_on(n, slenderness, PlateEdges::Free, &loads, vec![held])?;
    solve_linear(model, &["w_centre [-]", "w_corner [-]"], |model, motion| {
        [middle, corners[3]].map(|node| model.displacement_in(motion, node).z).to_vec()
    })
}

/// The first six ω a² √(ρh/D) of bending, a row each, rigid motions left out; n elements a side.
pub fn plate_frequencies(n: usize, slenderness: f64, edges: PlateEdges) -> Result<Solved, CaseError> {
    let (_, mut model) = plate(n, slenderness, edges, &[])?;
    let start = Instant::now();
    let (rigid, shift) = if edges == PlateEdges::Free { (3, -1.0) } else { (0, 0.0) };
    // with a = D = 1 the parameter is ω √(ρh) = ω √h
    let scale = slenderness.sqrt();
    let modes = natural_modes(&mut model, 0.0, 6 + rigid, shift / (scale * scale), &mut unwatched)?.modes;
    let mut frequencies: Vec<f64> = modes.iter().map(|mode| mode.circular_frequency() * scale).collect();
    frequencies.sort_by(f64::total_cmp);
    Ok(Solved {
        columns: vec!["mode [-]", "circular_frequency [-]"],
        rows: numbered(frequencies.split_off(rigid)),
        nodes: model.nodes(),
        spacing: model.spacing(),
        unknowns: model.unknowns(),
        iterations: 1,
        seconds: start.elapsed().as_secs_f64(),
    })
}
