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

/// The fastest wave of any direction over 1/√(ρt): membrane and bending together, of inertia ρt and ρt³/12.
fn fastest(stiffness: &Stiffness, thickness: f64) -> f64 {
    let matrix = |m: &[[f64; 3]; 3]| SMatrix::<f64, 3, 3>::from_fn(|i, j| m[i][j]);
    let [a, b, d] = [&stiffness.membrane, &stiffness.coupling, &stiffness.bending].map(matrix);
    let scale = 12.0_f64.sqrt() / thickness;
    let of_direction = |i: i32| {
        let (n2, n1) = libm::sincos(f64::from(i) * PI / 180.0);
        let strain = SMatrix::<f64, 3, 2>::new(n1, 0.0, 0.0, n2, n2, n1);
        let [a, b, d] = [a, b * scale, d * scale * scale].map(|m| strain.transpose() * m * strain);
        let mut both = SMatrix::<f64, 4, 4>::zeros();
        both.fixed_view_mut::<2, 2>(0, 0).copy_from(&a);
        both.fixed_view_mut::<2, 2>(0, 2).copy_from(&b);
        both.fixed_view_mut::<2, 2>(2, 0).copy_from(&b);
        both.fixed_view_mut::<2, 2>(2, 2).copy_from(&d);
        both.symmetric_eigenvalues().max()
    };
    (0..180).map(of_direction).fold(0.0, f64::max)
}

#[test]
fn no_wave_is_faster_than_the_membrane_scale() {
    let scale = |stiffness: &Stiffness| GivenSection::new(*stiffness, 0.2).unwrap().scales().membrane;
    let plies = matrices(&askew());
    let plain = Stiffness { coupling: [[0.0; 3]; 3], ..plies };
    // The two waves of the angle need not be greatest in one direction, and the norm of B is no more than a bound.
    for (stiffness, near) in [(plain, 0.9), (plies, 0.7)] {
        let [found, bound] = [fastest(&stiffness, 0.2), scale(&stiffness)];
        assert!(found <= bound * (1.0 + 1e-12) && found > near * bound, "{found} {bound}");
    }
    // One sheet about its face: B = At/2, D = At²/3, of which (5 + √21)/2 is the greatest wave over that of A.
    let a = matrices(&IsotropicSection::new(Isotropic::new(70.0, 0.3).unwrap(), 0.2).unwrap()).membrane;
    let times = |by: f64| a.map(|row| row.map(|x| by * x));
    let face =
        Stiffness { membrane: a, coupling: times(0.1), bending: times(0.04 / 3.0), shear: plies.shear };
    let found = fastest(&face, 0.2);
    assert!((found / (a[0][0] * 0.5 * (5.0 + 21.0_f64.sqrt())) - 1.0).abs() < 1e-12, "{found}");
    assert!(found <= scale(&face) * (1.0 + 1e-12));
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
