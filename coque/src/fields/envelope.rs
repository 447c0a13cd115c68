//! Envelopes of fields over load cases: of each number of each field the least, the greatest, the greatest size, and the case that has it.
//!
//! They are taken of the fields as the frames of the cases show them, so that von Mises' stress is that of each case, and stand in four frames behind
//! those, under the names of the fields.

use std::collections::BTreeMap;
use std::io;

use mesh_io::{Array, At, Connectivity, FieldWriter, Kind, Rows, Sheet, Values};

use crate::bodies::{FieldSource, Part};

/// The field that moves the points.
const MOTION: &str = "displacement";
/// Its name where it has the numbers of cases.
const CASE_OF_MOTION: &str = "displacement_in";
/// Fields that are the same in all cases, directions and labels.
const LEFT_OUT: [&str; 7] = ["director", "t1", "nodal_t1", "thickness", "volume", "area", "worst_ply"];
/// Fields whose least number is the worst.
const LEAST_COUNTS: &str = "reserve_factor";

/// What a frame shows of an envelope.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extreme {
    /// The least numbers.
    Least,
    /// The greatest numbers.
    Greatest,
    /// The greatest of their sizes, of reserve factors the least.
    Size,
    /// The number of the case, from 1, that has that size; the first of several.
    Governing,
}

impl Extreme {
    /// All of them, in the order of their frames.
    pub const ALL: [Self; 4] = [Self::Least, Self::Greatest, Self::Size, Self::Governing];

    /// Its name, that of its files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Least => "least",
            Self::Greatest => "greatest",
            Self::Size => "size",
            Self::Governing => "governing",
        }
    }
}

/// Envelopes of the fields of each body.
#[derive(Debug, Default)]
pub struct FieldEnvelope {
    bodies: Vec<OfBody>,
}

/// A body at rest, and its fields.
#[derive(Debug)]
struct OfBody {
    points: Vec<[f64; 3]>,
    cells: Vec<Vec<usize>>,
    fields: Vec<OfField>,
}

/// A field: its extremes in the order of [`Extreme::ALL`].
#[derive(Debug)]
struct OfField {
    at: At,
    name: String,
    array: Array,
    extremes: [Vec<f64>; 4],
}

impl FieldEnvelope {
    /// Takes in a case or combination by its number, the frames of its bodies.
    pub(crate) fn take(&mut self, number: f64, sheets: Vec<Sheet>) {
        if self.bodies.is_empty() {
            self.bodies = sheets.into_iter().map(|sheet| OfBody::new(number, sheet)).collect();
            return;
        }
        self.bodies.iter_mut().zip(&sheets).for_each(|(body, sheet)| body.take(number, sheet));
    }

    /// An extreme of the fields of a body.
    pub(crate) fn of_body(&self, body: usize, extreme: Extreme) -> Box<dyn FieldSource + '_> {
        Box::new(Shown { body: self.bodies.get(body), extreme })
    }
}

impl OfBody {
    fn new(number: f64, sheet: Sheet) -> Self {
        let Sheet { mut points, cells, point_data, cell_data, .. } = sheet;
        if let Some(motion) = point_data.get(MOTION).filter(|array| array.width == 3) {
            points.as_flattened_mut().iter_mut().zip(&motion.numbers).for_each(|(x, u)| *x -= u);
        }
        let kept = |at: At, all: BTreeMap<String, Array>| {
            let some = all
                .into_iter()
                .filter(|(name, _)| !LEFT_OUT.contains(&name.as_str()) && !name.contains("direction"));
            some.map(move |(name, array)| OfField::new(at, name, array, number)).collect::<Vec<_>>()
        };
        let mut fields = kept(At::Points, point_data);
        fields.extend(kept(At::Cells, cell_data));
        Self { points, cells, fields }
    }

    fn take(&mut self, number: f64, sheet: &Sheet) {
        for field in &mut self.fields {
            let all = if field.at == At::Points { &sheet.point_data } else { &sheet.cell_data };
            if let Some(array) = all.get(&field.name) {
                field.take(number, &array.numbers);
            }
        }
    }
}

impl OfField {
    fn new(at: At, name: String, mut array: Array, number: f64) -> Self {
        let numbers = std::mem::take(&mut array.numbers);
        let sizes = numbers.iter().map(|x| x.abs()).collect();
        let governing = vec![number; numbers.len()];
        Self { at, name, array, extremes: [numbers.clone(), numbers, sizes, governing] }
    }

    fn take(&mut self, number: f64, numbers: &[f64]) {
        let least_counts = self.name.ends_with(LEAST_COUNTS);
        let [least, greatest, size, governing] = &mut self.extremes;
        for (i, &x) in numbers.iter().enumerate().take(least.len()) {
            if x < least[i] || least[i].is_nan() {
                least[i] = x;
            }
            if x > greatest[i] || greatest[i].is_nan() {
                greatest[i] = x;
            }
            let governs = if least_counts { x.abs() < size[i] } else { x.abs() > size[i] };
            if governs || size[i].is_nan() {
                (size[i], governing[i]) = (x.abs(), number);
            }
        }
    }
}

/// What a frame shows of a body; nothing of one that no case had.
struct Shown<'a> {
    body: Option<&'a OfBody>,
    extreme: Extreme,
}

/// Numbers that are there, by rows.
struct Flat<'a> {
    numbers: &'a [f64],
    width: usize,
}

impl Rows<f64> for Flat<'_> {
    fn count(&self) -> usize {
        self.numbers.len() / self.width
    }

    fn width(&self) -> usize {
        self.width
    }

    fn fill(&self, first: usize, to: &mut [f64]) {
        to.copy_from_slice(&self.numbers[first * self.width..][..to.len()]);
    }
}

impl FieldSource for Shown<'_> {
    fn write(&self, part: Part, to: &mut dyn FieldWriter) -> io::Result<()> {
        let Some(body) = self.body.filter(|_| part == Part::Surface) else { return Ok(()) };
        let cell = |number: usize| {
            let own = &body.cells[number];
            let mut corners = [0; 8];
            corners.iter_mut().zip(own).for_each(|(to, &corner)| *to = corner as u32);
            let kind = match own.len() {
                1 => Kind::Vertex,
                2 => Kind::Line,
                3 => Kind::Triangle,
                6 => Kind::Wedge,
                8 => Kind::Hexahedron,
                _ => Kind::Quadrangle,
            };
            (kind, corners)
        };
        let points = Flat { numbers: body.points.as_flattened(), width: 3 };
        to.geometry(&points, Connectivity { count: body.cells.len(), cell: &cell })?;
        for OfField { at, name, array, extremes } in &body.fields {
            let numbers = &extremes[self.extreme as usize];
            let components: Vec<&str> = array.components.iter().map(String::as_str).collect();
            let governs = self.extreme == Extreme::Governing;
            // The number of a case moves nothing.
            let name = if governs && name == MOTION { CASE_OF_MOTION } else { name };
            let unit = array.unit.as_deref().filter(|_| !governs).unwrap_or("-");
            to.numbers(*at, name, unit, &components, Values::Double(&Flat { numbers, width: array.width }))?;
        }
        Ok(())
    }
}
