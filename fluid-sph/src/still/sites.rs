//! The water before the sites of wet faces.

use sph_core::{CellList, Vec3};

use super::links::{Link, way};
use super::{StillError, StillParts};

/// Part of half a cell by which a point on its side is within.
const WITHIN: f64 = 1e-6;
/// Least distance of the water from a face that counts, in spacings.
const LEAST: f64 = 1e-2;
/// Part of half the thickness below which a particle stands inside of the shell and not at its face.
const INSIDE: f64 = 0.98;

/// The water before a site.
#[derive(Clone, Debug)]
pub(super) struct Site {
    /// Cells whose pressures make up that of the water, with their weights; that of a cell mirrored at the free surface is less.
    pub cells: Vec<(u32, f64)>,
    /// Distance of the water from the face \[L\].
    pub depth: f64,
}

/// Finds the water half a spacing before each site; none where there is none.
pub(super) fn sites(
    parts: &StillParts<'_>,
    list: &CellList,
    links: &[[Link; 6]],
) -> Result<Vec<Option<Site>>, StillError> {
    let &StillParts { dimensions, spacing, positions, sites, .. } = parts;
    let (mut near, mut all) = (Vec::new(), Vec::with_capacity(sites.len()));
    for site in sites {
        list.within(&site.place, 0.5 * spacing + site.half, &mut near);
        for &cell in &near {
            let away = positions[cell as usize] - site.place;
            let height = away.dot(&site.normal);
            let beside = (away - site.normal * height).norm() < 0.5 * spacing;
            if beside && height.abs() < INSIDE * site.half {
                return Err(StillError::Inside { at: positions[cell as usize].into() });
            }
        }
        let face = site.place + site.normal * site.half;
        let point = face + site.normal * (0.5 * spacing);
        list.within(&point, spacing, &mut near);
        let away = |cell: &u32| (point - positions[*cell as usize]) / spacing;
        let within = |cell: &&u32| (0..dimensions).all(|k| away(cell)[k].abs() <= 0.5 + WITHIN);
        let holder = near.iter().filter(within);
        let holder =
            holder.min_by(|&a, &b| away(a).norm_squared().total_cmp(&away(b).norm_squared())).copied();
        all.push(holder.map(|holder| {
            let away = away(&holder);
            let mut corners = Corners { links, positions, spacing, away, found: Vec::new() };
            corners.spread(holder, 0, dimensions, 1.0, positions[holder as usize]);
            let depth = corners.found.iter().map(|&(_, w, x)| w.abs() * (x - face).dot(&site.normal));
            let depth = depth.sum::<f64>().max(LEAST * spacing);
            let mut cells: Vec<(u32, f64)> = Vec::new();
            for (cell, weight, _) in corners.found {
                match cells.iter_mut().find(|known| known.0 == cell) {
                    Some(known) => known.1 += weight,
                    None => cells.push((cell, weight)),
                }
            }
            Site { cells, depth }
        }));
    }
    Ok(all)
}

/// The corners of the cube of neighbours about a point, with their parts of a function that is linear along each axis.
struct Corners<'a> {
    links: &'a [[Link; 6]],
    positions: &'a [Vec3],
    spacing: f64,
    /// From the cell that holds the point to it, in spacings.
    away: Vec3,
    /// Cells, weights and places.
    found: Vec<(u32, f64, Vec3)>,
}

impl Corners<'_> {
    /// Shares a weight of a cell, which stands for a place, over its neighbours along the axes from one on. What lies behind a wall has the pressure
    /// before it, what lies beyond the free surface the opposite one.
    fn spread(&mut self, cell: u32, axis: usize, dimensions: usize, weight: f64, place: Vec3) {
        if axis == dimensions {
            self.found.push((cell, weight, place));
            return;
        }
        let along = self.away[axis];
        let (side, part) = (2 * axis + usize::from(along > 0.0), along.abs());
        self.spread(cell, axis + 1, dimensions, weight * (1.0 - part), place);
        if part == 0.0 {
            return;
        }
        let weight = weight * part;
        match self.links[cell as usize][side] {
            Link::To(other) => {
                self.spread(other, axis + 1, dimensions, weight, self.positions[other as usize]);
            }
            Link::Closed => self.spread(cell, axis + 1, dimensions, weight, place),
            Link::Open => {
                self.spread(cell, axis + 1, dimensions, -weight, place + way(side) * self.spacing);
            }
        }
    }
}
