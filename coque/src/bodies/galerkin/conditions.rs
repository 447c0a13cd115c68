//! Supports, loads and columns of a Galerkin solid.

use sph_core::{Hexahedra, Vec3};
use sr_galerkin::{Condition, Load, Mirror};

use super::places::Places;
use crate::bodies::PrescribedPoint;
use crate::bodies::refusal::model_error;
use crate::bodies::rigid::Hold;
use crate::bodies::solid::sets::NodeSets;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{OnNodes, Pressure, Traction};

/// Nodes nearer to a plane than this part of the spacing lie on it.
const ON_PLANE: f64 = 1e-9;
/// A held direction with more than this along a motion opposes it.
const OPPOSED: f64 = 1e-9;

/// The supports, but that of the motion that is sought.
pub(super) fn conditions(
    scene: &BodyInScene<'_>,
    sets: &NodeSets<'_>,
    sought: Option<usize>,
) -> Result<Vec<Condition>, SceneError> {
    let mut out = Vec::new();
    for (_, support) in scene.supports.iter().enumerate().filter(|(i, _)| sought != Some(*i)) {
        let nodes = sets.at(&support.at("on"), support.on)?;
        let held = |direction: Vec3| Condition::held(nodes.to_vec(), direction);
        for condition in support.kinds().iter().filter_map(|(_, kind)| kind.on_nodes()) {
            match condition {
                OnNodes::Symmetry(mirror) => out.push(held(Vec3::from(mirror.normal))),
                OnNodes::Held(given) => {
                    out.extend(given.displacement.iter().map(|&v| held(Vec3::from(v))));
                }
                OnNodes::Moved(moved) => {
                    out.push(Condition { by: moved.by, ..held(Vec3::from(moved.direction)) })
                }
                // The checks leave none.
                OnNodes::Turned(_) => {}
            }
        }
    }
    Ok(out)
}

/// Planes of symmetry that whole cuts of the body lie in: behind them the solid goes on. A traction along a cut bends what a whole has
/// there, and its plane is left out.
pub(super) fn mirrors(
    scene: &BodyInScene<'_>,
    places: &Places,
    sets: &NodeSets<'_>,
) -> Result<Vec<Mirror>, SceneError> {
    let mut out = Vec::new();
    for support in &scene.supports {
        let nodes = sets.at(&support.at("on"), support.on)?;
        for normal in support.symmetry.iter().map(|mirror| Vec3::from(mirror.normal).normalize()) {
            let all = &places.block.positions;
            let point = all[nodes[0] as usize];
            let on = |x: &Vec3| (x - point).dot(&normal).abs() <= ON_PLANE * places.block.greatest_spacing();
            let flat = nodes.iter().all(|&node| on(&all[node as usize]));
            let whole = all.iter().filter(|x| on(x)).count() == nodes.len();
            let mut pulled = false;
            for load in scene.loads.iter().filter(|load| load.traction.is_some()) {
                let loaded = sets.at(&load.at("on"), load.on)?;
                pulled |= loaded.iter().all(|&node| on(&all[node as usize]));
            }
            if flat && whole && !pulled {
                out.push(Mirror { point, normal });
            }
        }
    }
    Ok(out)
}

/// What conditions hold of rigid motions.
pub(super) fn holds(conditions: &[Condition]) -> Vec<Hold> {
    let of = |condition: &Condition| {
        let direction = condition.direction.normalize();
        condition.nodes.iter().map(move |&node| Hold::Displacement(node, direction)).collect::<Vec<_>>()
    };
    conditions.iter().flat_map(of).collect()
}

/// The one motion that drives an analysis which seeks its force, with the number of its support.
///
/// # Errors
/// [`SceneError::Model`] where another support opposes it.
pub(super) fn driven(
    scene: &BodyInScene<'_>,
    sets: &NodeSets<'_>,
) -> Result<Option<(usize, PrescribedPoint)>, SceneError> {
    let Some(number) = scene.sole_motion() else { return Ok(None) };
    let support = &scene.supports[number];
    let nodes = sets.at(&support.at("on"), support.on)?;
    let (&[node], Some(moved)) = (nodes, support.moved) else { return Ok(None) };
    let (direction, by) = (Vec3::from(moved.direction).normalize() * moved.by.signum(), moved.by.abs());
    for condition in conditions(scene, sets, Some(number))? {
        let along = direction.dot(&condition.direction.normalize());
        if condition.nodes.contains(&node) && along.abs() > OPPOSED {
            let path = support.at("moved");
            let message = format!(
                "node {node} is moved by {by} along a direction that another support holds; move another node, \
                                   or hold it less"
            );
            return Err(model_error(scene.source, &path, &message));
        }
    }
    Ok(Some((number, PrescribedPoint { particle: node, direction, by })))
}

/// The loads at level one; faces that a set cuts add their corners to the cells.
pub(super) fn loads(
    scene: &BodyInScene<'_>,
    density: f64,
    places: &Places,
    cells: &mut Hexahedra,
    sets: &NodeSets<'_>,
) -> Result<Vec<Load>, SceneError> {
    let mut out = Vec::new();
    for load in &scene.loads {
        let path = load.at("on");
        if let Some(force) = load.force {
            out.extend(shared(places, sets.at(&path, load.on)?, Vec3::from(force.total)));
        }
        if let Some(gravity) = load.gravity {
            out.push(Load::Body(Vec3::from(gravity.acceleration) * density));
        }
        if let Some(Traction { value, .. }) = load.traction {
            let traction = Vec3::from(value);
            out.push(match places.of_surface(scene, sets, (&path, load.on))? {
                Some(points) => Load::TractionOver { points, traction },
                None => Load::Traction { faces: places.faces(cells, sets, &path, load.on)?, traction },
            });
        }
        if let Some(pressure) = load.pressure.as_ref().map(Pressure::value) {
            out.push(match places.of_surface(scene, sets, (&path, load.on))? {
                Some(points) => Load::PressureOver { points, pressure },
                None => Load::Pressure { faces: places.faces(cells, sets, &path, load.on)?, pressure },
            });
        }
    }
    Ok(out)
}

/// A force shared by volume, at the places of nodes.
fn shared(places: &Places, nodes: &[u32], total: Vec3) -> Vec<Load> {
    let volume = |node: u32| places.block.volumes[node as usize];
    let whole: f64 = nodes.iter().map(|&node| volume(node)).sum();
    let at = |&node: &u32| Load::Point {
        place: places.block.positions[node as usize],
        force: total * (volume(node) / whole),
    };
    nodes.iter().map(at).collect()
}
