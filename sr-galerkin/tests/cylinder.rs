//! A thick cylinder under a pressure from within, in plane strain: Lamé's displacement and pressure for any Poisson's ratio, Hill's pressure as it
//! yields.

mod bodies;

use std::ops::ControlFlow;
use std::sync::Arc;

use bodies::cylinder::{RADII, cylinder, radius, widened};
use bodies::{body, curve};
use implicit_statics::{Control, PathOptions, Start, follow};
use shell_kinematics::Hardening;
use solid_kinematics::{Moduli, Plastic};
use sr_galerkin::{Galerkin, Hardened, PointResult, Volumes};

/// A pressure over Young's modulus that leaves displacements small.
const SMALL: f64 = 1e-6;

/// Lamé: `u = (1 + ν) p a²/(E (b² − a²)) ((1 − 2ν) r + b²/r)`.
fn lame(poisson: f64, r: f64) -> f64 {
    let [a, b] = RADII.map(|r| r * r);
    (1.0 + poisson) * SMALL * a / (b - a) * ((1.0 - 2.0 * poisson) * r + b / r)
}

/// How far off are the displacement of the inner face, and the mean stress of cells at most, which is
/// `⅔(1 + ν) p a²/(b² − a²)` everywhere.
fn errors(across: usize, poisson: f64, volumes: Volumes) -> [f64; 2] {
    let mut parts = cylinder(across);
    parts.material.moduli = Moduli::isotropic(1.0, poisson).expect("moduli");
    parts.volumes = volumes;
    let points = parts.rule.pow(3);
    let mut body = body(parts);
    curve(&mut body, &[SMALL], |_| 0.0);
    let [a, b] = RADII.map(|r| r * r);
    let exact = 2.0 / 3.0 * (1.0 + poisson) * SMALL * a / (b - a);
    let mean = |cell: &[PointResult]| {
        cell.iter().map(|point| point.stress[..3].iter().sum::<f64>()).sum::<f64>() / (3 * points) as f64
    };
    let off = |cell: &[PointResult]| (mean(cell) / exact - 1.0).abs();
    let uneven = body.point_results().chunks(points).map(off).fold(0.0, f64::max);
    [widened(&body, RADII[0]) / lame(poisson, RADII[0]) - 1.0, uneven]
}

/// With points by themselves the cylinder locks as ν goes to one half, and pressures are wrong before displacements are: with four cells .09 and
/// .55 of the displacement are missing at ν = .499 and .4999. By the mean of a cell the error is that of the mesh, .9 to 1.1 % with four cells and a quarter of it with
/// eight, whatever ν; mean stresses of cells, the same everywhere, are even to half a percent: no pattern from cell to cell is free.
#[test]
fn lames_cylinder_whatever_poissons_ratio() {
    for (across, most) in [(4, [0.012, 0.06]), (8, [0.0031, 0.0045])] {
        for poisson in [0.3, 0.49, 0.499, 0.4999] {
            let all = [Volumes::Points, Volumes::Shared, Volumes::Mean].map(|v| errors(across, poisson, v));
            println!("{across} cells, ν = {poisson}: {all:.5?}");
            for [off, uneven] in &all[1..] {
                assert!(off.abs() < most[0] && *uneven < most[1], "{across} {poisson}: {off} {uneven}");
            }
            assert!(
                poisson < 0.499 || all[0][0].abs() > 1.2 * all[2][0].abs(),
                "{across} {poisson}: {all:?}"
            );
        }
    }
}

/// Yield stress over Young's modulus: so little that the radii stay.
const YIELD: f64 = 1e-5;

/// Elastic-plastic radius by the plastic strain of a point, `α = σ_y/3G (c²/r² − 1)`, in the mean of those that have flowed.
fn front(body: &Galerkin, shear: f64) -> f64 {
    let points = body.point_results();
    let flowed = points.iter().zip(body.flowed()).filter(|(_, [alpha, _])| *alpha > 0.0);
    let square = |(point, [alpha, _]): (&PointResult, [f64; 2])| {
        radius(&point.place).powi(2) * (1.0 + 3.0 * shear * alpha / YIELD)
    };
    let all: Vec<f64> = flowed.map(square).collect();
    (all.iter().sum::<f64>() / all.len() as f64).sqrt()
}

/// Pressures and elastic-plastic radii on the way into full flow, and the pressure at its end over Hill's limit.
fn burst(across: usize, poisson: f64) -> (Vec<[f64; 2]>, f64) {
    let mut parts = cylinder(across);
    let moduli = Moduli::isotropic(1.0, poisson).expect("moduli");
    let shear = moduli.shear().expect("isotropic");
    let curve = Arc::new(Hardened(Hardening::linear(YIELD, 0.0).expect("a curve")));
    parts.material.plastic = Some(Plastic::new(&moduli, curve, 0.0).expect("plastic"));
    parts.material.moduli = moduli;
    parts.volumes = Volumes::Mean;
    let mut body = body(parts);
    let mut options =
        PathOptions::new(Control::ArcLength { first: 0.2 * YIELD, range: (-YIELD, 2.0 * YIELD) });
    options.newton.line_search = false;
    let all_through = YIELD / 3.0_f64.sqrt() * RADII[1] / (2.0 * shear);
    let (mut course, mut last) = (Vec::new(), 0.0);
    let path = follow(&mut body, &Start::default(), &options, |point, body| {
        last = point.level();
        if body.flowed().iter().any(|[alpha, _]| *alpha > 0.0) {
            course.push([last, front(body, shear)]);
        }
        if widened(body, RADII[1]) > 2.0 * all_through {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    println!("{:?}, {} points", path.end, path.points.len());
    assert!(path.end.is_ok(), "{:?}", path.end);
    (course, last / (2.0 / 3.0_f64.sqrt() * YIELD * libm::log(RADII[1] / RADII[0])))
}

/// Hill: `p = 2/√3 σ_y (ln c/a + ½ (1 − c²/b²))` where nothing changes its volume, and at c = b whatever ν.
fn hill(c: f64) -> f64 {
    let [a, b] = RADII;
    2.0 / 3.0_f64.sqrt() * YIELD * (libm::log(c / a) + 0.5 * (1.0 - c * c / (b * b)))
}

/// .14 % at most on the way of ν = .499, and .01 % at the limit.
#[test]
fn hills_cylinder_yields_from_within() {
    let (course, limit) = burst(8, 0.499);
    let within = course.iter().filter(|[_, c]| *c < RADII[1]);
    let off: Vec<[f64; 2]> = within.map(|&[p, c]| [c, p / hill(c) - 1.0]).collect();
    println!("limit {limit:.5}, pressure by radius {off:.4?}");
    assert!(off.len() >= 3 && off.iter().all(|[_, off]| off.abs() < 0.004), "{off:?}");
    assert!((limit - 1.0).abs() < 0.0004, "{limit}");
}
