//! The examples of structures on meshes: a stiffened panel from two programs, a bracket.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::Path;

use coque::{Outcome, Scene, Silent};

/// Values of a scene and what they are replaced by.
type Replaced<'a> = &'a [(&'a str, &'a str)];

/// A scene beside its mesh, with some values replaced.
fn run(name: &str, replaced: Replaced<'_>) -> Outcome {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/meshes/{name}.toml"));
    let replaced: Vec<(String, String)> =
        replaced.iter().map(|&(path, value)| (path.into(), value.into())).collect();
    let text = fs::read_to_string(&file).unwrap();
    let scene = Scene::with_overrides(&text, &file.display().to_string(), &replaced).unwrap();
    scene.build(1).unwrap().run(&mut Silent)
}

const MODES: [(&str, &str); 2] = [("analysis", "{ modal = { modes = 5 } }"), ("curve", "[]")];
const BUCKLING: [(&str, &str); 3] = [
    ("analysis", "{ buckling = { modes = 3 } }"),
    ("curve", "[]"),
    ("loads", "[{ on = \"pushed\", force = { total = [-10e3, 0, 0] } }]"),
];

/// How far numbers are from those of elements S8R of CalculiX, extrapolated over three meshes; they have to keep within bounds \[%\].
fn near(found: &[f64], elements: &[f64], within: std::ops::Range<f64>) {
    for (number, exact) in found.iter().zip(elements) {
        let error = 100.0 * (number / exact - 1.0);
        assert!(within.contains(&error), "{number} is {error:.2} % from {exact}");
    }
}

#[test]
fn a_panel_from_gmsh_and_from_abaqus_is_one_panel() {
    let programs = ["stiffened-panel-gmsh", "stiffened-panel-abaqus"];
    // Six and twelve cells a half wave: 3 and 1 % of deflections and frequencies; twelve of the shorter waves of buckling, 5 %.
    let asked: [(Replaced<'_>, &str, &[f64], _); 3] = [
        (&[], "w_middle", &[0.3228], -4.0..-2.0),
        (&MODES, "frequency", &[184.35, 239.5, 307.1, 397.4, 398.9], -1.5..1.5),
        (&BUCKLING, "level", &[3.8197, 3.973, 4.167], 4.0..6.0),
    ];
    for (replaced, column, elements, within) in asked {
        let [one, other] = programs.map(|program| run(program, replaced));
        near(&one.curve.column(column).unwrap(), elements, within);
        // The files hold the same numbers in the same order.
        let bits =
            |outcome: &Outcome| outcome.curve.rows.concat().into_iter().map(f64::to_bits).collect::<Vec<_>>();
        assert_eq!(bits(&one), bits(&other), "{column}");
    }
}

#[test]
fn a_bracket_is_as_stiff_as_elements_find_it() {
    let linear = run("flanged-bracket", &[]);
    let last = |name: &str| *linear.curve.column(name).unwrap().last().unwrap();
    // Twelve cells across; of second order.
    near(&[last("tip_x"), last("tip_z")], &[0.774241, 0.438569], -0.2..0.0);
    let modes = run("flanged-bracket", &MODES);
    near(
        &modes.curve.column("frequency").unwrap(),
        &[35.9383, 66.9177, 105.996, 244.197, 424.229],
        -0.8..0.2,
    );
    // The hole is a polygon of 48 sides: its area is .29 % smaller than that of the circle.
    let upright = 80.0 * 120.0 - 24.0 * 20.0 * 20.0 * libm::sin(std::f64::consts::PI / 24.0);
    assert!((last("R") / (-1e-3 * upright) - 1.0).abs() < 1e-6, "{}", last("R"));
}
