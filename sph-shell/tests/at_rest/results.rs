//! Strains and resultants at the sampling points: exact on patch fields, and consistent with the energy.

use crate::common::{
    self, AXIS, POISSON, THICKNESS as T, YOUNG, curved, disordered_curved, disordered_flat,
    energy_formulations, flat, free_shell, laminated, shake, shell,
};
use shell_kinematics::GreenLagrange;
use sph_core::{Cloud, CubicSpline, Vec3};
use sph_shell::{Divergence, Formulation, PointResult, Reach, Shell};

fn results(shell: &Shell) -> Vec<PointResult> {
    let mut out = vec![PointResult::default(); shell.reference().operator.points.len()];
    shell.point_results(&mut out);
    out
}

fn clouds() -> [(&'static str, Cloud); 2] {
    [("lattice", flat([8, 7], [1.7, 1.5])), ("disordered", disordered_flat([8, 7], [1.7, 1.5]))]
}

/// A tensor `s11, s22, s12` of the axes in the frame of a point; with `engineering` its last number is 2 s12.
fn rotated(s: [f64; 3], t1: &Vec3, engineering: bool) -> [f64; 3] {
    let (cos, sin) = (t1.x, t1.y);
    let factor = if engineering { 2.0 } else { 1.0 };
    let s12 = s[2] / factor;
    let cross = 2.0 * s12 * sin * cos;
    let (one, two) = (cos * cos, sin * sin);
    [
        s[0] * one + s[1] * two + cross,
        s[0] * two + s[1] * one - cross,
        factor * ((s[1] - s[0]) * sin * cos + s12 * (one - two)),
    ]
}

fn close(found: &[f64], expected: &[f64], bound: f64, what: &str) {
    for (f, e) in found.iter().zip(expected) {
        assert!((f - e).abs() < bound, "{what}: {found:?} against {expected:?}");
    }
}

/// `x = F X`: the Green–Lagrange strain is ½(FᵀF − 1), finite; the plane-stress law gives the forces.
#[test]
fn a_constant_stretch_is_read_exactly() {
    let f = [[1.02, 0.05], [-0.01, 0.97]];
    let column = |a: usize, b: usize| f[0][a] * f[0][b] + f[1][a] * f[1][b];
    let e = [0.5 * (column(0, 0) - 1.0), 0.5 * (column(1, 1) - 1.0), column(0, 1)];
    let c = YOUNG * T / (1.0 - POISSON * POISSON);
    let n = [c * (e[0] + POISSON * e[1]), c * (e[1] + POISSON * e[0]), c * 0.5 * (1.0 - POISSON) * e[2]];
    for (cloud_name, cloud) in clouds() {
        for (name, formulation) in energy_formulations() {
            let mut body = free_shell(cloud.clone(), formulation, T);
            for (a, x) in cloud.positions.iter().enumerate() {
                let to = Vec3::new(f[0][0] * x.x + f[0][1] * x.y, f[1][0] * x.x + f[1][1] * x.y, 0.0);
                body.set_state(a, to, Vec3::z());
            }
            let frames = body.reference().operator.points.clone();
            for (point, result) in frames.iter().zip(results(&body)) {
                let what = format!("{name}, {cloud_name}");
                let t1 = point.frame.t1;
                let (e, n) = (rotated(e, &t1, true), rotated(n, &t1, false));
                // Gradients are exact on linear fields to 1e-10 and better.
                close(&result.membrane, &e, 1e-9, &what);
                close(&result.force, &n, 1e-9 * c, &what);
                close(&result.curvature, &[0.0; 3], 1e-9, &what);
                close(&result.moment, &[0.0; 3], 1e-9 * c, &what);
                close(&result.shear, &[0.0; 2], 1e-9, &what);
                let now = Vec3::new(f[0][0] * t1.x + f[0][1] * t1.y, f[1][0] * t1.x + f[1][1] * t1.y, 0.0);
                close(&result.t1, now.normalize().as_slice(), 1e-9, &what);
            }
        }
    }
}

/// `w = −½(κ11 x² + κ22 y² + κ12 xy)` with its Kirchhoff directors, small: constant moments, no shear.
#[test]
fn a_constant_bending_is_read_exactly() {
    let eps = 1e-6;
    let k = [eps, -0.4 * eps, 0.6 * eps];
    let d = YOUNG * T * T * T / (12.0 * (1.0 - POISSON * POISSON));
    let m = [d * (k[0] + POISSON * k[1]), d * (k[1] + POISSON * k[0]), d * 0.5 * (1.0 - POISSON) * k[2]];
    for (cloud_name, cloud) in clouds() {
        for (name, formulation) in energy_formulations() {
            let mut body = free_shell(cloud.clone(), formulation, T);
            for (a, x) in cloud.positions.iter().enumerate() {
                let w = -0.5 * (k[0] * x.x * x.x + k[1] * x.y * x.y + k[2] * x.x * x.y);
                let turn = Vec3::new(k[0] * x.x + 0.5 * k[2] * x.y, k[1] * x.y + 0.5 * k[2] * x.x, 0.0);
                body.set_state(a, x + Vec3::z() * w, Vec3::z() + turn);
            }
            let frames = body.reference().operator.points.clone();
            for (point, result) in frames.iter().zip(results(&body)) {
                let what = format!("{name}, {cloud_name}");
                let (k, m) = (rotated(k, &point.frame.t1, true), rotated(m, &point.frame.t1, false));
                // Second order: slopes of 2e-6 leave 1e-12 in strains, 1e-12 of a unit in curvatures.
                close(&result.curvature, &k, 1e-5 * eps, &what);
                close(&result.moment, &m, 1e-5 * eps * d, &what);
                close(&result.shear, &[0.0; 2], 1e-5 * eps, &what);
                close(&result.membrane, &[0.0; 3], 1e-11, &what);
            }
        }
    }
}

/// Reading with no control beside it (strong form: energy of its strains alone) gives the whole internal energy.
#[test]
fn the_work_of_the_resultants_is_the_energy() {
    let strong = Formulation::StrongForm {
        smoothing: 1.2,
        viscosity: 1.0,
        divergence: Divergence::Sum,
        kernel: &CubicSpline,
    };
    let triangles = {
        // Triangles have no hourglass, so no control: quadrangles of the lattice cut in halves.
        let lattice = disordered_curved([7, 6]);
        let halves = lattice.cells.iter().flat_map(|cell| {
            let [a, b, c, d] = cell.corners;
            [sph_core::Cell::triangle([a, b, c]), sph_core::Cell::triangle([a, c, d])]
        });
        Cloud::from_cells(lattice.positions.clone(), None, halves.collect()).unwrap()
    };
    let cells = Formulation::StressPoint(Reach::Cell);
    for (name, mut body) in [
        ("strong form", free_shell(curved([7, 6]), strong, T)),
        ("cells, triangles", free_shell(triangles.clone(), cells, T)),
        ("cells, triangles, plies", laminated(triangles, cells, AXIS)),
    ] {
        shake(&mut body, 0.05, 4);
        let whole = common::energy(&mut body);
        let read = half_the_work(&body);
        assert!((read / whole - 1.0).abs() < 1e-12, "{name}: {read} against {whole}");
    }
}

/// The control holds only what the points cannot see: on a constant stretch it holds nothing.
#[test]
fn without_a_pattern_the_control_stores_nothing() {
    for (name, formulation) in energy_formulations() {
        let cloud = flat([6, 5], [1.0, 0.8]);
        let mut body = shell(cloud.clone(), formulation, T, &GreenLagrange, Vec::new(), Vec::new());
        for (a, x) in cloud.positions.iter().enumerate() {
            body.set_state(a, Vec3::new(1.03 * x.x, 0.99 * x.y, 0.0), Vec3::z());
        }
        let whole = common::energy(&mut body);
        let read = half_the_work(&body);
        assert!((read / whole - 1.0).abs() < 1e-9, "{name}: {read} against {whole}");
    }
}

fn half_the_work(body: &Shell) -> f64 {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let points = body.reference().operator.points.iter().zip(results(body));
    points
        .map(|(point, r)| {
            let work = dot(&r.force, &r.membrane) + dot(&r.moment, &r.curvature);
            0.5 * point.weight * (work + dot(&r.shear_force, &r.shear))
        })
        .sum()
}

/// Shaken cells: the sum over the points falls short of the internal energy by the control's, which is positive.
#[test]
fn the_control_makes_up_the_rest() {
    for (name, formulation) in energy_formulations() {
        let mut body = free_shell(curved([7, 6]), formulation, T);
        shake(&mut body, 0.05, 8);
        let whole = common::energy(&mut body);
        let read = half_the_work(&body);
        assert!(read > 0.0 && read < whole, "{name}: {read} of {whole}");
    }
}
