//! Sets that turn as one body, springs and velocities of sets, in scenes.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{Replaced, column, last, overridden, ran, run};
use coque::{Checked, Ended, Outcome, Rendering, render};

fn done(outcome: Outcome) -> Outcome {
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

/// A thousandth of a quarter turn: St Venant's torque of the strip, less what the clamped ends stiffen over about a width of eight; the
/// torque of a large angle is more than in proportion, since the long edges stretch.
#[test]
fn a_strip_is_twisted_from_a_scene() {
    let torque = column(&done(run("twisted-strip.toml", &[])), "torque");
    let (shear, t) = (1.2e9 / 2.6, 0.05_f64);
    let st_venant = shear * t.powi(3) / 3.0 * (1.0 - 0.63 * t) * (1e-3 * std::f64::consts::FRAC_PI_2) / 8.0;
    let ratio = torque[1] / st_venant;
    println!("{ratio} {torque:?}");
    assert!((1.0..1.1).contains(&ratio), "{ratio}");
    assert!(torque[5] > 1.2 * 1000.0 * torque[1], "{torque:?}");
}

const PLATE: &str = r#"
title = "Plate on springs"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [2.0, 1.0], particles = [9, 5] }
material.elastic = { young = 1e9, poisson = 0.3, density = 1000.0 }
section.homogeneous.thickness = 0.1
supports = [{ on = "all", held = { displacement = [[1, 0, 0], [0, 1, 0]] } },
            { on = "v0", spring = { direction = [0, 0, 1], stiffness = 30.0 } },
            { on = "v1", spring = { direction = [0, 0, 1], stiffness = 30.0 } }]
loads = [{ on = "all", gravity = { acceleration = [0, 0, -1] } }]
curve = [{ name = "w", of = "displacement", on = "all", direction = [0, 0, 1] },
         { name = "R", of = "reaction", on = "v0", direction = [0, 0, 1] }]
analysis.static = { levels = 1 }
"#;

fn plate(replaced: Replaced) -> Outcome {
    done(ran(overridden(PLATE, "plate.toml", replaced)))
}

/// Stiff against its springs, of 60 N/m together: `w = −mg/k`, half of the weight on either side, `ω² = k/m`.
#[test]
fn a_plate_on_two_springs_sinks_and_swings_as_one_mass() {
    let mass = 2.0 * 0.1 * 1000.0;
    let still = plate(&[]);
    assert!((last(&still, "w") * 60.0 / -mass - 1.0).abs() < 1e-4, "{}", last(&still, "w"));
    assert!((last(&still, "R") / (0.5 * mass) - 1.0).abs() < 1e-6, "{}", last(&still, "R"));
    assert!((still.summary.supports.unwrap().force[2] / mass - 1.0).abs() < 1e-6);
    let relaxed = plate(&[("analysis", "{ relaxation = { levels = 1 } }")]);
    assert!((last(&relaxed, "w") / last(&still, "w") - 1.0).abs() < 1e-5, "{}", last(&relaxed, "w"));
    let modes = plate(&[("analysis", "{ modal = { modes = 3 } }"), ("curve", "[]")]);
    let omega = column(&modes, "circular_frequency");
    println!("{omega:?}");
    // Up and down; rocking about y on springs spread evenly along x, with their second moment k a²/12 against that of the mass,
    // m (a² + t²)/12; rocking about x with the springs at the edges, m (b² + t²)/12.
    let along = 60.0 / mass / (1.0 + 0.01 / 4.0);
    let rocking = 60.0 * 0.25 / (mass * (1.0 / 12.0 + 0.01 / 12.0));
    for (found, square) in omega.iter().zip([60.0 / mass, along, rocking]) {
        assert!((found * found / square - 1.0).abs() < 3e-3, "{found} {square}");
    }
    assert!((omega[0] * omega[0] * mass / 60.0 - 1.0).abs() < 3e-3, "{omega:?}");
}

/// On a bed all over, and on lines at two edges of a single cell each, a plate rocks as on an even bed whatever its cells.
#[test]
fn a_plate_rocks_on_its_springs_as_on_an_even_bed() {
    let modal = [("analysis", "{ modal = { modes = 3 } }"), ("curve", "[]")];
    let bed = (
        "supports",
        "[{ on = \"all\", held = { displacement = [[1, 0, 0], [0, 1, 0]] } }, \
               { on = \"all\", spring = { direction = [0, 0, 1], stiffness = 60.0 } }]",
    );
    let k = 60.0 / 200.0;
    let along = k / (1.0 + 0.01 / 4.0);
    for geometry in [
        "{ lengths = [2.0, 1.0], particles = [3, 3] }",
        "{ lengths = [2.0, 1.0], particles = [6, 5] }",
        "{ lengths = [2.0, 1.0], scattered = { spacing = 0.2, seed = 3 } }",
    ] {
        let modes = plate(&[&modal[..], &[("geometry.plate", geometry), bed]].concat());
        let found = column(&modes, "circular_frequency").into_iter().map(|omega| omega * omega);
        let found: Vec<f64> = found.collect();
        println!("{geometry}: {found:?}");
        for (found, square) in found.iter().zip([k / (1.0 + 0.01), along, k]) {
            assert!((found / square - 1.0).abs() < 1e-4, "{geometry}: {found} {square}");
        }
    }
    // A single cell on springs at two of its edges, pressed at a third: F/k by the mean, F (a/2)²/(k a²/12) by the turn.
    let one = plate(&[
        ("geometry.plate.particles", "[2, 2]"),
        ("loads", "[{ on = \"u1\", force = { total = [0, 0, 1] } }]"),
        ("curve", "[{ name = \"w\", of = \"displacement\", on = \"u1\", direction = [0, 0, 1] }]"),
        ("analysis", "{ linear = {} }"),
    ]);
    let ratio = last(&one, "w") / ((1.0 + 3.0) / 60.0);
    println!("one cell: {ratio}");
    // Of a plate as stiff as this against its bed, what it bends.
    assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
}

/// The same in time: it sets out with a velocity and swings about zero by v/ω.
#[test]
fn a_plate_on_springs_swings_in_time() {
    let period = std::f64::consts::TAU * (200.0_f64 / 60.0).sqrt();
    let run = format!(
        "{{ explicit.transient = {{ duration = {}, record_every = {} }} }}",
        period / 4.0,
        period / 40.0
    );
    let swung = plate(&[("loads", "[]"), ("velocity", "{ linear = [0, 0, 0.01] }"), ("analysis", &run)]);
    let wanted = 0.01 * period / std::f64::consts::TAU;
    assert!((last(&swung, "w") / wanted - 1.0).abs() < 1e-3, "{} {wanted}", last(&swung, "w"));
}

/// One half of a free plate sets out, the other is at rest: the momentum is that of the half.
#[test]
fn a_set_sets_out_alone() {
    let scene = |on: &str| {
        let velocity = format!("{{ on = \"{on}\", linear = [0, 0, 2.0] }}");
        let run = "{ explicit.transient = { duration = 1e-4, record_every = 1e-4 } }";
        let pairs = [
            ("supports", "[]"),
            ("loads", "[]"),
            ("sets.half.box", "{ min = [-1, 0, -1], max = [0.9, 1, 1] }"),
            ("velocity", velocity.as_str()),
            ("curve", "[{ name = \"v\", of = \"velocity\", on = \"all\", direction = [0, 0, 1] }]"),
            ("analysis", run),
        ];
        overridden(PLATE, "plate.toml", &pairs)
    };
    let half = done(ran(scene("half")));
    // Four of nine rows.
    let start = column(&half, "v")[0];
    assert!((start - 2.0 * 4.0 / 9.0).abs() < 1e-12, "{start}");
    let line = "velocity of half at the start".to_string();
    assert!(half.summary.body.modelled.contains(&line));
    assert!(scene("haff").err().unwrap().to_string().contains("haff"));
}

const STRIP: &str = r#"
title = "Strip on springs"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [10.0, 1.0], particles = [21, 3] }
orientation = { axis = [1, 2, 3], degrees = 40.0 }
material.elastic = { young = 12e5, poisson = 0.0, density = 1000.0 }
section.homogeneous.thickness = 0.1
supports = [{ on = "u0", hinged = {} }, { on = "u0", spring = { axis = [0, 2, 0], stiffness = 30.0 } }]
loads = [{ on = "u1", force = { total = [0, 0, 0.01] } }]
curve = [{ name = "w", of = "displacement", on = "u1", direction = [0, 0, 1] },
         { name = "u", of = "displacement", on = "u1", direction = [1, 0, 0] },
         { name = "F", of = "reaction", on = "u1", direction = [1, 0, 0] },
         { name = "M", of = "reaction-moment", on = "u0", direction = [0, 1, 0] }]
analysis.linear = {}
"#;

fn sprung(replaced: Replaced) -> Outcome {
    done(ran(overridden(STRIP, "strip.toml", replaced)))
}

/// Hinged, with a spring against turning on the directors of its edge, or on the edge as a rigid set: `FL³/3EI + FL²/k`.
#[test]
fn a_strip_on_a_spring_against_turning_gives_way_by_its_angle() {
    let (stiff, force, length) = (12e5 * 1e-3 / 12.0, 0.01, 10.0_f64);
    let wanted = force * length.powi(3) / (3.0 * stiff) + force * length * length / 30.0;
    let body = [("rigid", "[{ on = \"u0\" }]")];
    let held = "[{ on = \"u0\", held = { displacement = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], director = [[0, 1, 0]] } }, \
                { on = \"u0\", spring = { axis = [0, 2, 0], stiffness = 30.0 } }]";
    for more in [&[][..], &[body[0], ("supports", held)]] {
        for (analysis, bound) in [("{ linear = {} }", 1e-3), ("{ static = { levels = 1 } }", 1e-3)] {
            let found = sprung(&[&[("analysis", analysis)], more].concat());
            let (error, moment) =
                (last(&found, "w") / wanted - 1.0, last(&found, "M") / (force * length) - 1.0);
            println!("{analysis}: {error:.1e} {moment:.1e}");
            // Of the lattice and of shear; the large motion shortens the arm by its square, 1e-5.
            assert!(error.abs() < bound && moment.abs() < 1e-4, "{analysis}: {error} {moment}");
        }
        let modes = sprung(&[&[("analysis", "{ modal = { modes = 1 } }"), ("curve", "[]")], more].concat());
        let square = column(&modes, "circular_frequency")[0].powi(2);
        // κ = kL/EI = 3: the root of the beam's determinant.
        let exact = 1.513_380_f64.powi(4) * stiff / (1000.0 * 0.1 * length.powi(4));
        println!("{}", (square / exact).sqrt().sqrt() * 1.513_380);
        assert!((square / exact - 1.0).abs() < 4e-3, "{}", square / exact);
    }
}

/// Pulled along its length with springs of its own stiffness from end to end: half of the force goes through them, pair by pair or from the
/// reference point of one rigid end to that of the other.
#[test]
fn springs_from_end_to_end_bear_half_of_the_force() {
    let stiff = 12e5 * 0.1 / 10.0;
    let supports = format!(
        "[{{ on = \"u0\", clamped = {{}} }}, {{ on = \"all\", held = {{ displacement = [[0, 1, 0], [0, 0, 1]], director = [[1, 0, 0]] }} }}, \
         {{ on = \"u1\", spring = {{ direction = [1, 0, 0], stiffness = {stiff}, to = \"u0\" }} }}]"
    );
    let rigid = format!(
        "[{{ on = \"u0\", clamped = {{}} }}, {{ on = \"u1\", held = {{ displacement = [[0, 1, 0], [0, 0, 1]], director = [[1, 0, 0]] }} }}, \
         {{ on = \"u1\", spring = {{ direction = [1, 0, 0], stiffness = {stiff}, to = \"u0\" }} }}]"
    );
    let loads = "[{ on = \"u1\", force = { total = [2, 0, 0] } }]";
    let bodies = "[{ on = \"u0\" }, { on = \"u1\", at = [10.5, 0.5, 0.0] }]";
    for (supports, bodies) in [(supports, "[]"), (rigid, bodies)] {
        let found = sprung(&[("supports", &supports), ("loads", loads), ("rigid", bodies)]);
        let (way, force) = (last(&found, "u") * 2.0 * stiff / 2.0 - 1.0, last(&found, "F") + 1.0);
        println!("{way:.1e} {force:.1e}");
        assert!(way.abs() < 1e-9 && force.abs() < 1e-9, "{way} {force}");
    }
}

#[test]
fn what_no_spring_or_turn_can_be_is_refused() {
    let refused = |replaced: Replaced| match overridden(PLATE, "plate.toml", replaced)
        .and_then(|s: Checked| s.build(1))
    {
        Ok(_) => panic!("{replaced:?} is not refused"),
        Err(error) => render(&error, Rendering { width: 200, colour: false }),
    };
    let spring = "supports[1].spring";
    for (path, value, says) in [
        (spring, "{ direction = [0, 0, 1], stiffness = 0 }", "supports[1].spring.stiffness"),
        (spring, "{ direction = [0, 0, 0], stiffness = 1 }", "supports[1].spring.direction"),
        (
            spring,
            "{ direction = [0, 0, 1], axis = [1, 0, 0], stiffness = 1 }",
            "exactly one direction or axis",
        ),
        (spring, "{ stiffness = 1 }", "no direction or axis"),
        (spring, "{ axis = [0, 0, 0], stiffness = 1 }", "supports[1].spring.axis"),
        (
            "supports[+]",
            "{ on = \"v0\", spring = { axis = [0, 0, 1], stiffness = 1 } }",
            "lies along the director",
        ),
        (spring, "{ axis = [1, 0, 0], stiffness = 1, to = \"v1\" }", "stands on the ground"),
        (spring, "{ direction = [0, 0, 1], stiffness = 1, to = \"v0\" }", "another set than `on`"),
        (spring, "{ direction = [0, 0, 1], stiffness = 1, to = \"v2\" }", "which is no set"),
        (spring, "{ direction = [0, 0, 1], stiffness = 1, to = \"u0\" }", "5 places"),
        ("supports[1].amplitude", "{ ramp = 1 }", "only `moved`, `rotated` and `turned` have a course"),
        (
            "supports[+]",
            "{ on = \"v0\", turned = { axis = [1, 0, 0], point = [0, 0.5, 0], by = 1 } }",
            "its other supports hold",
        ),
        (
            "supports",
            "[{ on = \"v0\", spring = { direction = [0, 0, 1], stiffness = 1 } }]",
            "translation along [1, 0, 0]",
        ),
    ] {
        let text = refused(&[(path, value)]);
        assert!(text.contains(says), "{says} is not in\n{text}");
    }
}
