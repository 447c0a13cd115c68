//! A deformed shape as a picture without a viewer: cells coloured by a field, the undeformed outline, a colour bar.
//!
//! Parallel projection, farther cells first (the painter's way): right for sheets whose cells do not cut each other, for the outer
//! faces of solids, and for particles, which are squares.

mod faces;
mod field;
mod paint;
mod together;

use std::collections::BTreeMap;

use faces::outer;
pub use field::FieldNotThere;
use field::{Values, values};
use mesh_io::Sheet;
use paint::{Camera, Canvas, HEIGHT, WIDTH, colour};
pub use together::together;
use together::{SIDE, side};

/// What to draw, and from where.
#[derive(Clone, Debug)]
pub struct Picture<'a> {
    /// A field of the sheet: a number, the length of a vector, or one component as in `moment.11`; without, the damage
    /// if there is any, the von Mises stress on top if there is one, else the displacement; of a fluid the pressure.
    pub field: Option<&'a str>,
    /// Where the viewer stands: azimuth from x towards y and height above the x–y plane, in degrees.
    pub view: [f64; 2],
    /// Planes through the origin, by their normals 0 to 2 for x to z, in which a part is mirrored to the whole. The
    /// colours of an image are those of the part.
    pub mirror: &'a [usize],
    /// Displacements are drawn this many times as large.
    pub scale: f64,
    /// Ends of the colours; left out, the least and greatest value.
    pub range: Option<[f64; 2]>,
    /// Words above the picture.
    pub title: &'a str,
}

impl<'a> Picture<'a> {
    /// The part as it is, seen from above and aside.
    pub fn new(title: &'a str) -> Self {
        Self { field: None, view: [-60.0, 30.0], mirror: &[], scale: 1.0, range: None, title }
    }
}

/// Cells beyond which their edges are not drawn: they would hide the colours.
const MOST_EDGED: usize = 5000;
/// Distance from a plane, in parts of the extent, below which a point lies on it.
const ON_PLANE: f64 = 1e-6;

/// Draws a sheet as SVG.
///
/// # Errors
/// [`FieldNotThere`], with what there is.
pub fn picture_svg(sheet: &Sheet, wanted: &Picture<'_>) -> Result<String, FieldNotThere> {
    let seen = outer(sheet);
    let sheet = seen.as_ref();
    let Values { name, unit, of_cells } = values(sheet, wanted.field)?;
    let camera = Camera::new(wanted.view);
    let start: Vec<[f64; 3]> = match sheet.point_data.get("displacement").filter(|u| u.width == 3) {
        None => sheet.points.clone(),
        Some(u) => {
            // Beside bodies that move, walls have no displacement.
            let way = |u: f64| if u.is_nan() { 0.0 } else { u };
            let moved = sheet.points.iter().zip(u.numbers.chunks_exact(3));
            moved.map(|(x, u)| [x[0] - way(u[0]), x[1] - way(u[1]), x[2] - way(u[2])]).collect()
        }
    };
    let drawn = sheet.points.iter().zip(&start);
    let drawn: Vec<[f64; 3]> =
        drawn.map(|(x, from)| [0, 1, 2].map(|i| from[i] + wanted.scale * (x[i] - from[i]))).collect();
    let see = |points: Vec<[f64; 3]>| -> Vec<[f64; 3]> {
        mirrored(points, wanted.mirror).iter().map(|x| camera.see(x)).collect()
    };
    let images = 1 << wanted.mirror.len();
    let shifted = |cell: &Vec<usize>, image: usize| -> Vec<usize> {
        cell.iter().map(|a| a + image * sheet.points.len()).collect()
    };
    let cells: Vec<Vec<usize>> =
        (0..images).flat_map(|image| sheet.cells.iter().map(move |cell| shifted(cell, image))).collect();
    let (now, before) = (see(drawn), see(start.clone()));
    let mut canvas = Canvas::fitting(now.iter().chain(&before));
    canvas.title(wanted.title);
    if wanted.scale != 1.0 {
        canvas.remark(&format!("displacements × {}", wanted.scale));
    }
    // Where a part meets its image there is no edge.
    let size = start.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
    let inner = |from: usize, to: usize| {
        let on = |a: usize, axis: usize| start[a % start.len()][axis].abs() <= ON_PLANE * size;
        wanted.mirror.iter().any(|&axis| on(from, axis) && on(to, axis))
    };
    let edges = outline(&cells).into_iter().filter(|&(from, to)| !inner(from, to));
    canvas.dashed(edges.map(|(from, to)| [&before[from], &before[to]]));
    let range = reported_apart(wanted.range.unwrap_or_else(|| ends(&of_cells)));
    let depth = |cell: &[usize]| cell.iter().map(|&a| now[a][2]).sum::<f64>() / cell.len() as f64;
    let mut order: Vec<(f64, usize)> = cells.iter().enumerate().map(|(i, cell)| (depth(cell), i)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let (sides, one) = (sheet.point_data.get(SIDE), side(sheet));
    let side = |cell: usize| match sides {
        Some(sides) => {
            sheet.cells[cell].first().and_then(|&a| sides.numbers.get(a)).copied().filter(|x| x.is_finite())
        }
        None => one,
    };
    let faces = order.into_iter().map(|(_, i)| {
        let corners = cells[i].iter().map(|&a| &now[a]).collect();
        let own = i % sheet.cells.len();
        (corners, side(own), colour(of_cells[own], range))
    });
    canvas.cells(faces, cells.len() <= MOST_EDGED);
    canvas.axes(&camera);
    canvas.bar(&name, unit.as_deref(), range);
    Ok(canvas.end())
}

/// Least and greatest value of a field that a picture would show, for pictures with the same colours.
///
/// # Errors
/// [`FieldNotThere`], with what there is.
pub fn picture_range(sheet: &Sheet, field: Option<&str>) -> Result<[f64; 2], FieldNotThere> {
    values(&outer(sheet), field).map(|values| ends(&values.of_cells))
}

fn ends(values: &[f64]) -> [f64; 2] {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    [finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max)]
}

/// Pictures side by side, two in a row.
pub fn strip(pictures: &[String]) -> String {
    let columns = pictures.len().clamp(1, 2);
    let (wide, high) = (columns as f64 * WIDTH, pictures.len().div_ceil(columns) as f64 * HEIGHT);
    let mut all = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{wide}\" height=\"{high}\" viewBox=\"0 0 {wide} {high}\">\n"
    );
    for (i, picture) in pictures.iter().enumerate() {
        let (x, y) = ((i % columns) as f64 * WIDTH, (i / columns) as f64 * HEIGHT);
        all += &picture.replacen("<svg ", &format!("<svg x=\"{x}\" y=\"{y}\" "), 1);
    }
    all + "</svg>\n"
}

/// The points, followed by their images in each plane and, in the next, the images of all these.
fn mirrored(mut points: Vec<[f64; 3]>, planes: &[usize]) -> Vec<[f64; 3]> {
    for &axis in planes {
        let image = points.clone().into_iter().map(|mut x| {
            x[axis] = -x[axis];
            x
        });
        points.extend(image.collect::<Vec<_>>());
    }
    points
}

/// The ends of the scale; one value where the four digits beside the bar would be the same: rounding has no colour.
fn reported_apart([low, high]: [f64; 2]) -> [f64; 2] {
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
    use mesh_io::Array;

    /// Two squares side by side, lifted by 1; a field of 2 and 6 on them.
    fn sheet() -> Sheet {
        let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 1.0], [1.0, 1.0], [2.0, 1.0]];
        let single = |numbers: &[f64]| Array {
            components: Vec::new(),
            unit: Some("N/mm²".into()),
            width: 1,
            numbers: numbers.into(),
        };
        let displacement =
            Array { components: Vec::new(), unit: None, width: 3, numbers: [0.0, 0.0, 1.0].repeat(6) };
        let moment = Array {
            components: vec!["11".into(), "22".into()],
            unit: None,
            width: 2,
            numbers: vec![1.0, 2.0, 3.0, 4.0],
        };
        Sheet {
            points: points.map(|[x, y]| [x, y, 1.0]).into(),
            cells: vec![vec![0, 1, 4, 3], vec![1, 2, 5, 4]],
            point_data: [("displacement".to_string(), displacement)].into(),
            cell_data: [("von_mises_top".to_string(), single(&[2.0, 6.0])), ("moment".to_string(), moment)]
                .into(),
            ..Sheet::default()
        }
    }

    fn drawn(field: Option<&str>) -> String {
        picture_svg(&sheet(), &Picture { field, ..Picture::new("a < b & c") }).unwrap()
    }

    /// Elements in a group.
    fn count(document: &roxmltree::Document<'_>, group: &str) -> usize {
        let found = document.descendants().find(|node| node.attribute("class") == Some(group)).unwrap();
        found.children().filter(roxmltree::Node::is_element).count()
    }

    #[test]
    fn a_part_is_mirrored_to_the_whole() {
        let wanted = Picture { mirror: &[0, 1], scale: 2.0, ..Picture::new("") };
        let svg = picture_svg(&sheet(), &wanted).unwrap();
        let document = roxmltree::Document::parse(&svg).unwrap();
        // Two cells in each quarter; the whole, 4 by 2, has an edge of twelve pieces.
        assert_eq!((count(&document, "cells"), count(&document, "outline")), (8, 12));
        assert!(svg.contains(">displacements × 2<"));
        let points = mirrored(vec![[1.0, 2.0, 3.0]], &[0, 2]);
        assert_eq!(points, [[1.0, 2.0, 3.0], [-1.0, 2.0, 3.0], [1.0, 2.0, -3.0], [-1.0, 2.0, -3.0]]);
    }

    #[test]
    fn a_picture_holds_cells_outline_and_bar() {
        let svg = drawn(None);
        let document = roxmltree::Document::parse(&svg).unwrap();
        // Seven edges in all, the middle one shared.
        assert_eq!((count(&document, "cells"), count(&document, "outline")), (2, 6));
        let words: Vec<&str> =
            document.descendants().filter(|n| n.is_text()).filter_map(|n| n.text()).collect();
        for word in ["a < b & c", "von_mises_top", "[N/mm²]", "2", "3", "4", "5", "6"] {
            assert!(words.contains(&word), "{word} in {words:?}");
        }
        // The ends of the scale are the colours of the two cells.
        assert!(svg.contains("#440154") && svg.contains("#fde725"));
    }

    #[test]
    fn rounding_has_no_colour() {
        assert_eq!(reported_apart([1.0, 1.0 + 1e-9]), [1.0 + 5e-10; 2]);
        assert_eq!(reported_apart([-1.0, 1.0]), [-1.0, 1.0]);
        assert_eq!(reported_apart([0.0, 1e-30]), [0.0, 1e-30]);
        let none = reported_apart([f64::INFINITY, f64::NEG_INFINITY]);
        assert_eq!(none, [f64::INFINITY, f64::NEG_INFINITY]);
    }

    #[test]
    fn a_component_or_the_length_of_a_vector_can_be_drawn() {
        assert!(drawn(Some("moment.22")).contains(">moment.22<"));
        // All points moved by one: a field without a range.
        assert!(drawn(Some("displacement")).contains(">1<"));
        assert!(drawn(Some("displacement.z")).contains(">displacement.z<"));
        for missing in ["pressure", "moment.33", "von_mises_top.x"] {
            let wanted = Picture { field: Some(missing), ..Picture::new("") };
            let error = picture_svg(&sheet(), &wanted).unwrap_err().to_string();
            assert!(
                error.contains(missing) && error.contains("displacement, moment, von_mises_top"),
                "{error}"
            );
        }
    }
}
