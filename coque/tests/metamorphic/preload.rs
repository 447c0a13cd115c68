//! Half of the loads before the analysis, half in it: the state of all of them at once.

use super::{common::text, difference, judge, ran};

/// Shells under loads of every kind, and how many times their loads are taken: enough that the answer is not linear.
const SCENES: [(&str, f64); 5] = [
    ("plate.toml", 10.0),
    ("hemisphere.toml", 40.0),
    ("scordelis-lo.toml", 50.0),
    ("twisted-beam.toml", 30.0),
    ("stepped-plate.toml", 5.0),
];

/// Multiplies every number.
fn times(value: &mut toml::Value, factor: f64) {
    match value {
        toml::Value::Float(number) => *number *= factor,
        toml::Value::Array(list) => list.iter_mut().for_each(|value| times(value, factor)),
        toml::Value::Table(table) => table.iter_mut().for_each(|(_, value)| times(value, factor)),
        _ => {}
    }
}

#[test]
fn loads_in_two_halves_give_the_state_of_the_whole() {
    let mut failures = Vec::new();
    for (name, factor) in SCENES {
        let mut scene = toml::Value::Table(text(name).parse().unwrap());
        scene["loads"].as_array_mut().unwrap().iter_mut().for_each(|load| times(load, factor));
        let mut split = scene.clone();
        let halves = split["loads"].as_array_mut().unwrap();
        halves.iter_mut().for_each(|load| times(load, 0.5));
        let first = halves.clone().into_iter().map(|mut load| {
            load.as_table_mut().unwrap().insert("preload".into(), true.into());
            load
        });
        halves.extend(first.collect::<Vec<_>>());
        let run = |scene: &toml::Value| {
            let statics = [("analysis", "{ static = { levels = [1.0], tolerance = 1e-11 } }")];
            let mut outcome = ran(&toml::to_string(scene).unwrap(), &statics, 1);
            // The state before the levels is not that of the other.
            outcome.curve.rows = outcome.curve.rows.split_off(outcome.curve.rows.len() - 1);
            outcome
        };
        let (whole, split) = (run(&scene), run(&split));
        assert!(split.summary.record.preload.is_some(), "{name}");
        let ones = vec![1.0; whole.curve.columns.len()];
        judge(&mut failures, "preload", name, difference(&whole, &split, &ones), 1e-10);
    }
    assert!(failures.is_empty(), "{failures:#?}");
}
