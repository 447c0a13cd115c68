//! What of a scene must stay on particles as its lattice changes: numbers of cells that do so, direction by direction.
//!
//! A set that reaches from the k-th to the l-th row of n cells stays where it is on m cells if k m/n and l m/n are whole: m is a multiple of
//! n/gcd(n, k) and n/gcd(n, l). Without that the point of a column jumps to the next particle, and differences between lattices tell of the
//! jump alone. A face of nodes at centres is their outermost layer on every lattice: it comes to lie on the face as the spacing falls, and asks for nothing.

use std::collections::BTreeMap;

use sph_core::{NodePlaces, Vec3};

use super::refined::cells;
use crate::scene::{BodyScene, Checked, Scene};

/// Faces of a block.
const FACES: [&str; 6] = ["x0", "x1", "y0", "y1", "z0", "z1"];

/// A declared or middle set, and what it asks of the numbers of cells.
pub(super) struct KeptSet {
    /// Its name.
    pub name: String,
    /// What the number of cells along each direction must be a multiple of.
    pub multiples: Vec<usize>,
    /// Whether columns alone name it, and nothing that acts on the body.
    pub read_only: bool,
}

/// The sets of the one body that hold numbers of cells, from its places at rest and its sets by name; none where it has no rows.
pub(super) fn kept(scene: &Checked, rest: &[Vec3], sets: &BTreeMap<String, Vec<u32>>) -> Vec<KeptSet> {
    let Some(rows) = Rows::of(scene, rest) else { return Vec::new() };
    let Ok(body) = scene.first_body() else { return Vec::new() };
    let (acting, reading) = named(scene);
    let [acting, reading] =
        [&acting, &reading].map(|names| body.with_operands(names.iter().map(String::as_str)));
    let is_named = |name: &str| acting.contains(name) || reading.contains(name);
    // What is made of sets stays where these stay.
    let is_made = |name: &str| scene.sets.get(name).is_some_and(|region| region.made().is_some());
    let wanted = sets.iter().filter(|(name, _)| is_named(name) || scene.sets.contains_key(*name));
    let wanted = wanted.filter(|(name, _)| !is_made(name));
    let one = |(name, members): (&String, &Vec<u32>)| {
        // Between nodes at centres a point falls to the nearest on every lattice, and a face is the outermost of them.
        let free = match scene.sets.get(name) {
            Some(region) => region.nearest.is_some(),
            None => FACES.contains(&name.as_str()),
        };
        let multiples =
            if free && rows.centred { vec![1; rows.cells.len()] } else { rows.multiples(members) };
        // What neither acts nor is read may hold cells of a part.
        let read_only = reading.contains(name.as_str()) && !acting.contains(name.as_str());
        KeptSet { name: name.clone(), multiples, read_only }
    };
    wanted.map(one).filter(|set| set.multiples.iter().any(|&multiple| multiple > 1)).collect()
}

/// Names of the sets that supports, loads and parts act on, and of those that columns read.
fn named(scene: &Scene) -> (Vec<String>, Vec<String>) {
    let mut supports = scene.supports.clone();
    let mut acting: Vec<String> = supports
        .iter_mut()
        .flat_map(|support| support.sets_mut().map(|on| on.clone()).collect::<Vec<_>>())
        .collect();
    acting.extend(scene.loads.iter().map(|load| load.on.clone()));
    if let Some(shell) = scene.as_shell() {
        acting.extend(shell.parts.iter().map(|part| part.on.clone()));
        acting.extend(shell.masses.iter().map(|mass| mass.on.clone()));
        acting.extend(shell.stiffeners.iter().map(|bar| bar.on.clone()));
        acting.extend(shell.rigid.iter().map(|set| set.on.clone()));
    }
    (acting, scene.curve.iter().map(|column| column.on.clone()).collect())
}

/// Rows of particles along each direction.
struct Rows {
    /// Cells.
    cells: Vec<usize>,
    /// Whether particles stand at their centres.
    centred: bool,
    /// The row of each particle.
    of: Vec<Vec<usize>>,
}

impl Rows {
    /// Of a lattice whose particles are all there, in order along the last direction first.
    fn of(scene: &Checked, rest: &[Vec3]) -> Option<Self> {
        let cells: Vec<usize> = cells(scene).into_iter().map(|cells| cells as usize).collect();
        match scene.bodies.values().next() {
            Some(BodyScene::Shell(_)) if !cells.is_empty() => {
                let across = cells[1] + 1;
                let of = (0..rest.len()).map(|a| vec![a / across, a % across]).collect();
                (rest.len() == (cells[0] + 1) * across).then_some(Self { cells, centred: false, of })
            }
            Some(BodyScene::Solid(solid)) if solid.geometry.block.is_some() => {
                let lattice = solid.lattice();
                if lattice.disorder > 0.0 || lattice.grading.iter().any(|&grading| grading != 1.0) {
                    return None;
                }
                let centred = lattice.nodes == NodePlaces::Centres;
                let row = |x: &Vec3, axis: usize| {
                    let along = (x[axis] - lattice.origin[axis]) / lattice.lengths[axis] * cells[axis] as f64;
                    (along - if centred { 0.5 } else { 0.0 }).round().max(0.0) as usize
                };
                let of = rest.iter().map(|x| (0..cells.len()).map(|axis| row(x, axis)).collect()).collect();
                Some(Self { cells, centred, of })
            }
            _ => None,
        }
    }

    /// What the numbers of cells must be multiples of so that a set stays where it is.
    fn multiples(&self, members: &[u32]) -> Vec<usize> {
        let of_axis = |axis: usize| {
            let rows = members.iter().filter_map(|&a| Some(self.of.get(a as usize)?[axis]));
            let ends = rows.fold(None, |ends: Option<[usize; 2]>, row| {
                Some(ends.map_or([row, row], |[low, high]| [low.min(row), high.max(row)]))
            });
            let Some([low, high]) = ends else { return 1 };
            // A cell reaches to the next face.
            let high = if self.centred { high + 1 } else { high };
            let n = self.cells[axis];
            least_common_multiple(n / greatest_common_divisor(n, low), n / greatest_common_divisor(n, high))
        };
        (0..self.cells.len()).map(of_axis).collect()
    }
}

/// The greatest whole number that divides both; of zero and another that other.
pub(super) fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

/// The least number that both divide.
pub(super) fn least_common_multiple(a: usize, b: usize) -> usize {
    a / greatest_common_divisor(a, b) * b
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_holds_the_fractions_at_which_it_begins_and_ends() {
        // 20×6 cells: a point at a quarter and the middle, an edge, a third of the width.
        let of = (0..21 * 7).map(|a| vec![a / 7, a % 7]).collect();
        let rows = Rows { cells: vec![20, 6], centred: false, of };
        let at = |i: u32, j: u32| i * 7 + j;
        assert_eq!(rows.multiples(&[at(5, 3)]), [4, 2]);
        assert_eq!(rows.multiples(&(0..7).map(|j| at(20, j)).collect::<Vec<_>>()), [1, 1]);
        assert_eq!(rows.multiples(&[at(0, 0), at(0, 1), at(0, 2)]), [1, 3]);
        assert_eq!(rows.multiples(&[at(7, 0)]), [20, 1]);
    }

    #[test]
    fn rows_of_centres_end_at_the_faces_of_their_cells() {
        let of = (0..12).map(|a| vec![a]).collect();
        let rows = Rows { cells: vec![12], centred: true, of };
        assert_eq!(rows.multiples(&[0, 1, 2]), [4]);
        assert_eq!(rows.multiples(&(0..12).collect::<Vec<_>>()), [1]);
    }
}
