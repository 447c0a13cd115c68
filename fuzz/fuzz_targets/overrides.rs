//! Any lines `path.to.key=value` as values replaced in a scene end in a model or in a refusal.
#![no_main]

use coque::{Rendering, Scene, SceneError, render};

/// Scenes with tables of every kind.
const SCENES: [&str; 4] = [
    include_str!("../../scenes/ring.toml"),
    include_str!("../../scenes/panel-laminated.toml"),
    include_str!("../../scenes/column-buckling.toml"),
    include_str!("../../scenes/plate.toml"),
];

libfuzzer_sys::fuzz_target!(|text: &str| {
    for scene in SCENES {
        if let Err(error) = model(scene, text) {
            let drawn = render(&error, Rendering { width: 80, colour: true });
            assert!(!drawn.is_empty() && !error.fault().repair.is_empty());
        }
    }
});

/// Builds what is small and needs no other file.
fn model(scene: &str, text: &str) -> Result<(), SceneError> {
    let pairs = text.lines().filter_map(|line| line.split_once('='));
    let replaced: Vec<_> = pairs.map(|(path, value)| (path.to_owned(), value.to_owned())).collect();
    let scene = Scene::with_overrides(scene, "fuzz.toml", &replaced)?;
    match scene.as_shell().and_then(|shell| shell.geometry.particles()) {
        Some([n1, n2]) if n1 * n2 <= 100 => scene.build(1).map(|_| ()),
        _ => Ok(()),
    }
}
