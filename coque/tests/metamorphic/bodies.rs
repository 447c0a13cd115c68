//! Fluids, walls and structures: in another order, with more threads, seen in a mirror.

use super::common::fluids::{DAM, GATE, PAIR, SHELL_GATE};
use super::{difference, judge, ran};

const SCENES: [(&str, &str); 4] =
    [("dam", DAM), ("gate", GATE), ("gate of a shell", SHELL_GATE), ("two gates and a sill", PAIR)];

/// The scene with its bodies in the reverse order.
fn backwards(text: &str) -> String {
    let mut parts: Vec<String> = Vec::new();
    for line in text.lines() {
        if parts.is_empty() || line.starts_with("[bodies.") {
            parts.push(String::new());
        }
        let part = parts.last_mut().unwrap();
        part.push_str(line);
        part.push('\n');
    }
    parts[1..].reverse();
    parts.concat()
}

/// Sums over neighbours run in another order, and a march lets what is left of rounding grow.
#[test]
fn bodies_in_another_order_give_the_same_curve() {
    let mut failures = Vec::new();
    for (name, text) in SCENES {
        assert_ne!(backwards(text), text);
        let (one, other) = (ran(text, &[], 1), ran(&backwards(text), &[], 1));
        let ones = vec![1.0; one.curve.columns.len()];
        judge(&mut failures, "bodies in another order", name, difference(&one, &other, &ones), 1e-9);
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn two_threads_give_the_bits_of_one() {
    for (name, text) in SCENES {
        assert_eq!(ran(text, &[], 1).curve, ran(text, &[], 2).curve, "{name}");
    }
}

/// What stands or points along x, the other way round.
fn mirrored(value: &mut toml::Value) {
    let minus = |value: &mut toml::Value| {
        let x = value.as_float().or_else(|| value.as_integer().map(|i| i as f64)).unwrap();
        *value = toml::Value::from(-x);
    };
    match value {
        toml::Value::Table(table) => {
            if let [Some(origin), Some(lengths)] = ["origin", "lengths"].map(|key| table.get(key).cloned()) {
                // A block, not a shell, which has its own axes.
                let end = origin[0].as_float().unwrap() + lengths[0].as_float().unwrap();
                table["origin"][0] = toml::Value::from(end);
            }
            if let [Some(min), Some(max)] = ["min", "max"].map(|key| table.get(key).cloned()) {
                (table["min"][0], table["max"][0]) = (max[0].clone(), min[0].clone());
            }
            for (key, value) in table.iter_mut() {
                match key.as_str() {
                    "origin" | "min" | "max" | "nearest" | "direction" => minus(&mut value[0]),
                    _ => mirrored(value),
                }
            }
        }
        toml::Value::Array(list) => list.iter_mut().for_each(mirrored),
        toml::Value::String(text) => {
            *text = match text.as_str() {
                "tank.x0" => "tank.x1".into(),
                "tank.x1" => "tank.x0".into(),
                same => same.into(),
            };
        }
        _ => {}
    }
}

#[test]
fn a_scene_in_a_mirror_gives_the_same_curve() {
    let mut failures = Vec::new();
    for (name, text) in SCENES {
        // Blocks say where they begin, so that they can begin elsewhere.
        let mut scene = toml::Value::Table(text.parse().unwrap());
        for body in scene["bodies"].as_table_mut().unwrap().iter_mut().map(|(_, body)| body) {
            let block = ["fluid", "solid"].into_iter().find(|kind| body.get(kind).is_some());
            if let Some(kind) = block {
                let block = body[kind]["geometry"]["block"].as_table_mut().unwrap();
                block.entry("origin").or_insert(toml::Value::from(vec![0.0, 0.0]));
            }
        }
        mirrored(&mut scene);
        let (one, other) = (ran(text, &[], 1), ran(&toml::to_string(&scene).unwrap(), &[], 1));
        let ones = vec![1.0; one.curve.columns.len()];
        judge(&mut failures, "in a mirror", name, difference(&one, &other, &ones), 1e-9);
    }
    assert!(failures.is_empty(), "{failures:#?}");
}
