//! What a solid shows of a state: its nodes with their fields, in a plane with the quadrangles between them.
//!
//! What a state consists of is written to the last bit, what follows from it in single precision.

use std::io;

use mesh_io::{At, Connectivity, FieldWriter, Kind, Values, rows};
use peridynamics::Solid;
use sph_core::Vec3;

use crate::bodies::invariants::{Principal, von_mises_in_space};
use crate::bodies::{FieldRequest, FieldSource, Part, State};
use crate::scene::units::{Quantity, Units};

const XYZ: &[&str] = &[];
const TENSOR: &[&str] = &["xx", "yy", "zz", "xy", "yz", "zx"];

/// What the fields of a solid show of its present state.
pub(super) fn fields<'a>(solid: &'a Solid, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
    Box::new(Content { solid, shown: *shown })
}

/// What is written of one frame.
struct Content<'a> {
    solid: &'a Solid,
    shown: FieldRequest<'a>,
}

impl FieldSource for Content<'_> {
    /// A solid has no other part than its nodes.
    fn write(&self, _: Part, to: &mut dyn FieldWriter) -> io::Result<()> {
        self.geometry(to)?;
        self.motion(to)?;
        self.forces(to)?;
        self.bonds(to)
    }
}

impl Content<'_> {
    fn geometry(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let (solid, cells) = (self.solid, &self.solid.block().cells);
        let points = rows(solid.len(), |a| xyz(solid.position(a)));
        if cells.is_empty() {
            let cell = |a: usize| (Kind::Vertex, [a as u32; 8]);
            return to.geometry(&points, Connectivity { count: solid.len(), cell: &cell });
        }
        let cell = |number: usize| {
            let [a, b, c, d] = cells[number].corners;
            (Kind::Quadrangle, [a, b, c, d, 0, 0, 0, 0])
        };
        to.geometry(&points, Connectivity { count: cells.len(), cell: &cell })
    }

    fn motion(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let (solid, state) = (self.solid, self.shown.state);
        // The displacements of a mode have no size.
        let quantity = if state == State::Mode { Quantity::Ratio } else { Quantity::Length };
        self.vectors(to, "displacement", quantity, &|a| solid.displacement(a))?;
        if state == State::Moving {
            self.vectors(to, "velocity", Quantity::Speed, &|a| solid.velocity(a))?;
        }
        if solid.director(0).is_some() {
            self.vectors(to, "director", Quantity::Ratio, &|a| solid.director(a).unwrap_or_default())?;
        }
        self.numbers(to, "volume", Quantity::Volume, |a| solid.block().volumes[a])
    }

    /// Reactions; where nothing is in balance and nothing moves there are none.
    fn forces(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let solid = self.solid;
        let linear = self.linear().map(|[reactions, _]| reactions);
        let force = |a: usize| match linear {
            Some(row) => Vec3::from_column_slice(&row[3 * a..3 * a + 3]),
            None => solid.reaction(a),
        };
        match self.shown.state {
            State::Mode => return Ok(()),
            State::Linear | State::Greatest if linear.is_none() => return Ok(()),
            State::Moving | State::Balance | State::Linear | State::Greatest => {}
        }
        // Where nothing is held the same difference of forces is what accelerates: no reaction.
        let reaction = |a: usize| if solid.is_held(a) { force(a) } else { Vec3::zeros() };
        self.vectors(to, "reaction", Quantity::Force, &reaction)
    }

    /// Reactions and stresses of a linear answer, node by node.
    fn linear(&self) -> Option<[&[f64]; 2]> {
        let count = self.solid.len();
        let (reactions, stresses) =
            self.shown.forces.filter(|row| row.len() == 9 * count)?.split_at(3 * count);
        Some([reactions, stresses])
    }

    /// What bonds say: damage and, of states that have a size, stress; of those of their own size, energy.
    fn bonds(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        let solid = self.solid;
        self.numbers(to, "damage", Quantity::Ratio, |a| solid.damage(a))?;
        match self.shown.state {
            State::Mode | State::Greatest => return Ok(()),
            State::Linear => {
                let Some([_, stresses]) = self.linear() else { return Ok(()) };
                return self.stresses(to, stresses.as_chunks().0);
            }
            State::Moving | State::Balance => {}
        }
        if solid.plastic_strain(0).is_some() {
            self.numbers(to, "plastic_strain", Quantity::Ratio, |a| {
                solid.plastic_strain(a).unwrap_or_default()
            })?;
        }
        self.numbers(to, "strain_energy", Quantity::Stress, |a| solid.strain_energy(a))?;
        if !self.shown.stresses && !self.shown.of_stresses.principal {
            return Ok(());
        }
        let stresses: Vec<[f64; 6]> = (0..solid.len()).map(|a| stress_of(solid, a)).collect();
        self.stresses(to, &stresses)
    }

    /// Stresses of all nodes, and what follows from them, where they are asked for.
    fn stresses(&self, to: &mut dyn FieldWriter, stresses: &[[f64; 6]]) -> io::Result<()> {
        if self.shown.of_stresses.principal {
            principal_fields(to, stresses, &self.shown.units)?;
        }
        if !self.shown.stresses {
            return Ok(());
        }
        let all = rows(stresses.len(), |a| stresses[a].map(|value| value as f32));
        self.put(to, "stress", Quantity::Stress, TENSOR, Values::Single(&all))?;
        self.numbers(to, "von_mises", Quantity::Stress, |a| von_mises_in_space(stresses[a]))
    }

    /// A number for each node, in single precision.
    fn numbers(
        &self,
        to: &mut dyn FieldWriter,
        name: &str,
        quantity: Quantity,
        value: impl Fn(usize) -> f64,
    ) -> io::Result<()> {
        let all = rows(self.solid.len(), |a| [value(a) as f32]);
        self.put(to, name, quantity, &[], Values::Single(&all))
    }

    fn vectors(
        &self,
        to: &mut dyn FieldWriter,
        name: &str,
        quantity: Quantity,
        vector: &dyn Fn(usize) -> Vec3,
    ) -> io::Result<()> {
        let all = rows(self.solid.len(), |a| xyz(vector(a)));
        self.put(to, name, quantity, XYZ, Values::Double(&all))
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

/// Principal stresses of stresses `xx, yy, zz, xy, yz, zx` at points, the greatest first, with the axes of the first and the last, and Tresca's stress.
pub(in crate::bodies) fn principal_fields(
    to: &mut dyn FieldWriter,
    stresses: &[[f64; 6]],
    units: &Units,
) -> io::Result<()> {
    let found: Vec<Principal> = stresses.iter().map(|&stress| Principal::of(stress)).collect();
    let (count, stress, ratio) = (found.len(), units.symbol(Quantity::Stress), units.symbol(Quantity::Ratio));
    let all = rows(count, |a| found[a].stresses.map(|value| value as f32));
    to.numbers(At::Points, "principal_stress", &stress, &["1", "2", "3"], Values::Single(&all))?;
    for (name, which) in [("principal_direction_1", 0), ("principal_direction_3", 2)] {
        let all = rows(count, |a| xyz(found[a].axes[which]).map(|value| value as f32));
        to.numbers(At::Points, name, &ratio, XYZ, Values::Single(&all))?;
    }
    let all = rows(count, |a| [found[a].tresca() as f32]);
    to.numbers(At::Points, "tresca", &stress, &[], Values::Single(&all))
}

/// Stress `xx, yy, zz, xy, yz, zx` of a node \[F/L²\].
pub(super) fn stress_of(solid: &Solid, node: usize) -> [f64; 6] {
    let s = solid.stress(node);
    [s[(0, 0)], s[(1, 1)], s[(2, 2)], s[(0, 1)], s[(1, 2)], s[(2, 0)]]
}

fn xyz(v: Vec3) -> [f64; 3] {
    v.into()
}
