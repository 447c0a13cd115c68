//! What the report shows of the panel: paths, limit points, shapes, cost, and the paper's own statement.

use benchmarks_ref::fe_shell::cases::{PanelSection, panel_shape};
use benchmarks_ref::{ReferenceError, reference};

use super::{FAST, LIMIT, limit_point, path, sze};
use crate::JudgeError;
use crate::figures::{
    Axis, BLACK, BLUE, Chart, Figure, GREEN, Line, Mark, Note, Numbers, ORANGE, Series, Shapes, Sheet,
    VERMILION, shade,
};
use crate::format::short;
use crate::judge::{Run, Runs};
use crate::methods::{CELL, ELEMENTS, METHODS, NODAL_3, STRONG_12, STRONG_085, STRONG_DIFFERENCE};

const DISPLACEMENT: &str = "displacement of the crown [mm]";
const LOAD: &str = "load on the whole panel [kN]";

/// Everything, in order.
pub fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut figures = vec![Figure::Chart(whole_path(runs)?), Figure::Chart(limit(runs)?)];
    figures.push(Figure::Numbers(limit_points(runs)?));
    if let Some(run) = runs.get(CELL, "21×21")? {
        figures.push(Figure::Shapes(shapes(run)));
        figures.push(Figure::Shapes(beside_elements(run)?));
    }
    figures.push(Figure::Chart(all_methods(runs)?));
    if let Some(run) = runs.get(FAST, "21×21")? {
        figures.push(Figure::Chart(fast(runs, run)?));
        figures.push(Figure::Note(statement(run)?));
    }
    Ok(figures)
}

fn points(run: &Run) -> Result<Vec<(f64, f64)>, JudgeError> {
    let (w, p) = path(run)?;
    Ok(w.into_iter().zip(p).collect())
}

fn table_of_sze() -> Result<Series, JudgeError> {
    let (w, p) = sze()?;
    Ok(Series::marks("Sze et al. 2004, S4R", w.into_iter().zip(p).collect(), GREEN, Mark::Cross))
}

fn bricks() -> Result<Series, JudgeError> {
    let table = reference("fe_hinged_roof_t12p7_isotropic")?;
    let loads = table.column("P")?.into_iter().map(|p| 1e-3 * p);
    let points = table.column("minus_W_C")?.into_iter().zip(loads).collect();
    Ok(Series::line("CalculiX, 16×16 bricks", points, BLACK, Line::Solid))
}

fn paper(top: f64, bottom: f64) -> Series {
    Series::line(
        "Lin et al. 2013: limit at 10.5 mm",
        vec![(10.5, bottom), (10.5, top)],
        VERMILION,
        Line::Dashed,
    )
}

fn whole_path(runs: &Runs) -> Result<Chart, JudgeError> {
    let mut series = vec![bricks()?, table_of_sze()?, paper(LIMIT, 0.0)];
    if let Some(run) = runs.get(CELL, "21×21")? {
        series.push(Series::marks("stress-point cell 21×21", points(run)?, BLUE, Mark::Disc));
    }
    Ok(Chart {
        title: "Load against displacement of the crown".into(),
        caption: "Three independent results lie on one line through limit point and dip. Towards 30 mm they part a \
                  little: a point load has no finite displacement in a shear-flexible shell."
            .into(),
        x: Axis::linear(DISPLACEMENT),
        y: Axis::linear(LOAD),
        series,
    })
}

fn limit(runs: &Runs) -> Result<Chart, JudgeError> {
    let mut series = vec![bricks()?, table_of_sze()?, paper(2.25, 2.1)];
    for (grid, part) in [("11×11", 0.0), ("21×21", 0.5), ("41×41", 1.0)] {
        if let Some(run) = runs.get(CELL, grid)? {
            let label = format!("stress-point cell {grid}");
            series.push(Series::both(&label, points(run)?, shade(part), Mark::Disc));
        }
    }
    if let Some(run) = runs.get(NODAL_3, "21×21")? {
        series.push(Series::marks("nodal 3 21×21", points(run)?, ORANGE, Mark::Triangle));
    }
    Ok(Chart {
        title: "The limit point, enlarged".into(),
        caption: "All results stay within 1.2 % of each other. The curve is so flat that the place of its top says \
                  little: a change of 0.2 % in load moves it by half a millimetre."
            .into(),
        x: Axis::linear(DISPLACEMENT).between(8.9, 13.1),
        y: Axis::linear(LOAD).between(2.08, 2.25),
        series,
    })
}

fn limit_points(runs: &Runs) -> Result<Numbers, JudgeError> {
    let table = reference("seed_panel_limit_points")?;
    let mut rows = Vec::new();
    for row in 0..table.rows.len() {
        if table.number(row, "t")? != 12.7 {
            continue;
        }
        // The paper gives no load: a cell without a number is shown as a dash.
        let cell = |column: &str, scale: f64| match table.number(row, column) {
            Ok(value) => Ok(short(scale * value)),
            Err(ReferenceError::NotANumber { .. }) => Ok("–".to_owned()),
            Err(error) => Err(error),
        };
        let source = table.rows[row][1].as_str().unwrap_or_default().to_owned();
        rows.push(vec![source, cell("limit_W", 1.0)?, cell("limit_P", 1e-3)?]);
    }
    for run in runs.iter().filter(|run| run.variant.method != FAST) {
        if let Some(limit) = limit_point(run)? {
            let name = format!("{} {}", run.variant.method, run.variant.grid);
            rows.push(vec![name, format!("{:.2}", limit.x), format!("{:.4}", limit.y)]);
        }
    }
    Ok(Numbers {
        title: "Limit points".into(),
        caption: "Published and independent results first, then the runs of this report (parabola through the highest \
                  point and its neighbours)."
            .into(),
        head: ["source", "displacement [mm]", "load [kN]"].map(String::from).into(),
        rows,
    })
}

/// The whole panel, from its quarter, at rest, near the limit point, and snapped through.
fn shapes(run: &Run) -> Shapes {
    let crown = 2540.0;
    let stages = [
        (0.0, "at rest"),
        (10.5 / 30.0, "w = 10.5 mm, near the limit point"),
        (1.0, "w = 30 mm, snapped through"),
    ];
    let mut sheets = Vec::new();
    for (number, (level, words)) in stages.iter().enumerate() {
        let shape = run.outcome.shapes.iter().find(|shape| (shape.level - level).abs() < 1e-9);
        sheets.extend(shape.map(|shape| {
            Sheet::new(words, &run.outcome.faces, shape, shade(0.5 * number as f64))
                .shifted(2, -crown)
                .stretched(2, 6.0)
                .shifted(2, -190.0 * number as f64)
                .mirrored(0)
                .mirrored(1)
        }));
    }
    Shapes {
        title: "The panel at rest, near the limit point, and snapped through (paper, figure 3)".into(),
        caption: "21×21 particles in the quarter that was computed, mirrored; heights six times enlarged. Near the limit \
                  the crown dips while the free curved edges still arch; at 30 mm the whole panel hangs through."
            .into(),
        view: (-58.0, 24.0),
        sheets,
    }
}

/// The quarter near the limit point and, shifted aside, the same of the finite-element shell.
fn beside_elements(run: &Run) -> Result<Shapes, JudgeError> {
    let (crown, limit) = (2540.0, 10.5);
    let refused = |cause: String| JudgeError::Study { case: "panel", method: ELEMENTS.into(), cause };
    let (nodes, elements) = panel_shape(20, 12.7, PanelSection::Isotropic, limit, 21)
        .map_err(|cause| refused(cause.to_string()))?;
    let shape = run.outcome.shapes.iter().find(|shape| (shape.level - limit / 30.0).abs() < 1e-9);
    let apart = shape.map(|shape| {
        let most = shape
            .positions
            .iter()
            .map(|x| nodes.iter().map(|node| (node - x).norm()).fold(f64::INFINITY, f64::min));
        most.fold(0.0, f64::max)
    });
    let place = |sheet: Sheet| sheet.shifted(2, -crown).stretched(2, 6.0).mirrored(0).mirrored(1);
    let mut sheets: Vec<Sheet> = shape
        .map(|shape| place(Sheet::new("particles", &run.outcome.faces, shape, BLUE)))
        .into_iter()
        .collect();
    let points = nodes.iter().map(|x| [x.x, x.y, x.z]).collect();
    let faces = elements.iter().map(|nodes| nodes.to_vec()).collect();
    let elements = Sheet { label: "finite elements".into(), points, faces, colour: BLACK };
    sheets.push(place(elements).shifted(0, 620.0));
    Ok(Shapes {
        title:
            "The panel at w = 10.5 mm, near the limit point: particles and finite elements (paper, figure 3)"
                .into(),
        caption: format!(
            "Left 21×21 particles, right 20×20 elements of the finite-element shell, both mirrored, heights six times enlarged. \
             Particles and nodes are {} mm apart at most, of 10.5 mm that the crown has moved.",
            apart.map_or_else(|| "–".into(), |most| format!("{most:.3}"))
        ),
        view: (-58.0, 24.0),
        sheets,
    })
}

fn all_methods(runs: &Runs) -> Result<Chart, JudgeError> {
    let mut series = vec![bricks()?];
    for setting in &METHODS {
        if let Some(run) = runs.get(setting.method, "21×21")? {
            series.push(Series::marks(setting.method, points(run)?, setting.colour, setting.mark));
        }
    }
    let mut caption = vec!["All that derive from an energy lie on the bricks."];
    let there = |method| runs.get(method, "21×21").map(|run| run.is_some());
    if there(STRONG_12)? || there(STRONG_085)? {
        caption.push("The strong form as printed is more than twice too stiff before the limit.");
    }
    if there(STRONG_DIFFERENCE)? {
        caption.push("Its difference form, edges prescribed, lies on them too.");
    }
    Ok(Chart {
        title: "Every formulation, 21×21".into(),
        caption: caption.join(" "),
        x: Axis::linear(DISPLACEMENT),
        y: Axis::linear(LOAD),
        series,
    })
}

fn fast(runs: &Runs, run: &Run) -> Result<Chart, JudgeError> {
    let mut series =
        vec![Series::line("30 mm in 3 ms, density 7.8e-9 t/mm³", points(run)?, VERMILION, Line::Solid)];
    if let Some(slow) = runs.get(CELL, "21×21")? {
        series.push(Series::both("at rest at each level", points(slow)?, BLUE, Mark::Disc));
    }
    Ok(Chart {
        title: "The panel pushed in within 3 ms".into(),
        caption: "With the density of steel the crown has to be accelerated: the reaction is ten times the static load \
                  from the start, and there is no limit point to see."
            .into(),
        x: Axis::linear(DISPLACEMENT),
        y: Axis::linear(LOAD),
        series,
    })
}

fn statement(run: &Run) -> Result<Note, JudgeError> {
    let (w, p) = path(run)?;
    let peak = p.iter().copied().fold(0.0, f64::max);
    let early = w.iter().position(|w| *w >= 10.5).map_or(f64::NAN, |row| p[row]);
    Ok(Note {
        title: "What the paper states, and why this report says it differently".into(),
        paragraphs: vec![
            "The paper (Lin et al. 2013) reports its limit point at a displacement of 10.5 mm, 1.78 % from Klinkel et al. \
             1999, for 21×21 particles and a displacement imposed within 3 ms."
                .into(),
            "The limit load is flat: it changes by less than 1 % from 9.9 to 11.8 mm. Two results that agree to 0.2 % in load \
             may put the maximum half a millimetre apart, so 10.5 mm is no contradiction to the 10.9 mm found here, and no \
             confirmation either. Loads at given displacements are compared instead."
                .into(),
            format!(
                "A linear ramp of 30 mm in 3 ms is a tenth of the panel's longest period (31 ms) at the density of steel. \
                 Computed so, the reaction is {} kN at 10.5 mm and reaches {} kN, against 2.2 kN at rest. A quasi-static \
                 curve within 3 ms needs a density scaled down by about 1e5, which the paper does not state; this report \
                 ramps and holds until the motion has died.",
                short(early),
                short(peak)
            ),
            format!(
                "The paper's equations to the letter (rows \"{STRONG_12}\" and \"{STRONG_085}\") do not give its curve: their \
                 pair sums neither balance momentum nor have a symmetric stiffness, and the load is more than twice too \
                 high. What the paper's program did beyond its text is not known."
            ),
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_are_drawn_even_without_runs() {
        let none = Runs { chosen: Vec::new(), left_out: crate::cases::shell::panel::case().variants };
        assert_eq!(limit_points(&none).unwrap().rows.len(), 6);
        assert_eq!(whole_path(&none).unwrap().series.len(), 3);
        assert!(figures(&none).unwrap().iter().all(|figure| !matches!(figure, Figure::Note(_))));
    }
}
