//! Gases and liquids enclosed by a shell: volumes, derivatives, and closed forms of tubes and boxes.

use std::f64::consts::FRAC_PI_2;
use std::ops::ControlFlow;

use crate::common::{
    POISSON, RandomNumbers, Sheets, X, Y, YOUNG, Z, derivatives_agree, disordered_curved, flat, parts, shake,
    shake_unknowns, spectrum, supported,
};
use explicit_dynamics::Amplitude;
use implicit_statics::{
    Equilibrium, Mode, Newton, NewtonOptions, RelaxationOptions, load_rate_error, natural_modes, relax,
    unwatched,
};
use sph_core::{Cloud, Cylinder, EndWeights, Side, Vec3, lattice};
use sph_shell::{
    AppliedLoad, Clamped, Content, Enclosed, EnclosedError, Formulation, Moved, Preloaded, Pressure, Reach,
    Shell, ShellError, StaticShell, Supported, SymmetryPlane, Volumes,
};

const GAS: Content = Content::Gas { pressure: 3.0, ambient: 1.0, exponent: 1.4 };
const LIQUID: Content = Content::Liquid { added: 0.1, bulk_modulus: 500.0 };

fn enclosing(
    cloud: Cloud,
    thickness: f64,
    supports: Vec<Supported>,
    content: Content,
    beside: f64,
) -> Result<Shell, ShellError> {
    let cells = (0..cloud.cells.len() as u32).collect();
    let load = Box::new(Enclosed::new(cells, content, beside));
    let loads = vec![AppliedLoad { load, amplitude: Amplitude::Constant }];
    let parts = parts(cloud, Formulation::StressPoint(Reach::Cell), thickness);
    Shell::builder(sph_shell::Parts { supports, loads, ..parts }).build()
}

/// A part of a tube along y that slides in planes of symmetry and on two walls.
fn tube(counts: [usize; 2], angle: f64, at: Vec3) -> (Cloud, Vec<Supported>) {
    let patch = Cylinder { radius: 3.0, angles: [0.0, angle], length: 1.0 };
    let mut cloud = lattice(&patch, counts, EndWeights::Trapezoid).unwrap();
    let sides = cloud.sides.clone().unwrap();
    cloud.positions.iter_mut().for_each(|x| *x += at);
    let slides = |side, normal| supported(sides.edge(side).to_vec(), SymmetryPlane { normal });
    let supports = vec![
        slides(Side::U0, X),
        slides(Side::U1, Vec3::new(libm::cos(angle), 0.0, -libm::sin(angle))),
        slides(Side::V0, Y),
        slides(Side::V1, Y),
    ];
    (cloud, supports)
}

/// Of boxes, closed, open to a plane of symmetry, flat with a tank beside, from either side, near and far from the origin.
#[test]
fn volumes_are_those_of_boxes_and_tubes() {
    let size = Vec3::new(2.0, 3.0, 1.5);
    let volume = |shell: Shell| shell.enclosed_at(0)[1];
    let mut worst = 0.0_f64;
    for shift in [Vec3::zeros(), Vec3::new(40.0, -7.0, 300.0)] {
        for inward in [false, true] {
            let Cloud { mut positions, mut cells, .. } = Sheets::boxed(size, [4, 5, 3]).welded();
            positions.iter_mut().for_each(|x| *x += shift);
            if inward {
                cells.iter_mut().for_each(|cell| cell.corners.reverse());
            }
            let cloud = Cloud::from_cells(positions, None, cells).unwrap();
            let found = volume(enclosing(cloud, 0.1, vec![], GAS, 0.5).unwrap());
            worst = worst.max((found - 9.5).abs());
        }
        for angle in [FRAC_PI_2, 0.4] {
            // An inscribed polygon: n triangles with the angle α/n at the axis.
            let (cloud, supports) = tube([9, 4], angle, shift);
            let exact = 8.0 * 0.5 * 9.0 * libm::sin(angle / 8.0);
            worst = worst.max((volume(enclosing(cloud, 0.1, supports, GAS, 0.0).unwrap()) - exact).abs());
        }
    }
    let sheet = flat([5, 5], [2.0, 2.0]);
    let rim = sheet.sides.as_ref().unwrap();
    let rim = [Side::U0, Side::U1, Side::V0, Side::V1].map(|side| rim.edge(side).to_vec()).concat();
    let held = || vec![supported(rim.clone(), Clamped)];
    let found = volume(enclosing(sheet.clone(), 0.1, held(), GAS, 0.7).unwrap());
    worst = worst.max((found - 0.7).abs());
    println!("volumes miss by {worst:.1e}");
    assert!(worst < 1e-9);
    // Nothing enclosed, and a rim that is free.
    let refused = enclosing(sheet.clone(), 0.1, held(), GAS, 0.0).err().unwrap();
    assert!(
        matches!(refused, ShellError::Enclosed(EnclosedError::NoVolume { load: 0, beside: 0.0, .. })),
        "{refused}"
    );
    let refused = enclosing(sheet, 0.1, vec![], GAS, 0.7).err().unwrap();
    assert!(matches!(refused, ShellError::Enclosed(EnclosedError::OpenRim { load: 0, .. })), "{refused}");
}

/// A box with a fin inside, or with a wall across, has no inside by all of its cells; without them it has.
#[test]
fn fins_and_walls_across_enclose_nothing() {
    let size = Vec3::new(2.0, 3.0, 1.5);
    let across = |part: f64| Sheets::boxed(size, [2, 2, 2]).add(X, [Y * 3.0 * part, Z * 1.5], [2, 2]).cloud();
    for cloud in [across(1.0), across(0.5)] {
        let refused = enclosing(cloud, 0.1, vec![], GAS, 0.0).err().unwrap();
        assert!(
            matches!(refused, ShellError::Enclosed(EnclosedError::NoSurface { load: 0, .. })),
            "{refused}"
        );
    }
    assert!(enclosing(Sheets::boxed(size, [2, 2, 2]).cloud(), 0.1, vec![], GAS, 0.0).is_ok());
}

/// Forces are the slope of the content's energy, in any state; on a closed surface they have neither resultant nor moment.
#[test]
fn forces_have_a_potential_and_no_resultant() {
    let size = Vec3::new(2.0, 3.0, 1.5);
    for content in [GAS, LIQUID] {
        let mut shell =
            enclosing(Sheets::boxed(size, [3, 4, 2]).welded(), 0.1, vec![], content, 0.0).unwrap();
        let rest = shell.enclosed_at(0)[1];
        shake(&mut shell, 0.15, 7);
        let mut dice = RandomNumbers(9);
        let mut system = StaticShell::new(shell);
        let level = 0.6;
        system.evaluate(level);
        let shell = system.shell();
        let home: Vec<(Vec3, Vec3)> =
            (0..shell.len()).map(|a| (shell.position(a), shell.director(a))).collect();
        let force = |a: usize| {
            let f = shell.external_force(a);
            Vec3::new(f[0], f[1], f[2])
        };
        let forces: Vec<Vec3> = (0..shell.len()).map(force).collect();
        let size: f64 = forces.iter().map(Vec3::norm).sum();
        let sum: Vec3 = forces.iter().sum();
        let moment: Vec3 = home.iter().zip(&forces).map(|((x, _), f)| x.cross(f)).sum();
        let way: Vec<Vec3> = home.iter().map(|_| dice.vector()).collect();
        let work: f64 = forces.iter().zip(&way).map(|(f, v)| f.dot(v)).sum();
        let mut energy = |step: f64| {
            for (a, (x, d)) in home.iter().enumerate() {
                system.shell_mut().set_state(a, x + way[a] * step, *d);
            }
            system.evaluate(level);
            content.energy(level, Volumes { now: system.shell().enclosed_at(0)[1], rest })
        };
        let step = 1e-3;
        let slope =
            (8.0 * (energy(step) - energy(-step)) - energy(2.0 * step) + energy(-2.0 * step)) / (12.0 * step);
        let misses = [(slope + work) / work, sum.norm() / size, moment.norm() / size];
        println!("slope, resultant, moment: {misses:?}");
        assert!(misses[0].abs() < 1e-9 && misses[1] < 1e-14 && misses[2] < 1e-14, "{misses:?}");
    }
}

/// The whole tangent is the derivative, with junctions, planes of symmetry, preloads and prescribed motions.
#[test]
fn the_tangent_and_the_load_rate_are_the_derivatives() {
    for (name, content) in [("gas", GAS), ("liquid", LIQUID)] {
        let boxed = Sheets::boxed(Vec3::new(2.0, 3.0, 1.5), [3, 4, 2]).cloud();
        let (quarter, slides) = tube([7, 4], FRAC_PI_2, Vec3::new(1.0, 2.0, 3.0));
        for (what, cloud, supports) in [
            ("box", boxed.clone(), vec![]),
            ("quarter of a tube", quarter, slides),
            ("held sheet", disordered_curved([6, 5]), vec![]),
        ] {
            let supports = if what == "held sheet" {
                let sides = cloud.sides.as_ref().unwrap();
                let rim =
                    [Side::U0, Side::U1, Side::V0, Side::V1].map(|side| sides.edge(side).to_vec()).concat();
                vec![supported(rim, Clamped)]
            } else {
                supports
            };
            let mut system = StaticShell::new(enclosing(cloud, 0.1, supports, content, 4.0).unwrap());
            shake_unknowns(&mut system, 0.02, 5);
            system.shell_mut();
            derivatives_agree(&mut system, 0.7, &format!("{name}, {what}"));
            let rate = load_rate_error(&mut system, 0.7, 1e-3);
            assert!(rate < 1e-10, "{name}, {what}: load rate {rate:e}");
        }
        // A box whose inner particles of one face are pushed in.
        let lid = boxed.positions.iter().enumerate();
        let inner = lid.filter(|(_, x)| x.z > 1.4 && (0.3..1.7).contains(&x.x) && (0.3..2.7).contains(&x.y));
        let inner: Vec<u32> = inner.map(|(a, _)| a as u32).collect();
        assert!(!inner.is_empty());
        let pushes = supported(inner, Moved { direction: Z, by: -0.2, amplitude: Amplitude::Constant });
        let mut system = StaticShell::new(enclosing(boxed, 0.1, vec![pushes], content, 0.0).unwrap());
        shake_unknowns(&mut system, 0.02, 5);
        system.shell_mut();
        let rate = load_rate_error(&mut system, 0.7, 1e-3);
        println!("{name}, a box pushed in: load rate {rate:.1e}");
        assert!(rate < 1e-8, "{name}: {rate:e}");
    }
}

/// What is enclosed resists no rigid motion: exactly six eigenvalues of a free box vanish, and one, its breathing, rises far.
#[test]
fn a_free_box_of_gas_has_six_zero_modes() {
    let empty = Content::Gas { pressure: 0.0, ambient: 50.0, exponent: 1.0 };
    let cloud = || Sheets::boxed(Vec3::new(2.0, 3.0, 1.5), [3, 4, 2]).cloud();
    let values = spectrum(enclosing(cloud(), 0.1, vec![], empty, 0.0).unwrap());
    println!(
        "sixth {:.1e} and seventh {:.1e} of the last {:.1e}",
        values[5],
        values[6],
        values[values.len() - 1]
    );
    assert!(values[5].abs() < 1e-9 * values[6].abs());
    let free =
        spectrum(Shell::builder(parts(cloud(), Formulation::StressPoint(Reach::Cell), 0.1)).build().unwrap());
    let sums = [values.iter().sum::<f64>(), free.iter().sum()];
    assert!(sums[0] > 1.00003 * sums[1], "{sums:?}");
}

/// `e = p R (1 − ν²)/(E t)` round a tube between walls, with p of a liquid whose stiffness is its own: `p = B ((V₀ + ΔV)/(V₀ (1 + e)²) − 1)`.
#[test]
fn a_liquid_and_a_tube_share_what_is_pumped_in() {
    let thickness = 0.05;
    let (cloud, supports) = tube([13, 4], FRAC_PI_2, Vec3::zeros());
    let ring = 2.0 * 3.0 * (1.0 - POISSON * POISSON) / (YOUNG * thickness);
    let volume = 12.0 * 0.5 * 9.0 * libm::sin(FRAC_PI_2 / 12.0);
    for stiffer in [0.2, 1.0, 50.0, 1e5] {
        let bulk_modulus = stiffer / ring;
        let content = Content::Liquid { added: 2e-4 * volume, bulk_modulus };
        let shell = enclosing(cloud.clone(), thickness, supports_again(&supports), content, 0.0).unwrap();
        let mut system = StaticShell::new(shell);
        let converged =
            Newton::new(&system, &NewtonOptions::default()).unwrap().at_level(&mut system, 1.0).unwrap();
        system.evaluate(1.0);
        let [pressure, _] = system.shell().enclosed_at(0);
        // Newton's method on the one equation.
        let mut strain = 0.0_f64;
        for _ in 0..20 {
            let filled = bulk_modulus * 1.0002 / (1.0 + strain).powi(2);
            let left = filled - bulk_modulus - strain * 2.0 / ring;
            strain += left / (2.0 * filled / (1.0 + strain) + 2.0 / ring);
        }
        let exact = strain * 2.0 / ring;
        let miss = pressure / exact - 1.0;
        println!(
            "liquid {stiffer} times as stiff: pressure {pressure:.6e}, {miss:.1e}, {} iterations",
            converged.iterations
        );
        // A polygon of 12 cells a quarter is .2 % too stiff.
        assert!(miss.abs() < 6e-3, "{stiffer}: {miss:e}");
        assert!(converged.iterations <= 6, "{stiffer}: {:?}", converged.residuals);
        assert_eq!(converged.inertia.negative, 0);
    }
}

fn supports_again(supports: &[Supported]) -> Vec<Supported> {
    let normals = [X, Vec3::new(0.0, 0.0, -1.0), Y, Y];
    let again =
        |(one, normal): (&Supported, Vec3)| supported(one.particles.clone(), SymmetryPlane { normal });
    supports.iter().zip(normals).map(again).collect()
}

/// `ρ t ω² = E t/((1 − ν²) R²) + 2 κ p_a/R` of a tube that breathes, full of a gas of the pressure outside.
#[test]
fn a_tube_breathes_faster_on_gas() {
    // Thick enough for no bending wave of nearly the same frequency to mix in.
    let (thickness, radius) = (0.2, 3.0);
    let ring = YOUNG * thickness / ((1.0 - POISSON * POISSON) * radius * radius);
    let ambient = 0.5 * ring * radius;
    let (cloud, supports) = tube([13, 4], FRAC_PI_2, Vec3::zeros());
    let found = [1.0, 0.0].map(|share| {
        let content = Content::Gas { pressure: 0.0, ambient: share * ambient, exponent: 1.4 };
        let shell = enclosing(cloud.clone(), thickness, supports_again(&supports), content, 0.0).unwrap();
        let mass = shell.reference().masses.iter().sum::<f64>() / (3.0 * FRAC_PI_2);
        let exact = (ring + share * 2.0 * 1.4 * ambient / radius) / mass;
        let mut system = StaticShell::new(shell);
        let modes = natural_modes(&mut system, 0.0, 9, exact * 1.001, &mut unwatched).unwrap().modes;
        // The one that changes the volume most.
        let along = system.beside_pattern(0.0).remove(0).along;
        let change = |mode: &Mode| along.iter().zip(&mode.shape).map(|(g, q)| g * q).sum::<f64>().abs();
        let breathing = modes.iter().max_by(|a, b| change(a).total_cmp(&change(b))).unwrap();
        (breathing.eigenvalue, breathing.eigenvalue / exact - 1.0)
    });
    println!("with gas and without: {found:?}");
    // The same polygon, and masses at its corners: .5 and .2 %.
    assert!(found.iter().all(|(_, miss)| miss.abs() < 0.016), "{found:?}");
    assert!(found[0].0 > 2.0 * found[1].0);
}

/// A gas as a preload is pumped in first and then held: a box pushed together afterwards presses it further, as one whose whole course is known
/// in another order; and relaxation finds what Newton's method finds.
#[test]
fn preloads_orders_and_relaxation_agree() {
    let cloud = || Sheets::boxed(Vec3::new(2.0, 3.0, 1.5), [3, 4, 2]).cloud();
    let cells = || (0..cloud().cells.len() as u32).collect::<Vec<u32>>();
    let gas = || Box::new(Enclosed::new(cells(), GAS, 0.0));
    let outside = || Box::new(Pressure { value: -0.6, follower: true });
    let built = |preloaded: bool| {
        let applied = |load| AppliedLoad { load, amplitude: Amplitude::Constant };
        let gas: Box<dyn sph_shell::Load> = if preloaded { Box::new(Preloaded(gas() as _)) } else { gas() };
        let loads = vec![applied(gas), applied(outside())];
        let held = crate::common::at(&cloud(), |x| x.z == 0.0);
        let parts = parts(cloud(), Formulation::StressPoint(Reach::Cell), 0.1);
        let parts = sph_shell::Parts { loads, supports: vec![supported(held, Clamped)], ..parts };
        StaticShell::new(Shell::builder(parts).build().unwrap())
    };
    let newton = |system: &mut StaticShell, level: f64| {
        Newton::new(system, &NewtonOptions::default()).unwrap().at_level(system, level).unwrap();
    };
    let mut at_once = built(false);
    newton(&mut at_once, 0.5);
    newton(&mut at_once, 1.0);
    at_once.evaluate(1.0);
    let mut first = built(true);
    assert!(first.has_preload());
    first.set_case(sph_shell::LoadCase::Preload);
    newton(&mut first, 1.0);
    first.set_case(sph_shell::LoadCase::Loading);
    newton(&mut first, 1.0);
    first.evaluate(1.0);
    let [one, two] = [&at_once, &first].map(|system| system.shell().enclosed_at(0));
    let miss = (one[0] / two[0] - 1.0).abs().max((one[1] / two[1] - 1.0).abs());
    println!("pressure, volume {one:?}: {miss:.1e} from the preload");
    assert!(miss < 1e-7);
    let mut relaxed = built(false);
    let options = RelaxationOptions { tolerance: 1e-9, ..RelaxationOptions::default() };
    relax(&mut relaxed, &options, (0.0, 1.0), |_| ControlFlow::Continue(())).unwrap();
    relaxed.evaluate(1.0);
    let three = relaxed.shell().enclosed_at(0);
    let miss = (one[0] / three[0] - 1.0).abs();
    println!("{miss:.1e} from relaxation");
    assert!(miss < 1e-6);
    assert!(one[1] > 9.0 && one[0] > 0.6);
}
