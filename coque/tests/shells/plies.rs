//! Plies of several materials: a sandwich bends and shears as its closed form says, plies of one material are one, masses add up, and what cannot be is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{Replaced, column, done, last, refusal};

const PULLED: &str = "strip-fibre-metal.toml";
const BENT: &str = "strip-springback.toml";

fn elastic(young: f64, poisson: f64) -> String {
    format!("{{ elastic = {{ young = {young:?}, poisson = {poisson:?}, density = 1e-9 }} }}")
}

/// Plies of those materials and thicknesses, each at no angle.
fn plies(all: &[(&str, f64)]) -> String {
    let ply = |(material, thickness): &(&str, f64)| match material.is_empty() {
        true => format!("{{ thickness = {thickness:?}, angle = 0.0 }}"),
        false => format!("{{ thickness = {thickness:?}, angle = 0.0, material = {material} }}"),
    };
    let list: Vec<String> = all.iter().map(ply).collect();
    format!("{{ layered = {{ axis = [1.0, 0.0, 0.0], plies = [{}] }} }}", list.join(", "))
}

/// The end of a strip with a soft core that a force bends: `P L³/3D + P L/S`, half of it and more by shear.
#[test]
fn a_sandwich_bends_and_shears_as_its_closed_form() {
    let [length, width, force] = [50.0, 10.0, 1e-3];
    let [face, core] = [(70e3, 0.5), (40.0, 10.0)];
    let [skin, soft] = [face, core].map(|(young, _)| elastic(young, 0.0));
    let section = plies(&[(&skin, face.1), (&soft, core.1), (&skin, face.1)]);
    let across = "[{ on = 'u0', clamped = {} }, { on = 'all', held = { displacement = [[0.0, 1.0, 0.0]] } }]";
    let load = format!("[{{ on = 'u1', force = {{ total = [0.0, 0.0, {force:?}] }} }}]");
    let outcome = done(
        PULLED,
        &[
            ("geometry.plate.particles", "[41, 5]"),
            ("material", &soft),
            ("section", &section),
            ("supports", across),
            ("loads", &load),
            ("analysis", "{ linear = {} }"),
            ("curve", "[{ name = 'w', of = 'displacement', on = 'u1', direction = [0.0, 0.0, 1.0] }]"),
            ("output", "{}"),
        ],
    );
    let deflection = last(&outcome, "w");
    let middle = 0.5 * (core.1 + face.1);
    let thin = |(young, t): (f64, f64)| young * width * t.powi(3) / 12.0;
    let bending = thin(core) + 2.0 * (thin(face) + face.0 * width * face.1 * middle * middle);
    // Shear evenly over the distance of the faces' middles; the core's own bending adds a parabola of a thousandth.
    let shear = 0.5 * core.0 * width * (2.0 * middle).powi(2) / core.1;
    let [of_bending, of_shear] = [force * length.powi(3) / (3.0 * bending), force * length / shear];
    println!("{:.4e} {:.4e} {:.2e}", of_bending, of_shear, deflection / (of_bending + of_shear) - 1.0);
    assert!(of_shear > of_bending);
    // 1.2e-3: shear within the faces, the parabola of the core, and cells.
    assert!((deflection / (of_bending + of_shear) - 1.0).abs() < 4e-3);
}

/// Plies whose materials are one, elastic or not, are the homogeneous shell.
#[test]
fn plies_of_one_material_are_one() {
    let plastic = "{ plastic = { young = 200000.0, poisson = 0.499, density = 7.8e-9, \
                    hardening = { linear = { yield-stress = 200.0, slope = 4000.0 } } } }";
    let third = 0.1 / 3.0;
    let all = plies(&[("", third), (plastic, third), ("", third)]);
    let one = ("section.homogeneous.slices", "18");
    let levels = |levels| ("analysis.static.levels", levels);
    let turns = |replaced: Replaced| column(&done(BENT, replaced), "turn");
    let [below, beyond] = ["[0.3, 0.6, 0.0]", "[0.6, 0.8, 1.0, 0.0]"];
    let off = |path| {
        let (a, b) = (turns(&[levels(path), ("section", &all)]), turns(&[levels(path), one]));
        let most = b.iter().fold(0.0_f64, |most, turn| most.max(turn.abs()));
        a.iter().zip(&b).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs() / most))
    };
    let [elastic, yielding] = [off(below), off(beyond)];
    println!("{elastic:.1e} {yielding:.1e}");
    // Elastic 5e-16; beyond, 1.2e-3: slices of a ply stand elsewhere than those of the whole, and an error of the moment counts ten times in the turn.
    assert!(elastic < 1e-14, "{elastic:.1e}");
    assert!(yielding < 4e-3, "{yielding:.1e}");
    let same = elastic_alone(&plies(&[("", 0.05), (&elastic_of(3e3), 0.05)]));
    let whole = elastic_alone("{ homogeneous = { thickness = 0.1 } }");
    println!("{:.1e}", same / whole - 1.0);
    assert!((same / whole - 1.0).abs() < 1e-14);
}

fn elastic_of(young: f64) -> String {
    elastic(young, 0.3)
}

/// The turn of a strip of one elastic material.
fn elastic_alone(section: &str) -> f64 {
    let outcome = done(
        BENT,
        &[
            ("material", &elastic_of(3e3)),
            ("section", section),
            ("loads[0].couple.moment", "1e-5"),
            ("curve", "[{ name = 'turn', of = 'rotation', on = 'u1', direction = [0.0, 1.0, 0.0] }]"),
            ("output", "{}"),
            ("analysis.static.levels", "[1.0]"),
        ],
    );
    last(&outcome, "turn")
}

/// The weight is that of all plies: `g b l Σ ρ t`.
#[test]
fn masses_of_plies_add_up() {
    let outcome = done(
        PULLED,
        &[
            ("loads", "[{ on = 'all', gravity = { acceleration = [9.81e6, 0.0, 0.0] } }]"),
            ("supports[2]", "{ on = 'u1', held = { displacement = [[0.0, 1.0, 0.0]] } }"),
            ("curve", "[{ name = 'R', of = 'reaction', on = 'u0', direction = [-1.0, 0.0, 0.0] }]"),
            ("output", "{}"),
            ("analysis.static.levels", "[1.0]"),
        ],
    );
    let weight = 9.81e6 * 10.0 * 50.0 * (0.9 * 2.78e-9 + 0.5 * 1.98e-9);
    let found = last(&outcome, "R");
    println!("{:.1e}", found / weight - 1.0);
    // 4e-12: the force is balanced to 1e-9 of the load.
    assert!((found / weight - 1.0).abs() < 1e-11);
}

/// Which side is up does not matter to a stretch, and turns bending round.
#[test]
fn plies_upside_down_bend_the_other_way() {
    let [steel, soft] = [elastic(2e5, 0.3), elastic(7e4, 0.33)];
    let lift = |section: &str| {
        let outcome = done(
            PULLED,
            &[
                ("material", &soft),
                ("section", section),
                ("supports[1]", "{ on = 'all', held = { displacement = [[0.0, 1.0, 0.0]] } }"),
                ("supports[0]", "{ on = 'u0', clamped = {} }"),
                ("supports[2].moved.by", "0.01"),
                ("analysis.static.levels", "[1.0]"),
                ("curve", "[{ name = 'w', of = 'displacement', on = 'u1', direction = [0.0, 0.0, 1.0] }]"),
                ("output", "{}"),
            ],
        );
        last(&outcome, "w")
    };
    let up = lift(&plies(&[(&steel, 0.3), (&soft, 0.7)]));
    let down = lift(&plies(&[(&soft, 0.7), (&steel, 0.3)]));
    println!("{up:.6e} {down:.6e}");
    assert!(up.abs() > 1e-3 && (up + down).abs() < 1e-9 * up.abs(), "{up} {down}");
}

#[test]
fn what_a_ply_cannot_be_is_refused() {
    let with = |ply: &str| {
        let section = format!("{{ layered = {{ axis = [1.0, 0.0, 0.0], plies = [{ply}] }} }}");
        refusal(PULLED, &[("section", section.as_str())], 140)
    };
    let rolled = "{ plastic = { young = 7e4, poisson = 0.3, density = 1e-9, hardening = { linear = { yield-stress = 100.0 } }, \
                   anisotropy = { axis = [0.0, 1.0, 0.0], r0 = 1.0, r45 = 1.0, r90 = 1.0 } } }";
    let all = [
        with(
            "{ thickness = 1.0, angle = 0.0, material = { rubber = { density = 1e-9, law = { neo-hooke = { c1 = 1.0 } } } } }",
        ),
        with(
            "{ thickness = 1.0, angle = 0.0, slices = 4, material = { elastic = { young = 1.0, poisson = 0.3, density = 1e-9 } } }",
        ),
        with("{ thickness = 1.0, angle = 0.0, slices = 1 }"),
        with(
            "{ thickness = 1.0, angle = 0.0, material = { elastic = { young = 1.0, poisson = 0.7, density = 1e-9 } } }",
        ),
        with(&format!("{{ thickness = 1.0, angle = 0.0, material = {rolled} }}")),
        refusal(PULLED, &[("analysis", "{ linear = {} }")], 140),
        refusal(
            PULLED,
            &[(
                "material",
                "{ elastic = { young = 1.0, young-values = 'E', poisson = 0.3, density = 1e-9 } }",
            )],
            140,
        ),
        refusal(
            PULLED,
            &[
                ("material", "{ elastic = { young = 1.0, poisson = 0.3, density = 1e-9 } }"),
                ("section.layered.plies", "[{ thickness = 1.0, angle = 0.0 }]"),
            ],
            140,
        ),
    ];
    insta::assert_snapshot!(all.join("\n"));
}
