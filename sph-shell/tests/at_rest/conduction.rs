//! Heat along a shell: linear temperatures, one free level, closed forms of walls and fins, radiation, sheets and axes that are turned.

use std::f64::consts::PI;

use crate::common::{disordered_flat, flat, scattered_flat};
use nalgebra::Rotation3;
use sph_core::{Cloud, Vec3};
use sph_shell::{
    Conduction, ConductionError, Conductor, ConductorError, HeatCourse, Radiation, Temperatures, spread,
};

const LENGTHS: [f64; 2] = [2.0, 1.5];

fn alike(cloud: &Cloud, conductor: Conductor) -> Conduction {
    Conduction::new(cloud, &vec![conductor; cloud.cells.len()]).unwrap()
}

fn isotropic(cloud: &Cloud, conductance: f64) -> Conduction {
    alike(cloud, Conductor::isotropic(conductance))
}

/// The areas of all particles.
fn all(cloud: &Cloud) -> Vec<(u32, f64)> {
    spread(cloud, &Vec::from_iter(0..cloud.cells.len() as u32), |_| 1.0)
}

fn where_(cloud: &Cloud, is: impl Fn(&Vec3) -> bool) -> Vec<u32> {
    (0..cloud.len() as u32).filter(|&a| is(&cloud.positions[a as usize])).collect()
}

fn largest(cloud: &Cloud, found: &Temperatures, exact: impl Fn(&Vec3) -> f64) -> f64 {
    let errors = cloud.positions.iter().zip(&found.values).map(|(x, t)| (t - exact(x)).abs());
    errors.fold(0.0, f64::max)
}

fn on_boundary(x: &Vec3) -> bool {
    let ends = |x: f64, length: f64| x.abs() < 1e-9 || (x - length).abs() < 1e-9;
    ends(x.x, LENGTHS[0]) || ends(x.y, LENGTHS[1])
}

/// Rounding: numbers of size ten through a factor of some hundred unknowns.
const EXACT: f64 = 1e-12;

/// Temperatures may be counted from anywhere: the same heat runs, however little it is beside their level.
#[test]
fn a_little_heat_is_found_at_any_level() {
    let cloud = flat([21, 3], [1.0, 0.2]);
    let of = |level: f64| {
        let mut conduction = isotropic(&cloud, 0.2);
        conduction.hold(&where_(&cloud, |x| x.x == 0.0), level).unwrap();
        conduction.supply(&[(where_(&cloud, |x| x.x > 1.0 - 1e-9)[0], 1e-8)]);
        conduction.steady().unwrap()
    };
    for level in [0.0, 300.0] {
        let found = of(level);
        // 300 goes in steps of 6e-14, what runs by 1e-8 from cell to cell: measured 1.5e-6.
        assert!((found.balance.held / -1e-8 - 1.0).abs() < 5e-6, "{level}: {:?}", found.balance);
    }
}

/// A plate that radiates into empty space, and nothing else, finds the temperature at which it gives off what it is given; one that is drawn more heat than it
/// has is refused.
#[test]
fn a_plate_radiates_into_empty_space() {
    let cloud = flat([5, 3], [1.0, 0.5]);
    let all: Vec<(u32, f64)> = (0..cloud.len() as u32).map(|a| (a, 1.0)).collect();
    let of = |heat: f64| {
        let mut conduction = isotropic(&cloud, 0.2);
        conduction.radiate(&all, Radiation { factor: 5.67e-8, surroundings: 0.0, zero: 0.0 });
        let heat: Vec<(u32, f64)> = all.iter().map(|&(a, _)| (a, heat)).collect();
        conduction.supply(&heat);
        conduction.steady()
    };
    let found = of(500.0).unwrap();
    let exact = libm::pow(500.0 / 5.67e-8, 0.25);
    assert!(found.values.iter().all(|t| (t / exact - 1.0).abs() < 1e-10), "{exact}: {:?}", found.values);
    assert!(matches!(of(-500.0), Err(ConductionError::BelowZero { .. } | ConductionError::Balance(_))));
}

#[test]
fn linear_temperatures_are_exact_on_uneven_cells() {
    let linear = |x: &Vec3| 3.0 + 2.0 * x.x - 5.0 * x.y;
    let tensor = Conductor::ply([9.0, 2.0], 0.6);
    for cloud in [flat([7, 6], LENGTHS), disordered_flat([9, 7], LENGTHS), scattered_flat(0.2, LENGTHS)] {
        let mut conduction = alike(&cloud, Conductor { tensor, axis: Some(Vec3::new(1.0, 0.3, 0.0)) });
        for a in where_(&cloud, on_boundary) {
            conduction.hold(&[a], linear(&cloud.positions[a as usize])).unwrap();
        }
        let found = conduction.steady().unwrap();
        assert!(largest(&cloud, &found, linear) < EXACT, "{}", largest(&cloud, &found, linear));
        assert_eq!(found.iterations, 1);
        // By hand: along the fibre, .6 rad beyond the axis, 9; across it 2.
        let angle: f64 = 0.6 + libm::atan2(0.3, 1.0);
        let (fibre, across) = (
            Vec3::new(libm::cos(angle), libm::sin(angle), 0.0),
            Vec3::new(-libm::sin(angle), libm::cos(angle), 0.0),
        );
        let slope = Vec3::new(2.0, -5.0, 0.0);
        let flux = -(fibre * 9.0 * slope.dot(&fibre) + across * 2.0 * slope.dot(&across));
        assert!(found.flux.iter().all(|own| (own - flux).norm() < 1e-10 * flux.norm()));
        assert!(found.balance.held.abs() < 1e-10);
    }
}

#[test]
fn nothing_but_a_uniform_temperature_runs_free_of_heat() {
    let cloud = disordered_flat([8, 6], LENGTHS);
    let mut free = isotropic(&cloud, 1.0);
    assert_eq!(free.untold(), Some(0));
    assert!(matches!(free.steady(), Err(ConductionError::Untold { particle: 0 })));
    // One particle that is held tells all: the matrix of the others has no zero, or its factor would be refused.
    free.hold(&[20], 4.0).unwrap();
    let found = free.steady().unwrap();
    assert!(largest(&cloud, &found, |_| 4.0) < EXACT);
    // The pattern of single cells conducts: heat that alternates from particle to particle warms by 1.8, where it ran free by any amount.
    let pattern = |a: u32| if (a % 8 + a / 8).is_multiple_of(2) { 1.0 } else { -1.0 };
    let heat: Vec<(u32, f64)> = (0..cloud.len() as u32).map(|a| (a, pattern(a))).collect();
    free.supply(&heat);
    let found = free.steady().unwrap();
    assert!(largest(&cloud, &found, |_| 4.0) < 5.4, "{}", largest(&cloud, &found, |_| 4.0));
    let opposite = free.hold(&[20], 5.0);
    assert!(matches!(opposite, Err(ConductionError::Contradiction { particle: 20, .. })));
}

#[test]
fn a_surface_that_does_not_conduct_everywhere_is_refused() {
    let cloud = flat([4, 4], LENGTHS);
    let mut conductors = vec![Conductor::isotropic(1.0); cloud.cells.len()];
    conductors[5] = Conductor { tensor: [1.0, 4.0, 2.0], axis: None };
    assert!(matches!(Conduction::new(&cloud, &conductors), Err(ConductorError::Conductor { cell: 5, .. })));
    assert!(matches!(Conduction::new(&cloud, &conductors[1..]), Err(ConductorError::Cells { .. })));
    conductors[5] = Conductor { axis: Some(Vec3::z()), ..Conductor::isotropic(1.0) };
    assert!(matches!(Conduction::new(&cloud, &conductors), Err(ConductorError::Space(_))));
}

/// A straight fin of length one, root at one, insulated tip: T = cosh m(1 − x)/cosh m; its error and the heat at its root.
fn fin(cells: usize) -> [f64; 2] {
    let m: f64 = 3.0;
    let cloud = flat([cells + 1, 3], [1.0, 0.2]);
    let mut conduction = isotropic(&cloud, 0.5);
    conduction.film(&all(&cloud), 0.5 * m * m, 0.0);
    conduction.hold(&where_(&cloud, |x| x.x < 1e-9), 1.0).unwrap();
    let found = conduction.steady().unwrap();
    let error = largest(&cloud, &found, |x| libm::cosh(m * (1.0 - x.x)) / libm::cosh(m));
    assert!((found.balance.held + found.balance.film).abs() < 1e-12);
    [error, (found.balance.held / (0.5 * 0.2 * m * libm::tanh(m)) - 1.0).abs()]
}

#[test]
fn a_fin_gives_off_what_its_closed_form_says_by_second_order() {
    let errors = [10, 20, 40].map(fin);
    for pair in errors.windows(2) {
        for k in 0..2 {
            let order = libm::log2(pair[0][k] / pair[1][k]);
            assert!((order - 2.0).abs() < 0.06, "{errors:?}");
        }
    }
    // 9.3e-5, and 7e-4 of the heat: temperatures linear along a cell, heat lumped at its ends.
    assert!(errors[2][0] < 2.8e-4 && errors[2][1] < 2.1e-3, "{errors:?}");
}

/// A ring between radii one and two, an angle wide, with cells that are longer the farther out they are.
fn ring(cells: usize) -> Cloud {
    let square = flat([cells + 1, cells + 1], [1.0, 1.0]);
    let bent = |x: &Vec3| {
        let (radius, angle) = (1.0 + x.x, 0.7 * x.y);
        Vec3::new(radius * libm::cos(angle), radius * libm::sin(angle), 0.0)
    };
    Cloud::from_cells(square.positions.iter().map(bent).collect(), None, square.cells).unwrap()
}

fn radius_is(radius: f64) -> impl Fn(&Vec3) -> bool {
    move |x| (x.norm() - radius).abs() < 1e-9
}

#[test]
fn the_wall_of_a_tube_conducts_by_the_logarithm() {
    let errors = [8, 16].map(|cells| {
        let cloud = ring(cells);
        let mut conduction = isotropic(&cloud, 2.0);
        conduction.hold(&where_(&cloud, radius_is(1.0)), 1.0).unwrap();
        conduction.hold(&where_(&cloud, radius_is(2.0)), 0.0).unwrap();
        let found = conduction.steady().unwrap();
        let through: f64 = where_(&cloud, radius_is(1.0)).iter().map(|&a| found.held[a as usize]).sum();
        let exact = 2.0 * 0.7 / libm::log(2.0);
        [
            largest(&cloud, &found, |x| 1.0 - libm::log(x.norm()) / libm::log(2.0)),
            (through / exact - 1.0).abs(),
        ]
    });
    assert!(
        libm::log2(errors[0][0] / errors[1][0]) > 1.9 && libm::log2(errors[0][1] / errors[1][1]) > 1.9,
        "{errors:?}"
    );
    // 3e-5 and 3.4e-4: radii are straight, arcs are chords.
    assert!(errors[1][0] < 9e-5 && errors[1][1] < 1e-3, "{errors:?}");
}

/// Modified Bessel functions of order zero and their slopes by the trapezoidal rule, which is exact but for rounding here.
fn bessel(x: f64) -> [f64; 2] {
    let i0 = (0..64).map(|k| libm::exp(x * libm::cos(PI * (k as f64 + 0.5) / 64.0))).sum::<f64>() / 64.0;
    let step = 0.02;
    let k0 = (0..400).map(|k| libm::exp(-x * libm::cosh(step * k as f64)) * if k == 0 { 0.5 } else { 1.0 });
    [i0, k0.sum::<f64>() * step]
}

#[test]
fn an_annular_fin_cools_by_bessel_functions() {
    let m = 1.5;
    let cloud = ring(16);
    let mut conduction = isotropic(&cloud, 2.0);
    conduction.film(&all(&cloud), 2.0 * m * m, 10.0);
    conduction.hold(&where_(&cloud, radius_is(1.0)), 30.0).unwrap();
    conduction.hold(&where_(&cloud, radius_is(2.0)), 18.0).unwrap();
    let found = conduction.steady().unwrap();
    let [[i1, k1], [i2, k2]] = [bessel(m), bessel(2.0 * m)];
    let det = i1 * k2 - i2 * k1;
    let [a, b] = [(20.0 * k2 - 8.0 * k1) / det, (8.0 * i1 - 20.0 * i2) / det];
    let exact = |x: &Vec3| {
        let [i, k] = bessel(m * x.norm());
        10.0 + a * i + b * k
    };
    // 1.9e-4 of the twenty degrees, by sixteen cells.
    let error = largest(&cloud, &found, exact) / 20.0;
    assert!(error < 5.6e-4, "{error}");
}

#[test]
fn faces_radiate_by_the_fourth_power() {
    // A plate alone in space: what is supplied leaves by radiation, in degrees Celsius.
    let (black, zero) = (5.670374419e-8, -273.15);
    let cloud = flat([3, 3], [1.0, 1.0]);
    let mut alone = isotropic(&cloud, 5.0);
    alone.radiate(&all(&cloud), Radiation { factor: 2.0 * 0.8 * black, surroundings: 20.0, zero });
    let heat: Vec<_> = all(&cloud).into_iter().map(|(a, area)| (a, 5000.0 * area)).collect();
    alone.supply(&heat);
    let found = alone.steady().unwrap();
    let exact = libm::pow(293.15_f64.powi(4) + 5000.0 / (1.6 * black), 0.25) + zero;
    assert!(largest(&cloud, &found, |_| exact) < 1e-9 * exact, "{found:?}");
    // A fin in empty space, T″ = c T⁴: T = T₀ (1 + x √(9 c T₀³/10))^(−2/3).
    let errors = [20, 40].map(|cells| {
        let c: f64 = 10.0;
        let cloud = flat([cells + 1, 3], [1.0, 0.1]);
        let exact = |x: &Vec3| libm::pow(1.0 + x.x * (0.9 * c).sqrt(), -2.0 / 3.0);
        let mut fin = isotropic(&cloud, 1.0);
        fin.radiate(&all(&cloud), Radiation { factor: c, surroundings: 0.0, zero: 0.0 });
        for end in [0.0, 1.0] {
            let at = where_(&cloud, |x| (x.x - end).abs() < 1e-9);
            fin.hold(&at, exact(&Vec3::new(end, 0.0, 0.0))).unwrap();
        }
        let found = fin.steady().unwrap();
        assert!(found.iterations < 8, "{}", found.iterations);
        largest(&cloud, &found, exact)
    });
    // 1.6e-4 by 40 cells.
    assert!(libm::log2(errors[0] / errors[1]) > 1.9 && errors[1] < 4.8e-4, "{errors:?}");
}

#[test]
fn turned_in_space_temperatures_are_the_same() {
    let turn = Rotation3::new(Vec3::new(0.4, -1.1, 0.7));
    let axis = Vec3::new(1.0, 0.4, 0.0);
    let found = [Rotation3::identity(), turn].map(|turn| {
        let cloud = disordered_flat([7, 6], LENGTHS).transformed(&turn, &Vec3::zeros());
        let conductor = Conductor { tensor: [5.0, 1.0, 0.5], axis: Some(turn * axis) };
        let mut conduction = alike(&cloud, conductor);
        conduction.film(&all(&cloud), 0.3, 10.0);
        conduction.hold(&[0, 1, 2], 50.0).unwrap();
        conduction.steady().unwrap()
    });
    for (a, b) in found[0].values.iter().zip(&found[1].values) {
        assert!((a - b).abs() < EXACT * 50.0);
    }
    for (a, b) in found[0].flux.iter().zip(&found[1].flux) {
        assert!((turn * a - b).norm() < 1e-9);
    }
}

/// Two sheets that meet along a line, each with particles of its own there, are one for heat: half of it runs into each.
#[test]
fn heat_runs_through_joined_sheets() {
    let plate = flat([5, 3], [1.0, 0.5]);
    let other = plate.transformed(&Rotation3::new(Vec3::new(0.0, 1.2, 0.0)), &Vec3::new(0.0, 0.0, 0.0));
    let count = plate.len() as u32;
    let shifted = other.cells.iter().map(|cell| {
        let mut cell = *cell;
        cell.corners.iter_mut().for_each(|corner| *corner += count);
        cell
    });
    let cells = plate.cells.iter().copied().chain(shifted).collect();
    let positions: Vec<Vec3> = plate.positions.iter().chain(&other.positions).copied().collect();
    let line: Vec<u32> = (0..count).filter(|&a| plate.positions[a as usize].x.abs() < 1e-9).collect();
    let joined = line.iter().map(|&a| vec![a, a + count]).collect();
    let cloud = Cloud::from_sheets(positions, None, cells, joined).unwrap();
    let mut conduction = isotropic(&cloud, 2.0);
    let far = |sheet: u32| -> Vec<u32> {
        (0..count)
            .filter(|&a| plate.positions[a as usize].x > 1.0 - 1e-9)
            .map(|a| a + sheet * count)
            .collect()
    };
    conduction.hold(&far(0), 10.0).unwrap();
    conduction.hold(&far(1), 4.0).unwrap();
    let found = conduction.steady().unwrap();
    for &a in &line {
        assert!((found.values[a as usize] - 7.0).abs() < EXACT * 10.0);
        assert!((found.values[(a + count) as usize] - 7.0).abs() < EXACT * 10.0);
    }
    let through: f64 = far(0).iter().map(|&a| found.held[a as usize]).sum();
    // Three degrees over a length of one, by a width of one half.
    assert!((through - 2.0 * 0.5 * 3.0).abs() < 1e-10);
}

/// A conductivity of `1 + 2T/100` between 0 and 100: `T + T²/100` is linear (Kirchhoff), at the particles to rounding; in time it ends there.
#[test]
fn a_conductivity_that_goes_with_the_temperature_is_kirchhoffs_transform() {
    let cloud = flat([11, 3], [1.0, 0.2]);
    let of = |last: f64| {
        let mut conduction = isotropic(&cloud, 2.0);
        let cells = Vec::from_iter(0..cloud.cells.len() as u32);
        conduction.by_temperature(&cells, vec![[0.0, 1.0], [40.0, 1.8], [last, 1.0 + 0.02 * last]]);
        conduction.hold(&where_(&cloud, |x| x.x < 1e-9), 0.0).unwrap();
        conduction.hold(&where_(&cloud, |x| x.x > 1.0 - 1e-9), 100.0).unwrap();
        conduction
    };
    let exact = |x: &Vec3| 50.0 * ((1.0 + 8.0 * x.x).sqrt() - 1.0);
    let conduction = of(100.0);
    let found = conduction.steady().unwrap();
    println!("{} solves, off by {:e}", found.iterations, largest(&cloud, &found, exact));
    assert!(largest(&cloud, &found, exact) < 1e-9, "{}", largest(&cloud, &found, exact));
    let end = where_(&cloud, |x| x.x > 1.0 - 1e-9);
    let through: f64 = end.iter().map(|&a| found.held[a as usize]).sum();
    assert!((through / (2.0 * 0.2 * 200.0) - 1.0).abs() < 1e-10, "{through}");
    // Along a cell the flux is that of the means: 2 (1 + 2T/100) dT/dx = 400.
    assert!(found.flux.iter().all(|flux| (flux.x / -400.0 - 1.0).abs() < 1e-9), "{:?}", found.flux[0]);
    let mut course = HeatCourse::new(&conduction, &all(&cloud), &vec![0.0; cloud.len()]).unwrap();
    course.advance(&conduction, 4.0, 0.01).unwrap();
    assert!(largest(&cloud, course.temperatures(), exact) < 1e-3);
    let (came, stored) = (course.came().held, course.stored());
    assert!((came / stored - 1.0).abs() < 1e-11, "{came} {stored}");
    let short = of(90.0).steady();
    assert!(matches!(short, Err(ConductionError::Table { .. })), "{short:?}");
}

/// A table of one entry knows one temperature: a plate of another one is refused with its ends.
#[test]
fn a_table_of_one_entry_knows_one_temperature() {
    let cloud = flat([4, 3], [1.0, 0.5]);
    let of = |held: f64| {
        let mut conduction = isotropic(&cloud, 2.0);
        conduction.by_temperature(&Vec::from_iter(0..cloud.cells.len() as u32), vec![[20.0, 1.5]]);
        conduction.hold(&where_(&cloud, |x| x.x < 1e-9 || x.x > 1.0 - 1e-9), held).unwrap();
        conduction.steady()
    };
    let beyond = of(25.0);
    assert!(matches!(beyond, Err(ConductionError::Table { ends: [20.0, 20.0], .. })), "{beyond:?}");
}
