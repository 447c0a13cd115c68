//! The closed surface of a body from a file, or from arrays in memory.

use std::path::Path;

use mesh_io::surface::{MeshError, Surface, read_body};

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

fn refused(scene: &BodyInScene<'_>, key: &str, error: &MeshError) -> SceneError {
    let mut said = error.clone();
    let repair = std::mem::take(&mut said.repair);
    let value = said.to_string();
    let value = value.trim_end_matches([';', ' ']);
    SceneError::Mesh(scene.body_scope().fault(&format!("{key}.file"), value, "a sound surface", &repair))
}
