//! Stresses of plies: they add up to the resultants, turn with their section, and know heat.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use shell_kinematics::{
    Criterion, FibreStrength, IntegratedSection, Isotropic, IsotropicSection, LayeredSection, Orthotropic,
    Pack, Ply, Rubber, RubberSection, Section, Strains, Strength, laminate_of,
};

fn carbon() -> Orthotropic {
    let strength = FibreStrength::new([1500.0, 1200.0], [50.0, 250.0], 70.0).unwrap();
    let fibre = Orthotropic::new(140e3, 10e3, 0.3, 5e3, 3e3).unwrap();
    fibre.expanding([-0.5e-6, 30e-6]).unwrap().strong(Strength::Fibre(strength))
}

/// Plies of thicknesses and angles \[degrees\].
fn stack(plies: &[(f64, f64)]) -> LayeredSection {
    let ply =
        |&(thickness, angle): &(f64, f64)| Ply { material: carbon(), thickness, angle: angle.to_radians() };
    LayeredSection::new(&plies.iter().map(ply).collect::<Vec<_>>()).unwrap()
}

fn skew() -> LayeredSection {
    stack(&[(0.1, 0.0), (0.25, 35.0), (0.15, -70.0)])
}

const STRAINS: [f64; 6] = [1.1e-3, -0.4e-3, 0.7e-3, 2e-3, -3e-3, 1.5e-3];

/// Resultants of a section at strains about its middle.
fn resultants(section: &dyn Section, s: [f64; 6]) -> [f64; 6] {
    let three = |first: usize| std::array::from_fn(|i| Pack::splat(s[first + i]));
    let strains = Strains { membrane: three(0), curvature: three(3), shear: [Pack::ZERO; 2] };
    let found = section.resultants(&strains);
    let all = [found.membrane, found.moment];
    std::array::from_fn(|i| all[i / 3][i % 3].lanes()[0])
}

/// Stress in the axes of a fibre in those of the section.
fn back([s1, s2, s6]: [f64; 3], angle: f64) -> [f64; 3] {
    let (s, c) = libm::sincos(angle);
    [
        c * c * s1 + s * s * s2 - 2.0 * s * c * s6,
        s * s * s1 + c * c * s2 + 2.0 * s * c * s6,
        s * c * (s1 - s2) + (c * c - s * s) * s6,
    ]
}

/// Forces and moments about the middle of what the plies bear, by Simpson's rule, exact for what is linear times linear.
fn added_up(section: &LayeredSection, through: &shell_kinematics::Through) -> [f64; 6] {
    let total: f64 = section.plies().iter().map(|ply| ply.thickness).sum();
    let (mut sum, mut bottom) = ([0.0; 6], -0.5 * total);
    for (number, ply) in section.plies().iter().enumerate() {
        for (share, weight) in [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] {
            let stress = back(section.ply_stress(number, through, share), ply.angle);
            let (height, part) = (bottom + share * ply.thickness, weight / 6.0 * ply.thickness);
            for i in 0..3 {
                sum[i] += part * stress[i];
                sum[3 + i] += part * height * stress[i];
            }
        }
        bottom += ply.thickness;
    }
    sum
}

fn near(a: &[f64], b: &[f64], tolerance: f64) {
    let size = b.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (x, y) in a.iter().zip(b) {
        assert!((x - y).abs() <= tolerance * size, "{a:?}\n{b:?}");
    }
}

#[test]
fn stresses_add_up_to_the_resultants() {
    let section = skew();
    let through = section.through(STRAINS, 0.0, None);
    // Some hundred operations of rounding.
    near(&added_up(&section, &through), &resultants(&section, STRAINS), 1e-13);
}

#[test]
fn heat_is_read_back_from_the_resultants() {
    let section = skew();
    for (heat, height) in [([80.0, 0.0], 0.0), ([-120.0, 30.0], 0.0), ([55.0, -20.0], 0.4)] {
        let about = section.through(STRAINS, height, None);
        let [m, k] = [about.membrane, about.curvature];
        let own = resultants(&section, [m[0], m[1], m[2], k[0], k[1], k[2]]);
        // About the surface of the particles, under the middle by the height.
        let blocked = section.expansion().unwrap().blocked(heat, height).resultants;
        let all: [f64; 6] = std::array::from_fn(|i| {
            if i < 3 { own[i] - blocked[i] } else { own[i] + height * own[i - 3] - blocked[i] }
        });
        let through = section.through(STRAINS, height, Some(all));
        let wanted = [heat[0], heat[1] / 0.5];
        // Temperatures are what is left of forces of the strains, of ten times their size.
        near(&through.heat, &wanted, 1e-11);
        let sums = added_up(&section, &through);
        let about: Vec<f64> =
            (0..6).map(|i| if i < 3 { all[i] } else { all[i] - height * all[i - 3] }).collect();
        near(&sums, &about, 1e-11);
    }
}

#[test]
fn a_free_ply_that_is_warm_bears_nothing() {
    let section = stack(&[(0.2, 25.0)]);
    let (s, c) = libm::sincos(25.0_f64.to_radians());
    let [l, t] = [-0.5e-6 * 100.0, 30e-6 * 100.0];
    let strains = [l * c * c + t * s * s, l * s * s + t * c * c, 2.0 * s * c * (l - t), 0.0, 0.0, 0.0];
    let through = section.through(strains, 0.0, Some([0.0; 6]));
    near(&[through.heat[0]], &[100.0], 1e-12);
    let stress = section.ply_stress(0, &through, 0.5);
    // Of forces of E α θ = 30 MPa.
    assert!(stress.iter().all(|s| s.abs() < 1e-10), "{stress:?}");
}

#[test]
fn a_turned_section_bears_the_same() {
    let turn = 0.4_f64;
    let (s, c) = libm::sincos(turn);
    let about = |[a, b, g]: [f64; 3]| {
        [
            c * c * a + s * s * b + s * c * g,
            s * s * a + c * c * b - s * c * g,
            2.0 * s * c * (b - a) + (c * c - s * s) * g,
        ]
    };
    let ([a, b, g, ka, kb, kg], own) = (STRAINS, skew());
    let other: Vec<Ply> = own.plies().iter().map(|ply| Ply { angle: ply.angle - turn, ..*ply }).collect();
    let other = LayeredSection::new(&other).unwrap();
    let ([a, b, g], [ka, kb, kg]) = (about([a, b, g]), about([ka, kb, kg]));
    let turned = other.through([a, b, g, ka, kb, kg], 0.0, None);
    let plain = own.through(STRAINS, 0.0, None);
    for ply in 0..3 {
        near(&other.ply_stress(ply, &turned, 0.3), &own.ply_stress(ply, &plain, 0.3), 1e-13);
    }
}

/// Plies of −θ under a mirrored shear bear shears of the other sign, with the same margins; upside down and bent the other way, the same plies.
#[test]
fn mirrored_plies_bear_the_same() {
    let own = skew();
    let plain = own.through(STRAINS, 0.0, None);
    let [a, b, g, ka, kb, kg] = STRAINS;
    let mirrored: Vec<Ply> = own.plies().iter().map(|ply| Ply { angle: -ply.angle, ..*ply }).collect();
    let mirrored = LayeredSection::new(&mirrored).unwrap();
    let other = mirrored.through([a, b, -g, ka, kb, -kg], 0.0, None);
    let over: Vec<Ply> = own.plies().iter().rev().copied().collect();
    let over = LayeredSection::new(&over).unwrap();
    let bent = over.through([a, b, g, -ka, -kb, -kg], 0.0, None);
    for ply in 0..3 {
        let stress = own.ply_stress(ply, &plain, 0.2);
        let [s1, s2, s6] = mirrored.ply_stress(ply, &other, 0.2);
        near(&[s1, s2, -s6], &stress, 1e-13);
        near(&over.ply_stress(2 - ply, &bent, 0.8), &stress, 1e-13);
        for criterion in [Criterion::TsaiWu, Criterion::Hashin] {
            let reserve = |section: &LayeredSection, ply, through| {
                section.ply_margin(ply, criterion, through).unwrap().reserve
            };
            near(
                &[reserve(&mirrored, ply, &other), reserve(&over, 2 - ply, &bent)],
                &[reserve(&own, ply, &plain); 2],
                1e-12,
            );
        }
    }
}

/// The worst of a ply is that of a thousand heights through it, for both criteria: none of them is worse, and one comes near.
#[test]
fn the_worst_of_a_ply_is_found_within_it() {
    let section = stack(&[(1.0, 0.0)]);
    let strength = section.plies()[0].material.strength().copied().unwrap();
    for curvature in [[2e-2, 4e-2, 0.0], [-1e-2, 3e-2, 5e-2], [3e-2, -6e-2, -4e-2]] {
        let [k1, k2, k3] = curvature;
        let through = section.through([1e-4, -2e-3, 1.2e-2, k1, k2, k3], 0.0, None);
        for criterion in [Criterion::TsaiWu, Criterion::Hashin] {
            let worst = section.ply_margin(0, criterion, &through).unwrap();
            let at =
                |i: usize| strength.margin(criterion, section.ply_stress(0, &through, i as f64 / 1000.0));
            let least = (0..=1000).map(at).map(|margin| margin.reserve).fold(f64::INFINITY, f64::min);
            assert!(worst.reserve <= least * (1.0 + 1e-12), "{criterion:?} {least} {worst:?}");
            assert!(worst.reserve > least * 0.99, "{criterion:?} {least} {worst:?}");
        }
    }
}

#[test]
fn homogeneous_sections_are_one_ply() {
    let steel = Isotropic::new(210e3, 0.3).unwrap().strong(250.0);
    let closed = IsotropicSection::new(steel, 0.4).unwrap();
    let integrated = IntegratedSection::new(steel, 0.4, 3).unwrap();
    for section in [&closed as &dyn Section, &integrated] {
        let laminate = laminate_of(section).unwrap();
        let through = laminate.through(STRAINS, 0.0, None);
        near(&added_up(&laminate, &through), &resultants(section, STRAINS), 1e-13);
        let (ply, margin) = laminate.worst_ply(Criterion::TsaiWu, &through).unwrap();
        let faces = [0.0, 1.0].map(|share| {
            let [a, b, c] = laminate.ply_stress(0, &through, share);
            (a * a + b * b - a * b + 3.0 * c * c).sqrt()
        });
        assert_eq!(ply, 0);
        near(&[margin.reserve], &[250.0 / faces[0].max(faces[1])], 1e-13);
    }
    let rubber = RubberSection::new(Rubber::neo_hooke(1.0).unwrap(), 0.1).unwrap();
    assert!(laminate_of(&rubber).is_none());
}

#[test]
fn plies_without_a_strength_are_not_judged() {
    let bare = Orthotropic::new(140e3, 10e3, 0.3, 5e3, 3e3).unwrap();
    let ply = |material| Ply { material, thickness: 0.1, angle: 0.0 };
    let section = LayeredSection::new(&[ply(bare), ply(carbon()), ply(bare)]).unwrap();
    let through = section.through(STRAINS, 0.0, None);
    assert!(section.ply_margin(0, Criterion::TsaiWu, &through).is_none());
    assert_eq!(section.worst_ply(Criterion::TsaiWu, &through).unwrap().0, 1);
    assert!(LayeredSection::new(&[ply(bare)]).unwrap().worst_ply(Criterion::Hashin, &through).is_none());
}
