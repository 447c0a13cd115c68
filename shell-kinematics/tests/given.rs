//! Sections of given stiffness: those of plies and of one material to the bit, no wave faster than the scale, what is refused.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use std::f64::consts::PI;

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

/// Waves of any direction and polarisation in the plane; of bending and turning, whose mass is ρt³/12, likewise.
#[test]
fn no_wave_is_faster_than_the_membrane_scale() {
    let stiffness = matrices(&askew());
    let scale = GivenSection::new(stiffness, 0.2).unwrap().scales().membrane;
    let greatest = |matrix: &[[f64; 3]; 3]| {
        let mut most = 0.0_f64;
        for (i, j) in (0..180).flat_map(|i| (0..180).map(move |j| (i, j))) {
            let (n, m) = (libm::sincos(f64::from(i) * PI / 180.0), libm::sincos(f64::from(j) * PI / 180.0));
            let e = [n.1 * m.1, n.0 * m.0, n.0 * m.1 + n.1 * m.0];
            let meets: f64 = (0..9).map(|at| e[at / 3] * matrix[at / 3][at % 3] * e[at % 3]).sum();
            most = most.max(meets);
        }
        most
    };
    let fastest = greatest(&stiffness.membrane).max(greatest(&stiffness.bending) * 12.0 / 0.04);
    assert!(fastest <= scale * (1.0 + 1e-12), "{fastest} {scale}");
    // The two waves of the angle need not be greatest in one direction.
    assert!(fastest > 0.9 * scale, "{fastest} {scale}");
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
