//! What stands in a frame: the sheet of particles with its fields, and the same sheet with its thickness.
//!
//! What a state consists of is written to the last bit, what follows from it in single precision.

use std::borrow::Cow;
use std::io::{self, Write};

use sph_core::{Cell, Vec3};
use sph_shell::{Formulation, PointResult};

use super::stress::{face, von_mises};
use super::vtu::{Kind, Vtu};
use super::{Frame, State};
use crate::scene::units::Quantity;

const XYZ: [&str; 3] = [""; 3];
const PLANE: [&str; 3] = ["11", "22", "12"];
const DOUBLED: [&str; 3] = ["11", "22", "2x12"];
const ACROSS: [&str; 2] = ["1", "2"];

/// What is written of one frame.
pub(crate) struct Content<'a> {
    pub frame: &'a Frame<'a>,
    /// Strains and resultants at the sampling points; none if the scene does not ask for stresses.
    pub results: Option<&'a [PointResult]>,
}

impl Content<'_> {
    /// The mid-surface: particles as points, cells between them.
    pub fn sheet<W: Write>(&self, file: &mut Vtu<W>) -> io::Result<()> {
        let shell = self.frame.shell;
        let (count, cells) = (shell.len(), self.cells());
        self.open(file, count, cells.len())?;
        points(file, (0..count).map(|a| shell.position(a)))?;
        let corners = cells.iter().map(|cell| usize::from(cell.count)).sum();
        let numbers = cells.iter().flat_map(|cell| cell.particles().iter().map(|&a| a as i32));
        connect(
            file,
            Counted { left: corners, inner: numbers },
            &cells,
            1,
            [Kind::Vertex, Kind::Triangle, Kind::Quadrangle],
        )?;
        file.line("<PointData Vectors=\"displacement\">")?;
        self.particles(file)?;
        if !self.at_cells() {
            self.stresses(file)?;
        }
        file.line("</PointData>\n<CellData>")?;
        if self.at_cells() {
            self.stresses(file)?;
        }
        file.line("</CellData>\n</Piece>")
    }

    /// The body: a layer of hexahedra and wedges between the faces, half the thickness along the directors; lines where
    /// there are points only.
    pub fn solid<W: Write>(&self, file: &mut Vtu<W>) -> io::Result<()> {
        let shell = self.frame.shell;
        let (count, cells) = (shell.len(), self.cells());
        let half = 0.5 * shell.thickness();
        self.open(file, 2 * count, cells.len())?;
        // The lower face first, then the upper one.
        let both = || (0..2 * count).map(move |i| if i < count { (i, -half) } else { (i - count, half) });
        points(file, both().map(|(a, height)| shell.position(a) + shell.director(a) * height))?;
        let corners = cells.iter().map(|cell| 2 * usize::from(cell.count)).sum();
        let numbers = cells.iter().flat_map(|cell| {
            let face = move |shift: usize| cell.particles().iter().map(move |&a| (a as usize + shift) as i32);
            // The lower face looks at the upper one: bodies of positive volume, as VTK measures wedges too.
            face(0).chain(face(count))
        });
        let kinds = [Kind::Line, Kind::Wedge, Kind::Hexahedron];
        connect(file, Counted { left: corners, inner: numbers }, &cells, 2, kinds)?;
        file.line("<PointData Vectors=\"displacement\">")?;
        let frames = &shell.reference().cloud.frames;
        let moved =
            |(a, height): (usize, f64)| shell.displacement(a) + (shell.director(a) - frames[a].n) * height;
        file.rows("displacement", &self.unit_of_motion(), XYZ, both().map(|at| xyz(moved(at))))?;
        if !self.at_cells() {
            self.faces(file, |results| both().map(move |(a, _)| &results[a]))?;
        }
        file.line("</PointData>\n<CellData>")?;
        if self.at_cells() {
            self.faces(file, |results| results.iter())?;
        }
        file.line("</CellData>\n</Piece>")
    }

    /// The cells of the cloud; where it has none each particle is one, with itself as its only corner.
    fn cells(&self) -> Cow<'_, [Cell]> {
        let shell = self.frame.shell;
        let cells = &shell.reference().cloud.cells;
        if cells.is_empty() {
            return (0..shell.len() as u32).map(|a| Cell { corners: [a; 4], count: 1 }).collect();
        }
        cells.into()
    }

    fn open<W: Write>(&self, file: &mut Vtu<W>, points: usize, cells: usize) -> io::Result<()> {
        file.line("<FieldData>")?;
        file.single("TimeValue", self.frame.along)?;
        file.single("level", self.frame.level)?;
        file.line("</FieldData>")?;
        file.line(&format!("<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">"))
    }

    fn particles<W: Write>(&self, file: &mut Vtu<W>) -> io::Result<()> {
        let Frame { shell, state, driven, linear, .. } = *self.frame;
        let all = || 0..shell.len();
        file.rows("displacement", &self.unit_of_motion(), XYZ, all().map(|a| xyz(shell.displacement(a))))?;
        if state == State::Moving {
            file.rows("velocity", &self.unit(Quantity::Speed), XYZ, all().map(|a| xyz(shell.velocity(a))))?;
        }
        file.rows("director", &self.unit(Quantity::Ratio), XYZ, all().map(|a| xyz(shell.director(a))))?;
        if self.frame.has_forces() {
            // Where nothing is held the same difference of forces is what accelerates: no reaction.
            let bears = |a: usize| shell.is_held(a) || driven == Some(a as u32);
            let force = |a: usize| linear.map_or_else(|| shell.reaction(a), |linear| linear.reactions[a]);
            let reaction = |a: usize| if bears(a) { xyz(force(a)) } else { [0.0; 3] };
            file.rows("reaction", &self.unit(Quantity::Force), XYZ, all().map(reaction))?;
        }
        let thickness = shell.thickness();
        file.list("thickness", &self.unit(Quantity::Length), all().map(|_| thickness))
    }

    fn unit(&self, quantity: Quantity) -> String {
        self.frame.units.symbol(quantity)
    }

    /// Of displacements; those of a mode have no size.
    fn unit_of_motion(&self) -> String {
        self.unit(if self.frame.state == State::Mode { Quantity::Ratio } else { Quantity::Length })
    }

    /// Whether strains are sampled at the cells, not at the particles.
    fn at_cells(&self) -> bool {
        matches!(self.frame.shell.formulation(), Formulation::StressPoint(_))
    }

    fn stresses<W: Write>(&self, file: &mut Vtu<W>) -> io::Result<()> {
        let Some(results) = self.results else { return Ok(()) };
        let thickness = self.frame.shell.thickness();
        let all = || results.iter();
        file.rows("t1", &self.unit(Quantity::Ratio), XYZ, all().map(|r| lean(r.t1)))?;
        file.rows("membrane_strain", &self.unit(Quantity::Ratio), DOUBLED, all().map(|r| lean(r.membrane)))?;
        file.rows("curvature", &self.unit(Quantity::Curvature), DOUBLED, all().map(|r| lean(r.curvature)))?;
        file.rows("shear_strain", &self.unit(Quantity::Ratio), ACROSS, all().map(|r| lean(r.shear)))?;
        file.rows(
            "membrane_force",
            &self.unit(Quantity::ForcePerLength),
            PLANE,
            all().map(|r| lean(r.force)),
        )?;
        file.rows("moment", &self.unit(Quantity::MomentPerLength), PLANE, all().map(|r| lean(r.moment)))?;
        file.rows(
            "shear_force",
            &self.unit(Quantity::ForcePerLength),
            ACROSS,
            all().map(|r| lean(r.shear_force)),
        )?;
        if self.frame.homogeneous {
            file.rows(
                "stress_top",
                &self.unit(Quantity::Stress),
                PLANE,
                all().map(|r| lean(face(r, thickness, 1.0))),
            )?;
            file.rows(
                "stress_bottom",
                &self.unit(Quantity::Stress),
                PLANE,
                all().map(|r| lean(face(r, thickness, -1.0))),
            )?;
        }
        self.faces(file, |results| results.iter())
    }

    /// The von Mises stresses of both faces of a homogeneous section at the sampling points that `pick` goes through.
    fn faces<'r, W: Write, I: ExactSizeIterator<Item = &'r PointResult>>(
        &'r self,
        file: &mut Vtu<W>,
        pick: impl Fn(&'r [PointResult]) -> I,
    ) -> io::Result<()> {
        let Some(results) = self.results.filter(|_| self.frame.homogeneous) else { return Ok(()) };
        let thickness = self.frame.shell.thickness();
        for (name, side) in [("von_mises_top", 1.0), ("von_mises_bottom", -1.0)] {
            file.list(
                name,
                &self.unit(Quantity::Stress),
                pick(results).map(|r| von_mises(face(r, thickness, side)) as f32),
            )?;
        }
        Ok(())
    }
}

fn xyz(v: Vec3) -> [f64; 3] {
    v.into()
}

/// Single precision: what is derived from the motion is looked at, not computed with, and half the bytes are half the cost.
fn lean<const N: usize>(row: [f64; N]) -> [f32; N] {
    row.map(|value| value as f32)
}

/// Strains and resultants of a frame: those of a linear answer, else those of the shell, read into `room`.
pub(crate) fn results<'r>(frame: &Frame<'r>, room: &'r mut Vec<PointResult>) -> &'r [PointResult] {
    if let Some(linear) = frame.linear {
        return &linear.points;
    }
    room.resize(frame.shell.reference().operator.points.len(), PointResult::default());
    frame.shell.point_results(room);
    room
}

fn points<W: Write>(file: &mut Vtu<W>, points: impl ExactSizeIterator<Item = Vec3>) -> io::Result<()> {
    file.line("<Points>")?;
    file.rows("Points", "-", XYZ, points.map(xyz))?;
    file.line("</Points>")
}

/// `layers` times the corners of a cell make one of the file; the kinds are those for one, three and four corners.
fn connect<W: Write>(
    file: &mut Vtu<W>,
    numbers: impl ExactSizeIterator<Item = i32>,
    cells: &[Cell],
    layers: i32,
    [one, three, four]: [Kind; 3],
) -> io::Result<()> {
    file.line("<Cells>")?;
    file.list("connectivity", "-", numbers)?;
    let mut end = 0;
    let ends = cells.iter().map(|cell| {
        end += layers * i32::from(cell.count);
        end
    });
    file.list("offsets", "-", ends)?;
    let kind = |cell: &Cell| match cell.count {
        1 => one,
        3 => three,
        _ => four,
    };
    file.list("types", "-", cells.iter().map(|cell| kind(cell) as u8))?;
    file.line("</Cells>")
}

/// An iterator whose length is known beforehand.
struct Counted<I> {
    left: usize,
    inner: I,
}

impl<I: Iterator> Iterator for Counted<I> {
    type Item = I::Item;

    fn next(&mut self) -> Option<I::Item> {
        self.left = self.left.saturating_sub(1);
        self.inner.next()
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.left, Some(self.left))
    }
}

impl<I: Iterator> ExactSizeIterator for Counted<I> {}
