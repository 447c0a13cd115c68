//! Periodic sides: uniform states stay uniform, momentum is kept, flows start and waves swing as their closed forms.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use std::f64::consts::{PI, TAU};

use common::{GRAVITY, disorder, lattice, march};
use explicit_dynamics::{Amplitude, Clock};
use fluid_sph::{Fluid, FluidError, Formulation, Liquid, Motion, Parts, Periods, Scheme, Start, Wall};
use sph_core::Vec3;

fn along(axes: &[usize], low: f64, length: f64) -> Periods {
    let mut periods = Periods { low: Vec3::repeat(low), lengths: Vec3::zeros() };
    axes.iter().for_each(|&axis| periods.lengths[axis] = length);
    periods
}

/// A box full of water without walls and gravity.
fn full(dimensions: usize, counts: [usize; 3], spacing: f64) -> Parts {
    let corner = if dimensions == 2 { [0.0, 0.0, -0.5 * spacing] } else { [0.0; 3] };
    Parts {
        dimensions,
        spacing,
        positions: lattice(corner, counts, spacing),
        velocities: Vec::new(),
        liquid: Liquid { density: 1000.0, sound_speed: 10.0 },
        formulation: Formulation::default(),
        gravity: Vec3::zeros(),
        start: Start::Uniform,
        walls: Vec::new(),
        structures: Vec::new(),
        domain: None,
        threads: 1,
    }
}

/// Water between plates at y = 0 and y = 1, periodic along x, of a viscosity; the upper plate may move.
fn channel(across: usize, viscosity: f64, gravity: Vec3, motion: Option<Motion>) -> Fluid {
    let spacing = 1.0 / across as f64;
    let columns = 8;
    let plate = |first: f64| lattice([0.0, first, -0.5 * spacing], [columns, 3, 1], spacing);
    let parts = Parts {
        liquid: Liquid { density: 1.0, sound_speed: 10.0 },
        formulation: Formulation {
            viscosity: 0.0,
            kinematic_viscosity: viscosity,
            confined: true,
            ..Formulation::default()
        },
        gravity,
        walls: vec![
            Wall { points: plate(-3.0 * spacing), motion: None },
            Wall { points: plate(1.0), motion },
        ],
        ..full(2, [columns, across, 1], spacing)
    };
    Fluid::repeated(parts, along(&[0], 0.0, columns as f64 * spacing)).unwrap()
}

/// Rms over the particles of what their speeds along x differ from a profile.
fn off(fluid: &Fluid, profile: impl Fn(f64) -> f64) -> f64 {
    let pairs = fluid.positions().iter().zip(fluid.velocities());
    let sum: f64 = pairs.map(|(p, v)| (v.x - profile(p.y)).powi(2)).sum();
    (sum / fluid.len() as f64).sqrt()
}

/// A lattice that moves along through all sides feels nothing and keeps its speed: rounding of the sums, whose terms are of the order of
/// P/ρ² F m = c² h⁻¹ without a pressure zero, so that the velocities are the same bits.
#[test]
fn a_plug_flows_through_all_sides_and_keeps_its_speed() {
    for dimensions in [2, 3] {
        let counts = if dimensions == 2 { [8, 8, 1] } else { [8, 8, 8] };
        let mut parts = full(dimensions, counts, 0.125);
        let mut velocity = Vec3::new(1.0, 0.5, 0.25);
        if dimensions == 2 {
            velocity.z = 0.0;
        }
        parts.velocities = vec![velocity; parts.positions.len()];
        let axes: Vec<usize> = (0..dimensions).collect();
        let mut fluid = Fluid::repeated(parts, along(&axes, 0.0, 1.0)).unwrap();
        march(&mut fluid, 2.0, |_, _| ());
        assert!(fluid.velocities().iter().all(|v| (v - velocity).norm() < 1e-12));
        assert!(fluid.positions().iter().all(|p| (0..dimensions).all(|k| (-0.1..1.1).contains(&p[k]))));
        // Two units of time along each axis, not the rest of periods.
        assert!((0..fluid.len()).all(|i| (fluid.displacement(i) - velocity * 2.0).norm() < 1e-9));
        assert!(fluid.greatest_density_error() < 1e-12);
    }
}

/// Forces across sides are found from either end: momentum of disordered water is kept to rounding.
#[test]
fn momentum_is_kept_through_sides() {
    for (dimensions, counts, axes) in
        [(2, [16, 16, 1], vec![0, 1]), (3, [8, 8, 8], vec![0, 1, 2]), (2, [16, 8, 1], vec![0])]
    {
        let mut parts = full(dimensions, counts, 0.0625);
        disorder(&mut parts, 0.2, 1.0);
        let size = counts[0] as f64 * 0.0625;
        let mut fluid = Fluid::repeated(parts, along(&axes, 0.0, size)).unwrap();
        let (before, speed) = (fluid.momentum(), fluid.velocities().iter().map(|v| v.norm()).sum::<f64>());
        march(&mut fluid, 0.2, |_, _| ());
        let lack = (fluid.momentum() - before).norm() / (speed * fluid.mass());
        assert!(lack < 1e-13, "{dimensions} {axes:?}: {lack:e}");
    }
}

/// Gravity along plates: `u = g y(1 − y)/2ν − Σ 4g/(νπ³n³) sin(nπy) exp(−n²π²νt)` over odd n, and what the plates bear at last is the weight.
/// Measured errors in parts of the greatest speed half way and steady: .84, 1.8 % at ten particles across, .21, .44 % at twenty; of the weight .2 %.
#[test]
fn flow_between_plates_starts_as_its_series() {
    let (viscosity, gravity) = (0.5, 0.5);
    let top = gravity / (8.0 * viscosity);
    let exact = |y: f64, time: f64| {
        let mode = |n: f64| {
            4.0 * gravity / (viscosity * (PI * n).powi(3))
                * libm::sin(PI * n * y)
                * libm::exp(-n * n * PI * PI * viscosity * time)
        };
        0.5 * gravity / viscosity * y * (1.0 - y) - [1.0, 3.0, 5.0, 7.0, 9.0].map(mode).iter().sum::<f64>()
    };
    for (across, bounds) in [(10, [0.025, 0.05]), (20, [0.007, 0.014])] {
        let mut fluid = channel(across, viscosity, Vec3::x() * gravity, None);
        let times = [0.2, 2.0];
        let clock = march(&mut fluid, times[0], |_, _| ());
        let half = off(&fluid, |y| exact(y, clock.now.time)) / top;
        let mut clock = clock;
        while clock.now.time < times[1] {
            clock.step(&mut fluid, times[1] - clock.now.time, |_| 1.0).unwrap();
        }
        let steady = off(&fluid, |y| exact(y, times[1])) / top;
        let borne =
            (fluid.wall_force(0) + fluid.wall_force(1)).x / (gravity * fluid.mass() * fluid.len() as f64);
        assert!(half < bounds[0] && steady < bounds[1], "{across}: {half} {steady}");
        assert!((borne - 1.0).abs() < 0.007, "{across}: {borne}");
    }
}

/// The upper plate moves at 1 and goes through the box again and again: u = y at last, and both plates are dragged by ν: measured .05 % of the profile, 1.0 and
/// .3 % of the drags, which swing by as much while the upper rows pass.
#[test]
fn a_plate_that_goes_through_the_sides_drags_the_water() {
    let viscosity = 0.5;
    let way = Some((Vec3::x(), Amplitude::Table(vec![[0.0, 0.0], [100.0, 100.0]]).into()));
    let mut fluid = channel(20, viscosity, Vec3::zeros(), Some(Motion { translation: way, rotation: None }));
    march(&mut fluid, 2.0, |_, _| ());
    let error = off(&fluid, |y| y);
    let length = 8.0 / 20.0;
    let drag = [0, 1].map(|wall| fluid.wall_force(wall).x / (viscosity * length));
    assert!(error < 0.0015, "{error}");
    assert!((drag[0] - 1.0).abs() < 0.03 && (drag[1] + 1.0).abs() < 0.03, "{drag:?}");
}

/// A pool that is periodic along x, all columns alike: water at rest with a wave of the first mode as its velocities.
fn pool(rows: usize, size: [f64; 2]) -> Parts {
    let spacing = size[1] / rows as f64;
    let columns = (size[0] / spacing).round() as usize;
    Parts {
        liquid: Liquid { density: 1000.0, sound_speed: 20.0 * (GRAVITY * size[1]).sqrt() },
        formulation: Formulation { viscosity: 0.0, ..Formulation::default() },
        gravity: Vec3::y() * -GRAVITY,
        start: Start::Hydrostatic,
        walls: vec![Wall {
            points: lattice([0.0, -3.0 * spacing, -0.5 * spacing], [columns, 3, 1], spacing),
            motion: None,
        }],
        ..full(2, [columns, rows, 1], spacing)
    }
}

/// No column of a periodic pool is another than the others, at a side or not.
#[test]
fn all_columns_of_a_pool_are_alike() {
    let parts = pool(8, [1.0, 0.5]);
    let mut fluid = Fluid::repeated(parts, along(&[0], 0.0, 1.0)).unwrap();
    march(&mut fluid, 0.2, |_, _| ());
    let columns = 16;
    for row in 0..8 {
        let first = row * columns;
        for column in 1..columns {
            let own = first + column;
            let apart = fluid.velocities()[own] - fluid.velocities()[first];
            assert!(apart.norm() < 1e-10, "{row} {column}: {apart:e}");
            assert!((fluid.densities()[own] - fluid.densities()[first]).abs() < 1e-7);
        }
    }
    let level = fluid.level_at(Vec3::new(0.5, 0.0, 0.0));
    for x in [0.0, 0.03125, 0.96875, 1.0] {
        let at_side = fluid.level_at(Vec3::new(x, 0.0, 0.0));
        assert!((at_side - level).abs() < 0.2 * 0.0625, "{x}: {at_side} {level}");
    }
    assert!(fluid.free_surface().iter().filter(|open| **open).count() <= columns);
}

/// A standing wave of one period: ω² = gk tanh kH, by the amplitude of its mode. Measured −.9 % at 15 rows; water that is compressed by 400 times less than
/// c² allows and a lattice of h = 1.55 Δx, whose moduli are negative, are both too slow.
#[test]
fn a_wave_in_a_periodic_pool_has_its_frequency() {
    let (length, depth) = (1.0, 0.3);
    let number = TAU / length;
    let omega = (GRAVITY * number * libm::tanh(number * depth)).sqrt();
    let mut parts = pool(15, [length, depth]);
    let speed = 0.05;
    let mode = |p: &Vec3| {
        let scale = speed / libm::sinh(number * depth);
        let (sin, cos) = libm::sincos(number * p.x);
        Vec3::new(-scale * libm::cosh(number * p.y) * sin, scale * libm::sinh(number * p.y) * cos, 0.0)
    };
    parts.velocities = parts.positions.iter().map(mode).collect();
    let mut fluid = Fluid::repeated(parts, along(&[0], 0.0, length)).unwrap();
    let mut crossings = Vec::new();
    let mut before: Option<[f64; 2]> = None;
    march(&mut fluid, 1.6, |clock, fluid| {
        let now: f64 = fluid.positions().iter().zip(fluid.velocities()).map(|(p, v)| mode(p).dot(v)).sum();
        if let Some([time, last]) = before
            && (last > 0.0) != (now > 0.0)
        {
            crossings.push(time + (clock.now.time - time) * last / (last - now));
        }
        before = Some([clock.now.time, now]);
    });
    let swings = crossings.len() - 1;
    let found = PI * swings as f64 / (crossings[swings] - crossings[0]);
    assert!(swings >= 3 && (found / omega - 1.0).abs() < 0.025, "{found} {omega}");
}

fn bits(fluid: &Fluid) -> Vec<u64> {
    fluid
        .state()
        .iter()
        .filter(|(name, _)| *name != "gone")
        .flat_map(|(_, numbers)| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>())
        .collect()
}

/// All of it given periods farther on stands where it stood, and goes on so to the last bit: numbers of few digits.
#[test]
fn moved_by_periods_it_is_the_same_bits() {
    let run = |periods: f64| {
        let mut parts = pool(8, [1.0, 0.5]);
        let shake =
            |i: usize| Vec3::new(((i * 37) % 16) as f64 / 1024.0, ((i * 11) % 16) as f64 / 1024.0, 0.0);
        let way = Vec3::x() * periods;
        for (i, position) in parts.positions.iter_mut().enumerate() {
            *position += shake(i) + way;
        }
        let mut fluid = Fluid::repeated(parts, along(&[0], 0.0, 1.0)).unwrap();
        let moved = fluid.displacement(5);
        assert_eq!(moved, Vec3::zeros());
        march(&mut fluid, 0.1, |_, _| ());
        bits(&fluid)
    };
    let here = run(0.0);
    assert!(here == run(1.0) && here == run(-2.0));
}

#[test]
fn a_state_put_back_goes_on_to_the_same_bits() {
    let make = || {
        let mut parts = full(2, [16, 16, 1], 0.0625);
        disorder(&mut parts, 0.2, 1.0);
        parts.formulation.xsph = 0.3;
        Fluid::repeated(parts, along(&[0, 1], 0.0, 1.0)).unwrap()
    };
    let mut fluid = make();
    let mut clock = march(&mut fluid, 0.1, |_, _| ());
    let (kept, mut resumed_clock) = (fluid.clone(), clock.clone());
    let steps = |fluid: &mut Fluid, clock: &mut Clock| {
        for _ in 0..20 {
            clock.step(fluid, f64::INFINITY, |_| 1.0).unwrap();
        }
    };
    steps(&mut fluid, &mut clock);
    let state = kept.state();
    let arrays: Vec<(&str, &[f64])> = state.iter().map(|(name, numbers)| (*name, &numbers[..])).collect();
    let mut resumed = make();
    resumed.set_state(&arrays).unwrap();
    steps(&mut resumed, &mut resumed_clock);
    assert!(bits(&fluid) == bits(&resumed));
    assert_eq!(fluid.displacement(3), resumed.displacement(3));
    assert_eq!(resumed.set_state(&arrays[..10]), Err(FluidError::State("gone")));
}

/// Work of gravity along the sides, losses and kinetic energy close as in a tank: 6·10⁻⁵ of the work is missing.
#[test]
fn energies_close_through_sides() {
    let mut parts = pool(8, [1.0, 0.5]);
    parts.gravity = Vec3::new(2.0, -GRAVITY, 0.0);
    parts.formulation.viscosity = 0.1;
    let mut fluid = Fluid::repeated(parts, along(&[0], 0.0, 1.0)).unwrap();
    let rows = common::recorded(&mut fluid, 1.0, 0.1);
    let last = rows.last().unwrap();
    assert!(last.energy.external > 0.0 && last.energy.kinetic > 0.0);
    assert!(
        last.balance_error.abs() < 2e-4 * last.energy.external,
        "{} {:?}",
        last.balance_error,
        last.energy
    );
}

#[test]
fn what_does_not_go_together_is_refused() {
    let parts = full(2, [16, 16, 1], 0.0625);
    let source = Parts {
        formulation: Formulation { scheme: Scheme::PredictorCorrector, ..Formulation::default() },
        ..parts.clone()
    };
    let refused = Fluid::repeated(source, along(&[0], 0.0, 1.0)).unwrap_err().to_string();
    assert!(refused.contains("predictor and corrector"), "{refused}");
    let refused = Fluid::repeated(parts.clone(), along(&[0], 0.0, 0.3)).unwrap_err().to_string();
    assert!(refused.contains("period along x is 0.3"), "{refused}");
    let refused = Fluid::repeated(parts.clone(), along(&[2], 0.0, 1.0)).unwrap_err().to_string();
    assert!(refused.contains("period along z"), "{refused}");
    // Particles across a side that are one place.
    let refused = Fluid::repeated(parts, along(&[0], 0.0, 0.9375)).unwrap_err();
    assert!(matches!(refused, FluidError::Overlap { .. }), "{refused}");
}
