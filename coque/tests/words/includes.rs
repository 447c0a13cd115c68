//! Files that a scene includes: the same model as with all of it in one text, in whatever folder they lie; what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::common::ran;
use crate::common::sittings::stopped_again_and_again;
use coque::{Checked, Rendering, Scene, SceneError, render};

const WHOLE: &str = r#"title = "Strip"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [10.0, 1.0], particles = [21, 3] }
material.elastic = { young = 2e6, poisson = 0.0, density = 2.0 }
section.homogeneous.thickness = 0.2
supports = [{ on = "u0", clamped = {} }, { on = "u1", held = { displacement = [[0, 0, 1]] } }]
loads = [{ on = "half", pressure = { value = 1.0 } }]
curve = [{ name = "w", of = "displacement", on = "middle", direction = [0.0, 0.0, 1.0] }]
[analysis.static]
levels = 2
[sets]
half.box = { min = [0.0, 0.0, 0.0], max = [5.0, 1.0, 0.0] }
middle.nearest = [5.0, 0.5, 0.0]
"#;

/// The same: its material from a folder beside it, its supports of two files, a set and an analysis that it has of its own.
const FILES: [(&str, &str); 4] = [
    (
        "strip.toml",
        r#"title = "Strip"
units = { length = "m", force = "N", time = "s" }
include = ["stock/steel.toml", "ends.toml"]
geometry.plate = { lengths = [10.0, 1.0], particles = [21, 3] }
section.homogeneous.thickness = "2 * ${t}"
supports = [{ on = "u0", clamped = {} }]
[material.elastic]
young = 2e6
[analysis.static]
levels = 2
[sets.half]
box = { min = [0.0, 0.0, 0.0], max = [5.0, 1.0, 0.0] }
"#,
    ),
    (
        "stock/steel.toml",
        "include = [\"../common.toml\"]\nunits.length = \"m\"\nmaterial.elastic = { young = 1.0, poisson = 0.0, density = 2.0 }\n\
         analysis.linear = {}\n",
    ),
    (
        "ends.toml",
        "include = [\"common.toml\"]\nsupports = [{ on = \"u1\", held = { displacement = [[0, 0, 1]] } }]\n\
         curve = [{ name = \"w\", of = \"displacement\", on = \"middle\", direction = [0.0, 0.0, 1.0] }]\n",
    ),
    (
        "common.toml",
        "parameters.t = 0.1\nsets = { half.nearest = [0, 0, 0], middle.nearest = [5.0, 0.5, 0.0] }\n\
         loads = [{ on = \"half\", pressure = { value = 1.0 } }]\n",
    ),
];

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("includes").join(name);
    let _ = fs::remove_dir_all(&folder);
    for (file, text) in FILES {
        let file = folder.join(file);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, text).unwrap();
    }
    folder
}

fn read(folder: &Path) -> Result<Checked, SceneError> {
    let file = folder.join("strip.toml");
    Scene::parse(&fs::read_to_string(&file).unwrap(), &file.display().to_string())
}

fn said(scene: &Checked) -> String {
    format!(
        "{:?}",
        (&scene.bodies, &scene.sets, &scene.supports, &scene.loads, &scene.analysis, &scene.curve)
    )
}

#[test]
fn a_scene_of_several_files_is_that_of_one() {
    let folder = folder("whole");
    let (whole, of_files) = (Scene::parse(WHOLE, "whole.toml").unwrap(), read(&folder).unwrap());
    assert_eq!(said(&whole), said(&of_files));
    let file = folder.join("strip.toml").display().to_string();
    let text = Scene::whole_text(FILES[0].1, &file, &[]).unwrap();
    assert!(text.contains("[parameters]\nt = 0.1\n") && !text.contains("include ="), "{text}");
    let again = Scene::parse(&text, "elsewhere/strip.toml").unwrap();
    assert_eq!(said(&whole), said(&again));
    assert_eq!(ran(Ok(whole)).curve, ran(Ok(of_files)).curve);
    // Without files a text is itself.
    assert_eq!(Scene::whole_text(WHOLE, "whole.toml", &[]).unwrap(), WHOLE);
}

/// A mesh that an included file names lies beside that file.
#[test]
fn files_are_named_from_where_they_are_named() {
    let folder = folder("meshes");
    let plate = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    fs::write(folder.join("stock/plate.obj"), plate).unwrap();
    fs::write(folder.join("stock/mesh.toml"), "geometry.mesh = { file = \"plate.obj\" }\n").unwrap();
    let text = FILES[0].1.replace("geometry.plate = { lengths = [10.0, 1.0], particles = [21, 3] }\n", "");
    let text = text.replace("[\"stock/steel.toml\"", "[\"stock/mesh.toml\", \"stock/steel.toml\"");
    let file = folder.join("strip.toml").display().to_string();
    let mesh = |text: &str| {
        let scene = Scene::parse(text, &file).unwrap();
        scene.as_shell().unwrap().geometry.mesh().unwrap().file.clone()
    };
    assert_eq!(mesh(&text), "stock/plate.obj");
    assert_eq!(mesh(&Scene::whole_text(&text, &file, &[]).unwrap()), "stock/plate.obj");
}

#[test]
fn what_cannot_be_included() {
    let steel = FILES[1].1;
    let cases: [(&str, &str, String); 9] = [
        ("a file that is not there", "ends.toml", FILES[2].1.replace("common.toml", "comon.toml")),
        ("a folder", "ends.toml", FILES[2].1.replace("common.toml", "stock")),
        ("a circle", "common.toml", "include = [\"stock/steel.toml\"]\n".into()),
        ("the scene itself", "common.toml", "include = [\"strip.toml\"]\n".into()),
        ("no list", "ends.toml", "include = \"common.toml\"\n".into()),
        ("no TOML", "ends.toml", "supports = [\n".into()),
        ("other units", "stock/steel.toml", steel.replace("length = \"m\"", "length = \"mm\"")),
        ("a value beyond its bound", "stock/steel.toml", steel.replace("poisson = 0.0", "poisson = 0.5")),
        ("an unknown key", "ends.toml", format!("{}\nlods = []\n", FILES[2].1)),
    ];
    let mut all = String::new();
    for (name, file, text) in cases {
        let folder = folder("refused");
        fs::write(folder.join(file), text).unwrap();
        let error = read(&folder).expect_err(name);
        let shown = render(&error, Rendering { width: 200, colour: false });
        let shown = shown.replace(&folder.display().to_string(), "FOLDER").replace('\\', "/");
        all.push_str(&format!("━━━ {name} ━━━\n{shown}"));
    }
    insta::assert_snapshot!(all);
}

fn coque(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_coque")).args(arguments).current_dir(folder).output().unwrap()
}

/// The copy in the folder of a run holds all of it: it runs again after the files have gone.
#[test]
fn the_copy_of_a_scene_needs_none_of_its_files() {
    let folder = folder("copied");
    let run = coque(&folder, &["run", "strip.toml", "--out", "first", "--set", "parameters.t=0.05"]);
    assert_eq!(run.status.code(), Some(0), "{}", String::from_utf8_lossy(&run.stderr));
    for (file, _) in FILES {
        fs::remove_file(folder.join(file)).unwrap();
    }
    let again = coque(&folder, &["run", "first/scene.toml", "--out", "second", "--set", "parameters.t=0.05"]);
    assert_eq!(again.status.code(), Some(0), "{}", String::from_utf8_lossy(&again.stderr));
    let curve = |run: &str| fs::read_to_string(folder.join(run).join("curve.csv")).unwrap();
    assert_eq!(curve("first"), curve("second"));
}

/// A run that was stopped goes on after the files have gone.
#[test]
fn a_run_goes_on_without_the_files_of_its_scene() {
    let folder = folder("resumed");
    let text = Scene::whole_text(FILES[0].1, &folder.join("strip.toml").display().to_string(), &[]).unwrap();
    fs::remove_dir_all(&folder).unwrap();
    stopped_again_and_again("included", &text, &[("analysis.static.levels", "8")], 2);
}
