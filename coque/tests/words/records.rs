//! Courses from files: what they become, where their numbers are kept, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::PathBuf;

use crate::common::ran;
use crate::common::refused::refused;
use coque::scene::Amplitude;
use coque::{Checked, Scene};

const STRIP: &str = r#"
title = "Strip"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [1.0, 0.2], particles = [5, 2] }
material.elastic = { young = 1e7, poisson = 0.0, density = 1000.0 }
section.homogeneous.thickness = 0.05
supports = [{ on = "u0", clamped = {} }]
loads = [{ on = "u1", force = { total = [0, 0, 1] }, amplitude = { record = { file = "push.csv", columns = ["t", "F"], units = ["ms", "kN"], factor = "2 * ${half}" } } }]
analysis.explicit.transient = { duration = 0.02, record_every = 0.005 }
parameters.half = 0.25
[[curve]]
name = "w"
of = "displacement"
on = "u1"
direction = [0, 0, 1]
"#;
const PUSH: &str = "# pushed by hand\nt,other,F\n0,1,0\n4,1,0.5\n9,1,-1\n";

fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("records").join(name);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("push.csv"), PUSH).unwrap();
    fs::write(folder.join("other.csv"), PUSH.replace("0.5", "0.75")).unwrap();
    folder
}

fn points(scene: &Checked) -> Vec<[f64; 2]> {
    match &scene.loads[0].amplitude {
        Some(Amplitude::Table(points)) => points.clone(),
        other => panic!("{other:?}"),
    }
}

fn read(text: &str, folder: &std::path::Path, replaced: &[(String, String)]) -> Checked {
    Scene::with_overrides(text, &folder.join("strip.toml").display().to_string(), replaced).unwrap()
}

#[test]
fn a_file_becomes_a_table_in_the_units_of_the_scene() {
    let folder = folder("units");
    assert_eq!(points(&read(STRIP, &folder, &[])), [[0.0, 0.0], [0.004, 250.0], [0.009, -500.0]]);
    let plain = STRIP.replace(", units = [\"ms\", \"kN\"]", "").replace("[\"t\", \"F\"]", "[1, 3]");
    assert_eq!(points(&read(&plain, &folder, &[])), [[0.0, 0.0], [4.0, 0.25], [9.0, -0.5]]);
}

/// The file is deleted once the run has begun: what is kept beside its results is the same scene, with the numbers of a file that an override named as well.
#[test]
fn what_is_kept_needs_the_file_no_more() {
    let folder = folder("kept");
    let origin = folder.join("strip.toml").display().to_string();
    let other = [("loads[0].amplitude.record.file".to_string(), "other.csv".to_string())]
        .map(|(path, file)| (path, format!("\"{file}\"")));
    let [one, two] = [&[][..], &other].map(|replaced| {
        (read(STRIP, &folder, replaced), Scene::whole_text(STRIP, &origin, replaced).unwrap())
    });
    fs::remove_file(folder.join("push.csv")).unwrap();
    fs::remove_file(folder.join("other.csv")).unwrap();
    assert!(Scene::parse(STRIP, &origin).is_err());
    for ((before, text), replaced) in [(one, &[][..]), (two, &other)] {
        assert!(text.starts_with(STRIP) && text.contains("pushed by hand"), "{text}");
        let after = read(&text, &folder, replaced);
        assert_eq!(points(&before), points(&after));
        // Once more, of a text that holds them: itself.
        assert_eq!(Scene::whole_text(&text, &origin, replaced).unwrap(), text);
        assert_eq!(ran(Ok(before)).curve, ran(Ok(after)).curve);
    }
}

/// A file that an included scene names lies beside that one.
#[test]
fn an_included_record_is_named_from_its_folder() {
    let folder = folder("included");
    fs::create_dir_all(folder.join("stock")).unwrap();
    fs::rename(folder.join("push.csv"), folder.join("stock/push.csv")).unwrap();
    let load = STRIP.lines().find(|line| line.starts_with("loads")).unwrap();
    fs::write(folder.join("stock/load.toml"), format!("{load}\n")).unwrap();
    let text = STRIP.replace(load, "include = [\"stock/load.toml\"]");
    let origin = folder.join("strip.toml").display().to_string();
    let wanted = points(&Scene::parse(&text, &origin).unwrap());
    let whole = Scene::whole_text(&text, &origin, &[]).unwrap();
    fs::remove_dir_all(folder.join("stock")).unwrap();
    assert_eq!(points(&Scene::parse(&whole, &origin).unwrap()), wanted);
}

#[test]
fn what_is_no_record_is_refused() {
    let held = format!(
        "{STRIP}\n[files]\n\"push.csv\" = \"t,F\\n0,0\\n1,1\\n\"\n\"words.csv\" = \"0,0\\n1,x\\n\"\n\"back.csv\" = \"0,0\\n0,1\\n\"\n\"v.AT2\" = \"a\\nb\\nVELOCITY TIME SERIES IN UNITS OF CM/S\\nNPTS= 2, DT= .01\\n1 2\\n\"\n\
         \"short.AT2\" = \"a\\nb\\nACCELERATION TIME SERIES IN UNITS OF G\\nNPTS= 3, DT= .01\\n1 2\\n\"\n"
    );
    let all = "file = \"push.csv\", columns = [\"t\", \"F\"], units = [\"ms\", \"kN\"]";
    let said = refused(
        &held,
        &[
            ("no file", all, "file = \"nothing.csv\""),
            ("a word among numbers", all, "file = \"words.csv\""),
            ("times that stand", all, "file = \"back.csv\""),
            ("a column that there is not", "columns = [\"t\", \"F\"]", "columns = [\"t\", \"G\"]"),
            ("a unit that there is not", "\"kN\"", "\"kgf\""),
            (
                "units of a scene without",
                "{ length = \"m\", force = \"N\", time = \"s\" }",
                "{ length = \"-\", force = \"-\", time = \"-\" }",
            ),
            ("a velocity", all, "file = \"v.AT2\""),
            ("a part of a record", all, "file = \"short.AT2\""),
            ("columns of a record", all, "file = \"short.AT2\", columns = [1, 2]"),
            ("a key that there is not", "factor", "facter"),
            (
                "a record where no time passes",
                "analysis.explicit.transient = { duration = 0.02, record_every = 0.005 }",
                "analysis.linear = {}",
            ),
            (
                "a base without end",
                "record_every = 0.005 }",
                "record_every = 0.005, base = { acceleration = [1, 0, 0], amplitude = { record = { file = \"push.csv\", units = [\"ms\", \"-\"] } } } }",
            ),
        ],
    );
    insta::assert_snapshot!(said);
}
