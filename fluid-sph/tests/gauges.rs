//! Instruments in water whose answer is known, and what is refused.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::{GRAVITY, pool};
use explicit_dynamics::{Amplitude, Bounds, Dynamics, OutOfBounds};
use fluid_sph::{Fluid, FluidError, Formulation, Motion, Parts, Rotation};
use sph_core::Vec3;

/// Pressures carried by gravity are exact in water at rest but for its compression, 4e-4 here of the depth's pressure.
#[test]
fn instruments_read_water_at_rest() {
    for dimensions in [2, 3] {
        let parts = pool(dimensions, [0.6; 3], [0.9, if dimensions == 2 { 0.9 } else { 0.6 }, 0.9], 0.05);
        let fluid = Fluid::new(parts).unwrap();
        let place = |x: f64, height: f64| {
            if dimensions == 2 { Vec3::new(x, height, 7.0) } else { Vec3::new(x, 0.3, height) }
        };
        for height in [0.0, 0.1, 0.31, 0.55] {
            let exact = 1000.0 * GRAVITY * (0.6 - height);
            let read = fluid.pressure_at(place(0.3, height)).unwrap();
            assert!(
                (read - exact).abs() < 1e-3 * 1000.0 * GRAVITY * 0.6,
                "{dimensions} {height}: {read} {exact}"
            );
        }
        assert_eq!(fluid.pressure_at(place(0.85, 0.3)), None);
        // Half of space is filled half a spacing over the top row: measured 0.02 spacings off.
        let level = fluid.level_at(place(0.3, 0.0));
        assert!((level - 0.6).abs() < 0.1 * 0.05, "{level}");
        assert_eq!(fluid.level_at(place(0.85, 0.11)), 0.11);
        // A wire through water is wet from the floor to the surface.
        let wet = fluid.wet_length_at(place(0.3, 0.2));
        assert!((wet - 0.6).abs() < 0.1 * 0.05, "{wet}");
        assert_eq!(fluid.wet_length_at(place(0.85, 0.11)), 0.0);
        for (point, pressure) in fluid.wall_positions(0).iter().zip(fluid.wall_pressures(0)) {
            let exact = 1000.0 * GRAVITY * (0.6 - point[dimensions - 1]);
            assert!(pressure == 0.0 || (pressure - exact).abs() < 1e-3 * 6000.0 * GRAVITY, "{point}");
        }
        let last = dimensions - 1;
        for (open, at) in fluid.free_surface().iter().zip(fluid.positions()) {
            // Beside a wall that goes on past the water less of the surroundings is empty.
            let inside = |k: usize| at[k] > 0.15 && (k == 0 || k == last || at[k] < 0.45);
            let surface = (at[last] > 0.55 || at.x > 0.55) && (0..dimensions).all(inside);
            assert!(!open || at[last] > 0.5 || at.x > 0.5, "{at}");
            assert!(*open || !surface, "{at}");
        }
    }
}

/// Over a sheet that flies above the water, four spacings thick, the level is its top; a wire leaves out the air.
#[test]
fn a_wire_leaves_out_the_air_below_a_sheet() {
    let mut parts = pool(2, [0.6, 0.3, 0.0], [0.9, 0.9, 0.0], 0.05);
    let sheet: Vec<Vec3> =
        parts.positions.iter().filter(|at| at.y < 0.2).map(|at| at + Vec3::y() * 0.8).collect();
    parts.positions.extend(sheet);
    let fluid = Fluid::new(Parts { start: fluid_sph::Start::Uniform, ..parts }).unwrap();
    let at = Vec3::new(0.3, 0.0, 0.0);
    let (level, wet) = (fluid.level_at(at), fluid.wet_length_at(at));
    // Measured .001 and .002: .02 and .04 spacings.
    assert!((level - 1.0).abs() < 0.005 && (wet - 0.5).abs() < 0.01, "{level} {wet}");
}

fn refused(change: impl Fn(&mut Parts)) -> FluidError {
    let mut parts = pool(2, [0.3, 0.3, 0.0], [0.5, 0.5, 0.0], 0.1);
    change(&mut parts);
    Fluid::new(parts).unwrap_err()
}

#[test]
fn bad_parts_are_refused_with_their_value() {
    let said = |change: fn(&mut Parts), words: &str| {
        let message = refused(change).to_string();
        assert!(message.contains(words), "{message}");
    };
    said(|p| p.dimensions = 4, "4 dimensions");
    said(|p| p.spacing = -1.0, "spacing is -1");
    said(|p| p.liquid.density = f64::NAN, "density is NaN");
    said(|p| p.liquid.sound_speed = 0.0, "sound_speed is 0");
    said(|p| p.formulation.smoothing = 0.5, "smoothing is 0.5");
    said(|p| p.formulation.courant = 2.0, "courant is 2");
    said(|p| p.positions.clear(), "no particle");
    said(|p| p.velocities.push(Vec3::zeros()), "velocities has 1 entries, 9");
    said(|p| p.positions[3].x = f64::INFINITY, "position 3");
    said(
        |p| p.positions[1] = p.positions[0] * 1.1,
        "particle 0 of the fluid is 0.071 spacings from particle 1",
    );
    said(|p| p.walls[0].points[2] = p.positions[5], "from particle 2 of wall 0");
    said(
        |p| p.domain = Some([Vec3::zeros(), Vec3::new(0.2, 1.0, 1.0)]),
        "particle 2 of the fluid lies outside",
    );
    said(
        |p| {
            let angle = Amplitude::Constant.into();
            let turn = Rotation { centre: Vec3::zeros(), axis: Vec3::zeros(), by: 1.0, angle };
            p.walls[0].motion = Some(Motion { translation: None, rotation: Some(turn) });
        },
        "axis of rotation of wall 0",
    );
    said(
        |p| {
            let layout = explicit_dynamics::BoundaryLayout { points: 2, ..Default::default() };
            p.structures.push(fluid_sph::Structure { layout, ..Default::default() });
        },
        "structure 0: areas has 0 entries, its layout needs 2",
    );
}

/// A particle that leaves the domain, one that is too fast and one at no place are named; nothing panics.
#[test]
fn what_leaves_its_bounds_is_named() {
    let mut parts = pool(2, [0.3, 0.3, 0.0], [0.5, 0.5, 0.0], 0.1);
    parts.walls.clear();
    parts.domain = Some([Vec3::new(0.0, -0.01, 0.0), Vec3::new(0.5, 0.5, 0.0)]);
    parts.formulation = Formulation::default();
    let mut fluid = Fluid::new(parts).unwrap();
    assert!(fluid.within_bounds(Bounds::Configuration).is_ok());
    let mut clock = explicit_dynamics::Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
    while clock.now.time < 0.2 && fluid.within_bounds(Bounds::Configuration).is_ok() {
        clock.step(&mut fluid, f64::INFINITY, |_| 1.0).unwrap();
    }
    let Err(OutOfBounds::Range(found)) = fluid.within_bounds(Bounds::Configuration) else {
        panic!("nobody left")
    };
    assert!(found.to_string().contains("second coordinate of particle"), "{found}");
    let state = fluid.state();
    let mut arrays: Vec<(&str, Vec<f64>)> = state.iter().map(|(n, x)| (*n, x.to_vec())).collect();
    drop(state);
    arrays[1].1[4] = f64::NAN;
    arrays[0].1[7] = f64::NAN;
    let borrowed: Vec<(&str, &[f64])> = arrays.iter().map(|(name, x)| (*name, &x[..])).collect();
    fluid.set_state(&borrowed).unwrap();
    fluid.evaluate(clock.now);
    assert!(matches!(fluid.within_bounds(Bounds::Motion), Err(OutOfBounds::Speed { particle: 1, .. })));
    assert!(fluid.within_bounds(Bounds::Configuration).is_err());
    assert!(fluid.stable_step(1.0).is_err() || fluid.within_bounds(Bounds::Motion).is_err());
}
