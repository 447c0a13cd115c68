//! Sweeps: every combination, one table, whatever becomes of a run.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use coque::{Scene, Silent};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn sweep(name: &str, arguments: &[&str]) -> (Output, PathBuf) {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("sweep").join(name);
    let _ = fs::remove_dir_all(&out);
    let output = Command::new(env!("CARGO_BIN_EXE_coque"))
        .args(["sweep", "scenes/patch-test.toml", "--out"])
        .arg(&out)
        .args(arguments)
        .current_dir(root())
        .output()
        .unwrap();
    (output, out)
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn the_table_holds_every_combination_and_the_last_row_of_each_curve() {
    let over = ["--over", "material.elastic.young=1e5,2e5", "--over", "material.elastic.poisson=0.1,0.2,0.3"];
    let (output, out) = sweep("all", &[&over[..], &["--jobs", "3"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    assert!(said(&output).contains("6 of 6 runs done"), "{}", said(&output));
    let table = fs::read_to_string(out.join("sweep.csv")).unwrap();
    let mut rows = table.lines();
    let head =
        "run,material.elastic.young,material.elastic.poisson,ended,warnings,wall [s],time [s],level [-],";
    assert!(rows.next().unwrap().starts_with(head), "{table}");
    let text = fs::read_to_string(root().join("scenes/patch-test.toml")).unwrap();
    for (number, row) in rows.enumerate() {
        let cells: Vec<&str> = row.split(',').collect();
        let (young, poisson) = (["1e5", "2e5"][number / 3], ["0.1", "0.2", "0.3"][number % 3]);
        assert_eq!(cells[..5], [&(number + 1).to_string(), young, poisson, "done", ""]);
        let replaced = [("young", young), ("poisson", poisson)]
            .map(|(key, value)| (format!("material.elastic.{key}"), value.to_string()));
        let scene = Scene::with_overrides(&text, "patch-test.toml", &replaced).unwrap();
        let alone = scene.build(1).unwrap().run(&mut Silent);
        let last: Vec<String> = alone.curve.rows.last().unwrap().iter().map(|x| format!("{x:?}")).collect();
        assert_eq!(cells[6..], last);
        assert!(out.join(format!("{:03}/curve.csv", number + 1)).exists());
    }
    assert_eq!(table.lines().count(), 7);
}

/// Of modes every one is a row, with the number and the values of its run.
#[test]
fn all_modes_of_a_run_are_in_the_table() {
    let over =
        ["--set", "analysis={ modal = { modes = 3 } }", "--over", "section.homogeneous.thickness=0.01,0.02"];
    let (output, out) = sweep("modes", &over);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let table = fs::read_to_string(out.join("sweep.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|row| row.split(',').collect()).collect();
    assert_eq!(rows[0][5..7], ["mode [-]", "circular_frequency [1/s]"], "{table}");
    let found: Vec<[&str; 3]> = rows[1..].iter().map(|row| [row[0], row[1], row[5]]).collect();
    let expected = |run: &'static str, value| ["1.0", "2.0", "3.0"].map(|mode| [run, value, mode]);
    assert_eq!(found, [expected("1", "0.01"), expected("2", "0.02")].concat());
    for run in ["001", "002"] {
        assert_eq!(fs::read_to_string(out.join(run).join("curve.csv")).unwrap().lines().count(), 4);
    }
}

/// Of load cases and combinations too; a march whose column is called so has its last row.
#[test]
fn all_cases_of_a_run_are_in_the_table() {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("sweep/cases");
    let _ = fs::remove_dir_all(&out);
    let output = Command::new(env!("CARGO_BIN_EXE_coque"))
        .args(["sweep", "scenes/two-span-cases.toml", "--set", "geometry.plate.particles=[21, 3]"])
        .args(["--over", "section.homogeneous.thickness=0.2,0.25", "--out"])
        .arg(&out)
        .current_dir(root())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let table = fs::read_to_string(out.join("sweep.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|row| row.split(',').collect()).collect();
    assert_eq!(rows[0][5], "case [-]", "{table}");
    let found: Vec<[&str; 2]> = rows[1..].iter().map(|row| [row[0], row[5]]).collect();
    let numbers = ["1.0", "2.0", "3.0", "4.0", "5.0", "6.0", "7.0", "8.0", "9.0"];
    assert_eq!(found, ["1", "2"].map(|run| numbers.map(|case| [run, case])).concat());
    let (output, out) =
        sweep("called-case", &["--over", "material.elastic.young=1e5,2e5", "--set", "curve[0].name=case"]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    assert_eq!(fs::read_to_string(out.join("sweep.csv")).unwrap().lines().count(), 3);
}

#[test]
fn every_run_has_frames_of_its_own() {
    let fields = ["--set", "output.fields={ stresses = true }", "--set", "analysis={ linear = {} }"];
    let over =
        ["--set", "supports[2]={ on = \"u0v0\", hinged = {} }", "--over", "loads[0].force.total[0]=1,2"];
    let (output, out) = sweep("fields", &[fields, over].concat());
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    // Tension on 1 × 0.1: ten times the force.
    for (run, stress) in [("001", 10.0), ("002", 20.0)] {
        let frames = coque::listed(&out.join(run).join("fields/shell.pvd")).unwrap();
        assert_eq!(frames.len(), 1);
        let sheet = coque::Sheet::read(&frames[0].1).unwrap();
        let found = &sheet.cell_data["von_mises_top"].numbers;
        assert!(found.iter().all(|s| (s / stress - 1.0).abs() < 1e-6), "{run}: {found:?}");
    }
}

#[test]
fn a_run_that_fails_stops_no_other() {
    let (output, out) = sweep(
        "failing",
        &["--over", "loads[0].force.total[0]=1e9,1.0", "--over", "section.homogeneous.thickness=-1,0.01"],
    );
    assert_eq!(output.status.code(), Some(3), "{}", said(&output));
    let table = fs::read_to_string(out.join("sweep.csv")).unwrap();
    let ends: Vec<bool> = table.lines().skip(1).map(|row| row.contains(",done,")).collect();
    assert_eq!(ends, [false, false, false, true], "{table}");
    assert!(
        table.contains("diverged at time ")
            && table.contains("refused: `section.homogeneous.thickness` is -1")
    );
    assert!(said(&output).contains("1 of 4 runs done"));
}

/// Three jobs into one folder, then one table: that of one sweep but for wall times; a part that lacks, or is another sweep's, is named.
#[test]
fn parts_make_the_table_of_the_whole() {
    let over =
        ["--over", "material.elastic.young=1e5,2e5", "--over", "section.homogeneous.thickness=0.01,-1,0.02"];
    let (_, whole) = sweep("whole", &over);
    let (first, out) = sweep("parts", &[&over[..], &["--only", "1/3"]].concat());
    assert_eq!(first.status.code(), Some(0), "{}", said(&first));
    assert!(said(&first).contains("2 of 2 runs done; they are in "), "{}", said(&first));
    let coque = |arguments: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_coque"))
            .arg("sweep")
            .args(arguments)
            .current_dir(root())
            .output()
            .unwrap()
    };
    let folder = out.display().to_string();
    let collect = || coque(&["--collect", &folder]);
    assert!(said(&collect()).contains("these are missing: 2, 3"), "{}", said(&collect()));
    let part = |over: &[&str], only: &str| {
        coque(&[&["scenes/patch-test.toml", "--out", &folder], over, &["--only", only]].concat())
    };
    // Counted from zero, the last is number zero.
    assert_eq!(part(&over, "2/3").status.code(), Some(3));
    let other = ["--over", "material.elastic.young=3e5"];
    part(&other, "0/3");
    assert!(said(&collect()).contains("part-3-of-3.json is a part of another sweep"), "{}", said(&collect()));
    part(&over, "0/3");
    let all = collect();
    assert_eq!(all.status.code(), Some(3), "{}", said(&all));
    assert!(said(&all).contains("4 of 6 runs done"), "{}", said(&all));
    let table = |folder: &Path| -> Vec<String> {
        let text = fs::read_to_string(folder.join("sweep.csv")).unwrap();
        let wall = text.lines().next().unwrap().split(',').position(|name| name == "wall [s]").unwrap();
        let without = |line: &str| {
            // Refusals are quoted, and have no commas in front of the wall time but in them.
            let cells: Vec<&str> = line.split(',').collect();
            if line.contains('"') {
                line.to_string()
            } else {
                [&cells[..wall], &cells[wall + 1..]].concat().join(",")
            }
        };
        text.lines().map(without).collect()
    };
    assert_eq!(table(&whole), table(&out));
    assert!(out.join("006/curve.csv").exists());
    // A whole sweep into the same folder takes the parts away.
    coque(&[&["scenes/patch-test.toml", "--out", &folder], &over[..]].concat());
    assert!(!out.join("part-1-of-3.json").exists());
}

#[test]
fn what_cannot_be_swept_is_refused() {
    let empty = sweep("empty", &["--over", "material.elastic.young=1,,2"]).0;
    assert_eq!(empty.status.code(), Some(2));
    assert!(said(&empty).contains("a value is empty; write PATH=V1,V2,"));
    assert_eq!(sweep("nothing", &[]).0.status.code(), Some(2));
    let part = sweep("part", &["--over", "material.elastic.young=1,2", "--only", "3/2"]).0;
    assert_eq!(part.status.code(), Some(2));
    assert!(said(&part).contains("write K/N"), "{}", said(&part));
    let none = Command::new(env!("CARGO_BIN_EXE_coque"))
        .args(["sweep", "--collect", "scenes"])
        .current_dir(root())
        .output()
        .unwrap();
    assert_eq!(none.status.code(), Some(2));
    assert!(said(&none).contains("no parts of a sweep are in scenes"), "{}", said(&none));
}
