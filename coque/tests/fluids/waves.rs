//! Walls that make waves by their stroke, and beaches that take them.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::refused::refused;
use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, overridden, ran};
use coque::Outcome;

const FLUME: &str = r#"title = "A short flume"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.875, record_every = 0.0125 }
loads = [{ on = "all", gravity = { acceleration = [0.0, -9.81, 0.0] } }]
curve = [{ name = "x", of = "displacement", on = "piston.all", take = "max", direction = [1, 0, 0] }]
[bodies.water.fluid]
geometry.block = { lengths = [0.8, 0.2], spacing = 0.02 }
material.liquid = { density = 1000.0, sound_speed = 15.0 }
beach = { from = [0.4, 0.0, 0.0], length = 0.4, period = 0.5, depth = 0.2 }
[bodies.flume.walls]
geometry.basin = { min = [-0.1, 0.0], max = [0.8, 0.3], open = ["x0", "y1"] }
[bodies.piston.walls]
geometry.block = { lengths = [0.08, 0.28], origin = [-0.08, 0.0] }
motion.waves = { height = 0.02, period = 0.5, depth = 0.2, growth = 0.5 }
"#;

const BEACH: &str = "beach = { from = [0.4, 0.0, 0.0], length = 0.4, period = 0.5, depth = 0.2 }";

fn flume(replaced: Replaced) -> Outcome {
    ran(overridden(FLUME, "flume.toml", replaced))
}

/// Wave number times depth, x tanh x = ω²d/g, by halving.
fn number_times_depth() -> f64 {
    let wanted = (std::f64::consts::TAU / 0.5).powi(2) * 0.2 / 9.81;
    let (mut low, mut high) = (1e-3, 50.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if middle * libm::tanh(middle) > wanted { high = middle } else { low = middle }
    }
    low
}

/// Grown, a piston goes half of its stroke to either side, `S = H (sinh 2x + 2x)/(2 cosh 2x − 2)`: at the crest at 1¼ periods. The top of a flap that is 1.4 times as
/// high as the water goes 1.4 times that of its own formula, as the sine of an angle where the surface has its tangent: .1 % here, and another .3 % for particles
/// that lie behind its face.
#[test]
fn walls_go_by_their_strokes() {
    let x = number_times_depth();
    let below = libm::sinh(2.0 * x) + 2.0 * x;
    let piston = 0.01 * below / (2.0 * (libm::cosh(2.0 * x) - 1.0));
    let outcome = flume(&[]);
    let ways = column(&outcome, "x");
    let crest = 50;
    assert!((column(&outcome, "time")[crest] - 0.625).abs() < 1e-12);
    assert!((ways[crest] / piston - 1.0).abs() < 1e-9, "{} {piston}", ways[crest]);
    assert!((ways[70] / -piston - 1.0).abs() < 1e-9, "{} {piston}", ways[70]);
    assert!(outcome.summary.record.warnings.is_empty(), "{:?}", outcome.summary.record.warnings);
    let flap = 0.01 * x * below / (4.0 * libm::sinh(x) * (x * libm::sinh(x) - libm::cosh(x) + 1.0));
    let hinged = "{ height = 0.02, period = 0.5, depth = 0.2, growth = 0.5, hinge = [0.0, 0.0, 0.0] }";
    let ways = column(&flume(&[("bodies.piston.walls.motion.waves", hinged)]), "x");
    // The highest row lies half a spacing below the edge.
    let top = flap * 0.27 / 0.2;
    assert!((ways[crest] / top - 1.0).abs() < 0.02, "{} {top}", ways[crest]);
}

/// Water that sloshes loses more where a beach lies, and its energies close as without one.
#[test]
fn a_beach_takes_energy_and_counts_it() {
    let moved = [
        ("bodies.water.fluid.velocity", "{ linear = [0.2, 0, 0] }"),
        (
            "bodies.piston.walls",
            "{ geometry = { block = { lengths = [0.08, 0.28], origin = [-0.08, 0.0] } } }",
        ),
        ("curve", "[{ name = 'h', of = 'level', on = 'water.all', at = [0.7, 0, 0] }]"),
    ];
    let bare = FLUME.replace(BEACH, "");
    let [with, without] = [flume(&moved), ran(overridden(&bare, "flume.toml", &moved))];
    let loss = |outcome: &Outcome| outcome.summary.record.fluid.as_ref().unwrap().viscous;
    assert!(loss(&with) > 1.5 * loss(&without), "{} {}", loss(&with), loss(&without));
    for outcome in [&with, &without] {
        let balance = outcome.summary.record.balance.as_ref().unwrap();
        assert!(balance.worst.abs() < 0.01 * balance.turned_over, "{balance:?}");
    }
}

#[test]
fn waves_that_cannot_be_made_are_refused() {
    let waves = "motion.waves = { height = 0.02, period = 0.5, depth = 0.2, growth = 0.5 }";
    let beach = BEACH;
    let cases = [
        ("waves that break", waves, "motion.waves = { height = 0.2, period = 0.5, depth = 0.2 }"),
        (
            "waves upwards",
            waves,
            "motion.waves = { height = 0.02, period = 0.5, depth = 0.2, along = [0, 1, 0] }",
        ),
        (
            "waves and another motion",
            waves,
            "motion = { waves = { height = 0.02, period = 0.5, depth = 0.2 }, translation = { by = [0.1, 0, 0], amplitude = { ramp = 1.0 } } }",
        ),
        ("no period", waves, "motion.waves = { height = 0.02, period = 0.0, depth = 0.2 }"),
        (
            "no growth of a sine",
            waves,
            "motion.translation = { by = [0.1, 0, 0], amplitude = { sine = { period = 1.0, growth = 0.0 } } }",
        ),
        ("waves without gravity", "[0.0, -9.81, 0.0]", "[0.0, 0.0, 0.0]"),
        (
            "a short beach",
            beach,
            "beach = { from = [0.6, 0.0, 0.0], length = 0.2, period = 0.5, depth = 0.2 }",
        ),
        (
            "a beach that waves go down to",
            beach,
            "beach = { from = [0.4, 0.0, 0.0], along = [0, -1, 0], length = 0.4, period = 0.5, depth = 0.2 }",
        ),
        ("waves of other water", waves, "motion.waves = { height = 0.02, period = 0.5, depth = 0.15 }"),
        (
            "a hinge above the floor",
            waves,
            "motion.waves = { height = 0.02, period = 0.5, depth = 0.2, hinge = [0.0, 0.1, 0.0] }",
        ),
        (
            "a beach for other water",
            beach,
            "beach = { from = [0.4, 0.0, 0.0], length = 0.4, period = 0.5, depth = 0.3 }",
        ),
        (
            "a beach behind the water",
            beach,
            "beach = { from = [0.8, 0.0, 0.0], length = 0.4, period = 0.5, depth = 0.2 }",
        ),
        (
            "a beach that turns its back",
            beach,
            "beach = { from = [0.0, 0.0, 0.0], along = [-1, 0, 0], length = 0.4, period = 0.5, depth = 0.2 }",
        ),
        (
            "a beach of the published march",
            beach,
            &format!("{beach}\nformulation.weakly-compressible = {{ method = \"source\" }}"),
        ),
    ];
    insta::assert_snapshot!(refused(FLUME, &cases));
}

/// Two runs beside each other: the greatest difference of a column over its greatest value.
fn apart(one: &Outcome, other: &Outcome, name: &str, factor: f64) -> f64 {
    let [one, other] = [one, other].map(|outcome| column(outcome, name));
    let most = one.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    one.iter().zip(&other).fold(0.0_f64, |most, (x, y)| most.max((x - factor * y).abs())) / most
}

/// A level at the middle and the way of the piston, both of water that starts from a level of .2 m: the swing of the surface is some hundredth of that.
const WATCHED: (&str, &str) = (
    "curve",
    "[{ name = 'x', of = 'displacement', on = 'piston.all', take = 'max', direction = [1, 0, 0] }, { name = 'h', of = 'level', on = 'water.all', at = [0.4, 0, 0] }, \
     { name = 'u', of = 'velocity', on = 'water.all', take = 'mean', direction = [1, 0, 0] }]",
);

/// In the mirror of x: the piston at the right, waves and beach to the left.
#[test]
fn waves_in_a_mirror_are_the_same() {
    let mirrored = [
        WATCHED,
        ("bodies.flume.walls.geometry.basin", "{ min = [0.0, 0.0], max = [0.9, 0.3], open = ['x1', 'y1'] }"),
        ("bodies.piston.walls.geometry.block", "{ lengths = [0.08, 0.28], origin = [0.8, 0.0] }"),
        (
            "bodies.piston.walls.motion.waves",
            "{ height = 0.02, period = 0.5, depth = 0.2, growth = 0.5, along = [-1, 0, 0] }",
        ),
        (
            "bodies.water.fluid.beach",
            "{ from = [0.4, 0.0, 0.0], along = [-1, 0, 0], length = 0.4, period = 0.5, depth = 0.2 }",
        ),
    ];
    let mirrored =
        [mirrored[0], mirrored[1], mirrored[2], mirrored[3], mirrored[4], ("curve[0].take", "'min'")];
    let [one, other] = [flume(&[WATCHED]), flume(&mirrored)];
    for (name, factor) in [("x", -1.0), ("h", 1.0), ("u", -1.0)] {
        let off = apart(&one, &other, name, factor);
        assert!(off < 1e-7, "{name}: {off:e}");
    }
}

/// In mm, N and s.
#[test]
fn waves_in_other_units_are_the_same() {
    let scaled = [
        WATCHED,
        ("units", "{ length = 'mm', force = 'N', time = 's' }"),
        ("loads[0].gravity.acceleration", "[0, -9810.0, 0]"),
        ("curve[1].at", "[400.0, 0, 0]"),
        ("bodies.water.fluid.geometry.block", "{ lengths = [800.0, 200.0], spacing = 20.0 }"),
        ("bodies.water.fluid.material.liquid", "{ density = 1000e-12, sound_speed = 15000.0 }"),
        ("bodies.water.fluid.beach", "{ from = [400.0, 0, 0], length = 400.0, period = 0.5, depth = 200.0 }"),
        (
            "bodies.flume.walls.geometry.basin",
            "{ min = [-100.0, 0.0], max = [800.0, 300.0], open = ['x0', 'y1'] }",
        ),
        ("bodies.piston.walls.geometry.block", "{ lengths = [80.0, 280.0], origin = [-80.0, 0.0] }"),
        ("bodies.piston.walls.motion.waves", "{ height = 20.0, period = 0.5, depth = 200.0, growth = 0.5 }"),
    ];
    let [one, other] = [flume(&[WATCHED]), flume(&scaled)];
    for name in ["x", "h", "u"] {
        let off = apart(&one, &other, name, 1e-3);
        assert!(off < 1e-7, "{name}: {off:e}");
    }
}

/// The same bits for any threads, and of a run in sittings.
#[test]
fn waves_are_the_same_bits_however_they_are_run() {
    let short = [WATCHED, ("analysis.explicit.transient.duration", "0.2")];
    let one = flume(&short).curve.rows;
    let scene = overridden(FLUME, "flume.toml", &short).unwrap();
    for threads in [2, 3] {
        assert_eq!(scene.build(threads).unwrap().run(&mut coque::Silent).curve.rows, one, "{threads}");
    }
    stopped_again_and_again("flume", FLUME, &short, 3);
}

/// In water 503 times as deep as 1/k a piston goes a quarter of the height to either side and a flap, whose top is 1.35 times as high as the water at its highest row, by
/// `H/2/(2 − 2/kd)` times that: hyperbolic functions of twice that depth overflow.
#[test]
fn walls_go_in_deep_water() {
    let short = ("analysis.explicit.transient", "{ duration = 0.06, record_every = 0.01 }");
    let crest = |hinge: &str| {
        let made = format!("{{ height = 0.0003, period = 0.04, depth = 0.2, growth = 0.04{hinge} }}");
        column(&flume(&[short, ("bodies.piston.walls.motion.waves", &made)]), "x")[5]
    };
    // Measured 8e-14: time of the record over the period.
    assert!((crest("") / 7.5e-5 - 1.0).abs() < 1e-12, "{}", crest(""));
    let kd = (std::f64::consts::TAU / 0.04).powi(2) * 0.2 / 9.81;
    let top = 1.5e-4 / (2.0 - 2.0 / kd) * 0.27 / 0.2;
    let flap = crest(", hinge = [0.0, 0.0, 0.0]");
    // Measured 5e-5: rows lie behind the face of the flap and come forward as it leans; three times that.
    assert!((flap / top - 1.0).abs() < 1.5e-4, "{flap} {top}");
}

/// The period of waves by a table is one of it.
#[test]
fn the_peak_of_a_table_lies_in_it() {
    let said = |table: &str| {
        let made = format!(
            "{{ height = 0.004, period = 0.5, depth = 0.2, growth = 0.5, spectrum = {{ seed = 1, shape.table = {table} }} }}"
        );
        let scene = overridden(FLUME, "flume.toml", &[("bodies.piston.walls.motion.waves", &made)]);
        scene.and_then(|scene| scene.build(1).map(drop)).err().map(|error| error.to_string())
    };
    let beside = said("[[2.5, 1.0], [3.0, 0.5]]").unwrap();
    assert!(beside.contains("motion.waves.period") && beside.contains("0.3333 to 0.4000"), "{beside}");
    assert_eq!(said("[[1.5, 0.5], [2.0, 1.0], [3.0, 0.5]]"), None);
}
