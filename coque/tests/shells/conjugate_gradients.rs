//! Linear answers by conjugate gradients in scenes: the direct answer, what the summary says, refusals.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{Replaced, overridden, ran, run, scene, scenes};
use coque::{Ended, Outcome};
use std::fs;

const ITERATED: (&str, &str) = ("analysis", "{ linear = { solver = \"conjugate-gradients\" } }");

fn done(outcome: Outcome) -> Outcome {
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

/// The row of a direct answer, without the pivots that iterations do not count.
fn without_pivots(direct: &Outcome) -> Vec<f64> {
    let curve = &direct.curve;
    let kept =
        curve.columns.iter().zip(&curve.rows[0]).filter(|(column, _)| column.name != "negative_pivots");
    kept.map(|(_, &value)| value).collect()
}

/// Every column of the direct answer, and reactions, within the tolerance of 1e-9 in the energy norm.
#[test]
fn it_reads_what_the_direct_solver_reads() {
    let more: Replaced = &[("geometry.cylinder.particles", "[31, 31]")];
    let direct = done(run("scordelis-lo.toml", more));
    let iterated = done(run("scordelis-lo.toml", &[more[0], ITERATED]));
    assert!(iterated.curve.columns.iter().all(|column| column.name != "negative_pivots"));
    assert_eq!(without_pivots(&direct).len(), iterated.curve.rows[0].len());
    for (a, b) in without_pivots(&direct).iter().zip(&iterated.curve.rows[0]) {
        assert!((a - b).abs() <= 1e-8 * a.abs(), "{a} {b}");
    }
    let [a, b] = [&direct, &iterated].map(|outcome| outcome.summary.supports.unwrap().force[2]);
    assert!((a / b - 1.0).abs() < 1e-7, "{a} {b}");
    assert!(direct.summary.record.conjugate_gradients.is_none());
    let took = iterated.summary.record.conjugate_gradients.unwrap();
    println!("{took:?}");
    assert!(took.iterations > 10 && took.residual < 1e-9 && took.unknowns.len() > 1, "{took:?}");
}

/// What drives may be a motion: the answer is then scaled to it.
#[test]
fn a_prescribed_motion_is_met() {
    let moved = "[{ on = 'u0', clamped = {} }, { on = 'u1', moved = { direction = [0, 0, 1], by = 0.1 } }]";
    let answer = |analysis| {
        let text = fs::read_to_string(scenes().join("stepped-plate.toml")).unwrap();
        let replaced = [("supports", moved), ("loads", "[]"), ("analysis", analysis)];
        done(ran(overridden(&text, "stepped-plate.toml", &replaced)))
    };
    let [direct, iterated] = ["{ linear = {} }", ITERATED.1].map(answer);
    // A motion pulls on what is beside it with a force whose energy is far above that of the answer, and the tolerance is a part of that.
    for (a, b) in without_pivots(&direct).iter().zip(&iterated.curve.rows[0]) {
        assert!((a - b).abs() <= 1e-6 * a.abs() + 1e-12, "{a} {b}");
    }
}

#[test]
fn bodies_that_do_not_tell_their_rigid_motions_are_refused() {
    let refused = |name: &str, replaced: Replaced| {
        let text = fs::read_to_string(scenes().join(name)).unwrap();
        overridden(&text, name, replaced)
            .and_then(|scene| scene.build(1))
            .map(|_| ())
            .unwrap_err()
            .to_string()
    };
    let solid = refused("cantilever-solid.toml", &[ITERATED]);
    assert!(solid.contains("analysis.linear.solver") && solid.contains("no shell"), "{solid}");
}

/// Too few iterations end the run with what is left; a factor has none to count.
#[test]
fn iterations_are_those_that_are_allowed() {
    let allowed = |iterations: &str, solver: &str| {
        let analysis = format!("{{ linear = {{ solver = \"{solver}\", iterations = {iterations} }} }}");
        scene("scordelis-lo.toml", &[("analysis", &analysis)]).and_then(|scene| scene.build(1))
    };
    let few = allowed("5", "conjugate-gradients").unwrap().run(&mut coque::Silent);
    assert!(few.summary.ended.contains("after 5 iterations"), "{}", few.summary.ended);
    assert_eq!(
        done(allowed("500", "conjugate-gradients").unwrap().run(&mut coque::Silent)).curve.rows.len(),
        1
    );
    for (iterations, solver, said) in
        [("5", "direct", "a factor does not iterate"), ("0", "conjugate-gradients", "from 1 to")]
    {
        let refused = allowed(iterations, solver).map(|_| ()).unwrap_err().to_string();
        assert!(refused.contains("analysis.linear.iterations") && refused.contains(said), "{refused}");
    }
}
