//! Friction on tools, in scenes: what is refused, a plate on an incline, a belt over a drum, the same bits from checkpoints.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, last, overridden, refusal, run, text};
use coque::{Ended, Outcome};

const INCLINE: &str = "incline.toml";
const CAPSTAN: &str = "capstan.toml";
/// Rests on a slope of 15 degrees.
const GENTLE: (&str, &str) = ("loads[0].gravity.acceleration", "[2.588190451, 0.0, -9.659258263]");

fn done(outcome: Outcome) -> Outcome {
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

#[test]
fn broken_friction() {
    let ball = "[{ name = 'a', sphere = { centre = [0, 0, 0], radius = 99 }, friction = 0.3, turn = 1.0 }]";
    let smooth =
        "[{ name = 'a', cylinder = { point = [0, 0, 0], axis = [0, 1, 0], radius = 99 }, turn = 1.0 }]";
    let cases: [(&str, &str, Replaced); 5] = [
        ("less than none", CAPSTAN, &[("tools[0].friction", "-0.1")]),
        ("beyond two", CAPSTAN, &[("tools[0].friction", "2.5")]),
        ("a ball that turns", CAPSTAN, &[("tools", ball)]),
        ("a smooth tool that turns", CAPSTAN, &[("tools", smooth)]),
        ("a turn without a course in time", INCLINE, &[("tools[0].turn", "0.1")]),
    ];
    let said = cases.map(|(what, name, replaced)| format!("== {what}\n{}\n", refusal(name, replaced, 100)));
    insta::assert_snapshot!(said.concat());
}

/// It is .14 % too fast as it swings on its contact. What friction lost, what is stored and what moves is the work of the loads, to 6e-5 of it
/// measured; the loss is μ N times the way, but for the ramp of the weight.
#[test]
fn a_plate_slides_down_an_incline_as_coulomb_says() {
    let outcome = done(run(INCLINE, &[]));
    let of = |name: &str| column(&outcome, name);
    let (time, v) = (of("time"), of("v"));
    let [a, b] = [20, time.len() - 1];
    let pace = (v[b] - v[a]) / (time[b] - time[a]);
    let exact = 10.0 * (0.5 - 0.3 * 0.75_f64.sqrt());
    println!("{pace:.4} for {exact:.4}");
    assert!((pace / exact - 1.0).abs() < 4e-3, "{pace} {exact}");
    let closed = last(&outcome, "kinetic") + last(&outcome, "internal") + last(&outcome, "lost");
    let open = closed / last(&outcome, "external") - 1.0;
    assert!(open.abs() < 2e-4, "{open:e}");
    let loss = last(&outcome, "lost") / (0.3 * 0.75_f64.sqrt() * last(&outcome, "u")) - 1.0;
    assert!(loss.abs() < 6e-3, "{loss:e}");
    assert!((last(&outcome, "dissipated") / last(&outcome, "lost") - 1.0).abs() < 1e-3);
}

/// Where friction holds it, it stays, but contact that swings lets it creep by 1.5e-3 of a cell in .6 s.
#[test]
fn a_plate_stays_on_a_gentle_slope() {
    let outcome = done(run(INCLINE, &[GENTLE]));
    let way = column(&outcome, "u").into_iter().fold(0.0_f64, |most, u| most.max(u.abs()));
    println!("{:.1e} of a cell", 15.0 * way);
    assert!(15.0 * way < 5e-3, "{way:e}");
}

/// Euler's formula, .45 % off with 60 cells, and the loss of a drum that turns on: difference of the tensions times the way of its face.
#[test]
fn a_belt_over_a_drum_is_drawn_as_euler_says() {
    let coarse = [("geometry.cylinder.particles", "[61, 3]"), ("tools[0].cylinder.radius", "99.86573")];
    let outcome = done(run(CAPSTAN, &[coarse[0], coarse[1], ("analysis.static.levels", "[0.2, 0.4]")]));
    let ratio = last(&outcome, "T2") / 210.0;
    let exact = libm::exp(0.3 * std::f64::consts::PI);
    let [before, after] = [1, 2].map(|row| column(&outcome, "lost")[row]);
    let loss = (after - before) / ((last(&outcome, "T2") - 210.0) * 0.2 * 0.02 * 99.97) - 1.0;
    // The torque on the drum is that of the tensions.
    let torque = last(&outcome, "torque") / (100.0 * (last(&outcome, "T2") - 210.0)) + 1.0;
    println!(
        "{ratio:.4} for {exact:.4}, loss {loss:.1e}, torque {torque:.1e}, gap {:.1e}",
        last(&outcome, "gap")
    );
    assert!(torque.abs() < 4e-4, "{torque:e}");
    // Cells touch with their middles: the particles stand off by their sag, .0343, less what the belt is drawn in by.
    let gap = last(&outcome, "gap");
    assert!(gap > 0.0 && gap < 0.0343, "{gap}");
    assert!((ratio / exact - 1.0).abs() < 0.01, "{ratio} {exact}");
    assert!(loss.abs() < 1.3e-3, "{loss:e}");
    // Its cells sag by a third of the half thickness, which is said.
    let warnings = &outcome.summary.record.warnings;
    assert!(warnings.iter().all(|own| own.kind == coque::WarningKind::CoarseContact), "{warnings:?}");
}

#[test]
fn friction_goes_on_to_the_same_bits_and_threads_change_none() {
    let short = ("analysis.explicit.transient.duration", "0.05");
    stopped_again_and_again("incline", &text(INCLINE), &[short], 4);
    let bits = |threads: usize| -> Vec<u64> {
        let replaced = [("geometry.plate.particles", "[41, 41]"), short];
        let model = overridden(&text(INCLINE), INCLINE, &replaced).unwrap().build(threads).unwrap();
        let outcome = done(model.run(&mut coque::Silent));
        outcome.curve.rows.iter().flatten().map(|x| x.to_bits()).collect()
    };
    assert_eq!(bits(1), bits(3));
}

#[test]
fn a_static_run_goes_on_with_its_anchors() {
    let coarse = ("geometry.cylinder.particles", "[31, 3]");
    let drum = ("tools[0].cylinder.radius", "99.76295");
    stopped_again_and_again("capstan", &text(CAPSTAN), &[coarse, drum, ("analysis.static.levels", "3")], 2);
}
