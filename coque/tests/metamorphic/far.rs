//! Far away: bodies ten thousand lengths from zero give the same curves as near it. Meshes: meshes.rs.

use super::common::fluids::{DAM, GATE, PAIR, SHELL_GATE};
use super::common::galerkin::BAR as GALERKIN;
use super::common::solids::BAR as BONDS;
use super::{difference, judge, ran};

/// Every place of a scene moved; of blocks that do not say where they begin, they begin there.
fn moved(value: &mut toml::Value, by: [f64; 3]) {
    let shift = |value: &mut toml::Value| {
        for (x, by) in value.as_array_mut().unwrap().iter_mut().zip(by) {
            *x = toml::Value::from(x.as_float().or_else(|| x.as_integer().map(|i| i as f64)).unwrap() + by);
        }
    };
    match value {
        toml::Value::Table(table) => {
            for (key, value) in table.iter_mut() {
                match key.as_str() {
                    "origin" | "min" | "max" | "nearest" | "point" | "at" => shift(value),
                    "block" => {
                        let block = value.as_table_mut().unwrap();
                        let zero = vec![0.0; block["lengths"].as_array().unwrap().len()];
                        block.entry("origin").or_insert(toml::Value::from(zero));
                        shift(&mut block["origin"]);
                    }
                    _ => moved(value, by),
                }
            }
        }
        toml::Value::Array(list) => list.iter_mut().for_each(|value| moved(value, by)),
        _ => {}
    }
}

/// Curves near zero and far away; columns of places move with the body.
fn hold(
    failures: &mut Vec<String>,
    name: &str,
    text: &str,
    analysis: Option<&str>,
    (length, bound): (f64, f64),
) {
    let mut scene: toml::Value = toml::Value::Table(text.parse().unwrap());
    if let Some(columns) = scene.get_mut("curve").and_then(toml::Value::as_array_mut) {
        columns.retain(|column| !matches!(column["of"].as_str(), Some("position" | "level")));
    }
    let replaced: Vec<(&str, &str)> = analysis.map(|analysis| ("analysis", analysis)).into_iter().collect();
    let near = ran(&toml::to_string(&scene).unwrap(), &replaced, 1);
    let plane = name.starts_with("dam") || name.starts_with("gate");
    // No multiple of a spacing, no sum that is exact.
    moved(&mut scene, [9013.7 * length, -4177.3 * length, if plane { 0.0 } else { 3511.9 * length }]);
    let far = ran(&toml::to_string(&scene).unwrap(), &replaced, 1);
    let ones = vec![1.0; near.curve.columns.len()];
    judge(failures, "far away", name, difference(&near, &far, &ones), bound);
}

/// Places have twelve digits there. At rest displacements keep theirs: nine and more. In a march bonds are stretched by what places lack, and
/// pressures answer it by the square of the speed of sound over that of the waves: up to 6e-9 of forces and energies were measured.
#[test]
fn bodies_far_away_give_the_same_curve() {
    let mut failures = Vec::new();
    let transient = "{ explicit = { transient = { duration = 5.0, record_every = 1.0 } } }";
    let across = |text: &str| {
        let loaded = text.replace("value = [1.0, 0.0, 0.0]", "value = [0.0, 0.0, 1e-4]");
        loaded.replace("direction = [1.0, 0.0, 0.0]", "direction = [0.0, 0.0, 1.0]")
    };
    for (name, text, analysis, scale) in [
        ("bonds", across(BONDS), Some("{ linear = {} }"), (4.0, 1e-9)),
        ("bonds, at levels", across(BONDS), Some("{ static = { levels = 2 } }"), (4.0, 1e-9)),
        ("bonds in time", across(BONDS), Some(transient), (4.0, 2e-8)),
        ("Galerkin", GALERKIN.to_string(), None, (2.0, 1e-9)),
        ("dam", DAM.to_string(), None, (0.2, 1e-8)),
        ("gate of bonds", GATE.to_string(), None, (0.2, 1e-8)),
        ("gate of a shell", SHELL_GATE.to_string(), None, (0.2, 1e-8)),
        ("gates that touch", PAIR.to_string(), None, (0.2, 1e-8)),
    ] {
        hold(&mut failures, name, &text, analysis, scale);
    }
    assert!(failures.is_empty(), "{failures:#?}");
}
