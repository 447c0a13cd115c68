//! Initial stresses and strain measures of parts in a scene: what they do in each analysis, what is said, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{Replaced, column, last, overridden, ran, run, text};
use coque::{Ended, Outcome, Rendering, WarningKind, render};

fn done(outcome: Outcome) -> Outcome {
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

fn warned(outcome: &Outcome) -> Vec<WarningKind> {
    outcome.summary.record.warnings.iter().map(|warning| warning.kind).collect()
}

/// Held by its edges nothing moves before the plate swings, and no preload is found; an edge that is let go takes its part of the tension away.
#[test]
fn a_stress_in_balance_needs_no_preload_and_one_that_is_not_does() {
    let held = done(run("tensioned-plate.toml", &[]));
    assert!(held.summary.record.preload.is_none() && warned(&held).is_empty(), "{:?}", warned(&held));
    assert!((column(&held, "frequency")[0] / 149.18 - 1.0).abs() < 3e-3);
    let line = "initial stress of all, balanced before the analysis".to_string();
    assert!(held.summary.body.modelled.contains(&line));
    let free = ["supports[1]", "supports[2]", "supports[3]"].map(|s| format!("{s}.held.displacement"));
    let free = free.each_ref().map(|path| (path.as_str(), "[[0, 1, 0], [0, 0, 1]]"));
    let [one, two, three] = free;
    let given_way =
        done(run("tensioned-plate.toml", &[one, two, three, ("material.elastic.poisson", "0.0")]));
    let preload = given_way.summary.record.preload.clone().unwrap();
    // The edge goes in until nothing pulls along x: ½ σ²/E by volume is gone.
    let relief = -0.5 * 30e6_f64.powi(2) / 70e9 * 0.5 * 0.4 * 0.002;
    assert!((preload.internal / relief - 1.0).abs() < 2e-3, "{preload:?} {relief}");
    let across = done(run(
        "tensioned-plate.toml",
        &[("initial_stress[0].membrane", "[0.0, 15e6, 0.0]"), ("material.elastic.poisson", "0.0")],
    ));
    let [a, b] = [&given_way, &across].map(|run| column(run, "frequency")[0]);
    // The shortened plate is a ten-thousandth smaller.
    assert!((a / b - 1.0).abs() < 2e-3, "{a} {b}");
}

/// The level counts a stress that nothing accompanies; beside a load it is found before.
#[test]
fn a_strip_rolls_up_by_level_or_before_a_load() {
    let rolled = done(run("relieved-strip.toml", &[]));
    assert!(rolled.summary.record.preload.is_none());
    let radius = 1.0 / std::f64::consts::PI;
    assert!((last(&rolled, "w_end") / -radius - 1.0).abs() < 2e-4, "{}", last(&rolled, "w_end"));
    assert!(last(&rolled, "stress") < 1.0, "{}", last(&rolled, "stress"));
    // ½ M₀²/D by area.
    let stored = -0.5 * 200e9 * 0.001_f64.powi(3) / 12.0 * std::f64::consts::PI.powi(2) * 0.025;
    assert!(
        (last(&rolled, "internal") / stored - 1.0).abs() < 1e-6,
        "{} {stored}",
        last(&rolled, "internal")
    );
    let load = ("loads", "[{ on = \"u1\", force = { total = [0, 0, 1e-3] } }]");
    let energy = ("curve[+]", "{ name = \"U\", of = \"energy\", on = \"all\" }");
    let pushed = done(run("relieved-strip.toml", &[load, energy, ("analysis.static.levels", "1")]));
    assert_eq!(pushed.summary.record.preload.as_ref().unwrap().negative_pivots, 0);
    assert!((column(&pushed, "w_end")[0] / -radius - 1.0).abs() < 2e-4);
    // Nearly all of it is the strips', the control's is not in the column.
    assert!((column(&pushed, "U")[0] / column(&pushed, "internal")[0] - 1.0).abs() < 1e-6);
}

/// Pressed from within, a plate buckles at the level at which its stress is critical; beyond it, that is reported.
#[test]
fn a_stress_alone_buckles_by_level() {
    let pressed: Replaced =
        &[("initial_stress[0].membrane", "[-1e6, -1e6, 0.0]"), ("analysis", "{ buckling = { modes = 1 } }")];
    let level = last(&done(run("tensioned-plate.toml", pressed)), "level");
    let pi = std::f64::consts::PI;
    let bending = 70e9 * 0.002_f64.powi(3) / 12.0 / 0.91;
    let exact = bending * ((pi / 0.5).powi(2) + (pi / 0.4).powi(2)) / (0.002 * 1e6);
    assert!((level / exact - 1.0).abs() < 5e-3, "{level} {exact}");
    let beyond = format!("[{0}, {0}, 0.0]", -1.05e6 * level);
    let over = run("tensioned-plate.toml", &[("initial_stress[0].membrane", &beyond)]);
    assert_eq!(warned(&over), [WarningKind::Unstable]);
    assert_eq!(column(&over, "frequency").iter().filter(|&&f| f == 0.0).count(), 1);
}

/// In real time the shell springs from where it is drawn, and damped comes to rest where statics finds it.
#[test]
fn a_march_sets_out_of_balance_and_says_so() {
    let slight = ("initial_stress[0].bending", "[-3e6, 0.0, 0.0]");
    let at_rest = last(&done(run("relieved-strip.toml", &[slight])), "w_end");
    let lattice = ("geometry.plate.particles", "[21, 3]");
    // A few periods of .31 s, damped nearly to the creeping of the first mode.
    let march =
        ("analysis", "{ explicit = { transient = { duration = 0.8, record_every = 0.1, damping = 35.0 } } }");
    let marched = done(run("relieved-strip.toml", &[slight, lattice, march]));
    assert_eq!(warned(&marched), [WarningKind::NotAtRest]);
    let found = last(&marched, "w_end");
    println!("{found} {at_rest}");
    assert!((found / at_rest - 1.0).abs() < 1e-2, "{found} {at_rest}");
    let held = "{ explicit = { transient = { duration = 1e-4, record_every = 1e-4 } } }";
    let still = done(run("tensioned-plate.toml", &[("analysis", held)]));
    assert!(warned(&still).is_empty(), "{:?}", warned(&still));
}

#[test]
fn patterns_among_the_modes_are_reported() {
    let thin = ("section.homogeneous.thickness", "1e-5");
    let modes = |count: &'static str| ("analysis.modal.modes", count);
    assert!(warned(&done(run("tensioned-plate.toml", &[thin, modes("10")]))).is_empty());
    let reported = done(run("tensioned-plate.toml", &[thin, modes("20")]));
    assert_eq!(warned(&reported), [WarningKind::PatternModes]);
    // The same mean tension by a motion of one edge, the others free to slide along it.
    let sliding = "[[0, 1, 0], [0, 0, 1]]";
    let pulled = |count: &'static str| {
        done(run(
            "tensioned-plate.toml",
            &[
                thin,
                modes(count),
                ("initial_stress", "[]"),
                ("supports[1].held.displacement", sliding),
                ("supports[2].held.displacement", sliding),
                ("supports[3].held.displacement", sliding),
                (
                    "supports[+]",
                    "{ on = \"u1\", moved = { direction = [1, 0, 0], by = 2.25e-4 }, preload = true }",
                ),
            ],
        ))
    };
    assert!(warned(&pulled("10")).is_empty());
    assert_eq!(warned(&pulled("20")), [WarningKind::PatternModes]);
}

/// A part with a measure of its own is built and said; one over all of a shell is the shell.
#[test]
fn a_part_measures_curvature_in_its_own_way() {
    let green = "formulation.stress-point.curvature = \"green-lagrange\"";
    let strip = text("relieved-strip.toml");
    let whole = strip.replace("title = ", &format!("{green}\ntitle = "));
    let part =
        strip.replace("[[initial_stress]]", &format!("[[parts]]\non = \"all\"\n{green}\n[[initial_stress]]"));
    let [whole, part] = [whole, part].map(|text| done(ran(overridden(&text, "strip.toml", &[]))));
    assert_eq!(last(&whole, "w_end").to_bits(), last(&part, "w_end").to_bits());
    let line = "part all: 80 cells, thickness 0.001, green-lagrange curvature".to_string();
    assert!(part.summary.body.modelled.contains(&line), "{:?}", part.summary.body.modelled);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let part = |says: &str| format!("[{{ on = \"all\", {says} }}]");
    let wide = part("formulation.stress-point.support = 1.4");
    let nodal = part("formulation.nodal = {}");
    let unknown = part("formulation.stress-point.curvature = \"none\"");
    let cases: &[(&str, Replaced, &str)] = &[
        (
            "relieved-strip.toml",
            &[("initial_stress[0].bending", "[1e300, 0, 0]")],
            "initial_stress[0].bending[0]",
        ),
        ("relieved-strip.toml", &[("initial_stress", "[{ on = \"all\" }]")], "`membrane`, `bending` or both"),
        (
            "relieved-strip.toml",
            &[("initial_stress", "[{ on = \"all\", membrane = [1, 0, 0] }]")],
            "add axis",
        ),
        ("relieved-strip.toml", &[("initial_stress[0].axis", "[0, 0, 1]")], "stands on the surface"),
        ("relieved-strip.toml", &[("initial_stress[0].on", "\"al\"")], "initial_stress[0].on"),
        ("relieved-strip.toml", &[("formulation", "{ nodal = {} }")], "strains are sampled in cells"),
        ("relieved-strip.toml", &[("analysis", "{ linear = {} }")], "does not look for its balance first"),
        ("relieved-strip.toml", &[("curve[0].of", "\"energy\"")], "column `internal`"),
        ("tensioned-plate.toml", &[("analysis", "{ static = { levels = 1 } }")], "nothing would move"),
        (
            "tensioned-plate.toml",
            &[("analysis", "{ buckling = { modes = 1, prebuckling = \"stress\" } }")],
            "\"rotations\"",
        ),
        ("relieved-strip.toml", &[("parts", &wide)], "neighbours of a particle"),
        ("relieved-strip.toml", &[("parts", &nodal)], "neighbours of a particle"),
        ("relieved-strip.toml", &[("parts", &unknown)], "parts[0].formulation.stress-point.curvature"),
    ];
    for (name, replaced, says) in cases {
        let scene = overridden(&text(name), name, replaced).and_then(|scene| scene.build(1));
        let Err(error) = scene else { panic!("{replaced:?} is not refused") };
        let shown = render(&error, Rendering { width: 200, colour: false });
        assert!(shown.contains(says), "{says} is not in\n{shown}");
    }
}
