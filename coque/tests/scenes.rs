//! Every scene of the repository is read and built; overrides do what they say.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::{Path, PathBuf};

use coque::Scene;
use coque::scene::{Analysis, Formulation, Geometry, LoadKind};

fn scenes() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let mut files: Vec<PathBuf> = [folder.clone(), folder.join("meshes")]
        .iter()
        .flat_map(|folder| fs::read_dir(folder).unwrap())
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    files.sort();
    files
}

fn ring() -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/ring.toml")).unwrap()
}

fn set(pairs: &[(&str, &str)]) -> Result<Scene, coque::SceneError> {
    let pairs: Vec<_> = pairs.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
    Scene::with_overrides(&ring(), "ring.toml", &pairs)
}

#[test]
fn every_scene_builds() {
    assert!(scenes().len() >= 7);
    for path in scenes() {
        let text = fs::read_to_string(&path).unwrap();
        let name = path.to_string_lossy();
        let (_, below) = name.rsplit_once("/scenes/").unwrap();
        assert!(text.contains(&format!("coque run scenes/{below}")), "{name} must say how to run it");
        let scene = Scene::parse(&text, &name).unwrap_or_else(|e| panic!("{name}: {e}"));
        let model = scene.build(1).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(model.describe().particles > 0);
    }
}

#[test]
fn overrides_replace_values_in_tables_and_lists() {
    let scene = set(&[
        ("geometry.plate.particles", "[25, 3]"),
        ("loads[0].couple.moment", "31.4"),
        ("supports.1.symmetry.normal.1", "2.0"),
        ("section.homogeneous.gauss_points", "3"),
        ("title", "coarse"),
    ])
    .unwrap();
    assert_eq!(scene.geometry.particles(), Some([25, 3]));
    assert_eq!(scene.title, "coarse");
    assert_eq!(scene.supports[1].symmetry.unwrap().normal, [0.0, 2.0, 0.0]);
    match scene.loads[0].kinds()[..] {
        [("couple", LoadKind::Couple(couple))] => assert_eq!(couple.moment, 31.4),
        _ => panic!("the load changed its kind"),
    }
}

#[test]
fn naming_another_alternative_drops_the_first() {
    let scene =
        set(&[("formulation.nodal.order", "3"), ("formulation.nodal.kernel", "wendland-c2")]).unwrap();
    match scene.formulation {
        Formulation::Nodal(nodal) => assert_eq!((nodal.order, nodal.smoothing_length()), (3, 1.5)),
        other => panic!("{other:?}"),
    }
    let cylinder = "{ radius = 50.0, angles = [0.0, 10.0], length = 1.0, particles = [9, 3] }";
    let scene = set(&[("geometry.cylinder", cylinder)]).unwrap();
    assert!(matches!(scene.geometry, Geometry::Cylinder(_)));
}

#[test]
fn a_last_override_wins() {
    let scene = set(&[("analysis.explicit.safety", "0.5"), ("analysis.explicit.safety", "0.6")]).unwrap();
    match scene.analysis {
        Analysis::Explicit(explicit) => assert_eq!(explicit.safety, 0.6),
        other => panic!("{other:?}"),
    }
}

#[test]
fn naming_another_analysis_drops_the_first() {
    let scene = set(&[("analysis.static.levels", "10"), ("analysis.static.iterations", "40")]).unwrap();
    match scene.analysis {
        Analysis::Static(path) => assert_eq!((path.levels.list().len(), path.iterations), (10, 40)),
        other => panic!("{other:?}"),
    }
    let back = set(&[("analysis.modal.modes", "3"), ("analysis.explicit.transient.duration", "1.0")]);
    assert!(back.unwrap_err().to_string().contains("record_every"));
}

#[test]
fn all_formulations_build_on_the_ring() {
    for formulation in [
        "{ stress-point = {} }",
        "{ stress-point = { support = 1.4 } }",
        "{ nodal = {} }",
        "{ nodal = { order = 2 } }",
        "{ nodal = { order = 3 } }",
        "{ strong-form = {} }",
    ] {
        let scene = set(&[("formulation", formulation), ("geometry.plate.particles", "[13, 5]")]).unwrap();
        scene.build(1).unwrap_or_else(|e| panic!("{formulation}: {e}"));
    }
}
