//! Courses from files: what they become, where their numbers are kept, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::PathBuf;

use crate::common::refused::refused;
use crate::common::{ran, scenes};
use coque::scene::{Amplitude, Analysis};
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

/// What an override replaces is not asked for; of a sweep the files of all its runs are held, and a run without its file is refused alone.
#[test]
fn only_files_of_what_is_run_are_held() {
    let folder = folder("replaced");
    fs::remove_file(folder.join("push.csv")).unwrap();
    fs::write(folder.join("third.csv"), PUSH.replace("0.5", "0.25")).unwrap();
    let origin = folder.join("strip.toml").display().to_string();
    let by = |file: &str| vec![("loads[0].amplitude.record.file".to_string(), format!("\"{file}\""))];
    let other = by("other.csv");
    let wanted = points(&read(STRIP, &folder, &other));
    let text = Scene::whole_text(STRIP, &origin, &other).unwrap();
    assert!(Scene::whole_text(STRIP, &origin, &[]).is_err());
    let all =
        Scene::whole_text_of(STRIP, &origin, &[other.clone(), by("none.csv"), by("third.csv")]).unwrap();
    fs::remove_file(folder.join("other.csv")).unwrap();
    fs::remove_file(folder.join("third.csv")).unwrap();
    assert_eq!(points(&read(&text, &folder, &other)), wanted);
    assert_eq!(points(&read(&all, &folder, &other)), wanted);
    assert_eq!(points(&read(&all, &folder, &by("third.csv")))[1], [0.004, 125.0]);
    assert!(Scene::with_overrides(&all, &origin, &by("none.csv")).is_err());
}

/// Of CSV and of .AT2, ending at zero or not: the base is at rest where it began when the record is over, and the run goes on.
#[test]
fn a_base_with_a_baseline_ends_at_rest() {
    let deck = fs::read_to_string(scenes().join("deck-in-quake.toml")).unwrap();
    let short = "[files]\n\"a.csv\" = \"0,1\\n0.002,-3\\n0.005,2\\n\"\n\"b.csv\" = \"0.001,1\\n0.002,-3\\n0.005,2\\n0.01,0\\n\"\n";
    let on = |file: &str| {
        let base = format!(
            "record_every = 0.005, base = {{ acceleration = [1, 0, 0], amplitude = {{ record = {{ file = \"{file}\", baseline = \"linear\" }} }} }} }}"
        );
        let load = STRIP.lines().find(|line| line.starts_with("loads")).unwrap();
        STRIP.replace(load, "").replace("record_every = 0.005 }", &base) + short
    };
    for (text, end) in [(on("a.csv"), 0.008), (on("b.csv"), 0.01), (deck, 7.98)] {
        let scene = Scene::parse(&text, "scene.toml").unwrap();
        let Analysis::Explicit(explicit) = &scene.analysis else { panic!() };
        let base = explicit.transient.as_ref().unwrap().base.as_ref().unwrap();
        let Amplitude::Table(points) = &base.amplitude else { panic!() };
        let [at, last] = points[points.len() - 1];
        assert!((at - end).abs() < 1e-12 && last == 0.0, "{at} {last}");
        let most = points.iter().fold(0.0_f64, |most, [_, x]| most.max(x.abs()));
        let [v, u] = base.amplitude.integrals(at);
        // Rounding of sums of four hundred numbers.
        assert!(most > 0.1 && v.abs() < 1e-14 * most * at && u.abs() < 1e-14 * most * at * at, "{v} {u}");
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
         \"short.AT2\" = \"a\\nb\\nACCELERATION TIME SERIES IN UNITS OF G\\nNPTS= 3, DT= .01\\n1 2\\n\"\n\
         \"g.AT2\" = \"a\\nb\\nACCELERATION TIME SERIES IN UNITS OF G\\nNPTS= 3, DT= .01\\n1 2 0\\n\"\n\"letter.csv\" = \"0,1.O\\n1,2\\n\"\n\
         \"names.csv\" = \"time [s] a b\\n0 1 2\\n\"\n\"two.csv\" = \"0,1\\n1,0\\n\"\n"
    );
    let transient = "record_every = 0.005 }";
    let base = |record: &str| {
        format!(
            "record_every = 0.005, base = {{ acceleration = [1, 0, 0], amplitude = {{ record = {{ {record} }} }} }} }}"
        )
    };
    let base_in_kn = base("file = \"push.csv\", units = [\"ms\", \"kN\"]");
    let base_of_two = base("file = \"two.csv\", baseline = \"linear\"");
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
            ("a word in the first row", all, "file = \"letter.csv\""),
            ("names with blanks between blanks", all, "file = \"names.csv\", columns = [\"time\", \"a\"]"),
            ("times in metres", "\"ms\", \"kN\"", "\"mm\", \"kN\""),
            ("a force in metres", "\"ms\", \"kN\"", "\"ms\", \"mm\""),
            ("a base in newtons", transient, &base_in_kn),
            (
                "a change of temperature in newtons",
                "force = { total = [0, 0, 1] }",
                "temperature = { change = 1.0 }",
            ),
            ("milliseconds of an .AT2", all, "file = \"g.AT2\", units = [\"ms\", \"-\"]"),
            ("metres of an .AT2", all, "file = \"g.AT2\", units = [\"s\", \"m/s^2\"]"),
            ("a force in g", all, "file = \"g.AT2\""),
            ("a line off two points", transient, &base_of_two),
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

/// The first numbers of a spectrum by frequency are frequencies, in its own table and in those of its dampings; by period they are times.
#[test]
fn a_spectrum_by_frequency_has_frequencies() {
    let folder = folder("by_frequency");
    fs::write(folder.join("push.csv"), "f,S\n0.01,0.5\n0.04,1\n").unwrap();
    let spectrum = |by: &str, unit: &str, course: &str| {
        let record =
            format!("amplitude = {{ record = {{ file = \"push.csv\", units = [\"{unit}\", \"g\"] }} }}");
        let record = if course == "#" { record } else { record.replace("\"g\"", "\"-\"") };
        let course = course.replace('#', &record);
        let loads = STRIP.find("loads = ").unwrap()..STRIP.find("analysis").unwrap();
        let mut text = STRIP.to_string();
        text.replace_range(loads, "");
        let base = format!("base = [{{ acceleration = [0, 0, 1], by = \"{by}\", {course} }}]");
        text = text.replace(
            "explicit.transient = { duration = 0.02, record_every = 0.005 }",
            &format!("response-spectrum = {{ modes = 2, damping.ratio = 0.05, {base} }}"),
        );
        Scene::with_overrides(&text, &folder.join("strip.toml").display().to_string(), &[])
    };
    // A spectrum for one damping stands apart from the acceleration that it multiplies.
    for (course, g) in [("#", 9.806_65), ("damped = [{ ratio = 0.05, # }]", 1.0)] {
        let scene = spectrum("frequency", "kHz", course).unwrap();
        let Analysis::ResponseSpectrum(wanted) = &scene.analysis else { panic!() };
        let curves = wanted.base[0].spectrum().curves;
        assert_eq!(curves[0].1, [[10.0, 0.5 * g], [40.0, g]], "{course}");
        assert!(spectrum("frequency", "ms", course).is_err(), "{course}");
        assert!(spectrum("period", "kHz", course).is_err() && spectrum("period", "ms", course).is_ok());
    }
}
