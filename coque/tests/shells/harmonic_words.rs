//! Steady vibration: what a run says, where it ends, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::ops::ControlFlow;

use super::harmonic::{MODES, PLATE, SHAKEN, UNREAD, plate};
use crate::common::{Replaced, last, overridden, ran, refusal};
use coque::{Ended, Progress, ProgressReport, WarningKind};

/// Ends a run at a level.
struct Until(f64);

impl Progress for Until {
    fn update(&mut self, news: &ProgressReport) -> ControlFlow<()> {
        if news.level < self.0 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }
}

#[test]
fn it_ends_between_two_frequencies_when_asked() {
    let model = overridden(PLATE, "plate.toml", &[]).unwrap().build(1).unwrap();
    let outcome = model.run(&mut Until(60.0));
    assert_eq!(outcome.ended, Ended::Interrupted { time: 0.0, level: 60.0 });
    assert_eq!(outcome.curve.rows.len(), 2);
}

#[test]
fn resonance_without_damping_is_said() {
    let modes = plate(&[MODES, UNREAD, ("loads", "[]")]);
    let list = format!("[{:.17e}]", last(&modes, "frequency"));
    let bare = "{ harmonic = { frequencies = [20.0], modes = 1 } }";
    let outcome =
        ran(overridden(PLATE, "plate.toml", &[("analysis", bare), ("analysis.harmonic.frequencies", &list)]));
    let said = outcome.summary.ended.to_string();
    assert!(said.contains("nothing damps the vibration"), "{said}");
}

#[test]
fn what_is_doubtful_is_said() {
    let kinds = |replaced: Replaced| -> Vec<WarningKind> {
        let outcome = plate(replaced);
        let kinds = outcome.summary.record.warnings.iter().map(|warning| warning.kind);
        kinds.filter(|&kind| kind != WarningKind::FewParticles).collect()
    };
    let fine = ("analysis.harmonic.frequencies", "{ from = 15.0, to = 60.0, points = 301 }");
    let rough = ("analysis.harmonic.frequencies", "{ from = 15.0, to = 60.0, points = 31 }");
    let modes = ("analysis.harmonic.modes", "8");
    assert_eq!(kinds(&[fine]), []);
    assert_eq!(kinds(&[fine, modes]), []);
    assert_eq!(kinds(&[rough]), [WarningKind::CoarseFrequencies]);
    assert_eq!(kinds(&[rough, modes]), [WarningKind::CoarseFrequencies]);
    assert_eq!(kinds(&[fine, ("analysis.harmonic.modes", "1")]), [WarningKind::TruncatedModes]);
    for analysis in [
        "{ harmonic = { frequencies = [15.0, 17.0, 40.0] } }",
        "{ harmonic = { frequencies = [15.0, 17.0, 40.0], modes = 8 } }",
    ] {
        assert_eq!(kinds(&[("analysis", analysis)]), [WarningKind::Undamped], "{analysis}");
    }
    let low = "{ harmonic = { frequencies = [5.0, 7.0] } }";
    assert_eq!(kinds(&[("analysis", low)]), []);
    // Between two clamps it buckles at −25e6.
    let pushed = [
        fine,
        ("initial_stress", "[{ on = \"all\", axis = [1, 0, 0], membrane = [-60e6, 0.0, 0.0] }]"),
        ("supports[+]", "{ on = \"u1\", clamped = {} }"),
        ("loads[0].on", "\"there\""),
    ];
    assert!(kinds(&pushed).contains(&WarningKind::Unstable));
}

#[test]
fn vibrations_that_cannot_be_had() {
    let at = "analysis.harmonic.frequencies";
    let cases: [(&str, Replaced); 12] = [
        ("falling range", &[(at, "{ from = 5.0, to = 5.0, points = 3 }")]),
        ("one point", &[(at, "{ from = 5.0, to = 6.0, points = 1 }")]),
        ("nothing", &[(at, "[]")]),
        ("rest", &[(at, "[0.0, 1.0]")]),
        ("out of order", &[(at, "[2.0, 1.0]")]),
        (
            "ratio without modes",
            &[(
                "analysis.harmonic",
                "{ frequencies = [1.0], damping.ratio = 0.1, base.acceleration = [0, 0, 1] }",
            )],
        ),
        ("no Rayleigh", &[("analysis.harmonic.damping", "{ rayleigh = {} }")]),
        ("base at rest", &[("analysis.harmonic.base.acceleration", "[0, 0, 0]")]),
        ("a motion", &[("supports[+]", "{ on = \"u1\", moved = { direction = [0, 0, 1], by = 0.1 } }")]),
        ("no driver", &[("analysis.harmonic", "{ frequencies = [1.0] }")]),
        ("an energy", &[("curve[+]", "{ name = \"E\", of = \"energy\", on = \"all\" }")]),
        ("the greatest", &[("curve[0].take", "\"max\"")]),
    ];
    let said = cases.map(|(what, replaced)| format!("== {what}\n{}\n", refusal(SHAKEN, replaced, 100)));
    let yields =
        refusal("roof-collapsing.toml", &[("analysis", "{ harmonic = { frequencies = [1.0] } }")], 100);
    let several =
        refusal("joined-cantilevers.toml", &[("analysis", "{ harmonic = { frequencies = [1.0] } }")], 100);
    let phase = refusal(SHAKEN, &[("curve[1].name", "\"tip_phase\"")], 100);
    insta::assert_snapshot!(
        said.concat()
            + "== yields\n"
            + &yields
            + "\n== several\n"
            + &several
            + "\n== a name that is taken\n"
            + &phase
    );
}
