//! Heat in time: what cools alone, walls and bars by series, courses, radiation, the estimate of a step, the balance of heat.

use std::f64::consts::PI;

use crate::common::{disordered_flat, flat};
use explicit_dynamics::Amplitude;
use sph_core::{Cloud, Vec3};
use sph_shell::{Conduction, ConductionError, Conductor, HeatCourse, Radiation, spread};

const EVERY: f64 = f64::INFINITY;

fn isotropic(cloud: &Cloud, conductance: f64) -> Conduction {
    Conduction::new(cloud, &vec![Conductor::isotropic(conductance); cloud.cells.len()]).unwrap()
}

fn all(cloud: &Cloud) -> Vec<(u32, f64)> {
    spread(cloud, &Vec::from_iter(0..cloud.cells.len() as u32), |_| 1.0)
}

fn where_(cloud: &Cloud, is: impl Fn(&Vec3) -> bool) -> Vec<u32> {
    (0..cloud.len() as u32).filter(|&a| is(&cloud.positions[a as usize])).collect()
}

/// The heat that came in all less what is stored, over what is stored.
fn open(course: &HeatCourse) -> f64 {
    let came = course.came();
    (came.supplied + came.held + came.film + came.radiated - course.stored()) / course.stored()
}

/// A plate of capacity one by area at one temperature, by so many steps of equal length to a time of one; the error of its temperature.
fn alone(steps: usize, give: impl Fn(&Cloud, &mut Conduction), start: f64, exact: f64) -> f64 {
    let cloud = flat([4, 3], [1.0, 0.5]);
    let mut conduction = isotropic(&cloud, 2.0);
    give(&cloud, &mut conduction);
    let mut course = HeatCourse::new(&conduction, &all(&cloud), &vec![start; cloud.len()]).unwrap();
    for i in 1..=steps {
        course.advance(&conduction, i as f64 / steps as f64, EVERY).unwrap();
    }
    assert!(open(&course).abs() < 1e-12, "{}", open(&course));
    assert_eq!((course.steps(), course.time()), (steps as u64, 1.0));
    let values = &course.temperatures().values;
    assert!(values.iter().all(|t| (t - values[0]).abs() < 1e-12 * start.abs().max(1.0)), "{values:?}");
    values[0] - exact
}

fn orders(of: impl Fn(usize) -> f64) -> ([f64; 2], f64) {
    let errors = [8, 16, 32].map(of);
    ([errors[0] / errors[1], errors[1] / errors[2]].map(|ratio| libm::log2(ratio.abs())), errors[2])
}

/// By films the exponential, under an ambient that rises `r (t − τ (1 − e^(−t/τ)))`, by radiation `(T⁻³ + 3 a t)^(−1/3)`: of second order.
#[test]
fn what_is_alone_cools_as_its_closed_form_says() {
    let film = |cloud: &Cloud, conduction: &mut Conduction| conduction.film(&all(cloud), 1.5, 20.0);
    let cooled = orders(|steps| alone(steps, film, 100.0, 20.0 + 80.0 * libm::exp(-1.5)));
    let rising = |cloud: &Cloud, conduction: &mut Conduction| {
        conduction.in_course(Amplitude::Ramp(1.0), |conduction| conduction.film(&all(cloud), 1.5, 30.0));
    };
    let exact = 30.0 * (1.0 - (1.0 - libm::exp(-1.5)) / 1.5);
    let warmed = orders(|steps| alone(steps, rising, 0.0, exact));
    let radiating = |cloud: &Cloud, conduction: &mut Conduction| {
        conduction.radiate(&all(cloud), Radiation { factor: 2e-8, surroundings: 0.0, zero: 0.0 });
    };
    let exact = libm::pow(libm::pow(500.0, -3.0) + 6e-8, -1.0 / 3.0);
    let radiated = orders(|steps| alone(steps, radiating, 500.0, exact));
    println!("{cooled:?} {warmed:?} {radiated:?}");
    for (orders, _) in [cooled, warmed, radiated] {
        assert!(orders.iter().all(|order| (order - 2.0).abs() < 0.15), "{orders:?}");
    }
}

/// A bar of length one and diffusivity one from one temperature, its ends held at another from the start: Fourier's series \[carslaw1959\].
fn slab(x: f64, time: f64) -> f64 {
    let term = |n: usize| {
        let k = (2 * n + 1) as f64 * PI;
        4.0 / k * libm::sin(k * x) * libm::exp(-k * k * time)
    };
    (0..40).map(term).sum()
}

#[test]
fn a_bar_whose_ends_are_quenched_follows_its_series() {
    let errors = [10, 20, 40].map(|cells| {
        let cloud = flat([cells + 1, 3], [1.0, 0.1]);
        let mut conduction = isotropic(&cloud, 3.0);
        conduction.hold(&where_(&cloud, |x| x.x < 1e-9 || x.x > 1.0 - 1e-9), 0.0).unwrap();
        let capacities = spread(&cloud, &Vec::from_iter(0..cloud.cells.len() as u32), |_| 3.0);
        let mut course = HeatCourse::new(&conduction, &capacities, &vec![1.0; cloud.len()]).unwrap();
        let mut worst: f64 = 0.0;
        for i in 1..=8 {
            let time = 0.0125 * f64::from(i);
            course.advance(&conduction, time, 1e-5).unwrap();
            for (x, t) in cloud.positions.iter().zip(&course.temperatures().values) {
                assert!((0.0..=1.0).contains(t), "{t}");
                if i >= 4 {
                    worst = worst.max((t - slab(x.x, time)).abs());
                }
            }
        }
        assert!(open(&course).abs() < 1e-12, "{}", open(&course));
        println!("{cells} cells: {worst:e}, {} steps, estimate {:e}", course.steps(), course.error());
        worst
    });
    // 4.6e-3, 1.1e-3, 2.7e-4.
    let order = |k: usize| libm::log2(errors[k] / errors[k + 1]);
    assert!((order(0) - 2.0).abs() < 0.2 && (order(1) - 2.0).abs() < 0.2, "{errors:?}");
}

/// A sudden flux into what is as good as endless warms its face by `2 q √(t/(π k ρ c))` \[carslaw1959\].
#[test]
fn a_sudden_flux_warms_a_half_space_by_the_root_of_time() {
    let cloud = flat([81, 2], [4.0, 0.05]);
    let mut conduction = isotropic(&cloud, 2.0);
    let face = where_(&cloud, |x| x.x < 1e-9);
    conduction.supply(&face.iter().map(|&a| (a, 7.0 * 0.025)).collect::<Vec<_>>());
    let capacities = spread(&cloud, &Vec::from_iter(0..cloud.cells.len() as u32), |_| 5.0);
    let mut course = HeatCourse::new(&conduction, &capacities, &vec![0.0; cloud.len()]).unwrap();
    for time in [0.25, 0.5, 1.0] {
        course.advance(&conduction, time, 1e-4).unwrap();
        let exact = 2.0 * 7.0 * (time / (PI * 2.0 * 5.0)).sqrt();
        let error = course.temperatures().values[face[0] as usize] / exact - 1.0;
        println!("at {time}: {error:e}, {} steps", course.steps());
        // 3.6e-4/t: of second order of the cells over the depth warmed, √(k t/ρc).
        assert!(error.abs() < 3.0 * 3.7e-4 / time, "{error}");
    }
    assert!((course.came().supplied - 7.0 * 0.05).abs() < 1e-13 && open(&course).abs() < 1e-12);
}

/// Held by a sine the end of a long bar sends a wave in, `exp(−x/δ) sin(ωt − x/δ)`, δ = √(2k/(ρ c ω)); what the rate of what holds says in time is what came.
#[test]
fn a_course_of_what_is_held_sends_a_wave_in() {
    let cloud = flat([101, 2], [5.0, 0.05]);
    let mut conduction = isotropic(&cloud, 1.0);
    let face = where_(&cloud, |x| x.x < 1e-9);
    let sine = Amplitude::Sine { period: 1.0, growth: None };
    conduction.in_course(sine, |conduction| conduction.hold(&face, 10.0)).unwrap();
    let capacities = all(&cloud);
    let mut course = HeatCourse::new(&conduction, &capacities, &vec![0.0; cloud.len()]).unwrap();
    let (mut rates, mut came) = (Vec::new(), 0.0);
    for i in 1..=400 {
        course.advance(&conduction, 0.01 * f64::from(i), 1e-4).unwrap();
        rates.push(course.temperatures().balance.held);
        if i == 300 {
            came = course.came().held;
        }
    }
    let depth = (1.0 / PI).sqrt();
    let worst = cloud.positions.iter().zip(&course.temperatures().values).map(|(x, t)| {
        let exact = 10.0 * libm::exp(-x.x / depth) * libm::sin(-x.x / depth);
        (t - exact).abs()
    });
    let worst = worst.fold(0.0, f64::max);
    // The last period by the trapezoidal rule.
    let summed: f64 = 0.01 * (rates[300..399].iter().sum::<f64>() + 0.5 * (rates[299] + rates[399]));
    let (came, turned) =
        (course.came().held - came, rates.iter().fold(0.0, |most: f64, rate| most.max(rate.abs())));
    println!("{worst:e}; {summed:e} {came:e} of {turned:e}; {} steps", course.steps());
    // .12 of ten: what is left of the start after four periods, by t^(-3/2), and cells of a tenth of the depth.
    assert!(worst < 0.36 && (summed - came).abs() < 1e-3 * turned);
    assert!(open(&course).abs() < 1e-11);
}

/// On an uneven lattice a step that is chosen keeps to what it says: the whole error is within the sum of the estimates, and that falls with the tolerance.
#[test]
fn the_estimate_is_what_a_run_is_off_by() {
    let cloud = disordered_flat([9, 7], [2.0, 1.5]);
    let of = |tolerance: f64| {
        let mut conduction = isotropic(&cloud, 1.0);
        conduction.hold(&where_(&cloud, |x| x.x < 1e-9), 100.0).unwrap();
        conduction.film(&all(&cloud), 0.5, 20.0);
        let mut course = HeatCourse::new(&conduction, &all(&cloud), &vec![20.0; cloud.len()]).unwrap();
        course.advance(&conduction, 0.5, tolerance).unwrap();
        (course.temperatures().values.clone(), course.error(), course.steps())
    };
    let (exact, ..) = of(1e-7);
    for tolerance in [1.0, 0.1, 0.01] {
        let (values, estimate, steps) = of(tolerance);
        let error = exact.iter().zip(&values).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        println!("{tolerance}: off by {error:e}, estimate {estimate:e}, {steps} steps");
        assert!(error < estimate && estimate < tolerance * steps as f64);
        assert!(error > 0.02 * estimate, "an estimate that says little: {error} {estimate}");
    }
}

#[test]
fn what_has_no_course_is_refused() {
    let cloud = flat([4, 3], [1.0, 0.5]);
    let mut conduction = isotropic(&cloud, 1.0);
    let start = vec![0.0; cloud.len()];
    let none = HeatCourse::new(&conduction, &all(&cloud)[1..], &start).map(drop);
    assert!(matches!(none, Err(ConductionError::Capacity { particle: 0, .. })), "{none:?}");
    // A corner that two courses hold is held once if they are one.
    let ramp = || Amplitude::Ramp(2.0);
    conduction.in_course(ramp(), |conduction| conduction.hold(&[0, 1], 5.0)).unwrap();
    conduction.in_course(ramp(), |conduction| conduction.hold(&[0, 4], 5.0)).unwrap();
    let other = conduction.in_course(Amplitude::Ramp(3.0), |conduction| conduction.hold(&[4], 5.0));
    assert!(matches!(other, Err(ConductionError::Contradiction { particle: 4, .. })));
    // Taken more heat off than it has.
    let mut cold = isotropic(&cloud, 1.0);
    cold.radiate(&all(&cloud), Radiation { factor: 1e-8, surroundings: 0.0, zero: 0.0 });
    cold.supply(&[(0, -100.0)]);
    let mut course = HeatCourse::new(&cold, &all(&cloud), &vec![10.0; cloud.len()]).unwrap();
    let found = course.advance(&cold, 1.0, EVERY);
    assert!(matches!(found, Err(ConductionError::BelowZero { .. })), "{found:?}");
}

/// A pulse of a fiftieth of the way, far from where halves of it end: a step ends at each of its corners, however much is allowed, and all of it enters.
#[test]
fn a_step_ends_at_the_corners_of_a_course() {
    let cloud = flat([4, 3], [1.0, 0.5]);
    let mut conduction = isotropic(&cloud, 2.0);
    let pulse = Amplitude::Table(vec![[0.31, 0.0], [0.32, 1.0], [0.33, 0.0]]);
    let shares = all(&cloud);
    conduction.in_course(pulse, |conduction| conduction.supply(&shares));
    let mut course = HeatCourse::new(&conduction, &shares, &vec![0.0; cloud.len()]).unwrap();
    course.advance(&conduction, 1.0, EVERY).unwrap();
    assert_eq!((course.steps(), course.time()), (4, 1.0));
    // One by area over .5, for .01: the rule is exact of straight lines; the differences of times leave 1e-14.
    let supplied = course.came().supplied / (0.5 * 0.01);
    assert!((supplied - 1.0).abs() < 1e-12, "{supplied}");
    assert!(open(&course).abs() < 1e-12, "{}", open(&course));
    // Ends of the whole way and what lies beyond it add no step.
    course.advance(&conduction, 1.5, EVERY).unwrap();
    assert_eq!((course.steps(), course.time()), (5, 1.5));
}
