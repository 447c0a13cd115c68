//! Runs that are led event by event: the bits of runs that are not, whatever is read or put back in between.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::borrow::Cow;

use crate::common::fluids::{DAM, SHELL_GATE};
use crate::common::sittings::{folder, go_on, pairs, same};
use crate::common::{self, overridden};
use coque::scene::Measured;
use coque::{
    Checkpoints, Ended, Event, Failure, FieldError, FieldSink, Frame, Mismatch, Model, Origin, Outcome,
    RunOptions, SCENE_COPY, Sheet, Silent, Simulation, StateArray,
};
use sph_core::Vec3;

/// A strip under a force at its end, with the displacement of one particle and what one at the clamp bears.
const STRIP: &str = r#"title = "Strip"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [4.0, 1.0], particles = [9, 3] }
material.elastic = { young = 1e6, poisson = 0.3, density = 1.0 }
section.homogeneous.thickness = 0.1
supports = [{ on = "u0", clamped = {} }]
loads = [{ on = "u1", force = { total = [-0.5, 0.0, 3.0] } }]
curve = [
    { name = "w", of = "displacement", on = "tip", direction = [0, 0, 1] },
    { name = "f", of = "reaction", on = "root", direction = [0, 0, 1] },
]
sets.tip = { nearest = [4.0, 0.5, 0.0] }
sets.root = { nearest = [0.0, 0.5, 0.0] }
"#;

/// A name, and an analysis of the strip.
const ANALYSES: [(&str, &str); 11] = [
    ("quasi-static", "{ explicit.quasi-static = { levels = [0.3, 1.0], hold = 4 } }"),
    ("transient", "{ explicit.transient = { duration = 0.2, record_every = 0.02, damping = 3.0 } }"),
    ("linear", "{ linear = {} }"),
    ("static", "{ static = { levels = 5 } }"),
    ("one solve", "{ static = { levels = 5, one_solve = true } }"),
    ("arc-length", "{ arc-length = { until = 1.0 } }"),
    ("relaxation", "{ relaxation = { levels = 3 } }"),
    ("modal", "{ modal = { modes = 3 } }"),
    ("harmonic", "{ harmonic = { frequencies = [0.5, 1.0], damping.structural = 0.1 } }"),
    (
        "random-vibration",
        "{ random-vibration = { modes = 3, damping.ratio = 0.1, frequencies = [0.5, 1.0], loads.density = [[0.1, 1.0], [2.0, 1.0]] } }",
    ),
    ("buckling", "{ buckling = { modes = 1 } }"),
];

/// The strip in an analysis.
fn strip(analysis: &str) -> Model {
    model(STRIP, &[("analysis", analysis)])
}

fn model(text: &str, replaced: common::Replaced) -> Model {
    overridden(text, "test.toml", replaced).unwrap().build(1).unwrap()
}

/// All that changes of the body, owned.
fn state(simulation: &Simulation<'_>) -> Vec<StateArray<'static>> {
    let owned = |array: StateArray<'_>| StateArray {
        name: Cow::Owned(array.name.into_owned()),
        numbers: Cow::Owned(array.numbers.into_owned()),
    };
    simulation.body().state().into_iter().map(owned).collect()
}

/// Leads a run to its end, and does something behind every event; the events, and what it leaves behind.
fn led(model: Model, mut between: impl FnMut(&mut Simulation<'_>, Event)) -> (Vec<Event>, Outcome) {
    let (mut simulation, mut events) = (Simulation::new(model), Vec::new());
    while events.last() != Some(&Event::End) {
        let event = simulation.advance().unwrap();
        between(&mut simulation, event);
        events.push(event);
    }
    assert_eq!(simulation.advance(), Ok(Event::End));
    (events, simulation.finish())
}

#[test]
fn every_analysis_is_led_to_its_end_with_the_same_bits() {
    for (name, analysis) in ANALYSES {
        let whole = strip(analysis).run(&mut Silent);
        assert_eq!(whole.ended, Ended::Done, "{name}");
        let mut rows = 0;
        let (events, outcome) = led(strip(analysis), |simulation, event| {
            let now = simulation.curve().rows.len();
            assert_eq!(event == Event::Record, now > rows, "{name}");
            assert_eq!(event == Event::End, simulation.ended().is_some() && now == rows, "{name}");
            rows = now;
        });
        same(&outcome, &whole);
        let records = events.iter().filter(|&&event| event == Event::Record).count();
        let expected = match name {
            "quasi-static" => 3,
            "transient" => 11,
            // The row of the start comes with the first level.
            "static" | "one solve" => 5,
            "relaxation" => 3,
            _ => 1,
        };
        assert_eq!(records, expected, "{name}");
        let steps = events.iter().filter(|&&event| event == Event::Step).count() as u64;
        let made = outcome.summary.record.steps;
        match name {
            // The last step leads to the end.
            "transient" => assert_eq!(steps + 1, made),
            // So does none that ends a level, and a look for the period takes one more.
            "quasi-static" => assert!(steps > made / 2 && steps < made, "{steps} of {made}"),
            _ => assert_eq!(steps, 0, "{name}"),
        }
    }
}

#[test]
fn what_is_read_and_put_back_changes_no_bit() {
    let gate = [("analysis.explicit.transient.duration", "0.004")];
    let torn = common::torn::strip(false);
    let preloaded = [
        ("analysis", "{ static = { levels = 3 } }"),
        ("loads[+]", "{ on = 'u1', force = { total = [0.5, 0, 0] }, preload = true }"),
    ];
    let others: [(&str, &str, common::Replaced); 4] = [
        ("dam", DAM, &[]),
        ("gate", SHELL_GATE, &gate),
        ("torn", &torn, &[]),
        ("preload", STRIP, &preloaded),
    ];
    let own = ANALYSES.map(|(name, analysis)| (name, STRIP, vec![("analysis", analysis)]));
    let others = others.map(|(name, text, replaced)| (name, text, replaced.to_vec()));
    for (name, text, replaced) in own.into_iter().chain(others) {
        let whole = model(text, &replaced).run(&mut Silent);
        let (mut number, mut put_back) = (0, 0);
        let (_, outcome) = led(model(text, &replaced), |simulation, event| {
            number += 1;
            let marched = simulation.stands_at().time > 0.0;
            if number % 3 != 1 || marched && event != Event::Step {
                return;
            }
            let before = state(simulation);
            simulation.set_state(&before).unwrap();
            assert!(state(simulation) == before, "{name}");
            simulation.sheet(true).unwrap();
            put_back += 1;
        });
        assert!(put_back > 0, "{name}");
        same(&outcome, &whole);
    }
}

/// A quantity at a particle at a record is what stands in the row, forces among them.
#[test]
fn what_is_read_at_a_record_is_what_the_row_says() {
    for (name, analysis) in ANALYSES {
        if ["linear", "modal", "harmonic", "random-vibration", "buckling"].contains(&name) {
            continue;
        }
        let mut seen = 0;
        led(strip(analysis), |simulation, event| {
            if event != Event::Record {
                return;
            }
            let (curve, body) = (simulation.curve(), simulation.body());
            let row = |column: &str| *curve.column(column).unwrap().last().unwrap();
            let nearest = |place: Vec3| {
                let rest = body.configuration().rest;
                let away = |a: &usize| (rest[*a] - place).norm();
                (0..rest.len()).min_by(|a, b| away(a).total_cmp(&away(b))).unwrap()
            };
            let (tip, root) = (nearest(Vec3::new(4.0, 0.5, 0.0)), nearest(Vec3::new(0.0, 0.5, 0.0)));
            let read = |of, particle| body.read(of, particle, &Vec3::z());
            assert_eq!(read(Measured::Displacement, tip).to_bits(), row("w").to_bits(), "{name}");
            assert_eq!(read(Measured::Reaction, root).to_bits(), row("f").to_bits(), "{name}");
            if name != "arc-length" {
                assert_eq!(simulation.stands_at().level, row("level"), "{name}");
            }
            let time = curve.column("time").map_or(0.0, |times| *times.last().unwrap());
            assert_eq!(simulation.stands_at().time, time, "{name}");
            seen += 1;
        });
        assert!(seen > 0, "{name}");
    }
}

/// Keeps frames in memory.
struct Sheets(Vec<Sheet>);

impl FieldSink for Sheets {
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError> {
        self.0.push(frame.sheet(true)?);
        Ok(())
    }
}

#[test]
fn a_sheet_is_the_frame_of_the_same_instant() {
    for (name, analysis) in [ANALYSES[0], ANALYSES[1], ANALYSES[3], ANALYSES[6]] {
        let mut sheets = Sheets(Vec::new());
        let options =
            RunOptions { progress: &mut Silent, checkpoints: None, fields: Some(&mut sheets), from: None };
        strip(analysis).run_with(options).unwrap();
        let mut seen = Vec::new();
        led(strip(analysis), |simulation, event| {
            if event == Event::Record {
                seen.push(simulation.sheet(true).unwrap());
            }
        });
        // Without time the first event is two rows, of which the second is the state.
        let frames = sheets.0.len();
        assert!(sheets.0[frames - seen.len()..] == seen, "{name}: {frames} frames");
    }
}

#[test]
fn a_run_that_is_left_goes_on_from_its_checkpoint_to_the_same_bits() {
    for (name, analysis) in [ANALYSES[0], ANALYSES[1], ANALYSES[3], ANALYSES[4], ANALYSES[6]] {
        let whole = strip(analysis).run(&mut Silent);
        // In the middle of the step in which the first record is taken, between two steps or levels.
        for after in [1, 2] {
            let folder = folder(&format!("left-{}-{after}", name.replace(' ', "-")));
            std::fs::write(folder.join(SCENE_COPY), STRIP).unwrap();
            let replaced = pairs(&[("analysis", analysis)]);
            let origin = Origin::new(STRIP, "test.toml".into(), replaced, 1);
            let mut checkpoints = Checkpoints::new(&folder, origin, 3600.0);
            let progress = &mut Silent;
            let options =
                RunOptions { progress, checkpoints: Some(&mut checkpoints), fields: None, from: None };
            let mut simulation = Simulation::with_options(strip(analysis), options).unwrap();
            for _ in 0..after {
                simulation.advance().unwrap();
            }
            let left = simulation.finish();
            assert!(matches!(left.ended, Ended::Interrupted { .. }), "{name}: {:?}", left.ended);
            assert!(left.curve.rows.len() < whole.curve.rows.len(), "{name}");
            same(&go_on(&folder, &mut Silent), &whole);
        }
    }
}

#[test]
fn another_state_is_gone_on_from_and_one_of_another_body_is_refused() {
    let whole = strip(ANALYSES[1].1).run(&mut Silent);
    let mut number = 0;
    let (_, pushed) = led(strip(ANALYSES[1].1), |simulation, _| {
        number += 1;
        if number != 20 {
            return;
        }
        let mut other = state(simulation);
        assert_eq!(simulation.set_state(&other[1..]), Err(Mismatch));
        other.iter_mut().for_each(|array| array.numbers.to_mut().iter_mut().for_each(|x| *x *= 1.001));
        simulation.set_state(&other).unwrap();
    });
    let ends = [&whole, &pushed].map(|outcome| *outcome.curve.column("w").unwrap().last().unwrap());
    assert!(ends[0] != ends[1] && (ends[0] / ends[1] - 1.0).abs() < 0.1, "{ends:?}");
    assert_eq!(whole.curve.rows.len(), pushed.curve.rows.len());
}

#[test]
fn runs_led_in_turns_and_on_more_threads_have_the_bits_that_they_have_alone() {
    let [march, levels] = [ANALYSES[1].1, ANALYSES[3].1];
    let alone = [march, levels].map(|analysis| strip(analysis).run(&mut Silent));
    let on_two = overridden(STRIP, "test.toml", &[("analysis", march)]).unwrap().build(2).unwrap();
    let mut simulations = [Simulation::new(on_two), Simulation::new(strip(levels))];
    while simulations.iter().any(|simulation| simulation.ended().is_none()) {
        simulations.iter_mut().for_each(|simulation| assert!(simulation.advance().is_ok()));
    }
    for (simulation, alone) in simulations.into_iter().zip(&alone) {
        let outcome = simulation.finish();
        assert_eq!(outcome.curve.rows, alone.curve.rows);
        assert_eq!(outcome.shapes, alone.shapes);
    }
}

#[test]
fn a_failure_is_reported_once_and_what_came_before_is_kept() {
    let short = strip("{ arc-length = { until = 1.0, steps = 2 } }");
    let mut simulation = Simulation::new(short);
    let failure = simulation.advance().unwrap_err();
    assert!(matches!(*failure, Failure::Steps { steps: 2, .. }), "{failure}");
    assert_eq!(simulation.advance(), Ok(Event::End));
    let outcome = simulation.finish();
    assert_eq!(outcome.curve.rows.len(), 3);
    assert_eq!(outcome.ended, Ended::Diverged(*failure));
}
