//! Named sets of particles of a fluid and of places of walls.

use sph_core::Vec3;

use super::walls::Piece;
use crate::bodies::sets::{Declared, inside};
use crate::scene::Region;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;

/// Particles of the set that the scene of a fluid alone names.
///
/// # Errors
/// [`SceneError::Set`] for a declared set without particles.
pub(in crate::bodies) fn of_fluid(
    scene: &BodyInScene<'_>,
    name: &str,
    positions: &[Vec3],
    spacing: f64,
) -> Result<Vec<u32>, SceneError> {
    let all = || (0..positions.len() as u32).collect();
    let Some(region) = scene.sets.get(name) else { return Ok(all()) };
    let pick = |region: &Region| inside(region, positions, spacing);
    Declared { scene, positions, own: &|_, _| Ok(all()), pick: &pick }.one(name, region)
}

/// What a name means on walls.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::bodies) struct OnWalls {
    /// Its particles: piece of the body, and number in it; of built-in sets those next to the fluid.
    pub particles: Vec<(usize, usize)>,
    /// Pieces that it takes whole; none of declared sets.
    pub pieces: Vec<usize>,
    /// The point that a set of one nearest particle was declared by \[L\].
    pub point: Option<Vec3>,
}

/// The set that the scene of walls alone names.
///
/// # Errors
/// [`SceneError::Set`] for a declared set without particles.
pub(in crate::bodies) fn of_walls(
    scene: &BodyInScene<'_>,
    name: &str,
    pieces: &[Piece],
    spacing: f64,
) -> Result<OnWalls, SceneError> {
    let numbered = || {
        let of = |(piece, of): (usize, &'_ Piece)| (0..of.points.len()).map(move |a| (piece, a));
        pieces.iter().enumerate().flat_map(of)
    };
    let taken = |name: &str| -> Vec<usize> {
        let taken = pieces.iter().enumerate().filter(|(_, piece)| name == "all" || piece.side == Some(name));
        taken.map(|(number, _)| number).collect()
    };
    let first =
        |taken: &[usize], (piece, a): (usize, usize)| taken.contains(&piece) && pieces[piece].first[a];
    let Some(region) = scene.sets.get(name) else {
        let pieces = taken(name);
        let particles = numbered().filter(|&at| first(&pieces, at)).collect();
        return Ok(OnWalls { particles, pieces, point: None });
    };
    let positions: Vec<Vec3> = pieces.iter().flat_map(|piece| piece.points.iter().copied()).collect();
    let own = |_: &str, name: &str| {
        let taken = taken(name);
        Ok((0..).zip(numbered()).filter(|&(_, at)| first(&taken, at)).map(|(a, _)| a).collect())
    };
    let pick = |region: &Region| inside(region, &positions, spacing);
    let found = Declared { scene, positions: &positions, own: &own, pick: &pick }.one(name, region)?;
    let all: Vec<(usize, usize)> = numbered().collect();
    let particles = found.into_iter().map(|a| all[a as usize]).collect();
    Ok(OnWalls { particles, pieces: Vec::new(), point: region.nearest.map(Vec3::from) })
}
