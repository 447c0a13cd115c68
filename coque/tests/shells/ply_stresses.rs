//! Stresses of plies, reserve factors: columns against closed forms and against each other; fields in stress_fields.rs.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::refused::refused;
use crate::common::{last, ran};
use coque::{Outcome, Scene};

/// T300/5208 of \[kaw2006\] in N and mm, with expansions of its kind.
pub const CARBON: &str = "orthotropic = { young_along = 181e3, young_across = 10.3e3, poisson = 0.28, shear = 7.17e3, density = 1.6e-9, \
    expansion = [0.02e-6, 22.5e-6], strength = { along_tension = 1500.0, along_compression = 1500.0, across_tension = 40.0, \
    across_compression = 246.0, shear = 68.0 } }";

/// A square sheet that is free in its plane, with a layup, loads and columns.
pub fn sheet(section: &str, loads: &str, columns: &str) -> String {
    format!(
        "title = \"Sheet\"\nunits = {{ length = \"mm\", force = \"N\", time = \"s\" }}\nanalysis.linear = {{}}\n\
         geometry.plate = {{ lengths = [10.0, 10.0], particles = [5, 5] }}\nmaterial.{CARBON}\n{section}\n\
         supports = [{{ on = \"u0v0\", held = {{ displacement = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] }} }},\n  \
         {{ on = \"u1v0\", held = {{ displacement = [[0, 1, 0], [0, 0, 1]] }} }},\n  \
         {{ on = \"u0v1\", held = {{ displacement = [[0, 0, 1]] }} }}]\n{loads}\n{columns}\n"
    )
}

pub fn layup(angles: &[f64]) -> String {
    let plies: Vec<String> =
        angles.iter().map(|angle| format!("{{ thickness = 0.125, angle = {angle:?} }}")).collect();
    format!("section.layered = {{ axis = [1.0, 0.0, 0.0], plies = [{}] }}", plies.join(", "))
}

/// Pulled along x by a force for each length \[N/mm\].
pub fn pulled(by: f64) -> String {
    let total = 10.0 * by;
    format!(
        "loads = [{{ on = \"u1\", force = {{ total = [{total:?}, 0.0, 0.0] }} }}, {{ on = \"u0\", force = {{ total = [{:?}, 0.0, 0.0] }} }}]",
        -total
    )
}

pub fn columns(list: &[&str]) -> String {
    list.iter().map(|own| format!("[[curve]]\n{own}\n")).collect()
}

fn of_plies(text: &str) -> Outcome {
    ran(Scene::parse(text, "sheet.toml"))
}

pub const RESERVE: &str =
    "name = \"reserve\"\nof = \"reserve-factor\"\non = \"all\"\ncriterion = \"tsai-wu\"";

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
            // Of 20 N/mm²: a sheet under even tractions is exact but for what the solver leaves, 4e-10.
            assert!(
                (last(&found, name) - exact).abs() < 1.2e-9,
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
        // As exact as these stresses, 3e-12 of them.
        assert!(
            (last(&found, "reserve") / exact - 1.0).abs() < 1e-11,
            "{angle}: {}",
            last(&found, "reserve")
        );
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
            // The answer is linear in the load: rounding of two solves, 1.2e-13.
            assert!((last(&there, name) - 1.0).abs() < 4e-13, "{criterion} {name}: {}", last(&there, name));
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
    // A linear answer is exact but for rounding, 1.4e-13; a state that has moved has the strains under which nothing is borne, whatever their
    // measure, but for what Newton's method leaves, 9e-12.
    for (text, bound) in
        [(linear.clone(), 5e-13), (linear.replace("linear = {}", "static.levels = 1"), 3e-11)]
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
        // One law written twice: the order of sums, 6e-14.
        assert!((a / b - 1.0).abs() < 2e-13, "{name}: {a} {b}");
    }
    // One number from two columns: the last digit.
    assert!((last(&plain, "reserve") * last(&plain, "mises") / 250.0 - 1.0).abs() < 1e-15);
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
        (
            "values at particles of a reserve factor",
            "criterion = \"tsai-wu\"",
            "criterion = \"tsai-wu\"\nrecovered = true",
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
        (
            "stresses at particles that are there already",
            "fields = { principal = true }",
            "fields = { recovered = true }\n[formulation]\nnodal = { order = 1 }",
        ),
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
        // Rounding of three answers, 3e-12.
        assert!((a + b - sum).abs() < 1e-11 * a.abs().max(b.abs()), "{name}: {a} + {b}, {sum}");
    }
}
