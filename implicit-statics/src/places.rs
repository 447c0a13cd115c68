//! The pattern of a tangent place by place: unknowns that stand at one place, such as the five of a particle, are one node of a smaller graph, in which orders
//! of elimination are looked for at a fraction of the cost.

/// Places in the order of their unknowns, and which of them are coupled.
pub(crate) struct Places {
    /// First unknown of each place, and the number of unknowns.
    first: Vec<usize>,
    /// Where each is \[L\].
    pub at: Vec<[f64; 3]>,
    /// Compressed columns of the lower triangle of the graph of places, the diagonal included.
    pub pointers: Vec<usize>,
    pub rows: Vec<usize>,
}

impl Places {
    /// Those of unknowns that follow each other and have the same coordinates; `pointers` and `rows` are compressed columns of the lower triangle of
    /// the pattern of the unknowns.
    pub fn of(coordinates: &[[f64; 3]], pointers: &[usize], rows: &[usize]) -> Self {
        let mut first = Vec::new();
        let mut of = Vec::with_capacity(coordinates.len());
        for (unknown, place) in coordinates.iter().enumerate() {
            if unknown == 0 || coordinates[unknown - 1] != *place {
                first.push(unknown);
            }
            of.push(first.len() - 1);
        }
        let at: Vec<_> = first.iter().map(|&unknown| coordinates[unknown]).collect();
        first.push(coordinates.len());
        let mut out = Self { first, at, pointers: vec![0], rows: Vec::new() };
        let mut seen = vec![usize::MAX; out.count()];
        for column in 0..out.count() {
            for unknown in out.unknowns(column) {
                for row in rows[pointers[unknown]..pointers[unknown + 1]].iter().map(|&row| of[row]) {
                    if seen[row] != column {
                        seen[row] = column;
                        out.rows.push(row);
                    }
                }
            }
            out.rows[out.pointers[column]..].sort_unstable();
            out.pointers.push(out.rows.len());
        }
        out
    }

    /// Number of places.
    pub fn count(&self) -> usize {
        self.at.len()
    }

    /// Unknowns at a place.
    pub fn unknowns(&self, place: usize) -> std::ops::Range<usize> {
        self.first[place]..self.first[place + 1]
    }

    /// Number of unknowns at a place.
    pub fn weight(&self, place: usize) -> usize {
        self.first[place + 1] - self.first[place]
    }

    /// Places coupled with a place, itself and later ones.
    pub fn coupled(&self, place: usize) -> &[usize] {
        &self.rows[self.pointers[place]..self.pointers[place + 1]]
    }

    /// An order of places as one of their unknowns.
    pub fn spread(&self, order: &[usize]) -> Vec<usize> {
        order.iter().flat_map(|&place| self.unknowns(place)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Places;

    /// Two unknowns at each of three places in a row, neighbours coupled: a chain of three.
    #[test]
    fn a_chain_of_pairs_is_a_chain() {
        let coordinates: Vec<[f64; 3]> = (0..6).map(|unknown| [f64::from(unknown / 2), 0.0, 0.0]).collect();
        let (mut pointers, mut rows) = (vec![0], Vec::new());
        for column in 0..6_usize {
            rows.extend(column..6.min(2 * (column / 2) + 4));
            pointers.push(rows.len());
        }
        let places = Places::of(&coordinates, &pointers, &rows);
        assert_eq!((places.count(), places.weight(1)), (3, 2));
        assert_eq!([0, 1, 2].map(|place| places.coupled(place).to_vec()), [vec![0, 1], vec![1, 2], vec![2]]);
        assert_eq!(places.spread(&[2, 0, 1]), [4, 5, 0, 1, 2, 3]);
    }
}
