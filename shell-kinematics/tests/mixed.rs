//! Sections side by side that need be neither linear nor without memory.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::sync::Arc;

use shell_kinematics::{
    BackStress, Hardening, HistoryPack, Isotropic, IsotropicSection, LANES, MixedSection, Pack, Plastic,
    PlasticPly, PlasticSection, PlyMaterial, Rate, Resultants, Rubber, RubberSection, Section, Strains,
};

fn elastic() -> Isotropic {
    Isotropic::new(100.0, 0.3).unwrap()
}

fn plastic(stress: f64) -> Plastic {
    Plastic::new(elastic(), Hardening::linear(stress, 5.0).unwrap())
}

/// With a back stress that recovers and a yield stress that grows with the rate.
fn in_time(material: Plastic) -> Plastic {
    let rate = Rate::cowper_symonds(40.0, 5.0).unwrap();
    material.recovering(vec![BackStress::new(3.0, 20.0).unwrap()]).unwrap().rated(rate)
}

/// Strains of the points on a way, as large as several times what flows.
fn strains(step: usize) -> Strains {
    let some = |k: usize| {
        Pack::from_fn(|lane| 0.01 * libm::sin((7 * k + 3 * lane + 5 * step) as f64) * (1.0 + step as f64))
    };
    Strains {
        membrane: [some(0), some(1), some(2)],
        curvature: [some(3), some(4), some(5)],
        shear: [some(6), some(7)],
    }
}

fn flat(found: &Resultants) -> Vec<[f64; LANES]> {
    let parts = found.membrane.iter().chain(&found.moment).chain(&found.shear);
    parts.map(|pack| pack.lanes()).collect()
}

#[test]
fn each_point_answers_as_in_a_pack_of_its_own() {
    let sections: [Arc<dyn Section>; LANES] = [
        Arc::new(PlasticSection::new(plastic(0.1), 0.5, 6).unwrap()),
        Arc::new(IsotropicSection::new(elastic(), 0.3).unwrap()),
        Arc::new(RubberSection::new(Rubber::neo_hooke(0.5).unwrap(), 0.2).unwrap()),
        Arc::new(PlasticSection::new(in_time(plastic(0.3)), 0.4, 4).unwrap()),
    ];
    let mut mixed = HistoryPack::new(Arc::new(MixedSection::new(sections.clone(), [0.0; LANES])));
    let mut alone = sections.map(HistoryPack::new);
    for step in 0..5 {
        let now = strains(step);
        let (found, tangent) = (flat(&mixed.resultants(&now)), mixed.tangent(&now));
        let energy = mixed.energy(&now).lanes();
        for (lane, own) in alone.iter().enumerate() {
            let wanted = flat(&own.resultants(&now));
            found.iter().zip(&wanted).for_each(|(a, b)| assert_eq!(a[lane], b[lane]));
            let of = own.tangent(&now);
            for (a, b) in tangent.as_flattened().iter().zip(of.as_flattened()) {
                assert_eq!(a.lanes()[lane], b.lanes()[lane]);
            }
            assert_eq!(energy[lane], own.energy(&now).lanes()[lane]);
        }
        mixed.commit_in(&now, 1e-3);
        alone.iter_mut().for_each(|own| own.commit_in(&now, 1e-3));
        let shares = mixed.kept_share().lanes();
        for (lane, own) in alone.iter().enumerate() {
            assert_eq!(shares[lane], own.kept_share().lanes()[lane]);
        }
    }
    let flowed = mixed.flowed().unwrap().plastic_strain.lanes();
    assert!(flowed[0] > 0.01 && flowed[3] > 0.01 && flowed[1] == 0.0 && flowed[2] == 0.0, "{flowed:?}");
}

#[test]
fn a_raised_section_is_half_of_one_with_an_empty_ply_below() {
    // Two plies, the lower of which bears next to nothing, about the middle of both.
    let weak = Plastic::new(Isotropic::new(1e-12, 0.3).unwrap(), Hardening::linear(1.0, 0.0).unwrap());
    let ply = |material: &Plastic| PlasticPly {
        material: PlyMaterial::Plastic(material.clone(), 5),
        thickness: 0.2,
        angle: 0.0,
    };
    let both = PlasticSection::layered(&[ply(&weak), ply(&plastic(0.1))]).unwrap();
    let one: Arc<dyn Section> = Arc::new(PlasticSection::new(plastic(0.1), 0.2, 5).unwrap());
    let raised = MixedSection::new(std::array::from_fn(|_| Arc::clone(&one)), [0.1; LANES]);
    let now = strains(2);
    let (found, wanted) = (raised.resultants(&now), both.resultants(&now));
    let scale = flat(&wanted).iter().flatten().fold(0.0, |most: f64, value| most.max(value.abs()));
    for (a, b) in flat(&found).iter().flatten().zip(flat(&wanted).iter().flatten()) {
        assert!((a - b).abs() < 1e-10 * scale, "{a} {b}");
    }
    let (found, wanted) = (raised.tangent(&now), both.tangent(&now));
    for (a, b) in found.as_flattened().iter().zip(wanted.as_flattened()) {
        let apart = (*a - *b).lanes().into_iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        assert!(apart < 1e-8, "{apart}");
    }
}
