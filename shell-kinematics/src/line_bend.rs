//! Bending of a line in the surface, at a particle between two neighbours: by how much the line turns about the director.
//!
//! With r⁻ and r⁺ the ways of the centroid line to and from the particle, d its director and l the length of the line that the particle stands for,
//!
//! ```text
//! s = d·(r⁻ × r⁺)/(|d| |r⁻| |r⁺|)      κ = (s − S)/l      U = ½ EI κ² l
//! ```
//!
//! s is the sine of the turn, S that at rest. A line without shear in the surface \[timoshenko1951\] has no unknown for it: the turn is the second difference of places,
//! exact where the curvature is steady. Rotations leave s as it is. With `T = d·(r⁻ × r⁺)` and `n_u = u/u·u` of each of the three vectors u,
//!
//! ```text
//! ∂s/∂u = s_u = T_u/(|d||r⁻||r⁺|) − s n_u
//! ∂²s/∂u∂v = T_uv/(|d||r⁻||r⁺|) − s_u n_vᵀ − n_u s_vᵀ − s n_u n_vᵀ − δ_uv s (1/u·u − 2 n_u n_uᵀ)
//! ```

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// The line at a particle.
#[derive(Clone, Copy, Debug)]
pub struct LinePlacement {
    /// Way of the centroid line from the neighbour before to the particle \[L\].
    pub before: Vector3<f64>,
    /// From the particle to the neighbour behind \[L\].
    pub after: Vector3<f64>,
    /// The director \[–\].
    pub d: Vector3<f64>,
}

/// A line that bends at a particle.
#[derive(Clone, Copy, Debug)]
pub struct LineBend {
    /// EI/l \[F L\].
    stiffness: f64,
    /// S.
    rest: f64,
}

impl LinePlacement {
    fn vectors(&self) -> [Vector3<f64>; 3] {
        [self.before, self.after, self.d]
    }

    /// s, the sine of the turn of the line about the director \[–\].
    pub fn turn(&self) -> f64 {
        let Self { before, after, d } = self;
        d.dot(&before.cross(after)) / (d.norm() * before.norm() * after.norm())
    }

    /// `n_u`, and `s_u`, for the way before, the way behind and the director.
    fn gradients(&self) -> ([Vector3<f64>; 3], [Vector3<f64>; 3]) {
        let Self { before, after, d } = self;
        let size = d.norm() * before.norm() * after.norm();
        let over = self.vectors().map(|u| u / u.norm_squared());
        let (turn, of_product) = (self.turn(), [after.cross(d), d.cross(before), before.cross(after)]);
        (over, std::array::from_fn(|k| of_product[k] / size - over[k] * turn))
    }
}

impl LineBend {
    /// A line with the bending stiffness EI \[F L²\] that is straight enough at rest, of a length that the particle stands for \[L\].
    pub fn new(bending: f64, length: f64, rest: &LinePlacement) -> Self {
        Self { stiffness: bending / length, rest: rest.turn() }
    }

    /// The sine of its turn less that at rest.
    pub fn strain(&self, placement: &LinePlacement) -> f64 {
        placement.turn() - self.rest
    }

    /// Bending moment about the director \[F L\].
    pub fn moment(&self, placement: &LinePlacement) -> f64 {
        self.stiffness * self.strain(placement)
    }

    /// Energy \[F L\].
    pub fn energy(&self, placement: &LinePlacement) -> f64 {
        0.5 * self.moment(placement) * self.strain(placement)
    }

    /// Its derivative over the way before, the way behind and the director.
    pub fn forces(&self, placement: &LinePlacement) -> SVector<f64, 9> {
        let (moment, (_, slopes)) = (self.moment(placement), placement.gradients());
        SVector::from_iterator(slopes.iter().flat_map(|slope| slope.iter().map(move |x| moment * x)))
    }

    /// Its second derivative, with the moment of another placement if one is given.
    pub fn tangent(&self, placement: &LinePlacement, stressed: Option<&LinePlacement>) -> SMatrix<f64, 9, 9> {
        let LinePlacement { before, after, d } = placement;
        let (over, slopes) = placement.gradients();
        let (turn, moment) = (placement.turn(), self.moment(stressed.unwrap_or(placement)));
        let size = d.norm() * before.norm() * after.norm();
        let (zero, vectors) = (Matrix3::zeros(), placement.vectors());
        // T_uv, zero on the diagonal.
        let product = [
            [zero, -d.cross_matrix(), after.cross_matrix()],
            [d.cross_matrix(), zero, -before.cross_matrix()],
            [-after.cross_matrix(), before.cross_matrix(), zero],
        ];
        let mut out: SMatrix<f64, 9, 9> = SMatrix::zeros();
        for u in 0..3 {
            for v in 0..3 {
                let mut second = product[u][v] / size
                    - slopes[u] * over[v].transpose()
                    - over[u] * slopes[v].transpose()
                    - over[u] * over[v].transpose() * turn;
                if u == v {
                    let square = vectors[u].norm_squared();
                    second -= (Matrix3::identity() / square - over[u] * over[u].transpose() * 2.0) * turn;
                }
                let block = slopes[u] * slopes[v].transpose() * self.stiffness + second * moment;
                out.fixed_view_mut::<3, 3>(3 * u, 3 * v).copy_from(&block);
            }
        }
        out
    }
}
