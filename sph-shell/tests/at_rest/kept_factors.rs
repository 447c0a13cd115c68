//! What kept factors cost in iterations and save in factorisations: the slit annulus lifted along its lip, the semi-cylinder under a point force.

use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::ControlFlow;

use crate::common::{self, supported};
use explicit_dynamics::Amplitude;
use implicit_statics::{Control, Effort, Newton, NewtonOptions, PathOptions, Start};
use shell_kinematics::{Isotropic, IsotropicSection};
use sph_core::{Cylinder, EndWeights, Parametric, Side, Vec3, lattice};
use sph_shell::{
    AppliedLoad, Clamped, Force, Formulation, Load, Parts, Reach, Shell, StaticShell, SymmetryPlane,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

/// Radii 6 and 10, thickness .03, E = 21e6, ν = 0, clamped along one lip, lifted along the other by .8 a length.
fn annulus() -> StaticShell {
    let place =
        |radius: f64, angle: f64| Vec3::new(radius * libm::cos(angle), radius * libm::sin(angle), 0.0);
    let patch = Parametric { position: place, range: [[6.0, 10.0], [0.0, 2.0 * PI]] };
    let cloud = lattice(&patch, [7, 31], EndWeights::Trapezoid).unwrap();
    let sides = cloud.sides.clone().unwrap();
    let lip = sides.edge(Side::V1).to_vec();
    let share = |k: usize| if k == 0 || k == lip.len() - 1 { 0.5 } else { 1.0 };
    let shares = lip.iter().enumerate().map(|(k, &a)| (a, share(k))).collect();
    let load: Box<dyn Load> = Box::new(Force { shares, total: Vec3::z() * 3.2 });
    let clamp = supported(sides.edge(Side::V0).to_vec(), Clamped);
    body(cloud, [21e6, 0.0, 0.03], vec![clamp], load)
}

/// Half of a semi-cylinder of radius 1.016 and length 3.048, clamped at one end, its straight edges on planes of symmetry, pushed in at the
/// crown of the other by 2000 in all.
fn semi_cylinder() -> StaticShell {
    let patch = Cylinder { radius: 101.6, angles: [0.0, FRAC_PI_2], length: 304.8 };
    let cloud = lattice(&patch, [17, 17], EndWeights::Trapezoid).unwrap();
    let sides = cloud.sides.clone().unwrap();
    let far = (0..cloud.len()).max_by(|&a, &b| {
        let of = |a: usize| cloud.positions[a].z + cloud.positions[a].y;
        of(a).total_cmp(&of(b))
    });
    let crown = far.unwrap() as u32;
    let n = cloud.frames[crown as usize].n;
    let load: Box<dyn Load> = Box::new(Force { shares: vec![(crown, 1.0)], total: -n * 1000.0 });
    let at = |side| sides.edge(side).to_vec();
    let plane = |side: Side| {
        let first = cloud.frames[sides.edge(side)[0] as usize];
        // The straight edge turns about itself no more: the plane holds the tangent across it.
        let axis = Vec3::y();
        supported(at(side), SymmetryPlane { normal: axis.cross(&first.n) })
    };
    let supports = vec![supported(at(Side::V0), Clamped), plane(Side::U0), plane(Side::U1)];
    body(cloud, [2068.5, 0.3, 3.0], supports, load)
}

fn body(
    cloud: sph_core::Cloud,
    [young, poisson, thickness]: [f64; 3],
    supports: Vec<sph_shell::Supported>,
    load: Box<dyn Load>,
) -> StaticShell {
    let section = IsotropicSection::new(Isotropic::new(young, poisson).unwrap(), thickness).unwrap();
    let loads = vec![AppliedLoad { load, amplitude: Amplitude::Constant }];
    let parts =
        Parts { section: Box::new(section), supports, loads, ..common::parts(cloud, CELL, thickness) };
    StaticShell::new(Shell::builder(parts).build().unwrap())
}

/// Iterations, factorisations and solves of so many equal levels, and the internal energy at the end.
fn counts(mut system: StaticShell, levels: usize, keep: f64) -> (usize, Effort, f64) {
    let newton =
        NewtonOptions { tolerance: 1e-9, iterations: 15, line_search: false, keep, ..Default::default() };
    let mut solver = Newton::new(&system, &newton).unwrap();
    let (mut start, mut iterations, mut effort) = (Start::default(), 0, Effort::default());
    for level in 1..=levels {
        let size = 1.0 / levels as f64;
        let mut options = PathOptions::new(Control::Load { step: size, until: level as f64 * size });
        options.newton = newton.clone();
        let path = solver.follow(&mut system, &start, &options, |point, _| {
            iterations += if point.step > 0 { point.converged.iterations } else { 0 };
            effort.factorisations += point.effort.factorisations;
            effort.solves += point.effort.solves;
            ControlFlow::Continue(())
        });
        path.end.unwrap();
        start = path.restart;
    }
    (iterations, effort, implicit_statics::Equilibrium::energy(&mut system))
}

/// The same equilibria, by kept factors in more iterations and fewer factorisations. With its own factor every iterate converges as Newton's
/// method does, by one solve each: what the counts have beside is the end of each level, and steps that failed.
#[test]
fn kept_factors_take_more_iterations_and_fewer_factorisations_to_the_same_states() {
    for (name, made, levels) in
        [("annulus", annulus as fn() -> StaticShell, 20), ("semi-cylinder", semi_cylinder, 20)]
    {
        let (kept, own) = (counts(made(), levels, 0.03), counts(made(), levels, 0.0));
        println!("{name}: kept {kept:?}, own {own:?}");
        assert!((kept.2 / own.2 - 1.0).abs() < 1e-7, "{name}: {} {}", kept.2, own.2);
        assert!(kept.0 > own.0 && kept.1.factorisations < own.1.factorisations, "{name}");
    }
}
