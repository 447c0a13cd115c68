//! Answers to response spectra and to noise: what is refused, what a run warns of.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use super::harmonic::plate;
use crate::common::{Replaced, refusal};
use coque::WarningKind;

const DECK: &str = "deck-by-spectrum.toml";
const PANEL: &str = "panel-in-noise.toml";

#[test]
fn spectra_and_noise_that_cannot_be_had() {
    let base = "analysis.response-spectrum.base";
    let first = "analysis.response-spectrum.base[0].amplitude";
    let density = "analysis.random-vibration.base[0].density";
    let cases: [(&str, &str, Replaced); 14] = [
        ("no base", DECK, &[(base, "[]")]),
        ("no direction", DECK, &[("analysis.response-spectrum.base[0].acceleration", "[0, 0, 0]")]),
        ("no spectrum", DECK, &[(base, "[{ acceleration = [0, 0, 1], by = \"period\" }]")]),
        ("no points", DECK, &[(first, "{ ramp = 1.0 }")]),
        ("out of order", DECK, &[(first, "{ table = [[0.2, 1.0], [0.1, 2.0]] }")]),
        ("a sign", DECK, &[(first, "{ table = [[0.1, 1.0], [0.2, -2.0]] }")]),
        ("a logarithm of nothing", DECK, &[("analysis.response-spectrum.base[0].logarithmic", "true")]),
        (
            "dampings that fall",
            DECK,
            &[(
                base,
                "[{ acceleration = [0, 0, 1], by = \"period\", damped = [{ ratio = 0.05, amplitude.table = [[0, 1]] }, { ratio = 0.02, amplitude.table = [[0, 1]] }] }]",
            )],
        ),
        ("a load", DECK, &[("loads", "[{ on = \"u1\", force = { total = [0, 0, 1] } }]")]),
        (
            "a stress without a sign",
            DECK,
            &[("curve[+]", "{ name = \"s\", of = \"von-mises\", on = \"all\" }")],
        ),
        ("no noise", PANEL, &[("analysis.random-vibration.base", "[]")]),
        ("one point", PANEL, &[(density, "[[20.0, 0.1]]")]),
        ("no power", PANEL, &[(density, "[[0.0, 0.1], [20.0, 0.1]]")]),
        (
            "noise of no loads",
            PANEL,
            &[("analysis.random-vibration.loads", "{ density = [[1.0, 1.0], [2.0, 1.0]] }")],
        ),
    ];
    let said = cases.map(|(what, scene, replaced)| format!("== {what}\n{}\n", refusal(scene, replaced, 100)));
    insta::assert_snapshot!(said.concat());
}

#[test]
fn what_is_doubtful_is_said() {
    let kinds = |replaced: Replaced| -> Vec<WarningKind> {
        let outcome = plate(&[&[("loads", "[]")], replaced].concat());
        let kinds = outcome.summary.record.warnings.iter().map(|warning| warning.kind);
        kinds.filter(|&kind| kind != WarningKind::FewParticles).collect()
    };
    let of = |modes: usize, base: &str| {
        format!(
            "{{ response-spectrum = {{ modes = {modes}, damping.ratio = 0.03, base = [{{ acceleration = [0, 0, 1], by = \"period\", {base} }}] }} }}"
        )
    };
    let flat = "amplitude.table = [[0.0, 1.0], [1.0, 1.0]]";
    assert_eq!(kinds(&[("analysis", &of(20, flat))]), []);
    assert_eq!(kinds(&[("analysis", &of(1, flat))]), [WarningKind::TruncatedModes]);
    let short = "amplitude.table = [[0.0, 1.0], [0.01, 1.0]]";
    assert_eq!(kinds(&[("analysis", &of(20, short))]), [WarningKind::BeyondSpectrum]);
    let damped = "damped = [{ ratio = 0.04, amplitude.table = [[0, 1], [1, 1]] }, { ratio = 0.05, amplitude.table = [[0, 1], [1, 1]] }]";
    assert_eq!(kinds(&[("analysis", &of(20, damped))]), [WarningKind::BeyondSpectrum]);
    let noise = |modes: usize| {
        format!(
            "{{ random-vibration = {{ modes = {modes}, damping.ratio = 0.03, frequencies = [5.0], \
             base = [{{ acceleration = [0, 0, 1], density = [[5.0, 1.0], [200.0, 1.0]] }}] }} }}"
        )
    };
    assert_eq!(kinds(&[("analysis", &noise(20))]), []);
    // Too few of the mass, and of the frequencies.
    let few = [WarningKind::TruncatedModes; 2];
    assert_eq!(kinds(&[("analysis", &noise(1))]), few);
}
