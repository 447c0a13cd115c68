//! Heat of shells in a scene: what it does in each analysis, what is said, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::sync::Arc;

use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, last, overridden, run, text};
use coque::{Ended, Outcome, Rendering, Scene, Silent, WarningKind, render};

fn done(outcome: Outcome) -> Outcome {
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    assert!(outcome.summary.record.warnings.is_empty(), "{:?}", outcome.summary.record.warnings);
    outcome
}

/// αE/(1 − ν) of the plate \[Pa/K\].
const PRESSES: f64 = 23e-6 * 70e9 / 0.7;
const PLATE: &str = "heated-plate.toml";
const STRIP: &str = "bimetal-strip.toml";
const COLUMNS: (&str, &str) = (
    "curve",
    "[{ name = \"n\", of = \"membrane-force\", on = \"all\", direction = [1, 0, 0] },
      { name = \"s\", of = \"stress\", face = \"top\", on = \"all\", direction = [1, 0, 0] },
      { name = \"w\", of = \"displacement\", on = \"all\", direction = [0, 0, 1] }]",
);

/// Between walls nothing moves, whatever looks for balance, and forces, face stresses and what is stored are those of the closed form.
#[test]
fn a_plate_between_walls_bears_its_heat_in_every_analysis() {
    let change = ("loads[0].temperature", "{ change = 2.0, difference = 3.0 }");
    let coarse = ("geometry.plate.particles", "[9, 9]");
    let clamped = ["supports[0]", "supports[1]", "supports[2]", "supports[3]"];
    let edges = ["u0", "u1", "v0", "v1"].map(|on| format!("{{ on = \"{on}\", clamped = {{}} }}"));
    for analysis in [
        "{ static = { levels = 2 } }",
        "{ static = { levels = 2, one_solve = true } }",
        "{ arc-length = { until = 1.0 } }",
        "{ relaxation = { levels = 2 } }",
        "{ linear = {} }",
        "{ linear = { solver = \"conjugate-gradients\" } }",
    ] {
        let mut replaced = vec![change, coarse, COLUMNS, ("analysis", analysis)];
        replaced.extend(clamped.into_iter().zip(edges.iter().map(String::as_str)));
        let found = done(run(PLATE, &replaced));
        let [n, s] = [-PRESSES * 2.0 * 0.004, -PRESSES * (2.0 + 1.5)];
        assert!((last(&found, "n") / n - 1.0).abs() < 1e-9, "{analysis}: {}", last(&found, "n"));
        assert!((last(&found, "s") / s - 1.0).abs() < 1e-9, "{analysis}: {}", last(&found, "s"));
        assert!(last(&found, "w").abs() < 1e-12, "{analysis}: {}", last(&found, "w"));
        // ½ ᾱθ·Q̄ᾱθ through the thickness, by area.
        let stored = 0.25 * PRESSES * 23e-6 * 0.004 * (2.0 * 2.0 + 3.0 * 3.0 / 12.0);
        assert!(
            (last(&found, "internal") / stored - 1.0).abs() < 1e-9,
            "{analysis}: {}",
            last(&found, "internal")
        );
    }
}

/// Heat of a preload is there before the plate swings: ω² falls straight to zero at the critical change.
#[test]
fn a_plate_that_is_heated_first_sings_lower() {
    let modes = ("analysis", "{ modal = { modes = 1 } }");
    let change = |change: &'static str| ("loads[0].temperature.change", change);
    let square = |outcome: Outcome| column(&done(outcome), "frequency")[0].powi(2);
    let cold = square(run(PLATE, &[modes, ("loads[0].preload", "true"), change("0.0")]));
    let warm = square(run(PLATE, &[modes, ("loads[0].preload", "true"), change("1.760465")]));
    // Half of the critical change; .2 % of that is the lattice's.
    assert!((warm / cold - 0.5).abs() < 2e-3, "{}", warm / cold);
}

/// Beside a load of the level the heat of a preload stays as it is, and both at once lead to the same state.
#[test]
fn heated_first_or_together_the_strip_ends_alike() {
    let force = ("loads[+]", "{ on = \"u1\", force = { total = [0, 0, -0.2] } }");
    let first = done(run(STRIP, &[force, ("loads[0].preload", "true")]));
    let together = done(run(STRIP, &[force]));
    let alone = last(&done(run(STRIP, &[])), "w_end");
    let [first, together] = [&first, &together].map(|run| last(run, "w_end"));
    assert!(
        (first / together - 1.0).abs() < 1e-9 && (first / alone - 1.0).abs() > 0.1,
        "{first} {together} {alone}"
    );
}

/// A plate with a slight bow bulges on as it is heated beyond its critical change; relaxation and arc length find what levels find.
#[test]
fn a_bowed_plate_bulges_alike_on_every_way() {
    let bowed = |analysis: &'static str| {
        let bow = ("imperfection", "{ mode = 1, amplitude = 0.0004 }");
        let change = ("loads[0].temperature.change", "6.0");
        let lattice = ("geometry.plate.particles", "[13, 13]");
        let middle = ("sets", "{ middle = { nearest = [0.25, 0.25, 0.0] } }");
        let columns =
            ("curve", "[{ name = \"w\", of = \"displacement\", on = \"middle\", direction = [0, 0, 1] }]");
        last(&done(run(PLATE, &[lattice, bow, change, middle, columns, ("analysis", analysis)])), "w")
    };
    let levels = bowed("{ static = { levels = 4 } }");
    let arc = bowed("{ arc-length = { until = 1.0 } }");
    let relaxed = bowed("{ relaxation = { levels = 4 } }");
    println!("{levels} {arc} {relaxed}");
    assert!(levels.abs() > 2e-3 && (arc / levels - 1.0).abs() < 1e-6, "{levels} {arc}");
    assert!((relaxed / levels - 1.0).abs() < 1e-4, "{relaxed} {levels}");
}

/// Let go under its heat a strip swings about where it comes to rest, and keeps its energy.
#[test]
fn a_strip_that_is_heated_at_once_swings() {
    let lattice = ("geometry.plate.particles", "[21, 3]");
    let slight = ("loads[0].temperature.change", "5.0");
    let at_rest = last(&done(run(STRIP, &[lattice, slight])), "w_end");
    // A period of the first bending mode is .03 s.
    let transient = ("analysis", "{ explicit = { transient = { duration = 0.06, record_every = 1e-3 } } }");
    let marched = done(run(STRIP, &[lattice, slight, transient]));
    let found = column(&marched, "w_end");
    let most = found.iter().fold(0.0_f64, |most, w| most.max(w / at_rest));
    println!("{most} {}", found.iter().sum::<f64>() / found.len() as f64 / at_rest);
    assert!((most - 2.0).abs() < 0.1, "{most}");
}

/// Half a plate with a mirror is half of the whole: its critical change, and the shape of a heated corner.
#[test]
fn half_a_plate_buckles_as_the_whole() {
    let whole = last(&done(run(PLATE, &[("geometry.plate.particles", "[21, 21]")])), "level");
    let half = [
        ("geometry.plate", "{ lengths = [0.25, 0.5], particles = [11, 21] }"),
        ("supports[1]", "{ on = \"u1\", symmetry = { normal = [1, 0, 0] } }"),
    ];
    let half = last(&done(run(PLATE, &half)), "level");
    assert!((half / whole - 1.0).abs() < 1e-9, "{half} {whole}");
}

/// A heated strip that is stopped goes on to the same bits, at rest and in time.
#[test]
fn a_heated_strip_goes_on_to_the_same_bits() {
    let lattice = ("geometry.plate.particles", "[21, 3]");
    let transient = ("analysis", "{ explicit = { transient = { duration = 0.01, record_every = 1e-3 } } }");
    stopped_again_and_again("heated-in-time", &text(STRIP), &[lattice, transient], 3);
    stopped_again_and_again("heated-at-rest", &text(STRIP), &[lattice, ("analysis.static.levels", "8")], 2);
}

/// In the mirror of its plane a strip has its plies the other way round, and bends the other way; half of a heat twice is all of it.
#[test]
fn mirrored_it_bends_the_other_way_and_halves_add_up() {
    let plies = "[{ thickness = 0.0005, angle = 0.0 }, { thickness = 0.0005, angle = 0.0, material = { elastic = \
                 { young = 100e9, poisson = 0.3, density = 8500.0, expansion = 19e-6 } } }]";
    let alone = done(run(STRIP, &[]));
    let mirrored = done(run(STRIP, &[("section.layered.plies", plies)]));
    let halves = [
        ("loads[0].temperature", "{ change = 50.0 }"),
        ("loads[+]", "{ on = \"all\", temperature = { change = 50.0 } }"),
    ];
    let halves = done(run(STRIP, &halves));
    for name in ["turn", "w_end"] {
        let [alone, mirrored, halves] = [&alone, &mirrored, &halves].map(|run| last(run, name));
        assert!((mirrored / alone + 1.0).abs() < 1e-9, "{name}: {mirrored} {alone}");
        assert!((halves / alone - 1.0).abs() < 1e-12, "{name}: {halves} {alone}");
    }
}

/// Changes at particles multiply the change of the load, in a cell by their mean.
#[test]
fn numbers_by_particle_multiply_the_change() {
    let named = |name: &str| {
        let heat = format!("{{ change = 2.0, difference = 3.0, values = \"{name}\" }}");
        let edges = ["u0", "u1", "v0", "v1"].map(|on| format!("{{ on = \"{on}\", clamped = {{}} }}"));
        let mut replaced = vec![
            ("loads[0].temperature", heat.as_str()),
            ("geometry.plate.particles", "[9, 9]"),
            COLUMNS,
            ("analysis", "{ linear = {} }"),
        ];
        replaced.extend(
            ["supports[0]", "supports[1]", "supports[2]", "supports[3]"]
                .into_iter()
                .zip(edges.iter().map(String::as_str)),
        );
        let mut scene: Scene = overridden(&text(PLATE), PLATE, &replaced).unwrap().into_scene();
        scene.arrays.insert("twice".into(), Arc::new(vec![2.0; 81]));
        scene.check().and_then(|checked| checked.build(1))
    };
    let twice = done(named("twice").unwrap().run(&mut Silent));
    assert!((last(&twice, "s") / (-2.0 * PRESSES * 3.5) - 1.0).abs() < 1e-9, "{}", last(&twice, "s"));
    let Err(error) = named("none") else { panic!("an array that is not there is not refused") };
    assert!(render(&error, Rendering { width: 200, colour: false }).contains("loads[0].temperature.values"));
}

#[test]
fn strains_that_are_not_small_are_reported() {
    let hot = run(
        PLATE,
        &[
            ("geometry.plate.particles", "[5, 5]"),
            ("material.elastic.expansion", "23e-3"),
            ("loads[0].temperature.change", "2.0"),
        ],
    );
    let warned: Vec<_> = hot.summary.record.warnings.iter().map(|warning| warning.kind).collect();
    assert!(warned.contains(&WarningKind::LargeStrain), "{warned:?}");
}

#[test]
fn what_makes_no_sense_is_refused() {
    let cases: &[(&str, Replaced, &str)] = &[
        (PLATE, &[("loads[0].temperature", "{}")], "`change`, `difference`, both, or `conducted`"),
        (PLATE, &[("loads[0].temperature.change", "1e300")], "loads[0].temperature.change"),
        (PLATE, &[("material.elastic.expansion", "1e-300")], "material.elastic.expansion"),
        (PLATE, &[("loads[0].on", "\"al\"")], "loads[0].on"),
        (PLATE, &[("loads[0].on", "\"u0\"")], "no cell lies between its particles"),
        (
            PLATE,
            &[("material", "{ elastic = { young = 70e9, poisson = 0.3, density = 2700.0 } }")],
            "no coefficient of expansion",
        ),
        (
            STRIP,
            &[(
                "section.layered.plies[0].material",
                "{ elastic = { young = 70e9, poisson = 0.3, density = 2700.0 } }",
            )],
            "of plies to each of theirs",
        ),
        (PLATE, &[("formulation", "{ nodal = {} }")], "strains are sampled in cells"),
        (
            PLATE,
            &[("analysis", "{ explicit = { quasi-static = { levels = 1, period = 1.0 } } }")],
            "use [analysis.static]",
        ),
        (
            PLATE,
            &[
                ("analysis", "{ explicit = { transient = { duration = 1.0, record_every = 1.0 } } }"),
                ("loads[0].amplitude", "{ ramp = 1.0 }"),
            ],
            "loads[0].amplitude",
        ),
        (
            PLATE,
            &[
                ("analysis", "{ static = { levels = 1 } }"),
                ("curve", "[{ name = \"U\", of = \"energy\", on = \"all\" }]"),
            ],
            "column `internal`",
        ),
        (
            PLATE,
            &[
                ("analysis", "{ static = { levels = 1 } }"),
                (
                    "material",
                    "{ plastic = { young = 1e9, poisson = 0.3, density = 1.0, hardening = { linear = { yield-stress = 1e6, slope = 0.0 } } } }",
                ),
            ],
            "plasticity or rubber",
        ),
        (
            "plate-solid.toml",
            &[("loads[0]", "{ on = \"z1\", temperature = { change = 1.0 } }")],
            "a Galerkin solid is warmed as a whole",
        ),
    ];
    for (name, replaced, says) in cases {
        let scene = overridden(&text(name), name, replaced).and_then(|scene| scene.build(1));
        let Err(error) = scene else { panic!("{replaced:?} is not refused") };
        let shown = render(&error, Rendering { width: 200, colour: false });
        assert!(shown.contains(says), "{says} is not in\n{shown}");
    }
}
