//! Supports, loads and rows of probes in another order: the same curve but for the rounding of sums.

use super::{SCENES, common::text, difference, judge, of_the_list, ran};

/// The scene with its lists of conditions written backwards.
fn backwards(text: &str) -> String {
    let mut scene: toml::Table = text.parse().unwrap();
    for list in ["supports", "loads"] {
        if let Some(toml::Value::Array(list)) = scene.get_mut(list) {
            list.reverse();
        }
    }
    toml::to_string(&scene).unwrap()
}

#[test]
fn conditions_in_another_order_give_the_same_curve() {
    let mut failures = Vec::new();
    // Rows of load cases stand in the order of the loads (coque/tests/shells/cases.rs).
    for scene in SCENES.into_iter().filter(|(name, _)| !text(name).contains("case = ")) {
        let (one, other) = (of_the_list(scene), ran(&backwards(&text(scene.0)), scene.1, 1));
        let ones = vec![1.0; one.curve.columns.len()];
        judge(&mut failures, "order", scene.0, difference(&one, &other, &ones), 1e-9);
    }
    assert!(failures.is_empty(), "{failures:#?}");
}
