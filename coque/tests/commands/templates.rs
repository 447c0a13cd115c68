//! What teaches: the schema fits every scene and what is refused, the catalogue, templates, `coque check`.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use coque::scene::{Load, Support};
use coque::{Scene, catalogue, reference_page, schema, schema_text};
use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn scenes() -> Vec<(String, String)> {
    let files = fs::read_dir(root().join("scenes")).unwrap().map(|entry| entry.unwrap().path());
    let mut scenes: Vec<_> = files
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .map(|path| {
            (path.file_stem().unwrap().to_string_lossy().into_owned(), fs::read_to_string(&path).unwrap())
        })
        .collect();
    scenes.sort();
    scenes
}

fn coque(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_coque")).args(arguments).current_dir(folder).output().unwrap()
}

fn said(output: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
}

#[test]
fn the_kept_schema_is_the_present_one() {
    let kept = fs::read_to_string(root().join("scenes/schema.json")).unwrap_or_default();
    assert!(
        kept.replace("\r\n", "\n") == schema_text(),
        "scenes/schema.json is not the schema of this program; refresh it:\n  \
         cargo run -p coque -- schema > scenes/schema.json"
    );
}

#[test]
fn the_kept_page_is_the_present_one() {
    let kept = fs::read_to_string(root().join("docs/scene-reference.md")).unwrap_or_default();
    let present = reference_page();
    assert!(
        kept.replace("\r\n", "\n") == present,
        "docs/scene-reference.md is not the page of this program; refresh it:\n  \
         cargo run -p coque -- schema --page > docs/scene-reference.md"
    );
    let (_, table) = present.rsplit_once("---|\n").unwrap();
    for word in Support::WORDS.iter().chain(&Load::WORDS) {
        assert!(table.contains(&format!("| `{word}`")), "{word} has no row");
    }
}

#[test]
fn every_key_is_described() {
    fn visit(value: &Value, path: &str, silent: &mut Vec<String>) {
        if let Some(keys) = value["properties"].as_object() {
            // The one key of an alternative is described beside it.
            let alternative = keys.len() == 1 && value["description"].is_string();
            for (key, of) in keys {
                if !alternative && !of["description"].is_string() {
                    silent.push(format!("{path}.{key}"));
                }
            }
        }
        match value {
            Value::Object(map) => {
                map.iter().for_each(|(key, of)| visit(of, &format!("{path}.{key}"), silent))
            }
            Value::Array(items) => items.iter().for_each(|of| visit(of, path, silent)),
            _ => {}
        }
    }
    let mut silent = Vec::new();
    visit(&schema(), "", &mut silent);
    assert_eq!(silent, [""; 0]);
    assert!(!schema_text().contains("\\\\["), "rustdoc marks are left in descriptions");
}

/// Whether a value fits a schema, as far as the schema of scenes goes; says where it does not.
fn fits(value: &Value, schema: &Value, root: &Value) -> Result<(), String> {
    if let Some(name) = schema["$ref"].as_str() {
        fits(value, root.pointer(name.trim_start_matches('#')).unwrap(), root)?;
    }
    if let Some(choices) = schema["oneOf"].as_array() {
        let fitting = choices.iter().filter(|choice| fits(value, choice, root).is_ok()).count();
        if fitting != 1 {
            return Err(format!("{value} fits {fitting} of {}", schema["oneOf"]));
        }
    }
    assert!(schema.get("anyOf").is_none(), "a keyword this test does not know: {schema}");
    let is = |kind: &Value| match kind.as_str() {
        Some("object") => value.is_object(),
        Some("array") => value.is_array(),
        Some("string") => value.is_string(),
        Some("boolean") => value.is_boolean(),
        Some("integer") => value.is_i64() || value.is_u64(),
        Some("number") => value.is_number(),
        other => panic!("a type this test does not know: {other:?}"),
    };
    let right = match &schema["type"] {
        Value::Null => true,
        Value::Array(kinds) => kinds.iter().any(is),
        kind => is(kind),
    };
    let right = right && value.as_str().is_none_or(|text| matches(text, &schema["pattern"]));
    let among = |key: &str| schema[key].as_array().is_none_or(|words| words.contains(value));
    let constant = schema.get("const").is_none_or(|wanted| wanted == value);
    let least =
        |key: &str| schema[key].as_f64().is_none_or(|least| value.as_f64().is_none_or(|x| x >= least));
    if !right || !among("enum") || !constant || !least("minimum") {
        return Err(format!("{value} does not fit {schema}"));
    }
    if let Some(map) = value.as_object() {
        let required = schema["required"].as_array().into_iter().flatten();
        if let Some(missing) = required.filter_map(Value::as_str).find(|key| !map.contains_key(*key)) {
            return Err(format!("{missing} is missing in {value}"));
        }
        for (key, item) in map {
            match (&schema["properties"][key], &schema["additionalProperties"]) {
                (Value::Null, Value::Bool(false)) => return Err(format!("unknown key {key}")),
                (Value::Null, Value::Null) => {}
                (Value::Null, other) => fits(item, other, root)?,
                (own, _) => fits(item, own, root)?,
            }
        }
    }
    if let Some(list) = value.as_array() {
        let count = |key: &str, default: u64| schema[key].as_u64().unwrap_or(default) as usize;
        if list.len() < count("minItems", 0) || list.len() > count("maxItems", u64::from(u32::MAX)) {
            return Err(format!("{} items in {value}", list.len()));
        }
        if schema["items"].is_object() {
            list.iter().try_for_each(|item| fits(item, &schema["items"], root))?;
        }
    }
    Ok(())
}

/// Whether a text fits a pattern: the schema has that of expressions and amounts alone.
fn matches(text: &str, pattern: &Value) -> bool {
    if pattern.is_null() {
        return true;
    }
    assert_eq!(pattern, "[$(+*/^-]|pi|[0-9] [a-zA-Z°]", "a pattern this test does not know");
    text.contains(['$', '(', '+', '*', '/', '^', '-']) || text.contains("pi") || text.contains(' ')
}

fn scene_fits(text: &str) -> Result<(), String> {
    let value: Value = toml::from_str(text).unwrap();
    let schema: Value = serde_json::from_str(&schema_text()).unwrap();
    fits(&value, &schema, &schema)
}

#[test]
fn every_scene_fits_the_schema() {
    for (name, text) in scenes() {
        scene_fits(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

#[test]
fn what_readers_refuse_the_schema_refuses() {
    let ring = scenes().into_iter().find(|(name, _)| name == "ring").unwrap().1;
    for (from, to) in [
        ("young = 1200.0", "yuong = 1200.0"),
        ("young = 1200.0", "young = \"stiff\""),
        ("[material.elastic]", "[material.elastik]"),
        ("density = 1.0\n", ""),
        ("force = \"N\"", "force = \"kg\""),
        ("clamped = {}", "clamped = {}\nhinged = {}"),
        ("clamped = {}\n", ""),
        ("of = \"rotation\"", "of = \"spin\""),
        ("axis = [0.0, -1.0, 0.0]", "axis = \"face\""),
        ("axis = [0.0, -1.0, 0.0]", "axis = [0.0, -1.0]"),
        ("levels = [0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0]", "levels = 0"),
        ("levels = [0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0]", "levels = []"),
        ("thickness = 1.0", "thickness = 1.0\n[formulation.nodal]\nkernel = \"gaussian\""),
        ("thickness = 1.0", "thickness = 1.0\n[formulation.stress-point]\nsupport = \"cells\""),
    ] {
        assert!(ring.contains(from), "the ring no longer says {from}");
        let broken = ring.replacen(from, to, 1);
        assert!(Scene::parse(&broken, "broken.toml").is_err(), "{to}");
        assert!(scene_fits(&broken).is_err(), "{to}");
    }
}

#[test]
fn the_catalogue_names_what_scenes_use() {
    let shelves = catalogue();
    for shelf in &shelves {
        assert!(!shelf.entries.is_empty(), "{}", shelf.name);
        for (word, line) in &shelf.entries {
            assert!(!line.is_empty() && !line.contains('\n'), "{}: {word}", shelf.name);
        }
    }
    let words = |name: &str| -> Vec<String> {
        let shelf = shelves.iter().find(|shelf| shelf.name == name).unwrap();
        shelf.entries.iter().map(|(word, _)| word.clone()).collect()
    };
    for (_, text) in scenes() {
        let scene = Scene::parse(&text, "a scene").unwrap();
        assert!(words("analyses").iter().any(|word| word.starts_with(scene.analysis.word())));
        if let Some(shell) = scene.as_shell() {
            assert!(words("geometries").contains(&shell.geometry.word().to_string()));
            assert!(words("formulations").contains(&shell.formulation.word().to_string()));
            assert!(words("strains").contains(&shell.curvature().to_string()));
        }
        if let Some(solid) = scene.as_solid() {
            assert!(words("solid-formulations").contains(&solid.formulation.word().to_string()));
        }
        for (word, _) in scene.supports.iter().flat_map(|support| support.kinds()) {
            assert!(words("supports").contains(&word.to_string()));
        }
        for (word, _) in scene.loads.iter().flat_map(|load| load.kinds()) {
            assert!(words("loads").contains(&word.to_string()));
        }
    }
}

#[test]
fn the_list_is_printed_whole_or_by_kind() {
    let all = said(&coque(&root(), &["list"]));
    for shelf in catalogue() {
        assert!(all.contains(&format!("{} ({})", shelf.name, shelf.place)));
    }
    let loads = said(&coque(&root(), &["list", "loads"]));
    assert!(
        loads.starts_with("loads ([[loads]])\n")
            && loads.contains("  gravity ")
            && !loads.contains("kernels")
    );
    let refused = coque(&root(), &["list", "forces"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(said(&refused).contains("there is no kind `forces`; known here: analyses, "));
}

#[test]
fn every_scene_is_a_template_that_checks() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("templates");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let listed = said(&coque(&folder, &["new"]));
    for (name, text) in scenes() {
        assert!(
            listed.contains(&format!("  {name} ")),
            "{name} is no example: add it in commands/examples.rs"
        );
        let written = coque(&folder, &["new", &name]);
        assert_eq!(written.status.code(), Some(0), "{}", said(&written));
        let copy = fs::read_to_string(folder.join(format!("{name}.toml"))).unwrap();
        let title = |text: &str| Scene::parse(text, &name).unwrap().into_scene().title;
        assert_eq!(title(&copy), title(&text));
        assert!(copy.contains(&format!("coque run {name}.toml")), "{copy}");
    }
    let twice = coque(&folder, &["new", "ring"]);
    assert_eq!(twice.status.code(), Some(2));
    assert!(said(&twice).contains("ring.toml is there already"));
    assert_eq!(coque(&folder, &["new", "rnig"]).status.code(), Some(2));
}

#[test]
fn examples_are_listed_with_seconds_and_written_with_their_meshes() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("examples");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let listed = said(&coque(&folder, &["examples"]));
    for line in listed.lines() {
        let (seconds, name) = line.split_once(" s  ").unwrap_or_else(|| panic!("{line}"));
        assert!(seconds.trim().parse::<f64>().is_ok_and(|seconds| seconds > 0.0), "{line}");
        assert!(name.split_once(' ').is_some_and(|(_, title)| title.trim().len() > 3), "{line}");
    }
    // A name that is no file is one of them.
    let missing = coque(&folder, &["run", "t-frame"]);
    assert_eq!(missing.status.code(), Some(2));
    assert!(said(&missing).contains("`coque examples t-frame` writes t-frame.toml"), "{}", said(&missing));
    assert_eq!(coque(&folder, &["examples", "t-frame"]).status.code(), Some(0));
    assert!(folder.join("t-frame.msh").is_file());
    let checked = coque(&folder, &["check", "t-frame.toml"]);
    assert_eq!(checked.status.code(), Some(0), "{}", said(&checked));
    let unknown = coque(&folder, &["examples", "rnig"]);
    assert!(unknown.status.code() == Some(2) && said(&unknown).contains("there is no example `rnig`"));
}

#[test]
fn shells_and_the_manual_know_every_word() {
    let help = said(&coque(&root(), &["--help"]));
    let words =
        help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let words: Vec<&str> = words.filter_map(|line| line.split_whitespace().next()).collect();
    assert!(words.contains(&"examples") && words.len() > 12, "{words:?}");
    let man = said(&coque(&root(), &["man"]));
    assert!(man.contains(".TH coque 1"), "{man}");
    for shell in ["bash", "zsh", "fish", "powershell"] {
        let text = said(&coque(&root(), &["completion", shell]));
        for word in words.iter().filter(|word| **word != "help") {
            assert!(text.contains(word), "{shell} does not complete {word}");
        }
        assert!(text.contains("threads"), "{shell} completes no options");
    }
    for word in words.iter().filter(|word| **word != "help") {
        assert!(man.contains(&format!(".SH \"coque {}\"", word.to_uppercase())), "{word}");
    }
    assert_eq!(coque(&root(), &["completion", "cmd"]).status.code(), Some(2));
}

#[test]
fn a_check_prints_the_model_and_the_cost() {
    let ring = coque(&root(), &["check", "scenes/ring.toml"]);
    assert_eq!(ring.status.code(), Some(0));
    let text = said(&ring);
    for line in [
        "  particles                250\n",
        "  points                   196\n",
        "  degrees of freedom       1127\n",
        "  clamped on u0\n",
        "left out\n  plasticity\n",
        "million particle-steps/s, timed just now",
    ] {
        assert!(text.contains(line), "no {line:?} in\n{text}");
    }
    let numbers = |word: &str| -> Vec<f64> {
        let line = text.lines().find(|line| line.starts_with(word)).unwrap();
        line.split_whitespace().filter_map(|number| number.parse().ok()).collect()
    };
    // Eight levels, ramp 1, holds from 0.1 to 8 periods, in steps of 0.8 times the stable one. The period is Rayleigh's of the
    // strip bent by a couple, w = x²: 17.9 s √(12.36/20); the given one is taken as it is.
    let steps = |period: f64| 8.0 * period / (0.8 * numbers("  stable step")[0]);
    let bent = steps(17.9 * (12.36_f64 / 20.0).sqrt());
    for (reported, wanted) in numbers("  steps").into_iter().zip([1.1 * bent, 9.0 * bent]) {
        assert!((reported / wanted - 1.0).abs() < 0.05, "{reported} for {wanted}");
    }
    assert_eq!(numbers("  steps").len(), 2);
    let levels = coque(&root(), &["check", "scenes/ring.toml", "--set", "analysis.static.levels=8"]);
    assert!(said(&levels).contains("  factorisations           24 to 240\n"), "{}", said(&levels));
    let wrong = coque(&root(), &["check", "scenes/ring.toml", "--set", "material.elastic.poisson=0.7"]);
    assert_eq!(wrong.status.code(), Some(2));
    assert!(said(&wrong).contains("material.elastic.poisson"));
}
