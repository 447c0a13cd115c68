//! `cargo xtask gallery`: every scene of the repository run and drawn, on one page of pictures.

use crate::cargo;
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What is drawn.
#[derive(Args)]
pub struct Options {
    /// Seconds after which a run is asked to end; its picture is that of the last state kept
    #[arg(long, value_name = "SECONDS", default_value_t = 20)]
    seconds: u64,
    /// Only scenes whose file names contain this
    filter: Option<String>,
}

/// Scenes in the plane, seen straight.
const PLANE: [&str; 16] = [
    "baffle",
    "box-in-waves",
    "channel-with-inflow",
    "crack-branching",
    "dam-break",
    "floating-box",
    "floating-cylinder",
    "flow-between-plates",
    "gate",
    "gate-bonds",
    "kalthoff",
    "open-channel",
    "paddle-on-hinge",
    "shell-in-water",
    "wave-flume",
    "wedge-entry",
];

/// A scene on the page.
struct Entry {
    /// File below the root.
    scene: String,
    title: String,
    /// Picture beside the page, or why there is none.
    picture: Result<String, String>,
}

/// Runs the scenes, draws them, writes the page.
pub fn run(options: &Options) -> Result<(), String> {
    let root = cargo::root();
    let build = cargo::words(&["build", "--release", "--package", "coque", "--bin", "coque"]);
    if !cargo::succeeds(&build)? {
        return Err(format!("{} failed; its message stands above", cargo::spelled(&build)));
    }
    let program = root.join("target/release").join(format!("coque{}", std::env::consts::EXE_SUFFIX));
    let folder = root.join("target/gallery");
    fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    let mut entries = Vec::new();
    for scene in scenes(&root)? {
        let wanted = options.filter.as_ref().is_none_or(|filter| scene.contains(filter.as_str()));
        if !wanted {
            continue;
        }
        let text =
            fs::read_to_string(root.join(&scene)).map_err(|error| format!("cannot read {scene}: {error}"))?;
        let picture =
            draw(&program, (&root.join(&scene), &text), &folder, Duration::from_secs(options.seconds));
        println!("{scene}: {}", picture.as_ref().map_or_else(|why| why.as_str(), |_| "drawn"));
        entries.push(Entry { title: title(&text).to_owned(), scene, picture });
    }
    let page = folder.join("index.html");
    fs::write(&page, html(&entries)).map_err(|error| format!("cannot write {}: {error}", page.display()))?;
    println!("gallery: {}", page.display());
    let missing = entries.iter().filter(|entry| entry.picture.is_err()).count();
    if missing == 0 {
        Ok(())
    } else {
        Err(format!("{missing} scenes have no picture; the lines above say why"))
    }
}

/// All scenes, sorted, relative to the root.
fn scenes(root: &Path) -> Result<Vec<String>, String> {
    let mut found = Vec::new();
    for folder in ["scenes", "scenes/meshes"] {
        let entries =
            fs::read_dir(root.join(folder)).map_err(|error| format!("cannot read {folder}: {error}"))?;
        let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
        found.extend(names.filter(|name| name.ends_with(".toml")).map(|name| format!("{folder}/{name}")));
    }
    found.sort();
    Ok(found)
}

fn title(text: &str) -> &str {
    let quoted = text.lines().find_map(|line| line.strip_prefix("title = \"")?.split('"').next());
    quoted.unwrap_or("without a title")
}

/// Runs a scene and draws it; the name of the picture in the folder.
fn draw(
    program: &Path,
    (scene, text): (&Path, &str),
    folder: &Path,
    limit: Duration,
) -> Result<String, String> {
    let name = scene.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let out: PathBuf = folder.join(&name);
    let _ = fs::remove_dir_all(&out);
    let mut run = Command::new(program);
    run.arg("run").arg(scene).arg("--out").arg(&out).stdout(Stdio::null()).stderr(Stdio::null());
    if !text.contains("fields") {
        run.args(["--set", "output.fields={}"]);
    }
    let mut child = run.spawn().map_err(|error| format!("cannot start coque: {error}"))?;
    let start = Instant::now();
    let mut asked = false;
    loop {
        match child.try_wait().map_err(|error| format!("cannot wait for coque: {error}"))? {
            Some(status) if asked || matches!(status.code(), Some(0 | 4)) => break,
            Some(status) => return Err(format!("coque run ended with {status}")),
            None if !asked && start.elapsed() > limit => {
                asked = true;
                let end = Command::new("kill").arg(child.id().to_string()).status();
                end.map_err(|error| format!("cannot ask the run to end: {error}"))?;
            }
            None => std::thread::sleep(Duration::from_millis(20)),
        }
    }
    let mut plot = Command::new(program);
    plot.arg("plot").arg(&out).stdout(Stdio::null());
    if PLANE.contains(&name.as_str()) {
        plot.arg("--view=-90,90");
    }
    let output = plot.output().map_err(|error| format!("cannot start coque: {error}"))?;
    if output.status.success() {
        Ok(format!("{name}/shape.svg"))
    } else {
        Err(String::from_utf8_lossy(&output.stderr).trim().to_owned())
    }
}

/// The page: a picture, a title and the command of each scene.
fn html(entries: &[Entry]) -> String {
    let escaped = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;");
    let mut out = String::from(
        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>coque: scenes</title><style>\
         body{font:15px sans-serif;margin:2em;display:grid;grid-template-columns:repeat(auto-fill,minmax(24em,1fr));gap:1.5em}\
         h1{grid-column:1/-1;margin:0}figure{margin:0}img{width:100%;height:17em;object-fit:contain}code{color:#555}</style>\
         <h1>Scenes of coque</h1>",
    );
    for entry in entries {
        let picture = match &entry.picture {
            Ok(file) => format!("<a href=\"{file}\"><img loading=\"lazy\" src=\"{file}\" alt=\"\"></a>"),
            Err(why) => format!("<p>no picture: {}</p>", escaped(why)),
        };
        let (title, scene) = (escaped(&entry.title), escaped(&entry.scene));
        out.push_str(&format!(
            "<figure>{picture}<figcaption>{title}<br><code>coque run {scene}</code></figcaption></figure>\n"
        ));
    }
    out.push_str("</html>\n");
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_of_the_repository_is_on_the_page() {
        let found = scenes(&cargo::root()).unwrap_or_default();
        assert!(found.len() >= 49, "{}", found.len());
        let is_one = |name: &&str| found.iter().any(|path| path.ends_with(&format!("/{name}.toml")));
        assert!(PLANE.iter().all(is_one));
        let entry = |picture: Result<String, String>| Entry {
            scene: "scenes/a.toml".into(),
            title: title("# a\ntitle = \"A <b>\"\n").into(),
            picture,
        };
        let page = html(&[entry(Ok("a/shape.svg".into())), entry(Err("ended".into()))]);
        assert!(page.contains("src=\"a/shape.svg\"") && page.contains("no picture: ended"));
        assert!(page.contains("A &lt;b>") && page.contains("coque run scenes/a.toml"));
    }
}
