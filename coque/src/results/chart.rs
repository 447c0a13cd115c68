//! Error against cost of a scene as a picture: a line a method over logarithmic axes, SVG.

use std::io::Write;
use std::path::Path;

use mesh_io::write_whole;
use plotters::prelude::*;

use super::plot::PlotError;
use crate::plain::plain_text;

/// Colours of the methods, in turn: distinguished by people who see red and green alike.
const COLOURS: [RGBColor; 4] =
    [RGBColor(0, 114, 178), RGBColor(213, 94, 0), RGBColor(0, 158, 115), RGBColor(204, 121, 167)];

/// Runs of a method, each with its wall time \[s\] and its error \[–\].
pub struct Costs {
    /// The method in words.
    pub method: String,
    /// Time and error of each run, coarse to fine.
    pub runs: Vec<[f64; 2]>,
}

/// Draws errors over times into an SVG file; runs without an error are left out.
///
/// # Errors
/// [`PlotError`] where nothing can be drawn or the file cannot be written.
pub fn costs_svg(costs: &[Costs], title: &str, file: &Path) -> Result<(), PlotError> {
    let refused = |reason: String| PlotError::Drawing { path: file.display().to_string(), reason };
    let shown: Vec<(&str, Vec<(f64, f64)>)> = costs
        .iter()
        .map(|costs| {
            let runs = costs.runs.iter().map(|&[time, error]| (time, error));
            (costs.method.as_str(), runs.filter(|(time, error)| *time > 0.0 && *error > 0.0).collect())
        })
        .collect();
    if shown.iter().all(|(_, runs)| runs.is_empty()) {
        return Err(refused("no run has an error".into()));
    }
    let svg = draw(&shown, &plain_text(title)).map_err(|error| refused(error.to_string()))?;
    write_whole(file, |to| to.write_all(svg.as_bytes())).map_err(|error| refused(error.to_string()))
}

fn draw(methods: &[(&str, Vec<(f64, f64)>)], title: &str) -> Result<String, Box<dyn std::error::Error>> {
    let mut svg = String::new();
    let area = SVGBackend::with_string(&mut svg, (720, 480)).into_drawing_area();
    area.fill(&WHITE)?;
    let all = || methods.iter().flat_map(|(_, runs)| runs.iter().copied());
    let (times, errors) = (decades(all().map(|run| run.0)), decades(all().map(|run| run.1)));
    let mut chart = ChartBuilder::on(&area)
        .caption(title, ("sans-serif", 22))
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(70)
        .build_cartesian_2d(times.log_scale(), errors.log_scale())?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc("time of the run [s]")
        .y_desc("error over the greatest value [-]")
        .x_label_formatter(&|x| format!("{x:e}"))
        .y_label_formatter(&|y| format!("{y:e}"))
        .label_style(("sans-serif", 16))
        .draw()?;
    for ((method, runs), colour) in methods.iter().zip(COLOURS.into_iter().cycle()) {
        chart
            .draw_series(LineSeries::new(runs.iter().copied(), colour.stroke_width(2)))?
            .label(*method)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], colour.stroke_width(2)));
        chart.draw_series(runs.iter().map(|&run| Circle::new(run, 4, colour.filled())))?;
    }
    chart.configure_series_labels().background_style(WHITE.mix(0.8)).label_font(("sans-serif", 15)).draw()?;
    area.present()?;
    drop(chart);
    drop(area);
    Ok(svg)
}

/// Whole decades about some numbers above zero.
fn decades(values: impl Iterator<Item = f64> + Clone) -> std::ops::Range<f64> {
    let low = values.clone().fold(f64::INFINITY, f64::min);
    let high = values.fold(0.0, f64::max);
    let power = |x: f64| libm::pow(10.0, x);
    power(libm::floor(libm::log10(low)))..power(libm::floor(libm::log10(high)) + 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_hold_whole_decades() {
        let range = decades([0.02, 0.5, 3.0].into_iter());
        assert!((range.start - 0.01).abs() < 1e-12 && (range.end - 10.0).abs() < 1e-9);
    }

    #[test]
    fn a_chart_names_its_methods_and_nothing_is_no_chart() {
        let file = std::env::temp_dir().join(format!("coque-costs-{}.svg", std::process::id()));
        let costs = Costs { method: "cells, static".into(), runs: vec![[0.01, 0.2], [0.04, 0.05]] };
        costs_svg(&[costs], "A plate", &file).unwrap();
        let svg = std::fs::read_to_string(&file).unwrap();
        assert!(svg.contains("cells, static") && svg.contains("A plate"));
        std::fs::remove_file(&file).unwrap();
        assert!(costs_svg(&[], "nothing", &file).is_err() && !file.exists());
    }
}
