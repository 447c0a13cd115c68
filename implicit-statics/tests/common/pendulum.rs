//! A chain of directors on spheres, bent by a side load: the state is no vector space.

use implicit_statics::Equilibrium;

type Vector = nalgebra::Vector3<f64>;

/// Directors d₁ … d_n, the first tied to e_z, each to the next by energy −dᵢ·dᵢ₊₁, under the load
/// `λ Σ f·dᵢ` with f = e_x + ½ e_y. Increments are two turns of each director, about its own tangents.
pub struct Pendulum {
    pub frames: Vec<[Vector; 3]>,
}

const LOAD: Vector = Vector::new(1.0, 0.5, 0.0);

impl Pendulum {
    pub fn new(directors: usize) -> Self {
        Self { frames: vec![[Vector::x(), Vector::y(), Vector::z()]; directors] }
    }

    pub fn director(&self, i: usize) -> Vector {
        self.frames[i][2]
    }

    /// Angle from e_z towards the load.
    pub fn angle(&self, i: usize) -> f64 {
        libm::atan2(self.director(i).dot(&LOAD.normalize()), self.director(i).z)
    }

    /// Magnitude of the load on one director at level 1.
    pub fn load() -> f64 {
        LOAD.norm()
    }

    fn neighbours(&self, i: usize) -> Vector {
        let below = if i == 0 { Vector::z() } else { self.director(i - 1) };
        let above = if i + 1 < self.frames.len() { self.director(i + 1) } else { Vector::zeros() };
        below + above
    }
}

impl Equilibrium for Pendulum {
    fn unknowns(&self) -> usize {
        2 * self.frames.len()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        let mut pattern = Vec::new();
        for i in 0..self.frames.len() {
            pattern.extend([(2 * i, 2 * i), (2 * i + 1, 2 * i + 1)]);
            if i > 0 {
                for (a, b) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    pattern.push((2 * i + a, 2 * (i - 1) + b));
                }
            }
        }
        pattern
    }

    fn internal(&mut self, _level: f64, out: &mut [f64]) {
        for i in 0..self.frames.len() {
            for a in 0..2 {
                out[2 * i + a] = -self.neighbours(i).dot(&self.frames[i][a]);
            }
        }
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.load_rate(level, out);
        out.iter_mut().for_each(|f| *f *= level);
    }

    fn load_rate(&mut self, _level: f64, out: &mut [f64]) {
        for i in 0..self.frames.len() {
            for a in 0..2 {
                out[2 * i + a] = LOAD.dot(&self.frames[i][a]);
            }
        }
    }

    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        let mut slot = 0;
        for i in 0..self.frames.len() {
            // on the sphere the second derivative along a great circle is that of the space less g·d
            let [t1, t2, d] = self.frames[i];
            let pull = (self.neighbours(i) + level * LOAD).dot(&d);
            values[slot..slot + 2].copy_from_slice(&[pull, pull]);
            slot += 2;
            if i > 0 {
                for t in [t1, t2] {
                    for b in 0..2 {
                        values[slot] = -t.dot(&self.frames[i - 1][b]);
                        slot += 1;
                    }
                }
            }
        }
    }

    fn update(&mut self, increment: &[f64]) {
        for (frame, turn) in self.frames.iter_mut().zip(increment.chunks(2)) {
            let way = turn[0] * frame[0] + turn[1] * frame[1];
            let rotation = nalgebra::Rotation3::new(frame[2].cross(&way));
            *frame = frame.map(|v| rotation * v);
        }
    }

    fn save(&self) -> Vec<f64> {
        self.frames.iter().flatten().flat_map(|v| [v.x, v.y, v.z]).collect()
    }

    fn restore(&mut self, saved: &[f64]) {
        for (frame, values) in self.frames.iter_mut().zip(saved.chunks(9)) {
            *frame = [0, 3, 6].map(|k| Vector::from_column_slice(&values[k..k + 3]));
        }
    }

    fn energy(&mut self) -> f64 {
        let last = self.frames.len() - 1;
        (0..=last)
            .map(|i| 1.0 - self.director(i).dot(&if i == 0 { Vector::z() } else { self.director(i - 1) }))
            .sum()
    }

    fn masses(&self) -> Vec<f64> {
        vec![1.0; self.unknowns()]
    }

    fn name_unknown(&self, unknown: usize) -> String {
        format!("director {}, turn {}", unknown / 2, unknown % 2)
    }
}
