//! What a rigid body shows of a state: its surface, which moves.

use std::io;

use mesh_io::{At, Connectivity, FieldWriter, Kind, Values, rows};
use rigid_body::RigidBody;
use sph_core::Vec3;

use crate::bodies::{FieldRequest, FieldSource, Part, State};
use crate::scene::units::Quantity;

/// What the fields of a rigid body show of its present state.
pub(super) fn fields<'a>(body: &'a RigidBody, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
    let shown = *shown;
    Box::new(move |_: Part, to: &mut dyn FieldWriter| write(body, &shown, to))
}

fn write(body: &RigidBody, shown: &FieldRequest<'_>, to: &mut dyn FieldWriter) -> io::Result<()> {
    let (cells, positions) = (body.cells(), body.positions());
    let points = rows(body.len(), |a| xyz(positions[a]));
    let cell = |number: usize| {
        let [a, b, c, d] = cells[number].corners;
        let kind = if cells[number].count == 3 { Kind::Triangle } else { Kind::Quadrangle };
        (kind, [a, b, c, d, 0, 0, 0, 0])
    };
    to.geometry(&points, Connectivity { count: cells.len(), cell: &cell })?;
    let mut vectors = |name: &str, quantity: Quantity, vector: &dyn Fn(usize) -> Vec3| {
        let all = rows(body.len(), |a| xyz(vector(a)));
        to.numbers(At::Points, name, &shown.units.symbol(quantity), &[], Values::Double(&all))
    };
    // The displacements of a mode have no size.
    let quantity = if shown.state == State::Mode { Quantity::Ratio } else { Quantity::Length };
    vectors("displacement", quantity, &|a| positions[a] - body.rest()[a])?;
    if shown.state == State::Moving {
        vectors("velocity", Quantity::Speed, &|a| body.velocity(a))?;
    }
    Ok(())
}

fn xyz(v: Vec3) -> [f64; 3] {
    v.into()
}
