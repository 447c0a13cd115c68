//! What a Galerkin solid shows of a state: its nodes and the cells between them, and its quadrature points.
//!
//! What a state consists of is written to the last bit, what follows from it in single precision.

use std::io;

use mesh_io::{At, Connectivity, FieldWriter, Kind, Values, rows};
use sph_core::Vec3;

use super::recovery::{RECOVERED, all_of, in_space};
use super::solid::GalerkinSolid;
use crate::bodies::invariants::von_mises_in_space;
use crate::bodies::solid::fields::principal_fields;
use crate::bodies::{FieldRequest, FieldSource, Part, State};
use crate::scene::units::Quantity;

/// Material axes that turn with the point.
const STRESS: &[&str] = &["11", "22", "33", "12", "23", "13"];
/// The same with shears twice.
const STRAIN: &[&str] = &["11", "22", "33", "2x12", "2x23", "2x13"];

/// What the fields of a Galerkin solid show of its present state.
pub(super) fn fields<'a>(solid: &'a GalerkinSolid, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
    let nodes = solid.galerkin().nodes();
    let linear = shown.forces.filter(|row| row.len() == (3 + RECOVERED) * nodes);
    let chunks = |row: &[f64]| row[3 * nodes..].as_chunks::<RECOVERED>().0.to_vec();
    let principal = shown.of_stresses.principal;
    let stresses = match shown.state {
        State::Moving | State::Balance if principal => Some(solid.stresses_at_nodes()),
        // Of a linear answer nothing has turned.
        State::Linear if principal => linear.map(|row| {
            let of =
                |own: &[f64; RECOVERED]| in_space(std::array::from_fn(|i| own[i]), solid.galerkin().axes());
            chunks(row).iter().map(of).collect()
        }),
        _ => None,
    };
    let recovered = match shown.state {
        State::Moving | State::Balance if shown.stresses => Some(solid.at_nodes()),
        State::Linear if shown.stresses => linear.map(chunks),
        _ => None,
    };
    let known = || Some(solid.reactions()?.to_vec());
    let reactions = match shown.state {
        State::Moving | State::Balance => known(),
        State::Linear | State::Greatest => {
            linear.map(|row| row[..3 * nodes].as_chunks::<3>().0.iter().map(|&f| Vec3::from(f)).collect())
        }
        State::Mode => None,
    };
    Box::new(Content { solid, shown: *shown, recovered, stresses, reactions })
}

/// What is written of one frame.
struct Content<'a> {
    solid: &'a GalerkinSolid,
    shown: FieldRequest<'a>,
    /// Stress, strain and angle at nodes; none if they are not asked for, or have no size.
    recovered: Option<Vec<[f64; RECOVERED]>>,
    /// Stress in space at nodes; none if its principal values are not asked for.
    stresses: Option<Vec<[f64; 6]>>,
    /// Forces of supports; none where they are not known.
    reactions: Option<Vec<Vec3>>,
}

impl FieldSource for Content<'_> {
    fn write(&self, part: Part, to: &mut dyn FieldWriter) -> io::Result<()> {
        match part {
            Part::Surface | Part::Extruded => self.nodes(to),
            Part::Points => self.points(to),
            // It has none.
            Part::Tools => Ok(()),
        }
    }
}

impl Content<'_> {
    /// Nodes with the cells between them.
    fn nodes(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let (solid, galerkin) = (self.solid, self.solid.galerkin());
        let count = galerkin.nodes();
        let moved: Vec<Vec3> = (0..count).map(|a| galerkin.displacement(a)).collect();
        let places = rows(count, |a| <[f64; 3]>::from(galerkin.rest()[a] + moved[a]));
        let cell = |number: usize| (Kind::Hexahedron, solid.hexahedra()[number]);
        to.geometry(&places, Connectivity { count: solid.hexahedra().len(), cell: &cell })?;
        self.displacements(to, &moved)?;
        if let Some(reactions) = &self.reactions {
            let all = rows(count, |a| <[f64; 3]>::from(reactions[a]));
            self.put(to, "reaction", Quantity::Force, &[], Values::Double(&all))?;
        }
        if let Some(values) = &self.recovered {
            self.stresses(to, values)?;
        }
        if let Some(stresses) = &self.stresses {
            principal_fields(to, stresses, &self.shown.units)?;
        }
        self.flowed(to, || self.solid.flowed_at_nodes().iter().map(|own| own.plastic_strain).collect())
    }

    /// Plastic strain, where the material yields and the state is one that it went through.
    fn flowed(&self, to: &mut dyn FieldWriter, values: impl Fn() -> Vec<f64>) -> io::Result<()> {
        if !matches!(self.shown.state, State::Moving | State::Balance) {
            return Ok(());
        }
        let values = values();
        if values.is_empty() {
            return Ok(());
        }
        let all = rows(values.len(), |i| [values[i] as f32]);
        self.put(to, "plastic_strain", Quantity::Ratio, &[], Values::Single(&all))
    }

    /// The points where the integrals are taken, each a cell of its own.
    fn points(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let galerkin = self.solid.galerkin();
        let results = galerkin.point_results();
        // Where shape functions were found once they are found again.
        let moved: Vec<Vec3> =
            results.iter().map(|point| galerkin.displacement_at(&point.place).unwrap_or_default()).collect();
        let places = rows(results.len(), |g| <[f64; 3]>::from(results[g].place + moved[g]));
        let cell = |number: usize| (Kind::Vertex, [number as u32; 8]);
        to.geometry(&places, Connectivity { count: results.len(), cell: &cell })?;
        self.displacements(to, &moved)?;
        self.flowed(to, || galerkin.flowed().iter().map(|[strain, _]| *strain).collect())?;
        if self.recovered.is_none() || matches!(self.shown.state, State::Linear | State::Greatest) {
            return Ok(());
        }
        let values: Vec<[f64; RECOVERED]> = results.iter().map(all_of).collect();
        self.stresses(to, &values)
    }

    fn displacements(&self, to: &mut dyn FieldWriter, moved: &[Vec3]) -> io::Result<()> {
        // The displacements of a mode have no size.
        let mode = self.shown.state == State::Mode;
        let quantity = if mode { Quantity::Ratio } else { Quantity::Length };
        let all = rows(moved.len(), |a| <[f64; 3]>::from(moved[a]));
        self.put(to, "displacement", quantity, &[], Values::Double(&all))
    }

    /// Co-rotated stress, strain, angle; the shear energy of the stress as one number.
    fn stresses(&self, to: &mut dyn FieldWriter, values: &[[f64; RECOVERED]]) -> io::Result<()> {
        let count = values.len();
        let six = |from: usize| {
            rows(count, move |a| std::array::from_fn::<f32, 6, _>(|i| values[a][from + i] as f32))
        };
        self.put(to, "stress", Quantity::Stress, STRESS, Values::Single(&six(0)))?;
        self.put(to, "strain", Quantity::Ratio, STRAIN, Values::Single(&six(6)))?;
        let angle = rows(count, |a| [values[a][12] as f32]);
        self.put(to, "rotation_angle", Quantity::Angle, &[], Values::Single(&angle))?;
        let mises = rows(count, |a| {
            let [xx, yy, zz, xy, yz, zx, ..] = values[a];
            [von_mises_in_space([xx, yy, zz, xy, yz, zx]) as f32]
        });
        self.put(to, "von_mises", Quantity::Stress, &[], Values::Single(&mises))
    }

    fn put(
        &self,
        to: &mut dyn FieldWriter,
        name: &str,
        quantity: Quantity,
        components: &[&str],
        values: Values<'_>,
    ) -> io::Result<()> {
        to.numbers(At::Points, name, &self.shown.units.symbol(quantity), components, values)
    }
}
