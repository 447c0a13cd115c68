//! Layered sections: against the isotropic closed form, rotated axes, coupling, and sums by hand.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{SMatrix, SymmetricEigen};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use shell_kinematics::{
    Isotropic, IsotropicSection, LANES, LayeredSection, MaterialError, Orthotropic, Pack, Ply, Resultants,
    Section, SectionPack, Strains, linear_tangent,
};

type Stiffness = SMatrix<f64, 8, 8>;

/// The whole stiffness over membrane 11, 22, 12, curvature 11, 22, 12, shear 1, 2.
fn stiffness(section: &dyn Section) -> Stiffness {
    let tangent = section.tangent(&Strains::default());
    Stiffness::from_fn(|i, j| tangent[i][j].lanes()[0])
}

fn stack(plies: &[(Orthotropic, f64, f64)]) -> LayeredSection {
    let plies: Vec<Ply> =
        plies.iter().map(|&(material, thickness, angle)| Ply { material, thickness, angle }).collect();
    LayeredSection::new(&plies).unwrap()
}

/// The ply of the laminated roofs of \[sze2004\], §3.8.
fn roof() -> Orthotropic {
    Orthotropic::new(3300.0, 1100.0, 0.25, 660.0, 500.0).unwrap()
}

fn coupling(section: &LayeredSection) -> f64 {
    stiffness(section).fixed_view::<3, 3>(0, 3).abs().max()
}

prop_compose! {
    fn material()(
        along in 1.0..100.0_f64,
        across in 1.0..100.0_f64,
        share in -0.95..0.95_f64,
        shear in 0.1..50.0_f64,
        shear_across in 0.1..50.0_f64,
    ) -> Orthotropic {
        Orthotropic::new(along, across, share * (along / across).sqrt(), shear, shear_across).unwrap()
    }
}

fn laminate() -> impl Strategy<Value = Vec<(Orthotropic, f64, f64)>> {
    prop::collection::vec((material(), 0.1..1.0_f64, -7.0..7.0_f64), 1..6)
}

proptest! {
    // The same cases on every run.
    #![proptest_config(ProptestConfig {
        cases: 256,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(20261120),
        ..ProptestConfig::default()
    })]

    /// Isotropic constants: neither angles nor the split into plies matter, and all scales are the closed ones.
    #[test]
    fn isotropic_plies_are_the_isotropic_section(
        young in 1.0..1000.0_f64,
        poisson in -0.9..0.49_f64,
        plies in prop::collection::vec((0.01..1.0_f64, -7.0..7.0_f64), 1..8),
    ) {
        let isotropic = Isotropic::new(young, poisson).unwrap();
        let g = isotropic.shear();
        let same = Orthotropic::new(young, young, poisson, g, g).unwrap();
        let thickness: f64 = plies.iter().map(|ply| ply.0).sum();
        let layered = stack(&plies.iter().map(|&(t, angle)| (same, t, angle)).collect::<Vec<_>>());
        let closed = IsotropicSection::new(isotropic, thickness).unwrap();
        let (a, b) = (stiffness(&layered), stiffness(&closed));
        // Membrane, coupling and bending have sizes C, C t, C t².
        let size = |i: usize| if (3..6).contains(&i) { thickness } else { 1.0 };
        let c = b[(0, 0)].max(b[(6, 6)]);
        for i in 0..8 {
            for j in 0..8 {
                prop_assert!((a[(i, j)] - b[(i, j)]).abs() < 1e-13 * c * size(i) * size(j), "{i} {j}: {a} {b}");
            }
        }
        let (a, b) = (layered.scales(), closed.scales());
        for (a, b) in [
            (a.thickness, b.thickness), (a.bending, b.bending), (a.shear, b.shear), (a.membrane, b.membrane),
        ] {
            // Bending less its released part: some tens of operations.
            prop_assert!((a / b - 1.0).abs() < 1e-12);
        }
    }

    /// Every strain stores energy, and the stiffness is symmetric.
    #[test]
    fn stiffness_is_positive_definite(plies in laminate()) {
        let c = stiffness(&stack(&plies));
        prop_assert!((c - c.transpose()).abs().max() <= 1e-15 * c.abs().max());
        let values = SymmetricEigen::new(c).eigenvalues;
        prop_assert!(values.min() > 0.0, "{values}");
    }

    /// Rotating every ply rotates the stiffness as a tensor: the energy of rotated strains is the same.
    #[test]
    fn rotated_plies_have_a_rotated_stiffness(
        plies in laminate(),
        turn in -4.0..4.0_f64,
        strain in prop::array::uniform8(-1.0..1.0_f64),
    ) {
        let rotated_plies: Vec<_> = plies.iter().map(|&(m, t, angle)| (m, t, angle + turn)).collect();
        let (s, c) = libm::sincos(turn);
        // Components of a strain in axes rotated back by `turn`.
        let tensor = |e: &[f64]| {
            [
                c * c * e[0] + s * s * e[1] - s * c * e[2],
                s * s * e[0] + c * c * e[1] + s * c * e[2],
                2.0 * s * c * (e[0] - e[1]) + (c * c - s * s) * e[2],
            ]
        };
        let (e, k) = (tensor(&strain[..3]), tensor(&strain[3..6]));
        let g = [c * strain[6] - s * strain[7], s * strain[6] + c * strain[7]];
        let rotated = [e[0], e[1], e[2], k[0], k[1], k[2], g[0], g[1]];
        let energy = |section: &LayeredSection, s: &[f64; 8]| {
            let s = SMatrix::<f64, 8, 1>::from_row_slice(s);
            (s.transpose() * stiffness(section) * s)[0]
        };
        let (before, after) = (energy(&stack(&plies), &strain), energy(&stack(&rotated_plies), &rotated));
        prop_assert!((after / before - 1.0).abs() < 1e-11, "{before} {after}");
    }

    /// The membrane scale bounds the stiffness that waves of any direction and polarisation meet, closely for one ply.
    #[test]
    fn no_wave_is_faster_than_the_membrane_scale(plies in laminate()) {
        let greatest = |section: &LayeredSection| {
            let a = stiffness(section).fixed_view::<3, 3>(0, 0).into_owned();
            let mut most = 0.0_f64;
            for (i, j) in (0..180).flat_map(|i| (0..180).map(move |j| (i, j))) {
                let (n, m) = (libm::sincos(f64::from(i) * PI / 180.0), libm::sincos(f64::from(j) * PI / 180.0));
                let e = SMatrix::<f64, 3, 1>::new(n.1 * m.1, n.0 * m.0, n.0 * m.1 + n.1 * m.0);
                most = most.max((e.transpose() * a * e)[0]);
            }
            most
        };
        let section = stack(&plies);
        let bound = section.scales().membrane;
        prop_assert!(greatest(&section) <= bound * (1.0 + 1e-12));
        let single = stack(&plies[..1]);
        // Half a degree off the greatest of cos 4θ: 4 θ² · 2 = 6e-4 of it at most.
        prop_assert!(greatest(&single) > single.scales().membrane * (1.0 - 1e-3));
    }
}

#[test]
fn a_quarter_turn_swaps_the_axes() {
    let plies = [(roof(), 0.3, 0.2), (roof(), 0.5, -0.4)];
    let [straight, rotated] =
        [0.0, FRAC_PI_2].map(|by| stiffness(&stack(&plies.map(|(m, t, a)| (m, t, a + by)))));
    // 1 becomes 2, 2 becomes −1: entries with one index 12, or of the shears 1 and 2, change sign.
    let to = [1, 0, 2, 4, 3, 5, 7, 6];
    let sign = [1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0, -1.0];
    for i in 0..8 {
        for j in 0..8 {
            let expected = sign[i] * sign[j] * straight[(i, j)];
            assert!((rotated[(to[i], to[j])] - expected).abs() < 1e-12 * straight.max(), "{i} {j}");
        }
    }
    assert!((straight[(0, 0)] / straight[(1, 1)] - 1.0).abs() > 0.1);
}

#[test]
fn unsymmetric_stacks_couple_and_symmetric_ones_do_not() {
    let t = 12.7 / 3.0;
    let scale = 3300.0 * t * t;
    assert!(coupling(&stack(&[(roof(), t, 0.0), (roof(), t, FRAC_PI_2), (roof(), t, 0.0)])) < 1e-13 * scale);
    assert!(coupling(&stack(&[(roof(), t, 0.7), (roof(), t, 0.0), (roof(), t, 0.7)])) < 1e-13 * scale);
    let cross = stiffness(&stack(&[(roof(), t, 0.0), (roof(), t, FRAC_PI_2)]));
    // 0/90 couples stretch with bending along each axis, with opposite signs, and nothing else.
    assert!(cross[(0, 3)] < -0.1 * scale && (cross[(0, 3)] + cross[(1, 4)]).abs() < 1e-12 * scale);
    assert!(cross[(0, 4)].abs() < 1e-12 * scale && cross[(2, 5)].abs() < 1e-12 * scale);
    // +45/−45 couples stretch with twist.
    let angle = stiffness(&stack(&[(roof(), t, 0.25 * PI), (roof(), t, -0.25 * PI)]));
    assert!(angle[(0, 5)].abs() > 0.1 * scale && angle[(0, 3)].abs() < 1e-12 * scale);
}

#[test]
fn two_plies_by_hand() {
    // E_L = 16, E_T = 4, ν = ½: Q11 = 16/(1 − ¼·¼) = 256/15, Q22 = 64/15, Q12 = 32/15; G_LT = 3, G_TT = 1.
    // Plies of 1 and 2 at 0° and 90°: ζ from −3/2 over −1/2 to 3/2, so
    // ∫1 = 1, 2;  ∫ζ = −1, 1;  ∫ζ² = (27 − 1)/24 = 13/12, (27 + 1)/24 = 7/6.
    let material = Orthotropic::new(16.0, 4.0, 0.5, 3.0, 1.0).unwrap();
    let c = stiffness(&stack(&[(material, 1.0, 0.0), (material, 2.0, FRAC_PI_2)]));
    let [q11, q22, q12] = [256.0 / 15.0, 64.0 / 15.0, 32.0 / 15.0];
    let mut expected = Stiffness::zeros();
    for (row, column, lower, upper) in [(0, 0, 1.0, 2.0), (0, 3, -1.0, 1.0), (3, 3, 13.0 / 12.0, 7.0 / 6.0)] {
        let mut put = |i: usize, j: usize, value: f64| {
            expected[(row + i, column + j)] = value;
            expected[(column + j, row + i)] = value;
        };
        put(0, 0, q11 * lower + q22 * upper);
        put(1, 1, q22 * lower + q11 * upper);
        put(0, 1, q12 * (lower + upper));
        put(1, 0, q12 * (lower + upper));
        put(2, 2, 3.0 * (lower + upper));
    }
    // Along 1: G_LT over the lower ply and G_TT over the upper one; along 2 the other way round.
    expected[(6, 6)] = 5.0 / 6.0 * (3.0 + 2.0);
    expected[(7, 7)] = 5.0 / 6.0 * (1.0 + 6.0);
    assert!((c - expected).abs().max() < 1e-13 * 60.0, "{c} {expected}");
}

#[test]
fn scales_of_a_coupled_stack_are_released() {
    // By hand for 0/90 with equal plies h and ν = 0, G → whatever: B = diag(−b, b), A = diag(a, a), D = diag(d, d) over
    // 11 and 22 with a = (E_L+E_T)h, b = (E_L−E_T)h²/2, d = (E_L+E_T)h³/3; released D − b²/a; D66 = G(2h)³/12.
    let (h, along, across, g) = (0.5, 40.0, 2.0, 3.0);
    let material = Orthotropic::new(along, across, 0.0, g, 1.0).unwrap();
    let scales = stack(&[(material, h, 0.0), (material, h, FRAC_PI_2)]).scales();
    let a = (along + across) * h;
    let b = 0.5 * (along - across) * h * h;
    let d = (along + across) * h * h * h / 3.0 - b * b / a;
    let expected = (6.0 * d + 4.0 * g * 8.0 * h * h * h / 12.0) / 8.0;
    assert!((scales.bending / expected - 1.0).abs() < 1e-13);
    assert!((scales.shear / (5.0 / 6.0 * 2.0 * h * 2.0) - 1.0).abs() < 1e-14);
    assert!((scales.membrane / (along * 2.0 * h) - 1.0).abs() < 1e-14);
}

#[test]
fn what_is_out_of_bounds_is_named() {
    let modulus = |error: MaterialError| matches!(error, MaterialError::Modulus { .. });
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(modulus(Orthotropic::new(bad, 1.0, 0.0, 1.0, 1.0).unwrap_err()));
        assert!(modulus(Orthotropic::new(1.0, bad, 0.0, 1.0, 1.0).unwrap_err()));
        assert!(modulus(Orthotropic::new(1.0, 1.0, 0.0, bad, 1.0).unwrap_err()));
        assert!(modulus(Orthotropic::new(1.0, 1.0, 0.0, 1.0, bad).unwrap_err()));
        assert!(LayeredSection::new(&[Ply { material: roof(), thickness: bad, angle: 0.0 }]).is_err());
    }
    let bound = MaterialError::MajorPoisson { value: 2.0, bound: 2.0 };
    assert_eq!(Orthotropic::new(4.0, 1.0, 2.0, 1.0, 1.0).unwrap_err(), bound);
    assert!(Orthotropic::new(4.0, 1.0, f64::NAN, 1.0, 1.0).is_err());
    assert!(Orthotropic::new(4.0, 1.0, -1.99, 1.0, 1.0).is_ok());
    assert_eq!(LayeredSection::new(&[]).unwrap_err(), MaterialError::NoPlies);
    let askew = Ply { material: roof(), thickness: 1.0, angle: f64::INFINITY };
    assert_eq!(LayeredSection::new(&[askew]).unwrap_err(), MaterialError::Angle(f64::INFINITY));
}

#[test]
fn sections_side_by_side_are_those_alone() {
    let isotropic = IsotropicSection::new(Isotropic::new(210.0, 0.3).unwrap(), 0.4).unwrap();
    let plies = stack(&[(roof(), 0.1, 0.3), (roof(), 0.2, -1.1)]);
    let heights = [0.0, 0.7, 0.0, -0.3];
    let sections: [&dyn Section; LANES] = [&isotropic, &isotropic, &plies, &plies];
    let pack = SectionPack::new(sections, heights);
    let p: [Pack; 8] = std::array::from_fn(|i| Pack::splat(0.3 - 0.1 * i as f64));
    let strains =
        Strains { membrane: [p[0], p[1], p[2]], curvature: [p[3], p[4], p[5]], shear: [p[6], p[7]] };
    let list = |r: &Resultants| [&r.membrane[..], &r.moment, &r.shear].concat();
    let found = list(&pack.resultants(&strains));
    for (lane, (section, height)) in sections.into_iter().zip(heights).enumerate() {
        // Strained at its own middle, its membrane force on its arm.
        let mut there = strains;
        (0..3).for_each(|i| there.membrane[i] += there.curvature[i] * height);
        let mut alone = section.resultants(&there);
        (0..3).for_each(|i| alone.moment[i] += alone.membrane[i] * height);
        for (a, b) in found.iter().zip(list(&alone)) {
            let [a, b] = [a.lanes()[lane], b.lanes()[lane]];
            assert!((a - b).abs() < 1e-12 * (1.0 + b.abs()), "lane {lane}: {a} {b}");
        }
        let energy = [pack.energy(&strains), section.energy(&there)].map(|e| e.lanes()[lane]);
        assert!((energy[0] / energy[1] - 1.0).abs() < 1e-12);
    }
    // The tangent is symmetric, and its columns are the answers to unit strains.
    let (tangent, columns) = (pack.tangent(&strains), linear_tangent(&pack));
    for (row, own) in tangent.iter().zip(&columns) {
        for (a, b) in row.iter().zip(own) {
            assert!((0..LANES).all(|lane| (a.lanes()[lane] - b.lanes()[lane]).abs() < 1e-12));
        }
    }
}
