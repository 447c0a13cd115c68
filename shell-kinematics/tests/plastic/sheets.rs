//! Rolled sheets by their r-values, and plies that yield.

use std::f64::consts::FRAC_PI_4;

use shell_kinematics::{
    Hardening, LayeredSection, Memory, Orthotropic, Pack, Plastic, PlasticPly, PlasticSection, Ply,
    PlyMaterial, RValues, Section, Strains,
};

use crate::common::*;

/// Of a mild steel, of an aluminium, and of a sheet far from both.
const SHEETS: [[f64; 3]; 3] = [[1.8, 1.2, 2.2], [0.7, 0.4, 0.6], [4.0, 0.3, 1.0]];

fn sheet([r0, r45, r90]: [f64; 3], hardening: &Hardening) -> Plastic {
    Plastic::new(elastic(), hardening.clone()).anisotropic(RValues::new(r0, r45, r90).unwrap())
}

fn one_ply(material: Plastic, angle: f64, slices: usize) -> PlasticSection {
    PlasticSection::layered(&[ply(&material, THICKNESS, angle, slices)]).unwrap()
}

/// Bars cut at 0, 45 and 90° strain across and through the thickness by their r-values; the one along the first axis yields at the yield stress.
#[test]
fn bars_have_the_r_values() {
    let hardening = Hardening::swift(500.0, 0.01, 0.2).unwrap();
    let mut worst = [0.0_f64; 2];
    for values in SHEETS {
        for (number, r) in values.into_iter().enumerate() {
            let material = sheet(values, &hardening);
            // The bar lies along the first axis of the point, the sheet at the opposite angle.
            let mut bar = Specimen::new(one_ply(material, -FRAC_PI_4 * number as f64, 2));
            let mut now = Strains::default();
            for step in 1..=20 {
                now.membrane[0] = Pack::splat(5e-3 * f64::from(step));
                now = bar.solved(&now, &[1, 2]);
                bar.commit(&now);
            }
            let stress = first(bar.resultants(&now).membrane[0]) / THICKNESS;
            let along = first(now.membrane[0]) - stress / YOUNG;
            let across = first(now.membrane[1]) + POISSON * stress / YOUNG;
            worst[0] = worst[0].max((across / -(along + across) / r - 1.0).abs());
            if number == 0 {
                let alpha = first(bar.section.tallies(&bar.history).plastic_strain());
                worst[1] = worst[1].max((stress / hardening.stress(alpha) - 1.0).abs());
                worst[1] = worst[1].max((alpha / along - 1.0).abs());
            }
        }
    }
    println!("{worst:?}");
    // 2e-15: rounding.
    assert!(worst[0] < 6e-15 && worst[1] < 6e-15, "{worst:?}");
}

/// Hill's stress, `√(3/2 σᵀPσ)`, against the curve at random points.
#[test]
fn three_steps_reach_the_surface_of_sheets() {
    for (name, hardening) in hardenings() {
        let mut random = Random(41);
        let mut worst = 0.0_f64;
        for round in 0..1500 {
            let values = SHEETS[round % 3];
            let mut specimen = Specimen::new(one_ply(sheet(values, &hardening), 0.0, 2));
            let size = random.size(1e-3, 1.0);
            let mut now = random.strains(size, 0.0);
            for _ in 0..3 {
                let before = specimen.section.tallies(&specimen.history).plastic_strain().lanes();
                specimen.commit(&now);
                let alpha = specimen.section.tallies(&specimen.history).plastic_strain().lanes();
                let force = specimen.resultants(&now).membrane.map(|n| (n * (1.0 / THICKNESS)).lanes());
                let [r0, r45, r90] = values;
                for lane in 0..COUNT {
                    let [s, t, u] = force.map(|n| n[lane]);
                    let share = r0 / (1.0 + r0);
                    let other = share * (1.0 + 1.0 / r90);
                    let n = (r0 + r90) * (1.0 + 2.0 * r45) / (2.0 * r90 * (1.0 + r0));
                    let size = (s * s + other * t * t - 2.0 * share * s * t + 2.0 * n * u * u).sqrt();
                    let excess = size / hardening.stress(alpha[lane]) - 1.0;
                    worst = worst.max(if alpha[lane] > before[lane] { excess.abs() } else { excess });
                }
                let size = random.size(1e-5, 1e-2);
                now = plus(&now, &random.strains(size, 0.0), 1.0);
            }
        }
        println!("{name}: {worst:.1e}");
        // 1.5e-13: rounding of stresses from strains of a thousand yield strains.
        assert!(worst < 5e-13, "{name}: {worst:.1e}");
    }
}

/// r = 1 in every direction is von Mises' law, at any angle.
#[test]
fn equal_r_values_are_von_mises() {
    let mut random = Random(43);
    let hardening = Hardening::voce(YIELD, 200.0, 12.0).unwrap();
    let mut plain = Specimen::new(section(hardening.clone(), 6));
    let mut hill = Specimen::new(one_ply(sheet([1.0; 3], &hardening), 0.7, 6));
    let mut worst = 0.0_f64;
    for _ in 0..200 {
        let now = random.strains(0.01, 0.02);
        let (a, b) = (forces(&plain.resultants(&now)), forces(&hill.resultants(&now)));
        for i in 0..8 {
            worst = worst.max(most(a[i] - b[i]) / sizes()[i]);
        }
        plain.commit(&now);
        hill.commit(&now);
    }
    println!("{worst:.1e}");
    // 2e-15: rounding.
    assert!(worst < 7e-15, "{worst:.1e}");
}

fn ply(material: &Plastic, thickness: f64, angle: f64, slices: usize) -> PlasticPly {
    PlasticPly { material: PlyMaterial::Plastic(material.clone(), slices), thickness, angle }
}

/// Three equal plies of 4 slices are one of 12 where nothing flows, and have its plastic moment to the error of either rule.
#[test]
fn equal_plies_are_one() {
    let material = Plastic::new(elastic(), Hardening::linear(YIELD, 0.0).unwrap());
    let third = THICKNESS / 3.0;
    let three = [0.0, 0.3, 0.6].map(|angle| ply(&material, third, angle, 4));
    let three = PlasticSection::layered(&three).unwrap();
    let one = one_ply(material, 0.0, 12);
    let mut random = Random(47);
    let small = random.strains(2e-4, 2e-4);
    let (a, b) = (fresh(&three, &small), fresh(&one, &small));
    let elastic = (0..8).fold(0.0_f64, |worst, i| worst.max(most(a[i] - b[i]) / sizes()[i]));
    let moment = |section: &PlasticSection| first(section.resultants(&bent([0.1, 0.0, 0.0])).moment[0]);
    let full = 2.0 / 3.0_f64.sqrt() * YIELD * THICKNESS * THICKNESS / 4.0;
    println!("{elastic:.1e}, {:.4} {:.4}", moment(&three) / full, moment(&one) / full);
    // 2e-17 of the yield force; moments .35 and .33 % above that of the integral.
    assert!(elastic < 1e-16, "{elastic:.1e}");
    assert!((moment(&three) / moment(&one) - 1.0).abs() < 0.01);
}

/// Plies of other materials at other angles: elastic as the laminate of the same constants; forces, tangent and turned frames as of one ply.
#[test]
fn plies_of_sheets_are_a_laminate() {
    let soft = shell_kinematics::Isotropic::new(70e3, 0.33).unwrap();
    let light = Plastic::new(soft, Hardening::voce(120.0, 80.0, 9.0).unwrap())
        .anisotropic(RValues::new(0.7, 0.4, 0.6).unwrap())
        .kinematic(900.0)
        .unwrap();
    let steel = sheet(SHEETS[0], &Hardening::linear(YIELD, 1500.0).unwrap());
    let stack = |by: f64| {
        let plies = [ply(&light, 0.2, 0.3 + by, 3), ply(&steel, 0.5, -0.8 + by, 6), ply(&light, 0.1, by, 2)];
        PlasticSection::layered(&plies).unwrap()
    };
    let linear = |young: f64, poisson: f64, thickness: f64| {
        let g = 0.5 * young / (1.0 + poisson);
        Ply { material: Orthotropic::new(young, young, poisson, g, g).unwrap(), thickness, angle: 0.0 }
    };
    let laminate =
        LayeredSection::new(&[linear(70e3, 0.33, 0.2), linear(YOUNG, POISSON, 0.5), linear(70e3, 0.33, 0.1)])
            .unwrap();
    let mut random = Random(53);
    let small = random.strains(1e-4, 1e-4);
    let (a, b) = (fresh(&stack(0.0), &small), fresh(&laminate, &small));
    let worst = (0..8).fold(0.0_f64, |worst, i| worst.max(most(a[i] - b[i]) / sizes()[i]));
    println!("{worst:.1e}");
    // 3e-17 of the yield force.
    assert!(worst < 1e-16, "{worst:.1e}");

    // Turned by an angle, stack and strains.
    let angle = 0.9;
    let mut here = Specimen::new(stack(0.0));
    let mut there = Specimen::new(stack(angle));
    let mut worst = 0.0_f64;
    for _ in 0..6 {
        let strains = random.strains(0.01, 0.02);
        let other = Strains {
            membrane: turned(strains.membrane, -angle, 2.0),
            curvature: turned(strains.curvature, -angle, 2.0),
            ..strains
        };
        here.commit(&strains);
        there.commit(&other);
        let (a, b) = (here.resultants(&strains), there.resultants(&other));
        let [n, m] = [a.membrane, a.moment].map(|part| turned(part, -angle, 1.0));
        for i in 0..3 {
            worst = worst.max(most(n[i] - b.membrane[i]) / sizes()[0]);
            worst = worst.max(most(m[i] - b.moment[i]) / sizes()[3]);
        }
    }
    println!("{worst:.1e}");
    // 7e-16: rounding.
    assert!(worst < 3e-15, "{worst:.1e}");
    assert_eq!(here.section.history_len(), 4 * 11 + 8);
}
