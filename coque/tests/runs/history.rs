//! A section with memory as a body: its history is part of the state that checkpoints keep.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use coque::Body;
use explicit_dynamics::{Dynamics, Instant, Step};
use shell_kinematics::{
    Isotropic, IsotropicSection, Memory, Pack, Resultants, Section, SectionScales, Strains, StretchCorrected,
};
use sph_core::{EndWeights, Plate, Vec3, lattice};
use sph_shell::{Formulation, Parts, Reach, Shell};

/// Membrane strain along the first axis beyond which half of the stiffness is lost for as long as the point remembers.
const LIMIT: f64 = 1e-3;

/// An elastic section that is half as stiff in a point whose strain was once beyond the limit; nothing here asks for its work.
struct Halved(IsotropicSection);

fn share(strains: &Strains, committed: &[Pack]) -> Pack {
    let (strain, halved) = (strains.membrane[0].lanes(), committed[0].lanes());
    Pack::from_fn(|lane| if halved[lane] > 0.0 || strain[lane] > LIMIT { 0.5 } else { 1.0 })
}

impl Memory for Halved {
    fn history_len(&self) -> usize {
        1
    }

    fn history_from(&self, strains: &Strains, _: f64, committed: &[Pack], trial: &mut [Pack]) -> Resultants {
        trial[0] = share(strains, committed) * -2.0 + Pack::splat(2.0);
        self.resultants_from(strains, committed)
    }

    fn resultants_from(&self, strains: &Strains, committed: &[Pack]) -> Resultants {
        let (mut out, share) = (self.0.resultants(strains), share(strains, committed));
        out.membrane[0] = out.membrane[0] * share;
        out
    }

    fn held_resultants(&self, strains: &Strains, _: &[Pack]) -> Resultants {
        self.0.resultants(strains)
    }

    fn tangent_from(&self, strains: &Strains, _: &[Pack]) -> [[Pack; 8]; 8] {
        self.0.tangent(strains)
    }

    fn energy_from(&self, strains: &Strains, _: &[Pack]) -> Pack {
        self.0.energy(strains)
    }
}

impl Section for Halved {
    fn resultants(&self, strains: &Strains) -> Resultants {
        self.resultants_from(strains, &[Pack::ZERO])
    }

    fn tangent(&self, strains: &Strains) -> [[Pack; 8]; 8] {
        self.0.tangent(strains)
    }

    fn energy(&self, strains: &Strains) -> Pack {
        self.0.energy(strains)
    }

    fn scales(&self) -> SectionScales {
        self.0.scales()
    }

    fn memory(&self) -> Option<&dyn Memory> {
        Some(self)
    }
}

fn elastic() -> IsotropicSection {
    IsotropicSection::new(Isotropic::new(1000.0, 0.0).unwrap(), 0.1).unwrap()
}

/// A free plate that is pulled apart.
fn plate(section: Box<dyn Section>) -> Shell {
    let mut shell = Shell::builder(Parts {
        cloud: lattice(&Plate { lengths: [1.0, 1.0] }, [6, 5], EndWeights::Trapezoid).unwrap(),
        section,
        strain: &StretchCorrected,
        material_axis: Some(Vec3::x()),
        density: 1.0,
        formulation: Formulation::StressPoint(Reach::Cell),
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 1,
    })
    .build()
    .unwrap();
    for a in 0..shell.len() {
        let x = shell.rest_position(a);
        shell.set_rate(a, Vec3::new(x.x * x.x, 0.0, 0.1 * x.y), Vec3::zeros());
    }
    shell
}

fn march(shell: &mut Shell, steps: std::ops::Range<u32>) {
    let dt = 1e-3;
    let at = |number: u32| Instant { time: f64::from(number) * dt, level: 1.0 };
    for n in steps {
        shell.advance(&Step { from: at(n), to: at(n + 1), kick: dt, damping: 0.0 });
    }
}

fn bits(shell: &Shell) -> Vec<u64> {
    shell.state().iter().flat_map(|array| array.numbers.iter().map(|x| x.to_bits())).collect()
}

#[test]
fn a_state_holds_the_history_and_is_taken_up_to_the_same_bits() {
    let mut once = plate(Box::new(Halved(elastic())));
    march(&mut once, 0..20);
    let mut other = plate(Box::new(Halved(elastic())));
    Body::set_state(&mut other, &once.state()).unwrap();
    march(&mut once, 20..40);
    march(&mut other, 20..40);
    assert!(bits(&once) == bits(&other));
    assert!(once.history().contains(&1.0), "no point went beyond its limit");
    // Within the limit, forces are those of what went beyond it; without the history they are not.
    let mut forgetful = plate(Box::new(Halved(elastic())));
    assert!(forgetful.take_up(once.motion()));
    let [known, taken_up, forgotten] = [&mut once, &mut other, &mut forgetful].map(forces_within_the_limit);
    assert!(known == taken_up && known != forgotten);
}

/// Forces on all particles, as bits, of a plate that is stretched by half of the limit.
fn forces_within_the_limit(shell: &mut Shell) -> Vec<u64> {
    for a in 0..shell.len() {
        let x = shell.rest_position(a);
        shell.set_state(a, Vec3::new((1.0 + 0.5 * LIMIT) * x.x, x.y, x.z), Vec3::z());
    }
    shell.evaluate_internal(false);
    (0..shell.len()).flat_map(|a| shell.internal_force(a).map(f64::to_bits)).collect()
}

#[test]
fn the_state_of_another_section_is_refused() {
    let (with, without) = (plate(Box::new(Halved(elastic()))), plate(Box::new(elastic())));
    assert_eq!(without.state().len(), 2);
    assert_eq!(with.state().len(), 3);
    assert!(Body::set_state(&mut plate(Box::new(elastic())), &with.state()).is_err());
    assert!(Body::set_state(&mut plate(Box::new(Halved(elastic()))), &without.state()).is_err());
}
