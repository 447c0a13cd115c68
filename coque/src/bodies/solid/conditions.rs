//! Supports, loads, columns and the velocity at the start of a solid.

use peridynamics::{AppliedLoad, FollowingPressure, Mirror, Solid, SolidError, Support, Supported};
use sph_core::{Block, BlockLattice, Facet, Spread, Vec3, spread};

use super::sets::NodeSets;
use crate::bodies::rigid::Hold;
use crate::bodies::{PrescribedPoint, Probe};
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::error::SceneError;
use crate::scene::sets::OF_SOLIDS;
use crate::scene::{Held, Measured, Moved, OnNodes, SolidScene, Traction};

/// A held direction with more than this along a motion opposes it.
const OPPOSED: f64 = 1e-9;
/// A normal this close to an axis is that of a face.
const SQUARE: f64 = 1e-9;

/// The loads of a solid.
pub(super) struct Loads {
    /// Forces on nodes.
    pub loads: Vec<AppliedLoad>,
    /// What of a load, by its number, goes through a plane of symmetry at once, on the face before it.
    pub passed: Vec<(usize, Vec<(u32, Vec3)>)>,
}

/// A motion that becomes a force that is sought.
pub(super) struct Driver {
    /// Number of its support.
    support: usize,
    node: u32,
    moved: Moved,
}

/// All that drives an analysis by levels, if it is the motion of one node. Every other motion is prescribed.
pub(super) fn driver(scene: &BodyInScene<'_>, sets: &NodeSets<'_>) -> Result<Option<Driver>, SceneError> {
    let Some(support) = scene.sole_motion() else { return Ok(None) };
    let nodes = sets.at(&scene.supports[support].at("on"), scene.supports[support].on)?;
    let moved = scene.supports[support].moved;
    Ok(moved.and_then(|moved| match nodes {
        &[node] => Some(Driver { support, node, moved }),
        _ => None,
    }))
}

impl Driver {
    /// The node and its motion; what else holds it must not oppose that.
    ///
    /// # Errors
    /// [`SolidError::Contradiction`].
    pub fn point(&self, others: &[Supported]) -> Result<PrescribedPoint, SolidError> {
        let Self { node, moved, .. } = *self;
        let (direction, by) = (Vec3::from(moved.direction).normalize() * moved.by.signum(), moved.by.abs());
        for Supported { nodes, support } in others {
            let Support::Held { displacement, .. } = support else { continue };
            let along = displacement.iter().map(|held| direction.dot(&held.normalize()));
            let opposed = along.fold(0.0, |most: f64, along| most.max(along.abs()));
            if nodes.contains(&node) && opposed > OPPOSED {
                return Err(SolidError::Contradiction { node, wanted: opposed * by });
            }
        }
        Ok(PrescribedPoint { particle: node, direction, by })
    }
}

/// The supports, but that of the motion that is sought.
pub(super) fn supports(
    scene: &BodyInScene<'_>,
    directors: bool,
    sets: &NodeSets<'_>,
    driver: Option<&Driver>,
) -> Result<Vec<Supported>, SceneError> {
    let mut supports = Vec::new();
    for (_, support) in
        scene.supports.iter().enumerate().filter(|(i, _)| driver.is_none_or(|driver| driver.support != *i))
    {
        let nodes = sets.at(&support.at("on"), support.on)?;
        for condition in support.kinds().iter().filter_map(|(_, kind)| kind.on_nodes()) {
            let support = match condition {
                // Planes of symmetry mirror the bonds, and hold what lies on them.
                OnNodes::Symmetry(_) => continue,
                OnNodes::Held(Held { displacement, director }) => Support::Held {
                    displacement: vectors(&displacement),
                    director: if directors { vectors(&director) } else { Vec::new() },
                },
                OnNodes::Moved(moved) => Support::Moved {
                    direction: Vec3::from(moved.direction),
                    by: moved.by,
                    amplitude: support.amplitude.clone().unwrap_or_default(),
                },
                OnNodes::Turned(turned) => Support::Turned {
                    axis: Vec3::from(turned.axis),
                    point: Vec3::from(turned.point),
                    by: turned.by.to_radians(),
                    amplitude: support.amplitude.clone().unwrap_or_default(),
                },
            };
            supports.push(Supported { nodes: nodes.to_vec(), support });
        }
    }
    Ok(supports)
}

fn vectors(list: &[[f64; 3]]) -> Vec<Vec3> {
    list.iter().map(|&v| Vec3::from(v)).collect()
}

/// What supports hold of rigid motions; of a plane block also what its plane does.
pub(super) fn holds(
    solid: &SolidScene,
    supports: &[Supported],
    block: &Block,
    mirrors: &[Mirror],
) -> Vec<Hold> {
    let mut all = Vec::new();
    if solid.is_plane() {
        all.extend([Hold::Displacement(0, Vec3::z()), Hold::Turn(Vec3::x()), Hold::Turn(Vec3::y())]);
    }
    for &Mirror { axis, at } in mirrors {
        // A plane keeps all of a body from moving along its normal, and from turning but about it.
        let normal = Vec3::ith(axis, 1.0);
        let nearest = |x: &Vec3| (x[axis] - at).abs();
        let nodes = (0..block.len() as u32).min_by(|&a, &b| {
            nearest(&block.positions[a as usize]).total_cmp(&nearest(&block.positions[b as usize]))
        });
        all.extend(nodes.map(|node| Hold::Displacement(node, normal)));
        all.extend([1, 2].map(|k| Hold::Turn(Vec3::ith((axis + k) % 3, 1.0))));
    }
    for Supported { nodes, support } in supports {
        for &node in nodes {
            match support {
                Support::Held { displacement, director } => {
                    all.extend(displacement.iter().map(|e| Hold::Displacement(node, e.normalize())));
                    // A director that keeps its component along n, at rest along z, does not turn about z × n.
                    all.extend(director.iter().map(|n| Hold::Turn(Vec3::z().cross(&n.normalize()))));
                }
                Support::Moved { direction, .. } => all.push(Hold::Displacement(node, direction.normalize())),
                Support::Turned { .. } => {
                    all.extend([0, 1, 2].map(|k| Hold::Displacement(node, Vec3::ith(k, 1.0))));
                    // A director that is prescribed does not turn by itself.
                    if solid.has_directors() {
                        all.extend([Hold::Turn(Vec3::x()), Hold::Turn(Vec3::y())]);
                    }
                }
            }
        }
    }
    all
}

/// The loads as forces on nodes \[F\].
pub(super) fn loads(
    scene: &BodyInScene<'_>,
    density: f64,
    block: &Block,
    sets: &NodeSets<'_>,
    mirrors: &[Mirror],
) -> Result<Loads, SceneError> {
    let planes: Vec<(usize, f64)> = mirrors.iter().map(|&Mirror { axis, at }| (axis, at)).collect();
    let on_surface = |facets: Vec<Facet>, force: &dyn Fn(&Vec3) -> Vec3| {
        let forces: Vec<(Facet, Vec3)> =
            facets.into_iter().map(|facet| (facet, force(&facet.area))).collect();
        spread(block, &planes, &forces)
    };
    let on_nodes = |forces| Spread { forces, through: Vec::new() };
    let (mut loads, mut passed) = (Vec::new(), Vec::new());
    for load in &scene.loads {
        let nodes = sets.at(&load.at("on"), load.on)?;
        let force = load.force.iter().map(|force| by_volume(block, nodes, Vec3::from(force.total)));
        let gravity = load.gravity.iter().map(|gravity| {
            let acceleration = Vec3::from(gravity.acceleration);
            let weight = |&node: &u32| (node, acceleration * (density * block.volumes[node as usize]));
            nodes.iter().map(weight).collect()
        });
        let by_area = load.traction.as_ref().is_some_and(|own| own.depth.is_none())
            || load.pressure.as_ref().is_some_and(|own| !own.follower);
        if by_area && sets.facets(load.on, nodes, &planes).is_some_and(|facets| facets.is_empty()) {
            let bound = "but nothing of the surface lies at its nodes";
            let repair =
                "use `surface`, x0 to z1, a group of the file, or a region that holds a part of the surface";
            let fault = sets.scene().source.fault(&load.at("on"), &format!("\"{}\"", load.on), bound, repair);
            return Err(SceneError::Set(fault));
        }
        let traction = load.traction.iter().map(|traction| match sets.facets(load.on, nodes, &planes) {
            Some(facets) if traction.depth.is_none() => {
                on_surface(facets, &|area| Vec3::from(traction.value) * area.norm())
            }
            _ => on_nodes(tractions(block, sets, load.on, traction)),
        });
        let dead = load.pressure.iter().filter(|pressure| !pressure.follower);
        let pressure = dead.map(|pressure| match sets.facets(load.on, nodes, &planes) {
            Some(facets) => on_surface(facets, &|area| area * -pressure.value()),
            None => on_nodes(pressures(sets, load.on, pressure.value())),
        });
        for Spread { forces, through } in force.chain(gravity).map(on_nodes).chain(traction).chain(pressure) {
            let borne = mirrors.iter().zip(through).filter(|(_, force)| *force != 0.0);
            passed.extend(borne.map(|(mirror, force)| (loads.len(), before(block, mirror, force))));
            loads.push(AppliedLoad { forces, amplitude: load.amplitude.clone().unwrap_or_default() });
        }
    }
    Ok(Loads { loads, passed })
}

/// Pressures that follow the surface that nodes fill.
pub(super) fn following(
    scene: &BodyInScene<'_>,
    sets: &NodeSets<'_>,
) -> Result<Vec<FollowingPressure>, SceneError> {
    let mut out = Vec::new();
    for load in &scene.loads {
        let Some(pressure) = load.pressure.as_ref().filter(|pressure| pressure.follower) else { continue };
        if !sets.names(load.on) {
            let bound = "which is no part of the surface with a name; only such parts have borders that a pressure can follow";
            let repair = "use `surface`, x0 to z1, or a group of the file, or remove `follower`";
            let fault = sets.scene().source.fault(&load.at("on"), &format!("\"{}\"", load.on), bound, repair);
            return Err(SceneError::Set(fault));
        }
        out.extend(sets.carried(load.on).map(|surface| FollowingPressure {
            surface,
            pressure: pressure.value(),
            amplitude: load.amplitude.clone().unwrap_or_default(),
        }));
    }
    Ok(out)
}

/// A force through a plane of symmetry, along its axis, by area on the nodes of the face before it.
fn before(block: &Block, mirror: &Mirror, force: f64) -> Vec<(u32, Vec3)> {
    let apart = |face: &[(u32, f64)]| {
        let distance =
            |(node, _): &(u32, f64)| (block.positions[*node as usize][mirror.axis] - mirror.at).abs();
        face.iter().map(distance).fold(f64::INFINITY, f64::min)
    };
    let [lower, upper] = [&block.faces[2 * mirror.axis], &block.faces[2 * mirror.axis + 1]];
    let face = if apart(lower) <= apart(upper) { lower } else { upper };
    let whole: f64 = face.iter().map(|(_, area)| area).sum();
    face.iter().map(|&(node, area)| (node, Vec3::ith(mirror.axis, force * area / whole))).collect()
}

/// The planes of symmetry: faces of the block.
///
/// # Errors
/// [`SceneError::Choice`] for a set that is no whole face, or another normal than that of the face.
pub(super) fn mirrors(
    scene: &BodyInScene<'_>,
    lattice: &BlockLattice,
    sets: &NodeSets<'_>,
) -> Result<Vec<Mirror>, SceneError> {
    let mut mirrors = Vec::new();
    for support in &scene.supports {
        let Some(symmetry) = support.symmetry else { continue };
        let nodes = sets.at(&support.at("on"), support.on)?;
        let normal = Vec3::from(symmetry.normal).normalize();
        let face = (0..2 * lattice.dimensions).find(|&face| {
            let of_face = sets.face(OF_SOLIDS[1 + face]);
            normal[face / 2].abs() > 1.0 - SQUARE
                && of_face.len() == nodes.len()
                && of_face.iter().zip(nodes).all(|((a, _), b)| a == b)
        });
        let Some(face) = face else {
            let path = support.at("symmetry");
            let found =
                format!("a plane of symmetry normal to {:?} through `{}`", symmetry.normal, support.on);
            let bound =
                "a whole face of the block, normal to it: bonds reach across to the image of the body";
            let repair =
                "use on = \"x0\" to \"z1\"; held = { displacement = [[…]] } holds a set and mirrors nothing";
            return Err(SceneError::Choice(scene.source.fault(&path, &found, bound, repair)));
        };
        let (axis, upper) = (face / 2, (face % 2) as f64);
        mirrors.push(Mirror { axis, at: lattice.origin[axis] + upper * lattice.lengths[axis] });
    }
    Ok(mirrors)
}

/// A force shared by volume.
fn by_volume(block: &Block, nodes: &[u32], total: Vec3) -> Vec<(u32, Vec3)> {
    let whole: f64 = nodes.iter().map(|&node| block.volumes[node as usize]).sum();
    nodes.iter().map(|&node| (node, total * (block.volumes[node as usize] / whole))).collect()
}

/// A force by area on the outermost nodes of a face, or the same force spread over the layer under it.
fn tractions(block: &Block, sets: &NodeSets<'_>, face: &str, traction: &Traction) -> Vec<(u32, Vec3)> {
    let (value, shares) = (Vec3::from(traction.value), sets.face(face));
    match traction.depth {
        None => shares.iter().map(|&(node, area)| (node, value * area)).collect(),
        Some(depth) => {
            let area: f64 = shares.iter().map(|(_, area)| area).sum();
            by_volume(block, &sets.layer(face, depth.get()), value * area)
        }
    }
}

/// A dead pressure on the outermost nodes of a face, against its outward normal.
fn pressures(sets: &NodeSets<'_>, face: &str, value: f64) -> Vec<(u32, Vec3)> {
    let inward = inward(face).unwrap_or_default();
    sets.face(face).iter().map(|&(node, area)| (node, inward * (value * area))).collect()
}

/// Against the outward normal of a face.
pub(super) fn inward(face: &str) -> Option<Vec3> {
    let number = OF_SOLIDS[1..].iter().position(|known| *known == face)?;
    Some(Vec3::ith(number / 2, if number % 2 == 0 { 1.0 } else { -1.0 }))
}

/// The columns of the curve.
pub(in crate::bodies) fn probes(
    scene: &BodyInScene<'_>,
    sets: &NodeSets<'_>,
) -> Result<Vec<Probe>, SceneError> {
    let probe = |column: &OnSet<'_, crate::scene::Probe>| {
        let mut nodes = sets.at(&column.at("on"), column.on)?.to_vec();
        if column.of == Measured::Pieces {
            nodes.truncate(1); // it is counted once, of the whole body
        }
        let direction = column.direction.map_or_else(Vec3::zeros, |v| Vec3::from(v).normalize());
        Ok(Probe::of_column(scene.scene, column, nodes, direction))
    };
    scene.curve.iter().map(probe).collect()
}

/// Gives nodes the velocity of the scene, `v + ω × (x − p)`; what is held stays at rest.
pub(super) fn set_out(scene: &SolidScene, solid: &mut Solid) {
    let Some(velocity) = &scene.velocity else { return };
    let linear = Vec3::from(velocity.linear.unwrap_or_default());
    let (spin, point) = velocity.spin.map_or_else(Default::default, |spin| {
        (Vec3::from(spin.axis).normalize() * spin.rate, Vec3::from(spin.point))
    });
    for node in 0..solid.len() {
        let about: Vec3 = solid.position(node) - point;
        solid.set_velocity(node, linear + spin.cross(&about));
    }
}
