//! Fluid beyond the closed sides of basins: it leaked, or splashed over an open side.

use fluid_sph::Fluid;
use sph_core::Vec3;

use crate::scene::sets::OF_WALLS;
use crate::scene::{BodyScene, Scene, WallGeometry};

/// The closed sides of a basin at rest.
#[derive(Clone, Debug)]
pub(in crate::bodies) struct Sides {
    /// By side, in the order of the built-in sets: how far along its axis the fluid may be \[L\]; none of open sides.
    closed: [Option<f64>; 6],
}

/// The basins of a scene that stand; particles may be half a spacing beyond their sides.
pub(in crate::bodies) fn basins(scene: &Scene, spacing: f64) -> Vec<Sides> {
    let sides = |body: &BodyScene| {
        let BodyScene::Walls(walls) = body else { return None };
        let (WallGeometry::Basin(basin), None) = (&walls.geometry, &walls.motion) else { return None };
        let closed = |side: usize| {
            let open = basin.open.iter().any(|open| open == OF_WALLS[side + 1]);
            let at = if side % 2 == 0 {
                basin.min.get(side / 2)? - 0.5 * spacing
            } else {
                basin.max.get(side / 2)? + 0.5 * spacing
            };
            (!open).then_some(at)
        };
        Some(Sides { closed: [0, 1, 2, 3, 4, 5].map(closed) })
    };
    scene.bodies.values().filter_map(sides).collect()
}

/// Particles beyond a closed side of any basin.
pub(in crate::bodies) fn lost(fluid: &Fluid, basins: &[Sides]) -> usize {
    let beyond = |x: &Vec3| {
        let past = |(side, at): (usize, &Option<f64>)| match at {
            Some(at) if side % 2 == 0 => x[side / 2] < *at,
            Some(at) => x[side / 2] > *at,
            None => false,
        };
        basins.iter().any(|basin| basin.closed.iter().enumerate().any(past))
    };
    fluid.positions().iter().filter(|x| beyond(x)).count()
}
