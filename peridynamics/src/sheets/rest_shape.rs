//! How the columns of a plate lie at rest: their plan, and directors along the normals.

use nalgebra::{Matrix2, Vector2};
use sph_core::{Block, Vec3};

use crate::bonds::families::Families;
use crate::error::SolidError;
use crate::formulation::Influence;

/// Greatest slope of a plate at rest: its bonds are found and weighed in the plan, two parts in a hundred shorter there.
const STEEPEST: f64 = 0.2;

/// The places of columns, projected on the plane that the plate is flat in.
pub(crate) fn plan(block: &Block) -> Vec<Vec3> {
    block.positions.iter().map(|x| Vec3::new(x.x, x.y, 0.0)).collect()
}

/// Directors `(−∂w/∂x, −∂w/∂y, 1)` of a plate whose columns stand at the heights w over the plan; slopes by least squares
/// over each family. Behind the places stand those of images.
///
/// # Errors
/// [`SolidError::Limit`] where a slope is too steep.
pub(crate) fn directors(
    places: &[Vec3],
    families: &Families,
    influence: Influence,
) -> Result<Vec<Vec3>, SolidError> {
    let slope = |node: usize| {
        let (mut squares, mut rise) = (Matrix2::zeros(), Vector2::zeros());
        for bond in families.bonds(node) {
            let to = places[bond.other] - places[node];
            let share = influence.weight(bond.length, families.reach) * families.volume(&bond);
            squares += share * to.xy() * to.xy().transpose();
            rise += share * to.z * to.xy();
        }
        squares.try_inverse().map_or(Vector2::zeros(), |inverse| inverse * rise)
    };
    let director = |node: usize| {
        let slope = slope(node);
        let steepness = slope.norm();
        if steepness <= STEEPEST {
            return Ok(Vec3::new(-slope.x, -slope.y, 1.0));
        }
        let bound = "at most 0.2: the plate is thin and nearly flat at rest";
        Err(SolidError::Limit { what: "the slope of the plate at rest", value: steepness, bound })
    };
    (0..families.len()).map(director).collect()
}
