//! Dynamic relaxation of the particle shell finds what Newton's method finds.

use std::ops::ControlFlow;

use crate::common::{energy_formulations, flat, shell};
use explicit_dynamics::Amplitude;
use implicit_statics::{
    Control, Damping, End, Equilibrium, PathOptions, RelaxationOptions, Start, follow, relax,
};
use shell_kinematics::strain_measures;
use sph_core::{Side, Vec3};
use sph_shell::{Clamped, Force, Load, Moved, Rotated, StaticShell, Support, Supported};

/// A strip clamped at one end; its other end is pushed aside, shortened or turned.
fn strip(formulation: usize, loads: Vec<Box<dyn Load>>, end: Option<Box<dyn Support>>) -> StaticShell {
    let cloud = flat([9, 3], [4.0, 1.0]);
    let edge = |side| cloud.sides.as_ref().unwrap().edge(side).to_vec();
    let mut supports = vec![Supported { particles: edge(Side::U0), support: Box::new(Clamped) }];
    supports.extend(end.map(|support| Supported { particles: edge(Side::U1), support }));
    let (formulation, strain) = (energy_formulations()[formulation].1, strain_measures()[0]);
    StaticShell::new(shell(cloud, formulation, 0.1, strain, supports, loads))
}

#[test]
fn relaxation_finds_what_newton_finds() {
    let amplitude = Amplitude::Constant;
    let aside = || -> Vec<Box<dyn Load>> {
        let shares = vec![(8, 1.0), (17, 2.0), (26, 1.0)];
        vec![Box::new(Force { shares, total: Vec3::new(0.0, 0.0, 5e-3) })]
    };
    let turned = Rotated { axis: -Vec3::y(), by: 1.0, amplitude: amplitude.clone() };
    let lifted = Moved { direction: Vec3::z(), by: 1.0, amplitude };
    let systems = [
        ("pushed, cells", strip(0, aside(), None)),
        ("pushed, nodal", strip(4, aside(), None)),
        ("turned", strip(0, Vec::new(), Some(Box::new(turned)))),
        ("lifted", strip(0, Vec::new(), Some(Box::new(lifted)))),
    ];
    for (name, mut system) in systems {
        let rest = system.save();
        let load = PathOptions::new(Control::Load { step: 0.25, until: 1.0 });
        let path = follow(&mut system, &Start::default(), &load, |_, _| ControlFlow::Continue(()));
        assert_eq!(path.end, Ok(End::Reached));
        let exact = system.save();
        let way = exact.iter().zip(&rest).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
        assert!(way > 0.5, "{name}: {way} is no large deflection of a strip of 4");
        for damping in [Damping::Kinetic, Damping::Rayleigh] {
            system.restore(&rest);
            let options = RelaxationOptions { damping, ..RelaxationOptions::default() };
            let found = relax(&mut system, &options, (0.0, 1.0), |_| ControlFlow::Continue(())).unwrap();
            let off = system.save().iter().zip(&exact).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs())) / way;
            println!("{name}, {damping:?}: {off:.1e} after {} evaluations", found.evaluations);
            assert!(off < 1e-4, "{name}, {damping:?}: {off:.1e} after {found:?}");
        }
    }
}
