//! A box under water on a hinge: what of the water swings with it, by potential flow in the plane and finite volumes.
//!
//! Half of the tank, the middle of the box to the left, where the potential of a swing to the side is zero; so it is on the surface, where swings are so fast that no wave
//! goes out, `ω² d ≫ g` of the depth d of the box. Walls, floor and the box are tight:
//!
//! ```text
//! ∇²φ = 0      ∂φ/∂n = n·(ω × r)  on the box, r from the hinge      I = ρ ∫ φ n·(ω × r) ds  over ω²
//! ```
//!
//! Errors go with the 4/3 of the cell, as those of every corner of a box: two sizes of cells give the limit.

use crate::floating_box::{Banded, ORDER};

/// A tank with a box on a hinge in its middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HingedBox {
    /// Length of the tank and depth of its water \[L\].
    pub tank: [f64; 2],
    /// Breadth and height of the box \[L\].
    pub section: [f64; 2],
    /// Heights of the lower face of the box and of the hinge over the floor \[L\].
    pub heights: [f64; 2],
}

impl HingedBox {
    /// Moment of inertia of the water about the hinge, over its density \[L⁴\]: the limit for small cells of this size and half of it, which divides all lengths but the
    /// height of the hinge.
    pub fn added_inertia(&self, cell: f64) -> f64 {
        let [coarse, fine] = [cell, 0.5 * cell].map(|cell| self.in_cells(cell));
        fine + (fine - coarse) / (libm::pow(2.0, ORDER) - 1.0)
    }

    /// Half a swing of a box of this density over that of water on a spring along the tank, whose stiffness is given over the density of water and by width \[L³/T²\], at the
    /// middle of the box \[T\].
    pub fn half_swing(&self, density: f64, stiffness: f64, cell: f64) -> f64 {
        let [breadth, height] = self.section;
        let arm = self.heights[1] - self.heights[0] - 0.5 * height;
        let own = breadth * height * (arm * arm + (breadth * breadth + height * height) / 12.0);
        let inertia = density * own + self.added_inertia(cell);
        std::f64::consts::PI * (inertia / stiffness).sqrt() / arm
    }

    fn in_cells(&self, cell: f64) -> f64 {
        let count = |length: f64| libm::round(length / cell) as usize;
        let (columns, rows) = (count(0.5 * self.tank[0]), count(self.tank[1]));
        let (wide, low) = (count(0.5 * self.section[0]), count(self.heights[0]));
        let high = low + count(self.section[1]);
        let within = |i: usize, j: usize| i < wide && (low..high).contains(&j);
        let mut number = vec![vec![None; rows]; columns];
        let mut all = 0;
        for (i, column) in number.iter_mut().enumerate() {
            for (_, place) in column.iter_mut().enumerate().filter(|(j, _)| !within(i, *j)) {
                *place = Some(all);
                all += 1;
            }
        }
        let at = |i: usize, j: usize| number.get(i).and_then(|column| column.get(j)).copied();
        let mut laplace = Banded::new(all, rows);
        // Cells beside the box with what of the water its faces push into them by time.
        let mut pushed = Vec::new();
        for i in 0..columns {
            for j in 0..rows {
                let Some(Some(own)) = at(i, j) else { continue };
                for (k, l) in [(i + 1, j), (i, j + 1)] {
                    match at(k, l) {
                        Some(Some(other)) => {
                            laplace.add(own, own, 1.0);
                            laplace.add(other, other, 1.0);
                            laplace.add(other, own, -1.0);
                        }
                        // Below the lower face, which goes up by the distance from the middle.
                        Some(None) => pushed.push((own, -cell * (i as f64 + 0.5))),
                        None => {}
                    }
                }
                if j == high && i < wide {
                    pushed.push((own, cell * (i as f64 + 0.5)));
                }
                if i == wide && (low..high).contains(&j) {
                    pushed.push((own, self.heights[1] - cell * (j as f64 + 0.5)));
                }
                // Half a cell lies between its middle and the middle of the tank, or the surface.
                for _ in 0..usize::from(i == 0) + usize::from(j + 1 == rows) {
                    laplace.add(own, own, 2.0);
                }
            }
        }
        laplace.factor();
        let mut field = vec![0.0; all];
        pushed.iter().for_each(|(own, speed)| field[*own] += cell * speed);
        laplace.solve(&mut field);
        2.0 * pushed.iter().map(|(own, speed)| cell * speed * (field[*own] + 0.5 * cell * speed)).sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On a long arm in much water a square of half an edge a goes to and fro alone: its added mass is 4.754 ρa² [newman1977]. The arm adds turns, the tank less than 3 %.
    #[test]
    fn on_a_long_arm_it_has_the_added_mass_of_a_square() {
        let wide = HingedBox { tank: [4.0, 4.0], section: [0.4, 0.4], heights: [1.8, 42.0] };
        let found = wide.added_inertia(0.1) / (40.0 * 40.0);
        let exact = 4.754 * 0.2 * 0.2;
        assert!((found / exact - 1.0).abs() < 0.03, "{found} {exact}");
    }

    /// Limits of two pairs of cells within .3 %.
    #[test]
    fn it_converges_with_the_order_of_the_corner() {
        let tank = HingedBox { tank: [1.2, 0.6], section: [0.2, 0.2], heights: [0.2, 0.8] };
        let [coarse, fine] = [0.05, 0.025].map(|cell| tank.added_inertia(cell));
        assert!((coarse / fine - 1.0).abs() < 3e-3, "{coarse} {fine}");
    }
}
