//! One brick: its functions, and the energy, forces and tangent of a point.

use nalgebra::{Matrix3, Matrix6, Matrix6x3, Vector3, Vector6};

/// Nodes of a brick.
pub const NODES: usize = 20;

/// Strains by components: 11, 22, 33, and twice 12, 23, 13.
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];

/// Elastic moduli, stress over strain by components \[F/L²\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moduli(pub Matrix6<f64>);

impl Moduli {
    /// The same in every direction: Young's modulus \[F/L²\] and Poisson's ratio.
    pub fn isotropic(young: f64, poisson: f64) -> Self {
        let shear = young / (2.0 * (1.0 + poisson));
        let lame = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
        Self(Matrix6::from_fn(|i, j| match (i, j) {
            (0..3, 0..3) => lame + if i == j { 2.0 * shear } else { 0.0 },
            _ if i == j => shear,
            _ => 0.0,
        }))
    }
}

/// Coordinates of the nodes in the brick: corners and middles of edges, the first axis fastest.
pub(super) fn places() -> [[i32; 3]; NODES] {
    let mut out = [[0; 3]; NODES];
    let all = (0..27).map(|at| [at % 3 - 1, at / 3 % 3 - 1, at / 9 - 1]);
    let nodes = all.filter(|place| place.iter().filter(|&&x| x == 0).count() < 2);
    out.iter_mut().zip(nodes).for_each(|(out, place)| *out = place);
    out
}

/// Value and slopes of the function of a node at a place of the brick.
pub(super) fn function(node: [i32; 3], at: [f64; 3]) -> (f64, [f64; 3]) {
    let own = node.map(f64::from);
    let edge = node.contains(&0);
    let factor: [f64; 3] = std::array::from_fn(|k| match node[k] {
        0 => 1.0 - at[k] * at[k],
        _ => 1.0 + own[k] * at[k],
    });
    let slope: [f64; 3] = std::array::from_fn(|k| if node[k] == 0 { -2.0 * at[k] } else { own[k] });
    let others = |k: usize| factor[(k + 1) % 3] * factor[(k + 2) % 3];
    let product = factor[0] * others(0);
    if edge {
        return (0.25 * product, std::array::from_fn(|k| 0.25 * slope[k] * others(k)));
    }
    let sum = (0..3).map(|k| own[k] * at[k]).sum::<f64>() - 2.0;
    let slopes = std::array::from_fn(|k| 0.125 * own[k] * (others(k) * sum + product));
    (0.125 * product * sum, slopes)
}

/// Places and weights of Gauss's rule with two or three points on (−1, 1).
pub(super) fn gauss(points: usize) -> Vec<(f64, f64)> {
    match points {
        2 => [-1.0, 1.0].map(|side| (side / 3.0_f64.sqrt(), 1.0)).to_vec(),
        _ => [(-1.0, 5.0), (0.0, 8.0), (1.0, 5.0)].map(|(side, w)| (side * 0.6_f64.sqrt(), w / 9.0)).to_vec(),
    }
}

/// A Gauss point at rest.
#[derive(Debug, Clone)]
pub(super) struct Point {
    /// Values of the functions.
    pub values: [f64; NODES],
    /// Their gradients \[1/L\].
    pub gradients: [Vector3<f64>; NODES],
    /// Its volume \[L³\].
    pub volume: f64,
}

impl Point {
    /// The points of a brick with so many along an edge; none where it is turned inside out.
    pub fn of(nodes: &[Vector3<f64>; NODES], rule: usize) -> Option<Vec<Self>> {
        let (line, own) = (gauss(rule), places());
        let mut out = Vec::with_capacity(rule.pow(3));
        for (x, y, z) in (0..rule.pow(3)).map(|at| (at % rule, at / rule % rule, at / rule / rule)) {
            let at = [line[x].0, line[y].0, line[z].0];
            let both = own.map(|node| function(node, at));
            let mut jacobian = Matrix3::zeros();
            for (node, (_, slopes)) in nodes.iter().zip(&both) {
                jacobian += node * Vector3::from(*slopes).transpose();
            }
            let inverse = jacobian.try_inverse().filter(|_| jacobian.determinant() > 0.0)?;
            let gradients = both.map(|(_, slopes)| inverse.transpose() * Vector3::from(slopes));
            let volume = line[x].1 * line[y].1 * line[z].1 * jacobian.determinant();
            out.push(Self { values: both.map(|both| both.0), gradients, volume });
        }
        Some(out)
    }

    /// Deformation gradient, Green's strain and St Venant's stress by components.
    pub fn state(
        &self,
        moved: &[Vector3<f64>; NODES],
        moduli: &Moduli,
    ) -> (Matrix3<f64>, Vector6<f64>, Vector6<f64>) {
        let mut gradient = Matrix3::identity();
        for (u, slope) in moved.iter().zip(&self.gradients) {
            gradient += u * slope.transpose();
        }
        let green = (gradient.transpose() * gradient - Matrix3::identity()) * 0.5;
        let strain = Vector6::from_fn(|k, _| {
            let (i, j) = PAIRS[k];
            if i == j { green[(i, i)] } else { 2.0 * green[(i, j)] }
        });
        (gradient, strain, moduli.0 * strain)
    }

    /// Derivative of the strain by the displacement of a node.
    pub fn rates(&self, gradient: &Matrix3<f64>, node: usize) -> Matrix6x3<f64> {
        let slope = &self.gradients[node];
        Matrix6x3::from_fn(|k, axis| {
            let (i, j) = PAIRS[k];
            let one = gradient[(axis, i)] * slope[j];
            if i == j { one } else { one + gradient[(axis, j)] * slope[i] }
        })
    }
}

/// Stress by components as a tensor.
pub(super) fn tensor(stress: &Vector6<f64>) -> Matrix3<f64> {
    let mut out = Matrix3::zeros();
    for (k, (i, j)) in PAIRS.into_iter().enumerate() {
        (out[(i, j)], out[(j, i)]) = (stress[k], stress[k]);
    }
    out
}
