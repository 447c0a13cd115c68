//! The plate with a crack in its middle, through its whole thickness or through one sheet: where it buckles.
//!
//! No closed form is known. A crack along the plate lets its middle go, one across it closes without contact: both lower
//! the load. Pulled, a plate with a crack across buckles beside the crack.

use implicit_statics::EquilibriumError;
use peridynamics::{Crack, Parts};
use sph_core::Vec3;

use crate::linear::critical;
use crate::plate::{Edges, LENGTHS, WAY, divided, parts, supports};

/// A crack in the middle of the plate.
#[derive(Clone, Copy, Debug)]
pub struct Middle {
    /// Its length along x and along y, one of which is zero \[mm\].
    pub length: [f64; 2],
    /// The sheets that it cuts: both, the upper or the lower.
    pub through: Through,
}

/// Which sheets a crack cuts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Through {
    /// Both.
    Both,
    /// The upper.
    Upper,
    /// The lower.
    Lower,
}

/// The plate with the crack between its rows, shortened or drawn out.
pub fn cracked(spacing: f64, crack: Middle, way: f64) -> Parts {
    // An odd number of cells across the crack: it lies between two rows.
    let odd = |length: f64| length / (2.0 * (0.5 * length / spacing).round() + 1.0);
    let cells = if crack.length[0] > 0.0 { [spacing, odd(LENGTHS[1])] } else { [odd(LENGTHS[0]), spacing] };
    let block = divided(cells);
    let supports = supports(&block, Edges::Held, way);
    let centre = Vec3::new(0.5 * LENGTHS[0], 0.5 * LENGTHS[1], 0.0);
    let half = Vec3::new(0.5 * crack.length[0], 0.5 * crack.length[1], 0.0);
    let ends = [centre - half, centre + half];
    let wall = |z: f64| {
        let up = Vec3::z() * z;
        Crack::Polygon(vec![ends[0], ends[1], ends[1] + up, ends[0] + up])
    };
    let crack = match crack.through {
        Through::Both => Crack::Segment(ends),
        Through::Upper => wall(LENGTHS[2]),
        Through::Lower => wall(-LENGTHS[2]),
    };
    Parts { cracks: vec![crack], ..parts(block, supports) }
}

/// Critical loads for cracks along and across, with the spacing.
pub fn table(spacings: &[f64]) -> Result<(), EquilibriumError> {
    println!("crack: critical loads shortened with spacings {spacings:?}");
    let along = |length: f64, through| Middle { length: [length, 0.0], through };
    let across = |length: f64, through| Middle { length: [0.0, length], through };
    for (name, crack, way) in [
        ("60 along, both", along(60.0, Through::Both), -WAY),
        ("120 along, both", along(120.0, Through::Both), -WAY),
        ("120 along, upper", along(120.0, Through::Upper), -WAY),
        ("120 along, lower", along(120.0, Through::Lower), -WAY),
        ("60 across, both", across(60.0, Through::Both), -WAY),
        ("120 across, both", across(120.0, Through::Both), -WAY),
        ("120 across, upper", across(120.0, Through::Upper), -WAY),
        ("120 across, both, drawn", across(120.0, Through::Both), WAY),
    ] {
        let loads: Vec<String> = spacings
            .iter()
            .map(|&spacing| match critical(&cracked(spacing, crack, way)) {
                Ok(found) => format!("{:.4}", found.load),
                Err(error) => error.to_string(),
            })
            .collect();
        println!("{name:24} {}", loads.join("  "));
    }
    Ok(())
}
