//! What flows through a section, and moments on structures, against what is known.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::{GRAVITY, lattice, march, pool};
use explicit_dynamics::{BoundaryLayout, BoundaryState};
use fluid_sph::{Fluid, Section, Structure};
use sph_core::Vec3;

fn section(at: f64, lowest: f64, highest: f64) -> Section {
    let [min, max] = [lowest, highest].map(|y| Vec3::new(-9.0, y, -9.0));
    Section { point: Vec3::new(at, 3.0, 1.0), normal: Vec3::x(), min, max: Vec3::new(9.0, max.y, 9.0) }
}

/// Of a lattice in uniform motion the flux is speed times area, wherever the section lies between particles; half a section
/// bears half. Round-off of some hundred numbers.
#[test]
fn a_lattice_in_motion_flows_as_a_continuum() {
    for dimensions in [2, 3] {
        let depth = if dimensions == 2 { 1.0 } else { 0.5 };
        let mut parts = pool(dimensions, [1.0, 0.4, 0.5], [1.5, 1.5, 1.5], 0.1);
        if dimensions == 2 {
            parts.positions = lattice([0.0, 0.0, -0.05], [10, 4, 1], 0.1);
        }
        parts.gravity = Vec3::zeros();
        parts.velocities = vec![Vec3::new(3.0, -7.0, 0.0); parts.positions.len()];
        let fluid = Fluid::new(parts).unwrap();
        let flux = |section: &Section| fluid.flux(section, 0..fluid.len());
        for step in 0..=10 {
            let at = 0.4 + 0.01 * f64::from(step);
            let whole = flux(&section(at, 0.0, 0.4));
            assert!((whole - 3.0 * 0.4 * depth).abs() < 1e-13, "{dimensions} {at}: {whole}");
            let half = flux(&section(at, 0.2, 1.0));
            assert!((half - 3.0 * 0.2 * depth).abs() < 1e-13, "{dimensions} {at}: {half}");
        }
        // Downwards as fast, through what is as long; the other way through a section that is turned.
        let unbounded = Vec3::repeat(9.0);
        let turned =
            Section { point: Vec3::new(0.0, 0.2, 0.0), normal: -Vec3::y(), min: -unbounded, max: unbounded };
        // Two rows on either side: the spline reaches all of them.
        assert!((flux(&turned) - 7.0 * depth).abs() < 1e-13);
        assert_eq!(fluid.flux(&turned, std::iter::empty()), 0.0);
    }
}

/// The integral of the spline.
fn passed(x: f64) -> f64 {
    let beyond = |x: f64| match x {
        x if x < 1.0 => 0.5 + x * (2.0 / 3.0 - x * x * (1.0 / 3.0 - 0.125 * x)),
        x if x < 2.0 => 1.0 - (2.0 - x).powi(4) / 24.0,
        _ => 1.0,
    };
    if x < 0.0 { 1.0 - beyond(-x) } else { beyond(x) }
}

/// Over a falling column the flux sums up to the water that has passed: what is left is the error of the steps' sum, 4e-4 of
/// it measured.
#[test]
fn a_flux_sums_up_to_what_has_passed() {
    let spacing = 0.02;
    let mut fluid = Fluid::new(pool(2, [0.2, 0.4, 0.0], [0.8, 0.8, 0.0], spacing)).unwrap();
    let across = section(0.25, -1.0, 2.0);
    let (mut sum, mut before) = (0.0, 0.0);
    march(&mut fluid, 0.3, |clock, fluid| {
        // Velocities are those of half a step before the places: of the middle of the step.
        sum += (clock.now.time - before) * fluid.flux(&across, 0..fluid.len());
        before = clock.now.time;
    });
    let beyond: f64 = fluid.positions().iter().map(|x| passed((x.x - 0.25) / spacing)).sum();
    let volume = beyond * spacing * spacing;
    assert!(volume > 0.2 * 0.2 * 0.4, "{volume}");
    assert!((sum / volume - 1.0).abs() < 1.3e-3, "{}", sum / volume - 1.0);
}

/// Water of depth h leans on a wall of points with ½ρgh², a third of the depth over its foot. Means over .6 s of what sways
/// about its rest, twenty rows deep: half a spacing of head is 2.5 % of the depth; −2.1 and +2.3 % measured.
#[test]
fn a_structure_is_turned_by_what_leans_on_it() {
    let (spacing, depth) = (0.05, 1.0);
    let mut parts = pool(2, [0.5, depth, 0.0], [0.5, 1.3, 0.0], spacing);
    // The right wall of the basin becomes a structure.
    let (right, rest): (Vec<Vec3>, Vec<Vec3>) =
        parts.walls[0].points.iter().partition(|x| x.x > 0.5 && x.y > 0.0);
    parts.walls[0].points = rest;
    let points: Vec<[f64; 3]> = right.iter().map(|x| (*x).into()).collect();
    let layout = BoundaryLayout { points: points.len(), areas: vec![spacing; points.len()], thin: None };
    parts.structures =
        vec![Structure { layout, state: BoundaryState { points, ..BoundaryState::default() } }];
    let mut fluid = Fluid::new(parts).unwrap();
    let foot = Vec3::new(0.5, 0.0, 0.0);
    let (mut force, mut moment, mut count) = (0.0, 0.0, 0.0);
    march(&mut fluid, 1.2, |clock, fluid| {
        if clock.now.time > 0.6 {
            force += fluid.structure_force(0).x;
            moment += fluid.structure_moment(0, foot).z;
            count += 1.0;
        }
    });
    let thrust = 0.5 * 1000.0 * GRAVITY * depth * depth;
    assert!((force / count / thrust - 1.0).abs() < 0.065, "{} of {thrust}", force / count);
    // Pushed along x above its foot it turns clockwise.
    let arm = -moment / force;
    assert!((arm / (depth / 3.0) - 1.0).abs() < 0.065, "{arm}");
    let (force, moment) = (fluid.structure_force(0), fluid.structure_moment(0, foot));
    let about = fluid.structure_moment(0, Vec3::new(0.2, 0.7, 0.0));
    let moved = moment - Vec3::new(-0.3, 0.7, 0.0).cross(&force);
    assert!((about - moved).norm() < 1e-12 * moment.norm(), "{about} {moved}");
}
