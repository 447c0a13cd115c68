//! One particle that hangs on cells: its place and director, their transpose, and its derivative.

use sph_core::Vec3;

use crate::conditions::body::Block;
use crate::packs::Row;

/// `Σφx + Σηd, x,₁, x,₂, m, d,₁, d,₂`: what a hanging particle sees of its host.
pub(crate) type Vectors = [Vec3; 6];

/// What one corner gives a particle that hangs on it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Share {
    /// φ, G₁, G₂ of its place \[–, 1/L, 1/L\].
    pub x: [f64; 3],
    /// The same of its director: with weights of their own where several cells bear the particle.
    pub d: [f64; 3],
    /// η, the height of the particle along its director times φ \[L\].
    pub height: f64,
}

/// A particle and the cells it hangs on.
#[derive(Clone, Debug, Default)]
pub(crate) struct Hanging {
    /// The particle.
    pub particle: u32,
    /// The cells, and how much each counts \[–\].
    pub cells: Vec<(u32, f64)>,
    /// Corners of the cells, each once.
    pub corners: Vec<u32>,
    /// What each corner gives.
    pub shares: Vec<Share>,
    /// `½ S₁₁, ½ S₂₂, ½ S₁₂` \[L²\].
    pub half_moments: [f64; 3],
    /// `½ S:K` at rest \[L\].
    pub chord: f64,
    /// Direction of the edge in the frame of the cells; as long as the edges on both sides of the particle \[L\].
    pub line: [f64; 2],
    /// The director in the axes of the cells.
    pub director: Vec3,
}

/// Axes of a cell at a particle, and what their derivative needs.
struct Axes {
    e: [Vec3; 3],
    /// 1/|m|, 1/|z|, `w·e₃`; z is the part of w across e₃.
    of_m: f64,
    of_z: f64,
    along: f64,
}

/// Rates of the axes along a change of the vectors.
struct AxesRate {
    e: [Vec3; 3],
    turn: Vec3,
    of_z: f64,
    along: f64,
}

impl Axes {
    fn of([_, a, b, m, ..]: &Vectors, [along_a, along_b]: [f64; 2]) -> Self {
        let of_m = 1.0 / m.norm();
        let e3 = m * of_m;
        let w = a * along_a + b * along_b;
        let along = w.dot(&e3);
        let z = w - e3 * along;
        let of_z = 1.0 / z.norm();
        let e1 = z * of_z;
        Self { e: [e1, e3.cross(&e1), e3], of_m, of_z, along }
    }

    fn rate(
        &self,
        [_, a, b, ..]: &Vectors,
        [_, da, db, dm, ..]: &Vectors,
        [along_a, along_b]: [f64; 2],
    ) -> AxesRate {
        let [e1, e2, e3] = self.e;
        let de3 = (dm - e3 * e3.dot(dm)) * self.of_m;
        let (w, dw) = (a * along_a + b * along_b, da * along_a + db * along_b);
        let along = dw.dot(&e3) + w.dot(&de3);
        let dz = dw - e3 * along - de3 * self.along;
        let turn = e3.cross(&de3) + e3 * (e2.dot(&dz) * self.of_z);
        AxesRate {
            e: [turn.cross(&e1), turn.cross(&e2), de3],
            turn,
            of_z: -self.of_z * self.of_z * e1.dot(&dz),
            along,
        }
    }

    /// A direction given in the axes.
    fn carry(&self, c: &Vec3) -> Vec3 {
        self.e[0] * c.x + self.e[1] * c.y + self.e[2] * c.z
    }
}

impl Hanging {
    /// Its components in the axes of the cell in a state.
    pub fn components(&self, state: &[Row], director: &Vec3) -> Vec3 {
        let axes = Axes::of(&self.vectors(state), self.line);
        Vec3::from(axes.e.map(|e| e.dot(director)))
    }

    pub fn vectors(&self, rows: &[Row]) -> Vectors {
        let mut v = [Vec3::zeros(); 6];
        for (&b, shares) in self.corners.iter().zip(&self.shares) {
            let row = &rows[b as usize];
            let (x, d) = (Vec3::new(row[0], row[1], row[2]), Vec3::new(row[3], row[4], row[5]));
            v[0] += d * shares.height;
            for i in 0..3 {
                v[i] += x * shares.x[i];
                v[3 + i] += d * shares.d[i];
            }
        }
        v
    }

    /// The place on the cells under the particle.
    pub fn foot(&self, rows: &[Row]) -> Vec3 {
        let place = |b: u32| Vec3::from_row_slice(&rows[b as usize][..3]);
        self.corners.iter().zip(&self.shares).map(|(&b, share)| place(b) * share.x[0]).sum()
    }

    /// What bending since rest raises the particle by, in units of m \[L\].
    pub fn rise(&self, [_, a, b, _, e, f]: &Vectors) -> f64 {
        let [s11, s22, s12] = self.half_moments;
        s11 * a.dot(e) + s22 * b.dot(f) + s12 * (a.dot(f) + b.dot(e)) - self.chord
    }

    /// Place and director that the host gives it.
    pub fn row(&self, v: &Vectors) -> Row {
        let x = v[0] + v[3] * self.rise(v);
        let d = Axes::of(v, self.line).carry(&self.director);
        [x.x, x.y, x.z, d.x, d.y, d.z]
    }

    /// The transpose of its variation: forces on the vectors from `[f, n]` on it.
    pub fn transpose(&self, v: &Vectors, row: &Row) -> Vectors {
        let (force, couple) = halves(row);
        let [_, a, b, m, e, f] = v;
        let ([s11, s22, s12], [along_a, along_b]) = (self.half_moments, self.line);
        let q = force.dot(m);
        let axes = Axes::of(v, self.line);
        let [_, e2, e3] = axes.e;
        // The work of n is that of the torque d × n on the turn e₃ × δe₃ + e₃ (e₂·δz)/|z|.
        let torque = axes.carry(&self.director).cross(&couple);
        let spin = torque.dot(&e3) * axes.of_z;
        let on_w = e2 * spin;
        let on_e3 = torque.cross(&e3) - on_w * axes.along;
        let on_m = (on_e3 - e3 * e3.dot(&on_e3)) * axes.of_m;
        [
            force,
            (e * s11 + f * s12) * q + on_w * along_a,
            (f * s22 + e * s12) * q + on_w * along_b,
            force * self.rise(v) + on_m,
            (a * s11 + b * s12) * q,
            (b * s22 + a * s12) * q,
        ]
    }

    /// The derivative of [`Hanging::transpose`] along a change of the vectors but the first, at the same `[f, n]`.
    fn transpose_rate(&self, v: &Vectors, dv: &Vectors, row: &Row) -> Vectors {
        let (force, couple) = halves(row);
        let [_, a, b, m, e, f] = v;
        let [_, da, db, dm, de, df] = dv;
        let ([s11, s22, s12], [along_a, along_b]) = (self.half_moments, self.line);
        let (q, dq) = (force.dot(m), force.dot(dm));
        let rise = s11 * (da.dot(e) + a.dot(de))
            + s22 * (db.dot(f) + b.dot(df))
            + s12 * (da.dot(f) + a.dot(df) + db.dot(e) + b.dot(de));
        let axes = Axes::of(v, self.line);
        let rate = axes.rate(v, dv, self.line);
        let ([_, e2, e3], [_, de2, de3]) = (axes.e, rate.e);
        let d = axes.carry(&self.director);
        let (torque, dtorque) = (d.cross(&couple), rate.turn.cross(&d).cross(&couple));
        let spin = torque.dot(&e3) * axes.of_z;
        let dspin = (dtorque.dot(&e3) + torque.dot(&de3)) * axes.of_z + torque.dot(&e3) * rate.of_z;
        let (on_w, d_on_w) = (e2 * spin, e2 * dspin + de2 * spin);
        let on_e3 = torque.cross(&e3) - on_w * axes.along;
        let d_on_e3 = dtorque.cross(&e3) + torque.cross(&de3) - d_on_w * axes.along - on_w * rate.along;
        let across = on_e3 - e3 * e3.dot(&on_e3);
        let d_across = d_on_e3 - de3 * e3.dot(&on_e3) - e3 * (de3.dot(&on_e3) + e3.dot(&d_on_e3));
        let d_on_m = d_across * axes.of_m - across * (axes.of_m * axes.of_m * e3.dot(dm));
        [
            Vec3::zeros(),
            (e * s11 + f * s12) * dq + (de * s11 + df * s12) * q + d_on_w * along_a,
            (f * s22 + e * s12) * dq + (df * s22 + de * s12) * q + d_on_w * along_b,
            force * rise + d_on_m,
            (a * s11 + b * s12) * dq + (da * s11 + db * s12) * q,
            (b * s22 + a * s12) * dq + (db * s22 + da * s12) * q,
        ]
    }

    /// Adds forces on the vectors to the rows of the corners.
    pub fn spread(&self, on: &Vectors, rows: &mut [Row]) {
        for (k, &b) in self.corners.iter().enumerate() {
            let share = self.share(k, on);
            rows[b as usize].iter_mut().zip(share).for_each(|(sum, more)| *sum += more);
        }
    }

    /// What forces on the vectors are on the k-th corner.
    fn share(&self, k: usize, on: &Vectors) -> Row {
        let Share { x: [phi, g1, g2], d: [psi, h1, h2], height } = self.shares[k];
        let x = on[0] * phi + on[1] * g1 + on[2] * g2;
        let d = on[0] * height + on[3] * psi + on[4] * h1 + on[5] * h2;
        [x.x, x.y, x.z, d.x, d.y, d.z]
    }

    /// Rates of place and director for rows of rates of the corners.
    pub fn rate(&self, v: &Vectors, rates: &[Row]) -> Row {
        let dv = self.vectors(rates);
        self.gradients(v).map(|of| of.iter().zip(&dv).map(|(g, change)| g.dot(change)).sum())
    }

    /// Derivatives of the six components of `[x, d]` with respect to the vectors.
    fn gradients(&self, v: &Vectors) -> [Vectors; 6] {
        std::array::from_fn(|i| {
            let mut unit = [0.0; 6];
            unit[i] = 1.0;
            self.transpose(v, &unit)
        })
    }

    /// `Z_k = ∂[x, d]_t/∂[x, d]_k` of each corner.
    pub fn jacobians(&self, v: &Vectors) -> Vec<Block> {
        let gradients = self.gradients(v);
        (0..self.corners.len()).map(|k| std::array::from_fn(|i| self.share(k, &gradients[i]))).collect()
    }

    /// The second variation `f·∂²x_t + n·∂²d_t`, a block for each pair of corners, row by row.
    pub fn second_variation(&self, v: &Vectors, row: &Row) -> Vec<Block> {
        let count = self.corners.len();
        let mut blocks = vec![[[0.0; 6]; 6]; count * count];
        for (l, shares) in self.shares.iter().enumerate() {
            for j in 0..6 {
                let mut dv = [Vec3::zeros(); 6];
                let own = if j < 3 { shares.x } else { shares.d };
                (0..3).for_each(|i| dv[i + j / 3 * 3][j % 3] = own[i]);
                let change = self.transpose_rate(v, &dv, row);
                for k in 0..count {
                    let share = self.share(k, &change);
                    (0..6).for_each(|i| blocks[k * count + l][i][j] = share[i]);
                }
            }
        }
        blocks
    }
}

fn halves(row: &Row) -> (Vec3, Vec3) {
    (Vec3::new(row[0], row[1], row[2]), Vec3::new(row[3], row[4], row[5]))
}
