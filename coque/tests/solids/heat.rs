//! Heat that solids conduct, in scenes: slabs and tubes by closed forms, in balance and in time, what it does to a solid, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fmt::Write;

use crate::common::{Replaced, last, overridden, ran, scene};
use coque::{Ended, Outcome, Silent, WarningKind};

/// A slab between a face that is held and a film, which either kind of solid conducts through.
const SLAB: &str = r#"title = "Slab"
units = { length = "m", force = "N", time = "s" }
analysis.heat = {}
heat = [{ on = "x0", held = 100.0 }, { on = "x1", film = { coefficient = 30.0, ambient = 20.0 } }]
sets.far = { nearest = [0.4, 0.1, 0.1] }
curve = [{ name = "far", of = "temperature", on = "far" }, { name = "root", of = "held-heat", on = "x0" }]
[bodies.slab.solid]
geometry.block = { lengths = [0.4, 0.2, 0.2], spacing = 0.05, nodes = "edges" }
material.elastic = { young = 1e9, poisson = 0.25, density = 2000.0, conductivity = 2.0, specific_heat = 500.0 }
"#;
const GALERKIN: (&str, &str) = ("bodies.slab.solid.formulation.galerkin", "{}");
const BONDS: (&str, &str) =
    ("bodies.slab.solid.formulation.bond-based", "{ horizon = 3.015, correction = \"balanced\" }");

fn slab(replaced: Replaced) -> Outcome {
    let outcome = ran(overridden(SLAB, "slab.toml", replaced));
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

/// Bits of the curve by so many threads.
fn threaded(replaced: Replaced, threads: usize) -> Vec<u64> {
    let outcome = overridden(SLAB, "slab.toml", replaced).unwrap().build(threads).unwrap().run(&mut Silent);
    outcome.curve.rows.iter().flatten().map(|value| value.to_bits()).collect()
}

/// `q = (T₀ − T_∞)/(L/k + 1/h)`, whatever carries the slab, and the ways by which the same heat is given.
#[test]
fn a_slab_gives_its_heat_to_a_film() {
    let flux = 80.0 / (0.4 / 2.0 + 1.0 / 30.0);
    // Three times what eliminating held nodes leaves on eight cells; bonds are exact to rounding.
    for (how, most) in [(GALERKIN, 8.1e-4), (BONDS, 1e-11)] {
        let found = slab(&[how]);
        let sum: f64 = ["supplied", "held", "film", "radiated"].iter().map(|name| last(&found, name)).sum();
        let off = (last(&found, "far") - 20.0 - flux / 30.0) / 80.0;
        println!("{}: {off:.1e}, {:.1e}", how.0, last(&found, "root") / (0.04 * flux) - 1.0);
        assert!(off.abs() < most && (last(&found, "root") / (0.04 * flux) - 1.0).abs() < most);
        assert!(sum.abs() < 1e-10 * flux);
        let ways = [
            ("{ on = 'x0', flow = 12.0 }", "x0"),
            ("{ on = 'x0', flux = 300.0 }", "x0"),
            ("{ on = 'all', source = 750.0 }", "all"),
        ];
        for (given, on) in ways {
            let found = slab(&[how, ("heat[0]", given), ("curve[1].on", &format!("'{on}'"))]);
            assert!((last(&found, "film") + 12.0).abs() < 1e-9, "{given}: {}", last(&found, "film"));
            // All of it leaves through the film: h A (T − 20).
            assert!((last(&found, "far") - 30.0).abs() < 0.2, "{given}: {}", last(&found, "far"));
        }
    }
}

/// A slab that radiates what it is given: one temperature at the face, `σ ε (T⁴ − T_s⁴) = q`.
#[test]
fn a_slab_radiates_what_it_is_given() {
    let radiation = "{ on = 'x1', radiation = { emissivity = 0.8, constant = 5.670374419e-8, surroundings = 20.0, zero = -273.15 } }";
    let exact = libm::pow(293.15_f64.powi(4) + 5000.0 / (0.8 * 5.670374419e-8), 0.25) - 273.15;
    // Three times what films at points of a face leave at its nodes; bonds: the tolerance of the balance.
    for (how, most) in [(GALERKIN, 2.7e-3), (BONDS, 1e-9)] {
        let found = slab(&[how, ("heat[0]", "{ on = 'x0', flux = 5000.0 }"), ("heat[1]", radiation)]);
        let off = last(&found, "far") / exact - 1.0;
        println!("{}: {off:.1e}", how.0);
        assert!(off.abs() < most && (last(&found, "radiated") + 200.0).abs() < 1e-8);
    }
}

/// A slab that is warm all through and cold at both ends from one moment on, by Fourier's series; in other units and on more threads it does the same. What swings over at the start is warned of.
#[test]
fn a_quenched_slab_cools_by_its_series() {
    let ends = "[{ on = ['x0', 'x1'], held = 20.0 }]";
    let run = "{ start = 120.0, duration = 8000.0, record_every = 2000.0, tolerance = 0.01 }";
    let at = |time: f64| {
        let term = |k: usize| {
            let n = (2 * k + 1) as f64 * std::f64::consts::PI;
            let sign = if k.is_multiple_of(2) { 4.0 } else { -4.0 };
            sign / n * libm::exp(-(n / 0.4).powi(2) * 2.0 / (2000.0 * 500.0) * time)
        };
        20.0 + 100.0 * (0..20).map(term).sum::<f64>()
    };
    // Three times what eight cells are off by, .08 and .43 of the fall from 100.
    for (how, most) in [(GALERKIN, 0.24), (BONDS, 1.3)] {
        let of = |more: Replaced| {
            let own = [
                how,
                ("heat", ends),
                ("analysis.heat.transient", run),
                ("sets.far", "{ nearest = [0.2, 0.1, 0.1] }"),
            ];
            slab(&[&own, more].concat())
        };
        let found = of(&[]);
        let off = last(&found, "far") - at(8000.0);
        println!("{}: {:.4}, {off:.4}", how.0, at(8000.0));
        assert!(off.abs() < most, "{off}");
        assert!((last(&found, "held_heat") / last(&found, "stored_heat") - 1.0).abs() < 1e-10);
        let millimetres = of(&[
            ("units", "{ length = 'mm', force = 'N', time = 's' }"),
            (
                "bodies.slab.solid.geometry.block",
                "{ lengths = [400, 200, 200], spacing = 50, nodes = 'edges' }",
            ),
            (
                "bodies.slab.solid.material.elastic",
                "{ young = 1e3, poisson = 0.25, density = 2e-9, conductivity = 2.0, specific_heat = 500e6 }",
            ),
            ("sets.far", "{ nearest = [200, 100, 100] }"),
        ]);
        // Of temperatures of a hundred: rounding of solves.
        assert!((last(&found, "far") - last(&millimetres, "far")).abs() < 1e-7);
        let swings = |outcome: &Outcome| {
            let all = &outcome.summary.record.warnings;
            all.iter().any(|warning| warning.kind == WarningKind::HeatOvershoot)
        };
        assert_eq!(swings(&found), how == GALERKIN);
        let [one, two] =
            [1, 2].map(|threads| threaded(&[how, ("heat", ends), ("analysis.heat.transient", run)], threads));
        assert_eq!(one, two, "{}", how.0);
    }
}

/// The stresses of a tube that is warm within by their closed form; its outer face.
#[test]
fn a_hot_tube_is_pressed_within() {
    let found = ran(scene("tube-hot.toml", &[]));
    assert_eq!(found.ended, Ended::Done);
    let off = ["hoop_within", "hoop_without", "wider"].map(|name| last(&found, name));
    println!("{off:?}");
    // Three times what 8 cells across leave: .31 and 1.2 % at nodes, .011 % of the displacement.
    for (found, [exact, most]) in
        off.into_iter().zip([[-408.7910, 9.3e-3], [259.1836, 0.035], [0.250800, 3.3e-4]])
    {
        assert!((found / exact - 1.0).abs() < most, "{found} {exact}");
    }
    // Warmed evenly between its ends: α ΔT (1 + ν) b, and −E α ΔT along.
    let even = ran(scene(
        "tube-hot.toml",
        &[
            ("loads", "[{ on = 'all', temperature = { change = 100.0 } }]"),
            ("heat", "[]"),
            ("curve[0].direction", "[0, 1, 0]"),
        ],
    ));
    assert!((last(&even, "wider") / (12e-6 * 100.0 * 1.3 * 100.0) - 1.0).abs() < 1e-9);
    assert!((last(&even, "hoop_within") / -240.0 - 1.0).abs() < 1e-8);
}

/// A block that is held between two walls as it is warmed, by levels and by both laws; free it has no stress.
#[test]
fn a_block_between_walls_is_pressed() {
    const BLOCK: &str = r#"title = "Block"
units = { length = "m", force = "N", time = "s" }
analysis.static.levels = 2
supports = [{ on = "x0", symmetry = { normal = [1.0, 0.0, 0.0] } }, { on = "x1", symmetry = { normal = [1.0, 0.0, 0.0] } }, { on = "y0", symmetry = { normal = [0.0, 1.0, 0.0] } }, { on = "z0", symmetry = { normal = [0.0, 0.0, 1.0] } }]
loads = [{ on = "all", temperature = { change = 50.0 } }]
curve = [{ name = "s", of = "stress", on = "x1", direction = [1.0, 0.0, 0.0] }, { name = "u", of = "displacement", on = "y1", direction = [0.0, 1.0, 0.0] }, { name = "wall", of = "reaction", on = "x1", direction = [1.0, 0.0, 0.0] }]
[bodies.block.solid]
geometry.block = { lengths = [1.0, 0.5, 0.5], spacing = 0.25 }
material.elastic = { young = 1e9, poisson = 0.3, density = 1.0, expansion = 1e-5 }
formulation.galerkin = {}
"#;
    for law in ["'strain-rotation'", "'st-venant'"] {
        let law_of = ("bodies.block.solid.formulation.galerkin.law", law);
        let found = ran(overridden(BLOCK, "block.toml", &[law_of]));
        assert_eq!(found.ended, Ended::Done);
        // What is stored is ½ E ε² V, free it is nothing; by one linear solve as well.
        let linear = ran(overridden(BLOCK, "block.toml", &[law_of, ("analysis", "{ linear = {} }")]));
        for found in [&found, &linear] {
            assert!(
                (last(found, "internal") / 31.25 - 1.0).abs() < 3e-3,
                "{law}: {}",
                last(found, "internal")
            );
        }
        let strain = 50.0 * 1e-5;
        // Strains of 5e-4 count by their square in what is left.
        assert!((last(&found, "s") / (-1e9 * strain) - 1.0).abs() < 2e-3, "{law}: {}", last(&found, "s"));
        assert!((last(&found, "u") / (1.3 * strain * 0.5) - 1.0).abs() < 2e-3, "{law}");
        assert!(
            (last(&found, "wall") / (-1e9 * strain * 0.25) - 1.0).abs() < 3e-3,
            "{law}: {}",
            last(&found, "wall")
        );
    }
}

#[test]
fn what_heat_of_solids_does_not_go_with_is_refused() {
    let mut out = String::new();
    let mut refused = |name: &str, text: &str, replaced: Replaced| {
        let error = match overridden(text, "slab.toml", replaced) {
            Err(error) => error,
            Ok(checked) => checked.build(1).err().unwrap_or_else(|| panic!("{name} is not refused")),
        };
        writeln!(out, "# {name}\n{error}\n").unwrap();
    };
    refused("an edge", SLAB, &[GALERKIN, ("heat[0]", "{ on = 'x0', edge_flux = 1.0 }")]);
    refused("faces", SLAB, &[GALERKIN, ("heat[1].film.faces", "'front'")]);
    refused(
        "no conductivity",
        SLAB,
        &[GALERKIN, ("bodies.slab.solid.material.elastic", "{ young = 1.0, poisson = 0.25, density = 1.0 }")],
    );
    refused("a place", SLAB, &[GALERKIN, ("heat[1].on", "'far'")]);
    refused(
        "a layer of bonds",
        SLAB,
        &[BONDS, ("sets.lid", "{ layer = { face = 'x1', depth = 0.05 } }"), ("heat[1].on", "'lid'")],
    );
    refused("a support", SLAB, &[GALERKIN, ("supports", "[{ on = 'x0', clamped = {} }]")]);
    refused("heat alone", SLAB, &[GALERKIN, ("heat", "[{ on = 'x0', flux = 1.0 }]")]);
    let statics = ("analysis", "{ static = { levels = 1 } }");
    let held = ("supports", "[{ on = 'x0', clamped = {} }]");
    let conducted = ("loads", "[{ on = 'all', temperature = { conducted = { over = 20.0 } } }]");
    let read = ("curve", "[]");
    refused("bonds that are warmed", SLAB, &[BONDS, statics, held, conducted, read]);
    refused("no expansion", SLAB, &[GALERKIN, statics, held, conducted, read]);
    let expands = ("bodies.slab.solid.material.elastic.expansion", "1e-5");
    refused(
        "a part",
        SLAB,
        &[
            GALERKIN,
            statics,
            held,
            read,
            expands,
            ("loads", "[{ on = 'x1', temperature = { conducted = { over = 20.0 } } }]"),
        ],
    );
    refused(
        "a difference",
        SLAB,
        &[
            GALERKIN,
            statics,
            held,
            read,
            expands,
            ("loads", "[{ on = 'all', temperature = { difference = 20.0 } }]"),
        ],
    );
    refused(
        "modes",
        SLAB,
        &[GALERKIN, ("analysis", "{ modal = { modes = 1 } }"), held, conducted, read, expands],
    );
    insta::assert_snapshot!(out);
}
