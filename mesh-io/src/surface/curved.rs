//! How far the surface through the nodes lies off the chord in the middle of an edge: what a refined surface follows.
//!
//! With curvature vectors κ a, κ b at its ends an edge of length L bulges by `−L²/8 κ`, of κ a and κ b the shorter, and by nothing where they
//! disagree: what is flat beside a curve stays flat. Inside a sheet κ is the second derivative along the edge of the quadric that fits the nodes about
//! an end best, times the normal; on a line where the sheet ends it is that of the line, so that lines in a plane stay in it. Corners have none.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use nalgebra::{DMatrix, DVector, Matrix2};
use sph_core::{Frame, Vec3};

use super::junctions::{FACET, FOLD, SHARP};
use super::{Surface, mean_normals};

/// Bulge over the length of an edge below which the surface is flat there \[–\]: rounding of coordinates.
const FLAT: f64 = 1e-9;
/// Rings of nodes about a node that are looked at.
const RINGS: usize = 3;
/// Coefficients of a quadric.
const COEFFICIENTS: usize = 5;
/// Least singular value of a fit over the greatest.
const DETERMINED: f64 = 0.02;

/// Bulges of the edges of a surface \[L\], by their nodes, the lesser first; none of those that are straight. Nodes of a junction count as `first` says.
pub(super) fn bulges(surface: &Surface, first: &[u32]) -> HashMap<[u32; 2], Vec3> {
    let rings: Vec<&[u32]> = surface.faces.iter().map(|face| face.particles()).collect();
    let mut uses: BTreeMap<[u32; 2], usize> = BTreeMap::new();
    rings.iter().flat_map(|ring| edges(ring)).for_each(|edge| *uses.entry(edge).or_default() += 1);
    let joined = |edge: &[u32; 2]| {
        let [a, b] = edge.map(|node| first[node as usize]);
        [a.min(b), a.max(b)]
    };
    let at = |node: u32| surface.positions[node as usize];
    let ends: BTreeSet<[u32; 2]> =
        uses.iter().filter(|(_, count)| **count == 1).map(|(edge, _)| joined(edge)).collect();
    let lines = Lines::new(&ends, &at);
    let sheets = Sheets::new(surface, &rings);
    let mut bulges = HashMap::new();
    for (edge, &count) in &uses {
        let [a, b] = *edge;
        let chord = at(b) - at(a);
        let (length, along) = (chord.norm(), chord.normalize());
        let curvatures = match count {
            1 => joined(edge).map(|node| lines.curvatures.get(&node).copied()),
            _ => edge.map(|node| sheets.curvature(node, &along)),
        };
        let [Some(one), Some(other)] = curvatures.map(|own| own.or(curvatures[0]).or(curvatures[1])) else {
            continue;
        };
        if one.dot(&other) <= 0.0 {
            continue;
        }
        let least = if one.norm_squared() < other.norm_squared() { one } else { other };
        let bulge = (least - along * along.dot(&least)) * (-0.125 * length * length);
        if bulge.norm() > FLAT * length {
            bulges.insert(joined(edge), bulge);
        }
    }
    bulges
}

/// The edges round a face, each with its lesser node first.
pub(super) fn edges(ring: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    (0..ring.len()).map(|k| {
        let (a, b) = (ring[k], ring[(k + 1) % ring.len()]);
        [a.min(b), a.max(b)]
    })
}

/// Lines on which sheets end.
struct Lines {
    /// Curvature vectors \[1/L\] at nodes where a line neither ends, branches nor has a corner.
    curvatures: HashMap<u32, Vec3>,
}

impl Lines {
    fn new(ends: &BTreeSet<[u32; 2]>, at: &impl Fn(u32) -> Vec3) -> Self {
        let mut beside: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for &[a, b] in ends {
            beside.entry(a).or_default().push(b);
            beside.entry(b).or_default().push(a);
        }
        let turn = |node: u32| -> Option<f64> {
            let &[before, behind] = &beside[&node][..] else { return None };
            Some((at(node) - at(before)).angle(&(at(behind) - at(node))))
        };
        let mut curvatures = HashMap::new();
        for (&node, others) in &beside {
            let (Some(own), &[before, behind]) = (turn(node), &others[..]) else { continue };
            let least = others.iter().filter_map(|&other| turn(other)).reduce(f64::min);
            if own > SHARP || own > FOLD && least.is_none_or(|least| least < FACET * own) {
                continue;
            }
            let [to, from] = [at(before) - at(node), at(behind) - at(node)];
            let second = to.normalize() + from.normalize();
            curvatures.insert(node, second * (2.0 / (to.norm() + from.norm())));
        }
        Self { curvatures }
    }
}

/// Second derivatives of a sheet at its nodes.
struct Sheets {
    /// Of each node a frame and the second derivatives along its tangents \[1/L\]; none where the nodes about it do not tell.
    quadrics: Vec<Option<(Frame, Matrix2<f64>)>>,
}

impl Sheets {
    fn new(surface: &Surface, rings: &[&[u32]]) -> Self {
        let count = surface.positions.len();
        let normals = mean_normals(&surface.positions, &surface.faces);
        let mut beside = vec![Vec::new(); count];
        for ring in rings {
            for &node in *ring {
                beside[node as usize].extend(ring.iter().filter(|&&other| other != node));
            }
        }
        for (node, others) in beside.iter_mut().enumerate() {
            let near =
                |other: &u32| (surface.positions[*other as usize] - surface.positions[node]).norm_squared();
            others.sort_by(|a, b| near(a).total_cmp(&near(b)).then(a.cmp(b)));
            others.dedup();
        }
        let quadric = |node: usize| {
            let mut about: Vec<u32> = beside[node].clone();
            for _ in 0..RINGS {
                if let Some(found) = quadric(surface, node, &normals[node], &about) {
                    return Some(found);
                }
                let next: BTreeSet<u32> =
                    about.iter().flat_map(|&other| beside[other as usize].iter().copied()).collect();
                about.extend(next.into_iter().filter(|other| *other as usize != node));
                let mut seen = BTreeSet::new();
                about.retain(|&other| seen.insert(other));
            }
            None
        };
        Self { quadrics: (0..count).map(quadric).collect() }
    }

    /// Curvature vector of the sheet at a node along a direction \[1/L\].
    fn curvature(&self, node: u32, along: &Vec3) -> Option<Vec3> {
        let (Frame { t1, t2, n }, second) = self.quadrics[node as usize].as_ref()?;
        let way = nalgebra::Vector2::new(t1.dot(along), t2.dot(along));
        let length = way.norm_squared();
        (length > 0.0).then(|| n * (way.dot(&(second * way)) / length))
    }
}

/// The quadric through a node that fits others best; none where they do not determine it.
fn quadric(surface: &Surface, node: usize, normal: &Vec3, about: &[u32]) -> Option<(Frame, Matrix2<f64>)> {
    if about.len() < COEFFICIENTS || normal.norm_squared() == 0.0 {
        return None;
    }
    let place = surface.positions[node];
    let frame = Frame::from_normal(*normal);
    let away: Vec<Vec3> = about.iter().map(|&other| surface.positions[other as usize] - place).collect();
    let reach = away.iter().map(Vec3::norm).fold(0.0, f64::max);
    let local = |r: &Vec3| [&frame.t1, &frame.t2, &frame.n].map(|e| e.dot(r) / reach);
    let matrix = DMatrix::from_fn(about.len(), COEFFICIENTS, |i, k| {
        let [x, y, _] = local(&away[i]);
        [0.5 * x * x, x * y, 0.5 * y * y, x, y][k]
    });
    let height = DVector::from_fn(about.len(), |i, _| local(&away[i])[2]);
    let svd = matrix.svd(true, true);
    let (most, least) = (svd.singular_values.max(), svd.singular_values.min());
    if least < DETERMINED * most {
        return None;
    }
    let c = svd.solve(&height, 0.0).ok()?;
    Some((frame, Matrix2::new(c[0], c[1], c[1], c[2]) / reach))
}
