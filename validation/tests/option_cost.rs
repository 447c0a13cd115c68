//! A scene pays only for what it names: arrays, allocations and what the summary says of it; no seconds.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::alloc::System;
use std::sync::{Mutex, MutexGuard, PoisonError};

use coque::{Body, Silent};
use explicit_dynamics::{March, Transient};
use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use validation::cases::option_cost::{
    BARE, CLAMPED, Extent, Row, measure_row, model, shell_without_scene, stir, table_rows,
};

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Tests of this file run one at a time: the counter belongs to the whole process.
fn alone() -> MutexGuard<'static, ()> {
    static ALONE: Mutex<()> = Mutex::new(());
    ALONE.lock().unwrap_or_else(PoisonError::into_inner)
}

fn all(side: usize) -> Vec<Row> {
    table_rows(&Extent { side, steps: 40, rounds: 1 }).unwrap()
}

fn row(side: usize, name: &str) -> Row {
    all(side).into_iter().find(|row| row.name == name).unwrap()
}

/// Bytes held now.
fn held() -> f64 {
    let stats = ALLOCATOR.stats();
    stats.bytes_allocated as f64 - stats.bytes_deallocated as f64
}

#[test]
fn a_bare_scene_marches_the_bits_of_the_layers_below() {
    let _alone = alone();
    // Some fifty steps of a plate of nine particles along an edge.
    let duration = 5e-3;
    let mut bare = row(9, BARE);
    let times = format!("{{ duration = {duration:e}, record_every = {duration:e} }}");
    bare.set.push(("analysis.explicit.transient".into(), times));
    let mut through_coque = model(&bare).unwrap();
    let mut shell = shell_without_scene(9).unwrap();
    stir(&mut shell);
    through_coque.body.body_mut().set_state(&Body::state(&shell)).unwrap();
    let outcome = through_coque.run(&mut Silent);
    let run = Transient { duration, record_every: duration, damping: 0.0, safety: 0.8 };
    let clock = March::start(run, &mut shell).unwrap().finish(&mut shell).unwrap();
    assert!(clock.steps > 30, "{} steps", clock.steps);
    assert_eq!(outcome.summary.record.steps, clock.steps);
    // The last record drifts on by one step after the shape is kept: what is compared is the curve's last row of energies.
    let energies = outcome.summary.record.energies;
    let last = clock.last_good().unwrap().energy;
    assert_eq!(energies.kinetic.to_bits(), last.kinetic.to_bits());
    assert_eq!(energies.internal.to_bits(), last.internal.to_bits());
    assert!(last.kinetic > 0.0 && last.internal > 0.0);
}

#[test]
fn a_bare_scene_holds_no_array_beyond_the_shell() {
    let _alone = alone();
    // What is read once for all scenes, such as their schema, is no part of any.
    drop(model(&row(4, BARE)).unwrap());
    let beyond = |side: usize| {
        let bare = row(side, BARE);
        let start = held();
        let shell = shell_without_scene(side).unwrap();
        let of_shell = held() - start;
        let bytes = shell.bytes_per_particle();
        drop(shell);
        let start = held();
        let model = model(&bare).unwrap();
        assert_eq!(model.description.bytes_per_particle, bytes);
        held() - start - of_shell
    };
    // 3200 particles more: the smallest array there could be, of one byte each, would show.
    let (small, large) = (beyond(20), beyond(60));
    assert!((large - small).abs() < 3200.0, "{small} bytes beyond the shell, then {large}");
}

#[test]
fn an_option_holds_its_own_arrays_and_no_other() {
    let _alone = alone();
    let rows = all(12);
    let bytes = |row: &Row| model(row).unwrap().description.bytes_per_particle;
    let bare = bytes(&row(12, BARE));
    for (name, more) in [
        // One row of external forces, six numbers of eight bytes, whatever the load.
        ("dead force", 48.0),
        ("dead pressure", 48.0),
        ("follower pressure", 48.0),
        ("couple", 48.0),
        // Sections are one for all points; a support holds what is held, apart from what free particles have.
        ("three Gauss points through the thickness", 0.0),
        ("three plies", 0.0),
        (CLAMPED, 0.0),
        ("one edge held", 0.0),
        ("one edge moved", 0.0),
        ("mass damping", 0.0),
        ("quasi-static, mass damping", 0.0),
        ("quasi-static, kinetic damping", 0.0),
        // What is read from the shell and written is none of the step's.
        ("row of the curve every 20 steps", 0.0),
        ("energy balance at every step", 0.0),
        ("fields: motion", 0.0),
        ("fields: with stresses", 0.0),
        ("fields: extruded as well", 0.0),
        ("checkpoints", 0.0),
    ] {
        let own = rows.iter().find(|row| row.name == name).unwrap_or_else(|| panic!("no row {name}"));
        assert!((bytes(own) - bare - more).abs() < 1e-9, "{name}: {} bytes more", bytes(own) - bare);
    }
    // Cells differ from their neighbours: seven numbers of the shear for each of 121 cells, in packs of four; and of the 33
    // constants that a cell shares with others where it is equal to them, some are its own.
    let stretched = rows.iter().find(|row| row.name == "lattice stretched").expect("a row");
    let (more, number) = (bytes(stretched) - bare, 31.0 * 4.0 * 8.0 / 144.0);
    assert!((7.0 * number..=40.0 * number).contains(&more), "lattice stretched: {more} bytes more");
}

#[test]
fn no_step_of_a_bare_scene_allocates() {
    let _alone = alone();
    let measurement = measure_row(&row(12, BARE), 12, 200).unwrap();
    // The test harness may allocate on its own thread now and then; a step that did would count 200.
    let counted = measurement.allocations.unwrap();
    assert!(counted < 20, "{counted} allocations in 200 steps");
}

#[test]
fn a_row_in_each_step_is_seen_by_the_allocator() {
    // The counterpart of the test above: what is named is paid for, and counted.
    let _alone = alone();
    let measurement = measure_row(&row(12, "energy balance at every step"), 12, 200).unwrap();
    assert!(measurement.allocations.unwrap() >= 200);
}

#[test]
fn the_summary_says_what_is_left_out_and_what_is_not() {
    let _alone = alone();
    let described = |name: &str| model(&row(6, name)).unwrap().describe();
    let bare = described(BARE);
    for word in ["loads", "damping"] {
        assert!(bare.left_out.iter().any(|line| line == word), "{word}: {:?}", bare.left_out);
    }
    for (name, word, left_out) in [
        ("dead force", "force on u1", "loads"),
        ("follower pressure", "follower pressure on all", "loads"),
        ("mass damping", "mass-proportional damping", "damping"),
        ("quasi-static, kinetic damping", "kinetic damping", "damping"),
        (CLAMPED, "clamped on u0", ""),
        ("three plies", "plies at 0/90/0 degrees", ""),
    ] {
        let with = described(name);
        assert!(with.modelled.iter().any(|line| line.contains(word)), "{name}: {:?}", with.modelled);
        assert!(!bare.modelled.iter().any(|line| line.contains(word)), "{word}: {:?}", bare.modelled);
        assert!(!with.left_out.iter().any(|line| line == left_out), "{name}: {:?}", with.left_out);
    }
}
