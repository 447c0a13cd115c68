//! Forces on a surface as the nodes behind it bear them.
//!
//! Nodes lie inside the body. On the nearest one a force on the surface would do the work of a smaller body, a part of the spacing over the
//! radius of curvature too little. It is spread over the nodes near its place x by weights that reproduce linear fields,
//!
//! ```text
//! Σ φᵢ(x) = 1     Σ φᵢ(x) xᵢ = x
//! ```
//!
//! moving least squares, so that its resultant, its moment and its work in any uniform strain are those on the surface.

use std::collections::BTreeMap;

use super::Facet;
use crate::Vec3;
use crate::block::Block;
use crate::sampling::moving_least_squares::{Basis, MovingLeastSquares, ShapeError, Support, Weight};

/// Radii within which nodes take part, in spacings: the first that has enough of them, not in a plane.
const REACHES: [f64; 2] = [2.0, 3.0];
/// Distance of a node from a plane of symmetry below which it is its own image, in spacings.
const ON_PLANE: f64 = 1e-9;

/// A node, or an image of one: its number, and what becomes of components of vectors.
type Image = (u32, [f64; 3]);

/// Forces on facets as forces on nodes, ascending \[F\]; where the body is one layer thick the node of a facet bears it alone.
///
/// `mirrors` are planes of symmetry, each the axis that it is normal to and where it cuts it: images of nodes behind them take part, and what they
/// bear is that of the nodes, mirrored.
pub fn spread(block: &Block, mirrors: &[(usize, f64)], forces: &[(Facet, Vec3)]) -> Vec<(u32, Vec3)> {
    let (places, images) = with_images(block, mirrors);
    let shapes = REACHES.map(|reach| shapes(&places, reach * block.greatest_spacing()));
    let mut sums = BTreeMap::<u32, Vec3>::new();
    for (facet, force) in forces {
        let at = |shapes: &Result<MovingLeastSquares, ShapeError>| shapes.as_ref().ok()?.at(&facet.place).ok();
        let Some(shape) = shapes.iter().find_map(at) else {
            *sums.entry(facet.node).or_default() += force;
            continue;
        };
        for (number, value) in shape.nodes.iter().zip(&shape.values) {
            let (node, signs) = images[*number as usize];
            *sums.entry(node).or_default() += Vec3::from_fn(|k, _| signs[k] * force[k] * value);
        }
    }
    sums.into_iter().collect()
}

fn shapes(places: &[Vec3], reach: f64) -> Result<MovingLeastSquares, ShapeError> {
    MovingLeastSquares::new(places, Basis::Linear, Support::sphere(reach), Weight::Csrbf2)
}

/// Places of the nodes, and behind them of their images within reach of planes of symmetry.
fn with_images(block: &Block, mirrors: &[(usize, f64)]) -> (Vec<Vec3>, Vec<Image>) {
    let spacing = block.greatest_spacing();
    let mut places = block.positions.clone();
    let mut images: Vec<Image> = (0..block.len() as u32).map(|node| (node, [1.0; 3])).collect();
    for &(axis, plane) in mirrors {
        for number in 0..places.len() {
            let (mut place, (node, mut signs)) = (places[number], images[number]);
            let away = (place[axis] - plane).abs() / spacing;
            if away > ON_PLANE && away < 2.0 * REACHES[1] {
                place[axis] = 2.0 * plane - place[axis];
                signs[axis] = -signs[axis];
                places.push(place);
                images.push((node, signs));
            }
        }
    }
    (places, images)
}
