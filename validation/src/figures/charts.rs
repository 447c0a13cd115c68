//! Charts as SVG: lines and marks over linear or logarithmic axes.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::prelude::*;

use super::legend::{self, Colour, GREY, Line, Mark};
use crate::JudgeError;

const SIZE: (u32, u32) = (760, 440);
/// Half size of a mark in pixels.
const MARK: f64 = 4.2;

/// A chart as data.
#[derive(Clone, Debug)]
pub struct Chart {
    /// What is drawn.
    pub title: String,
    /// What to see in it.
    pub caption: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Drawn in this order.
    pub series: Vec<Series>,
}

/// An axis.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Quantity with unit.
    pub label: String,
    /// Whether decades are equally long.
    pub log: bool,
    /// Range shown; that of the points if none.
    pub range: Option<(f64, f64)>,
}

/// Points that belong together.
#[derive(Clone, Debug)]
pub struct Series {
    /// Words in the legend; without, none.
    pub label: String,
    /// Points.
    pub points: Vec<(f64, f64)>,
    /// Colour of line and marks.
    pub colour: Colour,
    /// Mark at each point.
    pub mark: Option<Mark>,
    /// Line through the points.
    pub line: Option<Line>,
}

impl Axis {
    /// Equal steps are equally long.
    pub fn linear(label: &str) -> Self {
        Self { label: label.into(), log: false, range: None }
    }

    /// Equal factors are equally long.
    pub fn log(label: &str) -> Self {
        Self { label: label.into(), log: true, range: None }
    }

    /// Shows this range, whatever the points.
    #[must_use]
    pub fn between(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }

    /// A value in the units of the drawing: itself, or its decimal logarithm.
    fn place(&self, value: f64) -> f64 {
        if self.log { libm::log10(value) } else { value }
    }

    /// Range in the units of the drawing, with a little air.
    fn span(&self, values: impl Iterator<Item = f64>) -> (f64, f64) {
        if let Some((low, high)) = self.range {
            return (self.place(low), self.place(high));
        }
        let start = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = values.fold(start, |(low, high), v| (low.min(v), high.max(v)));
        match high - low {
            width if width > 0.0 => (low - 0.05 * width, high + 0.05 * width),
            0.0 => (low - 0.5, high + 0.5),
            _ => (0.0, 1.0),
        }
    }

    /// Places of the labels: 1, 2, 5 of each decade, or steps of 1, 2 or 5 times a power of ten.
    fn ticks(&self, (low, high): (f64, f64)) -> Vec<f64> {
        if self.log {
            let decades = low.floor() as i32..=high.ceil() as i32;
            let fine = high - low < 3.0;
            let digits: &[f64] = if fine { &[1.0, 2.0, 5.0] } else { &[1.0] };
            return decades
                .flat_map(|k| digits.iter().map(move |digit| f64::from(k) + libm::log10(*digit)))
                .filter(|tick| (low..=high).contains(tick))
                .collect();
        }
        let raw = (high - low) / 8.0;
        let decade = libm::pow(10.0_f64, libm::log10(raw).floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|digit| digit * decade).into_iter().find(|step| *step >= raw);
        let step = step.unwrap_or(10.0 * decade);
        let (first, last) = ((low / step).ceil() as i64, (high / step).floor() as i64);
        (first..=last).map(|i| i as f64 * step).collect()
    }

    fn words(&self, place: f64) -> String {
        crate::format::short(if self.log { libm::pow(10.0_f64, place) } else { place })
    }
}

impl Series {
    /// A line without marks.
    pub fn line(label: &str, points: Vec<(f64, f64)>, colour: Colour, line: Line) -> Self {
        Self { label: label.into(), points, colour, mark: None, line: Some(line) }
    }

    /// Marks without a line.
    pub fn marks(label: &str, points: Vec<(f64, f64)>, colour: Colour, mark: Mark) -> Self {
        Self { label: label.into(), points, colour, mark: Some(mark), line: None }
    }

    /// Marks joined by a line.
    pub fn both(label: &str, points: Vec<(f64, f64)>, colour: Colour, mark: Mark) -> Self {
        Self { label: label.into(), points, colour, mark: Some(mark), line: Some(Line::Solid) }
    }
}

impl Chart {
    /// The drawing, without title and caption, followed by its legend.
    ///
    /// # Errors
    /// [`JudgeError::Chart`] if the drawing library refuses.
    pub fn html(&self) -> Result<String, JudgeError> {
        let refused = |e: DrawingAreaErrorKind<std::io::Error>| JudgeError::Chart {
            title: self.title.clone(),
            reason: e.to_string(),
        };
        let mut svg = String::new();
        {
            let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
            self.draw(&area).map_err(refused)?;
            area.present().map_err(refused)?;
        }
        let entries: String = self
            .series
            .iter()
            .filter(|series| !series.label.is_empty())
            .map(|series| legend::entry(&series.label, series.colour, series.mark, series.line))
            .collect();
        Ok(format!("{svg}<ul class='legend'>{entries}</ul>"))
    }

    fn draw(&self, area: &DrawingArea<SVGBackend<'_>, Shift>) -> Drawn {
        let placed: Vec<Vec<(f64, f64)>> = self.series.iter().map(|series| self.placed(series)).collect();
        let points = || placed.iter().flatten();
        let (x_span, y_span) = (self.x.span(points().map(|p| p.0)), self.y.span(points().map(|p| p.1)));
        let ruler = |axis: &Axis, span| Ruler { span, ticks: axis.ticks(span), axis: axis.clone() };
        area.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(area)
            .margin(10)
            .x_label_area_size(52)
            .y_label_area_size(72)
            .build_cartesian_2d(ruler(&self.x, x_span), ruler(&self.y, y_span))?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(225, 225, 225))
            .axis_style(RGBColor(90, 90, 90))
            .x_desc(self.x.label.as_str())
            .y_desc(self.y.label.as_str())
            .label_style(("sans-serif", 16))
            .axis_desc_style(("sans-serif", 17))
            .draw()?;
        for (series, points) in self.series.iter().zip(placed) {
            series.draw(&mut chart, points)?;
        }
        Ok(())
    }

    /// Points in the units of the drawing; what is not finite there is left out, and a line is cut at a fixed range.
    fn placed(&self, series: &Series) -> Vec<(f64, f64)> {
        let inside =
            |axis: &Axis, value: f64| axis.range.is_none_or(|(low, high)| (low..=high).contains(&value));
        series
            .points
            .iter()
            .filter(|(x, y)| inside(&self.x, *x) && inside(&self.y, *y))
            .map(|(x, y)| (self.x.place(*x), self.y.place(*y)))
            .filter(|(x, y)| x.is_finite() && y.is_finite())
            .collect()
    }
}

type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;
type Plane = Cartesian2d<Ruler, Ruler>;

/// An axis in the units of the drawing, with ticks of our own choice.
struct Ruler {
    span: (f64, f64),
    ticks: Vec<f64>,
    axis: Axis,
}

impl Ranged for Ruler {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let part = (value - self.span.0) / (self.span.1 - self.span.0);
        limit.0 + (part * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.span.0..self.span.1
    }
}

impl ValueFormatter<f64> for Ruler {
    fn format_ext(&self, place: &f64) -> String {
        self.axis.words(*place)
    }
}

impl Series {
    fn draw(&self, chart: &mut ChartContext<'_, SVGBackend<'_>, Plane>, points: Vec<(f64, f64)>) -> Drawn {
        let colour = RGBColor(self.colour.0, self.colour.1, self.colour.2);
        let width = if self.colour == GREY { 1 } else { 2 };
        match self.line {
            Some(Line::Solid) => {
                chart.draw_series(LineSeries::new(points.iter().copied(), colour.stroke_width(width)))?;
            }
            Some(Line::Dashed) => {
                let style = colour.stroke_width(width);
                chart.draw_series(DashedLineSeries::new(points.iter().copied(), 7, 4, style))?;
            }
            None => {}
        }
        let Some(mark) = self.mark else { return Ok(()) };
        let pixels: Vec<(i32, i32)> = mark
            .corners()
            .iter()
            .map(|(x, y)| ((MARK * x).round() as i32, (MARK * y).round() as i32))
            .collect();
        for point in points {
            match mark {
                Mark::Disc => chart.draw_series([Circle::new(point, MARK, colour.filled())])?,
                Mark::Circle => chart.draw_series([Circle::new(point, MARK, colour.stroke_width(2))])?,
                _ => {
                    let mut path = pixels.clone();
                    if mark != Mark::Cross {
                        path.extend(pixels.first().copied());
                    }
                    let path = PathElement::new(path, colour.stroke_width(2));
                    chart.draw_series([EmptyElement::at(point) + path])?
                }
            };
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        let linear = Axis::linear("x");
        assert_eq!(linear.ticks((-0.05, 1.05)), [0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0]);
        assert_eq!(linear.ticks((0.0, 30.0)), [0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0]);
        let words = |axis: &Axis, span| axis.ticks(span).iter().map(|t| axis.words(*t)).collect::<Vec<_>>();
        assert_eq!(words(&linear, (-0.05, 1.05)), ["0", "0.2", "0.4", "0.6", "0.8", "1"]);
        assert_eq!(words(&Axis::log("x"), (-1.2, 0.8)), ["0.1", "0.2", "0.5", "1", "2", "5"]);
        assert_eq!(words(&Axis::log("x"), (-3.0, 2.0)), ["0.001", "0.01", "0.1", "1", "10", "100"]);
    }

    #[test]
    fn empty_and_single_points_have_a_range() {
        let axis = Axis::linear("x");
        assert_eq!(axis.span([].into_iter()), (0.0, 1.0));
        assert_eq!(axis.span([3.0].into_iter()), (2.5, 3.5));
        assert_eq!(Axis::log("x").between(0.1, 10.0).span([7.0].into_iter()), (-1.0, 1.0));
    }

    #[test]
    fn a_chart_draws_every_mark_and_leaves_out_what_is_not_finite() {
        let marks = [Mark::Disc, Mark::Circle, Mark::Square, Mark::Triangle, Mark::Diamond, Mark::Cross];
        let series = marks
            .iter()
            .enumerate()
            .map(|(i, &mark)| Series::both("a", vec![(1.0, 1.0 + i as f64), (2.0, 0.0)], GREY, mark))
            .collect();
        let chart =
            Chart { title: "t".into(), caption: "c".into(), x: Axis::linear("x"), y: Axis::log("y"), series };
        let html = chart.html().unwrap();
        assert_eq!(html.matches("<circle").count(), 2 + 2);
        assert_eq!(html.matches("<li>").count(), marks.len());
        assert!(!html.contains("NaN") && !html.contains("inf"));
    }
}
