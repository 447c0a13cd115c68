//! A scene that several run together: the first of them finds what one alone finds, to the bit. Threads stand for processes here; mpirun.rs has
//! processes.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use std::ops::ControlFlow;

use common::{Replaced, scene};
use coque::{Ended, Outcome, Progress, ProgressReport, Ranks, RunOptions, Silent};
use peers::together;

/// Scenes of several chunks that take a second or two, one for each way to march and one that relaxes, and of what everyone evaluates for all of
/// the shell: tools, a shell that touches itself, a gas; one that is heated.
const SHELLS: [(&str, Replaced<'static>); 8] = [
    (
        "panel.toml",
        &[
            ("geometry.cylinder.particles", "[31, 35]"),
            ("analysis.explicit.quasi-static", "{ levels = [0.03, 0.05], tolerance = 1e-3 }"),
        ],
    ),
    (
        "plate.toml",
        &[
            ("geometry.plate.particles", "[41, 41]"),
            ("analysis", "{ explicit = { transient = { duration = 0.02, record_every = 0.002 } } }"),
        ],
    ),
    (
        "ring-struck.toml",
        &[
            ("geometry.cylinder.particles", "[91, 9]"),
            ("analysis.explicit.transient", "{ duration = 2e-5, record_every = 2e-6 }"),
        ],
    ),
    (
        "panel.toml",
        &[
            ("geometry.cylinder.particles", "[31, 35]"),
            ("analysis", "{ relaxation = { levels = [0.03, 0.06] } }"),
        ],
    ),
    (
        "tube-crushed.toml",
        &[
            ("geometry.cylinder.particles", "[201, 5]"),
            ("tools.0.friction", "0.2"),
            ("curve.4.name", "taken"),
            ("tools.0.moved", "[0.0, 0.0, -2.0]"),
            ("tools.0.amplitude", "{ ramp = 5e-5 }"),
            ("analysis", "{ explicit = { transient = { duration = 5e-5, record_every = 1e-5 } } }"),
        ],
    ),
    (
        "ring-in-itself.toml",
        &[
            ("geometry.cylinder.particles", "[241, 5]"),
            ("analysis", "{ relaxation = { levels = [0.1, 0.31] } }"),
        ],
    ),
    (
        "plate-on-gas.toml",
        &[
            ("geometry.plate.particles", "[31, 31]"),
            ("analysis", "{ explicit = { transient = { duration = 0.05, record_every = 0.01 } } }"),
        ],
    ),
    (
        "bimetal-strip.toml",
        &[
            ("geometry.plate.particles", "[101, 11]"),
            ("analysis", "{ explicit = { transient = { duration = 1e-4, record_every = 2e-5 } } }"),
        ],
    ),
];

/// What a run found, wall times apart.
fn found(outcome: &Outcome) -> String {
    let record = coque::RunRecord { wall_seconds: 0.0, ..outcome.summary.record.clone() };
    let rows: Vec<Vec<u64>> =
        outcome.curve.rows.iter().map(|row| row.iter().map(|x| x.to_bits()).collect()).collect();
    format!("{:?} {rows:?} {record:?} {:?}", outcome.ended, outcome.shapes)
}

/// The same of bonds that break and of fluids.
const OTHERS: [(&str, Replaced<'static>); 8] = [
    (
        "crack-branching.toml",
        &[
            ("bodies.glass.solid.geometry.block.spacing", "2e-3"),
            ("supports", "[{ on = \"x0\", held = { displacement = [[1, 0, 0], [0, 1, 0]] } }]"),
            ("analysis", "{ explicit = { quasi-static = { levels = [0.01, 0.02], tolerance = 1e-3 } } }"),
        ],
    ),
    (
        "crack-branching.toml",
        &[
            ("bodies.glass.solid.geometry.block.spacing", "1e-3"),
            ("bodies.glass.solid.contact", "{}"),
            ("analysis.explicit.transient.record_every", "5e-6"),
        ],
    ),
    ("gate.toml", &[("analysis.explicit.transient.duration", "0.02")]),
    ("gate-bonds.toml", &[("analysis.explicit.transient.duration", "0.02")]),
    ("dam-break.toml", &[("analysis.explicit.transient.duration", "0.2")]),
    ("floating-box.toml", &[("analysis.explicit.transient.duration", "0.1")]),
    ("wave-flume.toml", &[("analysis.explicit.transient.duration", "0.1")]),
    (
        "bar-bonds-yielding.toml",
        &[
            ("bodies.bar.solid.geometry.block.spacing", "0.5"),
            ("analysis.explicit.transient", "{ duration = 5e-5, record_every = 1e-5 }"),
        ],
    ),
];

#[test]
fn the_first_finds_what_one_alone_finds() {
    for (number, (name, replaced)) in SHELLS.into_iter().chain(OTHERS).enumerate() {
        let alone = found(&common::done(name, replaced));
        let (count, threads) = [(2, 2), (3, 1)][number % 2];
        let all = together(count, |peers| {
            let mut model = scene(name, replaced).unwrap().build(threads).unwrap();
            model.share(&Ranks::new(peers)).unwrap();
            found(&model.run(&mut Silent))
        });
        assert!(all.unwrap()[0] == alone, "{name}, {count} of {threads} threads");
    }
}

/// Asks for the end in the step of a number.
struct EndsAt(Option<u64>);

impl Progress for EndsAt {
    fn update(&mut self, news: &ProgressReport) -> ControlFlow<()> {
        if self.0.is_some_and(|step| news.steps >= step) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }
}

/// One of three is asked to end: all end behind the same step.
#[test]
fn who_is_asked_to_end_ends_all() {
    let (name, replaced) = SHELLS[1];
    for asked in 0..3 {
        let all = together(3, |peers| {
            let ranks = Ranks::new(peers);
            let mut model = scene(name, replaced).unwrap().build(1).unwrap();
            model.share(&ranks).unwrap();
            let mut progress = EndsAt((ranks.rank() == asked).then_some(20));
            let options = RunOptions { progress: &mut progress, checkpoints: None, fields: None, from: None };
            let outcome = model.run_with(options).unwrap();
            assert!(matches!(outcome.ended, Ended::Interrupted { .. }), "{}", outcome.ended);
            outcome.summary.record.steps
        });
        assert_eq!(all.unwrap(), [21; 3], "asked of {asked}");
    }
}

/// The program without MPI, started three times by a launcher: once it says why it does nothing.
#[test]
fn a_launcher_of_several_is_refused_by_the_program_without_mpi() {
    for (rank, words) in [("0", 1), ("2", 0)] {
        for (size, number) in
            [("OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"), ("SLURM_STEP_NUM_TASKS", "SLURM_PROCID")]
        {
            let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_coque"));
            let run =
                command.args(["run", "no-scene.toml"]).env(size, "3").env(number, rank).output().unwrap();
            let said = String::from_utf8_lossy(&run.stderr);
            assert_eq!(run.status.code(), Some(2), "{said}");
            assert_eq!(
                said.matches(&format!("a launcher started 3 processes ({size})")).count(),
                words,
                "{said}"
            );
            assert!(!said.contains("no-scene"), "{said}");
        }
    }
}

#[test]
fn what_one_process_runs_alone_is_refused() {
    let refused = |name: &str, replaced: Replaced| {
        let all = together(2, |peers| {
            let mut model = scene(name, replaced).unwrap().build(1).unwrap();
            model.share(&Ranks::new(peers)).unwrap_err()
        });
        let all = all.unwrap();
        assert_eq!(all[0], all[1]);
        all[0]
    };
    let coarse = ("geometry.plate.particles", "[11, 11]");
    let marched = ("analysis", "{ explicit = { transient = { duration = 0.001, record_every = 0.001 } } }");
    let settled = ("analysis", "{ explicit = { quasi-static = { levels = [0.1] } } }");
    for (name, replaced, said) in [
        (
            "scordelis-lo.toml",
            &[][..],
            "[analysis.linear] runs in one process, but 2 were started together: start one",
        ),
        (
            "plate.toml",
            &[coarse, marched, ("error", "{}")],
            "leave out [error], --error, --accuracy and --chart",
        ),
        (
            "plate.toml",
            &[coarse, marched, ("formulation.nodal.order", "1")],
            "not sampled in cells (formulation) runs in one process",
        ),
        ("plate-pd.toml", &[settled], "a plate of two sheets (formulation.two-sheets) runs in one process"),
        (
            "plate-on-plate.toml",
            &[],
            "a scene of several bodies with [analysis.explicit.transient] runs in one process",
        ),
        ("block-on-flat.toml", &[], "runs in one process"),
    ] {
        let words = refused(name, replaced).to_string();
        println!("{words}");
        assert!(words.contains(said) && words.contains("2 were started together"), "{words}");
    }
}
