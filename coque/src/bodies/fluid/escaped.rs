//! Fluid beyond the closed sides of basins: it leaked, or splashed over an open side.

use fluid_sph::Fluid;
use sph_core::Vec3;

use crate::scene::sets::OF_WALLS;
use crate::scene::{BodyScene, Scene, WallGeometry};

/// A basin at rest.
#[derive(Clone, Debug)]
pub(in crate::bodies) struct Sides {
    /// Its corners \[L\]; unbounded across the plane of a plane fluid.
    min: Vec3,
    max: Vec3,
    /// Which of its sides have a wall, in the order of the built-in sets.
    closed: [bool; 6],
}

/// The basins of a scene that stand; particles may be half a spacing beyond their sides.
pub(in crate::bodies) fn basins(scene: &Scene, spacing: f64) -> Vec<Sides> {
    let sides = |body: &BodyScene| {
        let BodyScene::Walls(walls) = body else { return None };
        let (WallGeometry::Basin(basin), None) = (&walls.geometry, &walls.motion) else { return None };
        let corner =
            |list: &[f64], beyond: f64| {
                Vec3::from([0, 1, 2].map(|axis| {
                    list.get(axis).map_or(beyond * f64::INFINITY, |x| x + 0.5 * beyond * spacing)
                }))
            };
        let closed = |side: usize| basin.open.iter().all(|open| open != OF_WALLS[side + 1]);
        let (min, max) = (corner(&basin.min, -1.0), corner(&basin.max, 1.0));
        Some(Sides { min, max, closed: [0, 1, 2, 3, 4, 5].map(closed) })
    };
    scene.bodies.values().filter_map(sides).collect()
}

/// Particles behind a closed side of any basin: what left by an open side is not lost.
pub(in crate::bodies) fn lost(fluid: &Fluid, basins: &[Sides]) -> usize {
    let behind = |x: &Vec3, Sides { min, max, closed }: &Sides| {
        (0..6).any(|side| {
            let axis = side / 2;
            let past = if side % 2 == 0 { x[axis] < min[axis] } else { x[axis] > max[axis] };
            let beside =
                (0..3).all(|other| other == axis || (min[other] <= x[other] && x[other] <= max[other]));
            closed[side] && past && beside
        })
    };
    let here = fluid.positions().iter().enumerate().filter(|(i, _)| fluid.is_here(*i));
    here.filter(|(_, x)| basins.iter().any(|basin| behind(x, basin))).count()
}
