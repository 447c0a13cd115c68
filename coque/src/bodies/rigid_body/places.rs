//! The surface of a rigid body, and its named sets.

use std::collections::BTreeMap;

use rigid_body::{Outline, ball, cuboid};
use sph_core::{Cell, Vec3};

use crate::bodies::Identity;
use crate::bodies::from_file::surface;
use crate::bodies::sets::{Declared, inside};
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{Region, RigidGeometry};

/// The surface that a scene gives, and the file that it was read from.
pub(super) fn outline(
    scene: &BodyInScene<'_>,
    geometry: &RigidGeometry,
) -> Result<(Outline, Identity), SceneError> {
    match geometry {
        RigidGeometry::Ball(own) => {
            Ok((ball(own.centre, own.radius.get(), own.spacing.get()), Identity::default()))
        }
        RigidGeometry::Box(own) => Ok((cuboid(own.min, own.max, own.spacing.get()), Identity::default())),
        RigidGeometry::Mesh(mesh) => {
            let (surface, identity) = surface(scene, mesh, "geometry.mesh")?;
            Ok((joined(&surface.positions, &surface.faces), identity))
        }
    }
}

/// One surface of sheets that meet in folds, where each has nodes of its own: nodes on one place are one vertex.
fn joined(places: &[Vec3], faces: &[Cell]) -> Outline {
    let (mut numbers, mut vertices) = (BTreeMap::new(), Vec::new());
    // Adding zero makes −0 and 0 one.
    let bits = |x: &Vec3| [x.x, x.y, x.z].map(|c| (c + 0.0).to_bits());
    let mut number = |x: &Vec3| {
        *numbers.entry(bits(x)).or_insert_with(|| {
            vertices.push(*x);
            vertices.len() as u32 - 1
        })
    };
    let new: Vec<u32> = places.iter().map(&mut number).collect();
    let at = |corner: u32| new.get(corner as usize).copied().unwrap_or(corner);
    let cells = faces.iter().map(|face| Cell { corners: face.corners.map(at), count: face.count }).collect();
    Outline { vertices, cells }
}

/// The sets of a rigid body by name: the body itself at its centre, and vertices that regions pick.
///
/// # Errors
/// [`SceneError::Set`] for a region without vertices.
pub(super) fn sets(
    scene: &BodyInScene<'_>,
    rest: &[Vec3],
    spacing: f64,
) -> Result<BTreeMap<String, Vec<u32>>, SceneError> {
    let centre = rest.len() as u32 - 1;
    let vertices = &rest[..centre as usize];
    let pick = |region: &Region| inside(region, vertices, spacing);
    // The body itself, at its centre.
    let own = |_: &str, _: &str| Ok(vec![centre]);
    let mut all = Declared { scene, positions: vertices, own: &own, pick: &pick }.all()?;
    all.insert("all".into(), vec![centre]);
    Ok(all)
}

/// Mean length of the edges of a surface \[L\].
pub(super) fn spacing(outline: &Outline) -> f64 {
    let ends = outline.cells.iter().flat_map(|cell| cell.edges());
    let lengths: Vec<f64> =
        ends.map(|(a, b)| (outline.vertices[b as usize] - outline.vertices[a as usize]).norm()).collect();
    lengths.iter().sum::<f64>() / lengths.len().max(1) as f64
}
