//! Second derivatives of the control of cells, and of the scale of their curvature.

use shell_kinematics::{Pack, Pack3, Placement};

use super::{CHORD, CellPack, CellState, HOURGLASS};
use crate::control::yielding::YieldingControl;

/// What the tangent needs of the scaled curvature `k̂ = c k`, weights included.
pub(crate) struct ScaleTangent {
    /// Coupling of the scale with the five vectors; the patterns have none.
    pub mixed: [Pack3; 5],
    /// Second derivative over the scale itself.
    pub twice: Pack,
    /// First derivative over the scale, w M:k.
    pub released: Pack,
}

/// Vectors of a point: x,1 x,2 d d,1 d,2 and the patterns q_x q_d.
pub(crate) const VECTORS: usize = 7;

/// Second derivatives over the components of all vectors of a point.
pub(crate) type PointTangent = [[Pack; 3 * VECTORS]; 3 * VECTORS];

impl CellPack {
    /// Adds the second derivatives of the control's energy, and those of the curvature's scale, over
    /// x,1 x,2 d d,1 d,2 q_x q_d: the upper triangle by vectors.
    #[inline(always)]
    pub fn add_tangent(
        &self,
        p: &Placement,
        state: &CellState,
        scale: &ScaleTangent,
        yielding: Option<&YieldingControl>,
        out: &mut PointTangent,
    ) {
        let CellState { q, s, pulled, .. } = state;
        let [kx, _, _, kd, _, swirl] =
            yielding.map_or(self.stiffnesses(), |own| own.stiffnesses(self.stiffnesses()));
        let more = state.by_z * scale.released * 2.0;
        let held = kd + more;
        let [b11, b22, b12] = self.twist.map(|h| h * 0.5);
        let pulls = match yielding {
            None => std::array::from_fn(|i| pulled[i] * [kx, kx, kx, held, held, swirl][i]),
            Some(own) => {
                let [a, b, c, d, e, f] = own.pulls(self.stiffnesses(), pulled).0;
                [a, b, c, d + pulled[3] * more, e + pulled[4] * more, f]
            }
        };
        let force = |i: usize| pulls[i];
        // s1 … s6: products of a pattern and a vector, ½ H:k with k11 = x,1·d,1, k22 = x,2·d,2, k12 = x,1·d,2 + x,2·d,1, the swirl.
        let bend = [
            p.d1 * b11 + p.d2 * b12,
            p.d2 * b22 + p.d1 * b12,
            p.x1 * b11 + p.x2 * b12,
            p.x2 * b22 + p.x1 * b12,
        ];
        add_square(out, kx, &[(0, q[0]), (5, p.x1)]);
        add_square(out, kx, &[(1, q[0]), (5, p.x2)]);
        add_square(out, kx, &[(0, bend[0]), (1, bend[1]), (2, q[0]), (3, bend[2]), (4, bend[3]), (5, p.d)]);
        add_square(out, held, &[(0, q[1]), (6, p.x1)]);
        add_square(out, held, &[(1, q[1]), (6, p.x2)]);
        add_square(out, swirl, &[(0, p.d2), (1, Pack3::ZERO - p.d1), (3, Pack3::ZERO - p.x2), (4, p.x1)]);
        for (y, z, value) in [
            (0, 5, force(0)),
            (1, 5, force(1)),
            (2, 5, force(2)),
            (0, 3, force(2) * b11),
            (1, 4, force(2) * b22),
            (0, 4, force(2) * b12 + force(5)),
            (1, 3, force(2) * b12 - force(5)),
            (0, 6, force(3)),
            (1, 6, force(4)),
            (2, 2, scale.released * state.by_u() * -2.0),
        ] {
            (0..3).for_each(|k| out[3 * y + k][3 * z + k] += value);
        }
        // Gradients of u and z; c has second derivatives 2·CHORD[1] over u, u and HOURGLASS[1] over u, z.
        let of_u = p.d * Pack::splat(-2.0);
        let twice = [s[3] * 2.0, s[4] * 2.0];
        let of_z = [q[1] * twice[0], q[1] * twice[1], p.x1 * twice[0] + p.x2 * twice[1]];
        let of_c = [of_z[0] * state.by_z, of_z[1] * state.by_z, of_u * state.by_u(), of_z[2] * state.by_z];
        let half = scale.twice * 0.5;
        let with_c = [
            (0, scale.mixed[0] + of_c[0] * half),
            (1, scale.mixed[1] + of_c[1] * half),
            (2, scale.mixed[2] + of_c[2] * half),
            (3, scale.mixed[3]),
            (4, scale.mixed[4]),
            (6, of_c[3] * half),
        ];
        let of_c = [(0, of_c[0]), (1, of_c[1]), (2, of_c[2]), (6, of_c[3])];
        add_products(out, &of_c, &with_c);
        add_products(out, &with_c, &of_c);
        let (over_u, across) = (scale.released * CHORD[1], scale.released * HOURGLASS[1]);
        let with_u =
            [(0, of_z[0] * across), (1, of_z[1] * across), (2, of_u * over_u), (6, of_z[2] * across)];
        add_products(out, &[(2, of_u)], &with_u);
        add_products(out, &with_u, &[(2, of_u)]);
    }
}

/// Adds `k g gᵀ` for the parts of a gradient g by vectors.
#[inline(always)]
fn add_square<const N: usize>(out: &mut PointTangent, stiffness: Pack, gradient: &[(usize, Pack3); N]) {
    add_products(out, &gradient.map(|(y, part)| (y, part * stiffness)), gradient);
}

/// Adds the upper triangle of `a bᵀ`, both by vectors.
#[inline(always)]
fn add_products(out: &mut PointTangent, a: &[(usize, Pack3)], b: &[(usize, Pack3)]) {
    for &(y, left) in a {
        for &(z, right) in b.iter().filter(|part| part.0 >= y) {
            for k in 0..3 {
                for l in 0..3 {
                    out[3 * y + k][3 * z + l] += left.0[k] * right.0[l];
                }
            }
        }
    }
}
