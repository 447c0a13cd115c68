//! Envelopes of fields over load cases: against the frames of the cases, over combinations, on other bodies; what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::refused::refused;
use crate::common::{Replaced, overridden, text};
use coque::{FieldError, FieldSink, Frame, RunOptions, Sheet, Silent};

const SLAB: &str = "two-span-cases.toml";
const SMALL: (&str, &str) = ("geometry.plate.particles", "[21, 3]");

/// Frames with their names and places.
#[derive(Default)]
struct Kept(Vec<(String, f64, Sheet)>);

impl FieldSink for Kept {
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError> {
        self.0.push((frame.case.unwrap_or_default().into(), frame.along, frame.sheet(true)?));
        Ok(())
    }
}

fn kept(text: &str, replaced: Replaced) -> Vec<(String, f64, Sheet)> {
    let mut sink = Kept::default();
    let model = overridden(text, "scene.toml", replaced).unwrap().build(1).unwrap();
    let run = RunOptions { progress: &mut Silent, checkpoints: None, fields: Some(&mut sink), from: None };
    let outcome = model.run_with(run).unwrap();
    assert_eq!(outcome.summary.record.frames as usize, sink.0.len(), "{}", outcome.summary.ended);
    sink.0
}

/// Holds the last four frames against those of the cases from number `first` to `last`.
fn check(frames: &[(String, f64, Sheet)], first: f64, last: f64) {
    let (cases, ends) = frames.split_at(frames.len() - 4);
    let names: Vec<&str> = ends.iter().map(|end| end.0.as_str()).collect();
    assert_eq!(names, ["least", "greatest", "size", "governing"]);
    assert_eq!(ends[0].1, cases.last().unwrap().1 + 1.0);
    let counted: Vec<_> = cases.iter().filter(|(_, along, _)| (first..=last).contains(along)).collect();
    assert!(counted.len() > 1);
    let rest: Vec<[f64; 3]> = ends[0].2.points.clone();
    for name in ["displacement", "von_mises", "moment", "stress_top", "reaction"] {
        let of = |sheet: &Sheet, name: &str| {
            sheet.point_data.get(name).or(sheet.cell_data.get(name)).map(|array| array.numbers.clone())
        };
        let Some(least) = of(&ends[0].2, name) else { continue };
        let [greatest, size] = [1, 2].map(|k| of(&ends[k].2, name).unwrap());
        let governing =
            of(&ends[3].2, if name == "displacement" { "displacement_in" } else { name }).unwrap();
        for i in 0..least.len() {
            let all: Vec<(f64, f64)> =
                counted.iter().map(|(_, along, sheet)| (*along, of(sheet, name).unwrap()[i])).collect();
            assert_eq!(least[i], all.iter().map(|x| x.1).fold(f64::INFINITY, f64::min));
            assert_eq!(greatest[i], all.iter().map(|x| x.1).fold(f64::NEG_INFINITY, f64::max));
            assert_eq!(size[i], all.iter().map(|x| x.1.abs()).fold(0.0, f64::max));
            let of_governing = all.iter().find(|x| x.0 == governing[i]).unwrap();
            assert_eq!(of_governing.1.abs(), size[i]);
        }
    }
    // What moves stands at rest there.
    let (_, _, sheet) = counted[0];
    let motion = &sheet.point_data["displacement"].numbers;
    for (i, place) in rest.iter().enumerate() {
        assert!((0..3).all(|k| (place[k] + motion[3 * i + k] - sheet.points[i][k]).abs() < 1e-12));
    }
    assert!(!ends[0].2.point_data.contains_key("director"));
}

#[test]
fn fields_over_combinations_and_over_cases() {
    let slab = text(SLAB);
    let frames = kept(&slab, &[SMALL, ("output.fields.envelope", "true")]);
    assert_eq!(frames.len(), 9 + 4);
    check(&frames, 6.0, 9.0);
    let only_cases = [SMALL, ("output.fields.envelope", "true"), ("analysis.linear.combinations", "[]")];
    check(&kept(&slab, &only_cases), 1.0, 5.0);
    // Without it frames are those of the cases.
    assert_eq!(kept(&slab, &[SMALL]).len(), 9);
}

/// Two shells in one scene, and a Galerkin solid.
#[test]
fn fields_of_several_bodies_and_of_solids() {
    let cases = [
        ("analysis", "{ linear = {} }"),
        ("output.fields", "{ stresses = true, envelope = true }"),
        ("loads[0].case", "a"),
        ("loads[+]", "{ on = \"all\", gravity = { acceleration = [0, 0, -1] }, case = \"b\" }"),
    ];
    check(&kept(&text("joined-cantilevers.toml"), &cases), 1.0, 2.0);
    let block = r#"
title = "Block"
units = { length = "-", force = "-", time = "-" }
bodies.block.solid.geometry.block = { lengths = [2, 1, 1], spacing = 0.5 }
bodies.block.solid.material.elastic = { young = 1, poisson = 0.25, density = 1 }
bodies.block.solid.formulation.galerkin = {}
supports = [{ on = "x0", clamped = {} }]
loads = [
    { on = "x1", traction = { value = [0, 1e-3, 0] }, case = "a" },
    { on = "all", gravity = { acceleration = [2e-3, 0, 1e-3] }, case = "b" },
]
curve = [{ name = "u", of = "displacement", on = "x1", direction = [0.3, 0.2, 1] }]
analysis.linear = {}
output.fields = { stresses = true, envelope = true }
"#;
    check(&kept(block, &[]), 1.0, 2.0);
}

#[test]
fn an_envelope_of_no_cases_is_refused() {
    let scene = "title = \"Plate\"
units = { length = \"m\", force = \"N\", time = \"s\" }
geometry.plate = { lengths = [0.4, 0.3], particles = [7, 6] }
material.elastic = { young = 70e9, poisson = 0.3, density = 2700.0 }
section.homogeneous = { thickness = 0.004 }
supports = [{ on = \"u0\", clamped = {} }]
loads = [{ on = \"all\", gravity = { acceleration = [0, 0, -1] } }]
analysis.linear = {}
output.fields = {}
";
    insta::assert_snapshot!(refused(scene, &[("no cases", "fields = {}", "fields = { envelope = true }")]));
}

/// Of reserve factors the least counts: the frame of sizes has it, and the governing case is the one that has it; failure indices govern by the greatest.
/// Labels of plies have no envelope.
#[test]
fn the_least_reserve_governs() {
    let plate = "title = \"Plate\"
units = { length = \"m\", force = \"N\", time = \"s\" }
geometry.plate = { lengths = [0.4, 0.3], particles = [7, 6] }
material.elastic = { young = 70e9, poisson = 0.3, density = 2700.0, strength = 2e8 }
section.homogeneous = { thickness = 0.004 }
supports = [{ on = \"u0\", clamped = {} }]
loads = [
    { on = \"all\", gravity = { acceleration = [0, 0, -1] }, case = \"weight\" },
    { on = \"u1\", force = { total = [0, 0, 10.0] }, case = \"tip\" },
    { on = \"u1\", force = { total = [3e3, 0, 0] }, case = \"pull\" },
]
analysis.linear = {}
output.fields = { reserve = \"von-mises\", envelope = true }
";
    let frames = kept(plate, &[]);
    let (cases, ends) = frames.split_at(frames.len() - 4);
    let of = |sheet: &Sheet, name: &str| {
        sheet.point_data.get(name).or(sheet.cell_data.get(name)).map(|array| array.numbers.clone())
    };
    for (name, worst) in [("reserve_factor", 0), ("failure_index", 1)] {
        let [least, greatest, size, governing] = [0, 1, 2, 3].map(|k| of(&ends[k].2, name).unwrap());
        let mut met = [0; 3];
        for i in 0..size.len() {
            let all: Vec<f64> = cases.iter().map(|(_, _, sheet)| of(sheet, name).unwrap()[i]).collect();
            assert_eq!(least[i], all.iter().copied().fold(f64::INFINITY, f64::min));
            assert_eq!(greatest[i], all.iter().copied().fold(f64::NEG_INFINITY, f64::max));
            assert_eq!(size[i], [least[i], greatest[i]][worst], "{name} {i}");
            let number = governing[i] as usize;
            assert_eq!((all[number - 1], cases[number - 1].1), (size[i], governing[i]), "{name} {i}");
            met[number - 1] += 1;
        }
        // The push on the tip at the clamp, the pull from the middle on, the weight nowhere.
        assert!(met[0] == 0 && met[1] > 0 && met[2] > 0, "{name}: {met:?}");
    }
    assert!(of(&cases[0].2, "worst_ply").is_some());
    assert!(ends.iter().all(|end| of(&end.2, "worst_ply").is_none()));
}
