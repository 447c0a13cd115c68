//! A sheet whose normals are turned round, with its section counted from the other side: the same body, which moves alike.

use super::{difference, judge, ran};

/// Sums of a slender sheet in another order: 1e-12 of displacements, 1.1e-11 of stresses that bending and stretching leave of each other.
const BOUND: f64 = 4e-11;

/// A sheet 10 by 2 in one place, its normal up or down, under forces in space; a section and columns.
fn sheet(upturned: bool, section: &str, columns: &str) -> String {
    // About x: v runs the other way.
    let placed =
        if upturned { "placed = { origin = [0, 2, 0], u = [1, 0, 0], v = [0, -1, 0] }\n" } else { "" };
    format!(
        "title = \"Sheet\"\nunits = {{ length = \"mm\", force = \"N\", time = \"s\" }}\nanalysis.static.levels = 2\n{placed}\
         geometry.plate = {{ lengths = [10.0, 2.0], particles = [13, 5] }}\n{section}\n\
         supports = [{{ on = \"u0\", clamped = {{}} }}]\nloads = [{{ on = \"u1\", force = {{ total = [30.0, 4.0, 3.0] }} }}]\n\
         curve = [{{ name = \"u\", of = \"displacement\", on = \"u1\", direction = [1, 0, 0] }},\n  \
         {{ name = \"v\", of = \"displacement\", on = \"u1\", direction = [0, 1, 0] }},\n  \
         {{ name = \"w\", of = \"displacement\", on = \"u1\", direction = [0, 0, 1] }},\n  {columns}]\n"
    )
}

/// Rows of a scene.
fn rows(m: [[f64; 3]; 3]) -> String {
    format!("{m:?}")
}

/// With the first axis kept and the normal turned, the second axis turns as well: 16 and 26 change their sign, then all of B, as curvatures do.
#[test]
fn a_given_stiffness_that_is_upturned_moves_alike() {
    let shears = |m: [[f64; 3]; 3]| {
        let sign = |i: usize, j: usize| if (i == 2) == (j == 2) { m[i][j] } else { -m[i][j] };
        std::array::from_fn(|i| std::array::from_fn(|j| sign(i, j)))
    };
    let a = [[73346.7, 21326.4, -4600.99], [21326.4, 72411.8, -11949.7], [-4600.99, -11949.7, 23703.1]];
    let b = [[-19085.1, 665.939, -3912.72], [665.939, 17753.3, 1742.68], [-3912.72, 1742.68, 665.939]];
    let d = [[10289.8, 1271.68, 1230.55], [1271.68, 9776.19, 978.779], [1230.55, 978.779, 1556.88]];
    let section = |a, b, d, across: f64| {
        format!(
            "material.smeared.density = 1.6e-9\nsection.stiffness = {{ thickness = 1.2, axis = [1, 0, 0], membrane = {}, coupling = {}, \
             bending = {}, shear = [[4200.0, {across:?}], [{across:?}, 3900.0]] }}",
            rows(a),
            rows(b),
            rows(d)
        )
    };
    let negative = |m: [[f64; 3]; 3]| m.map(|row| row.map(|entry| -entry));
    let bent = "{ name = \"m\", of = \"bending-moment\", on = \"all\", direction = [1.0, 0.5, 0.0] }";
    let up = ran(&sheet(false, &section(a, b, d, 300.0), bent), &[], 1);
    let down = ran(&sheet(true, &section(shears(a), negative(shears(b)), shears(d), -300.0), bent), &[], 1);
    let mut factors = vec![1.0; up.curve.columns.len()];
    *factors.last_mut().unwrap() = -1.0;
    let mut failures = Vec::new();
    judge(&mut failures, "upturned", "given stiffness", difference(&up, &down, &factors), BOUND);
    // The coupling acts: with the sign of B as it was the sheet moves otherwise.
    let wrong = ran(&sheet(true, &section(shears(a), shears(b), shears(d), -300.0), bent), &[], 1);
    assert!(difference(&up, &wrong, &factors).0 > 0.1);
    assert!(failures.is_empty(), "{failures:#?}");
}

/// Plies are counted from the other side, with angles the other way; the axis across the fibre turns, and the shear stress changes its sign.
#[test]
fn plies_that_are_upturned_bear_the_same() {
    let material = "material.orthotropic = { young_along = 140e3, young_across = 10e3, poisson = 0.3, shear = 5e3, density = 1.6e-9, \
         strength = { along_tension = 1500.0, along_compression = 1200.0, across_tension = 50.0, across_compression = 200.0, shear = 70.0 } }";
    let plies = [(0.4, 10.0), (0.5, -50.0), (0.3, 80.0)];
    let section = |plies: &[(f64, f64)]| {
        let list: Vec<_> =
            plies.iter().map(|(t, angle)| format!("{{ thickness = {t:?}, angle = {angle:?} }}")).collect();
        format!("{material}\nsection.layered = {{ axis = [1, 0, 0], plies = [{}] }}", list.join(", "))
    };
    let columns = |ply: usize, face: &str| {
        let reserve = format!(
            "{{ name = \"reserve\", of = \"reserve-factor\", on = \"all\", criterion = \"hashin\", ply = {ply} }}"
        );
        let stress = ["along", "across", "shear"].map(|component| {
            format!(
                "{{ name = \"{component}\", of = \"ply-stress\", on = \"all\", ply = {ply}, face = \"{face}\", component = \"{component}\" }}"
            )
        });
        format!("{reserve}, {}", stress.join(", "))
    };
    let up = ran(&sheet(false, &section(&plies), &columns(1, "bottom")), &[], 1);
    let other: Vec<_> = plies.iter().rev().map(|&(t, angle)| (t, -angle)).collect();
    let down = ran(&sheet(true, &section(&other), &columns(3, "top")), &[], 1);
    let mut factors = vec![1.0; up.curve.columns.len()];
    *factors.last_mut().unwrap() = -1.0;
    let mut failures = Vec::new();
    judge(&mut failures, "upturned", "plies", difference(&up, &down, &factors), BOUND);
    assert!(failures.is_empty(), "{failures:#?}");
}

/// A bar on the upper face stays where it is in space: with the normal turned it stands on the lower one. Its moment is counted from the other side.
#[test]
fn a_stiffener_that_is_upturned_moves_alike() {
    let section = |place: &str| {
        format!(
            "material.elastic = {{ young = 70e3, poisson = 0.3, density = 2.7e-9 }}\nsection.homogeneous.thickness = 0.4\n\
             sets.rib.plane = {{ point = [0, 1, 0], normal = [0, 1, 0] }}\n\
             stiffeners = [{{ on = \"rib\", section.rectangle = {{ width = 0.3, height = 0.5 }}, {place} }}]"
        )
    };
    let bent = "{ name = \"m\", of = \"bar-moment\", on = \"rib\" }";
    let up = ran(&sheet(false, &section("side = \"top\""), bent), &[], 1);
    let mut factors = vec![1.0; up.curve.columns.len()];
    *factors.last_mut().unwrap() = -1.0;
    let mut failures = Vec::new();
    for place in ["side = \"bottom\"", "eccentricity = -0.45"] {
        let down = ran(&sheet(true, &section(place), bent), &[], 1);
        judge(&mut failures, "upturned", place, difference(&up, &down, &factors), BOUND);
    }
    // On which side it stands matters.
    let wrong = ran(&sheet(true, &section("side = \"top\""), bent), &[], 1);
    assert!(difference(&up, &wrong, &factors).0 > 0.01);
    assert!(failures.is_empty(), "{failures:#?}");
}
