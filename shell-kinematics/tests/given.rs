//! Sections of given stiffness: those of plies and of one material to the bit, no wave faster than the scale, what is refused.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use std::f64::consts::PI;

use nalgebra::SMatrix;
use shell_kinematics::{
    GivenSection, Isotropic, IsotropicSection, LayeredSection, MaterialError, Orthotropic, Pack, Ply,
    Section, Stiffness, Strains,
};

/// The matrices of a section, from its answers to unit strains.
fn matrices(section: &dyn Section) -> Stiffness {
    let tangent = section.tangent(&Strains::default());
    let at = |i: usize, j: usize| tangent[i][j].lanes()[0];
    let block =
        |row: usize, column: usize| std::array::from_fn(|i| std::array::from_fn(|j| at(row + i, column + j)));
    Stiffness {
        membrane: block(0, 0),
        coupling: block(0, 3),
        bending: block(3, 3),
        shear: std::array::from_fn(|i| std::array::from_fn(|j| at(6 + i, 6 + j))),
    }
}

fn askew() -> LayeredSection {
    let ply = |thickness, angle| Ply {
        material: Orthotropic::new(140.0, 10.0, 0.3, 5.0, 3.0).unwrap(),
        thickness,
        angle,
    };
    LayeredSection::new(&[ply(0.05, 0.0), ply(0.08, 1.1), ply(0.07, -0.6)]).unwrap()
}

/// Every answer of plies without a symmetry is that of their matrices.
#[test]
fn the_matrices_of_plies_give_their_bits() {
    let plies = askew();
    let given = GivenSection::new(matrices(&plies), 0.2).unwrap();
    let numbers = |at: usize| Pack::splat(libm::sin(1.0 + 1.7 * at as f64));
    let strains = Strains {
        membrane: [0, 1, 2].map(numbers),
        curvature: [3, 4, 5].map(numbers),
        shear: [6, 7].map(numbers),
    };
    let [a, b] = [plies.resultants(&strains), given.resultants(&strains)];
    for (a, b) in a
        .membrane
        .iter()
        .chain(&a.moment)
        .chain(&a.shear)
        .zip(b.membrane.iter().chain(&b.moment).chain(&b.shear))
    {
        assert_eq!(a.lanes(), b.lanes());
    }
    assert_eq!(plies.energy(&strains).lanes(), given.energy(&strains).lanes());
    let [a, b] = [plies.scales(), given.scales()];
    assert_eq!([a.thickness, a.bending, a.shear], [b.thickness, b.bending, b.shear]);
}

#[test]
fn one_material_has_its_own_scales() {
    let one = IsotropicSection::new(Isotropic::new(70.0, 0.3).unwrap(), 0.2).unwrap();
    let [a, b] = [one.scales(), GivenSection::new(matrices(&one), 0.2).unwrap().scales()];
    for (a, b) in [(a.membrane, b.membrane), (a.bending, b.bending), (a.shear, b.shear)] {
        assert!((b / a - 1.0).abs() < 1e-14, "{a} {b}");
    }
}

/// The most that a wave of displacements in the surface and turns meets: the greatest eigenvalue over all directions of `EᵀKE`, K the six rows of A, B and
/// D with curvatures in the mass of strains, ρt against ρt³/12, and E the strains and curvatures of motions in two directions and turns in two.
fn fastest(Stiffness { membrane, coupling, bending, .. }: &Stiffness, thickness: f64) -> f64 {
    let turns = 12.0_f64.sqrt() / thickness;
    let whole = SMatrix::<f64, 6, 6>::from_fn(|i, j| match (i < 3, j < 3) {
        (true, true) => membrane[i][j],
        (false, false) => bending[i - 3][j - 3] * turns * turns,
        _ => coupling[i % 3][j % 3] * turns,
    });
    let met = |degree: u32| {
        let (s, c) = libm::sincos(f64::from(degree) * PI / 180.0);
        let strains = SMatrix::<f64, 3, 2>::new(c, 0.0, 0.0, s, s, c);
        let mut all = SMatrix::<f64, 6, 4>::zeros();
        all.fixed_view_mut::<3, 2>(0, 0).copy_from(&strains);
        all.fixed_view_mut::<3, 2>(3, 2).copy_from(&strains);
        (all.transpose() * whole * all).symmetric_eigenvalues().max()
    };
    (0..180).map(met).fold(0.0, f64::max)
}

/// Plies without a symmetry, as they are and coupled less or the other way; a sheet raised by half of its thickness, of which a closed form says what a wave meets.
#[test]
fn no_wave_is_faster_than_the_membrane_scale() {
    let scale = |stiffness: Stiffness| GivenSection::new(stiffness, 0.2).unwrap().scales().membrane;
    let plies = matrices(&askew());
    for factor in [1.0, 0.5, 0.0, -1.0] {
        let mut own = plies;
        own.coupling.as_flattened_mut().iter_mut().for_each(|entry| *entry *= factor);
        let (met, bound) = (fastest(&own, 0.2), scale(own));
        assert!(met <= bound * (1.0 + 1e-12), "{factor}: {met} {bound}");
        // The waves of the angle, and A, B and D, need not be greatest in one direction: .891 of the bound with the whole coupling, .999 with none.
        assert!(met > 0.88 * bound, "{factor}: {met} {bound}");
    }
    // B = At/2 and D = At²/3 of a raised sheet: 1, √3 and 4 of A, which make (5 + √21)/2, not 4.
    let one = matrices(&IsotropicSection::new(Isotropic::new(70.0, 0.3).unwrap(), 0.2).unwrap());
    let times = |factor: f64| one.membrane.map(|row| row.map(|entry| entry * factor));
    let raised = Stiffness { coupling: times(0.1), bending: times(0.04 / 3.0), ..one };
    let exact = one.membrane[0][0] * (5.0 + 21.0_f64.sqrt()) / 2.0;
    for found in [fastest(&raised, 0.2), scale(raised)] {
        assert!((found / exact - 1.0).abs() < 1e-14, "{found} {exact}");
    }
    // A coupling of either sign, which stretches one way and turns the other: its size counts.
    let mut askew = one;
    askew.coupling = [[0.3, 0.0, 0.1], [0.0, -0.3, 0.1], [0.1, 0.1, 0.05]];
    let (met, bound) = (fastest(&askew, 0.2), scale(askew));
    assert!(met <= bound * (1.0 + 1e-12) && met > scale(one), "{met} {bound}");
}

#[test]
fn what_stores_no_energy_is_refused() {
    let good = matrices(&askew());
    let refused = |change: &dyn Fn(&mut Stiffness), thickness: f64| {
        let mut stiffness = good;
        change(&mut stiffness);
        match GivenSection::new(stiffness, thickness).unwrap_err() {
            MaterialError::Stiffness { what, bound } => {
                format!("{what} {}", bound.split(' ').next().unwrap())
            }
            other => other.to_string(),
        }
    };
    assert_eq!(refused(&|s| s.membrane[0][1] *= 1.001, 0.2), "membrane symmetric");
    assert_eq!(refused(&|s| s.coupling[2][1] += 0.1, 0.2), "coupling symmetric");
    assert_eq!(refused(&|s| s.shear[1][0] += 0.1, 0.2), "shear symmetric");
    assert_eq!(refused(&|s| s.bending[1][1] = f64::NAN, 0.2), "bending finite");
    assert_eq!(refused(&|s| s.membrane[2][2] = 0.0, 0.2), "membrane positive");
    assert_eq!(refused(&|s| s.bending[0][0] = -1.0, 0.2), "bending positive");
    assert_eq!(refused(&|s| s.shear = [[1.0, 2.0], [2.0, 1.0]], 0.2), "shear positive");
    // A and D are sound, and some stretch with its curvature would release energy.
    assert_eq!(refused(&|s| s.coupling = [[9.0, 0.0, 0.0], [0.0; 3], [0.0; 3]], 0.2), "coupling so");
    assert!(refused(&|_| (), 0.0).contains("thickness"));
    // What ten printed digits leave is made even.
    let mut printed = good;
    printed.membrane[0][1] *= 1.0 + 1e-10;
    assert!(GivenSection::new(printed, 0.2).is_ok());
}
