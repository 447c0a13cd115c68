//! Frames of sheets that meet along lines: closed forms of beams, large rotations, limit and buckling loads.

use crate::common::{
    self, Sheets, X, Y, Z, at, beam_parts, folded, line, linear_energy, shell, supported, tee,
};
use explicit_dynamics::Amplitude;
use implicit_statics::{BucklingOptions, Newton, NewtonOptions, linear_buckling, unwatched};
use shell_kinematics::StretchCorrected;
use sph_core::{Cloud, Vec3};
use sph_shell::{
    Clamped, CoupleAxis, EdgeCouple, Force, Formulation, Held, Hinged, Reach, Rotated, Shell, StaticShell,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

/// Energy of an L of two legs of length one, clamped at one end, under a unit force across the far leg: bending, axial force
/// and shear of beams in series, `M = s cos φ + 1` on the near leg and `s` on the far one.
fn beam_energy_of_fold(fold: f64, thickness: f64, wide: f64) -> f64 {
    let (sin, cos) = libm::sincos(fold);
    let bending = 12.0 / (common::YOUNG * thickness.powi(3) * wide);
    let axial = 1.0 / (common::YOUNG * thickness * wide);
    let shear = 1.0 / (5.0 / 6.0 * 0.5 * common::YOUNG * thickness * wide);
    let near = cos * cos / 3.0 + cos + 1.0;
    0.5 * (bending * (near + 1.0 / 3.0) + axial * sin * sin + shear * (cos * cos + 1.0))
}

/// Error of the energy of that L with so many cells a leg.
fn error_of_fold(fold: f64, n: usize, thickness: f64) -> f64 {
    let wide = 0.3;
    let cloud = folded(fold, n, wide, 1);
    let tip = X + X * libm::cos(fold) + Z * libm::sin(fold);
    let end = at(&cloud, |x| libm::hypot(x.x - tip.x, x.z - tip.z) < 1e-9);
    let across = -X * libm::sin(fold) + Z * libm::cos(fold);
    let force = Force { shares: line(&cloud, &end), total: across };
    let clamp = supported(at(&cloud, |x| libm::hypot(x.x, x.z) < 1e-9), Clamped);
    let body =
        Shell::builder(beam_parts(cloud, thickness, vec![clamp], vec![Box::new(force)])).build().unwrap();
    linear_energy(body) / beam_energy_of_fold(fold, thickness, wide) - 1.0
}

#[test]
fn frames_of_two_legs_are_as_right_as_a_straight_strip() {
    // One point a cell integrates M² by the midpoint rule: −1/4n² of a leg under a force, nothing under a couple.
    for (n, bound) in [(5, 2.6e-3), (10, 6.5e-4), (20, 1.7e-4), (40, 5e-5)] {
        let error = error_of_fold(90_f64.to_radians(), n, 0.01);
        println!("90°, {n} cells a leg: {:.4} %", 100.0 * error);
        assert!(error.abs() < bound, "{n}: {error:.2e}");
    }
    for degrees in [1.0, 5.0, 20.0, 45.0, 60.0, 120.0, 150.0, 170.0_f64] {
        for (n, bound) in [(5, 1e-2), (10, 2.5e-3), (20, 6.5e-4)] {
            let error = error_of_fold(degrees.to_radians(), n, 0.01);
            println!("{degrees}°, {n} cells a leg: {:.3} %", 100.0 * error);
            assert!(error.abs() < bound, "{degrees}° {n}: {error:.2e}");
        }
    }
}

#[test]
fn a_stem_on_a_bar_sways_as_beams_say() {
    let (thickness, wide) = (0.01_f64, 0.3);
    let ei = common::YOUNG * thickness.powi(3) * wide / 12.0;
    let (ea, ga) = (common::YOUNG * thickness * wide, 5.0 / 12.0 * common::YOUNG * thickness * wide);
    // Each half of the bar bears half the couple of the joint, its joint held in the middle.
    let couple = 0.5;
    let hold = couple * 0.5 / ei / (1.0 / (3.0 * ei) + 1.0 / ga);
    let turn = couple / ei - hold * 0.5 / ei;
    let exact = 0.5 * (1.0 / (3.0 * ei) + 1.0 / ga + turn + 0.5 / ea);
    for (n, bound) in [(5, 1.6e-2), (10, 4e-3), (20, 1e-3), (40, 3e-4)] {
        let cloud = tee(n, wide, 1);
        let tip = at(&cloud, |x| x.z > 1.0 - 1e-9);
        let force = Force { shares: line(&cloud, &tip), total: X };
        let clamp = supported(at(&cloud, |x| x.x.abs() > 1.0 - 1e-9), Clamped);
        let body =
            Shell::builder(beam_parts(cloud, thickness, vec![clamp], vec![Box::new(force)])).build().unwrap();
        let error = linear_energy(body) / exact - 1.0;
        println!("{n} cells a leg: {:.4} %", 100.0 * error);
        assert!(error.abs() < bound, "{n}: {error:.2e}");
    }
}

/// Places of the joint and the tip of a strip of two legs after its end was rolled by `2 φ`.
fn rolled(cloud: Cloud, end: Vec<u32>, probe: [Vec3; 2], turn: f64) -> [Vec3; 2] {
    let near = |place: Vec3| at(&cloud, |x| (x - place).norm() < 1e-9)[0] as usize;
    let probe = probe.map(near);
    let thickness: f64 = 0.05;
    let moment = turn * 0.3 * common::YOUNG * thickness.powi(3) / 12.0;
    let edge = line(&cloud, &end);
    let couple = EdgeCouple { edge, moment, axis: CoupleAxis::Fixed(Y) };
    let clamp = supported(at(&cloud, |x| libm::hypot(x.x, x.z) < 1e-9), Clamped);
    let body =
        Shell::builder(beam_parts(cloud, thickness, vec![clamp], vec![Box::new(couple)])).build().unwrap();
    let mut system = StaticShell::new(body);
    let options = NewtonOptions { tolerance: 1e-10, line_search: false, ..NewtonOptions::default() };
    let mut newton = Newton::new(&system, &options).unwrap();
    for step in 1..=48 {
        newton.at_level(&mut system, f64::from(step) / 48.0).unwrap();
    }
    probe.map(|a| system.shell().position(a))
}

#[test]
fn the_joint_of_a_rolled_frame_stands_where_that_of_a_strip_does() {
    for n in [10, 20] {
        let strip = Sheets::default().add(Vec3::zeros(), [X * 2.0, Y * 0.3], [2 * n, 1]).cloud();
        let end = at(&strip, |x| x.x > 2.0 - 1e-9);
        let [straight, tip] = rolled(strip, end, [X, X * 2.0], std::f64::consts::PI);
        let frame = folded(std::f64::consts::FRAC_PI_2, n, 0.3, 1);
        let end = at(&frame, |x| x.z > 1.0 - 1e-9);
        let [joint, corner] = rolled(frame, end, [X, X + Z], std::f64::consts::PI);
        // The far leg starts at a right angle: its chord is the strip's, turned by −90° about y.
        let chord = tip - straight;
        let turned = Vec3::new(-chord.z, chord.y, chord.x);
        let (joint_off, tip_off) = ((joint - straight).norm(), (corner - joint - turned).norm());
        println!("{n} cells a leg: joint {joint_off:.1e}, far leg {tip_off:.1e}");
        assert!(joint_off < 1e-6 && tip_off < 1e-6, "{n}: {joint_off:.1e} {tip_off:.1e}");
    }
}

/// Residuals of the load steps of a strip, straight or folded, clamped at one end and drawn aside at the other.
fn residuals(cloud: Cloud, end: Vec<u32>) -> (Vec<Vec<f64>>, StaticShell) {
    let force = Force { shares: line(&cloud, &end), total: Vec3::new(0.002, 0.004, 0.001) };
    let clamp = supported(at(&cloud, |x| x.x < 1e-9), Clamped);
    let body = shell(cloud, CELL, 0.05, &StretchCorrected, vec![clamp], vec![Box::new(force)]);
    let mut system = StaticShell::new(body);
    let options = NewtonOptions { tolerance: 1e-11, line_search: false, keep: 0.0, ..Default::default() };
    let mut newton = Newton::new(&system, &options).unwrap();
    let levels = [0.25, 0.5, 0.75, 1.0, 1.2].into_iter();
    let found = levels.map(|level| newton.at_level(&mut system, level).unwrap().residuals).collect();
    (found, system)
}

#[test]
fn residuals_fall_on_a_fold_as_on_a_strip() {
    let strip = Sheets::default().add(Vec3::zeros(), [X * 2.0, Y * 0.5], [12, 3]).cloud();
    let end = at(&strip, |x| x.x > 2.0 - 1e-9);
    let (straight, _) = residuals(strip, end);
    let fold = folded(std::f64::consts::FRAC_PI_2, 6, 0.5, 3);
    let end = at(&fold, |x| x.z > 1.0 - 1e-9);
    let (folded, system) = residuals(fold, end);
    let joint = at(&system.shell().reference().cloud, |x| (x - X).norm() < 1e-9)[0] as usize;
    let turn = system.shell().director(joint).angle(&Z).to_degrees();
    println!("joint turned by {turn:.0}°: {folded:?}");
    assert!(turn > 15.0);
    for (straight, folded) in straight.iter().zip(&folded) {
        assert!(folded.len() <= straight.len() + 1, "{straight:?} {folded:?}");
        // The last three above round-off: quadratic where linear convergence would leave the same digits each time.
        let [.., a, b, c, _] = folded[..] else { panic!("{folded:?}") };
        assert!(c < 1e-2 * b && b < 0.1 * a, "{folded:?}");
    }
}

#[test]
fn an_end_turned_by_its_support_carries_the_joint_and_needs_the_couple_of_a_beam() {
    // The joint itself is turned: by π/3 about the fold, while the far end of the near leg is clamped.
    let cloud = folded(std::f64::consts::FRAC_PI_2, 8, 0.3, 1);
    let joint = at(&cloud, |x| x.x > 1.0 - 1e-9 && x.z < 1e-9);
    let angle = std::f64::consts::FRAC_PI_3;
    let supports = vec![
        supported(at(&cloud, |x| x.x < 1e-9), Clamped),
        supported(joint.clone(), Rotated { axis: Y, by: angle, amplitude: Amplitude::Constant }),
    ];
    let thickness: f64 = 0.02;
    let body = Shell::builder(beam_parts(cloud, thickness, supports, Vec::new())).build().unwrap();
    let mut system = StaticShell::new(body);
    let mut newton = Newton::new(&system, &NewtonOptions::default()).unwrap();
    for step in 1..=16 {
        newton.at_level(&mut system, f64::from(step) / 16.0).unwrap();
    }
    system.evaluate(1.0);
    let shell = system.shell();
    let moment: f64 = joint.iter().map(|&a| shell.reaction_moment(a as usize).y).sum();
    let beam = angle * 0.3 * common::YOUNG * thickness.powi(3) / 12.0;
    // The strip bends to an arc: M = EI φ/L, exact but for what curvature along arcs leaves.
    println!("couple {:.2e} of the beam's", moment / beam - 1.0);
    assert!((moment / beam - 1.0).abs() < 1e-4, "{moment} {beam}");
    // The free leg goes along without bending, at a right angle to the joint.
    let tip = at(&shell.reference().cloud, |x| x.z > 1.0 - 1e-9)[0] as usize;
    let [d, e] = [shell.director(joint[0] as usize), shell.director(tip)];
    assert!(d.dot(&e).abs() < 1e-9, "{}", d.dot(&e));
}

/// A column on a hinge whose head is held in place and turned by a beam of the same section, clamped at its far end: with
/// u = L√(P/EI) and the beam's stiffness 4EI/L, `tan u = 4u/(4 + u²)`.
#[test]
fn a_column_held_by_a_beam_buckles_as_slope_deflection_says() {
    let (thickness, wide) = (0.01_f64, 0.05);
    let ei = common::YOUNG * thickness.powi(3) * wide / 12.0;
    let lack = |u: f64| libm::tan(u) - 4.0 * u / (4.0 + u * u);
    let (mut low, mut high) = (std::f64::consts::PI, 4.49);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        *(if lack(middle) < 0.0 { &mut low } else { &mut high }) = middle;
    }
    let exact = low * low * ei;
    // A cell finds the arc of a sine (kΔ)²/12 too stiff, and less beside the joint: second order.
    for (n, bound) in [(10, 3.5e-2), (20, 9e-3)] {
        let cloud =
            Sheets::default().add(Vec3::zeros(), [Z, Y * wide], [n, 1]).add(Z, [X, Y * wide], [n, 1]).cloud();
        let foot = at(&cloud, |x| x.z < 1e-9);
        let head = at(&cloud, |x| x.x < 1e-9 && x.z > 1.0 - 1e-9);
        let far = at(&cloud, |x| x.x > 1.0 - 1e-9);
        let all = (0..cloud.len() as u32).collect();
        let shares = line(&cloud, &head).into_iter().step_by(2).map(|(a, _)| (a, 1.0)).collect();
        let supports = vec![
            supported(foot, Hinged),
            supported(head, Held { displacement: vec![X], director: None }),
            supported(far, Clamped),
            supported(all, Held { displacement: vec![Y], director: Some(Y) }),
        ];
        let force = Force { shares, total: -Z * exact };
        let body =
            Shell::builder(beam_parts(cloud, thickness, supports, vec![Box::new(force)])).build().unwrap();
        let mut system = StaticShell::new(body);
        let found = linear_buckling(&mut system, 0.0, &BucklingOptions::new(1), &mut unwatched).unwrap();
        let level = found.modes[0].level;
        println!("{n} cells a leg: {:.3} % above", 100.0 * (level - 1.0));
        assert!((level - 1.0).abs() < bound, "{n}: {level}");
    }
}
