//! Plies that yield between plies that do not.

use shell_kinematics::{
    Hardening, Isotropic, LayeredSection, Memory, Orthotropic, Pack, Plastic, PlasticPly, PlasticSection,
    Ply, PlyMaterial, Section, Strains,
};

use crate::common::*;

/// A fibre of glass.
fn fibre() -> Orthotropic {
    Orthotropic::new(54e3, 9.4e3, 0.33, 5.5e3, 3e3).unwrap()
}

fn metal(slope: f64) -> Plastic {
    Plastic::new(elastic(), Hardening::linear(YIELD, slope).unwrap())
}

fn ply(material: PlyMaterial, thickness: f64, angle: f64) -> PlasticPly {
    PlasticPly { material, thickness, angle }
}

/// Metal, fibre at an angle, soft isotropic, metal.
pub fn stack(slope: f64, angle: f64) -> PlasticSection {
    PlasticSection::layered(&[
        ply(PlyMaterial::Plastic(metal(slope), 3), 0.3, 0.0),
        ply(PlyMaterial::Orthotropic(fibre()), 0.1, 0.4 + angle),
        ply(PlyMaterial::Elastic(Isotropic::new(3e3, 0.4).unwrap()), 0.2, 0.0),
        ply(PlyMaterial::Plastic(metal(slope), 2), 0.2, 0.0),
    ])
    .unwrap()
}

/// The greatest difference of resultants over [`sizes`].
fn apart(a: [Pack; 8], b: [Pack; 8]) -> f64 {
    (0..8).fold(0.0_f64, |worst, i| worst.max(most(a[i] - b[i]) / sizes()[i]))
}

#[test]
fn what_does_not_flow_is_the_laminate_transverse_shear_and_energy_too() {
    let shear = |young: f64, poisson: f64| 0.5 * young / (1.0 + poisson);
    let even = |young, poisson: f64| {
        let g = shear(young, poisson);
        Orthotropic::new(young, young, poisson, g, g).unwrap()
    };
    let of = |material, thickness, angle| Ply { material, thickness, angle };
    let laminate = LayeredSection::new(&[
        of(even(YOUNG, POISSON), 0.3, 0.0),
        of(fibre(), 0.1, 0.4),
        of(even(3e3, 0.4), 0.2, 0.0),
        of(even(YOUNG, POISSON), 0.2, 0.0),
    ])
    .unwrap();
    let small = Random(61).strains(1e-4, 1e-4);
    let section = stack(0.0, 0.0);
    let worst = apart(fresh(&section, &small), fresh(&laminate, &small));
    let energy = most(section.energy(&small) - laminate.energy(&small)) / most(laminate.energy(&small));
    let (a, b) = (section.tangent(&small), laminate.tangent(&small));
    let tangents = a.as_flattened().iter().zip(b.as_flattened());
    let tangent = tangents.fold(0.0_f64, |worst, (a, b)| worst.max(most(*a - *b))) / YOUNG;
    println!("{worst:.1e} {energy:.1e} {tangent:.1e}");
    // 2e-17 of the yield force, 4e-16 and 7e-17: rounding.
    assert!(worst < 1e-16 && energy < 1e-15 && tangent < 1e-15, "{worst:.1e} {energy:.1e} {tangent:.1e}");
    assert!(most(section.resultants(&small).shear[0]) > 0.0);
    // Only what yields remembers: five slices, and the section.
    assert_eq!(section.history_len(), 4 * 5 + 8);
    assert_eq!(section.fewest_slices(), 2);
}

#[test]
fn a_ply_that_never_yields_is_an_elastic_one_over_a_history() {
    let hard = Plastic::new(elastic(), Hardening::linear(1e9, 0.0).unwrap());
    let with = |middle| {
        let face = || ply(PlyMaterial::Plastic(metal(900.0), 4), 0.2, 0.0);
        Specimen::new(PlasticSection::layered(&[face(), ply(middle, 0.4, 0.0), face()]).unwrap())
    };
    let mut one = with(PlyMaterial::Plastic(hard, 2));
    let mut other = with(PlyMaterial::Elastic(elastic()));
    let mut random = Random(67);
    let mut worst = 0.0_f64;
    for _ in 0..6 {
        let now = random.strains(0.01, 0.02);
        one.commit(&now);
        other.commit(&now);
        let next = plus(&now, &random.strains(1e-3, 2e-3), 1.0);
        worst = worst.max(apart(forces(&one.resultants(&next)), forces(&other.resultants(&next))));
        let [a, b] = [&one, &other].map(|own| own.section.tallies(&own.history));
        worst = worst.max(most(a.thickness() - b.thickness()));
        worst = worst.max(most(a.kept_share() - b.kept_share()));
        worst = worst.max(most(a.plastic_strain() - b.plastic_strain()));
        worst = worst.max(most(a.dissipated() - b.dissipated()) / YIELD);
    }
    println!("{worst:.1e}");
    // 0 to 4e-16: rounding.
    assert!(worst < 2e-15, "{worst:.1e}");
}

/// Faces without hardening round an elastic core, in plane strain and ν = ½: the moment of faces that flow throughout is theirs and the core's `E'κ t³/12`.
#[test]
fn a_clad_strip_carries_the_moment_of_its_faces_and_its_core() {
    let [face, core, curvature] = [0.1, 0.8, 1e-4];
    let elastic = Isotropic::new(1.0, 0.5 - 1e-10).unwrap();
    let yields = Plastic::new(elastic, Hardening::linear(1e-6, 0.0).unwrap());
    let skin = || ply(PlyMaterial::Plastic(yields.clone(), 4), face, 0.0);
    let strip =
        PlasticSection::layered(&[skin(), ply(PlyMaterial::Elastic(elastic), core, 0.0), skin()]).unwrap();
    let now = Strains { curvature: [curvature, 0.0, 0.0].map(Pack::splat), ..Strains::default() };
    let moment = first(strip.resultants(&now).moment[0]);
    let stress = 2e-6 / 3.0_f64.sqrt();
    let wanted = stress * face * (core + face) + 4.0 / 3.0 * curvature * core * core * core / 12.0;
    println!("{:.1e}", moment / wanted - 1.0);
    // 1e-10: ν next to ½.
    assert!((moment / wanted - 1.0).abs() < 5e-10, "{moment} {wanted}");
}

#[test]
fn a_stack_turned_with_its_strains_answers_as_before() {
    let angle = 0.9;
    let [mut here, mut there] = [0.0, angle].map(|by| Specimen::new(stack(1500.0, by)));
    let mut random = Random(71);
    let mut worst = 0.0_f64;
    for _ in 0..6 {
        let strains = random.strains(0.01, 0.02);
        let [g1, g2] = strains.shear;
        let (sin, cos) = libm::sincos(angle);
        let other = Strains {
            membrane: turned(strains.membrane, -angle, 2.0),
            curvature: turned(strains.curvature, -angle, 2.0),
            shear: [g1 * cos - g2 * sin, g1 * sin + g2 * cos],
        };
        here.commit(&strains);
        there.commit(&other);
        let (a, b) = (here.resultants(&strains), there.resultants(&other));
        let [n, m] = [a.membrane, a.moment].map(|part| turned(part, -angle, 1.0));
        let [q1, q2] = a.shear;
        let q = [q1 * cos - q2 * sin, q1 * sin + q2 * cos];
        for i in 0..3 {
            worst = worst.max(most(n[i] - b.membrane[i]) / sizes()[0]);
            worst = worst.max(most(m[i] - b.moment[i]) / sizes()[3]);
        }
        (0..2).for_each(|i| worst = worst.max(most(q[i] - b.shear[i]) / sizes()[0]));
    }
    println!("{worst:.1e}");
    // 8e-16: rounding.
    assert!(worst < 3e-15, "{worst:.1e}");
}
