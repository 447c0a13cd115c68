//! `coque view`: the pages of folders of every kind of run, and what a browser makes of them.
//!
//! The pages are made without a browser; that something is drawn, that frames differ, that a particle answers and the mark
//! of the curve moves is asked of Chromium through the page's own `#selftest`.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::browser;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread::sleep;
use std::time::Duration;

use serde_json::Value;

/// What a page of numbers may take: that of the ring, with all stresses.
const RING: u64 = 500_000;
/// Of the dam break, forty frames.
const DAM_BREAK: u64 = 1_800_000;

fn command(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_coque"))
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
        .output()
        .unwrap()
}

fn succeeded(output: &Output) {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Runs a scene with values replaced into a folder of its own and writes its page; gives the folder.
fn viewed(name: &str, scene: &str, replaced: &[&str]) -> PathBuf {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("view").join(name);
    let _ = fs::remove_dir_all(&out);
    let folder = out.to_str().unwrap();
    let mut arguments = vec!["run", scene, "--out", folder];
    replaced.iter().for_each(|value| arguments.extend(["--set", value]));
    succeeded(&command(&arguments));
    succeeded(&command(&["view", folder, "--no-open"]));
    out
}

/// What stands in a page beside its numbers.
fn head(folder: &Path) -> Value {
    let html = fs::read_to_string(folder.join("view.html")).unwrap();
    let head = html.split("id=\"head\">").nth(1).and_then(|rest| rest.split("</script>").next());
    serde_json::from_str(head.unwrap()).unwrap()
}

fn names(list: &Value) -> Vec<&str> {
    list.as_array().unwrap().iter().map(|entry| entry["name"].as_str().unwrap()).collect()
}

const STRESSES: &str = "output.fields={ stresses = true }";

#[test]
fn a_page_holds_frames_fields_sets_curve_and_scene() {
    let folder = viewed("ring", "scenes/ring.toml", &["analysis.static.levels=8", STRESSES]);
    let head = head(&folder);
    assert_eq!(head["title"], "Ring: a strip rolled into a circle by an end couple");
    let frames = head["frames"].as_array().unwrap();
    assert_eq!((frames.len(), &frames[4]["label"], &frames[4]["row"]), (9, &"level 0.5".into(), &4.into()));
    let body = &head["bodies"][0];
    assert_eq!((&body["name"], &body["count"], &body["shell"]), (&"shell".into(), &250.into(), &true.into()));
    let fields = names(&body["fields"]);
    assert!(["von_mises_top", "moment", "director"].iter().all(|name| fields.contains(name)), "{fields:?}");
    let sets: Vec<&str> =
        body["sets"].as_array().unwrap().iter().map(|set| set[0].as_str().unwrap()).collect();
    assert!(sets.contains(&"u1") && sets.contains(&"centre-row") && !sets.contains(&"all"), "{sets:?}");
    assert!(names(&head["columns"]).contains(&"minus_U_tip") && head["rows"].as_array().unwrap().len() == 9);
    assert_eq!(head["plot"], serde_json::json!(["minus_U_tip", "level"]));
    assert!(head["scene"].as_str().unwrap().contains("centre-row"));
    assert!(fs::metadata(folder.join("view.html")).unwrap().len() <= RING);
}

#[test]
fn a_run_can_be_shown_at_once_and_a_folder_without_frames_has_its_curve() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("view").join("at-once");
    let out = folder.to_str().unwrap();
    let run = ["run", "scenes/hemisphere.toml", "--out", out];
    succeeded(&command(&[&run[..], &["--view"]].concat()));
    let shown = head(&folder);
    assert!(names(&shown["bodies"][0]["fields"]).contains(&"von_mises_top"));
    assert_eq!(shown["reload"], Value::Null);
    succeeded(&command(&run));
    assert!(!folder.join("view.html").exists(), "the page of an earlier run is no result of this one");
    succeeded(&command(&["view", out, "--no-open", "--follow"]));
    let bare = head(&folder);
    assert_eq!((bare["bodies"].as_array().unwrap().len(), bare["rows"].as_array().unwrap().len()), (0, 1));
    let refused = command(&["view", "no-such-folder"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("run a scene first"));
}

#[test]
fn a_page_loads_itself_again_until_its_run_has_ended() {
    let folder = viewed("followed", "scenes/ring.toml", &["analysis.static.levels=2", "output.fields={}"]);
    assert_eq!(head(&folder)["reload"], Value::Null);
    // A run holds its folder by a lock; here the test does.
    let lock = fs::File::create(folder.join("coque.lock")).unwrap();
    lock.lock().unwrap();
    let mut following = Command::new(env!("CARGO_BIN_EXE_coque"))
        .args(["view", "--no-open", "--follow=1"])
        .arg(&folder)
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    while head(&folder)["reload"].is_null() {
        assert!(following.try_wait().unwrap().is_none(), "it ended while the run went on");
        sleep(Duration::from_millis(50));
    }
    assert_eq!(head(&folder)["reload"], 1.0);
    drop(lock);
    assert!(following.wait().unwrap().success());
    assert_eq!(head(&folder)["reload"], Value::Null);
}

#[test]
fn a_dam_break_takes_little_room_and_is_seen_straight() {
    let folder = viewed("dam-break", "scenes/dam-break.toml", &["output.fields.every=2"]);
    let head = head(&folder);
    assert_eq!((head["frames"].as_array().unwrap().len(), &head["plane"]), (41, &2.into()));
    assert_eq!(names(&head["bodies"]), ["tank", "water"]);
    assert!(fs::metadata(folder.join("view.html")).unwrap().len() <= DAM_BREAK);
}

/// A short run of each kind: scene, what is replaced, and the field that is shown first.
const KINDS: [(&str, &str, &[&str], &str); 10] = [
    ("shell", "scenes/ring.toml", &["analysis.static.levels=4", STRESSES], "von_mises (both faces)"),
    ("mesh", "scenes/open-cylinder.toml", &["analysis.static.levels=4", STRESSES], "von_mises (both faces)"),
    ("linear", "scenes/plate.toml", &["output.fields={}"], "displacement"),
    ("modes", "scenes/plate-buckling.toml", &["output.fields={}"], "displacement"),
    ("galerkin", "scenes/thick-ring-solid.toml", &[STRESSES], "von_mises"),
    ("bonds", "scenes/crack-branching.toml", &["analysis.explicit.transient.duration=2e-5"], "damage"),
    ("sheets", "scenes/plate-pd.toml", &["analysis.static.levels=2", "output.fields={}"], "displacement"),
    ("heat", "scenes/cooled-fin.toml", &["output.fields={}"], "temperature"),
    ("fluid", "scenes/dam-break.toml", &["analysis.explicit.transient.duration=0.1"], "pressure"),
    ("coupled", "scenes/gate.toml", &["analysis.explicit.transient.duration=0.04"], "pressure"),
];

/// Without a card of its own a browser draws by the processor; time is counted by what the page does, not by the clock.
const FLAGS: [&str; 4] = [
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--window-size=1000,700",
    "--virtual-time-budget=60000",
];

/// Opens a page and gives what it answers about itself.
fn answers(browser: &str, folder: &Path) -> Value {
    let (dom, log) = browser::opened(browser, &FLAGS, &folder.join("view.html"), "#selftest");
    let said = dom.split("<pre id=\"selftest\">").nth(1).and_then(|rest| rest.split("</pre>").next());
    let said = said.unwrap_or_else(|| panic!("{}: no answer\n{log}", folder.display()));
    let faults: Vec<&str> = log.lines().filter(|line| line.contains("CONSOLE")).collect();
    assert!(faults.is_empty(), "{}: {faults:?}", folder.display());
    let plain = said.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
    serde_json::from_str(&plain).unwrap()
}

#[test]
fn a_browser_draws_every_kind_of_run() {
    let Some(browser) = browser::browser("no page is looked at") else { return };
    for (name, scene, replaced, field) in KINDS {
        let found = answers(browser, &viewed(&format!("kind-{name}"), scene, replaced));
        assert_eq!((&found["failed"], &found["faults"]), (&Value::Null, &serde_json::json!([])), "{name}");
        assert_eq!(found["field"], field, "{name}");
        // A thin strip across the picture covers a hundredth of it.
        assert!(found["share"].as_f64().unwrap() > 0.01, "{name}: {found}");
        let frames = found["frames"].as_u64().unwrap();
        let marks = &found["marks"];
        assert!(frames == 1 || found["moved"] == true && marks[0] != marks[1], "{name}: {found}");
        // Places at rest and now, then every field.
        assert_eq!(
            found["probe"].as_u64(),
            found["fields"].as_u64().map(|fields| fields + 2),
            "{name}: {found}"
        );
        // Spheres cut each other, discs do not; other bodies have neither.
        let particles = ["fluid", "coupled"].contains(&name);
        assert_eq!(found["spheres"].as_bool(), particles.then_some(true), "{name}: {found}");
        assert_eq!(found["hidden"], true, "{name}: what lies out of the range is still seen");
    }
}

#[test]
fn titles_and_sets_that_look_like_scripts_stay_words() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("view").join("evil");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let evil = "</script><img src=x onerror='document.title=1'> \\\"";
    let scene =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/ring.toml")).unwrap();
    let title = "title = \"Ring: a strip rolled into a circle by an end couple\"";
    assert!(scene.contains(title));
    let scene = scene.replace(title, &format!("title = \"{evil}\""));
    let scene = format!("{scene}\n[sets.\"{evil}\"]\nbox = {{ min = [0, 0, 0], max = [1, 1, 0] }}\n");
    let file = folder.join("evil.toml");
    fs::write(&file, scene).unwrap();
    let out = viewed("evil/out", file.to_str().unwrap(), &["analysis.static.levels=2", "output.fields={}"]);
    let plain = evil.replace("\\\"", "\"");
    let head = head(&out);
    assert_eq!(head["title"], plain.as_str());
    assert!(head["bodies"][0]["sets"].as_array().unwrap().iter().any(|set| set[0] == plain.as_str()));
    let html = fs::read_to_string(out.join("view.html")).unwrap();
    assert!(!html.contains("<img"));
    let Some(browser) = browser::browser("the page of such a title is read, not opened") else { return };
    let found = answers(browser, &out);
    assert_eq!((&found["failed"], &found["faults"]), (&Value::Null, &serde_json::json!([])));
}
