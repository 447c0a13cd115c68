//! `coque plot`: the last frame of a run, or its curve, as a picture without a viewer.

use std::io::Write;
use std::path::{Path, PathBuf};

use crate::{
    Picture, ReadError, Sheet, listed, picture_range, picture_svg, plot_svg, strip, together, write_whole,
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
    /// Number of the frame, from 0 [default: the last].
    #[arg(long, value_name = "N")]
    frame: Option<usize>,
    /// Draw so many frames side by side, from the first to the last, in the same colours.
    #[arg(long, value_name = "N", conflicts_with = "frame", value_parser = clap::value_parser!(u8).range(1..=12))]
    frames: Option<u8>,
    /// Ends of the colours [default: the least and the greatest value].
    #[arg(long, value_name = "LOW,HIGH", allow_hyphen_values = true, value_parser = range)]
    range: Option<[f64; 2]>,
    /// Where the viewer stands: azimuth and height in degrees.
    #[arg(long, value_name = "AZIMUTH,HEIGHT", allow_hyphen_values = true, value_parser = view, default_value = "-60,30")]
    view: [f64; 2],
    /// Mirror a part in planes through the origin to the whole: x, y, z are the normals of its symmetry planes.
    #[arg(long, value_name = "AXES", value_parser = axes, default_value = "")]
    mirror: Axes,
    /// Draw displacements so many times as large.
    #[arg(long, value_name = "FACTOR", value_parser = factor, default_value = "1")]
    scale: f64,
    /// Draw the curve instead: this column along, that one up.
    #[arg(long, value_name = "X,Y", value_parser = columns, conflicts_with_all = ["field", "body", "frame", "frames", "range", "view", "mirror", "scale"])]
    curve: Option<(String, String)>,
    /// The picture [default: DIR/shape.svg, or DIR/curve.svg].
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
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
    let mut drawn = Vec::new();
    for number in numbers(plot, &lists[0], series[0].len())? {
        drawn.push(frame(&lists, &series, number)?);
    }
    let field = plot.field.as_deref();
    let mut range = plot.range;
    if range.is_none() && drawn.len() > 1 {
        let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
        for (sheet, _, _) in &drawn {
            let [low, high] = picture_range(sheet, field).map_err(|e| format!("{e}\n"))?;
            ends = [ends[0].min(low), ends[1].max(high)];
        }
        range = Some(ends);
    }
    let scene = title(&plot.folder, read_summary(&plot.folder).as_ref());
    let curve = read_curve(&plot.folder).unwrap_or_default();
    let places: Vec<f64> = series[0].iter().map(|(along, _)| *along).collect();
    let places = Along::of(&curve, &places);
    let mut pictures = Vec::new();
    for (sheet, number, along) in &drawn {
        let instant = places.words(*along).unwrap_or_else(|| format!("frame {number} at {}", short(*along)));
        let title = format!("{scene}: {instant}");
        let (view, mirror, scale) = (plot.view, &plot.mirror.0[..], plot.scale);
        let wanted = Picture { field, view, mirror, scale, range, title: &title };
        pictures.push(picture_svg(sheet, &wanted).map_err(|e| format!("{e}\n"))?);
    }
    let svg = if let [one] = &pictures[..] { one.clone() } else { strip(&pictures) };
    let out = plot.out.clone().unwrap_or_else(|| plot.folder.join("shape.svg"));
    let written = write_whole(&out, |to| to.write_all(svg.as_bytes()));
    written.map_err(|e| format!("cannot write {}: {e}\n", out.display()))?;
    Ok(out)
}

/// Numbers of the frames that are drawn: one, or so many from the first to the last.
fn numbers(plot: &Plot, list: &Path, count: usize) -> Result<Vec<usize>, String> {
    let Some(wanted) = plot.frames else {
        let number = plot.frame.unwrap_or(count.saturating_sub(1));
        if number < count {
            return Ok(vec![number]);
        }
        return Err(format!("{} has no frame {number}; it lists {count}, from 0 on\n", list.display()));
    };
    let wanted = usize::from(wanted).min(count);
    if wanted == 0 {
        return Err(format!("{} lists no frame; run the scene again with [output.fields]\n", list.display()));
    }
    Ok((0..wanted).map(|i| i * (count - 1) / wanted.saturating_sub(1).max(1)).collect())
}

/// A frame of all bodies together, with its number and where it stands.
fn frame(
    lists: &[PathBuf],
    series: &[Vec<(f64, PathBuf)>],
    number: usize,
) -> Result<(Sheet, usize, f64), String> {
    let (mut sheets, mut at) = (Vec::new(), 0.0);
    for (list, frames) in lists.iter().zip(series) {
        let Some((along, path)) = frames.get(number) else {
            let count = frames.len();
            return Err(format!("{} has no frame {number}; it lists {count}, from 0 on\n", list.display()));
        };
        sheets.push(Sheet::read(path).map_err(unread)?);
        at = *along;
    }
    let sheet = if let [_] = sheets[..] { sheets.remove(0) } else { together(sheets) };
    Ok((sheet, number, at))
}

/// Lists of the frames that are drawn: of a lone body its own, of several those of all or of the one that is named.
fn lists(plot: &Plot) -> Result<Vec<PathBuf>, String> {
    let of = |name: &str| plot.folder.join("fields").join(name);
    if let Some(body) = &plot.body {
        return Ok(vec![of(&format!("{body}.pvd"))]);
    }
    let all = frame_lists(&plot.folder);
    let [shell, solid] = ["shell.pvd", "solid.pvd"].map(of);
    // Beside the list of a lone shell that of a solid is the same shell with its thickness.
    if all.is_empty() || all == [shell.clone(), solid] {
        return Ok(vec![shell]);
    }
    // Of a shell beside others what has its thickness is drawn, if it was written.
    let thick = |list: &PathBuf| {
        let name = list.file_stem().unwrap_or_default().to_string_lossy();
        list.with_file_name(format!("{name}-solid.pvd"))
    };
    Ok(all.iter().filter(|list| !all.contains(&thick(list))).cloned().collect())
}

fn unread(error: ReadError) -> String {
    format!("{error}; run the scene again with [output.fields]\n")
}
