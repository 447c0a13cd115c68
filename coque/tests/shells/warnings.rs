//! The table of warnings: each rule fires on a scene made to break it and keeps still on the scenes of the repository.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fmt::Write as _;

use crate::common::{Replaced, overridden, scene, scenes};
use coque::mesh::{Format, Surface, parse, report};
use coque::{WarningKind, warnings};
use explicit_dynamics::Amplitude;
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Cell, Cloud, Cylinder, EndWeights, Vec3, lattice};
use sph_shell::{AppliedLoad, Clamped, Formulation, Parts, Pressure, Reach, Shell, Supported};

fn words(name: &str, replaced: Replaced) -> Vec<WarningKind> {
    let model = scene(name, replaced).unwrap().build(1).unwrap();
    model.warnings().iter().map(|warning| warning.kind).collect()
}

/// What scenes raise all the same: the sled has few cells, and slides without turning; the block that breaks has no correction.
const RAISED: [(&str, WarningKind); 2] =
    [("plate-on-plate.toml", WarningKind::ScaledInertia), ("fragments-on-shell.toml", WarningKind::SoftSkin)];

/// Scenes of the repository, which `coque new` hands out as templates, and the one on a mesh.
#[test]
fn scenes_of_the_repository_raise_no_warning() {
    for folder in [scenes(), scenes().join("meshes")] {
        for file in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if file.extension().is_some_and(|end| end == "toml") {
                let text = std::fs::read_to_string(&file).unwrap();
                let model = overridden(&text, &file.display().to_string(), &[]).unwrap().build(1).unwrap();
                let kinds: Vec<_> = model.warnings().iter().map(|warning| warning.kind).collect();
                let raised: Vec<_> =
                    RAISED.iter().filter(|(name, _)| file.ends_with(name)).map(|(_, kind)| *kind).collect();
                assert_eq!(kinds, raised, "{}: {:?}", file.display(), model.warnings());
            }
        }
    }
}

const JITTERED: &str = "{ radius = 10.0, polar = [18.0, 90.0], azimuth = [0.0, 90.0], particles = [21, 21], \
                        disorder = { fraction = 0.25, seed = 1 } }";
const SCATTERED: &str = "{ lengths = [1.0, 1.0], scattered = { spacing = 0.05, seed = 1 } }";

/// Scene, what breaks it, and every warning that it then raises.
const BROKEN: [(&str, Replaced, &[WarningKind]); 17] = [
    ("plate.toml", &[("loads", "[{ on = \"u0\", force = { total = [0, 0, 1] } }]")], &[WarningKind::NoWork]),
    ("plate.toml", &[("loads", "[{ on = \"all\", pressure = { value = 0.0 } }]")], &[WarningKind::NoWork]),
    (
        "plate.toml",
        &[("loads", "[{ on = \"all\", force = { total = [3, 0, 1] } }]")],
        &[WarningKind::HeldLoad],
    ),
    ("plate.toml", &[("sets.centre.nearest", "[0.5, 0.5, 0.2]")], &[WarningKind::FarNearest]),
    ("plate.toml", &[("section.homogeneous.thickness", "0.6")], &[WarningKind::TooThick]),
    ("plate.toml", &[("geometry.plate.particles", "[5, 5]")], &[WarningKind::FewParticles]),
    ("plate.toml", &[("geometry.plate.particles", "[21, 5]")], &[WarningKind::FewParticles]),
    (
        "pinched-cylinder.toml",
        &[("geometry.cylinder.particles", "[4, 17]")],
        &[WarningKind::CoarseTurn, WarningKind::CoarseBending, WarningKind::FewParticles],
    ),
    ("hemisphere.toml", &[("section.homogeneous.thickness", "0.004")], &[WarningKind::CoarseBending]),
    ("pinched-cylinder.toml", &[("geometry.cylinder.particles", "[21, 13]")], &[WarningKind::CoarseBending]),
    (
        "hemisphere.toml",
        &[("section.homogeneous.thickness", "0.01"), ("geometry.sphere", JITTERED)],
        &[WarningKind::UnevenCells, WarningKind::CoarseBending],
    ),
    ("plate.toml", &[("formulation.nodal.order", "2")], &[WarningKind::NodalLocking]),
    ("plate.toml", &[("formulation.nodal.order", "3")], &[WarningKind::NodalLocking]),
    ("hemisphere.toml", &[("formulation.nodal.order", "3")], &[WarningKind::NodalLocking]),
    ("ring.toml", &[("formulation.strong-form.smoothing", "1.2")], &[WarningKind::StrongForm]),
    (
        "plate-heated-aside.toml",
        &[("material.elastic.by_temperature", "{ reference = 20.0, young = [[20, 1.0], [120, 0.8]] }")],
        &[WarningKind::WholeHeat],
    ),
    (
        "plate.toml",
        &[
            ("geometry.plate", SCATTERED),
            ("section.homogeneous.thickness", "0.0001"),
            ("formulation.stress-point.support", "1.4"),
        ],
        &[WarningKind::WideThin],
    ),
];

/// Each scene beside a sound one that differs as little as may be.
const SOUND: [(&str, Replaced); 10] = [
    ("plate.toml", &[("loads", "[{ on = \"all\", force = { total = [1, 0, 1] } }]")]),
    ("plate.toml", &[("sets.centre.nearest", "[0.52, 0.48, 0.1]")]),
    ("plate.toml", &[("section.homogeneous.thickness", "0.3")]),
    ("plate.toml", &[("geometry.plate.particles", "[9, 9]")]),
    ("pinched-cylinder.toml", &[("geometry.cylinder.particles", "[27, 17]")]),
    ("hemisphere.toml", &[("geometry.sphere", JITTERED)]),
    ("plate.toml", &[("formulation.nodal.order", "3"), ("section.homogeneous.thickness", "0.1")]),
    ("plate.toml", &[("geometry.plate", SCATTERED), ("section.homogeneous.thickness", "0.0001")]),
    ("ring.toml", &[("formulation.stress-point.support", "1.4")]),
    (
        "cooled-fin.toml",
        &[("material.elastic.by_temperature", "{ reference = 20.0, conductivity = [[0, 1.0], [100, 3.0]] }")],
    ),
];

#[test]
fn each_rule_fires_on_a_scene_that_breaks_it() {
    let sound = SOUND.iter().map(|&(name, replaced)| (name, replaced, &[][..]));
    let wrong: Vec<_> = BROKEN
        .into_iter()
        .chain(sound)
        .map(|(name, replaced, expected)| (name, replaced, expected, words(name, replaced)))
        .filter(|(.., expected, found)| expected != found)
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Eight cells round a circle turn by 0.79 from one to the next; fifty, as the scene has them, by 0.13.
/// A free plate of n cells a side turns in time with `1 + 3/n²` of its inertia: warned of above 1 %, and in the summary always. Modes have the true one.
#[test]
fn a_plate_that_turns_freely_is_reported_its_inertia_in_time() {
    const FREE: (&str, &str) = ("supports", "[]");
    const IN_TIME: (&str, &str) =
        ("analysis", "{ explicit = { transient = { duration = 1e-3, record_every = 1e-3 } } }");
    const MODES: (&str, &str) = ("analysis", "{ modal = { modes = 7 } }");
    let made = |particles: &str, replaced: &[(&str, &str)]| {
        let all =
            [&[("geometry.plate.particles", particles), ("loads", "[]"), ("curve", "[]")], replaced].concat();
        let model = scene("plate.toml", &all).unwrap().build(1).unwrap();
        let reported = model.warnings().iter().any(|warning| warning.kind == WarningKind::ScaledInertia);
        (reported, model.description.rotary_inertia_over_true)
    };
    let (reported, ratio) = made("[11, 11]", &[FREE, IN_TIME]);
    assert!(reported && (ratio.unwrap() - 1.03).abs() < 1e-3, "{ratio:?}");
    let (reported, ratio) = made("[21, 21]", &[FREE, IN_TIME]);
    assert!(!reported && (ratio.unwrap() - 1.0075).abs() < 1e-3, "{ratio:?}");
    assert_eq!(made("[11, 11]", &[FREE, MODES]), (false, None));
    // Supports that leave no rotation raise no warning.
    assert!(!made("[11, 11]", &[IN_TIME]).0);
}

#[test]
fn turns_of_the_deformed_shell_are_reported_once() {
    let replaced = [("geometry.plate.particles", "[9, 3]"), ("analysis", "{ static = { levels = 8 } }")];
    let model = scene("ring.toml", &replaced).unwrap().build(1).unwrap();
    assert_eq!(model.warnings(), []);
    let reported = model.run(&mut coque::Silent).summary.record.warnings;
    let turns: Vec<_> = reported.iter().filter(|warning| warning.kind == WarningKind::CoarseTurn).collect();
    assert_eq!(turns.len(), 1, "{reported:?}");
    assert!(turns[0].message.contains("at level 0.75"), "{}", turns[0].message);
}

/// The estimate of locking is one: R/t = 1000, energy over that of the lattice, 1/(1 + x) with x from a twentieth to a seventh of λ.
#[test]
fn the_figure_of_uneven_cells_bounds_what_they_cost() {
    let scattered = JITTERED
        .replace("particles = [21, 21], disorder = { fraction = 0.25,", "scattered = { spacing = 0.61,");
    let stiffness = |cloud: &str| {
        let replaced = [("section.homogeneous.thickness", "0.01"), ("geometry.sphere", cloud)];
        let scene = scene("hemisphere.toml", &replaced).unwrap();
        let figure = scene.build_shell(1).unwrap().chord_loss().locking;
        let outcome = scene.build(1).unwrap().run(&mut coque::Silent);
        (figure, 1.0 / outcome.curve.column("internal").unwrap()[0])
    };
    let even = JITTERED.replace(", disorder = { fraction = 0.25, seed = 1 }", "");
    let (none, lattice) = stiffness(&even);
    assert!(none < 1e-3, "{none}");
    for cloud in [JITTERED, &scattered] {
        let (figure, stiff) = stiffness(cloud);
        let more = stiff / lattice - 1.0;
        assert!(more > figure / 20.0 && more < figure / 7.0, "{more} of {figure}");
    }
}

/// A turned scene finds its sets where they are.
#[test]
fn a_turned_scene_raises_no_warning() {
    let turned = [("orientation", "{ axis = [1.0, 2.0, 3.0], degrees = 77.0 }")];
    assert_eq!(words("plate.toml", &turned), []);
}

/// A profile of the x–z plane, drawn out along y by five cells of 0.1, as OBJ.
fn drawn_out(profile: &[[f64; 2]]) -> String {
    let mut obj = String::new();
    for [x, z] in profile {
        (0..6).for_each(|j| writeln!(obj, "v {x:?} {:?} {z:?}", 0.1 * f64::from(j)).unwrap());
    }
    for i in 0..profile.len() - 1 {
        for j in 1..6 {
            let (a, b) = (6 * i + j, 6 * (i + 1) + j);
            writeln!(obj, "f {a} {b} {} {}", b + 1, a + 1).unwrap();
        }
    }
    obj
}

/// What `coque mesh` warns of.
fn mesh_warnings(obj: &str) -> Vec<String> {
    warnings_of(&parse("made.obj", Format::Obj, obj.as_bytes()).unwrap())
}

fn warnings_of(surface: &Surface) -> Vec<String> {
    let report = report(surface).unwrap();
    report.lines().filter_map(|line| line.strip_prefix("  warning    ")).map(String::from).collect()
}

#[test]
fn folds_are_reported_by_mesh() {
    let bent = |degrees: f64| {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let x = |i: i32| 0.1 * f64::from(i);
        let place = |i: i32| if i < 10 { [x(i), 0.0] } else { [1.0 + x(i - 10) * cos, x(i - 10) * sin] };
        let obj = drawn_out(&(0..=20).map(place).collect::<Vec<_>>());
        parse("made.obj", Format::Obj, obj.as_bytes()).unwrap()
    };
    assert_eq!(warnings_of(&bent(30.0)), [""; 0]);
    // Two sheets that are tied are right; with one normal for both they are not.
    assert_eq!(warnings_of(&bent(90.0)), [""; 0]);
    let [warning] = &warnings_of(&bent(90.0).undivided().unwrap())[..] else { panic!("one warning") };
    assert!(warning.starts_with("a fold of 90° (over 30° on 5 edges)"), "{warning}");
}

#[test]
fn sheets_that_are_too_narrow_at_junctions_are_reported() {
    // Flanges of so many cells on a web of so many, at right angles.
    let channel = |flange: usize, web: usize| {
        let mut profile: Vec<[f64; 2]> = (0..=flange).map(|i| [0.1 * (flange - i) as f64, 0.0]).collect();
        profile.extend((1..=web).map(|i| [0.0, 0.1 * i as f64]));
        profile.extend((1..=flange).map(|i| [0.1 * i as f64, 0.1 * web as f64]));
        mesh_warnings(&drawn_out(&profile))
    };
    assert_eq!(channel(3, 2), [""; 0]);
    let [warning] = &channel(4, 1)[..] else { panic!("one warning") };
    assert!(
        warning
            .starts_with("5 cells are tied along two opposite edges, the first at [0.0000, 0.0500, 0.0500]"),
        "{warning}"
    );
    let [warning] = &channel(2, 4)[..] else { panic!("one warning") };
    assert!(warning.starts_with("a sheet is 2 cells deep from a junction to its free edge"), "{warning}");
    assert!(warning.contains("along 10 edges"), "{warning}");
    let [warning] = &channel(1, 4)[..] else { panic!("one warning") };
    assert!(warning.contains("by 33 % of its share"), "{warning}");
}

#[test]
fn beams_of_too_few_cells_a_wall_are_reported() {
    // Z sections with so many cells a plate, half a metre long.
    let zee = |n: usize, wide: f64| {
        let place = |i: usize| wide * i as f64 / n as f64;
        let mut profile: Vec<[f64; 2]> = (0..=n).map(|i| [place(i) - wide, 0.0]).collect();
        profile.extend((1..=n).map(|i| [0.0, place(i)]));
        profile.extend((1..=n).map(|i| [place(i), wide]));
        let all = mesh_warnings(&drawn_out(&profile));
        all.into_iter().filter(|warning| warning.starts_with("a profile of thin walls")).collect::<Vec<_>>()
    };
    // 1/n² is missing about the weak axis.
    let [warning] = &zee(5, 0.04)[..] else { panic!("one warning") };
    assert!(warning.contains("the profile may be 4.0 % too soft"), "{warning}");
    assert!(warning.contains("2.0 times as many"), "{warning}");
    assert_eq!(zee(9, 0.04), [""; 0]);
    // A panel on legs is no beam.
    assert_eq!(zee(4, 0.2), [""; 0]);
}

/// A sheet that comes back over itself at a two-hundredth of a cell, its nodes beside those below.
#[test]
fn a_mesh_folded_onto_itself_is_reported() {
    let hairpin = |gap: f64| {
        let mut profile: Vec<[f64; 2]> = (0..=10).map(|i| [0.1 * f64::from(i), 0.0]).collect();
        profile.push([1.0, gap]);
        profile.extend((0..10).map(|i| [0.96 - 0.1 * f64::from(i), gap]));
        mesh_warnings(&drawn_out(&profile))
    };
    assert!(
        hairpin(0.004).iter().any(|warning| warning.contains("lie on each other")),
        "{:?}",
        hairpin(0.004)
    );
    assert!(!hairpin(0.04).iter().any(|warning| warning.contains("lie on each other")));
}

/// A shell clamped along x = 0 under a pressure.
fn bare(cloud: Cloud, thickness: f64) -> Shell {
    let held = (0..cloud.len() as u32).filter(|&a| cloud.positions[a as usize].x.abs() < 1e-9).collect();
    let section = IsotropicSection::new(Isotropic::new(1e6, 0.3).unwrap(), thickness).unwrap();
    let pressure = Box::new(Pressure { value: 1.0, follower: false });
    Shell::builder(Parts {
        cloud,
        section: Box::new(section),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation: Formulation::StressPoint(Reach::Cell),
        supports: vec![Supported { particles: held, support: Box::new(Clamped) }],
        loads: vec![AppliedLoad { load: pressure, amplitude: Amplitude::Constant }],
        threads: 1,
    })
    .build()
    .unwrap()
}

#[test]
fn sharp_corners_and_poles_are_reported() {
    let sheared = |degrees: f64| {
        let lean = 1.0 / libm::tan(degrees.to_radians());
        let n = 10_u32;
        let place = |k: u32| {
            Vec3::new(f64::from(k / (n + 1)), 0.0, 0.0)
                + Vec3::new(lean * f64::from(k % (n + 1)), f64::from(k % (n + 1)), 0.0)
        };
        let corner = |k: u32| {
            let a = (k / n) * (n + 1) + k % n;
            Cell::quadrangle([a, a + n + 1, a + n + 2, a + 1])
        };
        let positions = (0..(n + 1) * (n + 1)).map(place).collect();
        let cloud = Cloud::from_cells(positions, None, (0..n * n).map(corner).collect()).unwrap();
        warnings(&bare(cloud, 0.01)).iter().map(|warning| warning.kind).collect::<Vec<_>>()
    };
    assert_eq!(sheared(20.0), [WarningKind::SharpCorners]);
    assert_eq!(sheared(40.0), []);
    let fan = |spokes: u32| {
        let turn = std::f64::consts::TAU / f64::from(spokes);
        let ring = |k: u32| {
            let (sin, cos) = libm::sincos(turn * f64::from(k % spokes));
            Vec3::new(1.0 + cos, sin, 0.0) * f64::from(1 + k / spokes)
        };
        let mut positions = vec![Vec3::x()];
        positions.extend((0..spokes).map(ring));
        let cells = (0..spokes).map(|k| Cell::triangle([0, 1 + k, 1 + (k + 1) % spokes])).collect();
        let reported = warnings(&bare(Cloud::from_cells(positions, None, cells).unwrap(), 0.01));
        reported.iter().any(|warning| warning.kind == WarningKind::Pole)
    };
    assert!(fan(12));
    assert!(!fan(8));
}

/// Scenes of their own geometry are refused from t = R on; meshes are not.
#[test]
fn a_shell_thicker_than_its_radius_is_reported() {
    let tube = Cylinder { radius: 1.0, angles: [0.0, std::f64::consts::PI], length: 3.0 };
    let reported = |thickness| {
        let shell = bare(lattice(&tube, [31, 31], EndWeights::Trapezoid).unwrap(), thickness);
        warnings(&shell).iter().map(|warning| warning.kind).collect::<Vec<_>>()
    };
    assert_eq!(reported(1.2), [WarningKind::TooThick]);
    assert_eq!(reported(0.8), []);
}

/// A slice of plane strain is as long as it is: the width between its mirrors is none of the body.
#[test]
fn a_slice_between_mirrors_is_measured_by_its_length() {
    let narrow = ("geometry.plate", "{ lengths = [1.0, 0.01], particles = [101, 2] }");
    let thick = ("section.homogeneous.thickness", "0.1");
    let free = ("supports", "[{ on = \"u0\", clamped = {} }]");
    let mirror = |on: &str| format!("{{ on = \"{on}\", symmetry = {{ normal = [0, 1, 0] }} }}");
    let slice = format!("[{{ on = \"u0\", clamped = {{}} }}, {}, {}]", mirror("v0"), mirror("v1"));
    let thin = |supports| words("plate.toml", &[narrow, thick, supports]).contains(&WarningKind::TooThick);
    assert!(thin(free));
    assert!(!thin(("supports", &slice)));
}

/// `check` puts warnings under a heading of their own; a scene without any has none.
#[test]
fn check_prints_warnings_under_their_own_heading() {
    let check = |set: &[&str]| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_coque"));
        command.arg("check").arg(scenes().join("plate.toml"));
        for set in set {
            command.args(["--set", set]);
        }
        String::from_utf8(command.output().unwrap().stdout).unwrap()
    };
    assert!(!check(&[]).contains("warnings"));
    let reported = check(&["geometry.plate.particles=[5, 5]"]);
    assert!(reported.contains("\nwarnings\n  few-particles: 4 cells from end to end"), "{reported}");
}

/// A run says it before it starts, once, and writes it to `summary.json`.
#[test]
fn a_run_tells_its_warnings_once_and_writes_them() {
    let out = std::env::temp_dir().join(format!("coque-warnings-{}", std::process::id()));
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_coque"));
    command.arg("run").arg(scenes().join("plate.toml")).arg("--out").arg(&out);
    let said = command.args(["--set", "geometry.plate.particles=[5, 5]"]).output().unwrap();
    let said = String::from_utf8(said.stderr).unwrap();
    assert_eq!(said.matches("warning: 4 cells from end to end").count(), 1, "{said}");
    let summary: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(out.join("summary.json")).unwrap()).unwrap();
    assert_eq!(summary["warnings"][0]["kind"], "few-particles");
    std::fs::remove_dir_all(out).unwrap();
}
