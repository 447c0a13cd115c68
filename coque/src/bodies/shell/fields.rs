//! What a shell shows of a state: the sheet of particles with its fields, and the same sheet with its thickness.
//!
//! What a state consists of is written to the last bit, what follows from it in single precision.

use std::io;

use contact::Grip;
use mesh_io::{At, Connectivity, FieldWriter, Kind, Values, rows};
use sph_core::{Cell, Vec3};
use sph_shell::{Formulation, PointResult, Shell, Yielded};

use super::indicator::indicator;
use super::linear_forces::LinearForces;
use super::stress_fields::Stressed;
use crate::bodies::invariants::von_mises;
use crate::bodies::sampled::face_stress;
use crate::bodies::tool_shapes;
use crate::bodies::{ContactFields, FieldRequest, FieldSource, Part, State};
use crate::scene::ShellFace;
use crate::scene::units::Quantity;

const XYZ: &[&str] = &[];
const PLANE: &[&str] = &["11", "22", "12"];
const DOUBLED: &[&str] = &["11", "22", "2x12"];
const ACROSS: &[&str] = &["1", "2"];

/// What the fields of a shell show of its present state.
pub(crate) fn fields<'a>(
    shell: &'a Shell,
    shown: &FieldRequest<'a>,
    nodal: ContactFields,
) -> Box<dyn FieldSource + 'a> {
    let linear = shown.forces.and_then(|row| LinearForces::of(shell).with_numbers(row));
    // Where nothing is in balance and nothing moves there are no forces to show: neither stresses nor reactions.
    let forces = match shown.state {
        State::Moving | State::Balance => true,
        State::Linear | State::Greatest => linear.is_some(),
        State::Mode => false,
    };
    let (linear, reactions) =
        linear.map_or((None, None), |found| (Some(found.points), Some(found.reactions)));
    let wanted = shown.stresses || shown.indicator || shown.of_stresses.any();
    let results = (wanted && forces).then(|| {
        linear.unwrap_or_else(|| {
            let mut results = vec![PointResult::default(); shell.reference().operator.points.len()];
            shell.point_results(&mut results);
            results
        })
    });
    let yielded = shell.yielded();
    Box::new(Content { shell, shown: *shown, forces, results, reactions, nodal, yielded })
}

/// What is written of one frame.
struct Content<'a> {
    shell: &'a Shell,
    shown: FieldRequest<'a>,
    /// Whether there are forces to show.
    forces: bool,
    /// Strains and resultants at the sampling points; none if they are not asked for, or have no size.
    results: Option<Vec<PointResult>>,
    /// Reactions of a linear answer \[F\].
    reactions: Option<Vec<Vec3>>,
    /// What each particle feels of contact; nothing where that is not asked for.
    nodal: ContactFields,
    /// What each cell has gone through; nothing where no section yields.
    yielded: Vec<Yielded>,
}

impl FieldSource for Content<'_> {
    fn write(&self, part: Part, to: &mut dyn FieldWriter) -> io::Result<()> {
        match part {
            Part::Surface => self.surface(to),
            Part::Extruded => self.extruded(to),
            Part::Tools => {
                let tools: Vec<_> = self.shell.tools_as_they_stood().collect();
                tool_shapes::write(&tools, self.shell.rest_positions(), &self.shown.units, to)
            }
            // The checks leave a shell no other part.
            Part::Points => Ok(()),
        }
    }
}

impl Content<'_> {
    /// The mid-surface: particles as points, cells between them.
    fn surface(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let shell = self.shell;
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
        let wanted = self.shown.of_stresses;
        let results = self.results.as_ref().filter(|_| wanted.any() && self.at_once());
        let stressed =
            results.map(|results| Stressed { shell, results, units: self.shown.units, at: self.place() });
        // What stands at points goes before what stands in cells.
        if let Some(stressed) = stressed.as_ref().filter(|_| wanted.recovered && self.place() == At::Cells) {
            stressed.recovered(wanted.principal, to)?;
        }
        self.indicator(to)?;
        self.yielding(to)?;
        self.stresses(to)?;
        stressed.map_or(Ok(()), |stressed| stressed.write(wanted, to))
    }

    /// The body: a layer of hexahedra and wedges between the faces, half the thickness along the directors; lines where
    /// there are points only.
    fn extruded(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let shell = self.shell;
        let count = shell.len();
        let sections = self.of_particles();
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
        let at = |i: usize| {
            let (a, side) = if i < count { (i, -0.5) } else { (i - count, 0.5) };
            let [thickness, height] = sections[a];
            (a, height + side * thickness)
        };
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

    /// Thickness and height over the particle at each particle, means over its cells \[L, L\].
    fn of_particles(&self) -> Vec<[f64; 2]> {
        let shell = self.shell;
        if !shell.has_regions() && self.yielded.is_empty() {
            return vec![[shell.thickness(), 0.0]; shell.len()];
        }
        let mut sums = vec![[0.0; 3]; shell.len()];
        for (c, cell) in shell.reference().cloud.cells.iter().enumerate() {
            let section = shell.section_at(c);
            let thickness = section.thickness * self.yielded.get(c).map_or(1.0, |own| own.thickness);
            for &a in cell.particles() {
                let own = &mut sums[a as usize];
                *own = [own[0] + thickness, own[1] + section.height, own[2] + 1.0];
            }
        }
        sums.into_iter().map(|[thickness, height, cells]| [thickness / cells, height / cells]).collect()
    }

    /// Number of cells; where the cloud has none each particle is one, with itself as its only corner.
    fn cells(&self) -> usize {
        let shell = self.shell;
        match shell.reference().cloud.cells.len() {
            0 => shell.len(),
            cells => cells,
        }
    }

    fn cell(&self, number: usize) -> Cell {
        let cells = &self.shell.reference().cloud.cells;
        if cells.is_empty() { Cell { corners: [number as u32; 4], count: 1 } } else { cells[number] }
    }

    fn particles(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let (shell, driven, linear) = (self.shell, self.shown.driven, self.reactions.as_ref());
        let mut put = |name: &str, quantity: Quantity, vector: &dyn Fn(usize) -> Vec3| {
            let vectors = rows(shell.len(), |a| xyz(vector(a)));
            self.put(to, At::Points, name, quantity, XYZ, Values::Double(&vectors))
        };
        put("displacement", self.motion(), &|a| shell.displacement(a))?;
        if self.shown.state == State::Moving {
            put("velocity", Quantity::Speed, &|a| shell.velocity(a))?;
        }
        put("director", Quantity::Ratio, &|a| shell.director(a))?;
        if self.forces {
            // Where nothing is held the same difference of forces is what accelerates: no reaction.
            let bears = |a: usize| shell.is_held(a) || driven == Some(a as u32);
            let force = |a: usize| linear.map_or_else(|| shell.reaction(a), |reactions| reactions[a]);
            put("reaction", Quantity::Force, &|a| if bears(a) { force(a) } else { Vec3::zeros() })?;
        }
        let sections = self.of_particles();
        let thickness = rows(shell.len(), |a| [sections[a][0]]);
        self.put(to, At::Points, "thickness", Quantity::Length, &[], Values::Double(&thickness))?;
        self.contact(to)
    }

    /// What each particle feels of contact: normal force and friction over its area, its gap, and whether it sticks.
    fn contact(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let ContactFields { nodal, gaps } = &self.nodal;
        let touches = gaps.iter().any(|gap| gap.is_finite());
        if nodal.len() != self.shell.len() || !touches || !self.forces {
            return Ok(());
        }
        let pressure = rows(nodal.len(), |a| [nodal[a].pressure() as f32]);
        self.put(to, At::Points, "contact_pressure", Quantity::Stress, &[], Values::Single(&pressure))?;
        let shear = rows(nodal.len(), |a| xyz(nodal[a].shear()).map(|value| value as f32));
        self.put(to, At::Points, "contact_shear", Quantity::Stress, XYZ, Values::Single(&shear))?;
        let gap = rows(nodal.len(), |a| [gaps[a] as f32]);
        self.put(to, At::Points, "contact_gap", Quantity::Length, &[], Values::Single(&gap))?;
        let grip = rows(nodal.len(), |a| match nodal[a].grip {
            Grip::Apart => [0.0],
            Grip::Sticks => [1.0],
            Grip::Slips => [2.0],
        });
        self.put(to, At::Points, "contact_grip", Quantity::Ratio, &[], Values::Single(&grip))
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
        to.numbers(at, name, &self.shown.units.symbol(quantity), components, values)
    }

    /// Whether its numbers are met at once, so that others can be made of several.
    fn at_once(&self) -> bool {
        self.shown.state != State::Greatest
    }

    /// What displacements are; those of a mode have no size.
    fn motion(&self) -> Quantity {
        if self.shown.state == State::Mode { Quantity::Ratio } else { Quantity::Length }
    }

    /// Where strains are sampled: at the cells or at the particles.
    fn place(&self) -> At {
        match self.shell.formulation() {
            Formulation::StressPoint(_) => At::Cells,
            _ => At::Points,
        }
    }

    /// Where strains are sampled at the cells, how far those of a cell are from what its neighbours make of them.
    fn indicator(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let results = self
            .results
            .as_ref()
            .filter(|_| self.shown.indicator && self.at_once() && self.place() == At::Cells);
        let Some(results) = results else { return Ok(()) };
        let found = indicator(self.shell, results);
        let all = rows(found.len(), |i| [found[i] as f32]);
        self.put(to, At::Cells, "error_indicator", Quantity::Ratio, &[], Values::Single(&all))
    }

    /// What the sampling points have gone through, where the section yields.
    fn yielding(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        if self.yielded.is_empty() || !self.forces {
            return Ok(());
        }
        let mut put = |name: &str, quantity: Quantity, number: &dyn Fn(&Yielded) -> f64| {
            let all = rows(self.yielded.len(), |i| [number(&self.yielded[i]) as f32]);
            self.put(to, At::Cells, name, quantity, &[], Values::Single(&all))
        };
        put("plastic_strain", Quantity::Ratio, &|own| own.plastic_strain)?;
        put("yielded_share", Quantity::Ratio, &|own| own.share)?;
        put("dissipated", Quantity::ForcePerLength, &|own| own.dissipated)
    }

    fn stresses(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let results = self.results.as_ref().filter(|_| self.shown.stresses);
        let Some(count) = results.map(|results| results.len()) else { return Ok(()) };
        self.derived(to, "t1", Quantity::Ratio, XYZ, |r| r.t1)?;
        self.derived(to, "membrane_strain", Quantity::Ratio, DOUBLED, |r| r.membrane)?;
        self.derived(to, "curvature", Quantity::Curvature, DOUBLED, |r| r.curvature)?;
        self.derived(to, "shear_strain", Quantity::Ratio, ACROSS, |r| r.shear)?;
        self.derived(to, "membrane_force", Quantity::ForcePerLength, PLANE, |r| r.force)?;
        self.derived(to, "moment", Quantity::MomentPerLength, PLANE, |r| r.moment)?;
        self.derived(to, "shear_force", Quantity::ForcePerLength, ACROSS, |r| r.shear_force)?;
        if self.shell.homogeneous() && self.at_once() {
            let Some(results) = &self.results else { return Ok(()) };
            for (name, side) in [("stress_top", ShellFace::Top), ("stress_bottom", ShellFace::Bottom)] {
                let all = rows(results.len(), |i| self.at_face(results, i, side).map(|value| value as f32));
                self.put(to, self.place(), name, Quantity::Stress, PLANE, Values::Single(&all))?;
            }
        }
        self.faces(to, count, |i| i)
    }

    /// Stresses of a sampling point at a face.
    fn at_face(&self, results: &[PointResult], point: usize, face: ShellFace) -> [f64; 3] {
        let PointResult { force, moment, .. } = results[point];
        let section = self.shell.section_at(point);
        face_stress([force, moment], [section.thickness, section.height], face)
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
        let wanted = self.shown.stresses && self.shell.homogeneous() && self.at_once();
        let Some(results) = self.results.as_ref().filter(|_| wanted) else { return Ok(()) };
        for (name, side) in [("von_mises_top", ShellFace::Top), ("von_mises_bottom", ShellFace::Bottom)] {
            let all = rows(count, |i| [von_mises(self.at_face(results, of(i), side)) as f32]);
            self.put(to, self.place(), name, Quantity::Stress, &[], Values::Single(&all))?;
        }
        Ok(())
    }
}

fn xyz(v: Vec3) -> [f64; 3] {
    v.into()
}
