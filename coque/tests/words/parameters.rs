//! Parameters and expressions: the same model bit for bit as with the numbers written out, values replaced and swept, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::common::refused::refused;
use crate::common::{overridden, ran};
use crate::strip::strip;
use coque::{Rendering, Scene, render};

const PLAIN: &str = "section.homogeneous.thickness = 0.2";
const LOADS: &str = "loads = [{ on = \"tip\", pressure = { value = 1.0 } }]";

/// The strip, each of whose numbers follows from some parameters.
fn named() -> String {
    let text = strip("section.homogeneous.thickness = \"2 * ${t}\"", LOADS);
    let text = text.replace(
        "lengths = [10.0, 1.0], particles = [41, 5]",
        "lengths = [\"${ length }\", 1.0], particles = [\"4 * ${n} + 1\", \"round(${n} / 2)\"]",
    );
    let text = text.replace("young = 1e6, poisson = 0.0", "young = \"10^6\", poisson = \"sin(0) * pi\"");
    let text =
        text.replace("pressure = { value = 1.0 }", "pressure = { value = \"min(1, ${length}, sqrt(2))\" }");
    let text = text.replace("max = [6.0, 1.0, 0.0]", "max = [\"0.6*${length}\", 1, 0]");
    format!("parameters = {{ t = 0.1, length = \"${{n}}\", n = 10 }}\n{text}")
}

#[test]
fn expressions_are_the_numbers_they_stand_for() {
    let (plain, named) = (strip(PLAIN, LOADS), named());
    let [plain, named] = [plain, named].map(|text| Scene::parse(&text, "scene.toml").unwrap());
    let said =
        |scene: &coque::Checked| format!("{:?}", (&scene.bodies, &scene.sets, &scene.loads, &scene.curve));
    assert_eq!(said(&plain), said(&named));
    assert_eq!(named.parameters["length"], 10.0);
    let [plain, named] = [plain, named].map(|scene| ran(Ok(scene)).curve);
    assert_eq!(plain, named);
}

#[test]
fn a_value_replaced_in_a_parameter_changes_all_that_is_made_of_it() {
    let thick = ran(overridden(&strip(&PLAIN.replace("0.2", "0.5"), LOADS), "scene.toml", &[])).curve;
    for value in ["0.25", "\"1 / ${four}\""] {
        let text = named().replace("n = 10", "n = 10, four = 4");
        assert_eq!(ran(overridden(&text, "scene.toml", &[("parameters.t", value)])).curve, thick);
    }
    let text = strip(PLAIN, LOADS);
    let set = ("section.homogeneous.thickness", "\"(1 + 4) / 10\"");
    assert_eq!(ran(overridden(&text, "scene.toml", &[set])).curve, thick);
}

/// A text that holds no number stays one, and so does a word where a number may stand.
#[test]
fn texts_stay_texts() {
    let text = strip(PLAIN, LOADS).replace("title = \"Strip\"", "title = \"${t} * 2\"");
    assert_eq!(Scene::parse(&text, "scene.toml").unwrap().title, "${t} * 2");
}

#[test]
fn what_is_no_expression() {
    let text = format!("parameters.t = 0.1\n{}", strip(PLAIN, LOADS));
    let thickness = |value: &'static str| ("thickness = 0.2", value);
    let cases = [
        ("an unknown parameter", thickness("thickness = \"2 * ${u}\"")),
        ("a name without its signs", thickness("thickness = \"2 * t\"")),
        ("an unknown function", thickness("thickness = \"squrt(2)\"")),
        ("a unit", thickness("thickness = \"5 mm\"")),
        ("an end", thickness("thickness = \"2 *\"")),
        ("an open bracket", thickness("thickness = \"(1 + ${t}\"")),
        ("no number", thickness("thickness = \"sqrt(-${t})\"")),
        ("beyond its bound", thickness("thickness = \"-${t}\"")),
        ("a plain word", thickness("thickness = \"thin\"")),
        ("written with escapes", thickness("thickness = \"2\\u0020* t\"")),
        ("no whole number", ("particles = [41, 5]", "particles = [\"41 / 2\", 5]")),
        ("a list of parameters", ("parameters.t = 0.1", "parameters.t = [0.1]\nparameters.s = \"${t}\"")),
        ("made of itself", ("parameters.t = 0.1", "parameters.t = \"${s}\"\nparameters.s = \"1 + ${t}\"")),
        ("a parameter that is no expression", ("parameters.t = 0.1", "parameters.t = \"1 +\"")),
    ];
    let mut all: String =
        cases.iter().map(|(name, (from, to))| refused(&text, &[(name, from, to)])).collect();
    let sets = [
        ("parameters.u", "1.0"),
        ("parameters.t", "\"2 * ${t}\""),
        ("section.homogeneous.thickness", "\"${t} +* 2\""),
    ];
    for (path, value) in sets {
        let error = overridden(&text, "scene.toml", &[(path, value)]).unwrap_err();
        all.push_str(&format!(
            "━━━ --set {path}={value} ━━━\n{}",
            render(&error, Rendering { width: 100, colour: false })
        ));
    }
    let none = overridden(&strip(PLAIN, LOADS), "scene.toml", &[("parameters.t", "1")]).unwrap_err();
    all.push_str(&format!(
        "━━━ without parameters ━━━\n{}",
        render(&none, Rendering { width: 100, colour: false })
    ));
    insta::assert_snapshot!(all);
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("parameters").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn coque(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_coque")).args(arguments).current_dir(folder).output().unwrap()
}

/// A sweep over a parameter; a finer lattice of a scene whose numbers are expressions, its parameters kept.
#[test]
fn parameters_are_swept_and_stay_in_a_refined_scene() {
    let folder = folder("commands");
    fs::write(folder.join("strip.toml"), named()).unwrap();
    let swept = coque(&folder, &["sweep", "strip.toml", "--over", "parameters.t=0.1,0.25", "--out", "all"]);
    assert_eq!(swept.status.code(), Some(0), "{}", String::from_utf8_lossy(&swept.stderr));
    for (number, thickness) in [("001", "0.2"), ("002", "0.5")] {
        let curve = fs::read_to_string(folder.join("all").join(number).join("curve.csv")).unwrap();
        let alone = ran(overridden(&strip(&PLAIN.replace("0.2", thickness), LOADS), "scene.toml", &[]));
        let mut expected = Vec::new();
        alone.curve.write_csv(&mut expected).unwrap();
        assert_eq!(curve, String::from_utf8(expected).unwrap());
    }
    let refined = coque(&folder, &["refine", "strip.toml"]);
    assert_eq!(refined.status.code(), Some(0), "{}", String::from_utf8_lossy(&refined.stderr));
    let finer = fs::read_to_string(folder.join("strip-finer.toml")).unwrap();
    assert!(finer.contains("particles = [81, 9]") && finer.contains("\"2 * ${t}\""), "{finer}");
    let by_hand = strip(PLAIN, LOADS).replace("[41, 5]", "[81, 9]");
    assert_eq!(
        ran(overridden(&finer, "scene.toml", &[])).curve,
        ran(overridden(&by_hand, "scene.toml", &[])).curve
    );
}

/// Amounts in units of their own are the numbers in the units of the scene, to the last bit.
#[test]
fn amounts_with_a_unit_are_numbers_in_the_units_of_the_scene() {
    let text = |young: &str, density: &str, lengths: &str, angle: &str| {
        format!(
            "title = \"Arc\"\nunits = {{ length = \"mm\", force = \"N\", time = \"s\" }}\n\
             geometry.cylinder = {{ radius = {lengths}, angles = [0.0, {angle}], length = {lengths}, particles = [11, 5] }}\n\
             material.elastic = {{ young = {young}, poisson = 0.3, density = {density} }}\n\
             section.homogeneous.thickness = \"${{t}} / 2\"\nparameters.t = {lengths}\nanalysis.linear = {{}}\n\
             supports = [{{ on = \"u0\", clamped = {{}} }}]\nloads = [{{ on = \"u1\", force = {{ total = [0, 0, 1] }} }}]\n"
        )
    };
    let said = |text: String| {
        let scene = Scene::parse(&text, "scene.toml").unwrap();
        format!("{:?}", (&scene.bodies, &scene.parameters))
    };
    let plain = said(text("210e3", "7.85e-9", "50.0", "90.0"));
    let amounts = text("\"210 GPa\"", "\"7850 kg/m^3\"", "\"5 cm\"", "\"90 deg\"");
    assert_eq!(plain, said(amounts.clone()));
    let cases = [
        ("another dimension", "\"210 GPa\"", "\"210 kN\""),
        ("an unknown unit", "\"210 GPa\"", "\"210 Gpa\""),
        ("no dimension", "poisson = 0.3", "poisson = \"0.3 m\""),
        ("a count", "[11, 5]", "[\"11 mm\", 5]"),
        ("no angle", "\"90 deg\"", "\"90 mm\""),
    ];
    insta::assert_snapshot!(refused(&amounts, &cases));
}
