//! Shells of given stiffness in a scene: those of the material that it is of, in every analysis; parts; what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::refused::refused;
use crate::common::{column as column_of, text};
use crate::strip::{self, THIN, strip};

const GIVEN: &str = "sandwich-panel.toml";

/// A of a sheet of E = 1e6, ν = 0.3 and t = 0.2, as a scene writes it, times a factor.
fn matrix(factor: f64) -> String {
    let of = |part: f64| factor * part * 1e6 / 0.91;
    let [own, across, shear] = [of(1.0), of(0.3), of(0.35)];
    format!("[[{own:?}, {across:?}, 0.0], [{across:?}, {own:?}, 0.0], [0.0, 0.0, {shear:?}]]")
}

/// The stiffness of that sheet.
fn given() -> String {
    let shear = 5.0 / 6.0 * 0.2 * 1e6 / 2.6;
    format!(
        "thickness = 0.2, axis = [0.6, 0.8, 0.0], membrane = {}, bending = {}, shear = [[{shear:?}, 0.0], [0.0, {shear:?}]]",
        matrix(0.2),
        matrix(0.008 / 12.0)
    )
}

/// The strip as one material, and as the stiffness of it: an analysis in place of the linear one, a column, and how far they may differ.
fn both(analysis: &str, name: &str, bound: f64) {
    let force = "loads = [{ on = \"u1\", force = { total = [0.0, 0.3, 3.0] } }]";
    let plain = strip(THIN, force)
        .replace("analysis.linear = {}", analysis)
        .replace("poisson = 0.0", "poisson = 0.3");
    let own = plain
        .replace(
            "material.elastic = { young = 1e6, poisson = 0.3, density = 2.0 }",
            "material.smeared.density = 2.0",
        )
        .replace(THIN, &format!("section.stiffness = {{ {} }}", given()));
    let [a, b] = [plain, own].map(|text| {
        // Modes have no curve of their own.
        let curve = if name == "w" { text.len() } else { text.find("[[curve]]").unwrap() };
        column_of(&strip::run(&text[..curve]), name)
    });
    assert!(a.len() == b.len() && !a.is_empty());
    let most = a.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    for (a, b) in a.iter().zip(&b) {
        assert!((a - b).abs() <= bound * most, "{analysis}: {a} {b}");
    }
}

/// The frames of its points lie askew, so that sums have another order: rounding by the condition of a thin strip, 1.4e-11.
#[test]
fn the_stiffness_of_a_material_is_that_material() {
    both("analysis.linear = {}", "w", 1e-10);
    both("analysis.static.levels = 3", "w", 1e-9);
    both("analysis.explicit.transient = { duration = 0.05, record_every = 0.01 }", "w", 1e-9);
    both("analysis.modal.modes = 4", "circular_frequency", 1e-9);
}

/// Half of a strip as its own stiffness: a part as any other.
#[test]
fn a_part_may_have_a_stiffness_of_its_own() {
    let force = "loads = [{ on = \"u1\", force = { total = [0.0, 0.0, 3.0] } }]";
    let plain = strip(THIN, force).replace("poisson = 0.0", "poisson = 0.3");
    let part = format!(
        "[[parts]]\non = \"root\"\nmaterial.smeared.density = 2.0\nsection.stiffness = {{ {} }}\n",
        given()
    );
    let [a, b] = [plain.clone(), format!("{plain}{part}")].map(|text| strip::last(&strip::run(&text)));
    assert!((b / a - 1.0).abs() < 1e-10, "{a} {b}");
}

/// Membrane and bending that are coupled by an eccentric skin: what the plies of it give.
#[test]
fn a_coupled_stiffness_bends_as_its_plies_do() {
    let force = "loads = [{ on = \"u1\", force = { total = [3.0, 0.0, 0.3] } }]";
    let plies = "section.layered = { axis = [1.0, 0.0, 0.0], plies = [{ thickness = 0.1, angle = 0.0 }, { thickness = 0.1, angle = 0.0, \
                 material.elastic = { young = 3e6, poisson = 0.0, density = 2.0 } }] }";
    let plied = strip(plies, force).replace("analysis.linear = {}", "analysis.static.levels = 2");
    // ∫ E (1, ζ, ζ²) dζ of two halves, E and 3 E; the shear stiffness of the plies is theirs alone.
    let of =
        |value: f64| format!("[[{value:?}, 0.0, 0.0], [0.0, {value:?}, 0.0], [0.0, 0.0, {:?}]]", 0.5 * value);
    let [a, b, d] = [0.4e6, 0.1 * 0.05 * 2e6, 4e6 * 0.1f64.powi(3) / 3.0];
    let own = format!(
        "section.stiffness = {{ thickness = 0.2, axis = [1.0, 0.0, 0.0], membrane = {}, coupling = {}, bending = {}, shear = [[1.6e5, 0.0], [0.0, 1.6e5]] }}",
        of(a),
        of(b),
        of(d)
    );
    let given = strip(&own, force).replace("analysis.linear = {}", "analysis.static.levels = 2").replace(
        "material.elastic = { young = 1e6, poisson = 0.0, density = 2.0 }",
        "material.smeared.density = 2.0",
    );
    let [a, b] = [plied, given].map(|text| strip::last(&strip::run(&text)));
    // Shear is 1e-4 of the deflection, and its stiffness was taken a tenth off.
    assert!((b / a - 1.0).abs() < 1e-4, "{a} {b}");
}

#[test]
fn broken_stiffnesses() {
    let cases = [
        ("not symmetric", "[[13318.56, 3995.569, 0.0]", "[[13318.56, 3995.5, 0.0]"),
        ("no energy", "[0.0, 0.0, 4661.497]", "[0.0, 0.0, 0.0]"),
        ("too much coupling", "shear = [[", "coupling = [[1e8, 0, 0], [0, 0, 0], [0, 0, 0]]\nshear = [["),
        ("shear without one", "[0.0, 540800.0]", "[0.0, -540800.0]"),
        ("no direction", "axis = [1.0, 0.0, 0.0]", "axis = [0.0, 0.0, 0.0]"),
        ("along the normal", "axis = [1.0, 0.0, 0.0]", "axis = [0.0, 0.0, 1.0]"),
        ("a matrix of two rows", "[[865280.0, 0.0], [0.0, 540800.0]]", "[[865280.0, 0.0]]"),
        ("a material beside it", "[material.smeared]", "[material.elastic]\nyoung = 70e9\npoisson = 0.3"),
        ("heat", "pressure = { value = -20e3 }", "temperature = { change = 1.0 }"),
        ("stress at a face", "of = \"bending-moment\"", "of = \"stress\"\nface = \"top\""),
    ];
    insta::assert_snapshot!(refused(&text(GIVEN), &cases));
    let alone = text(GIVEN).replace("[material.smeared]", "[material.elastic]\nyoung = 70e9\npoisson = 0.3");
    let start = alone.find("[section.stiffness]").unwrap();
    let end = start + alone[start..].find("[sets]").unwrap();
    let plain = format!("{}[section.homogeneous]\nthickness = 0.02\n\n{}", &alone[..start], &alone[end..]);
    let smeared = [("a mass alone", "[material.elastic]\nyoung = 70e9\npoisson = 0.3", "[material.smeared]")];
    insta::assert_snapshot!(refused(&plain, &smeared));
}
