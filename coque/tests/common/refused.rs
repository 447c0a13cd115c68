//! What is refused of broken scenes, as a user reads it.

use coque::{Rendering, Scene, render};

/// Reads and builds a scene after each replacement of one text by another; renders what is refused.
pub fn refused(text: &str, cases: &[(&str, &str, &str)]) -> String {
    let mut all = String::new();
    for (name, from, to) in cases {
        assert!(text.contains(from), "{name}: the scene no longer says {from}");
        let scene = Scene::parse(&text.replacen(from, to, 1), "scene.toml");
        let said = match scene.and_then(|scene| scene.build(1)) {
            Ok(_) => "not refused".into(),
            Err(error) => render(&error, Rendering { width: 100, colour: false }),
        };
        all.push_str(&format!("━━━ {name} ━━━\n{}\n", said.trim_end()));
    }
    assert!(!all.contains("not refused"), "{all}");
    all
}
