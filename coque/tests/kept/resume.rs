//! Runs that are stopped and go on: the same bits as runs that never stopped; what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::common::fluids::{CUBE, DAM, GATE, ROLLING, SHELL_GATE};
use crate::common::sittings::{
    Pairs, StopAfter, folder, go_on, pairs, same, sit, start, stopped_again_and_again,
};
use crate::common::surfaces::Obj;
use crate::common::{self, text};
use coque::{CHECKPOINT, Checkpoint, Ended, Origin, RunOptions, SCENE_COPY, Scene, Silent};

/// Particles, densities, forces of the last evaluation, the clocks and what they counted: all of it is kept.
#[test]
fn a_fluid_and_what_is_in_it_go_on_to_the_same_bits() {
    stopped_again_and_again("dam", DAM, &[], 6);
    let replaced = [("analysis.explicit.transient.duration", "0.006")];
    stopped_again_and_again("shell-gate", SHELL_GATE, &replaced, 4);
    stopped_again_and_again("solid-gate", GATE, &replaced, 4);
    stopped_again_and_again("cube", CUBE, &[("analysis.explicit.transient.duration", "0.002")], 3);
    stopped_again_and_again("rolling", ROLLING, &[], 6);
    let source = ("bodies.water.fluid.formulation", "{ weakly-compressible = { method = \"source\" } }");
    stopped_again_and_again("source", DAM, &[source], 6);
    let first = ("coupling", "{ order = \"fluid-first\", impedance = false }");
    stopped_again_and_again("fluid-first", SHELL_GATE, &[replaced[0], first], 4);
}

/// Where the level counts the stress, where it is found before a load, where it is let go in time.
#[test]
fn runs_under_an_initial_stress_go_on_to_the_same_bits() {
    let strip = text("relieved-strip.toml");
    let slight = ("initial_stress[0].bending", "[-3e7, 0.0, 0.0]");
    let load = ("loads", "[{ on = \"u1\", force = { total = [0, 0, 1e-3] } }]");
    let march = "{ explicit = { transient = { duration = 2e-3, record_every = 2e-4 } } }";
    stopped_again_and_again("relieved", &strip, &[], 2);
    stopped_again_and_again("relieved-before", &strip, &[slight, load], 2);
    stopped_again_and_again("let-go", &strip, &[slight, ("analysis", march)], 3);
}

/// A rigid end that is turned, hinged beside its mass, with springs: its pose and motion are those of its particles.
#[test]
fn runs_with_rigid_sets_go_on_to_the_same_bits() {
    let strip = text("twisted-strip.toml");
    let rigid = ("rigid", "[{ on = \"u1\", at = [8.5, 0.3, 0.4], mass = 10.0, inertia = 1.0 }]");
    let hinged = "[{ on = 'u0', clamped = {} }, { on = 'u1', moved = { direction = [0, 0, 1], by = 0.1 }, amplitude = { smooth = 0.01 } }, \
                  { on = 'u1', spring = { axis = [1, 0, 0], stiffness = 100 } }]";
    let march = ("analysis", "{ explicit = { transient = { duration = 5e-3, record_every = 5e-4 } } }");
    stopped_again_and_again("turned-body", &strip, &[rigid], 2);
    stopped_again_and_again("moved-body", &strip, &[rigid, march, ("supports", hinged)], 3);
}

/// A solid that fills a surface from a file, one end turned, a pressure on a group of its faces.
#[test]
fn runs_of_a_filled_solid_go_on_to_the_same_bits() {
    let file = Obj::cuboid([0.3, -0.7, 1.1], [1.53, -0.1, 1.7]).write("resumed");
    let bar = format!(
        "title = \"Bar\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\n\
         bodies.bar.solid.geometry.filled = {{ file = {file:?}, spacing = 0.1 }}\n\
         bodies.bar.solid.material.elastic = {{ young = 1000.0, poisson = 0.3, density = 2.0 }}\n\
         bodies.bar.solid.formulation.state-based.horizon = 2.015\n\
         analysis.explicit.transient = {{ duration = 0.1, record_every = 0.01 }}\n\
         supports = [{{ on = \"x0\", turned = {{ axis = [1, 0, 0], point = [0, -0.4, 1.4], by = 5 }}, amplitude = {{ smooth = 0.1 }} }}]\n\
         loads = [{{ on = \"side1\", pressure = {{ value = 2 }} }}]\n\
         curve = [{{ name = \"M\", of = \"reaction-moment\", on = \"x0\", direction = [1, 0, 0] }}]"
    );
    stopped_again_and_again("filled", &bar, &[], 3);
    let by = |threads| Scene::parse(&bar, "filled").unwrap().build(threads).unwrap().run(&mut Silent).curve;
    assert_eq!(by(1), by(2));
}

/// Reserve factors, stresses of plies, forces through a cut: they follow from the state alone.
#[test]
fn runs_with_columns_of_plies_and_cuts_go_on_to_the_same_bits() {
    let plies = include_str!("../metamorphic/plies.toml");
    let march = ("analysis", "{ explicit = { transient = { duration = 2e-4, record_every = 2e-5 } } }");
    stopped_again_and_again("plies", plies, &[("analysis.static.levels", "4")], 2);
    stopped_again_and_again("plies-march", plies, &[march], 3);
}

#[test]
fn quasi_static_runs_go_on_to_the_same_bits() {
    let coarse = ("geometry.plate.particles", "[17, 3]");
    let levels = ("analysis.explicit.quasi-static.levels", "4");
    let kinetic = ("analysis.explicit.quasi-static.damping", "\"kinetic\"");
    stopped_again_and_again("ratio", &text("ring.toml"), &[coarse, levels], 8);
    stopped_again_and_again("kinetic", &text("ring.toml"), &[coarse, levels, kinetic], 8);
}

#[test]
fn warnings_and_looks_at_stability_go_on_to_the_same_bits() {
    let coarse = ("geometry.plate.particles", "[17, 3]");
    let path = "{ levels = 3, period = 17.9, hold = 2, damping = { ratio = 4.0 }, stability = true }";
    let replaced = [coarse, ("analysis.explicit.quasi-static", path)];
    stopped_again_and_again("unsettled", &text("ring.toml"), &replaced, 8);
    let replaced = [coarse, ("analysis.explicit.quasi-static.stability", "true")];
    stopped_again_and_again("looked-at", &text("ring.toml"), &replaced, 8);
}

#[test]
fn every_formulation_goes_on_to_the_same_bits() {
    let coarse = ("geometry.plate.particles", "[13, 5]");
    let levels = ("analysis.explicit.quasi-static.levels", "[0.05]");
    for (name, formulation) in [
        ("wide", "{ stress-point = { support = 1.4 } }"),
        ("nodal", "{ nodal = { order = 2 } }"),
        ("strong-form", "{ strong-form = {} }"),
    ] {
        let hold = ("analysis.explicit.quasi-static.hold", "0.5");
        let replaced = [coarse, levels, hold, ("formulation", formulation)];
        stopped_again_and_again(name, &text("ring.toml"), &replaced, 6);
    }
}

#[test]
fn transient_runs_go_on_to_the_same_bits() {
    let transient = "{ transient = { duration = 0.003, record_every = 0.0001, damping = 10.0 } }";
    let replaced = [
        ("analysis.explicit", transient),
        ("supports[3].amplitude", "{ sine = { period = 0.01 } }"),
        ("geometry.cylinder.particles", "[11, 11]"),
    ];
    stopped_again_and_again("transient", &text("panel.toml"), &replaced, 6);
}

/// A base that moves by a record: its way is found anew from its time, and is in the columns after a pause as before.
#[test]
fn a_run_on_a_shaken_base_goes_on_to_the_same_bits() {
    let replaced = [
        ("geometry.plate.particles", "[9, 3]"),
        ("analysis.explicit.transient.duration", "0.5"),
        ("analysis.explicit.transient.base.response", "\"absolute\""),
    ];
    let text = text("deck-in-quake.toml").replace("[output.fields]\nevery = 5\n", "");
    stopped_again_and_again("shaken", &text, &replaced, 6);
}

/// Beams with a heavy body at their end, and a rib that hangs on a plate: groups and hosts hold no state of their own.
#[test]
fn bodies_and_ties_go_on_to_the_same_bits() {
    let heavy = text("heavy-end.toml");
    let load = ("loads", "[{ on = \"u1\", force = { total = [5, 20, 80] } }]");
    let curve = "[{ name = \"w\", of = \"displacement\", on = \"u1\", direction = [0, 0, 1] }]";
    let short = [("geometry.plate.particles", "[13, 3]"), load, ("curve", curve)];
    let march = ("analysis", "{ explicit = { transient = { duration = 4e-3, record_every = 1e-4 } } }");
    stopped_again_and_again("body", &heavy, &[&short[..], &[march]].concat(), 6);
    let levels = ("analysis", "{ static = { levels = 8 } }");
    stopped_again_and_again("body-static", &heavy, &[&short[..], &[levels]].concat(), 3);
    let file = format!("{:?}", Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/meshes/tied-rib.msh"));
    let march = ("analysis", "{ explicit = { transient = { duration = 3e-4, record_every = 1e-5 } } }");
    let replaced = [("geometry.mesh.file", file.as_str()), march];
    stopped_again_and_again("tied", &text("meshes/tied-rib.toml"), &replaced, 4);
}

#[test]
fn a_breaking_solid_goes_on_to_the_same_bits() {
    let replaced = [
        ("bodies.glass.solid.geometry.block.spacing", "1e-3"),
        ("analysis.explicit.transient.duration", "3.5e-5"),
        ("sets.lower.layer.depth", "3e-3"),
        ("sets.upper.layer.depth", "3e-3"),
    ];
    let text = text("crack-branching.toml").replace("fields = { every = 10 }", "");
    stopped_again_and_again("by-stretch", &text, &replaced, 5);
    let work = [replaced.as_slice(), &[("bodies.glass.solid.fracture.by", "\"work\"")]].concat();
    stopped_again_and_again("by-work", &text, &work, 5);
}

/// Bonds break between balances: the pattern of the tangent is that of the body before any broke.
#[test]
fn a_strip_that_tears_goes_on_to_the_same_bits() {
    let strip = common::torn::strip(false);
    stopped_again_and_again("torn-newton", &strip, &[], 3);
    let relaxed = ("analysis", "{ relaxation = { levels = [0.25, 0.5, 0.75, 1.0] } }");
    stopped_again_and_again("torn-relaxed", &strip, &[relaxed], 3);
}

#[test]
fn static_runs_go_on_from_the_last_level_to_the_same_bits() {
    let coarse = ("geometry.plate.particles", "[17, 3]");
    let levels = ("analysis.static.levels", "8");
    stopped_again_and_again("static-load", &text("ring.toml"), &[coarse, levels], 3);
    // A preload is over where a run goes on from a level, and is applied anew where it was interrupted on its way.
    let first = "{ on = \"u1\", force = { total = [0, 0, 0.3] }, preload = true }";
    stopped_again_and_again("static-preload", &text("ring.toml"), &[coarse, levels, ("loads[+]", first)], 3);
    let coarse = ("geometry.cylinder.particles", "[9, 9]");
    stopped_again_and_again("static-moved", &text("panel.toml"), &[coarse, levels], 3);
}

/// Masses, slow modes, the levels behind and the energies go along: in a checkpoint, not found anew.
#[test]
fn relaxations_go_on_from_the_last_level_to_the_same_bits() {
    let (coarse, levels) = (("geometry.plate.particles", "[17, 3]"), ("analysis.relaxation.levels", "8"));
    stopped_again_and_again("relaxed-load", &text("ring.toml"), &[coarse, levels], 4);
    let coarse = ("geometry.cylinder.particles", "[9, 9]");
    stopped_again_and_again("relaxed-moved", &text("panel.toml"), &[coarse, levels], 4);
    let sheets = ("bodies.plate.solid.geometry.block.spacing", "25.0");
    let levels = ("analysis", "{ relaxation = { levels = [0.02, 0.04, 0.08], tolerance = 1e-4 } }");
    stopped_again_and_again("relaxed-sheets", &text("plate-pd.toml"), &[sheets, levels], 3);
    let coarse = ("bodies.beam.solid.geometry.block.spacing", "[25.4, 12.7, 12.7]");
    let levels = ("analysis", "{ relaxation = { levels = [1.0, 2.0, 3.0], tolerance = 1e-5 } }");
    stopped_again_and_again("relaxed-galerkin", &text("cantilever-solid.toml"), &[coarse, levels], 3);
}

#[test]
fn a_run_that_is_not_stopped_is_the_same_with_checkpoints() {
    let folder = folder("kept");
    let replaced = pairs(&[("geometry.plate.particles", "[17, 3]"), ("analysis.static.levels", "3")]);
    let text = text("ring.toml");
    let whole = Scene::with_overrides(&text, "test.toml", &replaced).unwrap().build(1).unwrap();
    let whole = whole.run(&mut Silent);
    same(&start(&folder, &text, &replaced, &mut Silent), &whole);
    assert!(!folder.join("checkpoint.part").exists());
    // Killed after the checkpoint of its last level nothing is left to be found, and all is there, what the supports bear among it.
    assert!(whole.summary.supports.is_some());
    same(&go_on(&folder, &mut Silent), &whole);
}

/// A folder with a checkpoint of the patch test, stopped after some steps.
fn stopped(name: &str) -> PathBuf {
    let folder = folder(name);
    let outcome = start(&folder, &text("patch-test.toml"), &Pairs::new(), &mut StopAfter(50));
    assert!(matches!(outcome.ended, Ended::Interrupted { time, .. } if time > 0.0));
    assert!(outcome.summary.ended.starts_with("interrupted at time "), "{}", outcome.summary.ended);
    folder
}

fn refusal(folder: &Path) -> String {
    match Checkpoint::read(folder) {
        Ok(_) => "not refused".into(),
        Err(error) => {
            error.to_string().replace(&folder.display().to_string(), "out").replace(" (os error 2)", "")
        }
    }
}

#[test]
fn refused_checkpoints() {
    let mut all = String::new();
    let mut note = |name: &str, change: &dyn Fn(&Path, Vec<u8>)| {
        let folder = stopped("refused");
        let bytes = fs::read(folder.join(CHECKPOINT)).unwrap();
        change(&folder, bytes);
        all.push_str(&format!("━━━ {name} ━━━\n{}\n", refusal(&folder)));
    };
    let put = |folder: &Path, bytes: &[u8]| fs::write(folder.join(CHECKPOINT), bytes).unwrap();
    note("none", &|folder, _| fs::remove_file(folder.join(CHECKPOINT)).unwrap());
    note("something else", &|folder, _| put(folder, b"time [s],level [-]\n0.0,0.0\n"));
    note("an empty file", &|folder, _| put(folder, b""));
    note("cut off in its header", &|folder, bytes| put(folder, &bytes[..14]));
    note("cut off", &|folder, bytes| put(folder, &bytes[..1000]));
    note("one bit turned", &|folder, mut bytes| {
        bytes[500] ^= 4;
        put(folder, &bytes);
    });
    // What stood in the header before the layout changed.
    note("an older layout", &|folder, mut bytes| {
        bytes[8] = 1;
        put(folder, &bytes);
    });
    note("a later layout", &|folder, mut bytes| {
        bytes[8] = 99;
        put(folder, &bytes);
    });
    note("another program", &|folder, mut bytes| {
        // The version of the program is the first text of the contents, behind its length.
        bytes[25..30].copy_from_slice(b"9.9.9");
        let checksum = crc32fast::hash(&bytes[24..]);
        bytes[20..24].copy_from_slice(&checksum.to_le_bytes());
        put(folder, &bytes);
    });
    note("another scene", &|folder, _| {
        fs::write(folder.join(SCENE_COPY), text("patch-test.toml").replacen("0.3", "0.31", 1)).unwrap();
    });
    note("no scene", &|folder, _| fs::remove_file(folder.join(SCENE_COPY)).unwrap());
    insta::assert_snapshot!(all);
}

#[test]
fn no_damage_goes_unseen() {
    let folder = stopped("damaged");
    let whole = fs::read(folder.join(CHECKPOINT)).unwrap();
    for at in (0..whole.len()).step_by(37).chain(0..24) {
        let mut bytes = whole.clone();
        bytes[at] ^= 1 << (at % 8);
        fs::write(folder.join(CHECKPOINT), &bytes).unwrap();
        assert_ne!(refusal(&folder), "not refused", "byte {at}");
        fs::write(folder.join(CHECKPOINT), &whole[..at]).unwrap();
        assert_ne!(refusal(&folder), "not refused", "{at} bytes");
    }
}

#[test]
fn a_checkpoint_of_another_model_is_refused() {
    let folder = stopped("other-model");
    let finer = refused_by_the_model(&folder, &pairs(&[("geometry.plate.particles", "[11, 7]")]));
    assert!(finer.contains("holds 45 particles, the scene now builds 77"), "{finer}");
    let as_many = refused_by_the_model(&folder, &pairs(&[("geometry.plate.particles", "[5, 9]")]));
    assert!(as_many.contains("the mid-surface has changed since the run began"), "{as_many}");
}

/// Why a model of the scene in a folder does not take up the checkpoint there.
fn refused_by_the_model(folder: &Path, replaced: &Pairs) -> String {
    let (checkpoint, text) = Checkpoint::read(folder).unwrap();
    let model = Scene::with_overrides(&text, &checkpoint.origin.file, replaced).unwrap().build(1).unwrap();
    let options =
        RunOptions { progress: &mut Silent, checkpoints: None, fields: None, from: Some(checkpoint) };
    model.run_with(options).unwrap_err().to_string().replace(&folder.display().to_string(), "out")
}

#[test]
fn a_checkpoint_of_another_mesh_is_refused() {
    let folder = folder("other-mesh");
    let (scene, mesh) = (folder.join(SCENE_COPY), folder.join("roof.msh"));
    let whole = text("meshes/roof.msh");
    fs::write(&mesh, &whole).unwrap();
    let text = text("meshes/roof.toml");
    fs::write(&scene, &text).unwrap();
    let replaced = pairs(&[("analysis.static.levels", "2")]);
    let name = scene.display().to_string();
    let origin = Origin::new(&text, name.clone(), replaced.clone(), 1);
    let sound = Scene::with_overrides(&text, &name, &replaced).unwrap();
    sit(&folder, &sound, origin, &mut StopAfter(4), None);
    // A node that moved, and a group that holds another line: both leave the number of particles.
    let moved = whole.replacen(" 25.4 ", " 25.4000001 ", 1);
    let regrouped = whole.replacen("11 1 2 2 2 111 112", "11 1 2 3 2 111 112", 1);
    for changed in [moved, regrouped] {
        assert_ne!(changed, whole);
        fs::write(&mesh, changed).unwrap();
        let error = refused_by_the_model(&folder, &replaced);
        assert!(error.starts_with("out/roof.msh has changed since the run began"), "{error}");
        assert!(error.ends_with("put it back, or run the scene again from its start"), "{error}");
    }
    fs::write(&mesh, whole).unwrap();
    assert_eq!(go_on(&folder, &mut Silent).ended, Ended::Done);
}

/// Names and contents of the files of a folder.
fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    files.map(|file| (file.file_name().into_string().unwrap(), fs::read(file.path()).unwrap())).collect()
}

#[test]
fn frames_of_a_run_in_sittings_are_those_of_one_sitting() {
    let fields = ("output.fields", "{ every = 2, extruded = true, stresses = true }");
    let coarse = ("geometry.cylinder.particles", "[7, 7]");
    let transient = "{ transient = { duration = 0.05, record_every = 0.005 } }";
    let hinge = ("supports[2]", "{ on = \"u0v0\", hinged = {} }");
    for (name, scene, replaced) in [
        ("static", "panel.toml", vec![coarse, fields, ("analysis.static.levels", "7")]),
        ("marched", "patch-test.toml", vec![hinge, fields, ("analysis.explicit", transient)]),
    ] {
        let (text, replaced) = (text(scene), pairs(&replaced));
        let whole = folder(&format!("frames-{name}-whole"));
        let expected = start(&whole, &text, &replaced, &mut Silent);
        let parts = folder(&format!("frames-{name}"));
        let (mut after, mut stops) = (1, 0);
        let mut outcome = start(&parts, &text, &replaced, &mut StopAfter(after));
        while let Ended::Interrupted { .. } = outcome.ended {
            // What a sitting that was killed wrote after its checkpoint is taken out.
            fs::create_dir_all(parts.join("fields")).unwrap();
            fs::write(parts.join("fields/shell-0099.vtu"), "of a frame to come").unwrap();
            (stops, after) = (stops + 1, 2 * after);
            outcome = go_on(&parts, &mut StopAfter(after));
        }
        assert!(stops >= 2, "{name}: {stops}");
        same(&outcome, &expected);
        assert!(expected.summary.record.frames >= 4, "{name}: {}", expected.summary.record.frames);
        assert!(contents(&parts.join("fields")) == contents(&whole.join("fields")), "{name}");
    }
}
