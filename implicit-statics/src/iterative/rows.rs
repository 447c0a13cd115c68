//! Sparse matrices by rows: what multigrid multiplies and transposes.

/// Compressed rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    pub columns: usize,
    /// Where each row begins, and the end.
    pub begin: Vec<usize>,
    pub at: Vec<u32>,
    pub values: Vec<f64>,
}

impl Rows {
    /// The whole of a symmetric matrix given by its lower triangle.
    pub fn symmetric(unknowns: usize, pattern: &[(usize, usize)], values: &[f64]) -> Self {
        let mut begin = vec![0; unknowns + 1];
        for &(i, j) in pattern {
            begin[i + 1] += 1;
            begin[j + 1] += usize::from(i != j);
        }
        (0..unknowns).for_each(|i| begin[i + 1] += begin[i]);
        let mut next = begin.clone();
        let mut whole = Self {
            columns: unknowns,
            at: vec![0; begin[unknowns]],
            values: vec![0.0; begin[unknowns]],
            begin,
        };
        let mut put = |i: usize, j: usize, value: f64| {
            (whole.at[next[i]], whole.values[next[i]]) = (j as u32, value);
            next[i] += 1;
        };
        for (&(i, j), &value) in pattern.iter().zip(values) {
            put(i, j, value);
            if i != j {
                put(j, i, value);
            }
        }
        whole
    }

    pub fn len(&self) -> usize {
        self.begin.len() - 1
    }

    /// Columns and values of a row.
    pub fn row(&self, i: usize) -> (&[u32], &[f64]) {
        let range = self.begin[i]..self.begin[i + 1];
        (&self.at[range.clone()], &self.values[range])
    }

    /// The product of a row with a vector.
    pub fn times(&self, i: usize, x: &[f64]) -> f64 {
        let (at, values) = self.row(i);
        at.iter().zip(values).map(|(&j, value)| value * x[j as usize]).sum()
    }

    /// `out = A x`.
    pub fn apply(&self, x: &[f64], out: &mut [f64]) {
        out.iter_mut().enumerate().for_each(|(i, out)| *out = self.times(i, x));
    }

    /// `out = Aᵀ x`.
    pub fn apply_transposed(&self, x: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for (i, x) in x.iter().enumerate() {
            let (at, values) = self.row(i);
            at.iter().zip(values).for_each(|(&j, value)| out[j as usize] += value * x);
        }
    }

    pub fn transposed(&self) -> Self {
        let mut begin = vec![0; self.columns + 1];
        self.at.iter().for_each(|&j| begin[j as usize + 1] += 1);
        (0..self.columns).for_each(|j| begin[j + 1] += begin[j]);
        let mut next = begin.clone();
        let mut other =
            Self { columns: self.len(), begin, at: vec![0; self.at.len()], values: vec![0.0; self.at.len()] };
        for i in 0..self.len() {
            let (at, values) = self.row(i);
            for (&j, &value) in at.iter().zip(values) {
                let place = &mut next[j as usize];
                (other.at[*place], other.values[*place]) = (i as u32, value);
                *place += 1;
            }
        }
        other
    }

    /// `A B`, columns of a row ascending.
    pub fn product(&self, other: &Self) -> Self {
        let mut out = Self { columns: other.columns, begin: vec![0], ..Self::default() };
        let mut sum = vec![0.0; other.columns];
        let mut seen = vec![u32::MAX; other.columns];
        let mut touched = Vec::new();
        for i in 0..self.len() {
            touched.clear();
            let (at, values) = self.row(i);
            for (&j, a) in at.iter().zip(values) {
                let (at, values) = other.row(j as usize);
                for (&k, b) in at.iter().zip(values) {
                    if seen[k as usize] != i as u32 {
                        seen[k as usize] = i as u32;
                        sum[k as usize] = 0.0;
                        touched.push(k);
                    }
                    sum[k as usize] += a * b;
                }
            }
            touched.sort_unstable();
            out.at.extend(&touched);
            out.values.extend(touched.iter().map(|&k| sum[k as usize]));
            out.begin.push(out.at.len());
        }
        out
    }
}
