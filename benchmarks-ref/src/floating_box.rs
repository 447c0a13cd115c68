//! A box that floats in a tank and swings up and down: linear potential flow in the plane, by finite volumes.
//!
//! Half of the tank, the box to the left, in square cells whose means of the potential φ are the unknowns. Walls, floor and the side of the box are tight; below
//! the box the water moves with it; on the surface `φ = φ_s`:
//!
//! ```text
//! ∇²φ = 0      η' = ∂φ/∂y      φ_s' = −g η      m Z'' = −ρ ∫ φ' dx − ρ g b Z      m = ρ b d
//! ```
//!
//! φ' is harmonic as well, with −gη on the surface and Z'' below the box: a part for each, so that the added mass stands with m on the left. In time by the rule of
//! Runge and Kutta of the fourth order. The velocity at the lower corners of the box is singular, φ ~ r^⅔, so that errors go with the 4/3 of the cell: two sizes
//! of cells give the limit.

/// A tank with a box that floats in its middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatingBox {
    /// Length and depth of the tank \[L\].
    pub tank: [f64; 2],
    /// Breadth and draught of the box \[L\].
    pub section: [f64; 2],
    /// Gravity \[L/T²\].
    pub gravity: f64,
}

/// The order of the errors.
pub(crate) const ORDER: f64 = 4.0 / 3.0;

/// Half of the tank in cells.
struct Grid {
    cell: f64,
    laplace: Banded,
    /// Cells below the surface, and below the box.
    surface: Vec<usize>,
    below: Vec<usize>,
    /// Integral over half of the box of the potential that a unit of velocity of the box makes \[L³\].
    added: f64,
    /// Volume that half of the box displaces \[L²\].
    displaced: f64,
    breadth: f64,
    gravity: f64,
}

impl Grid {
    /// So many cells to a draught, which divide the other lengths.
    fn new(of: &FloatingBox, cells: usize) -> Self {
        let FloatingBox { tank: [length, depth], section: [breadth, draught], gravity } = *of;
        let cell = draught / cells as f64;
        let count = |length: f64| libm::round(length / cell) as usize;
        let (columns, rows, of_box) = (count(0.5 * length), count(depth), count(0.5 * breadth));
        let mut number = vec![vec![None; rows]; columns];
        let mut all = 0;
        for (i, column) in number.iter_mut().enumerate() {
            let top = if i < of_box { rows - cells } else { rows };
            column[..top].iter_mut().for_each(|place| {
                *place = Some(all);
                all += 1;
            });
        }
        let at = |i: usize, j: usize| number.get(i).and_then(|column| column.get(j)).copied().flatten();
        let mut laplace = Banded::new(all, rows);
        for i in 0..columns {
            for j in 0..rows {
                let Some(own) = at(i, j) else { continue };
                for other in [at(i + 1, j), at(i, j + 1)].into_iter().flatten() {
                    laplace.add(own, own, 1.0);
                    laplace.add(other, other, 1.0);
                    laplace.add(other, own, -1.0);
                }
            }
        }
        let surface: Vec<usize> = (of_box..columns).filter_map(|i| at(i, rows - 1)).collect();
        let below: Vec<usize> = (0..of_box).filter_map(|i| at(i, rows - cells - 1)).collect();
        // Half a cell lies between its middle and the surface.
        surface.iter().for_each(|&own| laplace.add(own, own, 2.0));
        laplace.factor();
        let (displaced, added) = (0.5 * breadth * draught, 0.0);
        let mut grid = Self { cell, laplace, surface, below, added, displaced, breadth, gravity };
        let unit = grid.potential(&vec![0.0; grid.surface.len()], 1.0);
        grid.added = grid.on_box(&unit, 1.0);
        grid
    }

    /// The potential with these values on the surface and this velocity of the box.
    fn potential(&self, surface: &[f64], velocity: f64) -> Vec<f64> {
        let mut field = vec![0.0; self.laplace.size];
        self.surface.iter().zip(surface).for_each(|(&own, value)| field[own] += 2.0 * value);
        self.below.iter().for_each(|&own| field[own] += self.cell * velocity);
        self.laplace.solve(&mut field);
        field
    }

    /// Integral of a potential over half of the lower face of the box, which has this velocity.
    fn on_box(&self, field: &[f64], velocity: f64) -> f64 {
        self.below.iter().map(|&own| self.cell * (field[own] + 0.5 * self.cell * velocity)).sum()
    }

    /// Rates of heights, potentials on the surface, place and velocity of the box.
    fn rates(&self, state: &[f64]) -> Vec<f64> {
        let count = self.surface.len();
        let (heights, potentials) = (&state[..count], &state[count..2 * count]);
        let [place, velocity] = [state[2 * count], state[2 * count + 1]];
        let field = self.potential(potentials, velocity);
        let pulled: Vec<f64> = heights.iter().map(|height| -self.gravity * height).collect();
        let pressed = self.on_box(&self.potential(&pulled, 0.0), 0.0);
        let force = -pressed - self.gravity * 0.5 * self.breadth * place;
        let up =
            self.surface.iter().zip(potentials).map(|(&own, value)| 2.0 * (value - field[own]) / self.cell);
        let last = [velocity, force / (self.displaced + self.added)];
        up.chain(pulled.iter().copied()).chain(last).collect()
    }
}

impl FloatingBox {
    /// Times \[T\] and heights of the box over the one at the start, from which it is let go above flat water at rest; `cells` to a draught.
    pub fn heave(&self, cells: usize, step: f64, steps: usize) -> Vec<[f64; 2]> {
        let grid = Grid::new(self, cells);
        let count = grid.surface.len();
        // What the box gives up of its draught the surface goes down.
        let down = -self.section[0] / (self.tank[0] - self.section[0]);
        let mut state = vec![0.0; 2 * count + 2];
        state[..count].fill(down);
        state[2 * count] = 1.0;
        let ahead = |state: &[f64], rate: &[f64], by: f64| -> Vec<f64> {
            state.iter().zip(rate).map(|(value, rate)| value + by * rate).collect()
        };
        let mut rows = vec![[0.0, 1.0]];
        for number in 1..=steps {
            let first = grid.rates(&state);
            let second = grid.rates(&ahead(&state, &first, 0.5 * step));
            let third = grid.rates(&ahead(&state, &second, 0.5 * step));
            let fourth = grid.rates(&ahead(&state, &third, step));
            for (k, value) in state.iter_mut().enumerate() {
                *value += step / 6.0 * (first[k] + 2.0 * (second[k] + third[k]) + fourth[k]);
            }
            rows.push([number as f64 * step, state[2 * count]]);
        }
        rows
    }

    /// The first time at which the box goes through its place at rest, and the time from then to the next \[T\]: half of its period. The limit for small cells
    /// of `cells` and twice as many to a draught.
    pub fn half_swing(&self, cells: usize, step: f64, steps: usize) -> Option<[f64; 2]> {
        let of = |cells: usize| match crossings(&self.heave(cells, step, steps))[..] {
            [first, second, ..] => Some([first, second - first]),
            _ => None,
        };
        let ([coarse, fine], part) = ([of(cells)?, of(2 * cells)?], libm::pow(2.0, ORDER) - 1.0);
        Some([0, 1].map(|k| fine[k] + (fine[k] - coarse[k]) / part))
    }

    /// Added mass of the box over the mass that it displaces where it moves so fast that no wave goes out.
    pub fn added_mass(&self, cells: usize) -> f64 {
        let grid = Grid::new(self, cells);
        grid.added / grid.displaced
    }
}

/// Times at which rows of time and value go through zero, straight between two rows.
pub fn crossings(rows: &[[f64; 2]]) -> Vec<f64> {
    let through = |pair: &[[f64; 2]]| {
        let [[t, x], [u, y]] = [pair[0], pair[1]];
        (x * y < 0.0 || y == 0.0 && x != 0.0).then(|| t + (u - t) * x / (x - y))
    };
    rows.windows(2).filter_map(through).collect()
}

/// A symmetric matrix by the rows of its lower band, in which its Cholesky factor takes its place.
pub(crate) struct Banded {
    size: usize,
    width: usize,
    rows: Vec<f64>,
}

impl Banded {
    pub(crate) fn new(size: usize, width: usize) -> Self {
        Self { size, width, rows: vec![0.0; size * (width + 1)] }
    }

    /// The place of row i and column j ≤ i.
    fn at(&self, i: usize, j: usize) -> usize {
        i * (self.width + 1) + j + self.width - i
    }

    pub(crate) fn add(&mut self, i: usize, j: usize, value: f64) {
        let at = self.at(i.max(j), i.min(j));
        self.rows[at] += value;
    }

    pub(crate) fn factor(&mut self) {
        for i in 0..self.size {
            let first = i.saturating_sub(self.width);
            for j in first..=i {
                let from = first.max(j.saturating_sub(self.width));
                let done: f64 = (from..j).map(|k| self.rows[self.at(i, k)] * self.rows[self.at(j, k)]).sum();
                let at = self.at(i, j);
                let left = self.rows[at] - done;
                self.rows[at] = if i == j { left.sqrt() } else { left / self.rows[self.at(j, j)] };
            }
        }
    }

    pub(crate) fn solve(&self, x: &mut [f64]) {
        for i in 0..self.size {
            let done: f64 = (i.saturating_sub(self.width)..i).map(|k| self.rows[self.at(i, k)] * x[k]).sum();
            x[i] = (x[i] - done) / self.rows[self.at(i, i)];
        }
        for i in (0..self.size).rev() {
            x[i] /= self.rows[self.at(i, i)];
            for k in i.saturating_sub(self.width)..i {
                x[k] -= self.rows[self.at(i, k)] * x[i];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box half as deep as wide in much water is half of a square that moves in water without end, whose added mass is 1.5134 π a² for half its edge a [newman1977]:
    /// 1.189 of what it displaces. The limit of two, four cells is within .6 %, which the tank adds.
    #[test]
    fn a_fast_box_has_half_of_the_added_mass_of_a_square() {
        let wide = FloatingBox { tank: [8.0, 4.0], section: [0.4, 0.2], gravity: 9.81 };
        let [coarse, fine] = [2, 4].map(|cells| wide.added_mass(cells));
        let limit = fine + (fine - coarse) / (libm::pow(2.0, ORDER) - 1.0);
        let exact = 1.5134 * std::f64::consts::PI / 4.0;
        assert!((limit / exact - 1.0).abs() < 0.01, "{limit} {exact}");
    }

    /// Times of three sizes of cells differ by the 4/3 of the cell: their order is found within a tenth, and the limits of two pairs within .2 %.
    #[test]
    fn times_converge_with_the_order_of_the_corner() {
        let small = FloatingBox { tank: [1.2, 0.4], section: [0.4, 0.2], gravity: 9.81 };
        let second = |cells| crossings(&small.heave(cells, 0.01, 120))[1];
        let times = [2, 4, 8].map(second);
        let order = libm::log2((times[0] - times[1]) / (times[1] - times[2]));
        assert!((order - ORDER).abs() < 0.15, "{order} {times:?}");
        let [coarse, fine] = [2, 4].map(|cells| small.half_swing(cells, 0.01, 120).unwrap());
        assert!((0..2).all(|k| (coarse[k] / fine[k] - 1.0).abs() < 4e-3), "{coarse:?} {fine:?}");
    }

    /// Kinetic and potential energy of water and box together stay as they are along the rates: both are quadratic, so that a central difference is exact but for
    /// rounding.
    #[test]
    fn energy_is_kept() {
        let small = FloatingBox { tank: [1.2, 0.4], section: [0.4, 0.2], gravity: 9.81 };
        let grid = Grid::new(&small, 2);
        let count = grid.surface.len();
        let energy = |state: &[f64]| {
            let (heights, potentials) = (&state[..count], &state[count..2 * count]);
            let [place, velocity] = [state[2 * count], state[2 * count + 1]];
            let field = grid.potential(potentials, velocity);
            let rates = grid.rates(state);
            let flow: f64 = potentials.iter().zip(&rates).map(|(value, rate)| grid.cell * value * rate).sum();
            let kinetic = 0.5 * (flow + velocity * grid.on_box(&field, velocity));
            let raised: f64 = heights.iter().map(|height| grid.cell * height * height).sum();
            let potential = 0.5 * grid.gravity * (raised + 0.5 * grid.breadth * place * place);
            kinetic + potential + 0.5 * grid.displaced * velocity * velocity
        };
        let mut state: Vec<f64> = (0..2 * count).map(|i| 0.1 * libm::sin(i as f64)).collect();
        state.extend([0.3, -0.2]);
        let rates = grid.rates(&state);
        let moved = |by: f64| -> f64 {
            let next: Vec<f64> = state.iter().zip(&rates).map(|(value, rate)| value + by * rate).collect();
            energy(&next)
        };
        // The rate of the energy along the motion, by a central difference.
        let rate = (moved(1e-4) - moved(-1e-4)) / 2e-4;
        assert!(rate.abs() < 1e-7 * energy(&state), "{rate:e} {:e}", energy(&state));
    }
}
