//! `coque plot`: frames of a run, or its curve, as a picture without a viewer.

use std::io::Write;
use std::path::{Path, PathBuf};

use crate::{
    Picture, PictureExtent, ReadError, Sheet, listed, picture_extent, picture_svg, plot_svg, strip, together,
    usual_field, write_whole,
};
use clap::Args;

use super::stderr::{Refused, say};
use crate::shown::folder::{Along, frame_lists, read_curve, read_summary, short, title};

#[derive(Args)]
pub struct Plot {
    /// Folder of a run; of a scene with [output.fields] unless --curve is given.
    folder: PathBuf,
    /// A field, or a component of one: von_mises_top, displacement.z, moment.11 … [default: pressure of a fluid, damage
    /// where there is any, von_mises_top, else displacement]
    #[arg(long, value_name = "FIELD")]
    field: Option<String>,
    /// Of several bodies draw this one alone.
    #[arg(long, value_name = "NAME")]
    body: Option<String>,
    /// Number of the frame, from 0.
    #[arg(long, value_name = "N")]
    frame: Option<usize>,
    /// Which frames are drawn, side by side: all, so many from the first to the last, or the last.
    #[arg(long, value_name = "all|N|last", conflicts_with = "frame", value_parser = frames, default_value = "last")]
    frames: Frames,
    /// Ends of the colours [default: the least and the greatest value of all frames; where outliers would leave all others
    /// one colour, the ends that 2 % of a frame's values lie beyond, which the colour bar says].
    #[arg(long, value_name = "LOW,HIGH", allow_hyphen_values = true, value_parser = range)]
    range: Option<[f64; 2]>,
    /// Where the viewer stands: azimuth and height in degrees.
    #[arg(long, value_name = "AZIMUTH,HEIGHT", allow_hyphen_values = true, value_parser = view, default_value = "-60,30")]
    view: [f64; 2],
    /// Mirror a part in planes through the origin to the whole: x, y, z are the normals of its symmetry planes.
    #[arg(long, value_name = "AXES", value_parser = axes, default_value = "")]
    mirror: Axes,
    /// Draw displacements so many times as large; of a mode, which has no size, 1 is a tenth of the body's diagonal.
    #[arg(long, value_name = "FACTOR", value_parser = factor, default_value = "1")]
    scale: f64,
    /// Draw the curve instead: this column along, that one up.
    #[arg(long, value_name = "X,Y", value_parser = columns, conflicts_with_all = ["field", "body", "frame", "frames", "range", "view", "mirror", "scale"])]
    curve: Option<(String, String)>,
    /// The picture [default: DIR/shape.svg, or DIR/curve.svg].
    #[arg(long, value_name = "FILE", value_parser = svg)]
    out: Option<PathBuf>,
}

pub const HELP: &str = "\
Examples:
  coque plot out/gate --view=-90,90             the last frame, seen straight, in the zoom and colours of the whole run
  coque plot out/gate --view=-90,90 --frames 6  six frames side by side, comparable with each other
  coque plot out/modes --frames all             every mode, with its frequency
  coque plot out/ring --field moment.11 --frame 3 --out moment.svg
  coque plot out/ring --curve minus_U_tip,W_tip

Every picture says the scene's title, the level, time or mode, the field with its unit, its least and greatest value in the run,
and how displacements are drawn where that is not to scale. All bodies share one colour bar; cells across an open crack are left out.";

/// The name of a picture.
fn svg(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let known = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("svg"));
    known.then_some(path).ok_or_else(|| "pictures are SVG: give a name that ends in .svg".into())
}

/// Which frames are drawn.
#[derive(Clone, Copy)]
enum Frames {
    Last,
    All,
    /// So many, evenly from the first to the last.
    Some(usize),
}

/// Frames of one picture beyond which a browser is slow to show it.
const MOST_FRAMES: usize = 100;

fn frames(text: &str) -> Result<Frames, String> {
    match text.trim() {
        "last" => Ok(Frames::Last),
        "all" => Ok(Frames::All),
        number => match number.parse() {
            Ok(count @ 1..=MOST_FRAMES) => Ok(Frames::Some(count)),
            _ => Err(format!("write all, last or a number from 1 to {MOST_FRAMES}")),
        },
    }
}

fn two(text: &str) -> Option<[f64; 2]> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    text.split_once(',').and_then(|(a, b)| Some([number(a)?, number(b)?]))
}

fn view(text: &str) -> Result<[f64; 2], String> {
    two(text).ok_or_else(|| "write two numbers in degrees, such as -60,30".into())
}

fn range(text: &str) -> Result<[f64; 2], String> {
    let ends = two(text).filter(|[low, high]| low < high);
    ends.ok_or_else(|| "write two numbers, the lower one first, such as 0,3000".into())
}

/// Numbers of axes, in their order.
#[derive(Clone)]
struct Axes(Vec<usize>);

fn axes(text: &str) -> Result<Axes, String> {
    let words: Vec<&str> = text.split(',').map(str::trim).filter(|word| !word.is_empty()).collect();
    let axes = ["x", "y", "z"].into_iter().enumerate().filter(|(_, axis)| words.contains(axis));
    let axes: Vec<usize> = axes.map(|(i, _)| i).collect();
    if axes.len() == words.len() {
        Ok(Axes(axes))
    } else {
        Err("write some of x, y and z, each once, such as x,y".into())
    }
}

fn factor(text: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().ok().filter(|x| x.is_finite() && *x >= 0.0);
    number.ok_or_else(|| "write a number from 0 on, such as 50".into())
}

fn columns(text: &str) -> Result<(String, String), String> {
    let both = text.split_once(',').map(|(x, y)| (x.trim().to_string(), y.trim().to_string()));
    both.ok_or_else(|| "write two columns of curve.csv, such as w_crown,P".into())
}

/// Reads, draws, writes; the error is ready to print.
pub fn carry_out(plot: &Plot) -> Result<(), Refused> {
    let out = match &plot.curve {
        None => shape(plot),
        Some((x, y)) => curve(plot, x, y),
    }?;
    say(&out.display().to_string());
    Ok(())
}

fn curve(plot: &Plot, x: &str, y: &str) -> Result<PathBuf, String> {
    let curve = read_curve(&plot.folder)?;
    let out = plot.out.clone().unwrap_or_else(|| plot.folder.join("curve.svg"));
    plot_svg(&curve, x, y, &title(&plot.folder, read_summary(&plot.folder).as_ref()), &out)
        .map_err(|e| format!("{e}\n"))?;
    Ok(out)
}

fn shape(plot: &Plot) -> Result<PathBuf, String> {
    let lists = lists(plot)?;
    let mut series = Vec::new();
    for list in &lists {
        series.push(listed(list).map_err(unread)?);
    }
    let count = series.iter().map(Vec::len).min().unwrap_or_default();
    let numbers = numbers(plot, &lists[0], count)?;
    let (last, _) = frame(&series, count - 1)?;
    let field = plot.field.as_deref().unwrap_or_else(|| usual_field(&last));
    let summary = read_summary(&plot.folder);
    let scene = title(&plot.folder, summary.as_ref());
    let curve = read_curve(&plot.folder).unwrap_or_default();
    let places: Vec<f64> = series[0].iter().map(|(along, _)| *along).collect();
    let places = Along::of(&curve, &places).with_cases(summary.as_ref());
    let (view, mirror) = (plot.view, &plot.mirror.0[..]);
    let own = Picture {
        field: Some(field),
        view,
        mirror,
        scale: plot.scale,
        sizeless: places.are_modes(),
        range: plot.range,
        ..Picture::new(&scene)
    };
    let missing = |e| format!("{e}\n");
    let mut extent: PictureExtent = picture_extent(&last, &own).map_err(missing)?;
    for number in 0..count - 1 {
        // A frame that is not drawn may lack the field.
        if let Ok(other) = picture_extent(&frame(&series, number)?.0, &own) {
            extent = extent.with(&other);
        }
    }
    let mut pictures = Vec::new();
    for number in numbers {
        let (sheet, along) = frame(&series, number)?;
        let instant = places.words(along).unwrap_or_else(|| format!("frame {number} at {}", short(along)));
        let wanted = Picture { extent: Some(extent), instant: &instant, ..own.clone() };
        pictures.push(picture_svg(&sheet, &wanted).map_err(missing)?);
    }
    let svg = if let [one] = &pictures[..] { one.clone() } else { strip(&pictures) };
    let out = plot.out.clone().unwrap_or_else(|| plot.folder.join("shape.svg"));
    let written = write_whole(&out, |to| to.write_all(svg.as_bytes()));
    written.map_err(|e| format!("cannot write {}: {e}\n", out.display()))?;
    Ok(out)
}

/// Numbers of the frames that are drawn, of so many.
fn numbers(plot: &Plot, list: &Path, count: usize) -> Result<Vec<usize>, String> {
    let list = list.display();
    if count == 0 {
        return Err(format!("{list} lists no frame; run the scene again with [output.fields]\n"));
    }
    if let Some(number) = plot.frame {
        let none = || format!("{list} has no frame {number}; it lists {count}, from 0 on\n");
        return (number < count).then(|| vec![number]).ok_or_else(none);
    }
    let wanted = match plot.frames {
        Frames::Last => return Ok(vec![count - 1]),
        Frames::All if count > MOST_FRAMES => {
            return Err(format!(
                "{list} lists {count} frames; --frames {MOST_FRAMES} draws so many of them\n"
            ));
        }
        Frames::All => count,
        Frames::Some(wanted) => wanted.min(count),
    };
    Ok((0..wanted).map(|i| i * (count - 1) / (wanted - 1).max(1)).collect())
}

/// A frame of all bodies together, and where it stands.
fn frame(series: &[Vec<(f64, PathBuf)>], number: usize) -> Result<(Sheet, f64), String> {
    let mut sheets = Vec::new();
    for frames in series {
        sheets.push(Sheet::read(&frames[number].1).map_err(unread)?);
    }
    let sheet = if let [_] = sheets[..] { sheets.remove(0) } else { together(sheets) };
    Ok((sheet, series[0][number].0))
}

/// Lists of the frames that are drawn: of a lone body its own, of several those of all or of the one that is named.
fn lists(plot: &Plot) -> Result<Vec<PathBuf>, String> {
    let of = |name: &str| plot.folder.join("fields").join(name);
    if let Some(body) = &plot.body {
        return Ok(vec![of(&format!("{body}.pvd"))]);
    }
    let (tools, all): (Vec<PathBuf>, Vec<PathBuf>) =
        frame_lists(&plot.folder).into_iter().partition(|list: &PathBuf| are_tools(list));
    let [shell, solid] = ["shell.pvd", "solid.pvd"].map(of);
    // Beside the list of a lone shell that of a solid is the same shell with its thickness.
    if all.is_empty() || all == [shell.clone(), solid] {
        return Ok([vec![shell], tools].concat());
    }
    // Of a shell beside others what has its thickness is drawn, if it was written.
    let thick = |list: &PathBuf| {
        let name = list.file_stem().unwrap_or_default().to_string_lossy();
        list.with_file_name(format!("{name}-solid.pvd"))
    };
    let bodies = all.iter().filter(|list| !all.contains(&thick(list))).cloned();
    Ok(bodies.chain(tools).collect())
}

/// Whether a list is one of tools.
fn are_tools(list: &Path) -> bool {
    let name = list.file_stem().unwrap_or_default().to_string_lossy();
    name == "tools" || name.ends_with("-tools")
}

fn unread(error: ReadError) -> String {
    format!("{error}; run the scene again with [output.fields]\n")
}
