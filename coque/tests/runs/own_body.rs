//! A body that no scene knows goes through every analysis, checkpoints, fields and the estimate: the interface is whole.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use crate::chain::Chain;
use coque::scene::bounded::{
    Modes, NotNegative, Positive, RelaxationIterations, RelaxedResidual, Residual, Safety,
};
use coque::scene::{
    Analysis, Explicit, Fields, Levels, Linear, Measured, Modal, Output, Relaxation, RelaxationDamping,
    Static, Transient,
};
use coque::{
    Checkpoint, Checkpoints, Description, Ended, FieldFiles, Force, Length, Model, Origin, Outcome, Probe,
    Progress, ProgressReport, Ready, RunOptions, SCENE_COPY, Silent, Task, Time, Units, listed,
};
use sph_core::Vec3;

const BEADS: usize = 6;

fn model(analysis: Analysis) -> Model {
    let chain = Box::new(Chain::new(BEADS));
    let body =
        if let Analysis::Explicit(_) = analysis { Ready::Dynamic(chain) } else { Ready::Static(chain) };
    let units = Units { length: Length::Metre, force: Force::Newton, time: Time::Second, by_depth: false };
    let task = Task { title: "Beads".into(), units, analysis, output: Output::default() };
    let description = Description { kind: "chain", particles: BEADS, dof: BEADS, ..Description::default() };
    let end = Probe::new("u", Measured::Displacement, vec![BEADS as u32 - 1], Vec3::x());
    Model::new(task, body, description, vec![end])
}

fn transient() -> Analysis {
    let run = Transient {
        duration: Positive::new(400.0).unwrap(),
        record_every: Positive::new(10.0).unwrap(),
        damping: NotNegative::new(0.25).unwrap(),
        base: None,
    };
    Analysis::Explicit(Explicit {
        safety: Safety::new(0.5).unwrap(),
        quasi_static: None,
        transient: Some(run),
    })
}

fn last(outcome: &Outcome, column: &str) -> f64 {
    assert_eq!(outcome.ended, Ended::Done);
    *outcome.curve.column(column).unwrap().last().unwrap()
}

/// Under the force λ each of the n springs is stretched by λ: the end moves by nλ, ½nλ² is stored.
#[test]
fn every_analysis_finds_the_stretched_chain() {
    let levels = || Levels::Equal(4);
    let statics =
        Analysis::Static(Static { tolerance: Residual::new(1e-12).unwrap(), ..Static::at(levels()) });
    let damping = RelaxationDamping::Kinetic;
    let relaxed = Relaxation {
        levels: levels(),
        tolerance: RelaxedResidual::new(1e-8).unwrap(),
        damping,
        iterations: RelaxationIterations::new(10_000).unwrap(),
        force: NotNegative::default(),
    };
    for (name, analysis, bound) in [
        ("static", statics, 1e-12),
        ("relaxation", Analysis::Relaxation(relaxed), 1e-6),
        ("linear", Analysis::Linear(Linear::default()), 1e-9),
        ("march", transient(), 1e-4),
    ] {
        let outcome = model(analysis).run(&mut Silent);
        let (u, stored) = (last(&outcome, "u"), last(&outcome, "internal"));
        assert!((u / BEADS as f64 - 1.0).abs() < bound, "{name}: {u}");
        assert!((stored / (0.5 * BEADS as f64) - 1.0).abs() < 2.0 * bound, "{name}: {stored}");
    }
    let outcome = model(Analysis::Modal(Modal { modes: Modes::new(2).unwrap() })).run(&mut Silent);
    let found = outcome.curve.column("circular_frequency").unwrap();
    for (k, omega) in found.iter().enumerate() {
        let angle = (2 * k + 1) as f64 * std::f64::consts::PI / (2.0 * (2 * BEADS + 1) as f64);
        assert!((omega / (2.0 * libm::sin(angle)) - 1.0).abs() < 1e-9, "mode {k}: {omega}");
    }
}

/// Ends a run after so many steps.
struct Patience(u64);

impl Progress for Patience {
    fn update(&mut self, report: &ProgressReport) -> ControlFlow<()> {
        if report.steps >= self.0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("own-body").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn it_goes_on_from_its_checkpoint_and_shows_its_fields() {
    let folder = folder("resumed");
    fs::write(folder.join(SCENE_COPY), "no scene").unwrap();
    let origin = || Origin::new("no scene", "beads".into(), Vec::new(), 1);
    let run = |patience: u64, from: Option<Checkpoint>| {
        let mut checkpoints = Checkpoints::new(&folder, origin(), 1e9);
        let wanted = Fields::MOTION;
        let frames = from.as_ref().map_or(0, Checkpoint::frames);
        let mut files = FieldFiles::go_on(&folder, "beads", &wanted, frames).unwrap();
        let options = RunOptions {
            progress: &mut Patience(patience),
            checkpoints: Some(&mut checkpoints),
            fields: Some(&mut files),
            from,
        };
        model(transient()).run_with(options).unwrap()
    };
    assert!(matches!(run(333, None).ended, Ended::Interrupted { .. }));
    let resumed = run(u64::MAX, Some(Checkpoint::read(&folder).unwrap().0));
    let whole = model(transient()).run(&mut Silent);
    assert_eq!(resumed.curve.rows, whole.curve.rows);
    assert_eq!(resumed.shapes, whole.shapes);
    let frames = listed(&folder.join("beads.pvd")).unwrap();
    assert_eq!(frames.len(), whole.curve.rows.len());
}

#[test]
fn what_it_costs_is_estimated() {
    let estimate = model(transient()).estimate();
    assert_eq!(estimate.steps, Some([800.0; 2]));
    let levels = Levels::Equal(4);
    let statics = Analysis::Static(Static { tolerance: Residual::new(1e-12).unwrap(), ..Static::at(levels) });
    assert!(model(statics).estimate().seconds.unwrap()[1] > 0.0);
}
