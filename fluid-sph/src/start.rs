//! What a fluid is built from, checked; and its pressures at the start.

use sph_core::Vec3;

use crate::cells::Grid;
use crate::error::FluidError;
use crate::liquid::Liquid;
use crate::parts::Parts;
use crate::periods::{Copies, Periods};
use crate::sorted::Sorted;

/// Distance up to which particles are of one body of water, in spacings.
const CONNECTED: f64 = 1.6;

/// Refuses numbers out of bounds and lists of wrong lengths.
pub(crate) fn check(parts: &Parts) -> Result<(), FluidError> {
    let Parts { dimensions, spacing, positions, velocities, liquid, formulation, gravity, domain, .. } =
        parts;
    if !matches!(dimensions, 2 | 3) {
        return Err(FluidError::Dimensions(*dimensions));
    }
    for (key, value) in
        [("spacing", *spacing), ("density", liquid.density), ("sound_speed", liquid.sound_speed)]
    {
        if !(value > 0.0 && value.is_finite()) {
            return Err(FluidError::Option { key, value, bound: "positive and finite" });
        }
    }
    formulation.check()?;
    let count = positions.len();
    if count == 0 {
        return Err(FluidError::Empty);
    }
    if count >= u32::MAX as usize {
        return Err(FluidError::TooMany(count));
    }
    if !velocities.is_empty() && velocities.len() != count {
        return Err(FluidError::Length { what: "velocities", found: velocities.len(), expected: count });
    }
    let corners = domain.map_or_else(Vec::new, |corners| corners.to_vec());
    let gravity = [*gravity];
    let lists: [(&'static str, &[Vec3]); 4] = [
        ("position", positions),
        ("velocity", velocities),
        ("gravity", &gravity),
        ("corner of the domain", &corners),
    ];
    for (what, list) in lists {
        if let Some(index) = list.iter().position(|v| !v.iter().all(|x| x.is_finite())) {
            return Err(FluidError::NotFinite { what, index });
        }
    }
    if let Some(domain) = domain {
        let outside = |position: &Vec3| outside(*dimensions, domain, position);
        if let Some(particle) = positions.iter().position(outside) {
            return Err(FluidError::Outside(particle));
        }
    }
    Ok(())
}

/// Whether a place lies outside a box.
pub(crate) fn outside(dimensions: usize, [low, high]: &[Vec3; 2], at: &Vec3) -> bool {
    !(0..dimensions).all(|k| at[k] >= low[k] && at[k] <= high[k])
}

/// Densities under the weight of the water above: below the highest particle of each connected body and half a spacing. Bodies may be
/// connected across periodic sides.
pub(crate) fn hydrostatic(
    dimensions: usize,
    spacing: f64,
    positions: &[Vec3],
    gravity: &Vec3,
    liquid: &Liquid,
    periods: Option<&Periods>,
) -> Vec<f64> {
    let strength = gravity.norm();
    if strength == 0.0 {
        return vec![liquid.density; positions.len()];
    }
    let height = |position: &Vec3| -gravity.dot(position) / strength;
    let bodies = bodies(dimensions, CONNECTED * spacing, positions, periods);
    let mut tops = vec![f64::NEG_INFINITY; positions.len()];
    for (position, &body) in positions.iter().zip(&bodies) {
        tops[body] = tops[body].max(height(position) + 0.5 * spacing);
    }
    let density = |(position, &body): (&Vec3, &usize)| {
        liquid.density_at(liquid.density * strength * (tops[body] - height(position)))
    };
    positions.iter().zip(&bodies).map(density).collect()
}

/// By particle: the first of all that are connected to it by particles so far apart at most.
fn bodies(dimensions: usize, distance: f64, positions: &[Vec3], periods: Option<&Periods>) -> Vec<usize> {
    let mut copies = Copies::default();
    if let Some(periods) = periods {
        copies.find(periods, positions.len(), distance, |i| positions[i]);
    }
    let (all, place) = (copies.all(positions.len()), |number: usize| copies.place(number, |i| positions[i]));
    let grid = Grid::around(dimensions, (0..all).map(place), distance);
    let mut sorted = Sorted::default();
    sorted.sort(1, &grid, all, |number, _| Some(place(number).into()));
    let mut body = vec![usize::MAX; positions.len()];
    let mut front = Vec::new();
    for first in 0..positions.len() {
        if body[first] != usize::MAX {
            continue;
        }
        body[first] = first;
        front.push(first);
        while let Some(a) = front.pop() {
            let cell = grid.cell(&place(a).into());
            for &(from, to) in grid.beside(cell, &sorted.starts).filled() {
                for &number in &sorted.order[from as usize..to as usize] {
                    let b = copies.source(number as usize);
                    if body[b] == usize::MAX && (place(a) - place(number as usize)).norm() < distance {
                        body[b] = first;
                        front.push(b);
                    }
                }
            }
        }
    }
    body
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two pools with a gap: each has its own surface.
    #[test]
    fn each_body_of_water_has_its_own_surface() {
        let liquid = Liquid { density: 1000.0, sound_speed: 50.0 };
        let column = |x: f64, rows: usize| (0..rows).map(move |j| Vec3::new(x, 0.1 * j as f64 + 0.05, 0.0));
        let positions: Vec<Vec3> = column(0.0, 10).chain(column(1.0, 4)).collect();
        let densities = hydrostatic(2, 0.1, &positions, &Vec3::new(0.0, -10.0, 0.0), &liquid, None);
        for (position, density) in positions.iter().zip(densities) {
            let top = if position.x < 0.5 { 1.0 } else { 0.4 };
            let exact = 1e4 * (top - position.y);
            assert!((liquid.pressure(density) - exact).abs() < 1e-7, "{position}");
        }
    }
}
