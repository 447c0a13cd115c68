//! Scenes of the repository on other meshes than those of their files.

use std::fmt::Write;
use std::fs;
use std::sync::atomic::{AtomicU32, Ordering};

use coque::{Rendering, Scene, Silent, render};
use sph_core::Vec3;

use super::meshes::Mesh;
use crate::Outcome;

/// A set of nodes by its name, and what belongs to it.
pub type Set<'a> = (&'a str, &'a dyn Fn(&Vec3) -> bool);

/// Runs a scene whose mesh is replaced, with sets of nodes, and other values replaced.
///
/// # Errors
/// What refuses the scene, in words.
pub fn on_mesh(text: &str, mesh: &Mesh, sets: &[Set<'_>], set: &[(&str, &str)]) -> Result<Outcome, String> {
    static NUMBER: AtomicU32 = AtomicU32::new(0);
    let number = NUMBER.fetch_add(1, Ordering::Relaxed);
    let file = std::env::temp_dir().join(format!("coque-mesh-{}-{number}.inp", std::process::id()));
    fs::write(&file, abaqus(mesh, sets).map_err(|error| error.to_string())?)
        .map_err(|error| error.to_string())?;
    let mut replaced: Vec<(String, String)> =
        set.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
    replaced.push(("geometry.mesh.file".into(), format!("{:?}", file.display().to_string())));
    let built = Scene::with_overrides(text, "scene on a mesh", &replaced).and_then(|scene| scene.build(1));
    let how = Rendering { width: 110, colour: false };
    let found = built.map(|model| model.run(&mut Silent).into()).map_err(|error| render(&error, how));
    // Each load case has read it by now; a file that cannot be removed is one of the system's to remove.
    let _ = fs::remove_file(&file);
    found
}

/// The mesh as Abaqus writes it.
fn abaqus(mesh: &Mesh, sets: &[Set<'_>]) -> Result<String, std::fmt::Error> {
    let mut text = String::from("*NODE\n");
    for (number, place) in (1..).zip(&mesh.places) {
        writeln!(text, "{number}, {}, {}, {}", place.x, place.y, place.z)?;
    }
    text.push_str("*ELEMENT, TYPE=S4, ELSET=FACES\n");
    for (number, face) in (1..).zip(&mesh.faces) {
        write!(text, "{number}")?;
        face.iter().try_for_each(|corner| write!(text, ", {}", corner + 1))?;
        text.push('\n');
    }
    for (name, belongs) in sets {
        writeln!(text, "*NSET, NSET={name}")?;
        let own = (1..).zip(&mesh.places).filter(|(_, place)| belongs(place));
        own.map(|(number, _): (u32, _)| number).try_for_each(|number| writeln!(text, "{number}"))?;
    }
    Ok(text)
}
