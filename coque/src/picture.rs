//! A deformed shape as a picture without a viewer: cells coloured by a field, the undeformed outline, a colour bar.
//!
//! Parallel projection, farther cells first (the painter's way): right for sheets whose cells do not cut each other.

mod field;
mod paint;

use std::collections::BTreeMap;

use crate::fields::Sheet;
pub use field::FieldNotThere;
use field::{Values, values};
use paint::{Camera, Canvas, colour};

/// What to draw, and from where.
#[derive(Clone, Debug)]
pub struct Picture<'a> {
    /// A field of the sheet: a number, the length of a vector, or one component as in `moment.11`; without, the
    /// von Mises stress on top if there is one, else the displacement.
    pub field: Option<&'a str>,
    /// Where the viewer stands: azimuth from x towards y and height above the x–y plane, in degrees.
    pub view: [f64; 2],
    /// Words above the picture.
    pub title: &'a str,
}

/// Cells beyond which their edges are not drawn: they would hide the colours.
const MOST_EDGED: usize = 5000;

/// Draws a sheet as SVG.
///
/// # Errors
/// [`FieldNotThere`], with what there is.
pub fn picture_svg(sheet: &Sheet, wanted: &Picture<'_>) -> Result<String, FieldNotThere> {
    let Values { name, of_cells } = values(sheet, wanted.field)?;
    let camera = Camera::new(wanted.view);
    let start: Vec<[f64; 3]> = match sheet.point_data.get("displacement").filter(|u| u.width == 3) {
        None => sheet.points.clone(),
        Some(u) => {
            let moved = sheet.points.iter().zip(u.numbers.chunks_exact(3));
            moved.map(|(x, u)| [x[0] - u[0], x[1] - u[1], x[2] - u[2]]).collect()
        }
    };
    let now: Vec<[f64; 3]> = sheet.points.iter().map(|x| camera.see(x)).collect();
    let before: Vec<[f64; 3]> = start.iter().map(|x| camera.see(x)).collect();
    let mut canvas = Canvas::fitting(now.iter().chain(&before));
    canvas.title(wanted.title);
    for (from, to) in outline(&sheet.cells) {
        canvas.dashed(&before[from], &before[to]);
    }
    let finite = || of_cells.iter().copied().filter(|value| value.is_finite());
    let range =
        told_apart([finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max)]);
    let depth = |cell: &[usize]| cell.iter().map(|&a| now[a][2]).sum::<f64>() / cell.len() as f64;
    let mut order: Vec<(f64, usize)> =
        sheet.cells.iter().enumerate().map(|(i, cell)| (depth(cell), i)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let edged = sheet.cells.len() <= MOST_EDGED;
    for (_, i) in order {
        let corners: Vec<&[f64; 3]> = sheet.cells[i].iter().map(|&a| &now[a]).collect();
        canvas.polygon(&corners, &colour(of_cells[i], range), edged);
    }
    canvas.axes(&camera);
    canvas.bar(&name, range);
    Ok(canvas.end())
}

/// The ends of the scale; one value where the four digits beside the bar would be the same: rounding has no colour.
fn told_apart([low, high]: [f64; 2]) -> [f64; 2] {
    let middle = 0.5 * (low + high);
    if high - low <= 1e-4 * middle.abs() { [middle; 2] } else { [low, high] }
}

/// Edges that belong to one cell only; a particle alone has none.
fn outline(cells: &[Vec<usize>]) -> Vec<(usize, usize)> {
    let mut used: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for cell in cells.iter().filter(|cell| cell.len() > 1) {
        for (i, &from) in cell.iter().enumerate() {
            let to = cell[(i + 1) % cell.len()];
            *used.entry((from.min(to), from.max(to))).or_default() += 1;
        }
    }
    used.into_iter().filter(|&(_, count)| count == 1).map(|(edge, _)| edge).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields::Array;

    /// Two squares side by side, lifted by 1; a field of 2 and 6 on them.
    fn sheet() -> Sheet {
        let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 1.0], [1.0, 1.0], [2.0, 1.0]];
        let single = |numbers: &[f64]| Array { components: Vec::new(), width: 1, numbers: numbers.into() };
        let displacement = Array { components: Vec::new(), width: 3, numbers: [0.0, 0.0, 1.0].repeat(6) };
        let moment =
            Array { components: vec!["11".into(), "22".into()], width: 2, numbers: vec![1.0, 2.0, 3.0, 4.0] };
        Sheet {
            points: points.map(|[x, y]| [x, y, 1.0]).into(),
            cells: vec![vec![0, 1, 4, 3], vec![1, 2, 5, 4]],
            point_data: [("displacement".to_string(), displacement)].into(),
            cell_data: [("von_mises_top".to_string(), single(&[2.0, 6.0])), ("moment".to_string(), moment)]
                .into(),
        }
    }

    fn drawn(field: Option<&str>) -> String {
        picture_svg(&sheet(), &Picture { field, view: [-60.0, 30.0], title: "a < b & c" }).unwrap()
    }

    #[test]
    fn a_picture_holds_cells_outline_and_bar() {
        let svg = drawn(None);
        let document = roxmltree::Document::parse(&svg).unwrap();
        let class =
            |name: &str| document.descendants().filter(|n| n.attribute("class") == Some(name)).count();
        // Seven edges in all, the middle one shared.
        assert_eq!((class("cell"), class("outline")), (2, 6));
        let words: Vec<&str> =
            document.descendants().filter(|n| n.is_text()).filter_map(|n| n.text()).collect();
        for word in ["a < b & c", "von_mises_top", "2", "4", "6"] {
            assert!(words.contains(&word), "{word} in {words:?}");
        }
        // The ends of the scale are the colours of the two cells.
        assert!(svg.contains("#440154") && svg.contains("#fde725"));
    }

    #[test]
    fn rounding_has_no_colour() {
        assert_eq!(told_apart([1.0, 1.0 + 1e-9]), [1.0 + 5e-10; 2]);
        assert_eq!(told_apart([-1.0, 1.0]), [-1.0, 1.0]);
        assert_eq!(told_apart([0.0, 1e-30]), [0.0, 1e-30]);
        let none = told_apart([f64::INFINITY, f64::NEG_INFINITY]);
        assert_eq!(none, [f64::INFINITY, f64::NEG_INFINITY]);
    }

    #[test]
    fn a_component_or_the_length_of_a_vector_can_be_drawn() {
        assert!(drawn(Some("moment.22")).contains(">moment.22<"));
        // All points moved by one: a field without a range.
        assert!(drawn(Some("displacement")).contains(">1<"));
        assert!(drawn(Some("displacement.z")).contains(">displacement.z<"));
        for missing in ["pressure", "moment.33", "von_mises_top.x"] {
            let wanted = Picture { field: Some(missing), view: [0.0, 0.0], title: "" };
            let error = picture_svg(&sheet(), &wanted).unwrap_err().to_string();
            assert!(
                error.contains(missing) && error.contains("displacement, moment, von_mises_top"),
                "{error}"
            );
        }
    }
}
