//! Points side by side: strain measures of their own, resultants where nothing is strained.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use shell_kinematics::{
    GreenLagrange, Isotropic, IsotropicSection, LANES, Measures, Pack, Resultants, Section, SectionPack,
    StrainMeasure, StrainPack, Strains, StressedPack, StretchCorrected,
};

/// Numbers that no two entries share.
fn row(first: f64) -> [Pack; 8] {
    std::array::from_fn(|i| Pack::from_fn(|lane| 0.3 * libm::sin(first + 3.1 * i as f64 + 1.7 * lane as f64)))
}

fn measures(first: f64) -> Measures {
    let [a, b, c, d, e, f, g, h] = row(first);
    Measures { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] }
}

fn strains(first: f64) -> Strains {
    let [a, b, c, d, e, f, g, h] = row(first);
    Strains { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] }
}

fn lane(of: impl IntoIterator<Item = Pack>, lane: usize) -> Vec<f64> {
    of.into_iter().map(|pack| pack.lanes()[lane]).collect()
}

#[test]
fn measures_side_by_side_are_those_alone() {
    let of: [&'static dyn StrainMeasure; LANES] =
        [&StretchCorrected, &GreenLagrange, &GreenLagrange, &StretchCorrected];
    let pack = StrainPack::new(of);
    let (now, reference) = (measures(1.0), measures(2.0));
    let [a, b, c, d, e, f, g, h] = row(3.0);
    let stress = Resultants { membrane: [a, b, c], moment: [d, e, f], shear: [g, h] };
    let flat = |s: Strains| s.membrane.into_iter().chain(s.curvature).chain(s.shear);
    for (i, alone) in of.into_iter().enumerate() {
        let strained = |of: &dyn StrainMeasure| lane(flat(of.strains(&now, &reference)), i);
        assert_eq!(strained(&pack), strained(alone));
        let back = |of: &dyn StrainMeasure| {
            let f = of.transpose(&now, &reference, &stress);
            lane(f.membrane.into_iter().chain(f.curvature).chain(f.shear), i)
        };
        assert_eq!(back(&pack), back(alone));
        let first = |of: &dyn StrainMeasure| lane(of.gradient(&now, &reference).into_iter().flatten(), i);
        assert_eq!(first(&pack), first(alone));
        let second = |of: &dyn StrainMeasure| {
            lane(of.second_gradient(&now, &reference, &stress).into_iter().flatten(), i)
        };
        assert_eq!(second(&pack), second(alone));
    }
}

/// `∂ψ/∂ε` by differences of a quadratic, which central ones find exactly; a part of the stress is that part of it.
#[test]
fn resultants_under_stress_are_the_derivative_of_the_energy() {
    let section = IsotropicSection::new(Isotropic::new(10.0, 0.3).unwrap(), 0.5).unwrap();
    let initial = [[3.0, -1.0, 0.5, 0.2, 0.4, -0.1]; LANES];
    let mut pack = StressedPack::new(SectionPack::new([&section; LANES], [0.1; LANES]), initial);
    let at = |pack: &StressedPack, k: usize, by: f64| {
        let mut strains = strains(1.0);
        let all = strains.membrane.iter_mut().chain(&mut strains.curvature).chain(&mut strains.shear);
        let slot = all.into_iter().nth(k).unwrap();
        *slot += Pack::splat(by);
        pack.energy(&strains).lanes()[2]
    };
    for share in [1.0, 0.4] {
        pack.set_share(share);
        let found = pack.resultants(&strains(1.0));
        let found = lane(found.membrane.into_iter().chain(found.moment).chain(found.shear), 2);
        for (k, found) in found.into_iter().enumerate() {
            let slope = (at(&pack, k, 0.5) - at(&pack, k, -0.5)) / 1.0;
            assert!((slope - found).abs() < 1e-13, "{k}: {slope} {found}");
        }
        let nothing = pack.resultants(&Strains::default());
        assert_eq!(nothing.membrane[0].lanes()[0], 3.0 * share);
        assert_eq!(pack.energy(&Strains::default()).lanes(), [0.0; LANES]);
    }
}
