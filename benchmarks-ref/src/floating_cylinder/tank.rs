//! The cylinder in a tank: linear potential flow by boundary elements, in time.
//!
//! Half of the tank with its image, lengths over the radius, times over √(a/g). On straight pieces of its edge the potential φ and its slope q along the outward normal
//! are constant, and at the middle of each
//!
//! ```text
//! Σ φ ∫ ∂ ln r/∂n ds = Σ q ∫ ln r ds      q = 0 on walls and floor,  n_y V on the body      η' = q,  φ' = −η on the surface
//! ```
//!
//! φ' is harmonic as well, with −η on the surface and the acceleration on the body: a part for each, so that the added mass stands with what the cylinder displaces. In time by
//! the rule of Runge and Kutta of the fourth order.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{DMatrix, DVector};

/// By how much pieces of the surface grow with the distance from the body, those of walls and floor are over their distance from it.
const GROWTH: f64 = 0.03;
const FAR: f64 = 0.08;

/// A tank with the cylinder in its middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tank {
    /// Half of its length, over the radius.
    pub half: f64,
    /// Depth of the water, over the radius.
    pub depth: f64,
}

/// A straight piece of the edge, the water on its left.
#[derive(Clone, Copy)]
struct Piece {
    from: [f64; 2],
    along: [f64; 2],
    length: f64,
}

impl Piece {
    fn middle(&self) -> [f64; 2] {
        [0, 1].map(|k| self.from[k] + 0.5 * self.length * self.along[k])
    }

    /// Integrals over it of ln r and of its slope along the outward normal, r from a place.
    fn seen(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let ([dx, dy], [tx, ty]) = ([x - self.from[0], y - self.from[1]], self.along);
        let (first, off) = (dx * tx + dy * ty, dx * ty - dy * tx);
        let last = first - self.length;
        let angle = libm::atan2(off * self.length, off * off + first * last);
        let whole = |s: f64| s * libm::log(libm::hypot(s, off));
        [whole(first) - whole(last) - self.length + off * angle, -angle]
    }
}

/// From 0 to a length in pieces that begin with a size and grow so much with the way.
fn graded(length: f64, first: f64, growth: f64) -> Vec<f64> {
    let count = libm::ceil(libm::log1p(growth * length / first) / growth).max(1.0);
    let rate = libm::log1p(growth * length / first) / count;
    (0..=count as usize).map(|i| first * libm::expm1(rate * i as f64) / growth).collect()
}

/// What the edge does: rates of the surface, forces on the body.
struct Edge {
    surface: usize,
    /// q on the surface by φ on it, and by the velocity of the body.
    rises: DMatrix<f64>,
    pushed: DVector<f64>,
    /// Force up on the body by φ' on the surface, and its added mass.
    lifts: DVector<f64>,
    added: f64,
}

impl Edge {
    fn new(tank: &Tank, size: f64) -> Option<Self> {
        let of_body = libm::ceil(FRAC_PI_2 / size) as usize;
        let angle = |i: usize| FRAC_PI_2 * i as f64 / of_body as f64;
        // Round the water against the clock: surface to the body, body, (axis,) floor, wall.
        let mut corners: Vec<[f64; 2]> =
            graded(tank.half - 1.0, size, GROWTH).iter().rev().map(|x| [1.0 + x, 0.0]).collect();
        let surface = corners.len() - 1;
        corners.extend((1..=of_body).map(|i| [libm::cos(angle(i)), -libm::sin(angle(i))]));
        let body = corners.len() - 1;
        let floor: Vec<[f64; 2]> =
            graded(tank.half, FAR * tank.depth, FAR).iter().map(|x| [*x, -tank.depth]).collect();
        let rows = libm::ceil(tank.depth / (FAR * tank.half)).max(12.0) as usize;
        let wall = (1..=rows).map(|i| [tank.half, -tank.depth * (1.0 - i as f64 / rows as f64)]);
        let mut pieces = Vec::new();
        let mut join = |line: &[[f64; 2]]| {
            for pair in line.windows(2) {
                let way = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
                let length = libm::hypot(way[0], way[1]);
                pieces.push(Piece { from: pair[0], along: way.map(|part| part / length), length });
            }
        };
        join(&corners);
        join(&floor.into_iter().chain(wall).collect::<Vec<_>>());
        let count = pieces.len();
        let (mut single, mut double) = (DMatrix::zeros(count, count), DMatrix::zeros(count, count));
        for (i, own) in pieces.iter().enumerate() {
            let [x, y] = own.middle();
            let mut sum = 0.0;
            for (j, piece) in pieces.iter().enumerate() {
                let [direct, image] = [[x, y], [-x, y]].map(|place| piece.seen(place));
                single[(i, j)] = direct[0] + image[0];
                double[(i, j)] = if i == j { image[1] } else { direct[1] + image[1] };
                sum += double[(i, j)];
            }
            // An even potential has no slope.
            double[(i, i)] -= sum;
        }
        let on_body = surface..body;
        let upward: Vec<f64> = on_body.clone().map(|j| -pieces[j].along[0]).collect();
        let mut matrix = double.clone();
        let mut given = DMatrix::zeros(count, surface + 1);
        for i in 0..count {
            for j in 0..surface {
                matrix[(i, j)] = -single[(i, j)];
                given[(i, j)] = -double[(i, j)];
            }
            given[(i, surface)] = on_body.clone().zip(&upward).map(|(j, up)| single[(i, j)] * up).sum();
        }
        let all = matrix.lu().solve(&given)?;
        let on = |column: usize| -> f64 {
            let each = on_body.clone().zip(&upward);
            each.map(|(j, up)| 2.0 * up * pieces[j].length * all[(j, column)]).sum()
        };
        Some(Self {
            surface,
            rises: all.view((0, 0), (surface, surface)).into_owned(),
            pushed: all.view((0, surface), (surface, 1)).column(0).into_owned(),
            lifts: DVector::from_iterator(surface, (0..surface).map(|j| -on(j))),
            added: on(surface),
        })
    }

    /// Rates of heights, potentials on the surface, place and velocity of the body.
    fn rates(&self, state: &DVector<f64>) -> DVector<f64> {
        let count = self.surface;
        let (heights, potentials) = (state.rows(0, count), state.rows(count, count));
        let [place, velocity] = [state[2 * count], state[2 * count + 1]];
        let lift = -self.lifts.dot(&heights) - 2.0 * place;
        let mut rates = DVector::zeros(2 * count + 2);
        rates.rows_mut(0, count).copy_from(&(&self.rises * potentials + &self.pushed * velocity));
        rates.rows_mut(count, count).copy_from(&(-heights));
        rates[2 * count] = velocity;
        rates[2 * count + 1] = lift / (FRAC_PI_2 + self.added);
        rates
    }
}

impl Tank {
    /// Times and heights of the cylinder over the one at the start, from which it is let go over flat water at rest; least size of the pieces over the radius, steps of a length and
    /// their number. None where the equations have no solution.
    pub fn released(&self, size: f64, step: f64, steps: usize) -> Option<Vec<[f64; 2]>> {
        let edge = Edge::new(self, size)?;
        let mut state = DVector::zeros(2 * edge.surface + 2);
        state[2 * edge.surface] = 1.0;
        let mut rows = vec![[0.0, 1.0]];
        for number in 1..=steps {
            let first = edge.rates(&state);
            let second = edge.rates(&(&state + &first * (0.5 * step)));
            let third = edge.rates(&(&state + &second * (0.5 * step)));
            let fourth = edge.rates(&(&state + &third * step));
            state += (first + (second + third) * 2.0 + fourth) * (step / 6.0);
            rows.push([number as f64 * step, state[2 * edge.surface]]);
        }
        Some(rows)
    }

    /// Added mass over what the cylinder displaces where it moves so fast that no wave goes out.
    pub fn added_mass(&self, size: f64) -> Option<f64> {
        Edge::new(self, size).map(|edge| edge.added / FRAC_PI_2)
    }
}
