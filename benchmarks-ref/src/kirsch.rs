//! An infinite plate with a circular hole under tension: the closed form of Kirsch, plane stress.

/// The plate: Young's modulus \[F/L²\], Poisson's ratio, radius of the hole \[L\], tension σ along x far away \[F/L²\].
#[derive(Clone, Copy, Debug)]
pub struct Hole {
    /// E.
    pub young: f64,
    /// ν.
    pub poisson: f64,
    /// a.
    pub radius: f64,
    /// σ.
    pub tension: f64,
}

impl Hole {
    /// Displacement at a point outside the hole \[L\] \[timoshenko1951\].
    ///
    /// ```text
    /// u_r = σ/(2E) { (1+ν)[ a²/r + cos 2θ (r − a⁴/r³) ] + (1−ν) r + 4 a²/r cos 2θ }
    /// u_θ = −σ/(2E) sin 2θ { (1+ν)(r + a⁴/r³) + 2(1−ν) a²/r }
    /// ```
    pub fn displacement(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let Self { young, poisson: nu, radius: a, tension } = *self;
        let square = x * x + y * y;
        let r = square.sqrt();
        let (cos, sin) = (x / r, y / r);
        let (cos2, sin2) = (cos * cos - sin * sin, 2.0 * sin * cos);
        let (near, nearer) = (a * a / r, a.powi(4) / r.powi(3));
        let factor = tension / (2.0 * young);
        let radial =
            factor * ((1.0 + nu) * (near + cos2 * (r - nearer)) + (1.0 - nu) * r + 4.0 * near * cos2);
        let around = -factor * sin2 * ((1.0 + nu) * (r + nearer) + 2.0 * (1.0 - nu) * near);
        [radial * cos - around * sin, radial * sin + around * cos]
    }

    /// Hoop stress `σ_θ` at a distance r from the centre, across the load (θ = 90°) \[F/L²\].
    pub fn hoop_across(&self, r: f64) -> f64 {
        let q = (self.radius / r).powi(2);
        0.5 * self.tension * (2.0 + q + 3.0 * q * q)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const HOLE: Hole = Hole { young: 2.0, poisson: 0.3, radius: 0.5, tension: 1.2 };

    #[test]
    fn the_edge_moves_by_three_and_minus_one() {
        let unit = HOLE.tension * HOLE.radius / HOLE.young;
        assert_relative_eq!(HOLE.displacement([0.5, 0.0])[0], 3.0 * unit, max_relative = 1e-14);
        assert_relative_eq!(HOLE.displacement([0.0, 0.5])[1], -unit, max_relative = 1e-14);
        assert_relative_eq!(HOLE.hoop_across(0.5), 3.0 * HOLE.tension);
        assert_relative_eq!(HOLE.hoop_across(1.0), 1.21875 * HOLE.tension);
    }

    /// Strains by differences give stresses in balance, and none across the edge of the hole.
    #[test]
    fn the_field_is_in_balance() {
        let Hole { young: e, poisson: nu, .. } = HOLE;
        let stress = |x: f64, y: f64| {
            let h = 1e-5;
            let d = |f: &dyn Fn(f64) -> [f64; 2]| {
                let (plus, minus) = (f(h), f(-h));
                [(plus[0] - minus[0]) / (2.0 * h), (plus[1] - minus[1]) / (2.0 * h)]
            };
            let along = d(&|s| HOLE.displacement([x + s, y]));
            let across = d(&|s| HOLE.displacement([x, y + s]));
            let plane = e / (1.0 - nu * nu);
            [
                plane * (along[0] + nu * across[1]),
                plane * (across[1] + nu * along[0]),
                e / (2.0 * (1.0 + nu)) * (along[1] + across[0]),
            ]
        };
        let (x, y, h) = (0.6, 0.45, 1e-3);
        let along = [0, 1, 2].map(|i| (stress(x + h, y)[i] - stress(x - h, y)[i]) / (2.0 * h));
        let across = [0, 1, 2].map(|i| (stress(x, y + h)[i] - stress(x, y - h)[i]) / (2.0 * h));
        // Second differences of a field of size one lose 1e-16/(h·1e-5).
        assert!((along[0] + across[2]).abs() < 1e-4 && (along[2] + across[1]).abs() < 1e-4);
        let (x, y) = (0.3, 0.4);
        let [xx, yy, xy] = stress(x, y);
        let (n, m) = (0.6, 0.8);
        assert!((xx * n + xy * m).abs() < 1e-6 && (xy * n + yy * m).abs() < 1e-6);
    }
}
