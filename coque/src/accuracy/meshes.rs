//! Finer meshes beside that of a scene: each face cut into four, once or twice.

use std::path::Path;
use std::sync::Arc;

use super::refined::Refined;
use crate::mesh::{MeshError, Surface, read};
use crate::scene::{Analysis, Checked, Scene};

/// Nodes up to which a mesh is cut twice, into sixteen times as many; a march is not, which takes four times the steps as well.
const TWICE: usize = 2000;

/// The scene on meshes of half the spacing and, where that is cheap, a quarter of it; `alone` is what is to be run on them.
///
/// # Errors
/// In words: meshes that are points, that are tied, or whose sections are those of the file; what no cloud can be made of.
pub(super) fn finer(scene: &Checked, alone: &Scene) -> Result<Vec<Refined>, String> {
    let Some((file, mut surface)) = surface(scene)? else { return Ok(Vec::new()) };
    let marched = matches!(scene.analysis, Analysis::Explicit(_));
    let times = if surface.positions.len() <= TWICE && !marched { 2 } else { 1 };
    let mut finer = Vec::new();
    for time in 1..=times {
        let arrays = surface.refined();
        surface = arrays.surface(&file, false).map_err(refused)?;
        let mut refined = alone.clone();
        let nodes = arrays.points.len();
        refined.surfaces.insert(file.clone(), Arc::new(arrays));
        let refined = refined.check().map_err(|error| format!("the finer mesh is refused: {error}"))?;
        let spacing = 1.0 / f64::from(1 << time);
        finer.push(Refined { scene: refined, spacing, lattice: format!("mesh of {nodes} nodes") });
    }
    Ok(finer)
}

/// The surface of the one shell, with the name of its file; none where it is a lattice.
///
/// # Errors
/// In words: what cannot be refined.
pub(super) fn surface(scene: &Checked) -> Result<Option<(String, Surface)>, String> {
    let shell = scene.as_shell();
    let Some((shell, mesh)) = shell.and_then(|shell| Some((shell, shell.geometry.mesh()?))) else {
        return Ok(None);
    };
    if !shell.ties.is_empty() {
        return Err(
            "the mesh is tied to edges that do not match it, and is not refined; mesh it finer and run both"
                .into(),
        );
    }
    let surface = match scene.surfaces.get(&mesh.file) {
        Some(arrays) => arrays.surface(&mesh.file, false).map_err(refused)?,
        None => {
            let folder = Path::new(scene.source.origin()).parent().unwrap_or(Path::new(""));
            read(&folder.join(&mesh.file)).map_err(refused)?
        }
    };
    if surface.faces.is_empty() {
        return Err(
            "points without faces are not refined; give a mesh of faces, or run point clouds of two spacings"
                .into(),
        );
    }
    if !surface.sections.is_empty() {
        return Err("a mesh with sections of its file is not refined; give them as [material] and [section], or mesh it finer".into());
    }
    Ok(Some((mesh.file.clone(), surface)))
}

fn refused(error: MeshError) -> String {
    format!("the mesh cannot be refined: {error}")
}
