//! Problems on bricks: resolution in, figures out.

use std::time::Instant;

use implicit_statics::{Equilibrium, EquilibriumError, Newton, NewtonOptions};
use nalgebra::Vector3;

use super::element::Moduli;
use super::mesh::Mesh;
use super::model::{Held, Model};
use crate::fe_shell::cases::Solved;

/// Length of the cantilever, and side of its section \[mm\].
const BEAM: [f64; 2] = [254.0, 25.4];
/// Its Young's modulus \[N/mm²\].
const YOUNG: f64 = 82.74;
/// Side of the plate over its thickness, and its Poisson's ratio.
const PLATE: [f64; 2] = [100.0, 0.316];

/// Deflection of the axis of a clamped beam of square section at its tip, over its length, under `K = q L³/(E I)` by a dead load on its
/// upper face; with `volume` the load is one by volume. Columns `level` (K) and `w`.
///
/// # Errors
/// [`EquilibriumError`] where a level is not reached.
pub fn cantilever(
    counts: [usize; 3],
    poisson: f64,
    levels: &[f64],
    volume: bool,
) -> Result<Solved, EquilibriumError> {
    let [length, h] = BEAM;
    let mesh = Mesh::block([length, h, h], counts);
    let held = fixed(&mesh.nodes(|x| x.x == 0.0), &[0, 1, 2]);
    let line = YOUNG * h.powi(4) / (12.0 * length.powi(3));
    let down = Vector3::new(0.0, 0.0, -line);
    let loads = if volume {
        mesh.body_force(down / (h * h))
    } else {
        mesh.traction(|x| x.z > h * (1.0 - 1e-9), down / h)
    };
    let tip = mesh.nodes(|x| x.x > length * (1.0 - 1e-9));
    let near = |node: &usize| (mesh.positions[*node] - Vector3::new(length, 0.5 * h, 0.5 * h)).norm();
    // Where no node stands on the axis, the mean of those nearest to it.
    let least = tip.iter().map(near).fold(f64::INFINITY, f64::min);
    let axis: Vec<usize> = tip.iter().copied().filter(|node| near(node) < least + 1e-6 * h).collect();
    let model = Model::new(&mesh, Moduli::isotropic(YOUNG, poisson), 3, &held, &loads);
    solve(model, levels, |model| {
        let sum = axis.iter().map(|&node| model.displacement(node).z).sum::<f64>();
        -sum / (axis.len() as f64 * length)
    })
}

/// Deflection of the middle of a square plate over its thickness, a/h = 100, ν = .316, edges held on the line of the mid-plane against
/// deflecting and moving along their normals, under the pressure `P = q a⁴/(E h⁴)`: a quarter of `across`² bricks in two layers. Columns `level` (P) and `w`.
///
/// # Errors
/// [`EquilibriumError`] where a level is not reached.
pub fn plate(across: usize, levels: &[f64]) -> Result<Solved, EquilibriumError> {
    let [side, poisson] = PLATE;
    let half = 0.5 * side;
    let mesh = Mesh::block([half, half, 1.0], [across, across, 2]);
    let edge = |x: f64| x > half * (1.0 - 1e-9);
    let middle = |x: &Vector3<f64>| (x.z - 0.5).abs() < 1e-9;
    let mut held = fixed(&mesh.nodes(|x| x.x == 0.0), &[0]);
    held.extend(fixed(&mesh.nodes(|x| x.y == 0.0), &[1]));
    held.extend(fixed(&mesh.nodes(|x| middle(x) && edge(x.x)), &[0, 2]));
    held.extend(fixed(&mesh.nodes(|x| middle(x) && edge(x.y)), &[1, 2]));
    let pressure = Vector3::new(0.0, 0.0, -side.powi(-4));
    let loads = mesh.traction(|x| x.z > 1.0 - 1e-9, pressure);
    let centre = mesh.nodes(|x| x.x == 0.0 && x.y == 0.0 && middle(x));
    let model = Model::new(&mesh, Moduli::isotropic(1.0, poisson), 3, &held, &loads);
    solve(model, levels, |model| centre.iter().map(|&node| -model.displacement(node).z).sum())
}

/// Nodes held along some axes.
fn fixed(nodes: &[usize], axes: &[usize]) -> Vec<Held> {
    nodes.iter().flat_map(|&node| axes.iter().map(move |&axis| Held { node, axis, by: 0.0 })).collect()
}

/// Equilibria at levels, a number of each.
fn solve(
    model: Option<Model>,
    levels: &[f64],
    read: impl Fn(&Model) -> f64,
) -> Result<Solved, EquilibriumError> {
    let start = Instant::now();
    let mut model = model.unwrap_or_else(|| unreachable!("bricks of a box keep their sides"));
    let options =
        NewtonOptions { tolerance: 1e-8, iterations: 30, line_search: false, ..NewtonOptions::default() };
    let mut newton = Newton::new(&model, &options)?;
    let (mut rows, mut iterations) = (vec![vec![0.0; 2]], 0);
    for &level in levels {
        iterations += newton.at_level(&mut model, level)?.iterations;
        rows.push(vec![level, read(&model)]);
    }
    Ok(Solved {
        columns: vec!["level [-]", "w [-]"],
        rows,
        nodes: model.nodes(),
        spacing: 0.0,
        unknowns: model.unknowns(),
        iterations,
        seconds: start.elapsed().as_secs_f64(),
    })
}
