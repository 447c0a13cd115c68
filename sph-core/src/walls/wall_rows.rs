//! What rows of wall particles have in common: what is refused, spacings, particles kept apart, gaps.

use std::collections::BTreeSet;

use libm::round;

use crate::Vec3;
use crate::error::SpaceError;
use crate::neighbours::CellList;

/// Most particles that one wall may take.
const MOST_PARTICLES: f64 = 1e8;
/// Most rows: supports of kernels reach three spacings, seldom six.
const MOST_ROWS: usize = 20;
/// Widest gap in a row over the spacing that does not count as a leak.
const WIDEST_GAP: f64 = 1.2;
/// Least distance of two wall particles over the spacing.
const LEAST_DISTANCE: f64 = 0.5;

/// Counts the places where the first row of walls has a gap wider than 1.2 spacings.
///
/// `first_row` are points where the first row should stand, a quarter of the spacing apart or closer, as
/// [`polyline_first_row`](crate::polyline_first_row) and [`surface_first_row`](crate::surface_first_row) give them.
/// In a plane the middle of such a gap has no particle within 0.6 spacings; in space, where four particles stand
/// round a gap, none within 0.6 √2. Such points less than a spacing apart are one place. A wall thinner than a
/// spacing, or an edge of it sharper than about 50°, is named too: no particle fits in it. `spacing` is in \[L\].
pub fn leaks(first_row: &[Vec3], rows: &[Vec3], dimensions: usize, spacing: f64) -> usize {
    let reach = 0.5 * WIDEST_GAP * spacing * if dimensions == 2 { 1.0 } else { 2.0_f64.sqrt() };
    let near = CellList::new(rows, reach);
    let mut found = Vec::new();
    let mut open = first_row.to_vec();
    open.retain(|x| {
        near.within(x, reach, &mut found);
        found.is_empty()
    });
    let list = CellList::new(&open, spacing);
    let mut left: BTreeSet<u32> = (0..open.len() as u32).collect();
    let mut places = 0;
    while let Some(first) = left.pop_first() {
        places += 1;
        let mut front = vec![first];
        while let Some(at) = front.pop() {
            list.within(&open[at as usize], spacing, &mut found);
            front.extend(found.iter().filter(|&other| left.remove(other)));
        }
    }
    places
}

/// Refuses spacings and numbers of rows that make no wall.
pub(super) fn check(spacing: f64, rows: usize) -> Result<(), SpaceError> {
    if !(spacing > 0.0 && spacing.is_finite()) {
        return Err(SpaceError::OutOfRange { what: "spacing", value: spacing, bound: "(0, ∞)" });
    }
    if !(1..=MOST_ROWS).contains(&rows) {
        let (what, value) = ("number of rows of walls", rows as f64);
        return Err(SpaceError::OutOfRange { what, value, bound: "[1, 20]" });
    }
    Ok(())
}

/// Refuses more particles than a machine holds.
pub(super) fn check_count(count: f64) -> Result<(), SpaceError> {
    if count <= MOST_PARTICLES {
        return Ok(());
    }
    Err(SpaceError::OutOfRange { what: "number of wall particles", value: count, bound: "[1, 1e8]" })
}

/// Refuses dimensions other than two and three.
pub(super) fn check_dimensions(dimensions: usize) -> Result<(), SpaceError> {
    if dimensions == 2 || dimensions == 3 {
        return Ok(());
    }
    Err(SpaceError::OutOfRange { what: "number of dimensions", value: dimensions as f64, bound: "[2, 3]" })
}

/// Into how many parts a length is divided: the nearest to the spacing whose gaps are no leaks.
pub(super) fn divisions(length: f64, spacing: f64) -> usize {
    let parts = length / spacing;
    let nearest = round(parts).max(1.0);
    (if parts > WIDEST_GAP * nearest { nearest + 1.0 } else { nearest }) as usize
}

/// The particles without those nearer than half a spacing to one before them.
pub(super) fn apart(particles: Vec<Vec3>, spacing: f64) -> Vec<Vec3> {
    // Particles that a spacing divides evenly may stand at half of it but for rounding.
    let least = LEAST_DISTANCE * spacing * (1.0 + 1e-9);
    let list = CellList::new(&particles, spacing);
    let mut stays = vec![true; particles.len()];
    let mut found = Vec::new();
    for (first, x) in particles.iter().enumerate() {
        if stays[first] {
            list.within(x, least, &mut found);
            found
                .iter()
                .filter(|&&other| other as usize > first)
                .for_each(|&other| stays[other as usize] = false);
        }
    }
    let kept = particles.into_iter().zip(stays);
    kept.filter_map(|(x, stays)| stays.then_some(x)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_between_particles_are_never_leaks() {
        for length in (1..400).map(|i| 0.05 * f64::from(i)) {
            let gap = length / divisions(length, 1.0) as f64;
            assert!(gap <= WIDEST_GAP && (length < 0.6 || gap >= 0.6), "{length}: {gap}");
        }
        assert_eq!((divisions(7.4, 1.0), divisions(7.6, 1.0)), (7, 8));
    }

    #[test]
    fn the_first_of_two_near_particles_stays() {
        let row: Vec<Vec3> = (0..7).map(|i| Vec3::new(0.3 * f64::from(i), 0.0, 0.0)).collect();
        let kept = apart(row.clone(), 1.0);
        assert_eq!(kept, [row[0], row[2], row[4], row[6]]);
    }

    #[test]
    fn leaks_are_counted_by_place() {
        let row = |gap: f64| -> Vec<Vec3> {
            let places = [0.0, 1.0, 1.0 + gap, 2.0 + gap, 2.0 + 2.0 * gap];
            places.map(|x| Vec3::new(x, 0.0, 0.0)).to_vec()
        };
        let marks: Vec<Vec3> = (0..45).map(|i| Vec3::new(0.1 * f64::from(i), 0.0, 0.0)).collect();
        assert_eq!(leaks(&marks, &row(1.1), 2, 1.0), 0);
        assert_eq!(leaks(&marks[..44], &row(1.3), 2, 1.0), 2);
        assert_eq!(leaks(&marks[..44], &row(1.3), 3, 1.0), 0);
        assert_eq!(leaks(&marks, &[], 2, 1.0), 1);
    }
}
