//! A thin tube that is crushed between flats, first from above and below, then from the sides, under outer pressure: it folds onto itself and
//! never comes through.
//!
//! `TUBE=200,50,100000 cargo test --release -p sph-shell --test touching -- crumpling --nocapture` takes 200 particles round, 50 along and 10⁵ steps.

use crate::audit::crossings;
use crate::common::{DENSITY, POISSON, YOUNG, parts};
use contact::{Law, ToolShape, stiffness};
use explicit_dynamics::{Amplitude, Event, March, Transient};
use sph_core::{Cell, Cloud, Vec3};
use sph_shell::{AppliedLoad, Formulation, Load, LoadCase, OwnContact, Parts, Pressure, Reach, Shell, Tool};

/// Particles round and along, and steps.
fn size() -> [usize; 3] {
    let asked = std::env::var("TUBE").ok();
    let numbers: Vec<usize> =
        asked.iter().flat_map(|asked| asked.split(',').filter_map(|n| n.parse().ok())).collect();
    <[usize; 3]>::try_from(numbers).unwrap_or([96, 12, 6000])
}

/// A tube of radius one about y.
fn tube(round: usize, along: usize, spacing: f64) -> Cloud {
    let places = (0..round * along).map(|a| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * (a % round) as f64 / round as f64);
        Vec3::new(cos, spacing * (a / round) as f64, sin)
    });
    let cell = |a: usize| {
        let next = a - a % round + (a + 1) % round;
        Cell::quadrangle([a, a + round, next + round, next].map(|a| a as u32))
    };
    Cloud::from_cells(places.collect(), None, (0..round * (along - 1)).map(cell).collect()).unwrap()
}

#[test]
fn a_tube_that_is_crushed_never_comes_through_itself() {
    let [round, along, steps] = size();
    let spacing = std::f64::consts::TAU / round as f64;
    let (thickness, length) = (0.4 * spacing, spacing * (along - 1) as f64);
    let sound = (YOUNG / (DENSITY * (1.0 - POISSON * POISSON))).sqrt();
    // About the time of those steps: half for each pair of flats.
    let duration = 0.4 * spacing / sound * steps as f64;
    let law = Law::new(0.05).unwrap();
    let flat = |from: Vec3, part: f64, begin: f64| Tool {
        shape: ToolShape::Plane {
            point: from * (1.0 + 0.5 * thickness / from.norm()),
            normal: -from.normalize(),
        },
        moved: from * -part,
        turn: 0.0,
        amplitude: Amplitude::Table(vec![[begin * duration, 0.0], [(begin + 0.5) * duration, 1.0]]),
        case: LoadCase::Loading,
        law,
        stiffness: stiffness(YOUNG, thickness, spacing),
        friction: 0.0,
    };
    let sides = [Vec3::z(), Vec3::x() * 1.6].map(|from| [from, -from]);
    let pairs = [(sides[0], 0.75, 0.0), (sides[1], 0.6, 0.5)];
    let tools = pairs.into_iter().flat_map(|(sides, part, begin)| sides.map(|from| flat(from, part, begin)));
    let value = -YOUNG * thickness.powi(3) / 12.0;
    let load: Box<dyn Load> = Box::new(Pressure { value, follower: true });
    let loads = vec![AppliedLoad { load, amplitude: Amplitude::Constant }];
    let stiffness = 0.5 * stiffness(YOUNG, thickness, spacing);
    let own = OwnContact { law, stiffness, edges: true, friction: 0.0 };
    let cloud = tube(round, along, spacing);
    let formulation = Formulation::StressPoint(Reach::Cell);
    let built = Parts { loads, ..parts(cloud, formulation, thickness) };
    let mut shell = Shell::builder(built).tools(tools.collect()).touching_itself(own).build().unwrap();
    for a in 0..shell.len() {
        let x = shell.position(a);
        let rate = 2e-3 * sound * libm::sin(3.0 * x.y + 2.0 * x.x);
        shell.set_rate(a, Vec3::new(x.x, 0.0, x.z) * rate, Vec3::zeros());
    }
    let run =
        Transient { duration: 1e6, record_every: 0.02 * duration, damping: 8.0 / duration, safety: 0.8 };
    let mut march = March::start(run, &mut shell).unwrap();
    let (mut depth, mut area, mut crossed, mut shortest): (f64, f64, usize, f64) =
        (0.0, 0.0, 0, f64::INFINITY);
    let (mut open, mut turned): (f64, f64) = (0.0, 0.0);
    let each = (steps / 50).max(1) as u64;
    while march.clock().steps < steps as u64 {
        if let Event::Record(record) = march.advance(&mut shell).unwrap() {
            let energy = record.energy;
            turned = turned.max(energy.kinetic + energy.internal + energy.dissipated);
            open = open.max(record.balance_error.abs());
        }
        let touch = shell.own_touch().unwrap();
        (depth, area) = (depth.max(touch.greatest_depth), area.max(touch.area));
        shortest = shortest.min(march.clock().dt);
        if march.clock().steps.is_multiple_of(each) {
            let found = crossings(&shell);
            crossed += found;
            println!("{}: {found} crossings, {touch:?}", march.clock().steps);
        }
    }
    let whole = std::f64::consts::TAU * length;
    println!(
        "{} particles, {steps} steps: {crossed} crossings, depth {depth:.2}, touching {:.2} of it, shortest step {shortest:.2e}, energy left open {:.1e}",
        shell.len(),
        area / whole,
        open / turned
    );
    assert_eq!(crossed, 0);
    assert!(area > 0.03 * whole && depth < 1.0, "{area} of {whole}, {depth}");
}
