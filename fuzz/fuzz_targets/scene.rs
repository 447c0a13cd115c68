//! Any text as a scene ends in a model or in a refusal, drawn under the text.
#![no_main]

use coque::{Rendering, Scene, SceneError, render};

libfuzzer_sys::fuzz_target!(|text: &str| {
    if let Err(error) = model(text) {
        let drawn = render(&error, Rendering { width: 80, colour: true });
        assert!(!drawn.is_empty() && !error.fault().repair.is_empty());
    }
});

/// Builds what is small and needs no other file.
fn model(text: &str) -> Result<(), SceneError> {
    let scene = Scene::parse(text, "fuzz.toml")?;
    match scene.as_shell().and_then(|shell| shell.geometry.particles()) {
        Some([n1, n2]) if n1 * n2 <= 200 => scene.build(1).map(|_| ()),
        _ => Ok(()),
    }
}
