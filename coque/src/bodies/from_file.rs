//! The closed surface of a body from a file, or from arrays in memory.

use std::collections::HashMap;
use std::path::Path;

use mesh_io::surface::{MeshError, Surface, read_body};
use sph_core::Vec3;

use super::Identity;
use crate::scene::Mesh;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;

/// The surface that a body names at `key`, and the file that it was read from.
///
/// # Errors
/// [`SceneError::Mesh`].
pub(super) fn surface(
    scene: &BodyInScene<'_>,
    mesh: &Mesh,
    key: &str,
) -> Result<(Surface, Identity), SceneError> {
    let Mesh { file, scale, flip } = mesh;
    let folder = Path::new(scene.source.origin()).parent().unwrap_or(Path::new(""));
    let surface = match scene.scene.surfaces.get(file) {
        Some(arrays) => arrays.surface(file, false),
        None => read_body(&folder.join(file)),
    };
    let surface = surface.map_err(|error| refused(scene, key, &error))?.scaled(scale.get());
    let surface = if *flip { surface.flipped() } else { surface };
    let identity = Identity { file: Some(surface.file.clone()), checksum: Some(surface.checksum) };
    Ok((surface, identity))
}

/// Triangles of the faces, each with the number of its face; sheets that fold are one surface again, and nodes on one place one node.
pub(crate) fn triangles(surface: &Surface) -> (Vec<[u32; 3]>, Vec<u32>) {
    let mut first = HashMap::new();
    // Adding zero makes −0 and 0 one.
    let bits = |x: &Vec3| [x.x, x.y, x.z].map(|c| (c + 0.0).to_bits());
    let place: Vec<u32> =
        (0..).zip(&surface.positions).map(|(node, x)| *first.entry(bits(x)).or_insert(node)).collect();
    let at = |node: u32| surface.positions[node as usize];
    let (mut triangles, mut faces) = (Vec::new(), Vec::new());
    for (number, face) in (0..).zip(&surface.faces) {
        let [a, b, c, d] = face.corners.map(|node| place.get(node as usize).copied().unwrap_or(node));
        if face.count == 3 {
            triangles.push([a, b, c]);
            faces.push(number);
            continue;
        }
        // Along the diagonal whose halves are both on the side of the whole, the more even ones.
        let normal = (at(c) - at(a)).cross(&(at(d) - at(b)));
        let half = |[a, b, c]: [u32; 3]| (at(b) - at(a)).cross(&(at(c) - at(a))).dot(&normal);
        let ways = [[[a, b, c], [a, c, d]], [[b, c, d], [b, d, a]]];
        let [one, other] = ways.map(|halves| half(halves[0]).min(half(halves[1])));
        triangles.extend(if other > one * (1.0 + 1e-9) { ways[1] } else { ways[0] });
        faces.extend([number; 2]);
    }
    (triangles, faces)
}

fn refused(scene: &BodyInScene<'_>, key: &str, error: &MeshError) -> SceneError {
    let mut said = error.clone();
    let repair = std::mem::take(&mut said.repair);
    let value = said.to_string();
    let value = value.trim_end_matches([';', ' ']);
    SceneError::Mesh(scene.body_scope().fault(&format!("{key}.file"), value, "a sound surface", &repair))
}
