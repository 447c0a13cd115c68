//! Heat of sections: what it stores, plies of one material, plies that are turned, two metals.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use shell_kinematics::{
    Blocked, Expansion, IntegratedSection, Isotropic, IsotropicSection, LANES, LayeredSection, Orthotropic,
    Pack, Ply, Resultants, Section, SectionPack, Strains, StressedPack,
};

const HEIGHT: f64 = 0.13;

fn steel() -> Isotropic {
    Isotropic::new(10.0, 0.3).unwrap().expanding(2e-3).unwrap()
}

fn carbon() -> Orthotropic {
    Orthotropic::new(140.0, 9.0, 0.3, 5.0, 3.0).unwrap().expanding([-0.5e-3, 3e-2]).unwrap()
}

/// Four points of a section at a height, heated.
fn pack(section: &dyn Section, change: [f64; 2], height: f64) -> StressedPack {
    let mut pack = StressedPack::new(SectionPack::new([section; LANES], [height; LANES]), [[0.0; 6]; LANES]);
    let Blocked { resultants, energy } = section.expansion().unwrap().blocked(change, height);
    pack.put([resultants.map(|n| -n); LANES], [energy; LANES]);
    pack
}

fn strains(membrane: [f64; 3], curvature: [f64; 3]) -> Strains {
    let three = |of: [f64; 3]| of.map(Pack::splat);
    Strains { membrane: three(membrane), curvature: three(curvature), ..Strains::default() }
}

fn forces(found: &Resultants) -> [f64; 6] {
    let own = |i: usize| if i < 3 { found.membrane[i] } else { found.moment[i - 3] };
    std::array::from_fn(|i| own(i).lanes()[1])
}

fn largest(of: impl IntoIterator<Item = f64>) -> f64 {
    of.into_iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// Strained as it would be free, a section of one material bears and stores nothing, whatever its height.
#[test]
fn a_free_section_bears_and_stores_nothing() {
    let (thickness, [change, difference]) = (0.4, [7.0, -3.0]);
    let sections: [Box<dyn Section>; 3] = [
        Box::new(IsotropicSection::new(steel(), thickness).unwrap()),
        Box::new(IntegratedSection::new(steel(), thickness, 3).unwrap()),
        Box::new(
            LayeredSection::new(&[0.1, 0.3].map(|t| Ply {
                material: isotropic_ply(),
                thickness: t,
                angle: 0.7,
            }))
            .unwrap(),
        ),
    ];
    for section in &sections {
        let slope = 2e-3 * difference / thickness;
        let at_particles = 2e-3 * change - HEIGHT * slope;
        let free = strains([at_particles, at_particles, 0.0], [slope, slope, 0.0]);
        let pack = pack(&**section, [change, difference], HEIGHT);
        let left = largest(forces(&pack.resultants(&free)));
        assert!(left < 1e-15, "{left}");
        assert!(pack.energy(&free).lanes()[0].abs() < 1e-16);
        assert!(pack.energy(&Strains::default()).lanes()[0] > 1e-5);
    }
}

/// Steel as a ply: the same along and across.
fn isotropic_ply() -> Orthotropic {
    let shear = 10.0 / 2.6;
    Orthotropic::new(10.0, 10.0, 0.3, shear, shear).unwrap().expanding([2e-3; 2]).unwrap()
}

/// One ply, and plies of one angle, are what their fibre is, turned: strained by α along and across it they are free.
#[test]
fn a_turned_ply_expands_along_and_across_its_fibre() {
    for angle in [0.0, 0.4, -1.2] {
        let plies = [0.1, 0.2].map(|thickness| Ply { material: carbon(), thickness, angle });
        let section = LayeredSection::new(&plies).unwrap();
        let (s, c) = libm::sincos(angle);
        let [l, t] = [-0.5e-3, 3e-2].map(|own| 5.0 * own);
        let membrane = [l * c * c + t * s * s, l * s * s + t * c * c, 2.0 * s * c * (l - t)];
        let pack = pack(&section, [5.0, 0.0], 0.0);
        let left = largest(forces(&pack.resultants(&strains(membrane, [0.0; 3]))));
        assert!(left < 1e-14, "{angle}: {left}");
        assert!(pack.energy(&strains(membrane, [0.0; 3])).lanes()[0].abs() < 1e-14);
    }
}

/// Resultants are the derivative of what is stored, by differences of a quadratic, which central ones find exactly.
#[test]
fn resultants_are_the_derivative_of_what_is_stored() {
    let plies = [(0.1, 0.0), (0.15, 1.1), (0.05, -0.6)];
    let plies = plies.map(|(thickness, angle)| Ply { material: carbon(), thickness, angle });
    let section = LayeredSection::new(&plies).unwrap();
    let pack = pack(&section, [3.0, 8.0], HEIGHT);
    let at = |k: usize, by: f64| {
        let mut all = [0.02, -0.01, 0.03, 0.05, 0.01, -0.04];
        all[k] += by;
        strains([all[0], all[1], all[2]], [all[3], all[4], all[5]])
    };
    let found = forces(&pack.resultants(&at(0, 0.0)));
    for (k, found) in found.into_iter().enumerate() {
        let slope = pack.energy(&at(k, 0.5)).lanes()[0] - pack.energy(&at(k, -0.5)).lanes()[0];
        assert!((slope - found).abs() < 1e-13, "{k}: {slope} {found}");
    }
}

/// Two metals on each other, free: the curvature of \[timoshenko1925\].
#[test]
fn two_metals_bend_as_timoshenko_says() {
    let [thin, thick] = [0.3, 0.5];
    let metal = |young: f64, expansion: f64| {
        let shear = young / 2.6;
        Orthotropic::new(young, young, 0.3, shear, shear).unwrap().expanding([expansion; 2]).unwrap()
    };
    let (below, above) = (metal(100.0, 19e-6), metal(200.0, 11e-6));
    let plies =
        [(below, thin), (above, thick)].map(|(material, thickness)| Ply { material, thickness, angle: 0.0 });
    let pack = pack(&LayeredSection::new(&plies).unwrap(), [100.0, 0.0], 0.0);
    // Alike in all directions: two unknowns, the strain and the curvature that leave no force.
    let at = |e: f64, k: f64| {
        let found = forces(&pack.resultants(&strains([e, e, 0.0], [k, k, 0.0])));
        [found[0], found[3]]
    };
    let ([n0, m0], [n1, m1], [n2, m2]) = (at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0));
    let ([a, b], [c, d]) = ([n1 - n0, n2 - n0], [m1 - m0, m2 - m0]);
    let curvature = (c * n0 - a * m0) / (a * d - b * c);
    // m and n of the metal that expands less over that which expands more.
    let (m, n) = (thick / thin, 200.0_f64 / 100.0);
    let bend = 3.0 * (1.0 + m).powi(2) + (1.0 + m * n) * (m * m + 1.0 / (m * n));
    let exact = -6.0 * 8e-6 * 100.0 * (1.0 + m).powi(2) / ((thin + thick) * bend);
    assert!((curvature / exact - 1.0).abs() < 1e-12, "{curvature} {exact}");
}

#[test]
fn what_does_not_say_how_it_expands_has_no_expansion() {
    let silent = Isotropic::new(10.0, 0.3).unwrap();
    let none: Option<Expansion> = None;
    assert_eq!(IsotropicSection::new(silent, 0.1).unwrap().expansion(), none);
    let ply = |material| Ply { material, thickness: 0.1, angle: 0.0 };
    let bare = Orthotropic::new(140.0, 9.0, 0.3, 5.0, 3.0).unwrap();
    assert_eq!(LayeredSection::new(&[ply(carbon()), ply(bare)]).unwrap().expansion(), none);
    assert!(silent.expanding(f64::NAN).is_err() && bare.expanding([0.0, f64::INFINITY]).is_err());
}
