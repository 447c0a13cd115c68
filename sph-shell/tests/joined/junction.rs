//! Sheets that meet along a line: derivatives of the energy, zero modes, degrees of freedom, refusals.

use crate::common::{
    self, RandomNumbers, Sheets, X, Y, Z, alone, at, derivatives_along, folded, free_shell, parts,
    shake_unknowns, shell, spectrum, supported, tee,
};
use implicit_statics::Equilibrium;
use shell_kinematics::StretchCorrected;
use sph_core::{Cloud, Vec3};
use sph_shell::{
    Clamped, Formulation, Held, Reach, Shell, ShellError, StaticShell, Supported, SymmetryPlane,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

/// A box of square section one and some length along y with diaphragms at both ends and in the middle.
fn closed_box(n: usize, length: f64, along: usize) -> Cloud {
    let wall = [n, along];
    let mut sheets = Sheets::default()
        .add(Vec3::zeros(), [X, Y * length], wall)
        .add(Z, [X, Y * length], wall)
        .add(Vec3::zeros(), [Z, Y * length], wall)
        .add(X, [Z, Y * length], wall);
    for part in [0.0, 0.5, 1.0] {
        sheets = sheets.add(Y * (part * length), [X, Z], [n, n]);
    }
    sheets.cloud()
}

/// Turns everything by a rotation vector as a whole, then moves all unknowns at random: groups stay groups.
#[test]
fn forces_and_tangent_are_derivatives_of_the_energy_at_a_turned_state() {
    for (name, cloud) in [("fold", folded(1.2, 3, 0.8, 2)), ("tee", tee(2, 1.0, 2))] {
        let supports = vec![
            supported(at(&cloud, |x| x.x < cloud.positions[0].x + 1e-9), Clamped),
            supported(at(&cloud, |x| x.y < 1e-9), SymmetryPlane { normal: Y }),
        ];
        let body = shell(cloud, CELL, 0.2, &StretchCorrected, supports, Vec::new());
        let mut system = StaticShell::new(body);
        // Twice, so that directors are far from rest and forces run along them.
        shake_unknowns(&mut system, 0.1, 3);
        shake_unknowns(&mut system, 0.1, 4);
        let n = system.unknowns();
        let mut dice = RandomNumbers(7);
        // All unknowns at once, and those of groups, which turn about three axes, alone.
        let turning = (0..n).filter(|&i| system.name_unknown(i).contains("junction turning"));
        let turning: Vec<usize> = turning.collect();
        assert!(turning.len() >= 6, "{name}: {}", turning.len());
        let random: Vec<f64> = (0..n).map(|_| dice.roll()).collect();
        let both = |i: usize| {
            let mut v = vec![0.0; n];
            (v[turning[i - 1]], v[turning[i]]) = (1.0, 0.7);
            v
        };
        let ways = std::iter::once(random).chain(turning.iter().map(|&i| alone(i, n)));
        for v in ways.chain((1..turning.len()).map(both)) {
            derivatives_along(&mut system, 0.0, &v, 2e-4, [1e-8, 1e-6], name);
        }
    }
}

#[test]
fn free_frames_have_exactly_six_zero_modes() {
    for (name, cloud, thickness) in [
        ("tee", tee(4, 1.0, 4), 0.1),
        ("thin tee", tee(4, 1.0, 4), 0.02),
        ("box of one cell a side", closed_box(1, 2.0, 2), 0.1),
        ("thin box", closed_box(2, 2.0, 4), 0.01),
        ("fold of 5°", folded(5_f64.to_radians(), 4, 1.0, 4), 0.02),
        ("fold of 170°", folded(170_f64.to_radians(), 4, 1.0, 4), 0.02),
    ] {
        let values = spectrum(free_shell(cloud, CELL, thickness));
        let (sixth, seventh) = (values[5].abs(), values[6]);
        println!("{name}: {sixth:.1e} | {seventh:.3e} {:.3e}", values[7]);
        assert!(seventh > 1e3 * sixth && seventh > 0.0, "{name}: {sixth:.1e} {seventh:.1e}");
    }
}

/// Two halves of a plate at 1° vibrate as the plate does: the spin about the normal has an inertia as small as its stiffness.
#[test]
fn a_flat_fold_has_the_modes_of_a_plate() {
    let modes =
        |body: Shell| -> Vec<f64> { spectrum(body)[6..12].iter().map(|square| square.sqrt()).collect() };
    let plate = Sheets::default().add(Vec3::zeros(), [X * 2.0, Y], [16, 8]).cloud();
    let plate = modes(free_shell(plate, CELL, 0.05));
    let fold = modes(free_shell(folded(1_f64.to_radians(), 8, 1.0, 8), CELL, 0.05));
    println!("{plate:.3?} {fold:.3?}");
    for (plate, fold) in plate.iter().zip(&fold) {
        // Twist loses 1.2 % at most: a group does not feel the spin of cells, so that a layer beside the fold bears no twisting moment.
        assert!((fold / plate - 1.0).abs() < 3e-2, "{plate} {fold}");
    }
}

#[test]
fn particles_that_cannot_be_tied_are_refused() {
    let parallel = Sheets::default().add(Vec3::zeros(), [X, Y], [2, 2]).add(X, [X, Y], [2, 2]).cloud();
    let refused = Shell::builder(parts(parallel, CELL, 0.1)).build().err().unwrap();
    assert!(matches!(refused, ShellError::ParallelDirectors { .. }), "{refused}");
    let wide = common::energy_formulations()[2].1;
    let refused = Shell::builder(parts(folded(1.0, 2, 1.0, 2), wide, 0.1)).build().err().unwrap();
    assert!(matches!(refused, ShellError::JunctionOfWideStencils), "{refused}");
}

/// Six unknowns a group, less what is held: directions held on one particle are held on all.
#[test]
fn a_group_has_six_degrees_of_freedom_and_one_set_of_supports() {
    let free = free_shell(tee(2, 1.0, 2), CELL, 0.1);
    assert_eq!(free.tied(), (6, 3));
    assert_eq!(free.dof(), 5 * (free.len() - 6) + 18);
    assert_eq!(StaticShell::new(free_shell(tee(2, 1.0, 2), CELL, 0.1)).unknowns(), free.dof());
    let cloud = tee(2, 1.0, 2);
    let joint = at(&cloud, |x| x.x.abs() < 1e-9 && x.z < 1e-9);
    for (support, held) in [
        (Box::new(Clamped) as Box<dyn sph_shell::Support>, 6),
        (Box::new(Held { displacement: vec![X, Z], director: Some(Y) }), 4),
    ] {
        let one = vec![Supported { particles: vec![joint[1]], support }];
        let body = shell(cloud.clone(), CELL, 0.1, &StretchCorrected, one, Vec::new());
        assert_eq!(body.dof(), free.dof() - held);
        assert_eq!(StaticShell::new(body).unknowns(), free.dof() - held);
    }
}
