//! Other units: every number of a scene times the factor of its unit, as the page of all keys has it, gives a curve whose columns are
//! multiplied by the factors of theirs.

use std::collections::HashMap;

use super::touched::SLIDING;
use super::{SCENES, common::text, difference, judge, ran};

/// Numbers of new units in an old one: of length, force and time, as from mm, N, s to m, kN, ms, and of temperature, as from kelvins to degrees Rankine.
const FACTORS: [(&str, f64); 4] = [("L", 1e-3), ("F", 1e-3), ("T", 1e3), ("Θ", 1.8)];
/// The units by which columns are named.
const UNITS: &str = "{ length = \"mm\", force = \"N\", time = \"s\" }";
const NAMES: [(&str, &str); 4] = [("mm", "L"), ("N", "F"), ("s", "T"), ("rad", "1")];

/// The factor of a product of powers such as `F T²/L⁴`; none of what is no such product.
fn factor(unit: &str) -> Option<f64> {
    let (above, below) = unit.split_once('/').unwrap_or((unit, ""));
    let product = |words: &str| {
        words.trim_matches(['(', ')']).split_whitespace().try_fold(1.0, |product, word| {
            let power = ["", "", "²", "³", "⁴"].iter().rposition(|end| word.ends_with(end))?;
            let name = word.trim_end_matches(['²', '³', '⁴']);
            let name = NAMES.iter().find(|(unit, _)| *unit == name).map_or(name, |(_, base)| base);
            let of_one = if matches!(name, "1" | "-") {
                1.0
            } else {
                FACTORS.iter().find(|(base, _)| *base == name)?.1
            };
            Some(product * f64::powi(of_one, power.max(1) as i32))
        })
    };
    Some(product(above)? / product(below)?)
}

/// The unit of every key, by the kind of body and the path below it.
fn units() -> HashMap<(&'static str, String), String> {
    let page = include_str!("../../../docs/scene-reference.md");
    let mut kind = "";
    let mut found = HashMap::new();
    for line in page.lines() {
        kind = match line.strip_prefix("## ") {
            Some(title) if title.starts_with("A shell") => "shell",
            Some(title) if title.starts_with("A solid") => "solid",
            Some(title) if title.starts_with("At the top") => "",
            Some(_) => "other",
            None => kind,
        };
        let cells: Vec<_> = line.split('|').map(str::trim).collect();
        if let [_, key, _, _, unit, ..] = cells[..] {
            found.insert((kind, key.trim_matches('`').to_string()), unit.to_string());
        }
    }
    found
}

/// Multiplies every number by the factor of its unit.
fn scale(
    value: &mut toml::Value,
    path: &str,
    kind: &'static str,
    units: &HashMap<(&'static str, String), String>,
) {
    let find = |kind, path: &str| units.get(&(kind, path.to_string()));
    match value {
        toml::Value::Table(table) => {
            for (key, value) in table.iter_mut() {
                match path {
                    "bodies" => scale(value, "bodies.NAME", kind, units),
                    "bodies.NAME" => {
                        let kind = if key == "solid" { "solid" } else { "shell" };
                        scale(value, "", kind, units);
                    }
                    "sets" => scale(value, "sets.NAME", kind, units),
                    "" => scale(value, key, kind, units),
                    _ => scale(value, &format!("{path}.{key}"), kind, units),
                }
            }
        }
        // Rows of tables by temperature: a temperature and a factor.
        toml::Value::Array(row) if path.contains(".by_temperature.") && row[0].is_array() => {
            for pair in row.iter_mut().filter_map(toml::Value::as_array_mut) {
                let at = pair[0].as_float().or_else(|| pair[0].as_integer().map(|i| i as f64)).unwrap();
                pair[0] = toml::Value::Float(at * factor("Θ").unwrap());
            }
        }
        toml::Value::Array(list) => {
            let within = format!("{path}[]");
            for value in list {
                let tables = value.is_table();
                scale(value, if tables { &within } else { path }, kind, units);
            }
        }
        toml::Value::Float(number) => {
            let unit = find("", path).or_else(|| find(kind, path));
            *number *= unit.and_then(|unit| factor(unit)).unwrap_or(1.0);
        }
        toml::Value::Integer(number) => {
            let unit = find("", path).or_else(|| find(kind, path)).and_then(|unit| factor(unit));
            if let Some(factor) = unit.filter(|factor| *factor != 1.0) {
                *value = toml::Value::Float(*number as f64 * factor);
            }
        }
        _ => {}
    }
}

/// Puts a value at a path of keys.
fn put(table: &mut toml::Table, path: &str, value: &toml::Value) {
    match path.split_once('.') {
        None => drop(table.insert(path.into(), value.clone())),
        Some((key, rest)) => {
            let within = table.entry(key).or_insert_with(|| toml::Value::Table(toml::Table::new()));
            put(within.as_table_mut().unwrap(), rest, value);
        }
    }
}

#[test]
fn a_scene_in_other_units_gives_the_same_curve_in_those() {
    let units = units();
    assert_eq!(factor("F T²/L⁴"), Some(1e15));
    assert_eq!(factor("F/(T Θ)"), Some(1e-3 / (1e3 * 1.8)));
    let mut failures = Vec::new();
    // Numbers of a record are in units of their own, not in those that are scaled (coque/tests/runs/base.rs).
    for (name, replaced) in SCENES.into_iter().filter(|(name, _)| !text(name).contains("record = {")) {
        // What is replaced has units as well.
        let mut own: toml::Table = text(name).parse().unwrap();
        for (path, value) in replaced {
            let value: toml::Table = format!("value = {value}").parse().unwrap();
            put(&mut own, path, &value["value"]);
        }
        let mut scaled = toml::Value::Table(own.clone());
        scale(&mut scaled, "", "shell", &units);
        let of = |scene: String| ran(&scene, &[("units", UNITS)], 1);
        let (one, other) = (of(toml::to_string(&own).unwrap()), of(toml::to_string(&scaled).unwrap()));
        let of_column = |column: &coque::Column| factor(&column.unit).unwrap_or(1.0);
        let factors: Vec<_> = one.curve.columns.iter().map(of_column).collect();
        let bound = if name == "plate-on-plate.toml" { SLIDING } else { 1e-8 };
        judge(&mut failures, "units", name, difference(&one, &other, &factors), bound);
    }
    assert!(failures.is_empty(), "{failures:#?}");
}
