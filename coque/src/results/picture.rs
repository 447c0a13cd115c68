//! A deformed shape as a picture without a viewer: cells coloured by a field, the undeformed outline, a colour bar.
//!
//! Parallel projection, farther cells first (the painter's way): right for sheets whose cells do not cut each other, for the outer
//! faces of solids, and for particles, which are squares.

mod extent;
mod faces;
mod field;
mod paint;
mod seen;
mod together;
mod torn;

use std::collections::BTreeMap;

pub use extent::PictureExtent;
pub use field::FieldNotThere;
use field::Values;
pub use field::usual_field;
use mesh_io::Sheet;
use paint::{Bar, Canvas, HEIGHT, WIDTH, colour};
use seen::{SWING, Seen};
pub use together::together;
use together::{SIDE, side};

/// What to draw, and from where.
#[derive(Clone, Debug)]
pub struct Picture<'a> {
    /// A field of the sheet: a number, the length of a vector, or one component as in `moment.11`; without, the
    /// [`usual_field`].
    pub field: Option<&'a str>,
    /// Where the viewer stands: azimuth from x towards y and height above the x–y plane, in degrees.
    pub view: [f64; 2],
    /// Planes through the origin, by their normals 0 to 2 for x to z, in which a part is mirrored to the whole. The
    /// colours of an image are those of the part.
    pub mirror: &'a [usize],
    /// Displacements are drawn this many times as large.
    pub scale: f64,
    /// The sheet is a mode, whose motion has no size: at the scale 1 the greatest displacement is drawn as a tenth of the
    /// body's diagonal, and values are shares of the greatest one.
    pub sizeless: bool,
    /// Ends of the colours; left out, those of the extent.
    pub range: Option<[f64; 2]>,
    /// Zoom and colours; left out, those of the sheet. That of all frames of a run makes their pictures comparable.
    pub extent: Option<PictureExtent>,
    /// Words above the picture.
    pub title: &'a str,
    /// Words below them: which instant it is.
    pub instant: &'a str,
}

impl<'a> Picture<'a> {
    /// The part as it is, seen from above and aside.
    pub fn new(title: &'a str) -> Self {
        Self {
            field: None,
            view: [-60.0, 30.0],
            mirror: &[],
            scale: 1.0,
            sizeless: false,
            range: None,
            extent: None,
            title,
            instant: "",
        }
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
    let seen = Seen::of(sheet, wanted)?;
    let extent = wanted.extent.unwrap_or_else(|| seen.extent());
    let all: Vec<usize> = (0..seen.sheet.cells.len()).collect();
    let (drawn_then, cells) = (seen.with_images(&all), seen.with_images(&seen.whole));
    let Seen { sheet, values: Values { name, unit, of_cells }, camera, start, now, before, whole } = seen;
    let mut canvas = Canvas::showing(&extent.seen);
    canvas.titles(wanted.title, &remarks(wanted));
    // Where a part meets its image there is no edge.
    let size = start.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
    let inner = |from: usize, to: usize| {
        let on = |a: usize, axis: usize| start[a % start.len()][axis].abs() <= ON_PLANE * size;
        wanted.mirror.iter().any(|&axis| on(from, axis) && on(to, axis))
    };
    let edges = outline(&drawn_then).into_iter().filter(|&(from, to)| !inner(from, to));
    canvas.dashed(edges.map(|(from, to)| [&before[from], &before[to]]));
    let (ends, clipped) = wanted.range.map_or_else(|| extent.colours(), |range| (range, false));
    let range = reported_apart(ends);
    let depth = |cell: &[usize]| cell.iter().map(|&a| now[a][2]).sum::<f64>() / cell.len() as f64;
    let mut order: Vec<(f64, usize)> = cells.iter().enumerate().map(|(i, cell)| (depth(cell), i)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let (sides, one) = (sheet.point_data.get(SIDE), side(&sheet));
    let side = |cell: usize| match sides {
        Some(sides) => {
            sheet.cells[cell].first().and_then(|&a| sides.numbers.get(a)).copied().filter(|x| x.is_finite())
        }
        None => one,
    };
    let faces = order.into_iter().map(|(_, i)| {
        let corners = cells[i].iter().map(|&a| &now[a]).collect();
        let own = whole[i % whole.len()];
        (corners, side(own), colour(of_cells[own], range))
    });
    canvas.cells(faces, cells.len() <= MOST_EDGED);
    canvas.axes(&camera);
    let all = (!wanted.sizeless).then_some(extent.all);
    canvas.bar(&Bar { name: &name, unit: unit.as_deref(), range, clipped, all });
    Ok(canvas.end())
}

/// Which instant it is, and what is not drawn to scale.
fn remarks(wanted: &Picture<'_>) -> String {
    let drawn = match wanted.scale {
        scale if wanted.sizeless => {
            format!("greatest motion drawn as {} % of the body’s diagonal", 100.0 * SWING * scale)
        }
        1.0 => String::new(),
        scale => format!("displacements × {scale}"),
    };
    let words = [wanted.instant, &drawn];
    words.into_iter().filter(|words| !words.is_empty()).collect::<Vec<_>>().join("; ")
}

/// What the picture of a sheet takes; those of all frames of a run, joined by [`PictureExtent::with`], make their pictures
/// comparable.
///
/// # Errors
/// [`FieldNotThere`], with what there is.
pub fn picture_extent(sheet: &Sheet, wanted: &Picture<'_>) -> Result<PictureExtent, FieldNotThere> {
    Seen::of(sheet, wanted).map(|seen| seen.extent())
}

/// Pictures side by side: two in a row, of more than six three, of more than twelve four.
pub fn strip(pictures: &[String]) -> String {
    let columns = match pictures.len() {
        0 | 1 => 1,
        2..=6 => 2,
        7..=12 => 3,
        _ => 4,
    };
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
    fn a_mode_is_drawn_as_large_as_it_can_be_seen() {
        let mut tiny = sheet();
        tiny.points.iter_mut().for_each(|x| x[2] = 1e-7);
        tiny.point_data.get_mut("displacement").unwrap().numbers = [0.0, 0.0, 1e-7].repeat(6);
        let wanted =
            Picture { sizeless: true, instant: "mode 3, 12.4 Hz", view: [-90.0, 0.0], ..Picture::new("") };
        let svg = picture_svg(&tiny, &wanted).unwrap();
        let words = "mode 3, 12.4 Hz; greatest motion drawn as 10 % of the body’s diagonal";
        assert!(svg.contains(words) && svg.contains("[of the greatest]"), "{svg}");
        // Two by one at rest: the way up is a tenth of √5.
        let [_, up] = picture_extent(&tiny, &wanted).unwrap().seen;
        assert!((up[1] - up[0] - 0.1 * 5.0_f64.sqrt()).abs() < 1e-9, "{up:?}");
    }

    #[test]
    fn pictures_of_one_extent_have_one_zoom_and_one_range() {
        let mut later = sheet();
        later.points.iter_mut().for_each(|x| x[0] += 2.0);
        later.cell_data.get_mut("von_mises_top").unwrap().numbers = vec![3.0, 12.0];
        let own = Picture::new("");
        let both = [sheet(), later].map(|sheet| picture_extent(&sheet, &own).unwrap());
        let wanted = Picture { extent: Some(both[0].with(&both[1])), ..own };
        let svg = picture_svg(&sheet(), &wanted).unwrap();
        assert!(
            svg.contains(">greatest 12<") && svg.contains(">least 2<") && !svg.contains("#fde725\" d"),
            "{svg}"
        );
        assert_ne!(svg, drawn(None));
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
