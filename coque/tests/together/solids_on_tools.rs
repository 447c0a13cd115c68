//! Solids on rigid tools: Hertz's pressure under a drum, an even pressure under a flat, energy of what is thrown on one, whatever moves, along
//! whichever axis, the same bits however a run is cut, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{self, column, last, overridden, ran, run};

/// A Galerkin block under a flat.
const PRESSED: &str = include_str!("solids_on_tools/pressed.toml");
/// A block of bonds thrown on a flat.
const THROWN: &str = include_str!("solids_on_tools/thrown.toml");
/// A ball in place of the flat.
const BALL: &str =
    "[{ name = \"ball\", sphere = { centre = [0.5, 0.5, 1.5], radius = 1.0 }, moved = [0.0, 0.0, -0.02] }]";

/// `p = √(P E*/πR)` at each level from that on at which the contact is two cells wide in its half.
#[test]
fn a_drum_presses_on_a_block_as_hertz_says() {
    let outcome = run("drum-on-block.toml", &[]);
    let [force, pressure, area] = ["P", "p", "area"].map(|name| column(&outcome, name));
    // Of half of the contact on a cell.
    let force: Vec<f64> = force.iter().map(|force| 40.0 * force).collect();
    let (young, radius) = (2.1e11 / 0.91, 10.0);
    for i in 1..force.len() {
        let exact = (force[i] * young / (std::f64::consts::PI * radius)).sqrt();
        let half = (4.0 * force[i] * radius / (std::f64::consts::PI * young)).sqrt();
        let off = pressure[i] / exact - 1.0;
        println!("a/h {:.2} p {:+.4} area {:.3}", half / 0.05, off, area[i] / 0.05 / half);
        assert!(half < 0.1 || off.abs() < 0.03, "{i}: {off}");
    }
}

/// A block of bonds under the drum: the greatest pressure of contacts of 3.4 to 5.1 spacings in their half width is off by 2.8 % at most, the half width
/// itself, by the moment of the forces about the middle, by 5 %.
#[test]
fn a_drum_presses_on_bonds_as_hertz_says() {
    let outcome = run("drum-on-bonds.toml", &[("analysis.explicit.quasi-static.levels", "[0.5, 1.0]")]);
    let [force, moment, pressure] = ["P", "M", "p"].map(|name| column(&outcome, name));
    let (young, radius) = (2.1e11 / 0.9375, 10.0);
    for i in 1..force.len() {
        let whole = 2.0 / 0.12 * force[i];
        let exact = (whole * young / (std::f64::consts::PI * radius)).sqrt();
        let half = (4.0 * whole * radius / (std::f64::consts::PI * young)).sqrt();
        let found = 0.75 * std::f64::consts::PI * (moment[i] / force[i]).abs();
        println!("a/h {:.2} a {:+.4} p {:+.4}", half / 0.04, found / half - 1.0, pressure[i] / exact - 1.0);
        assert!((pressure[i] / exact - 1.0).abs() < 0.084, "{i}: {} {exact}", pressure[i]);
        assert!((found / half - 1.0).abs() < 0.15, "{i}: {found} {half}");
    }
}

/// Contact gives way by a hundredth of a cell of .25: a block of .5 is as stiff as one of .5025.
#[test]
fn a_flat_presses_evenly_whichever_of_both_moves_and_along_any_axis() {
    let outcome = ran(overridden(PRESSED, "pressed.toml", &[]));
    let [force, reaction] = ["F", "R"].map(|name| last(&outcome, name));
    println!("{force} {reaction}");
    assert!((force * 0.5025 - 1.0).abs() < 2.5e-2, "{force}");
    assert!((force / reaction - 1.0).abs() < 1e-6, "{force} {reaction}");
    let raised = [
        ("supports.0", "{ on = \"block.z0\", moved = { direction = [0, 0, 1], by = 0.001 } }"),
        (
            "bodies.block.solid.tools",
            "[{ name = \"flat\", plane = { point = [0, 0, 0.5], normal = [0, 0, -1] } }]",
        ),
    ];
    let other = last(&ran(overridden(PRESSED, "pressed.toml", &raised)), "F");
    assert!((other / force - 1.0).abs() < 1e-8, "{other} {force}");
    // x, y, z become y, z, x.
    let round = PRESSED
        .replace("[1, 0, 0]", "[0, 1, 0]'")
        .replace("[[0, 1, 0]]", "[[0, 0, 1]']")
        .replace("[[0, 0, 1]]", "[[1, 0, 0]]")
        .replace("[0, 0, 1]'", "[0, 0, 1]")
        .replace("[0, 1, 0]'", "[0, 1, 0]")
        .replace("block.y0", "block.Z")
        .replace("block.x0", "block.y0")
        .replace("block.z0", "block.x0")
        .replace("block.Z", "block.z0")
        .replace("[1.0, 1.0, 0.5]", "[0.5, 1.0, 1.0]")
        .replace("[0.0, 0.0, 0.5]", "[0.5, 0.0, 0.0]")
        .replace("[0.0, 0.0, -1.0]", "[-1.0, 0.0, 0.0]")
        .replace("[0.0, 0.0, -0.001]", "[-0.001, 0.0, 0.0]")
        .replace("direction = [0.0, 0.0, 1.0]", "direction = [1.0, 0.0, 0.0]");
    let turned = last(&ran(overridden(&round, "pressed.toml", &[])), "F");
    assert!((turned / force - 1.0).abs() < 1e-8, "{turned} {force}");
}

/// What the contact stores is no part of the energies, whose balance a step of finite size leaves open by 7.6e-3 of the kinetic one while it presses; after
/// the impact 2.1e-3 are gone.
#[test]
fn what_is_thrown_on_a_flat_keeps_its_energy() {
    let outcome = ran(overridden(THROWN, "thrown.toml", &[]));
    let force = column(&outcome, "F");
    assert!(force.iter().any(|force| *force > 10.0) && *force.last().unwrap() == 0.0, "{force:?}");
    assert!(last(&outcome, "gap") > 0.0);
    let [kinetic, internal, external] =
        ["kinetic", "internal", "external"].map(|name| column(&outcome, name));
    let mut open = 0.0_f64;
    for ((now, internal), external) in kinetic.iter().zip(&internal).zip(&external) {
        open = open.max((now + internal - external - kinetic[0]).abs() / kinetic[0]);
    }
    let kept = (kinetic.last().unwrap() + internal.last().unwrap()) / kinetic[0] - 1.0;
    println!("balance {open:.1e}, kept {kept:.1e}");
    assert!(open < 2.3e-2 && kept.abs() < 6.4e-3, "{open} {kept}");
}

/// Rows of nodes that touch from the rim to the middle, and whether they are too few: on both sides of the bounds, of Galerkin solids and bonds, under a
/// drum and a ball; a flat, which touches all over, has no rim.
#[test]
fn a_contact_of_few_rows_is_warned_of() {
    let said = |text: &str, replaced: &[(&str, &str)]| {
        let outcome = ran(overridden(text, "pressed.toml", replaced));
        let warnings = &outcome.summary.record.warnings;
        let own = warnings.iter().find(|own| own.kind == coque::WarningKind::CoarseContact);
        let rows = outcome.summary.record.contacts[0].rows.unwrap();
        (rows.fewest.rows, rows.most.rows, own.map(|own| own.message.clone()))
    };
    let [drum, bonds] = ["drum-on-block.toml", "drum-on-bonds.toml"].map(common::text);
    let last = ("analysis.static.levels", "[1.0]");
    // Half widths of 3.3 cells, of 1.6 and, along levels, from 1.6 on.
    assert_eq!(said(&drum, &[last]), (4, 4, None));
    let coarse = ("bodies.block.solid.geometry.block", "{ lengths = [1.0, 0.1, 1.0], spacing = 0.1 }");
    let (fewest, most, message) = said(&drum, &[last, coarse]);
    let message = message.unwrap();
    println!("{message}");
    assert_eq!((fewest, most), (2, 2));
    for part in ["tool `drum`", "up to level 1 ", "spans 2 of the 4 rows", "0.50 of this spacing"] {
        assert!(message.contains(part), "{message}");
    }
    let (fewest, most, message) = said(&drum, &[]);
    assert_eq!((fewest, most), (2, 4));
    assert!(message.unwrap().contains("up to level 0.75 "));
    // Half widths of 5.1 spacings at a horizon of three, and of 3.4.
    let levels = |list| [("analysis.explicit.quasi-static.levels", list)];
    assert_eq!(said(&bonds, &levels("[1.0]")), (5, 5, None));
    let (fewest, most, message) = said(&bonds, &levels("[0.5, 1.0]"));
    let message = message.unwrap();
    println!("{message}");
    assert_eq!((fewest, most), (4, 5));
    assert!(message.contains("up to level 0.5 ") && message.contains("spans 4 of the 5 rows"), "{message}");
    let short = [("bodies.block.solid.formulation.bond-based.horizon", "2.015"), levels("[0.5, 1.0]")[0]];
    assert_eq!(said(&bonds, &short).2, None);
    // A flat touches all over; a ball on four cells to a side does not come far.
    assert_eq!(said(PRESSED, &[]).2, None);
    let (_, most, message) = said(PRESSED, &[("bodies.block.solid.tools", BALL)]);
    assert!(most < 3 && message.unwrap().contains("tool `ball`"));
}

#[test]
fn on_any_threads_and_stopped_the_bits_are_the_same() {
    let scene = overridden(THROWN, "thrown.toml", &[]).unwrap();
    let rows = |threads| scene.build(threads).unwrap().run(&mut coque::Silent).curve.rows;
    let one = rows(1);
    assert!([2, 3].into_iter().all(|threads| rows(threads) == one));
    let coarse = [
        ("bodies.block.solid.geometry.block", "{ lengths = [1.0, 0.3, 1.0], spacing = 0.1 }"),
        ("bodies.block.solid.formulation.bond-based.horizon", "2.015"),
        ("analysis.explicit.quasi-static.levels", "2"),
        ("output", "{}"),
    ];
    stopped_again_and_again("drum-on-bonds", &common::text("drum-on-bonds.toml"), &coarse, 3);
    stopped_again_and_again("mass-on-column", &common::text("mass-on-column.toml"), &[], 3);
    stopped_again_and_again("thrown-on-flat", THROWN, &[], 3);
    stopped_again_and_again("under-ball", PRESSED, &[("bodies.block.solid.tools", BALL)], 1);
}

#[test]
fn tools_that_a_solid_cannot_touch_are_refused() {
    let refused = |text: &str, replaced: &[(&str, &str)]| {
        let scene = overridden(text, "scene.toml", replaced);
        scene.and_then(|scene| scene.build(1).map(drop)).unwrap_err().to_string()
    };
    let deep = "[{ name = \"flat\", plane = { point = [0.0, 0.0, 0.45], normal = [0.0, 0.0, -1.0] }, moved = [0, 0, -0.001] }]";
    let error = refused(PRESSED, &[("bodies.block.solid.tools", deep)]);
    assert!(error.contains("tools[0]") && error.contains("deep in the solid"), "{error}");
    let rough = BALL.replace("moved", "friction = 0.3, moved");
    let error = refused(PRESSED, &[("bodies.block.solid.tools", &rough)]);
    assert!(error.contains("tools[0].friction") && error.contains("smooth at rest"), "{error}");
    let thin =
        "[{ name = \"pin\", sphere = { centre = [0.5, 0.5, 0.503], radius = 0.002 }, moved = [0, 0, -0.1] }]";
    let error = refused(PRESSED, &[("bodies.block.solid.tools", thin)]);
    assert!(error.contains("tools[0]") && error.contains("a hundredth of the least spacing"), "{error}");
    let linear = PRESSED.replace("static = { levels = 2 }", "linear = {}");
    let error = refused(&linear, &[]);
    assert!(error.contains("tools") && error.contains("nothing opens or closes"), "{error}");
    let graded = [("bodies.cube.solid.geometry.block.grading", "[1.0, 1.0, 2.0]")];
    let error = refused(THROWN, &graded);
    assert!(error.contains("even lattice"), "{error}");
    let resting = THROWN
        .replace("explicit.transient = { duration = 0.024, record_every = 0.002 }", "static = { levels = 2 }")
        .replace("velocity = { linear = [0.3, 0.1, -2.0] }", "");
    let error = refused(&resting, &[]);
    assert!(error.contains("none at rest"), "{error}");
}
