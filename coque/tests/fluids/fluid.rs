//! Fluids, their walls and the structures in them, from the scene to the curve.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;

use crate::common::fields::{Read, folder, listed, run};
use crate::common::fluids::{DAM, GATE, SHELL_GATE};
use crate::common::{column, last};
use coque::scene::Fields;
use coque::{Ended, FieldFiles, Outcome, Scene, Silent, WarningKind, Written};

/// Runs a scene after replacements of one text by another.
fn ran(text: &str, replaced: &[(&str, &str)], threads: usize) -> Outcome {
    let text = replaced.iter().fold(text.to_string(), |text, (from, to)| {
        assert!(text.contains(from), "the scene no longer says {from}");
        text.replacen(from, to, 1)
    });
    Scene::parse(&text, "scene.toml").unwrap().build(threads).unwrap().run(&mut Silent)
}

fn bits(outcome: &Outcome) -> Vec<Vec<u64>> {
    outcome.curve.rows.iter().map(|row| row.iter().map(|x| x.to_bits()).collect()).collect()
}

/// The tank as wide as the water: nothing flows.
const FULL: (&str, &str) = ("max = [0.4, 0.4]", "max = [0.1, 0.4]");

#[test]
fn still_water_presses_as_it_is_deep() {
    let gauge = ("nearest = [0.4, 0.02, 0.0]", "nearest = [0.05, 0.0, 0.0]");
    let outcome = ran(DAM, &[FULL, gauge, ("duration = 0.05", "duration = 0.2")], 1);
    assert_eq!(outcome.ended, Ended::Done);
    let mean = |name: &str| {
        let all = column(&outcome, name);
        all.iter().sum::<f64>() / all.len() as f64
    };
    // ρgH at the floor, ρgH²/2 on the side, 2000 and 200: ten rows of particles are deep to half a spacing, a part in twenty.
    for (name, exact, within) in [("p", 2000.0, 0.08), ("F", -200.0, 0.08)] {
        let error = mean(name) / exact - 1.0;
        assert!(error.abs() < within, "{name}: {error}");
    }
    // The surface lies half a spacing over the highest particles; half of that is not distinguished.
    assert!((mean("h") - 0.2).abs() < 0.01, "{}", mean("h"));
    let figures = outcome.summary.record.fluid.clone().unwrap();
    assert_eq!(figures.mass, 1000.0 * 0.1 * 0.2);
    assert!(figures.greatest_density_error < 0.01, "{figures:?}");
    assert!(outcome.summary.record.warnings.is_empty(), "{:?}", outcome.summary.record.warnings);
}

#[test]
fn water_that_ran_is_warned_of_while_its_artificial_viscosity_brakes_it() {
    let warned = |alpha: &str| {
        let braked = format!("sound_speed = 20.0 }}\nformulation.weakly-compressible.viscosity = {alpha}");
        let outcome =
            ran(DAM, &[("duration = 0.05", "duration = 0.15"), ("sound_speed = 20.0 }", &braked)], 1);
        let warnings = outcome.summary.record.warnings;
        warnings.into_iter().find(|warning| warning.kind == WarningKind::LateFront)
    };
    // ν = α c₀ h/8 with h = 1.55 · .02: Re = √(10 · .2) · .2/.00155 = 182, so 16.5/182 + .85/√182 = 15 % late.
    let message = warned("0.02").unwrap().message;
    assert!(
        message.contains("Reynolds number of 182") && message.contains("may come 15 % too late"),
        "{message}"
    );
    assert_eq!(warned("1e-4"), None);
}

#[test]
fn a_dam_break_keeps_its_energy_balance_and_runs_away() {
    let outcome = ran(DAM, &[("duration = 0.05", "duration = 0.15")], 1);
    let (front, external) = (column(&outcome, "front"), column(&outcome, "external"));
    assert!(front.windows(2).skip(1).all(|pair| pair[0] < pair[1]), "{front:?}");
    // The dam break of ten rows is off its figures, but what gravity gives is found again: measured 0.4 %.
    let error = outcome.summary.record.energies.balance_error;
    assert!(error.abs() < 0.02 * external.last().unwrap().abs(), "{error} of {external:?}");
    // Walls stay, and the fluid does not pass them.
    assert!(outcome.shapes[0].positions.iter().all(|x| x.y > -0.06 && x.x > -0.06), "leaks");
}

/// Water falls on the floor of its tank: means over records have the whole impulse, however long the records are; instants lose
/// what comes and goes between two of them.
#[test]
fn an_impact_shorter_than_a_record_is_in_the_mean() {
    let dropped = [
        ("spacing = 0.02 }", "spacing = 0.02, origin = [0.1, 0.05] }"),
        ("duration = 0.05, record_every = 0.01", "duration = 0.24, record_every = 0.04"),
        (
            "{ name = \"p\", of = \"pressure\", on = \"gauge\" }",
            "{ name = \"J\", of = \"force\", on = \"tank.all\", direction = [0, 1, 0] }",
        ),
        (
            "{ name = \"h\", of = \"level\", on = \"gauge\" }",
            "{ name = \"v\", of = \"velocity\", on = \"water.all\", direction = [0, 1, 0] }",
        ),
    ];
    let outcome = ran(DAM, &dropped, 1);
    assert_eq!(outcome.ended, Ended::Done);
    let (time, now, mean) = (column(&outcome, "time"), column(&outcome, "J"), column(&outcome, "J_mean"));
    assert_eq!(mean[0], now[0]);
    let sum = |force: &dyn Fn(usize) -> f64| -> f64 {
        (1..time.len()).map(|row| (time[row] - time[row - 1]) * force(row)).sum()
    };
    // What the tank got, its weight gave to the water (20 kg/m, 10 m/s²) and the water has no more.
    let (mass, end) = (20.0, time.len() - 1);
    let exact = -mass * (10.0 * time[end] + last(&outcome, "v"));
    let (by_means, by_instants) = (sum(&|row| mean[row]), sum(&|row| 0.5 * (now[row] + now[row - 1])));
    println!("{exact} {by_means} {by_instants}");
    // Measured 6e-4 and 14 %: the velocity is that after the kick, half a step later.
    assert!((by_means / exact - 1.0).abs() < 2e-3, "{by_means} {exact}");
    assert!((by_instants / exact - 1.0).abs() > 0.1, "{by_instants} {exact}");
}

#[test]
fn threads_change_no_bit_of_a_fluid() {
    let [one, two, four] = [1, 2, 4].map(|threads| bits(&ran(DAM, &[], threads)));
    assert_eq!(one, two);
    assert_eq!(one, four);
}

#[test]
fn a_moment_moves_with_its_point() {
    let columns = "{ name = \"F\", of = \"force\", on = \"tank.x0\", direction = [1, 0, 0] },";
    let more = format!(
        "{columns} {{ name = \"Fy\", of = \"force\", on = \"tank.x0\", direction = [0, 1, 0] }},
        {{ name = \"M\", of = \"moment\", on = \"tank.x0\", direction = [0, 0, 1] }},
        {{ name = \"Mp\", of = \"moment\", on = \"tank.x0\", direction = [0, 0, 2], about = [0.3, 0.1, 0.0] }},"
    );
    let outcome = ran(DAM, &[(columns, &more)], 1);
    let of = |name: &str| last(&outcome, name);
    // M about p is M − p × F, along a unit vector whatever its length in the scene.
    let moved = of("M") - (0.3 * of("Fy") - 0.1 * of("F"));
    assert!((of("Mp") - moved).abs() < 1e-9 * of("M").abs().max(1.0));
    assert!(of("M") > 0.0, "water pushes the left wall to the left, above the origin");
    let units: Vec<&str> = outcome.curve.columns.iter().map(|column| column.unit.as_str()).collect();
    assert_eq!(
        units[6..],
        ["m", "N/m²", "m", "N/m", "N/m", "N/m", "N/m", "N m/m", "N m/m", "N m/m", "N m/m"]
    );
}

#[test]
fn water_leans_on_a_gate_of_a_shell() {
    let force = "curve = [{ name = \"F\", of = \"force\", on = \"gate.all\", direction = [1, 0, 0] }, ";
    let outcome = ran(SHELL_GATE, &[("curve = [", force)], 1);
    assert_eq!(outcome.ended, Ended::Done);
    // ρgH²/2 at the start, 128: sixteen rows are deep to half a spacing.
    let thrust = column(&outcome, "F")[0];
    assert!((thrust / 128.0 - 1.0).abs() < 0.06, "{thrust}");
    assert!(last(&outcome, "dx") > 1e-6, "{:?}", column(&outcome, "dx"));
    let summary = serde_json::to_value(&outcome.summary).unwrap();
    assert_eq!(summary["kind"], "coupled");
    assert_eq!(summary["bodies"]["gate"]["kind"], "shell");
    let figures = outcome.summary.record.fluid.clone().unwrap();
    assert!(figures.substeps > 0 && figures.most_substeps > 0);
    // ρ₀c₀Δt/(ρ_s t), Δt about 0.24 h/c₀: 1000·0.24·0.013/(1100·0.02) = 0.14.
    assert!((0.1..0.2).contains(&figures.added_mass[0]), "{figures:?}");
}

#[test]
fn water_leans_on_a_gate_of_a_solid() {
    let outcome = ran(GATE, &[], 1);
    assert_eq!(outcome.ended, Ended::Done);
    let thrust = column(&outcome, "F")[0];
    assert!((thrust / 128.0 - 1.0).abs() < 0.06, "{thrust}");
    assert!(last(&outcome, "dx") > 1e-6, "{:?}", column(&outcome, "dx"));
    // The lone solid of the same scene has the same nodes and degrees of freedom.
    let bodies = &outcome.summary.body.bodies;
    let [curve, gate] = ["curve = [", "[bodies.gate"].map(|part| GATE.find(part).unwrap());
    let alone = format!("{}{}", &GATE[..curve], &GATE[gate..]);
    let lone = Scene::parse(&alone, "alone.toml").unwrap().build(1).unwrap().describe();
    assert_eq!((bodies["gate"].particles, bodies["gate"].dof), (lone.particles, lone.dof));
}

#[test]
fn each_body_has_frames_of_its_own() {
    let folder = folder("gate");
    let scene = Scene::parse(SHELL_GATE, "scene.toml").unwrap();
    let wanted = Fields { extruded: true, ..Fields::MOTION };
    let bodies = ["water", "gate", "tank"].map(|name| Written { name, shell: name == "gate", tools: false });
    let mut files = FieldFiles::create_all(&folder, &bodies, &wanted).unwrap();
    let outcome = run(&scene, &mut files);
    let names = ["water", "gate", "tank", "gate-solid"];
    let frames: Vec<usize> = names.map(|name| listed(&folder.join(format!("{name}.pvd"))).len()).into();
    // One at each record.
    assert_eq!(frames, [6; 4]);
    assert!(!folder.join("water-solid.pvd").exists());
    assert_eq!(outcome.summary.record.frames, 6);
    let read = |name: &str| Read::new(&listed(&folder.join(format!("{name}.pvd"))).last().unwrap().1);
    let [water, gate, tank, thick] = names.map(read);
    let points = |read: &Read| read.get("Points").len() / 3;
    let count = |name: &str| outcome.summary.body.bodies[name].particles;
    assert_eq!([points(&water), points(&gate), points(&tank)], ["water", "gate", "tank"].map(count));
    assert_eq!(water.get("pressure").len(), 160);
    assert_eq!(water.get("velocity").len(), 480);
    // p²/2K by volume: one K of all particles, to what compression of a part in a hundred changes.
    let moduli = water.get("pressure").iter().zip(water.get("compression_energy"));
    let moduli: Vec<f64> =
        moduli.filter(|(p, _)| **p > 100.0).map(|(p, stored)| 0.5 * p * p / stored).collect();
    let [least, most] = [f64::min, f64::max].map(|pick| moduli.iter().copied().reduce(pick).unwrap());
    assert!(least > 0.0 && most / least < 1.05, "{least} {most}");
    assert!(gate.get("displacement").iter().any(|&u| u != 0.0));
    // Both faces of the strip, a thickness apart.
    assert_eq!(points(&thick), 2 * points(&gate));
    let (lower, upper) = thick.get("Points").split_at(3 * points(&gate));
    for (low, high) in lower.chunks(3).zip(upper.chunks(3)) {
        let square: f64 = low.iter().zip(high).map(|(a, b)| (a - b) * (a - b)).sum();
        assert!((square.sqrt() - 0.02).abs() < 1e-12, "{low:?} {high:?}");
    }
    assert!(fs::read_dir(&folder).unwrap().count() >= 28);
}

/// A cantilever, and the same placed elsewhere with its load turned along.
#[test]
fn a_placed_shell_answers_the_same() {
    const TEXT: &str = r#"title = "Cantilever"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [10.0, 1.0], particles = [11, 3] }
material.elastic = { young = 1.2e6, poisson = 0.3, density = 1.0 }
section.homogeneous = { thickness = 0.1 }
supports = [{ on = "u0", clamped = {} }]
loads = [{ on = "u1", force = { total = [0.0, 0.0, 1.0] } }]
analysis.static = { levels = 2 }
curve = [{ name = "w", of = "displacement", on = "u1", direction = [0.0, 0.0, 1.0] }]
"#;
    let plain = last(&ran(TEXT, &[], 1), "w");
    let placed = ran(
        TEXT,
        &[
            ("supports", "placed = { origin = [3.0, -2.0, 1.0], u = [0, 2, 0], v = [0, 0, 1] }\nsupports"),
            ("total = [0.0, 0.0, 1.0]", "total = [1.0, 0.0, 0.0]"),
            ("direction = [0.0, 0.0, 1.0]", "direction = [1.0, 0.0, 0.0]"),
        ],
        1,
    );
    // Newton's tolerance.
    assert!((last(&placed, "w") / plain - 1.0).abs() < 1e-7, "{plain}, {}", last(&placed, "w"));
    let far = placed.shapes[0].positions.iter().map(|x| (x.x - 3.0).abs()).fold(0.0, f64::max);
    assert_eq!(far, 0.0);
}
