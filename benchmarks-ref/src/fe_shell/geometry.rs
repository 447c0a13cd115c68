//! One quadrilateral in its reference configuration: quadrature points, local axes, assumed strains.

use super::membrane::{self, Place, Spread, Ties};
use super::section::Section;
use nalgebra::{Matrix2, Vector2, Vector3};

/// Edges (from, to), along r at s = −1 and +1, then along s at r = −1 and +1; nodes run counter-clockwise from (−1, −1).
pub const EDGES: [(usize, usize); 4] = [(0, 1), (3, 2), (0, 3), (1, 2)];

/// Abscissa of the two-point Gauss rule, 1/√3.
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// A quadrature point.
#[derive(Debug, Clone)]
pub struct Point {
    /// Reference area \[L²\].
    pub area: f64,
    /// Local derivatives from the differences along the four edges: ∂f/∂(axis a) = Σ_e `slopes[a][e]` Δf_e \[1/L\].
    pub slopes: [[f64; 4]; 2],
    /// Assumed membrane strain per tied strain.
    pub spread: Spread,
    /// Reference curvature B₁₁ B₂₂ 2B₁₂ \[1/L\].
    pub curvature: Vector3<f64>,
    /// Shape functions.
    pub shape: [f64; 4],
}

/// Positions and directors of the four nodes.
#[derive(Debug, Clone, Copy)]
pub struct Corners {
    /// Positions \[L\].
    pub positions: [Vector3<f64>; 4],
    /// Unit directors.
    pub directors: [Vector3<f64>; 4],
}

/// What does not change with the motion.
#[derive(Debug, Clone)]
pub struct Geometry {
    /// The 2 × 2 quadrature points.
    pub points: [Point; 4],
    /// Tied membrane measures ¼|Δx|²/2 and x,_r·x,_s/2 of the reference configuration \[L²\].
    pub ties: Ties,
    /// Tied shears Δx·d̄ of the reference configuration \[L\].
    pub shears: [f64; 4],
}

/// Differences along the edges.
pub fn differences(values: &[Vector3<f64>; 4]) -> [Vector3<f64>; 4] {
    EDGES.map(|(from, to)| values[to] - values[from])
}

/// Means over the edges.
pub fn means(values: &[Vector3<f64>; 4]) -> [Vector3<f64>; 4] {
    EDGES.map(|(from, to)| (values[to] + values[from]) * 0.5)
}

/// The arc that belongs to the chord between two unit directors, Δ(1 + |Δ|²/24) = Δ · (angle/(2 sin(angle/2))) + O(Δ⁵).
///
/// With chords, the angle between the ends of a strip bent by a couple is (2α)²/6 too large, α the half angle of an
/// element: 0.26 % for a ring of fifty.
pub fn arc(chord: &Vector3<f64>) -> Vector3<f64> {
    chord * (1.0 + chord.norm_squared() / 24.0)
}

/// Tied membrane measures of a configuration from its edge vectors: half the squared covariant lengths, half the
/// product of the mid-lines.
pub fn tied_measures(edges: &[Vector3<f64>; 4]) -> Ties {
    let (r, s) = mid_lines(edges);
    let length = |edge: usize| 0.125 * edges[edge].norm_squared();
    Ties::from([length(0), length(1), length(2), length(3), 0.5 * r.dot(&s)])
}

/// x,_r and x,_s at the centre.
pub fn mid_lines(edges: &[Vector3<f64>; 4]) -> (Vector3<f64>, Vector3<f64>) {
    ((edges[0] + edges[1]) * 0.25, (edges[2] + edges[3]) * 0.25)
}

impl Geometry {
    /// The geometry of an element; local axes start from the projection of `axis` onto the surface.
    ///
    /// `None` where the surface has no area or `axis` stands upright on it.
    pub fn new(corners: &Corners, axis: &Vector3<f64>, section: &Section) -> Option<Self> {
        let edges = differences(&corners.positions);
        let centre = place([0.0, 0.0], &edges, axis)?;
        let mut places = [centre; 4];
        for (place, at) in
            places.iter_mut().zip([[-GAUSS, -GAUSS], [GAUSS, -GAUSS], [GAUSS, GAUSS], [-GAUSS, GAUSS]])
        {
            *place = self::place(at, &edges, axis)?;
        }
        let spreads =
            membrane::spreads(&places, &centre, distortion(&corners.positions, &edges)?, &section.membrane());
        let arcs = differences(&corners.directors).map(|chord| arc(&chord));
        let points = std::array::from_fn(|index| {
            let place = &places[index];
            let slopes = slopes(place);
            let tangents = derivatives(&slopes, &edges);
            let turns = derivatives(&slopes, &arcs);
            let k = |a: usize, b: usize| tangents[a].dot(&turns[b]);
            let [r, s] = place.at;
            let shape = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
                .map(|(r_node, s_node)| 0.25 * (1.0 + r * r_node) * (1.0 + s * s_node));
            let curvature = Vector3::new(k(0, 0), k(1, 1), k(0, 1) + k(1, 0));
            Point { area: place.area, slopes, spread: spreads[index], curvature, shape }
        });
        let middles = means(&corners.directors);
        let shears = std::array::from_fn(|edge| edges[edge].dot(&middles[edge]));
        Some(Self { points, ties: tied_measures(&edges), shears })
    }
}

/// Derivatives along the local axes from values at the edges.
pub fn derivatives(slopes: &[[f64; 4]; 2], edges: &[Vector3<f64>; 4]) -> [Vector3<f64>; 2] {
    slopes.map(|row| edges[0] * row[0] + edges[1] * row[1] + edges[2] * row[2] + edges[3] * row[3])
}

/// The place at (r, s): local axes, Jacobian, area (of a point with weight one).
fn place([r, s]: [f64; 2], edges: &[Vector3<f64>; 4], axis: &Vector3<f64>) -> Option<Place> {
    let along_r = (edges[0] * (1.0 - s) + edges[1] * (1.0 + s)) * 0.25;
    let along_s = (edges[2] * (1.0 - r) + edges[3] * (1.0 + r)) * 0.25;
    let product = along_r.cross(&along_s);
    let area = product.norm();
    let normal = product.try_normalize(f64::MIN_POSITIVE)?;
    let first = (axis - normal * normal.dot(axis)).try_normalize(1e-6 * axis.norm())?;
    let second = normal.cross(&first);
    let jacobian =
        Matrix2::new(along_r.dot(&first), along_s.dot(&first), along_r.dot(&second), along_s.dot(&second));
    Some(Place { at: [r, s], jacobian, area })
}

/// f,_a = (J⁻ᵀ)_aα f,_α with f,_r = Σ (1 ∓ s)/4 Δf over the edges along r, likewise along s.
fn slopes(place: &Place) -> [[f64; 4]; 2] {
    let inverse = place.jacobian.try_inverse().unwrap_or_default();
    let [r, s] = place.at;
    [0, 1].map(|a| {
        let (along_r, along_s) = (0.25 * inverse[(0, a)], 0.25 * inverse[(1, a)]);
        [along_r * (1.0 - s), along_r * (1.0 + s), along_s * (1.0 - r), along_s * (1.0 + r)]
    })
}

/// (c_r, c_s) of x_d in the plane of the centre, by least squares.
fn distortion(positions: &[Vector3<f64>; 4], edges: &[Vector3<f64>; 4]) -> Option<[f64; 2]> {
    let (r, s) = mid_lines(edges);
    let skew = (positions[0] - positions[1] + positions[2] - positions[3]) * 0.25;
    let gram = Matrix2::new(r.dot(&r), r.dot(&s), r.dot(&s), s.dot(&s));
    let components = gram.try_inverse()? * Vector2::new(skew.dot(&r), skew.dot(&s));
    Some([components.x, components.y])
}
