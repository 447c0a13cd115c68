//! The curve as a picture: one line, with its points where they are few, in a band of its errors where they stand beside it, SVG.

use std::io::Write;
use std::ops::Range;
use std::path::Path;

use plotters::coord::ranged1d::ValueFormatter;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

use mesh_io::write_whole;

use crate::plain::plain_text;
use crate::results::curve::Curve;
use crate::results::error_bars::bar_of;

/// Width in pixels.
const WIDTH: u32 = 720;
/// Rows beyond which the line alone is drawn: its points would touch each other.
const MOST_POINTS: usize = 60;

/// Why a plot could not be made.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// No such column.
    #[error("the curve has no column `{name}`; it has {known}")]
    NoColumn {
        /// What was asked for.
        name: String,
        /// What there is.
        known: String,
    },
    /// Drawing or writing failed.
    #[error("cannot draw {path}: {reason}")]
    Drawing {
        /// The file.
        path: String,
        /// What went wrong.
        reason: String,
    },
}

/// Draws column `y` over column `x` into an SVG file; rows that are not finite are left out.
///
/// # Errors
/// [`PlotError`] for an unknown column or a file that cannot be written.
pub fn plot_svg(curve: &Curve, x: &str, y: &str, title: &str, file: &Path) -> Result<(), PlotError> {
    plot_scaled(curve, [x, y], Scales::default(), title, file)
}

/// Which axes of a plot go by powers of ten: on them values that are not above zero are left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Scales {
    /// The horizontal one.
    pub log_x: bool,
    /// The vertical one.
    pub log_y: bool,
}

/// The same with axes of a kind.
///
/// # Errors
/// [`PlotError`] for an unknown column or a file that cannot be written.
pub fn plot_scaled(
    curve: &Curve,
    [x, y]: [&str; 2],
    scales: Scales,
    title: &str,
    file: &Path,
) -> Result<(), PlotError> {
    let values = |name: &str| {
        curve.column(name).ok_or_else(|| PlotError::NoColumn {
            name: name.into(),
            known: curve.columns.iter().map(|c| c.name.as_str()).collect::<Vec<_>>().join(", "),
        })
    };
    let shown = |x: f64, y: f64| {
        let on_axis = |value: f64, log: bool| value.is_finite() && (value > 0.0 || !log);
        on_axis(x, scales.log_x) && on_axis(y, scales.log_y)
    };
    let points: Vec<(f64, f64)> =
        values(x)?.into_iter().zip(values(y)?).filter(|&(x, y)| shown(x, y)).collect();
    let bars = curve.column(&bar_of(y)).unwrap_or_default();
    let band = values(x)?.into_iter().zip(values(y)?).zip(bars).map(|((x, y), bar)| (x, [y - bar, y + bar]));
    let band: Vec<(f64, [f64; 2])> = band.filter(|&(x, ends)| shown(x, ends[0])).collect();
    let label = |name: &str| {
        let column = curve.columns.iter().find(|column| column.name == name);
        column.map_or_else(|| name.to_string(), |column| column.title())
    };
    let refused = |reason: String| PlotError::Drawing { path: file.display().to_string(), reason };
    let words = Words { x: &label(x), y: &label(y), title: &plain_text(title) };
    let svg = draw(&points, &band, scales, &words).map_err(|e| refused(e.to_string()))?;
    write_whole(file, |to| to.write_all(svg.as_bytes())).map_err(|e| refused(e.to_string()))
}

/// What stands beside a plot.
struct Words<'a> {
    x: &'a str,
    y: &'a str,
    title: &'a str,
}

type Band = [(f64, [f64; 2])];

fn draw(
    points: &[(f64, f64)],
    band: &Band,
    Scales { log_x, log_y }: Scales,
    words: &Words<'_>,
) -> Result<String, Box<dyn std::error::Error>> {
    let xs = points.iter().map(|p| p.0);
    let ys = points.iter().map(|p| p.1).chain(band.iter().flat_map(|(_, ends)| *ends));
    let linear = |range: Range<f64>| RangedCoordf64::from(range);
    let powers = |range: Range<f64>| LogCoord::from(range.log_scale());
    match (log_x, log_y) {
        (false, false) => drawn(points, band, (linear(range(xs)), linear(range(ys))), words),
        (true, false) => drawn(points, band, (powers(decades(xs)), linear(range(ys))), words),
        (false, true) => drawn(points, band, (linear(range(xs)), powers(decades(ys))), words),
        (true, true) => drawn(points, band, (powers(decades(xs)), powers(decades(ys))), words),
    }
}

fn drawn<X, Y>(
    points: &[(f64, f64)],
    band: &Band,
    (x_axis, y_axis): (X, Y),
    words: &Words<'_>,
) -> Result<String, Box<dyn std::error::Error>>
where
    X: Ranged<ValueType = f64> + ValueFormatter<f64>,
    Y: Ranged<ValueType = f64> + ValueFormatter<f64>,
{
    let Words { x: x_label, y: y_label, title } = *words;
    let mut svg = String::new();
    // A letter is about half as wide as it is high.
    let size = (WIDTH as f64 / (0.53 * title.chars().count().max(1) as f64)).min(22.0);
    let area = SVGBackend::with_string(&mut svg, (WIDTH, 480)).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .caption(title, ("sans-serif", size))
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(70)
        .build_cartesian_2d(x_axis, y_axis)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc(x_label)
        .y_desc(y_label)
        .x_label_formatter(&|x| short(*x))
        .y_label_formatter(&|y| short(*y))
        .label_style(("sans-serif", 16))
        .draw()?;
    let around = band.iter().map(|&(x, [_, top])| (x, top));
    let around: Vec<(f64, f64)> =
        around.chain(band.iter().rev().map(|&(x, [bottom, _])| (x, bottom))).collect();
    if band.len() > 1 {
        chart.draw_series([Polygon::new(around, BLUE.mix(0.18))])?;
    }
    chart.draw_series(LineSeries::new(points.iter().copied(), BLUE.stroke_width(2)))?;
    if points.len() <= MOST_POINTS {
        chart.draw_series(points.iter().map(|&p| Circle::new(p, 3, BLUE.filled())))?;
    }
    area.present()?;
    drop(chart);
    drop(area);
    Ok(svg)
}

/// A number beside an axis: six digits at most, powers of ten where zero after zero would come.
fn short(x: f64) -> String {
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    match rounded.abs() {
        0.0 => "0".into(),
        size if (1e-3..1e5).contains(&size) => format!("{rounded}"),
        _ => format!("{rounded:e}"),
    }
}

/// Range of an axis with a little air; never empty.
fn range(values: impl Iterator<Item = f64> + Clone) -> Range<f64> {
    let low = values.clone().fold(f64::INFINITY, f64::min);
    let high = values.fold(f64::NEG_INFINITY, f64::max);
    if low > high {
        return 0.0..1.0;
    }
    let air = 0.04 * (high - low);
    if air > 0.0 { low - air..high + air } else { low - 1.0..high + 1.0 }
}

/// The same of an axis by powers of ten.
fn decades(values: impl Iterator<Item = f64> + Clone) -> Range<f64> {
    let Range { start, end } = range(values.map(libm::log10));
    libm::exp10(start)..libm::exp10(end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_beside_axes_are_short() {
        assert_eq!(
            [0.1 + 0.2, 2e-5, 0.0, 123456.0, -40.0].map(short),
            ["0.3", "2e-5", "0", "1.23456e5", "-40"]
        );
    }

    #[test]
    fn an_axis_is_never_empty() {
        assert_eq!(range([].into_iter()), 0.0..1.0);
        assert_eq!(range([3.0, 3.0].into_iter()), 2.0..4.0);
        let Range { start, end } = decades([1.0, 1e25].into_iter());
        assert!((start / 0.1 - 1.0).abs() < 1e-12 && (end / 1e26 - 1.0).abs() < 1e-12);
    }
}
