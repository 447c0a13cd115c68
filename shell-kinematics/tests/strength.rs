//! Failure criteria: strengths are met, reserve factors bring the index to one, published and closed forms.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use shell_kinematics::{Criterion, FibreStrength, MaterialError, Strength};

const BOTH: [Criterion; 2] = [Criterion::TsaiWu, Criterion::Hashin];

/// Graphite and epoxy of \[kaw2006\], table 2.1 \[MPa\].
fn graphite() -> FibreStrength {
    FibreStrength::new([1500.0, 1500.0], [40.0, 246.0], 68.0).unwrap()
}

/// Strengths of which no two are alike.
fn uneven() -> FibreStrength {
    FibreStrength::new([1500.0, 900.0], [50.0, 210.0], 80.0).unwrap().sheared_across(70.0).unwrap()
}

/// A handful of stresses of all signs \[MPa\].
fn stresses() -> impl Iterator<Item = [f64; 3]> {
    let signs = [-1.0, 0.3, 1.0];
    signs.into_iter().flat_map(move |a| {
        signs.into_iter().flat_map(move |b| [-40.0, 0.0, 25.0].map(|c| [a * 310.0, b * 37.0, c]))
    })
}

#[test]
fn every_strength_is_met() {
    let alone =
        [[1500.0, 0.0, 0.0], [-900.0, 0.0, 0.0], [0.0, 50.0, 0.0], [0.0, -210.0, 0.0], [0.0, 0.0, -80.0]];
    for criterion in BOTH {
        for stress in alone {
            let at = uneven().margin(criterion, stress);
            assert!(
                (at.index - 1.0).abs() < 1e-14 && (at.reserve - 1.0).abs() < 1e-14,
                "{criterion:?} {stress:?}"
            );
            let half = uneven().margin(criterion, stress.map(|s| 0.5 * s));
            assert!((half.reserve - 2.0).abs() < 1e-14, "{criterion:?} {stress:?}");
        }
        let none = uneven().margin(criterion, [0.0; 3]);
        assert!(none.index == 0.0 && none.reserve == f64::INFINITY);
    }
}

#[test]
fn a_reserve_factor_brings_the_index_to_one() {
    let all = [Strength::Fibre(uneven()), Strength::Fibre(graphite()), Strength::of_yield(250.0).unwrap()];
    for strength in all {
        for criterion in BOTH {
            for stress in stresses() {
                let reserve = strength.margin(criterion, stress).reserve;
                let there = strength.margin(criterion, stress.map(|s| reserve * s));
                assert!((there.index - 1.0).abs() < 1e-13, "{criterion:?} {stress:?}: {}", there.index);
            }
        }
    }
}

/// \[kaw2006\], example 2.19: a ply at 60° under σx = 2S, σy = −3S, τxy = 4S fails at S = 22.39 MPa.
#[test]
fn a_published_ply_at_sixty_degrees() {
    let stress = turned([2.0, -3.0, 4.0], 60.0);
    let reserve = graphite().margin(Criterion::TsaiWu, stress).reserve;
    assert!((reserve - 22.39).abs() < 0.005, "{reserve}");
}

/// Stress of the axes x and y in those of a fibre at an angle \[degrees\].
fn turned([x, y, xy]: [f64; 3], angle: f64) -> [f64; 3] {
    let (s, c) = libm::sincos(angle.to_radians());
    [
        c * c * x + s * s * y + 2.0 * s * c * xy,
        s * s * x + c * c * y - 2.0 * s * c * xy,
        s * c * (y - x) + (c * c - s * s) * xy,
    ]
}

/// Off-axis strength of Tsai and Wu: `A σ² + B σ = 1` with `A = F₁₁c⁴ + F₂₂s⁴ + (F₆₆ + 2F₁₂)s²c²`, `B = F₁c² + F₂s²`.
#[test]
fn a_bar_off_its_axis() {
    let ([xt, xc], [yt, yc], shear) = ([1500.0, 900.0], [50.0, 210.0], 80.0);
    let (f11, f22, f66): (f64, f64, f64) = (1.0 / (xt * xc), 1.0 / (yt * yc), 1.0 / (shear * shear));
    for interaction in [-0.5, 0.0, 0.4_f64] {
        let strength = uneven().interacting(interaction).unwrap();
        let f12 = interaction * (f11 * f22).sqrt();
        for angle in [0.0, 5.0, 17.0, 45.0, 70.0, 90.0_f64] {
            let (s, c) = libm::sincos(angle.to_radians());
            let (cc, ss) = (c * c, s * s);
            let a = f11 * cc * cc + f22 * ss * ss + (f66 + 2.0 * f12) * ss * cc;
            let b = (1.0 / xt - 1.0 / xc) * cc + (1.0 / yt - 1.0 / yc) * ss;
            for sign in [1.0, -1.0] {
                let exact = (-sign * b + (b * b + 4.0 * a).sqrt()) / (2.0 * a);
                let found = strength.margin(Criterion::TsaiWu, turned([sign, 0.0, 0.0], angle)).reserve;
                assert!((found / exact - 1.0).abs() < 1e-12, "{angle}: {found}, {exact}");
            }
        }
    }
}

/// Strengths alike in all directions, S = X/√3 and the interaction −½: Tsai and Wu's criterion is von Mises'.
#[test]
fn equal_strengths_are_von_mises() {
    let x = 250.0_f64;
    let alike = FibreStrength::new([x; 2], [x; 2], x / 3.0_f64.sqrt()).unwrap();
    for stress in stresses() {
        let [fibre, plain] = [Strength::Fibre(alike), Strength::of_yield(x).unwrap()]
            .map(|strength| strength.margin(Criterion::TsaiWu, stress).reserve);
        assert!((fibre / plain - 1.0).abs() < 1e-13);
    }
}

#[test]
fn strengths_out_of_bounds_are_refused() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(FibreStrength::new([bad, 1.0], [1.0; 2], 1.0).is_err());
        assert!(FibreStrength::new([1.0; 2], [1.0, bad], 1.0).is_err());
        assert!(FibreStrength::new([1.0; 2], [1.0; 2], bad).is_err());
        assert!(graphite().sheared_across(bad).is_err() && Strength::of_yield(bad).is_err());
    }
    assert!(matches!(graphite().interacting(1.0), Err(MaterialError::Constant { value: 1.0, .. })));
    assert!(graphite().interacting(f64::NAN).is_err());
}
