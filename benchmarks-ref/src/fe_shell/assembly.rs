//! Numbering of the free degrees of freedom, the tangent's pattern, and where each element adds to it.

use super::support::Frame;

/// DofMap of a node: three displacements, two turns of the director.
const DOF: usize = 5;

/// Entries in the lower triangle of an element's tangent.
const ENTRIES: usize = 210;

/// Marks an entry of an element that belongs to a held dof.
const HELD: u32 = u32::MAX;

/// Numbers and places, the same for every state.
#[derive(Debug, Clone)]
pub struct Assembly {
    /// Unknown of each dof of each node.
    numbers: Vec<[Option<usize>; DOF]>,
    /// Node and dof of each unknown.
    owners: Vec<(usize, usize)>,
    /// Positions (row, column), row ≥ column, by rows.
    pattern: Vec<(usize, usize)>,
    /// Place in the pattern of each entry of each element.
    places: Vec<[u32; ENTRIES]>,
}

impl Assembly {
    /// Numbers the degrees of freedom that the frames leave, node by node, and finds the pattern.
    pub fn new(frames: &[Frame], elements: impl Iterator<Item = [usize; 4]>) -> Self {
        let mut owners = Vec::new();
        let numbers: Vec<[Option<usize>; DOF]> = frames
            .iter()
            .enumerate()
            .map(|(node, frame)| {
                std::array::from_fn(|dof| {
                    let free = if dof < 3 { dof >= frame.held } else { dof - 3 < frame.turns };
                    free.then(|| {
                        owners.push((node, dof));
                        owners.len() - 1
                    })
                })
            })
            .collect();
        let entries: Vec<Vec<Option<(usize, usize)>>> =
            elements.map(|nodes| entries(&nodes, &numbers)).collect();
        let mut pattern: Vec<(usize, usize)> = entries.iter().flatten().flatten().copied().collect();
        pattern.extend((0..owners.len()).map(|unknown| (unknown, unknown)));
        pattern.sort_unstable();
        pattern.dedup();
        let place = |entry: Option<(usize, usize)>| {
            entry.and_then(|entry| pattern.binary_search(&entry).ok()).map_or(HELD, |place| place as u32)
        };
        let places =
            entries.iter().map(|entries| std::array::from_fn(|index| place(entries[index]))).collect();
        Self { numbers, owners, pattern, places }
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.owners.len()
    }

    /// Lower triangle, by rows.
    pub fn pattern(&self) -> Vec<(usize, usize)> {
        self.pattern.clone()
    }

    /// The unknown of a node's dof, if it is free.
    pub fn unknown(&self, node: usize, dof: usize) -> Option<usize> {
        self.numbers[node][dof]
    }

    /// Node and dof of an unknown.
    pub fn owner(&self, unknown: usize) -> (usize, usize) {
        self.owners[unknown]
    }

    /// Adds an element's tangent to the values of the pattern.
    pub fn scatter(&self, element: usize, tangent: &[[f64; 20]; 20], values: &mut [f64]) {
        let lower = tangent.iter().enumerate().flat_map(|(row, entries)| &entries[..=row]);
        for (&place, value) in self.places[element].iter().zip(lower) {
            if place != HELD {
                values[place as usize] += value;
            }
        }
    }
}

/// Positions of an element's lower triangle, row by row; `None` where a dof is held.
fn entries(nodes: &[usize; 4], numbers: &[[Option<usize>; DOF]]) -> Vec<Option<(usize, usize)>> {
    let unknown = |local: usize| numbers[nodes[local / DOF]][local % DOF];
    let pair = |row: usize, column: usize| {
        let (first, second) = (unknown(row)?, unknown(column)?);
        Some((first.max(second), first.min(second)))
    };
    (0..20)
        .flat_map(|row| (0..=row).map(move |column| (row, column)))
        .map(|(row, column)| pair(row, column))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    #[test]
    fn held_degrees_of_freedom_have_no_number_and_the_pattern_holds_the_diagonal() {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let free = Frame { axes, held: 0, turns: 2 };
        let clamped = Frame { axes, held: 3, turns: 0 };
        let frames = [clamped.clone(), free.clone(), free, clamped];
        let assembly = Assembly::new(&frames, std::iter::once([0, 1, 2, 3]));
        assert_eq!(assembly.unknowns(), 10);
        assert_eq!(assembly.pattern().len(), 55);
        assert_eq!((assembly.unknown(0, 0), assembly.unknown(1, 0)), (None, Some(0)));
        assert_eq!(assembly.owner(7), (2, 2));
        let mut values = vec![0.0; 55];
        let tangent = std::array::from_fn(|row| std::array::from_fn(|column| (row.max(column)) as f64));
        assembly.scatter(0, &tangent, &mut values);
        assert_eq!(values[..3], [5.0, 6.0, 6.0]);
    }
}
