//! Linearised buckling: a cantilever column, and a simply supported plate pressed along its length.

use super::{CaseError, Solved, numbered};
use crate::fe_shell::{Load, Mesh, Model, Section, Side, Support, Turning};
use implicit_statics::{
    Branches, BucklingOptions, Control, CriticalOptions, Equilibrium, PathOptions, Start, follow,
    linear_buckling, unwatched,
};
use nalgebra::Vector3;
use std::f64::consts::PI;
use std::ops::ControlFlow;
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

/// Length and width of the plate of `plate_stability` \[mm\].
const PLATE: [f64; 2] = [300.0, 200.0];

/// The plate of `plate_stability` shortened by a moved end, all edges simply supported and its sides held across: force
/// \[kN\] and greatest deflection from the flat plane along its middle line and at its centre \[mm\], for
/// shortenings \[mm\] up to one in equal steps.
///
/// It is bent at rest by one half-wave each way of this deflection \[mm\]. 3n × 2n elements, n even.
pub fn plate_shortened(n: usize, deflection: f64, until: f64, steps: usize) -> Result<Solved, CaseError> {
    let mut options = PathOptions::new(Control::Load { step: until / steps as f64, until });
    options.largest = 1.0;
    shortened(n, deflection, &options)
}

/// The same plate by arc length, first to one shortening \[mm\] and up to another, past turning points on the way and along the
/// branch that leaves a bifurcation; deflection zero makes it flat.
pub fn plate_path(n: usize, deflection: f64, first: f64, until: f64) -> Result<Solved, CaseError> {
    let mut options = PathOptions::new(Control::ArcLength { first, range: (f64::NEG_INFINITY, until) });
    options.critical =
        Some(CriticalOptions { tolerance: 1e-3, branches: Branches::Stable, ..CriticalOptions::default() });
    options.newton.line_search = false;
    shortened(n, deflection, &options)
}

fn shortened(n: usize, deflection: f64, options: &PathOptions) -> Result<Solved, CaseError> {
    let [length, width] = PLATE;
    let mesh = Mesh::patch(3 * n, 2 * n, |xi, eta| {
        let ((sx, cx), (sy, cy)) = (libm::sincos(PI * xi), libm::sincos(PI * eta));
        let slope = [deflection * PI / length * cx * sy, deflection * PI / width * sx * cy];
        let place = Vector3::new(length * xi, width * eta, deflection * sx * sy);
        (place, Vector3::new(-slope[0], -slope[1], 1.0).normalize())
    });
    let roller = |side: Side, directions: &[Vector3<f64>]| Support {
        nodes: mesh.side(side),
        held: directions.to_vec(),
        director: Turning::Free,
    };
    let ends = [Vector3::x(), Vector3::z()];
    let sides = [Vector3::y(), Vector3::z()];
    let supports = [
        roller(Side::XiStart, &ends),
        roller(Side::XiEnd, &ends),
        roller(Side::EtaStart, &sides),
        roller(Side::EtaEnd, &sides),
    ];
    let section = Section::isotropic(69000.0, 0.33, 2.0, 1.0);
    let start = Instant::now();
    let model = Model::new(&mesh, section, Vector3::x(), &supports, &[])?;
    let mut model = model.moving(&mesh.side(Side::XiEnd), -Vector3::x());
    let (held, centre) = (mesh.side(Side::XiStart), mesh.node(3 * n / 2, n));
    let middle: Vec<usize> = (0..=3 * n).map(|i| mesh.node(i, n)).collect();
    let mut rows = Vec::new();
    let path = follow(&mut model, &Start::default(), options, |point, model| {
        let height = |node: usize| mesh.positions[node].z + model.displacement(node).z;
        let most = middle.iter().map(|&node| height(node)).fold(0.0, f64::max);
        rows.push(vec![point.level(), 1e-3 * model.reaction(&held).x, height(centre), most]);
        ControlFlow::Continue(())
    });
    path.end?;
    Ok(Solved {
        columns: vec!["shortening [mm]", "P [kN]", "w_centre [mm]", "w_most [mm]"],
        rows,
        nodes: model.nodes(),
        spacing: model.spacing(),
        unknowns: model.unknowns(),
        iterations: path.points.iter().map(|point| point.converged.iterations + 1).sum(),
        seconds: start.elapsed().as_secs_f64(),
    })
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
