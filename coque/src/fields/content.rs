//! What a shell shows of a state: the sheet of particles with its fields, and the same sheet with its thickness.
//!
//! What a state consists of is written to the last bit, what follows from it in single precision.

use std::borrow::Cow;
use std::io;

use mesh_io::{At, Connectivity, FieldWriter, Kind, Values, rows};
use sph_core::{Cell, Vec3};
use sph_shell::{Formulation, PointResult, Shell};

use super::stress::{face, von_mises};
use super::{Evaluated, FieldSource, Part, State};
use crate::units::{Quantity, Units};

const XYZ: &[&str] = &[];
const PLANE: &[&str] = &["11", "22", "12"];
const DOUBLED: &[&str] = &["11", "22", "2x12"];
const ACROSS: &[&str] = &["1", "2"];

/// A shell in a state, as the frames of its fields see it.
#[derive(Clone, Copy)]
pub struct ShellFields<'a> {
    /// The shell; its forces are those of the state, but for a linear answer and a mode.
    pub shell: &'a Shell,
    /// The particle whose prescribed motion drives an analysis without time: it bears a reaction though no support
    /// holds it.
    pub driven: Option<u32>,
    /// Whether stresses run linearly through the thickness, so that those at the faces follow from the resultants.
    pub homogeneous: bool,
    /// The forces of a linear answer.
    pub linear: Option<&'a LinearForces>,
}

/// What a linear answer holds beside its motion: all of it grows with the load, none of it is that of the moved shell.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinearForces {
    /// Strains and resultants of every sampling point, with its direction at rest.
    pub points: Vec<PointResult>,
    /// Reactions of all particles \[F\].
    pub reactions: Vec<Vec3>,
}

impl FieldSource for ShellFields<'_> {
    fn evaluate(&self, state: State, units: Units, stresses: bool) -> Box<dyn Evaluated + '_> {
        // Where nothing is in balance and nothing moves there are no forces to show: neither stresses nor reactions.
        let forces = match state {
            State::Moving | State::Balance => true,
            State::Linear => self.linear.is_some(),
            State::Mode => false,
        };
        let results = (stresses && forces).then(|| match self.linear {
            Some(linear) => Cow::Borrowed(&linear.points[..]),
            None => {
                let points = self.shell.reference().operator.points.len();
                let mut results = vec![PointResult::default(); points];
                self.shell.point_results(&mut results);
                results.into()
            }
        });
        Box::new(Content { fields: *self, state, units, forces, results })
    }
}

/// What is written of one frame.
struct Content<'a> {
    fields: ShellFields<'a>,
    state: State,
    units: Units,
    /// Whether there are forces to show.
    forces: bool,
    /// Strains and resultants at the sampling points; none if they are not asked for, or have no size.
    results: Option<Cow<'a, [PointResult]>>,
}

impl Evaluated for Content<'_> {
    fn write(&self, part: Part, to: &mut dyn FieldWriter) -> io::Result<()> {
        match part {
            Part::Surface => self.surface(to),
            Part::Extruded => self.extruded(to),
        }
    }
}

impl Content<'_> {
    /// The mid-surface: particles as points, cells between them.
    fn surface(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let shell = self.fields.shell;
        let cell = |number: usize| {
            let Cell { corners: [a, b, c, d], count } = self.cell(number);
            let kind = match count {
                1 => Kind::Vertex,
                3 => Kind::Triangle,
                _ => Kind::Quadrangle,
            };
            (kind, [a, b, c, d, 0, 0, 0, 0])
        };
        let points = rows(shell.len(), |a| xyz(shell.position(a)));
        to.geometry(&points, Connectivity { count: self.cells(), cell: &cell })?;
        self.particles(to)?;
        self.stresses(to)
    }

    /// The body: a layer of hexahedra and wedges between the faces, half the thickness along the directors; lines where
    /// there are points only.
    fn extruded(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let shell = self.fields.shell;
        let count = shell.len();
        let half = 0.5 * shell.thickness();
        // The lower face looks at the upper one: bodies of positive volume, as VTK measures wedges too.
        let cell = |number: usize| {
            let cell = self.cell(number);
            let (kind, own) = match cell.count {
                1 => (Kind::Line, 1),
                3 => (Kind::Wedge, 3),
                _ => (Kind::Hexahedron, 4),
            };
            let mut corners = [0; 8];
            for (i, &a) in cell.particles().iter().enumerate() {
                (corners[i], corners[own + i]) = (a, a + count as u32);
            }
            (kind, corners)
        };
        // The lower face first, then the upper one.
        let at = |i: usize| if i < count { (i, -half) } else { (i - count, half) };
        let place = |(a, height): (usize, f64)| shell.position(a) + shell.director(a) * height;
        let points = rows(2 * count, |i| xyz(place(at(i))));
        to.geometry(&points, Connectivity { count: self.cells(), cell: &cell })?;
        let frames = &shell.reference().cloud.frames;
        let moved =
            |(a, height): (usize, f64)| shell.displacement(a) + (shell.director(a) - frames[a].n) * height;
        let moved = rows(2 * count, |i| xyz(moved(at(i))));
        self.put(to, At::Points, "displacement", self.motion(), XYZ, Values::Double(&moved))?;
        match self.place() {
            At::Points => self.faces(to, 2 * count, |i| at(i).0),
            _ => self.faces(to, self.cells(), |i| i),
        }
    }

    /// Number of cells; where the cloud has none each particle is one, with itself as its only corner.
    fn cells(&self) -> usize {
        let shell = self.fields.shell;
        match shell.reference().cloud.cells.len() {
            0 => shell.len(),
            cells => cells,
        }
    }

    fn cell(&self, number: usize) -> Cell {
        let cells = &self.fields.shell.reference().cloud.cells;
        if cells.is_empty() { Cell { corners: [number as u32; 4], count: 1 } } else { cells[number] }
    }

    fn particles(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let ShellFields { shell, driven, linear, .. } = self.fields;
        let mut put = |name: &str, quantity: Quantity, vector: &dyn Fn(usize) -> Vec3| {
            let vectors = rows(shell.len(), |a| xyz(vector(a)));
            self.put(to, At::Points, name, quantity, XYZ, Values::Double(&vectors))
        };
        put("displacement", self.motion(), &|a| shell.displacement(a))?;
        if self.state == State::Moving {
            put("velocity", Quantity::Speed, &|a| shell.velocity(a))?;
        }
        put("director", Quantity::Ratio, &|a| shell.director(a))?;
        if self.forces {
            // Where nothing is held the same difference of forces is what accelerates: no reaction.
            let bears = |a: usize| shell.is_held(a) || driven == Some(a as u32);
            let force = |a: usize| linear.map_or_else(|| shell.reaction(a), |linear| linear.reactions[a]);
            put("reaction", Quantity::Force, &|a| if bears(a) { force(a) } else { Vec3::zeros() })?;
        }
        let thickness = rows(shell.len(), |_| [shell.thickness()]);
        self.put(to, At::Points, "thickness", Quantity::Length, &[], Values::Double(&thickness))
    }

    fn put(
        &self,
        to: &mut dyn FieldWriter,
        at: At,
        name: &str,
        quantity: Quantity,
        components: &[&str],
        values: Values<'_>,
    ) -> io::Result<()> {
        to.numbers(at, name, &self.units.symbol(quantity), components, values)
    }

    /// What displacements are; those of a mode have no size.
    fn motion(&self) -> Quantity {
        if self.state == State::Mode { Quantity::Ratio } else { Quantity::Length }
    }

    /// Where strains are sampled: at the cells or at the particles.
    fn place(&self) -> At {
        match self.fields.shell.formulation() {
            Formulation::StressPoint(_) => At::Cells,
            _ => At::Points,
        }
    }

    fn stresses(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let Some(count) = self.results.as_ref().map(|results| results.len()) else { return Ok(()) };
        self.derived(to, "t1", Quantity::Ratio, XYZ, |r| r.t1)?;
        self.derived(to, "membrane_strain", Quantity::Ratio, DOUBLED, |r| r.membrane)?;
        self.derived(to, "curvature", Quantity::Curvature, DOUBLED, |r| r.curvature)?;
        self.derived(to, "shear_strain", Quantity::Ratio, ACROSS, |r| r.shear)?;
        self.derived(to, "membrane_force", Quantity::ForcePerLength, PLANE, |r| r.force)?;
        self.derived(to, "moment", Quantity::MomentPerLength, PLANE, |r| r.moment)?;
        self.derived(to, "shear_force", Quantity::ForcePerLength, ACROSS, |r| r.shear_force)?;
        if self.fields.homogeneous {
            let thickness = self.fields.shell.thickness();
            for (name, side) in [("stress_top", 1.0), ("stress_bottom", -1.0)] {
                self.derived(to, name, Quantity::Stress, PLANE, |r| face(r, thickness, side))?;
            }
        }
        self.faces(to, count, |i| i)
    }

    /// A row for each sampling point, in single precision: what is derived from the motion is looked at, not computed
    /// with, and half the bytes are half the cost.
    fn derived<const N: usize>(
        &self,
        to: &mut dyn FieldWriter,
        name: &str,
        quantity: Quantity,
        components: &[&str],
        row: impl Fn(&PointResult) -> [f64; N],
    ) -> io::Result<()> {
        let Some(results) = &self.results else { return Ok(()) };
        let all = rows(results.len(), |i| row(&results[i]).map(|value| value as f32));
        self.put(to, self.place(), name, quantity, components, Values::Single(&all))
    }

    /// The von Mises stresses of both faces of a homogeneous section: so many rows, each of the sampling point that `of`
    /// gives for its number.
    fn faces(&self, to: &mut dyn FieldWriter, count: usize, of: impl Fn(usize) -> usize) -> io::Result<()> {
        let Some(results) = self.results.as_ref().filter(|_| self.fields.homogeneous) else { return Ok(()) };
        let thickness = self.fields.shell.thickness();
        for (name, side) in [("von_mises_top", 1.0), ("von_mises_bottom", -1.0)] {
            let all = rows(count, |i| [von_mises(face(&results[of(i)], thickness, side)) as f32]);
            self.put(to, self.place(), name, Quantity::Stress, &[], Values::Single(&all))?;
        }
        Ok(())
    }
}

fn xyz(v: Vec3) -> [f64; 3] {
    v.into()
}
