//! Every scene of the repository is read and built; overrides do what they say.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::{Path, PathBuf};

use coque::scene::{Analysis, Formulation, Geometry, LoadKind, RelaxationDamping};
use coque::{Checked, Scene, Silent};

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

fn set(pairs: &[(&str, &str)]) -> Result<Checked, coque::SceneError> {
    let pairs: Vec<_> = pairs.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
    Scene::with_overrides(&ring(), "ring.toml", &pairs)
}

/// A scene whose shell stands at the top, with the body and its sets named.
fn in_the_long_form(text: &str) -> String {
    let mut scene: toml::Table = text.parse().unwrap();
    let keys = [
        "geometry",
        "orientation",
        "material",
        "section",
        "parts",
        "masses",
        "ties",
        "stiffeners",
        "rigid",
        "tools",
        "initial_stress",
        "formulation",
        "velocity",
    ];
    let shell = keys.into_iter().filter_map(|key| scene.remove_entry(key)).collect::<toml::Table>();
    for list in ["supports", "loads", "curve", "heat", "links"] {
        for item in scene.get_mut(list).and_then(|list| list.as_array_mut()).into_iter().flatten() {
            let long = |on: &toml::Value| toml::Value::from(format!("shell.{}", on.as_str().unwrap()));
            item["on"] = match &item["on"] {
                toml::Value::Array(names) => names.iter().map(long).collect::<Vec<_>>().into(),
                name => long(name),
            };
        }
    }
    let one = |name: &str, of: toml::Table| toml::Table::from_iter([(name.into(), of.into())]);
    scene.extend(one("bodies", one("shell", one("shell", shell))));
    scene.to_string()
}

/// All that a scene says, exactly.
fn said(scene: Checked) -> String {
    let Scene {
        title,
        units,
        include: _,
        files,
        parameters,
        bodies,
        sets,
        supports,
        loads,
        contact,
        glue,
        heat,
        links,
        joints,
        analysis,
        coupling,
        curve,
        output,
        error,
        is_load_set: _,
        source: _,
        surfaces: _,
        arrays: _,
    } = scene.into_scene();
    format!(
        "{:?}",
        (
            title,
            (units, parameters, files),
            bodies,
            sets,
            supports,
            (loads, contact, glue, heat, links, joints),
            (analysis, coupling),
            curve,
            (output, error)
        )
    )
}

#[test]
fn both_forms_say_the_same() {
    let short = |path: &PathBuf| !fs::read_to_string(path).unwrap().contains("[bodies.");
    for path in scenes().into_iter().filter(short) {
        let (text, name) = (fs::read_to_string(&path).unwrap(), path.to_string_lossy());
        let long = in_the_long_form(&text);
        let [short, long] = [&text, &long].map(|text| Scene::parse(text, &name).unwrap());
        assert_eq!(short.bodies.keys().next().unwrap(), "shell");
        assert_eq!(said(short), said(long), "{name}");
    }
    let text = fs::read_to_string(scenes()[0].with_file_name("patch-test.toml")).unwrap();
    let run = |text: &str| Scene::parse(text, "patch-test.toml").unwrap().build(1).unwrap().run(&mut Silent);
    let (short, long) = (run(&text), run(&in_the_long_form(&text)));
    assert_eq!(short.curve, long.curve);
    assert_eq!(short.shapes, long.shapes);
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
    assert_eq!(scene.as_shell().and_then(|shell| shell.geometry.particles()), Some([25, 3]));
    assert_eq!(scene.title, "coarse");
    assert_eq!(scene.supports[1].symmetry.unwrap().normal, [0.0, 2.0, 0.0]);
    match scene.loads[0].kinds()[..] {
        [("couple", LoadKind::Couple(couple))] => assert_eq!(couple.moment, 31.4),
        _ => panic!("the load changed its kind"),
    }
}

#[test]
fn overrides_append_to_lists() {
    let one = r#"{ on = "u1", force = { total = [0, 0, 1] } }"#;
    let scene = set(&[
        ("loads[+]", one),
        ("loads.+", one),
        ("loads[2].force.total[1]", "2.0"),
        ("sets.tip.nearest", "[10, 0, 0]"),
    ])
    .unwrap();
    let totals: Vec<_> = scene.loads.iter().map(|load| load.force.map(|force| force.total)).collect();
    assert_eq!(totals, [None, Some([0.0, 0.0, 1.0]), Some([0.0, 2.0, 1.0])]);
    assert_eq!(set(&[("title[+]", "3.0")]).unwrap_err().code(), "scene::override");
    // A list that is not there begins with its first item.
    let none = ring()
        .replace("[[loads]]", "[[no-loads]]")
        .lines()
        .take_while(|line| *line != "[[no-loads]]")
        .map(|line| format!("{line}\n"))
        .collect::<String>();
    let pairs = [("loads[+]", one), ("analysis.modal.modes", "1")]
        .map(|(path, value)| (path.to_string(), value.to_string()));
    assert_eq!(Scene::with_overrides(&none, "ring.toml", &pairs).unwrap().loads.len(), 1);
}

#[test]
fn a_relaxation_has_defaults() {
    match set(&[("analysis.relaxation.levels", "4")]).unwrap().into_scene().analysis {
        Analysis::Relaxation(path) => {
            assert_eq!(
                (path.levels.list().len(), path.tolerance.get(), path.damping, path.iterations.get()),
                (4, 1e-6, RelaxationDamping::Kinetic, 100_000)
            );
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn naming_another_alternative_drops_the_first() {
    let scene =
        set(&[("formulation.nodal.order", "3"), ("formulation.nodal.kernel", "wendland-c2")]).unwrap();
    match &scene.as_shell().unwrap().formulation {
        Formulation::Nodal(nodal) => assert_eq!((nodal.order.get(), nodal.smoothing_length()), (3, 1.5)),
        other => panic!("{other:?}"),
    }
    let cylinder = "{ radius = 50.0, angles = [0.0, 10.0], length = 1.0, particles = [9, 3] }";
    let scene = set(&[("geometry.cylinder", cylinder)]).unwrap();
    assert!(matches!(scene.as_shell().unwrap().geometry, Geometry::Cylinder(_)));
}

#[test]
fn a_last_override_wins() {
    let scene = set(&[("analysis.explicit.safety", "0.5"), ("analysis.explicit.safety", "0.6")]).unwrap();
    match scene.into_scene().analysis {
        Analysis::Explicit(explicit) => assert_eq!(explicit.safety.get(), 0.6),
        other => panic!("{other:?}"),
    }
}

#[test]
fn naming_another_analysis_drops_the_first() {
    let scene = set(&[("analysis.static.levels", "10"), ("analysis.static.iterations", "40")]).unwrap();
    match scene.into_scene().analysis {
        Analysis::Static(path) => assert_eq!((path.levels.list().len(), path.iterations.get()), (10, 40)),
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
