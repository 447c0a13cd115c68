//! Solids that touch: unlike blocks pressed on each other, what a block of bonds and a plate that it hits do to each other, energy, the same bits
//! however the run is cut, a block that breaks, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{column, last, overridden, ran, text};

/// Two Galerkin blocks of unlike cells, face to face.
const BLOCKS: &str = include_str!("touching_solids/blocks.toml");
/// A block of bonds thrown aslant on a plate, both free.
const THROWN: &str = include_str!("touching_solids/thrown.toml");

/// Force on a node and on the one behind it by the parts 1 − w and w leaves `2w − w²` of a cell of straight displacements unstrained, and contact
/// gives twice what the deeper surface lies below its face: with E = 1000, cells of .25, w of .1 and .08, depths of .025 and .02 the force is
/// `1/(1 − .0859 + .05)`. Smooth shape functions strain a little more: .9 % measured. Deflections of the face differ by 7.9 % between unlike cells.
#[test]
fn unlike_blocks_press_on_each_other_evenly() {
    let outcome = ran(overridden(BLOCKS, "blocks.toml", &[]));
    let [force, reaction] = ["F", "R"].map(|name| last(&outcome, name));
    println!("{force} {reaction} {} {}", last(&outcome, "least"), last(&outcome, "most"));
    assert!((force * 0.9641 - 1.0).abs() < 2.5e-2, "{force}");
    assert!((force / reaction - 1.0).abs() < 1e-6, "{force} {reaction}");
    let [least, most] = ["least", "most"].map(|name| last(&outcome, name));
    assert!(least > 0.0 && most / least < 1.2, "{least} {most}");
}

/// Each feels what the other does, to 1e-16 measured; energies add up to 3e-4 of the kinetic one over the impact.
#[test]
fn what_a_block_of_bonds_does_to_a_plate_the_plate_does_to_it_and_energy_is_kept() {
    let outcome = ran(overridden(THROWN, "thrown.toml", &[]));
    let [f, g] = ["F", "G"].map(|name| column(&outcome, name));
    let most = f.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
    assert!(most > 10.0, "{most}");
    assert!(f.iter().zip(&g).all(|(f, g)| (f + g).abs() < 1e-12 * most));
    let [kinetic, internal, external] =
        ["kinetic", "internal", "external"].map(|name| column(&outcome, name));
    let mut open = 0.0_f64;
    for ((now, internal), external) in kinetic.iter().zip(&internal).zip(&external) {
        open = open.max((now + internal - external - kinetic[0]).abs() / kinetic[0]);
    }
    println!("force {most:.3e}, energy {open:.1e}");
    assert!(open < 7e-4, "{open}");
}

#[test]
fn whichever_is_named_first_on_any_threads_and_stopped_the_bits_are_the_same() {
    let rows = ran(overridden(THROWN, "thrown.toml", &[])).curve.rows;
    let swapped = [("contact", "[{ between = [\"plate\", \"cube\"] }]")];
    assert_eq!(ran(overridden(THROWN, "thrown.toml", &swapped)).curve.rows, rows);
    let scene = overridden(THROWN, "thrown.toml", &[]).unwrap();
    for threads in [2, 3] {
        assert_eq!(scene.build(threads).unwrap().run(&mut coque::Silent).curve.rows, rows, "{threads}");
    }
    stopped_again_and_again("thrown-bonds", THROWN, &[], 3);
    stopped_again_and_again("blocks", BLOCKS, &[], 1);
}

#[test]
fn a_block_breaks_on_the_plate_that_it_falls_on() {
    let outcome = ran(overridden(&text("fragments-on-shell.toml"), "fragments.toml", &[]));
    assert!(last(&outcome, "pieces") > 10.0, "{}", last(&outcome, "pieces"));
    assert!(column(&outcome, "F").iter().any(|force| *force > 1e3));
}

#[test]
fn solids_without_a_surface_are_refused() {
    let refused = |replaced: &[(&str, &str)]| {
        let scene = overridden(THROWN, "thrown.toml", replaced);
        scene.and_then(|scene| scene.build(1).map(drop)).unwrap_err().to_string()
    };
    let graded = [("bodies.cube.solid.geometry.block.grading", "[1.0, 1.0, 2.0]")];
    let error = refused(&graded);
    assert!(error.contains("even lattice") && error.contains("contact[0].between"), "{error}");
    let deep = [("bodies.cube.solid.geometry.block.origin", "[0.31, 0.32, 0.005]")];
    let error = refused(&deep);
    assert!(error.contains("apart") && error.contains("contact[0]"), "{error}");
    let rough = [("contact[0].friction", "0.3")];
    let error = overridden(BLOCKS, "blocks.toml", &rough).map(drop).unwrap_err().to_string();
    assert!(error.contains("contact[0].friction") && error.contains("is no shell"), "{error}");
    let resting = THROWN
        .replace("explicit.transient = { duration = 0.03, record_every = 0.0025 }", "static = { levels = 2 }")
        .replace("velocity = { linear = [0.3, 0.1, -2.0] }", "");
    let error = overridden(&resting, "thrown.toml", &[]).map(drop).unwrap_err().to_string();
    assert!(error.contains("measured in marches alone"), "{error}");
}

#[test]
fn a_contact_of_a_galerkin_solid_is_warned_of() {
    let model = overridden(BLOCKS, "blocks.toml", &[]).unwrap().build(1).unwrap();
    let said = model.warnings().iter().filter(|own| own.kind == coque::WarningKind::CoarseContact).count();
    assert_eq!(said, 2);
}
