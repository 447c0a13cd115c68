//! Forces on a surface as the nodes behind it bear them.
//!
//! Nodes lie inside the body. On the nearest one a force on the surface would do the work of a smaller body, a part of the spacing over the
//! radius of curvature too little. A force at x before the node at x₀ is spread over the nodes beside that by the shape functions φ of moving least
//! squares there, which reproduce linear fields, and their gradients:
//!
//! ```text
//! wᵢ = φᵢ(x₀) + (x − x₀)·∇φᵢ(x₀)      Σ wᵢ = 1     Σ wᵢ xᵢ = x
//! ```
//!
//! Its resultant, its moment and its work in any uniform strain are those on the surface. Weights are linear in x: a triangle that is cut in
//! pieces bears the same.

use std::collections::BTreeMap;

use super::Facet;
use crate::Vec3;
use crate::block::Block;
use crate::sampling::moving_least_squares::{Basis, MovingLeastSquares, PointShape, Support, Weight};

/// Radii within which nodes take part, in spacings: the first that has enough of them, not in a plane.
const REACHES: [f64; 2] = [2.0, 3.0];
/// Distance of a node from a plane of symmetry below which it is its own image, in spacings.
const ON_PLANE: f64 = 1e-9;

/// What nodes bear of forces on a surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spread {
    /// Forces on nodes, ascending \[F\].
    pub forces: Vec<(u32, Vec3)>,
    /// What of them goes through each plane of symmetry at once, along its axis, since nodes behind it bear it \[F\].
    pub through: Vec<f64>,
}

/// A node, or an image of one.
#[derive(Clone, Copy)]
struct Image {
    node: u32,
    /// What becomes of components of vectors.
    signs: [f64; 3],
    /// Planes in which it is mirrored, a bit each.
    planes: u8,
}

/// Spreads forces on facets over the nodes of a block; where the body is one layer thick the node of a facet bears it alone.
///
/// `mirrors` are planes of symmetry, each the axis that it is normal to and where it cuts it: images of nodes behind them take part, and what they
/// bear is that of the nodes, mirrored.
pub fn spread(block: &Block, mirrors: &[(usize, f64)], forces: &[(Facet, Vec3)]) -> Spread {
    let (places, images) = with_images(block, mirrors);
    let nets = nets(&places, block.greatest_spacing());
    let at = |node: u32| nets.iter().find_map(|net| net.at(&places[node as usize]).ok());
    let mut shapes = BTreeMap::<u32, Option<PointShape>>::new();
    let mut sums = BTreeMap::<u32, Vec3>::new();
    let mut through = vec![0.0; mirrors.len()];
    for (facet, force) in forces {
        let Some(shape) = shapes.entry(facet.node).or_insert_with(|| at(facet.node)) else {
            *sums.entry(facet.node).or_default() += force;
            continue;
        };
        let before = facet.place - places[facet.node as usize];
        for ((number, value), slope) in shape.nodes.iter().zip(&shape.values).zip(&shape.gradients) {
            let weight = value + before.dot(&Vec3::from(*slope));
            let Image { node, signs, planes } = images[*number as usize];
            *sums.entry(node).or_default() += Vec3::from_fn(|k, _| signs[k] * force[k] * weight);
            for (plane, &(axis, _)) in mirrors.iter().enumerate() {
                if planes >> plane & 1 == 1 && signs[axis] < 0.0 {
                    through[plane] += 2.0 * weight * force[axis];
                }
            }
        }
    }
    Spread { forces: sums.into_iter().collect(), through }
}

/// Shape functions over nodes, those of the narrower reach first.
pub(super) fn nets(places: &[Vec3], spacing: f64) -> Vec<MovingLeastSquares> {
    let net = |reach: f64| {
        MovingLeastSquares::new(places, Basis::Linear, Support::sphere(reach * spacing), Weight::Csrbf2)
    };
    REACHES.iter().filter_map(|&reach| net(reach).ok()).collect()
}

/// Places of the nodes, and behind them of their images within reach of planes of symmetry.
fn with_images(block: &Block, mirrors: &[(usize, f64)]) -> (Vec<Vec3>, Vec<Image>) {
    let spacing = block.greatest_spacing();
    let mut places = block.positions.clone();
    let own = |node: u32| Image { node, signs: [1.0; 3], planes: 0 };
    let mut images: Vec<Image> = (0..block.len() as u32).map(own).collect();
    for (number, &(axis, plane)) in mirrors.iter().enumerate() {
        for source in 0..places.len() {
            let (mut place, mut image) = (places[source], images[source]);
            let away = (place[axis] - plane).abs() / spacing;
            if away > ON_PLANE && away < 2.0 * REACHES[1] {
                place[axis] = 2.0 * plane - place[axis];
                image.signs[axis] = -image.signs[axis];
                image.planes |= 1 << number;
                places.push(place);
                images.push(image);
            }
        }
    }
    (places, images)
}
