//! Stresses of plies, reserve factors, principal stresses: columns and fields against closed forms and against each other.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::fields::{self, Read, folder};
use crate::common::refused::refused;
use crate::common::{last, ran};
use coque::{FieldFiles, Outcome, Scene};

/// T300/5208 of \[kaw2006\] in N and mm, with expansions of its kind.
const CARBON: &str = "orthotropic = { young_along = 181e3, young_across = 10.3e3, poisson = 0.28, shear = 7.17e3, density = 1.6e-9, \
    expansion = [0.02e-6, 22.5e-6], strength = { along_tension = 1500.0, along_compression = 1500.0, across_tension = 40.0, \
    across_compression = 246.0, shear = 68.0 } }";

/// A square sheet that is free in its plane, with a layup, loads and columns.
fn sheet(section: &str, loads: &str, columns: &str) -> String {
    format!(
        "title = \"Sheet\"\nunits = {{ length = \"mm\", force = \"N\", time = \"s\" }}\nanalysis.linear = {{}}\n\
         geometry.plate = {{ lengths = [10.0, 10.0], particles = [5, 5] }}\nmaterial.{CARBON}\n{section}\n\
         supports = [{{ on = \"u0v0\", held = {{ displacement = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] }} }},\n  \
         {{ on = \"u1v0\", held = {{ displacement = [[0, 1, 0], [0, 0, 1]] }} }},\n  \
         {{ on = \"u0v1\", held = {{ displacement = [[0, 0, 1]] }} }}]\n{loads}\n{columns}\n"
    )
}

fn layup(angles: &[f64]) -> String {
    let plies: Vec<String> =
        angles.iter().map(|angle| format!("{{ thickness = 0.125, angle = {angle:?} }}")).collect();
    format!("section.layered = {{ axis = [1.0, 0.0, 0.0], plies = [{}] }}", plies.join(", "))
}

/// Pulled along x by a force for each length \[N/mm\].
fn pulled(by: f64) -> String {
    let total = 10.0 * by;
    format!(
        "loads = [{{ on = \"u1\", force = {{ total = [{total:?}, 0.0, 0.0] }} }}, {{ on = \"u0\", force = {{ total = [{:?}, 0.0, 0.0] }} }}]",
        -total
    )
}

fn columns(list: &[&str]) -> String {
    list.iter().map(|own| format!("[[curve]]\n{own}\n")).collect()
}

fn of_plies(text: &str) -> Outcome {
    ran(Scene::parse(text, "sheet.toml"))
}

const RESERVE: &str = "name = \"reserve\"\nof = \"reserve-factor\"\non = \"all\"\ncriterion = \"tsai-wu\"";

/// A single ply pulled at an angle bears the stresses of statics and fails as Tsai and Wu say.
#[test]
fn a_ply_off_its_axis() {
    for angle in [0.0, 15.0, 45.0, 90.0_f64] {
        let stress = |component: &str| {
            format!(
                "name = \"{component}\"\nof = \"ply-stress\"\non = \"all\"\nply = 1\nface = \"middle\"\ncomponent = \"{component}\""
            )
        };
        let list = columns(&[RESERVE, &stress("along"), &stress("across"), &stress("shear")]);
        let found = of_plies(&sheet(&layup(&[angle]), &pulled(2.5), &list));
        let (s, c) = libm::sincos(angle.to_radians());
        let [s1, s2, s6] = [20.0 * c * c, 20.0 * s * s, -20.0 * s * c];
        for (name, exact) in [("along", s1), ("across", s2), ("shear", s6)] {
            // Of 20 N/mm²: a sheet under even tractions is exact but for what the solver leaves.
            assert!(
                (last(&found, name) - exact).abs() < 2e-8,
                "{angle} {name}: {} {exact}",
                last(&found, name)
            );
        }
        let (f1, f11): (f64, f64) = (0.0, 1.0 / (1500.0 * 1500.0));
        let (f2, f22, f66): (f64, f64, f64) =
            (1.0 / 40.0 - 1.0 / 246.0, 1.0 / (40.0 * 246.0), 1.0 / (68.0 * 68.0));
        let a = f11 * s1 * s1 + f22 * s2 * s2 + f66 * s6 * s6 - (f11 * f22).sqrt() * s1 * s2;
        let b = f1 * s1 + f2 * s2;
        let exact = (-b + (b * b + 4.0 * a).sqrt()) / (2.0 * a);
        assert!((last(&found, "reserve") / exact - 1.0).abs() < 1e-8, "{angle}: {}", last(&found, "reserve"));
    }
}

/// Loads times the reserve factor bring the failure index to one.
#[test]
fn the_reserve_factor_is_one_on_the_load() {
    let text = |by: f64, criterion: &str| {
        let judged =
            |of: &str| format!("name = \"{of}\"\nof = \"{of}\"\non = \"all\"\ncriterion = \"{criterion}\"");
        let list = columns(&[&judged("reserve-factor"), &judged("failure-index")]);
        of_plies(&sheet(&layup(&[0.0, 45.0, -45.0, 90.0, 30.0]), &pulled(by), &list))
    };
    for criterion in ["tsai-wu", "hashin"] {
        let reserve = last(&text(20.0, criterion), "reserve-factor");
        let there = text(20.0 * reserve, criterion);
        for name in ["reserve-factor", "failure-index"] {
            assert!((last(&there, name) - 1.0).abs() < 1e-8, "{criterion} {name}: {}", last(&there, name));
        }
    }
}

/// [0/90]ₛ cooled free: e (Q₁₁ + Q₂₂ + 2Q₁₂) = (Q₁₁ + Q₁₂)α_L ΔT + (Q₂₂ + Q₁₂)α_T ΔT in both directions.
#[test]
fn cooled_cross_plies_bear_what_they_keep_from_each_other() {
    let list = columns(&[
        "name = \"across\"\nof = \"ply-stress\"\non = \"all\"\nply = 2\nface = \"top\"\ncomponent = \"across\"",
        "name = \"along\"\nof = \"ply-stress\"\non = \"all\"\nply = 1\nface = \"bottom\"\ncomponent = \"along\"",
        RESERVE,
    ]);
    let cooled = "loads = [{ on = \"all\", temperature = { change = -100.0 } }]";
    let linear = sheet(&layup(&[0.0, 90.0, 90.0, 0.0]), cooled, &list);
    let q11: f64 = 181e3 / (1.0 - 0.28 * 0.28 * 10.3 / 181.0);
    let (q22, q12) = (q11 * 10.3 / 181.0, 0.28 * q11 * 10.3 / 181.0);
    let [l, t] = [0.02e-6 * -100.0, 22.5e-6 * -100.0];
    let e = ((q11 + q12) * l + (q22 + q12) * t) / (q11 + q22 + 2.0 * q12);
    let along: f64 = q11 * (e - l) + q12 * (e - t);
    let across = q12 * (e - l) + q22 * (e - t);
    assert!((along + across).abs() < 1e-9 && across > 10.0);
    // In a state that has moved strains are of second degree in the motion, by 2e-4 of these.
    for (text, bound) in [(linear.clone(), 1e-7), (linear.replace("linear = {}", "static.levels = 1"), 1e-3)]
    {
        let found = of_plies(&text);
        for (name, exact) in [("along", along), ("across", across)] {
            assert!(
                (last(&found, name) / exact - 1.0).abs() < bound,
                "{name}: {} {exact}",
                last(&found, name)
            );
        }
    }
}

/// A ply of a material that is alike in all directions is the homogeneous shell: the same stresses, the same reserve by von Mises.
#[test]
fn a_ply_alike_in_all_directions_is_a_homogeneous_shell() {
    let bend = "loads = [{ on = \"u1\", force = { total = [300.0, 40.0, 5.0] } }]";
    let clamp = |text: String| {
        let start = text.find("supports").unwrap();
        let end = text.find("loads").unwrap();
        format!("{}supports = [{{ on = \"u0\", clamped = {{}} }}]\n{}", &text[..start], &text[end..])
    };
    let shear: f64 = 210e3 / 2.6;
    let fibre = format!(
        "orthotropic = {{ young_along = 210e3, young_across = 210e3, poisson = 0.3, shear = {shear:?}, density = 1e-9, strength = {{ \
         along_tension = 250.0, along_compression = 250.0, across_tension = 250.0, across_compression = 250.0, shear = {:?} }} }}",
        250.0 / 3.0_f64.sqrt()
    );
    let one = "section.layered = { axis = [1.0, 0.0, 0.0], plies = [{ thickness = 0.5, angle = 0.0 }] }";
    let ply = "name = \"x\"\nof = \"ply-stress\"\non = \"all\"\nply = 1\nface = \"top\"\ncomponent = \"along\"\ntake = \"max\"";
    let plies = clamp(sheet(one, bend, &columns(&[RESERVE, ply]))).replace(CARBON, &fibre);
    let steel = "elastic = { young = 210e3, poisson = 0.3, density = 1e-9, strength = 250.0 }";
    let x = "name = \"x\"\nof = \"stress\"\non = \"all\"\nface = \"top\"\ndirection = [1.0, 0.0, 0.0]\ntake = \"max\"";
    let mises = "name = \"mises\"\nof = \"von-mises\"\non = \"all\"";
    let homogeneous = "section.homogeneous.thickness = 0.5";
    let plain =
        clamp(sheet(homogeneous, bend, &columns(&[&RESERVE.replace("tsai-wu", "von-mises"), x, mises])));
    let [plies, plain] = [of_plies(&plies), of_plies(&plain.replace(CARBON, steel))];
    for name in ["reserve", "x"] {
        let [a, b] = [&plies, &plain].map(|run| last(run, name));
        assert!((a / b - 1.0).abs() < 1e-9, "{name}: {a} {b}");
    }
    assert!((last(&plain, "reserve") * last(&plain, "mises") / 250.0 - 1.0).abs() < 1e-12);
}

/// Pure shear: principal stresses ±τ at 45°, Tresca's 2τ; fields show the same, with the axis in space, however the sheet lies.
#[test]
fn pure_shear_has_its_axes_at_45_degrees() {
    let steel = "elastic = { young = 210e3, poisson = 0.3, density = 1e-9, strength = 250.0 }";
    // 4 N/mm on all edges of a thickness of 0.5: 8 N/mm².
    let edge =
        |on: &str, x: f64, y: f64| format!("{{ on = \"{on}\", force = {{ total = [{x:?}, {y:?}, 0.0] }} }}");
    let loads = format!(
        "loads = [{}, {}, {}, {}]",
        edge("u1", 0.0, 40.0),
        edge("u0", 0.0, -40.0),
        edge("v1", 40.0, 0.0),
        edge("v0", -40.0, 0.0)
    );
    let of = |name: &str, more: &str| format!("name = \"{name}\"\nof = \"{name}\"\non = \"all\"\n{more}");
    let angle = of("principal-angle", "face = \"bottom\"\ndirection = [1.0, 0.0, 0.0]");
    let list = columns(&[
        &of("max-principal", ""),
        &of("min-principal", "face = \"middle\""),
        &of("tresca", "face = \"top\""),
        &angle,
    ]);
    let text = sheet("section.homogeneous.thickness = 0.5", &loads, &list).replace(CARBON, steel)
        + "[output]\nfields = { principal = true, reserve = \"von-mises\" }\n";
    let turned = "orientation = { axis = [1.0, 2.0, -0.7], degrees = 37.0 }\n";
    for (k, text) in [text.clone(), format!("{turned}{text}")].into_iter().enumerate() {
        let scene = Scene::parse(&text, "sheet.toml").unwrap();
        let files = folder(&format!("principal-{k}"));
        let wanted = scene.output.fields.unwrap();
        let found = fields::run(&scene, &mut FieldFiles::create(&files, FieldFiles::LONE, &wanted).unwrap());
        let exact = [("max-principal", 8.0), ("min-principal", -8.0), ("tresca", 16.0)];
        for (name, exact) in exact {
            assert!((last(&found, name) / exact - 1.0).abs() < 1e-8, "{name}: {}", last(&found, name));
        }
        let quarter = std::f64::consts::FRAC_PI_4;
        assert!((last(&found, "principal-angle") / quarter - 1.0).abs() < 1e-8);
        let read = Read::new(&files.join("shell-0000.vtu"));
        let axis = match k {
            0 => sph_core::Vec3::new(1.0, 1.0, 0.0).normalize(),
            _ => {
                scene.as_shell().unwrap().orientation.unwrap().rotation()
                    * sph_core::Vec3::new(1.0, 1.0, 0.0).normalize()
            }
        };
        for name in ["top", "middle", "bottom"] {
            let principal = read.get(&format!("principal_stress_{name}"));
            assert!(principal.chunks(2).all(|s| (s[0] - 8.0).abs() < 1e-5 && (s[1] + 8.0).abs() < 1e-5));
            let axes = read.get(&format!("principal_direction_{name}"));
            assert!(
                axes.chunks(3)
                    .all(|n| { (sph_core::Vec3::from_column_slice(n).dot(&axis).abs() - 1.0).abs() < 1e-6 })
            );
            assert!(read.get(&format!("tresca_{name}")).iter().all(|s| (s - 16.0).abs() < 1e-5));
        }
        let reserve = 250.0 / (8.0 * 3.0_f64.sqrt());
        assert!(read.get("reserve_factor").iter().all(|r| (r / reserve - 1.0).abs() < 1e-6));
        assert!(read.get("worst_ply").iter().all(|&ply| ply == 1.0));
    }
}

/// The files hold what the columns take, and the number of the worst ply.
#[test]
fn fields_hold_what_columns_take() {
    let index = "name = \"index\"\nof = \"failure-index\"\non = \"all\"\ncriterion = \"tsai-wu\"";
    let ply =
        "name = \"ply\"\nof = \"ply-stress\"\non = \"all\"\nply = 3\nface = \"top\"\ncomponent = \"across\"";
    let second = "name = \"second\"\nof = \"reserve-factor\"\non = \"all\"\nply = 2\ncriterion = \"tsai-wu\"";
    let text = sheet(&layup(&[0.0, 45.0, 90.0]), &pulled(10.0), &columns(&[RESERVE, index, ply, second]))
        + "[output]\nfields = { plies = true, reserve = \"tsai-wu\" }\n";
    let scene = Scene::parse(&text, "sheet.toml").unwrap();
    let files = folder("plies");
    let wanted = scene.output.fields.unwrap();
    let found = fields::run(&scene, &mut FieldFiles::create(&files, FieldFiles::LONE, &wanted).unwrap());
    let read = Read::new(&files.join("shell-0000.vtu"));
    let least = |name: &str| read.get(name).iter().copied().fold(f64::INFINITY, f64::min);
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-6, "{a} {b}");
    near(least("reserve_factor"), last(&found, "reserve"));
    near(least("ply_2_reserve_factor"), last(&found, "second"));
    let index = read.get("failure_index").iter().copied().fold(0.0, f64::max);
    near(index, last(&found, "index"));
    near(read.get("ply_3_top")[1], last(&found, "ply"));
    // The ply across the load is the weakest.
    assert!(read.get("worst_ply").iter().all(|&ply| ply == 3.0));
    assert!(read.place("stress_top").is_none() && read.place("membrane_force").is_none());
}

#[test]
fn what_plies_are_asked_that_they_have_not() {
    let ply =
        "name = \"s\"\nof = \"ply-stress\"\non = \"all\"\nply = 2\nface = \"top\"\ncomponent = \"along\"";
    let text = sheet(&layup(&[0.0, 90.0]), &pulled(1.0), &columns(&[RESERVE, ply]))
        + "[output]\nfields = { plies = true, reserve = \"hashin\" }\n";
    let text = text.replace("linear = {}", "static.levels = 1");
    let cases = [
        ("no criterion", "\ncriterion = \"tsai-wu\"", ""),
        ("a criterion of metals", "criterion = \"tsai-wu\"", "criterion = \"von-mises\""),
        ("no such criterion", "criterion = \"tsai-wu\"", "criterion = \"tsai-hill\""),
        ("no such ply", "ply = 2", "ply = 3"),
        ("ply zero", "ply = 2", "ply = 0"),
        ("no ply", "ply = 2\n", ""),
        ("no face", "face = \"top\"\n", ""),
        ("no component", "\ncomponent = \"along\"", ""),
        (
            "a component of a reserve factor",
            "criterion = \"tsai-wu\"",
            "criterion = \"tsai-wu\"\ncomponent = \"along\"",
        ),
        ("a face of a reserve factor", "criterion = \"tsai-wu\"", "criterion = \"tsai-wu\"\nface = \"top\""),
        (
            "von Mises of plies",
            "of = \"ply-stress\"\non = \"all\"\nply = 2\nface = \"top\"\ncomponent = \"along\"",
            "of = \"von-mises\"\non = \"all\"",
        ),
        ("a strength below zero", "along_tension = 1500.0", "along_tension = -1500.0"),
        ("an open surface", "shear = 68.0", "shear = 68.0, interaction = 1.0"),
        ("a strength unknown", "across_tension = 40.0, ", ""),
        ("principal stresses of plies", "plies = true", "principal = true"),
        ("fields by von Mises", "reserve = \"hashin\"", "reserve = \"von-mises\""),
        (
            "without strengths",
            ", strength = { along_tension = 1500.0, along_compression = 1500.0, across_tension = 40.0, across_compression = 246.0, shear = 68.0 }",
            "",
        ),
        (
            "under stress before",
            "section.layered",
            "initial_stress = [{ on = \"all\", membrane = [1.0, 0.0, 0.0], axis = [1, 0, 0] }]\nsection.layered",
        ),
    ];
    insta::assert_snapshot!(refused(&text, &cases));
}

#[test]
fn what_a_homogeneous_shell_is_asked_that_it_has_not() {
    let steel = "elastic = { young = 210e3, poisson = 0.3, density = 1e-9, strength = 250.0 }";
    let reserve = RESERVE.replace("tsai-wu", "von-mises");
    let angle = "name = \"angle\"\nof = \"principal-angle\"\non = \"all\"\nface = \"middle\"\ndirection = [1.0, 0.0, 0.0]";
    let text = sheet("section.homogeneous.thickness = 0.5", &pulled(1.0), &columns(&[&reserve, angle]))
        .replace(CARBON, steel)
        + "[output]\nfields = { principal = true }\n";
    let text = text.replace("linear = {}", "static.levels = 1");
    let cases = [
        ("a criterion of fibres", "criterion = \"von-mises\"", "criterion = \"hashin\""),
        ("no strength", ", strength = 250.0", ""),
        ("stresses of plies", "principal = true", "plies = true"),
        ("a ply of a principal angle", "face = \"middle\"", "face = \"middle\"\nply = 1"),
        ("no face", "face = \"middle\"\n", ""),
        ("no direction", "\ndirection = [1.0, 0.0, 0.0]", ""),
        (
            "of a material that yields",
            "elastic = { young = 210e3, poisson = 0.3, density = 1e-9, strength = 250.0 }",
            "plastic = { young = 210e3, poisson = 0.3, density = 1e-9, hardening = { linear = { yield-stress = 250.0, slope = 1.0 } } }",
        ),
    ];
    insta::assert_snapshot!(refused(&text, &cases));
}

/// Frames of a linear answer of cooled plies hold what its columns take: heat is read back from forces that grow with the load.
#[test]
fn frames_of_cooled_plies_hold_what_columns_take() {
    let ply =
        "name = \"ply\"\nof = \"ply-stress\"\non = \"all\"\nply = 2\nface = \"top\"\ncomponent = \"across\"";
    let cooled = "loads = [{ on = \"all\", temperature = { change = -100.0, difference = 20.0 } }]";
    let text = sheet(&layup(&[0.0, 90.0, 90.0, 0.0]), cooled, &columns(&[RESERVE, ply]))
        + "[output]\nfields = { plies = true, reserve = \"tsai-wu\" }\n";
    for (k, text) in [text.clone(), text.replace("linear = {}", "static.levels = 1")].iter().enumerate() {
        let scene = Scene::parse(text, "sheet.toml").unwrap();
        let files = folder(&format!("cooled-plies-{k}"));
        let wanted = scene.output.fields.unwrap();
        let found = fields::run(&scene, &mut FieldFiles::create(&files, FieldFiles::LONE, &wanted).unwrap());
        let last_frame = fields::listed(&files.join("shell.pvd")).last().unwrap().1.clone();
        let read = Read::new(&last_frame);
        let across: Vec<f64> = read.get("ply_2_top").chunks(3).map(|own| own[1]).collect();
        let mean = across.iter().sum::<f64>() / across.len() as f64;
        assert!((mean / last(&found, "ply") - 1.0).abs() < 1e-6, "{mean} {}", last(&found, "ply"));
        let least = read.get("reserve_factor").iter().copied().fold(f64::INFINITY, f64::min);
        assert!((least / last(&found, "reserve") - 1.0).abs() < 1e-6);
    }
}

/// In a linear answer stresses of plies under two loads are the sums of those under each.
#[test]
fn stresses_of_plies_add_up() {
    let ply = |component: &str| {
        format!(
            "name = \"{component}\"\nof = \"ply-stress\"\non = \"all\"\nply = 2\nface = \"bottom\"\ncomponent = \"{component}\""
        )
    };
    let list = columns(&[&ply("along"), &ply("across"), &ply("shear")]);
    let pull = "{ on = \"u1\", force = { total = [30.0, 0.0, 0.0] } }, { on = \"u0\", force = { total = [-30.0, 0.0, 0.0] } }";
    let heat = "{ on = \"all\", temperature = { change = -70.0, difference = 5.0 } }";
    let of = |loads: &str| of_plies(&sheet(&layup(&[0.0, 45.0, 90.0]), &format!("loads = [{loads}]"), &list));
    let [pulled, cooled, both] = [of(pull), of(heat), of(&format!("{pull}, {heat}"))];
    for name in ["along", "across", "shear"] {
        let [a, b, sum] = [&pulled, &cooled, &both].map(|run| last(run, name));
        assert!((a + b - sum).abs() < 1e-7 * a.abs().max(b.abs()), "{name}: {a} + {b}, {sum}");
    }
}
