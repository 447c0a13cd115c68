//! Gases and liquids that a shell encloses, in scenes: what is refused, halves, orders, steps, the same bits, what is doubtful.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, done, last, overridden, refusal, text};

const PLATE: &str = "plate-on-gas.toml";
const TUBE: &str = "tube-inflating.toml";
const AIR: &str = "[{ on = \"all\", gas = { pressure = 0.05, ambient = 0.1, exponent = 1.4 } }]";

#[test]
fn what_cannot_be_enclosed() {
    let gas = |inside: &str| format!("[{{ on = \"all\", gas = {inside} }}]");
    let (vacuum, pull) = (gas("{ pressure = 0.0 }"), gas("{ pressure = -2.0, ambient = 1.0 }"));
    let (still, word) = (gas("{ pressure = 1.0, exponent = 0.0 }"), gas("{ pressure = 1.0, volume = 3.0 }"));
    let curve = "[{ name = \"p\", of = \"enclosed-pressure\", on = \"centre\" }]";
    let everywhere = "[{ name = \"p\", of = \"enclosed-pressure\", on = \"all\" }]";
    let solid = "[{ on = \"plate.all\", gas = { pressure = 1.0 } }]";
    let flat = "[{ on = \"all\", gas = { pressure = 1.0 } }]";
    let free = "[{ on = \"u0\", clamped = {} }]";
    let cases: [(&str, &str, Replaced); 12] = [
        ("no gas", TUBE, &[("loads", &vacuum)]),
        ("a gas that pulls", TUBE, &[("loads", &pull)]),
        ("an exponent of zero", TUBE, &[("loads", &still)]),
        ("a word of the other", TUBE, &[("loads", &word)]),
        (
            "a liquid that gives without pressure",
            TUBE,
            &[("loads", "[{ on = \"all\", volume = { added = 1.0, bulk_modulus = 0.0 } }]")],
        ),
        (
            "a liquid without its stiffness",
            TUBE,
            &[("loads", "[{ on = \"all\", volume = { added = 1.0 } }]")],
        ),
        ("an open rim", TUBE, &[("loads", AIR), ("supports", free)]),
        ("a flat sheet by itself", PLATE, &[("loads", flat)]),
        ("buckling", TUBE, &[("loads", AIR), ("analysis", "{ buckling = { modes = 1 } }")]),
        ("measured elsewhere", PLATE, &[("curve", curve)]),
        ("measured where nothing is", TUBE, &[("curve", everywhere)]),
        ("in a solid", "plate-clamped-solid.toml", &[("loads", solid)]),
    ];
    let said = cases.map(|(what, name, replaced)| format!("== {what}\n{}\n", refusal(name, replaced, 100)));
    insta::assert_snapshot!(said.concat());
}

/// Half a plate over half of the chamber is half of the whole, pressed and in its modes.
#[test]
fn half_a_chamber_is_half_of_the_whole() {
    let half: Replaced = &[
        ("geometry.plate.lengths", "[0.5, 1.0]"),
        ("geometry.plate.particles", "[11, 21]"),
        ("supports[2]", "{ on = \"u1\", symmetry = { normal = [1.0, 0.0, 0.0] } }"),
        ("loads[1].gas.beside", "0.025"),
    ];
    let modes = ("analysis.modal.modes", "1");
    let [whole, part] = [&[][..], half].map(|replaced| done(PLATE, replaced));
    let [all, some] = [&[modes][..], &[half, &[modes]].concat()].map(|replaced| done(PLATE, replaced));
    let misses = [
        last(&part, "p_gas") / last(&whole, "p_gas") - 1.0,
        2.0 * last(&part, "volume") / last(&whole, "volume") - 1.0,
        column(&some, "circular_frequency")[0] / column(&all, "circular_frequency")[0] - 1.0,
    ];
    println!("{misses:?}");
    // The masses of modes differ by 1e-5 at a plane of symmetry, with and without the gas.
    let bounds = [1e-9, 1e-9, 4e-5];
    assert!(misses.iter().zip(bounds).all(|(miss, bound)| miss.abs() < bound), "{misses:?}");
}

/// A force on a plate over gas against the motion that it makes: the force again as reaction, the same pressure. And seen in a mirror, the plate's
/// normal down and its chamber above: the same pressure, the way reversed.
#[test]
fn pushed_moved_and_mirrored_agree() {
    let force = "[{ on = \"centre\", force = { total = [0.0, 0.0, -0.01] } }, \
                 { on = \"all\", gas = { pressure = 0.0, ambient = 21.0, exponent = 1.4, beside = 0.05 } }]";
    let reaction =
        ("curve[+]", "{ name = \"P\", of = \"reaction\", on = \"centre\", direction = [0.0, 0.0, 1.0] }");
    let pushed = done(PLATE, &[("loads", force)]);
    let moved = format!(
        "{{ on = \"centre\", moved = {{ direction = [0.0, 0.0, 1.0], by = {:e} }} }}",
        last(&pushed, "w_centre")
    );
    // Another load beside it: else the motion is that of the force that drives an analysis alone.
    let gas = "[{ on = \"all\", gas = { pressure = 0.0, ambient = 21.0, exponent = 1.4, beside = 0.05 } }, \
               { on = \"u0\", force = { total = [0.0, 0.0, 0.0] } }]";
    let moved = done(PLATE, &[("loads", gas), ("supports[+]", &moved), reaction]);
    let misses = [last(&moved, "P") / -0.01 - 1.0, last(&moved, "p_gas") / last(&pushed, "p_gas") - 1.0];
    println!("pushed and moved {misses:?}");
    assert!(misses.iter().all(|miss| miss.abs() < 1e-8), "{misses:?}");
    let here = done(PLATE, &[]);
    let placed = ("placed", "{ origin = [0.0, 0.0, 0.0], u = [0.0, 1.0, 0.0], v = [1.0, 0.0, 0.0] }");
    let edge = |edge: &str, axis: &str| {
        format!("{{ on = \"{edge}\", held = {{ displacement = [[0.0, 0.0, 1.0]], director = [{axis}] }} }}")
    };
    let (x, y) = ("[1.0, 0.0, 0.0]", "[0.0, 1.0, 0.0]");
    let edges = [edge("u0", x), edge("u1", x), edge("v0", y), edge("v1", y)];
    let turned: Vec<(String, &str)> =
        edges.iter().enumerate().map(|(i, edge)| (format!("supports[{}]", i + 1), edge.as_str())).collect();
    let replaced: Vec<(&str, &str)> =
        turned.iter().map(|(key, edge)| (key.as_str(), *edge)).chain([placed]).collect();
    let there = done(PLATE, &replaced);
    let misses = [
        last(&there, "p_gas") / last(&here, "p_gas") - 1.0,
        last(&there, "w_centre") / last(&here, "w_centre") + 1.0,
    ];
    println!("mirrored {misses:?}");
    assert!(misses.iter().all(|miss| miss.abs() < 1e-9), "{misses:?}");
}

/// A plate on gas beside another body with which it may touch, and does not: alone or first or last, the gas bears the same.
#[test]
fn a_gas_among_several_bodies_is_that_of_one() {
    let alone = done(PLATE, &[]);
    let plate = |name: &str, shift: f64| {
        let held = |edge: &str, axis: &str| {
            format!(
                "{{ on = '{name}.{edge}', held = {{ displacement = [[0, 0, 1]], director = [{axis}] }} }}"
            )
        };
        let supports = [
            format!("{{ on = '{name}.all', held = {{ displacement = [[1, 0, 0], [0, 1, 0]] }} }}"),
            held("u0", "[0, 1, 0]"),
            held("u1", "[0, 1, 0]"),
            held("v0", "[1, 0, 0]"),
            held("v1", "[1, 0, 0]"),
        ];
        let body = format!(
            "[bodies.{name}.shell]\ngeometry.plate = {{ lengths = [1.0, 1.0], particles = [21, 21] }}\nplaced = {{ origin = [0.0, 0.0, {shift:?}], u = [1.0, 0.0, 0.0], v = [0.0, 1.0, 0.0] }}\n\
             material.elastic = {{ young = 1.092e7, poisson = 0.3, density = 100.0 }}\nsection.homogeneous = {{ thickness = 0.01 }}\n"
        );
        (body, supports.join(", "))
    };
    let scene = |order: [&str; 2]| {
        let of = |name: &str| plate(name, if name == "gauge" { 0.0 } else { 0.5 });
        let [(one, held), (two, also)] = order.map(of);
        format!(
            "title = 'Two plates'\nunits = {{ length = '-', force = '-', time = '-' }}\nanalysis.static.levels = 1\nsupports = [{held}, {also}]\n\
             loads = [{{ on = 'gauge.all', pressure = {{ value = -0.01 }} }}, {{ on = 'other.all', pressure = {{ value = -0.02 }} }},\n\
             {{ on = 'gauge.all', gas = {{ pressure = 0.0, ambient = 21.0, exponent = 1.4, beside = 0.05 }} }}]\n\
             contact = [{{ between = ['gauge', 'other'] }}]\n\
             curve = [{{ name = 'p_gas', of = 'enclosed-pressure', on = 'gauge.all' }}]\n{one}{two}"
        )
    };
    for order in [["gauge", "other"], ["other", "gauge"]] {
        let outcome =
            overridden(&scene(order), "two.toml", &[]).unwrap().build(1).unwrap().run(&mut coque::Silent);
        let miss = (last(&outcome, "p_gas") / last(&alone, "p_gas") - 1.0).abs();
        println!("{order:?}: {miss:.1e}");
        assert!(miss < 1e-8, "{order:?}: {miss:e}");
    }
}

/// The levels by which a gas is pumped in leave no trace; a gas that is pumped in before and held is that of all its course; a tank beside takes
/// pressure away.
#[test]
fn a_gas_does_not_know_how_it_came_in() {
    let few = done(TUBE, &[("loads", AIR), ("analysis.static.levels", "2")]);
    let many = done(TUBE, &[("loads", AIR), ("analysis.static.levels", "9")]);
    let miss = (last(&few, "r") / last(&many, "r") - 1.0).abs();
    println!("levels {miss:.1e}");
    assert!(miss < 1e-9, "{miss:e}");
    let held = "[{ on = \"all\", gas = { pressure = 0.05, ambient = 0.1, exponent = 1.4 }, preload = true }, \
                { on = \"all\", pressure = { value = 0.0 } }]";
    let held = done(TUBE, &[("loads", held), ("analysis.static.levels", "1")]);
    let miss = (last(&few, "r") / last(&held, "r") - 1.0).abs();
    println!("preload {miss:.1e}");
    assert!(miss < 1e-9, "{miss:e}");
    let tank = "[{ on = \"all\", gas = { pressure = 0.05, ambient = 0.1, exponent = 1.4, beside = 1e6 } }]";
    let tank = done(TUBE, &[("loads", tank), ("analysis.static.levels", "9")]);
    assert!(last(&tank, "r") > last(&few, "r") + 0.1, "more gas goes further");
}

const FLOODED: Replaced = &[
    (
        "loads",
        "[{ on = \"all\", volume = { added = 100.0, bulk_modulus = 20.0 }, amplitude = { ramp = 0.002 } }]",
    ),
    ("analysis", "{ explicit.transient = { duration = 0.004, record_every = 0.0005 } }"),
];

/// A liquid let in at once swings back and pulls, and that is said; let in slowly under damping it does not, nor at rest.
#[test]
fn a_liquid_that_pulls_is_doubtful() {
    let pulls = |replaced: Replaced| {
        let outcome = done(TUBE, replaced);
        outcome
            .summary
            .record
            .warnings
            .iter()
            .any(|warning| warning.kind == coque::WarningKind::PullingLiquid)
    };
    let at_once = "[{ on = \"all\", volume = { added = 100.0, bulk_modulus = 20.0 }, amplitude = { table = [[0, 0], [1e-5, 1], [1e-3, 0]] } }]";
    assert!(pulls(&[("loads", at_once), FLOODED[1]]));
    assert!(!pulls(&[
        FLOODED[0],
        ("analysis", "{ static = { levels = 2 } }"),
        ("loads[0]", "{ on = \"all\", volume = { added = 100.0, bulk_modulus = 20.0 } }")
    ]));
    assert!(!pulls(&[("loads", AIR), ("analysis.static.levels", "2")]));
}

#[test]
fn a_march_goes_on_to_the_same_bits() {
    stopped_again_and_again("enclosed", &text(TUBE), FLOODED, 3);
}
