//! Probes: what one number of the method, changed, changes of the answers.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{self, ran, scene};
use coque::scene::GalerkinSupport;
use coque::{Checked, Errors, Silent};

fn errors(scene: &Checked) -> Errors {
    let outcome = scene.build(1).unwrap().run(&mut Silent);
    scene.errors(&outcome, 1, &mut Silent)
}

#[test]
fn a_probe_is_the_difference_of_two_runs() {
    let ring = scene("thick-ring-solid.toml", &[("error", "{ probes = [\"support\"] }")]).unwrap();
    let errors = errors(&ring);
    let lattices = ring.companions(1).unwrap().lattices;
    // Too few cells across for a coarser one: its own is the coarsest.
    assert!(lattices.iter().all(|companion| companion.spacing < 1.0));
    let [probe] = &errors.probes[..] else { panic!("{:?}", errors.lacks) };
    assert_eq!(probe.lattice, "its own lattice");
    let mut wide = ring.clone().into_scene();
    let solid = wide.bodies.values_mut().next().unwrap();
    let coque::scene::BodyScene::Solid(solid) = solid else { panic!("a solid") };
    let coque::scene::SolidFormulation::Galerkin(galerkin) = &mut solid.formulation else {
        panic!("Galerkin")
    };
    galerkin.support = Some(GalerkinSupport::Ellipsoid(coque::scene::PerAxis::Same(1.2 * 2.5)));
    let [wide, usual] = [ran(wide.check()).curve, ran(Ok(ring.clone())).curve];
    for column in ["w_crown", "u_side"] {
        let found = probe.columns.iter().find(|found| found.name == column).unwrap();
        let change = wide.column(column).unwrap()[0] - usual.column(column).unwrap()[0];
        assert!(change != 0.0);
        assert_eq!(found.last.unwrap().to_bits(), change.to_bits());
        assert_eq!(found.greatest, change.abs());
    }
    // What a probe tells is left out no longer.
    assert!(errors.lacks.iter().all(|words| !words.contains("support")), "{:?}", errors.lacks);
}

#[test]
fn half_the_step_changes_a_march_by_less_than_its_lattice_does() {
    let plate = r#"
        title = "A plate let go"
        units = { length = "m", force = "N", time = "s" }
        geometry.plate = { lengths = [1.0, 0.5], particles = [17, 9] }
        material.elastic = { young = 1e6, poisson = 0.3, density = 1.0 }
        section.homogeneous = { thickness = 0.05 }
        supports = [{ on = "u0", clamped = {} }]
        loads = [{ on = "u1", force = { total = [0.0, 0.0, 1.0] } }]
        analysis.explicit.transient = { duration = 0.1, record_every = 0.02 }
        curve = [{ name = "w", of = "displacement", on = "u1", direction = [0.0, 0.0, 1.0] }]
        error = { probes = ["step", "horizon"] }
    "#;
    let errors = errors(&common::overridden(plate, "plate.toml", &[]).unwrap());
    let [step] = &errors.probes[..] else { panic!("{:?}", errors.lacks) };
    let widest = errors.of("w").unwrap().bars.iter().filter_map(|bar| bar.bar).fold(0.0, f64::max);
    assert!(step.columns[0].greatest > 0.0 && step.columns[0].greatest < widest, "{step:?}, {widest}");
    assert!(errors.lacks.iter().any(|words| words.contains("nothing for the probe `horizon`")));
    assert!(errors.lacks.iter().any(|words| words == "time between records"));
}

#[test]
fn a_sound_speed_is_probed_in_the_fluid() {
    let set = [
        ("analysis.explicit.transient.duration", "0.02"),
        ("analysis.explicit.transient.record_every", "0.01"),
        ("error", "{ probes = [\"sound-speed\", \"smoothing\"] }"),
    ];
    let errors = errors(&scene("dam-break.toml", &set).unwrap());
    assert_eq!(errors.probes.len(), 2, "{:?} {:?}", errors.lacks, errors.without);
    assert!(errors.probes.iter().all(|probe| probe.columns.iter().any(|column| column.greatest > 0.0)));
}
