//! A rigid turn of geometry, conditions and probes together: the same curve.

use super::{SCENES, common::text, difference, judge, of_the_list, ran};

#[test]
fn a_scene_that_is_turned_gives_the_same_curve() {
    let mut failures = Vec::new();
    // `orientation` is a key of a shell alone; two shells are turned in touched.rs.
    for scene in SCENES.into_iter().filter(|(name, _)| !text(name).contains("[bodies.")) {
        let mut replaced = scene.1.to_vec();
        replaced.push(("orientation", "{ axis = [1.0, 2.0, -0.7], degrees = 37.0 }"));
        let (still, turned) = (of_the_list(scene), ran(&text(scene.0), &replaced, 1));
        let ones = vec![1.0; still.curve.columns.len()];
        judge(&mut failures, "turned", scene.0, difference(&still, &turned, &ones), 1e-8);
    }
    assert!(failures.is_empty(), "{failures:#?}");
}
