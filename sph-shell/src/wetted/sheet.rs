//! Places over the middle surface of a shell in space.

use sph_core::{Cell, CellList, Cloud, Lattice, Vec3};

use crate::wetted::places::Places;
use crate::wetted::strip::locate;
use crate::wetted::wetting::Wetting;

/// Distance, over the spacing, below which one of two places is left out: rows of cells do not divide all lengths.
const CLOSE: f64 = 0.7;

/// A place before it is taken: weights, position \[L\], and the area it stands for \[L²\].
struct Place {
    weights: [(u32, f64); 4],
    position: Vec3,
    area: f64,
}

/// Lays places over a shell: columns of points, then places of free edges. Returns them with the areas of the columns
/// \[L²\].
pub(super) fn over_sheet(cloud: &Cloud, wetting: &Wetting) -> (Places, Vec<f64>) {
    let mut places = match &cloud.lattice {
        Some(lattice) => by_lattice(cloud, lattice, wetting),
        None if cloud.cells.is_empty() => by_particles(cloud),
        None => by_cells(cloud, wetting),
    };
    let area = |best: fn(f64, f64) -> f64, from: f64| places.iter().map(|place| place.area).fold(from, best);
    let even = cloud.lattice.is_some() && area(f64::max, 0.0) < 2.0 * area(f64::min, f64::INFINITY);
    if !even {
        places = apart(places, CLOSE * wetting.spacing);
    }
    let mut middle = Places::default();
    for place in &places {
        middle.push(place.weights);
    }
    free_edges(cloud, wetting, &mut middle);
    (middle, places.into_iter().map(|place| place.area).collect())
}

/// Places in rows along both directions of a lattice, even along its mean lines.
fn by_lattice(cloud: &Cloud, lattice: &Lattice, wetting: &Wetting) -> Vec<Place> {
    let [n, m] = lattice.counts;
    let x = |i: usize, j: usize| cloud.positions[lattice.index(i, j)];
    let mean = |count: usize, gap: &dyn Fn(usize) -> f64| (0..count).map(gap).sum::<f64>() / count as f64;
    let along: Vec<f64> = (0..n - 1).map(|i| mean(m, &|j| (x(i + 1, j) - x(i, j)).norm())).collect();
    let across: Vec<f64> = (0..m - 1).map(|j| mean(n, &|i| (x(i, j + 1) - x(i, j)).norm())).collect();
    let [rows, columns] = [along, across].map(|lengths| {
        let whole: f64 = lengths.iter().sum();
        let count = wetting.count(whole);
        let at = |half: usize| locate(&lengths, whole * half as f64 / (2 * count) as f64);
        (0..=2 * count).map(at).collect::<Vec<_>>()
    });
    let bilinear = |(i, u): (usize, f64), (j, v): (usize, f64)| {
        let corner = |i: usize, j: usize, weight: f64| (lattice.index(i, j) as u32, weight);
        [
            corner(i, j, (1.0 - u) * (1.0 - v)),
            corner(i + 1, j, u * (1.0 - v)),
            corner(i + 1, j + 1, u * v),
            corner(i, j + 1, (1.0 - u) * v),
        ]
    };
    let mut places = Vec::new();
    for row in rows.windows(3).step_by(2) {
        for column in columns.windows(3).step_by(2) {
            let at = |k: usize, l: usize| position(cloud, &bilinear(row[k], column[l]));
            let area = 0.5 * (at(2, 2) - at(0, 0)).cross(&(at(0, 2) - at(2, 0))).norm();
            let weights = bilinear(row[1], column[1]);
            places.push(Place { weights, position: position(cloud, &weights), area });
        }
    }
    places
}

/// Places at the particles.
fn by_particles(cloud: &Cloud) -> Vec<Place> {
    let place = |(a, (&position, &area)): (usize, (&Vec3, &f64))| {
        let none = (a as u32, 0.0);
        Place { weights: [(a as u32, 1.0), none, none, none], position, area }
    };
    cloud.positions.iter().zip(&cloud.areas).enumerate().map(place).collect()
}

/// Places in the middle of the parts into which cells are divided.
fn by_cells(cloud: &Cloud, wetting: &Wetting) -> Vec<Place> {
    let mut places = Vec::new();
    for cell in &cloud.cells {
        let edges: Vec<f64> = cell
            .edges()
            .map(|(a, b)| (cloud.positions[b as usize] - cloud.positions[a as usize]).norm())
            .collect();
        let whole = cell.geometry(&cloud.positions).area;
        let start = places.len();
        let mut put = |weights: [f64; 4]| {
            let weights = std::array::from_fn(|k| (cell.corners[k], weights[k]));
            places.push(Place { weights, position: position(cloud, &weights), area: whole });
        };
        if cell.count == 4 {
            let [n, m] = [edges[0].max(edges[2]), edges[1].max(edges[3])].map(|length| wetting.count(length));
            for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
                let (u, v) = ((i as f64 + 0.5) / n as f64, (j as f64 + 0.5) / m as f64);
                put([(1.0 - u) * (1.0 - v), u * (1.0 - v), u * v, (1.0 - u) * v]);
            }
        } else {
            let n = wetting.count(edges.iter().fold(0.0, |most, &length| length.max(most)));
            let third = 1.0 / (3.0 * n as f64);
            for (i, j) in (0..n).flat_map(|i| (0..n - i).map(move |j| (i, j))) {
                let upright = [(3 * i + 1) as f64 * third, (3 * j + 1) as f64 * third];
                put([1.0 - upright[0] - upright[1], upright[0], upright[1], 0.0]);
                if i + j + 2 <= n {
                    let turned = upright.map(|part| part + third);
                    put([1.0 - turned[0] - turned[1], turned[0], turned[1], 0.0]);
                }
            }
        }
        let share = 1.0 / (places.len() - start) as f64;
        places[start..].iter_mut().for_each(|place| place.area *= share);
    }
    places
}

/// Leaves out places closer than `distance` to one before; the nearest of those takes over their area.
fn apart(places: Vec<Place>, distance: f64) -> Vec<Place> {
    let positions: Vec<Vec3> = places.iter().map(|place| place.position).collect();
    let list = CellList::new(&positions, distance);
    let mut near = Vec::new();
    let mut number: Vec<Option<usize>> = vec![None; places.len()];
    let mut taken: Vec<Place> = Vec::new();
    for (a, place) in places.into_iter().enumerate() {
        list.within(&place.position, distance, &mut near);
        let far = |b: usize| (taken[b].position - place.position).norm_squared();
        let nearest =
            near.iter().filter_map(|&b| number[b as usize]).min_by(|&b, &c| far(b).total_cmp(&far(c)));
        match nearest {
            Some(nearest) => taken[nearest].area += place.area,
            None => {
                number[a] = Some(taken.len());
                taken.push(place);
            }
        }
    }
    taken
}

/// Places along the edges that belong to one cell and join two particles of free edges.
fn free_edges(cloud: &Cloud, wetting: &Wetting, middle: &mut Places) {
    let mut free = vec![false; cloud.len()];
    wetting.free_edges.iter().for_each(|&particle| free[particle as usize] = true);
    let key = |(a, b): (u32, u32)| (a.min(b), a.max(b));
    let mut edges: Vec<(u32, u32)> = cloud.cells.iter().flat_map(Cell::edges).map(key).collect();
    edges.sort_unstable();
    for same in edges.chunk_by(|a, b| a == b).filter(|same| same.len() == 1) {
        let (a, b) = same[0];
        if free[a as usize] && free[b as usize] {
            let n = wetting.count((cloud.positions[b as usize] - cloud.positions[a as usize]).norm());
            for part in (0..n).map(|k| (k as f64 + 0.5) / n as f64) {
                middle.push([(a, 1.0 - part), (b, part)]);
            }
        }
    }
}

fn position(cloud: &Cloud, weights: &[(u32, f64); 4]) -> Vec3 {
    weights.iter().map(|&(particle, weight)| cloud.positions[particle as usize] * weight).sum()
}
