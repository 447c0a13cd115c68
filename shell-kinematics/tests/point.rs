//! Strain against transpose, section against energy, rotations against their definitions.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use nalgebra::{Matrix3, Rotation3, Vector3};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use shell_kinematics::{
    GreenLagrange, IntegratedSection, Isotropic, IsotropicSection, LayeredSection, MaterialError, Measures,
    Orthotropic, Pack, Pack3, Placement, Ply, Resultants, Section, StrainMeasure, Strains, StretchCorrected,
    congruence, parallel_transport, strain_measure, strain_measures,
};

mod paper;

use paper::{local_green_lagrange, rodrigues, tangent_map};

/// Measures that are polynomials of the five vectors; the logarithmic one has tests of its own.
const POLYNOMIAL: [&dyn StrainMeasure; 2] = [&StretchCorrected, &GreenLagrange];

type Vectors = [Vector3<f64>; 5];

fn placement(v: &Vectors) -> Placement {
    let pack = |x: &Vector3<f64>| Pack3::splat([x.x, x.y, x.z]);
    Placement { x1: pack(&v[0]), x2: pack(&v[1]), d: pack(&v[2]), d1: pack(&v[3]), d2: pack(&v[4]) }
}

fn first(pack: Pack) -> f64 {
    pack.lanes()[0]
}

fn numbers(s: &Strains) -> [f64; 8] {
    let [e, k, g] = [s.membrane, s.curvature, [s.shear[0], s.shear[1], Pack::ZERO]];
    [e[0], e[1], e[2], k[0], k[1], k[2], g[0], g[1]].map(first)
}

fn resultants(n: &[f64; 8]) -> Resultants {
    let p = n.map(Pack::splat);
    Resultants { membrane: [p[0], p[1], p[2]], moment: [p[3], p[4], p[5]], shear: [p[6], p[7]] }
}

fn vectors() -> impl Strategy<Value = Vectors> {
    let small = || prop::array::uniform3(-0.3..0.3_f64).prop_map(Vector3::from);
    [small(), small(), small(), small(), small()]
        .prop_map(|[a, b, c, d, e]| [a + Vector3::x(), b + Vector3::y(), c + Vector3::z(), d, e])
}

proptest! {
    // The same cases on every run.
    #![proptest_config(ProptestConfig {
        cases: 256,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(20130826),
        ..ProptestConfig::default()
    })]

    /// `stress · δstrain = forces · δvectors` for every measure: the transpose is that of the derivative.
    #[test]
    fn transposes_are_those_of_the_strains(
        now in vectors(),
        reference in vectors(),
        along in vectors(),
        stress in prop::array::uniform8(-1.0..1.0_f64),
    ) {
        let reference = placement(&reference).measures();
        for measure in POLYNOMIAL {
            let at = |s: f64| {
                let moved: Vectors = std::array::from_fn(|i| now[i] + along[i] * s);
                numbers(&measure.strains(&placement(&moved).measures(), &reference))
            };
            // Strains are polynomials of degree four: five points differentiate them exactly.
            let h = 0.1;
            let (a, b, c, d) = (at(h), at(-h), at(2.0 * h), at(-2.0 * h));
            let work: f64 =
                (0..8).map(|i| stress[i] * (8.0 * (a[i] - b[i]) - (c[i] - d[i])) / (12.0 * h)).sum();
            let p = placement(&now);
            let on_measures = measure.transpose(&p.measures(), &reference, &resultants(&stress));
            let f = p.transpose(&on_measures);
            let power: f64 = [f.n1, f.n2, f.q, f.m1, f.m2]
                .iter()
                .zip(&along)
                .map(|(force, v)| Vector3::from(force.lane(0)).dot(v))
                .sum();
            prop_assert!((work - power).abs() < 1e-12 * (1.0 + work.abs()), "{}: {work} {power}", measure.name());
        }
    }

    /// The tangent is the derivative of the forces, for every measure and section.
    #[test]
    fn tangents_are_the_derivatives_of_the_forces(now in vectors(), reference in vectors(), along in vectors()) {
        let reference = placement(&reference).measures();
        for section in sections() {
            for measure in POLYNOMIAL {
                let forces = |s: f64| -> [f64; 15] {
                    let moved: Vectors = std::array::from_fn(|i| now[i] + along[i] * s);
                    let p = placement(&moved);
                    let m = p.measures();
                    let stress = section.resultants(&measure.strains(&m, &reference));
                    let f = p.transpose(&measure.transpose(&m, &reference, &stress));
                    let v = [f.n1, f.n2, f.q, f.m1, f.m2].map(|v| v.lane(0));
                    std::array::from_fn(|i| v[i / 3][i % 3])
                };
                let p = placement(&now);
                let m = p.measures();
                let strains = measure.strains(&m, &reference);
                let stress = section.resultants(&strains);
                let mut over = congruence(&measure.gradient(&m, &reference), &section.tangent(&strains));
                for (row, add) in over.iter_mut().zip(measure.second_gradient(&m, &reference, &stress)) {
                    row.iter_mut().zip(add).for_each(|(value, more)| *value += more);
                }
                let k = p.tangent(&over, &measure.transpose(&m, &reference, &stress));
                let h = 1e-3;
                let (a, b, c, d) = (forces(h), forces(-h), forces(2.0 * h), forces(-2.0 * h));
                for i in 0..15 {
                    let slope = (8.0 * (a[i] - b[i]) - (c[i] - d[i])) / (12.0 * h);
                    let exact: f64 = (0..15).map(|j| first(k[i][j]) * along[j / 3][j % 3]).sum();
                    // Truncation h⁴ = 1e-12 of stiffnesses of some hundred.
                    prop_assert!((slope - exact).abs() < 1e-7, "{}: {slope} {exact}", measure.name());
                }
            }
        }
    }

    /// No strain under a finite rotation of all vectors.
    #[test]
    fn rotations_do_not_strain(now in vectors(), axis in prop::array::uniform3(-3.0..3.0_f64)) {
        let turned = now.map(|v| rodrigues(&Vector3::from(axis)) * v);
        let reference = placement(&now).measures();
        for measure in strain_measures() {
            for value in numbers(&measure.strains(&placement(&turned).measures(), &reference)) {
                // Round-off of products of some units.
                prop_assert!(value.abs() < 1e-13);
            }
        }
    }

    /// Resultants are the derivative of the energy, for every section.
    #[test]
    fn resultants_are_the_derivative_of_the_energy(
        at in prop::array::uniform8(-1.0..1.0_f64),
        along in prop::array::uniform8(-1.0..1.0_f64),
    ) {
        for section in sections() {
            let strains = |s: f64| {
                let p: [Pack; 8] = std::array::from_fn(|i| Pack::splat(at[i] + s * along[i]));
                Strains { membrane: [p[0], p[1], p[2]], curvature: [p[3], p[4], p[5]], shear: [p[6], p[7]] }
            };
            // Quadratic energy: the central difference is exact.
            let slope = first(section.energy(&strains(0.5))) - first(section.energy(&strains(-0.5)));
            let stress = section.resultants(&strains(0.0));
            let mut direction = strains(1.0);
            let base = strains(0.0);
            for i in 0..3 {
                direction.membrane[i] -= base.membrane[i];
                direction.curvature[i] -= base.curvature[i];
            }
            for i in 0..2 {
                direction.shear[i] -= base.shear[i];
            }
            let work = first(stress.work(&direction));
            prop_assert!((slope - work).abs() < 1e-12 * (1.0 + work.abs()));
        }
    }

    /// Rodrigues' formula and nalgebra's rotation agree, near zero and far from it.
    #[test]
    fn rodrigues_is_the_exponential(axis in prop::array::uniform3(-2.0..2.0_f64), scale in -9.0..0.0_f64) {
        let theta = Vector3::from(axis) * libm::pow(10.0_f64, scale);
        let exact = Rotation3::from_scaled_axis(theta);
        prop_assert!((rodrigues(&theta) - exact.matrix()).norm() < 1e-13);
    }

    /// `𝕎` carries the rate of the rotation vector to the spatial angular velocity.
    #[test]
    fn tangent_map_gives_the_angular_velocity(
        axis in prop::array::uniform3(-2.0..2.0_f64),
        rate in prop::array::uniform3(-1.0..1.0_f64),
        scale in -6.0..0.0_f64,
    ) {
        let theta = Vector3::from(axis) * libm::pow(10.0_f64, scale);
        let rate = Vector3::from(rate);
        let h = 1e-4;
        let at = |s: f64| rodrigues(&(theta + rate * s));
        let spin: Matrix3<f64> =
            ((at(h) - at(-h)) * 8.0 - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h) * rodrigues(&theta).transpose();
        let omega = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);
        prop_assert!((tangent_map(&theta) * rate - omega).norm() < 1e-10);
    }

    /// Parallel transport is Rodrigues' update about `d × ḋ`, and the paper's eq. 10 carries its rate.
    #[test]
    fn parallel_transport_is_the_papers_update(
        turn in prop::array::uniform3(-3.0..3.0_f64),
        rate in prop::array::uniform3(-1.0..1.0_f64),
        dt in 1e-6..2.0_f64,
    ) {
        let d = rodrigues(&Vector3::from(turn)) * Vector3::z();
        let rate = Vector3::from(rate);
        let rate = rate - d * d.dot(&rate);
        let omega = d.cross(&rate);
        let step = rodrigues(&(omega * dt));
        let (new_d, new_rate) = parallel_transport(d.into(), rate.into(), dt);
        // Round-off of some tens of operations on numbers of size one.
        prop_assert!((Vector3::from(new_d) - step * d).norm() < 1e-13);
        // 𝕎 leaves a vector along its own axis alone: the angular velocity of a great circle stays.
        let carried = tangent_map(&(omega * dt)) * omega;
        prop_assert!((Vector3::from(new_rate) - carried.cross(&(step * d))).norm() < 1e-13);
    }
}

/// The closed form, five sections that must equal it, and an unsymmetric laminate.
fn sections() -> [Box<dyn Section>; 7] {
    let material = Isotropic::new(210.0, 0.3).unwrap();
    let gauss = |n| Box::new(IntegratedSection::new(material, 0.4, n).unwrap());
    let shear = material.shear();
    let alike = Orthotropic::new(210.0, 210.0, 0.3, shear, shear).unwrap();
    let ply = |material, thickness, angle| Ply { material, thickness, angle };
    let same = [ply(alike, 0.1, 0.0), ply(alike, 0.3, 1.0)];
    let fibre = Orthotropic::new(210.0, 20.0, 0.3, 15.0, 7.0).unwrap();
    let skew = [ply(fibre, 0.1, 0.0), ply(alike, 0.1, 0.0), ply(fibre, 0.2, 0.8)];
    [
        Box::new(IsotropicSection::new(material, 0.4).unwrap()),
        gauss(2),
        gauss(3),
        gauss(4),
        gauss(5),
        Box::new(LayeredSection::new(&same).unwrap()),
        Box::new(LayeredSection::new(&skew).unwrap()),
    ]
}

#[test]
fn sections_of_one_isotropic_material_agree() {
    let p: [Pack; 8] = std::array::from_fn(|i| Pack::splat(0.3 - 0.1 * i as f64));
    let strains =
        Strains { membrane: [p[0], p[1], p[2]], curvature: [p[3], p[4], p[5]], shear: [p[6], p[7]] };
    let [closed, rest @ .., _] = sections();
    for section in rest {
        let (a, b) = (closed.resultants(&strains), section.resultants(&strains));
        for (a, b) in a
            .membrane
            .iter()
            .chain(&a.moment)
            .chain(&a.shear)
            .zip(b.membrane.iter().chain(&b.moment).chain(&b.shear))
        {
            assert!((first(*a) - first(*b)).abs() < 1e-13 * first(*a).abs());
        }
    }
}

#[test]
fn the_split_is_the_papers_tensor_to_first_order_in_the_thickness() {
    // Flat reference: the natural basis is orthonormal, and E(ζ) = E_m + ζ E_f + O(ζ²).
    let flat = [Vector3::x(), Vector3::y(), Vector3::z(), Vector3::zeros(), Vector3::zeros()];
    let now = [
        Vector3::new(1.1, 0.05, 0.2),
        Vector3::new(-0.03, 0.95, 0.1),
        Vector3::new(-0.2, -0.1, 0.97),
        Vector3::new(0.3, 0.1, -0.05),
        Vector3::new(0.02, -0.4, 0.1),
    ];
    let frame = [Vector3::x(), Vector3::y(), Vector3::z()];
    let split = GreenLagrange.strains(&placement(&now).measures(), &placement(&flat).measures());
    let s = numbers(&split);
    let tensor = |zeta: f64| local_green_lagrange(&now, &flat, zeta, &frame).unwrap();
    let (middle, slope) = (tensor(0.0), (tensor(1e-3) - tensor(-1e-3)) / 2e-3);
    for (value, expected) in [
        (middle[(0, 0)], s[0]),
        (middle[(1, 1)], s[1]),
        (2.0 * middle[(0, 1)], s[2]),
        (slope[(0, 0)], s[3]),
        (slope[(1, 1)], s[4]),
        (2.0 * slope[(0, 1)], s[5]),
        (2.0 * middle[(0, 2)], s[6]),
        (2.0 * middle[(1, 2)], s[7]),
    ] {
        assert!((value - expected).abs() < 1e-12, "{value} against {expected}");
    }
}

#[test]
fn a_circle_is_free_of_membrane_force_for_the_corrected_curvature_only() {
    // Roll a strip to curvature k with mid-surface stretch λ: x,1 = λ e, d,1 = k e. Equilibrium of the strip under
    // an end couple asks for no membrane force; the derivative of the energy by λ must vanish at λ = 1.
    let section = IsotropicSection::new(Isotropic::new(1200.0, 0.0).unwrap(), 1.0).unwrap();
    let rolled = |stretch: f64, k: f64| {
        placement(&[Vector3::x() * stretch, Vector3::y(), Vector3::z(), Vector3::x() * k, Vector3::zeros()])
    };
    let reference = rolled(1.0, 0.0).measures();
    let k = std::f64::consts::TAU / 10.0;
    let membrane = |measure: &dyn StrainMeasure, stretch: f64| {
        let p = rolled(stretch, k);
        let m: Measures = p.measures();
        let f = measure.transpose(&m, &reference, &section.resultants(&measure.strains(&m, &reference)));
        Vector3::from(p.transpose(&f).n1.lane(0)).x
    };
    // Green–Lagrange rests at λ² = 1 − (kt)²/6 (see benchmarks: rolled strip).
    let contracted = (1.0 - k * k / 6.0).sqrt();
    assert!(membrane(&GreenLagrange, contracted).abs() < 1e-10);
    // At λ = 1 it pulls with EIk² = 39.5: the moment along the turning director.
    assert!((membrane(&GreenLagrange, 1.0) - 100.0 * k * k).abs() < 1e-9);
    // Corrected: the moment's share of n1 along x,1 cancels against its membrane share at λ = 1.
    assert!(membrane(&StretchCorrected, 1.0).abs() < 1e-10);
}

#[test]
fn materials_out_of_bounds_are_named() {
    assert_eq!(Isotropic::new(-1.0, 0.3).unwrap_err(), MaterialError::Young(-1.0));
    assert_eq!(Isotropic::new(1.0, 0.5).unwrap_err(), MaterialError::Poisson(0.5));
    assert!(Isotropic::new(1.0, f64::NAN).is_err());
    let sound = Isotropic::new(1.0, 0.3).unwrap();
    assert_eq!(IsotropicSection::new(sound, 0.0).unwrap_err(), MaterialError::Thickness(0.0));
    assert_eq!(IntegratedSection::new(sound, 1.0, 1).unwrap_err(), MaterialError::GaussPoints(1));
    assert!(IntegratedSection::new(sound, 1.0, 6).is_err());
}

#[test]
fn strain_measures_are_found_by_name() {
    for measure in strain_measures() {
        assert_eq!(strain_measure(measure.name()).unwrap().name(), measure.name());
        assert!(!measure.describe().is_empty());
    }
    assert!(strain_measure("almansi").is_none());
}
