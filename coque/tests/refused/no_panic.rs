//! Whatever is done to a scene, reading it ends in a scene or in a refusal, never in a panic.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::Path;

use crate::common::fluids::{DAM, GATE, SHELL_GATE};
use crate::common::galerkin;
use crate::common::solids::{BAR, PLATE, SHEETS};
use coque::scene::bounded::Positive;
use coque::scene::{BodyScene, FluidGeometry, RigidGeometry, WallGeometry};
use coque::{Checked, Rendering, Scene, SceneError, render};
use proptest::prelude::*;

const SCENES: [&str; 5] =
    ["ring.toml", "panel.toml", "panel-laminated.toml", "patch-test.toml", "cantilever-end-shear.toml"];

/// Numbers that break things.
const NUMBERS: [&str; 16] = [
    "nan",
    "-inf",
    "-1",
    "0",
    "0.0",
    "1e400",
    "1e308",
    "-1e-320",
    "1e30",
    "1e-30",
    "1e60",
    "1e-60",
    "9223372036854775807",
    "2",
    "-0.0",
    "3.5",
];

/// Scenes of files and, after them, small ones of solids and of fluids.
fn scene(number: usize) -> String {
    let more = [BAR, PLATE, SHEETS, DAM, GATE, SHELL_GATE, galerkin::BAR, galerkin::ARC];
    if let Some(small) = number.checked_sub(SCENES.len()) {
        return more[small % more.len()].into();
    }
    let name = SCENES[number];
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name)).unwrap()
}

fn drawn(error: &SceneError) -> String {
    render(error, Rendering { width: 80, colour: true })
}

#[derive(Clone, Debug)]
enum Damage {
    /// Drops a line.
    Line(usize),
    /// Puts a number in the place of another one.
    Number(usize, usize),
    /// Swaps two neighbouring letters.
    Letters(usize),
    /// Doubles a line.
    Double(usize),
    /// Cuts the text off.
    Cut(usize),
}

fn damage() -> impl Strategy<Value = Damage> {
    prop_oneof![
        3 => any::<usize>().prop_map(Damage::Line),
        6 => (any::<usize>(), any::<usize>()).prop_map(|(at, which)| Damage::Number(at, which)),
        3 => any::<usize>().prop_map(Damage::Letters),
        1 => any::<usize>().prop_map(Damage::Double),
        1 => any::<usize>().prop_map(Damage::Cut),
    ]
}

fn apply(text: &str, damage: &Damage) -> String {
    let mut lines: Vec<&str> = text.lines().collect();
    match *damage {
        Damage::Line(at) if !lines.is_empty() => {
            lines.remove(at % lines.len());
            lines.join("\n")
        }
        Damage::Double(at) if !lines.is_empty() => {
            let at = at % lines.len();
            lines.insert(at, lines[at]);
            lines.join("\n")
        }
        Damage::Number(at, which) => replace_number(text, at, NUMBERS[which % NUMBERS.len()]),
        Damage::Letters(at) if text.len() > 2 => {
            let mut letters: Vec<char> = text.chars().collect();
            let at = at % (letters.len() - 1);
            letters.swap(at, at + 1);
            letters.into_iter().collect()
        }
        Damage::Cut(at) => text.chars().take(at % text.chars().count().max(1)).collect(),
        _ => text.into(),
    }
}

/// Replaces one run of number characters outside comments.
fn replace_number(text: &str, at: usize, by: &str) -> String {
    let part = |c: char| c.is_ascii_digit() || ".-+e".contains(c);
    let mut runs = Vec::new();
    let mut line_start = 0;
    for line in text.split_inclusive('\n') {
        let code = line.split('#').next().unwrap_or_default();
        let mut start = None;
        for (i, c) in code.char_indices().chain([(code.len(), ' ')]) {
            match start {
                None if c.is_ascii_digit() || c == '-' => start = Some(i),
                Some(from) if !part(c) => {
                    runs.push((line_start + from)..(line_start + i));
                    start = None;
                }
                _ => {}
            }
        }
        line_start += line.len();
    }
    match runs.get(at % runs.len().max(1)) {
        Some(run) => format!("{}{by}{}", &text[..run.start], &text[run.end..]),
        None => text.into(),
    }
}

/// Whether a body is built in a moment.
fn is_small(scene: &Checked, body: &BodyScene) -> bool {
    let spacing = scene.fluid().map_or(1.0, |(_, fluid)| fluid.geometry.spacing());
    match body {
        BodyScene::Shell(shell) => shell.geometry.particles().is_some_and(|[n1, n2]| n1 * n2 <= 500),
        BodyScene::Solid(solid) => match &solid.geometry.block {
            Some(block) => {
                let along = |(axis, length): (usize, &Positive)| length.get() / block.spacing.along(axis);
                block.lengths.iter().enumerate().map(along).product::<f64>() <= 500.0
            }
            None => solid.geometry.arc.is_some_and(|arc| arc.cells.iter().product::<usize>() <= 500),
        },
        BodyScene::Fluid(fluid) => match &fluid.geometry {
            FluidGeometry::Block(block) => {
                block.lengths.iter().map(|length| length.get() / spacing).product::<f64>() <= 500.0
            }
            _ => false,
        },
        BodyScene::Walls(walls) => match &walls.geometry {
            WallGeometry::Basin(basin) => {
                basin.min.iter().zip(&basin.max).all(|(min, max)| (max - min) / spacing <= 100.0)
            }
            _ => false,
        },
        BodyScene::Rigid(rigid) => match &rigid.geometry {
            RigidGeometry::Ball(ball) => ball.radius.get() / ball.spacing.get() <= 5.0,
            RigidGeometry::Box(own) => (0..3).all(|k| (own.max[k] - own.min[k]) / own.spacing.get() <= 10.0),
            RigidGeometry::Mesh(_) => true,
        },
    }
}

proptest! {
    // The same scenes on every run.
    #![proptest_config(ProptestConfig {
        cases: 2048,
        rng_seed: proptest::test_runner::RngSeed::Fixed(1),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn damaged_scenes_never_panic(number in 0..SCENES.len() + 6, damages in prop::collection::vec(damage(), 1..4)) {
        let text = damages.iter().fold(scene(number), |text, damage| apply(&text, damage));
        match Scene::parse(&text, "damaged.toml") {
            Ok(scene) => {
                let small = scene.bodies.values().all(|body| is_small(&scene, body));
                let built = if small { scene.build(1).map(|_| ()) } else { Ok(()) };
                if let Err(error) = built {
                    prop_assert!(!drawn(&error).is_empty());
                }
            }
            Err(error) => {
                let fault = error.fault();
                let inside = fault.place.span.clone().is_none_or(|s| s.end <= fault.place.text.len());
                prop_assert!(inside, "{fault:?}");
                prop_assert!(!fault.repair.is_empty());
                prop_assert!(!drawn(&error).is_empty());
            }
        }
    }

    #[test]
    fn any_override_never_panics(path in "[a-z.\\[\\]0-9-]{0,30}", value in "\\PC{0,20}") {
        let refused = Scene::with_overrides(&scene(0), "ring.toml", &[(path, value)]);
        if let Err(error) = refused {
            prop_assert!(!drawn(&error).is_empty());
        }
    }

    /// A text in place of a number, of what expressions and amounts are made of, in quotes of either kind.
    #[test]
    fn texts_for_numbers_never_panic(text in "([-+*/^() ,.]|[$][{]t[}]|pi|min|sqrt|mm|deg|é|[0-9]{1,3}|1e9){0,12}", raw in any::<bool>()) {
        let quote = if raw { "'" } else { "\"" };
        let value = format!("{quote}{text}{quote}");
        let replaced = [
            ("parameters".to_string(), "{ t = 2.0 }".to_string()),
            ("section.homogeneous.thickness".to_string(), value),
        ];
        if let Err(error) = Scene::with_overrides(&scene(0), "ring.toml", &replaced) {
            let fault = error.fault();
            let inside = fault.place.span.clone().is_none_or(|s| s.end <= fault.place.text.len());
            prop_assert!(inside && !drawn(&error).is_empty(), "{fault:?}");
        }
    }
}
