//! What hangs on a shell and what its section may be: couples, lumped masses, brackets from two files, thicknesses from a
//! table, sections high over their particles.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::Path;

use crate::strip::{THIN, last, run, strip};
use coque::{Rendering, Scene, Silent, render};

#[test]
fn a_couple_about_a_fixed_axis_acts_on_any_set() {
    // On the end row's middle particle, or on a block of particles beside it: the arm up to it bends as under any couple.
    let stiffness = 1e6 * 0.2_f64.powi(3) / 12.0;
    let block = "[sets]\nblock.box = { min = [9.4, 0.0, 0.0], max = [10.0, 1.0, 0.0] }\n";
    let couple = |on: &str| {
        format!("loads = [{{ on = \"{on}\", couple = {{ moment = 1.0, axis = [0.0, -1.0, 0.0] }} }}]")
    };
    let text = strip(THIN, &couple("u1")).replace("[sets]\n", block);
    let exact = 100.0 / (2.0 * stiffness);
    let on = |set: &str| last(&run(&text.replace(&couple("u1"), &couple(set))));
    assert!((on("u1") / exact - 1.0).abs() < 1e-9);
    // Three rows at 9.5, 9.75 and 10: Σ (L² − (L − x)²)/3 over 2EI.
    let of_block = (100.0 - 0.25 + 100.0 - 0.0625 + 100.0) / 3.0 / (2.0 * stiffness);
    let found = on("block");
    assert!((found / of_block - 1.0).abs() < 1e-3, "{found} {of_block}");
}

#[test]
fn lumped_masses_have_weight_and_inertia() {
    let text = strip(
        THIN,
        "loads = [{ on = \"all\", gravity = { acceleration = [0.0, 0.0, -2.0] } }]\nmasses = [{ on = \"u1\", mass = 3.0 }]",
    );
    let outcome = run(&text);
    let loads = outcome.summary.body.resultants.as_ref().unwrap();
    // The strip has a mass of 4; the other 3 hang on its end.
    assert!((loads.loads[0].1.force[2] + 2.0 * 7.0).abs() < 1e-10, "{loads:?}");
    let stiffness = 1e6 * 0.2_f64.powi(3) / 12.0;
    let exact = -(2.0 * 0.4 * 1e4 / 8.0 + 6.0 * 1e3 / 3.0) / stiffness;
    assert!((last(&outcome) / exact - 1.0).abs() < 2e-3, "{} {exact}", last(&outcome));
    assert!(outcome.summary.body.modelled.contains(&"mass of 3 on u1".to_string()));
}

#[test]
fn the_brackets_of_both_files_are_one_in_statics_and_in_time() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/meshes");
    let found = |name: &str, replaced: &[(&str, &str)]| {
        let path = folder.join(name);
        let text = fs::read_to_string(&path).unwrap();
        let replaced: Vec<_> =
            replaced.iter().map(|(key, value)| (key.to_string(), value.to_string())).collect();
        let scene = Scene::with_overrides(&text, &path.to_string_lossy(), &replaced).unwrap();
        let outcome = scene.build(1).unwrap().run(&mut Silent);
        ["w_end", "of_foot", "of_arm", "R"].map(|name| *outcome.curve.column(name).unwrap().last().unwrap())
    };
    let (gmsh, abaqus) = (found("bracket-gmsh.toml", &[]), found("bracket-abaqus.toml", &[]));
    // The period is that of the first mode; a march ends within its accuracy of the answer at rest.
    let march = ("analysis.explicit.quasi-static", "{ levels = 1, period = 1.78e-3 }");
    let marched = found("bracket-abaqus.toml", &[march]);
    for i in 0..4 {
        assert!((gmsh[i] / abaqus[i] - 1.0).abs() < 1e-9, "{gmsh:?} {abaqus:?}");
        assert!((marched[i] / abaqus[i] - 1.0).abs() < 1e-3, "{marched:?} {abaqus:?}");
    }
}

/// A strip whose thickness falls from .2 to .1, from a table at its particles in units of .1, as from its taper.
#[test]
fn a_table_of_thicknesses_is_a_taper_and_is_refused_where_it_has_holes() {
    let folder = std::env::temp_dir().join(format!("coque-thickness-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let mut text = String::from("# by particle\nx, y, z, t\n");
    for i in 0..41 {
        for j in 0..5 {
            let x = 0.25 * f64::from(i);
            text.push_str(&format!("{x}, {}, 0, {}\n", 0.25 * f64::from(j), 2.0 - 0.1 * x));
        }
    }
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).unwrap();
    write("t.csv", &text);
    let half: Vec<&str> = text.lines().take(100).collect();
    write("half.csv", &half.join("\n"));
    write("negative.csv", &text.replace(", 1\n", ", -1\n"));
    write("word.csv", &text.replace(", 1\n", ", thin\n"));
    let load = "loads = [{ on = \"u1\", force = { total = [0.0, 0.0, 1e-3] } }]";
    let parse = |section: &str| {
        let scene = Scene::parse(&strip(section, load), &folder.join("scene.toml").display().to_string());
        scene.and_then(|scene| scene.build(1))
    };
    let table = |file: &str, column: &str| {
        format!(
            "section.homogeneous = {{ thickness = 0.1, table = {{ file = \"{file}\", column = \"{column}\" }} }}"
        )
    };
    let taper =
        "section.homogeneous = { thickness = 0.2, taper = { point = [0, 0, 0], gradient = [-0.01, 0, 0] } }";
    let found = last(&parse(&table("t.csv", "t")).unwrap().run(&mut Silent));
    let exact = last(&parse(taper).unwrap().run(&mut Silent));
    // Rounding of the system of a thin strip, whose thicknesses differ in their last digit.
    assert!((found / exact - 1.0).abs() < 1e-10, "{found} {exact}");
    for (section, says) in [
        (table("t.csv", "thick"), "has no column"),
        (table("none.csv", "t"), "cannot be read"),
        (table("half.csv", "t"), "no row near"),
        (table("negative.csv", "t"), "-1 in column t"),
        (table("word.csv", "t"), "no number in column t"),
        (taper.replace("} }", "}, table = { file = \"t.csv\", column = \"t\" } }"), "a taper and a table"),
    ] {
        let error = parse(&section).err().map_or_else(String::new, |error| error.to_string());
        assert!(error.contains(says), "{says}: {error}");
    }
    fs::remove_dir_all(&folder).unwrap();
}

/// A cantilever all of whose section lies a tenth of its length over its particles: its first frequency is as much too low as the
/// warning's rule says of the wave `∫w′²/∫w² = 4.65/L²` that it is, and the warning tells of it.
#[test]
fn frequencies_of_sections_high_over_their_particles_are_doubted() {
    let modal = |offset: f64| {
        let part = format!("{THIN}\nparts = [{{ on = \"all\", offset = {offset} }}]");
        let text = strip(&part, "").replace("analysis.linear = {}", "analysis.modal = { modes = 1 }");
        let text = text.split("[[curve]]").next().unwrap().to_string();
        let scene = Scene::parse(&text, "scene.toml").and_then(|scene| scene.build(1));
        let model =
            scene.unwrap_or_else(|e| panic!("{}", render(&e, Rendering { width: 100, colour: false })));
        let warned = model.warnings().iter().any(|warning| warning.kind == coque::WarningKind::OffsetInertia);
        let outcome = model.run(&mut Silent);
        (*outcome.curve.column("frequency").unwrap().first().unwrap(), warned)
    };
    let (middle, low) = (modal(1e-9), modal(0.2));
    assert!(!middle.1 && !low.1);
    let (high, warned) = modal(1.0);
    let (off, expected) = (high / middle.0 - 1.0, (1.0_f64 + 2.0 * 0.0465).sqrt().recip() - 1.0);
    println!("{off:.4}, expected {expected:.4}");
    assert!(warned && (off - expected).abs() < 5e-3, "{off} {expected}");
}
