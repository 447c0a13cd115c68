//! What writes fields, wherever they go: a file ([`crate::Vtu`]) or memory ([`crate::Sheet`]).

use std::io;

/// Most numbers in a row of a field.
pub(crate) const MOST_COMPONENTS: usize = 9;

/// Takes one frame: numbers of the whole frame, its geometry, fields of the points, fields of the cells, in this order.
pub trait FieldWriter {
    /// Takes points, by rows x, y, z \[L\], and the cells between them.
    ///
    /// # Errors
    /// Those of the system; `InvalidInput` where the geometry was there before, and for rows that are not three wide.
    fn geometry(&mut self, points: &dyn Rows<f64>, cells: Connectivity<'_>) -> io::Result<()>;

    /// Takes a field: a row for each point or cell, with its unit (`-` for none) and a name for each component (none for
    /// x, y, z and for a single number).
    ///
    /// # Errors
    /// Those of the system; `InvalidInput` for a field before or behind its place, and for as many rows as there are
    /// neither points nor cells.
    fn numbers(
        &mut self,
        at: At,
        name: &str,
        unit: &str,
        components: &[&str],
        values: Values<'_>,
    ) -> io::Result<()>;
}

/// What has the numbers of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum At {
    /// The whole frame: one number.
    Frame,
    /// Each point.
    Points,
    /// Each cell.
    Cells,
}

/// Kinds of cells, by their numbers in VTK.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One point.
    Vertex = 1,
    /// Two points.
    Line = 3,
    /// Three points.
    Triangle = 5,
    /// Four points round a face.
    Quadrangle = 9,
    /// A quadrangle and the one above it.
    Hexahedron = 12,
    /// A triangle and the one above it.
    Wedge = 13,
}

impl Kind {
    /// Points of such a cell.
    pub fn corners(self) -> usize {
        match self {
            Self::Vertex => 1,
            Self::Line => 2,
            Self::Triangle => 3,
            Self::Quadrangle => 4,
            Self::Hexahedron => 8,
            Self::Wedge => 6,
        }
    }
}

/// Cells of a frame, each made as it is asked for.
#[derive(Clone, Copy)]
pub struct Connectivity<'a> {
    /// Number of cells.
    pub count: usize,
    /// A cell by its number: what kind it is, and its points; behind those of the kind anything may stand.
    pub cell: &'a dyn Fn(usize) -> (Kind, [u32; 8]),
}

/// Rows of numbers, made as they are asked for: no array is held whole.
pub trait Rows<T> {
    /// Number of rows.
    fn count(&self) -> usize;

    /// Numbers a row.
    fn width(&self) -> usize;

    /// Writes the rows from `first` on, as many as fill `to`.
    fn fill(&self, first: usize, to: &mut [T]);
}

/// So many rows, each from a function of its number.
pub fn rows<T: Copy, const N: usize>(count: usize, row: impl Fn(usize) -> [T; N]) -> impl Rows<T> {
    Each { count, row }
}

struct Each<F> {
    count: usize,
    row: F,
}

impl<T: Copy, const N: usize, F: Fn(usize) -> [T; N]> Rows<T> for Each<F> {
    fn count(&self) -> usize {
        self.count
    }

    fn width(&self) -> usize {
        N
    }

    fn fill(&self, first: usize, to: &mut [T]) {
        for (number, to) in (first..).zip(to.as_chunks_mut::<N>().0) {
            *to = (self.row)(number);
        }
    }
}

/// The numbers of a field.
#[derive(Clone, Copy)]
pub enum Values<'a> {
    /// To the last bit.
    Double(&'a dyn Rows<f64>),
    /// In single precision.
    Single(&'a dyn Rows<f32>),
}

impl Values<'_> {
    /// Number of rows, and numbers a row.
    pub(crate) fn shape(&self) -> (usize, usize) {
        match self {
            Self::Double(rows) => (rows.count(), rows.width()),
            Self::Single(rows) => (rows.count(), rows.width()),
        }
    }

    /// Refuses a field whose rows are not as many as `needed`, or that has too many or too few numbers in a row.
    pub(crate) fn check(&self, name: &str, needed: usize) -> io::Result<()> {
        let (count, width) = self.shape();
        if count != needed {
            return Err(misused(format!("the field {name} has {count} rows where {needed} are needed")));
        }
        if !(1..=MOST_COMPONENTS).contains(&width) {
            let what =
                format!("the field {name} has {width} numbers a row; 1 to {MOST_COMPONENTS} are written");
            return Err(misused(what));
        }
        Ok(())
    }
}

/// Refuses points that do not lie in space.
pub(crate) fn in_space(points: &dyn Rows<f64>) -> io::Result<()> {
    match points.width() {
        3 => Ok(()),
        width => Err(misused(format!("points have {width} coordinates; 3 are needed"))),
    }
}

/// What was not asked in the order of [`FieldWriter`].
pub(crate) fn misused(what: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, what)
}
