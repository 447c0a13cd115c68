//! A row of bars, the end of which the level moves.

use implicit_statics::Equilibrium;

/// A row of bars of stiffness n between a wall and an end that is moved by the level; each hardens with its strain.
pub struct Bars {
    pub q: Vec<f64>,
    end: f64,
    pub accepted: usize,
}

impl Bars {
    pub fn new(bars: usize) -> Self {
        Self { q: vec![0.0; bars - 1], end: 0.0, accepted: 0 }
    }

    fn strain(&self, bar: usize) -> f64 {
        let left = if bar == 0 { 0.0 } else { self.q[bar - 1] };
        let right = self.q.get(bar).copied().unwrap_or(self.end);
        (right - left) * (self.q.len() + 1) as f64
    }

    /// Force in a bar, `ε + ε³`.
    pub fn force(&self, bar: usize) -> f64 {
        let strain = self.strain(bar);
        strain + strain.powi(3)
    }

    fn stiffness(&self, bar: usize) -> f64 {
        (1.0 + 3.0 * self.strain(bar).powi(2)) * (self.q.len() + 1) as f64
    }
}

impl Equilibrium for Bars {
    fn unknowns(&self) -> usize {
        self.q.len()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        (0..self.q.len())
            .flat_map(|i| [(i, i), (i, i.wrapping_sub(1))])
            .filter(|&(_, j)| j < usize::MAX)
            .collect()
    }

    fn internal(&mut self, level: f64, out: &mut [f64]) {
        self.end = level;
        for (i, force) in out.iter_mut().enumerate() {
            *force = self.force(i) - self.force(i + 1);
        }
    }

    fn external(&mut self, _: f64, out: &mut [f64]) {
        out.fill(0.0);
    }

    fn load_rate(&mut self, level: f64, out: &mut [f64]) {
        self.end = level;
        out.fill(0.0);
        let last = self.q.len();
        out[last - 1] = self.stiffness(last);
    }

    fn has_moving_supports(&self) -> bool {
        true
    }

    fn driving_force(&self) -> f64 {
        self.force(self.q.len()).abs()
    }

    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        self.end = level;
        let mut slot = 0;
        for i in 0..self.q.len() {
            values[slot] = self.stiffness(i) + self.stiffness(i + 1);
            slot += 1;
            if i > 0 {
                values[slot] = -self.stiffness(i);
                slot += 1;
            }
        }
    }

    fn commit(&mut self) {
        self.accepted += 1;
    }

    fn update(&mut self, increment: &[f64]) {
        self.q.iter_mut().zip(increment).for_each(|(q, d)| *q += d);
    }

    fn save(&self) -> Vec<f64> {
        self.q.iter().copied().chain([self.end]).collect()
    }

    fn restore(&mut self, saved: &[f64]) {
        let (end, q) = saved.split_last().expect("the end is saved last");
        self.q.copy_from_slice(q);
        self.end = *end;
    }

    fn energy(&mut self) -> f64 {
        let bars = self.q.len() + 1;
        (0..bars).map(|bar| self.strain(bar).powi(2) * (0.5 + 0.25 * self.strain(bar).powi(2))).sum::<f64>()
            / bars as f64
    }

    fn masses(&self) -> Vec<f64> {
        vec![1.0; self.q.len()]
    }

    fn name_unknown(&self, unknown: usize) -> String {
        format!("joint {unknown}")
    }
}
