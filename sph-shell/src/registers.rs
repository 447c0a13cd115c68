//! Registers that hold a number of each of four points, and how constants, rows of particles and forces come and go.
//!
//! [`Baseline`] computes with [`Pack`], whatever the processor. The [`Lanes`] that the processor chooses carry a whole pack
//! in one register; [`Reals`] give them the operators in which the point formulas are written. Both give the same bits.

use lanes::{Lanes, Reals};
use shell_kinematics::{LANES, Measures, Number, Pack};

/// Position and director of a particle, or the forces on them: `[x, y, z, d_x, d_y, d_z]`.
pub(crate) type Row = [f64; 6];

/// A kind of registers; a token that is handed down to wherever something is loaded.
pub(crate) trait Registers: Copy {
    /// A number of each of four points.
    type Four: Number;

    /// The same number in every lane.
    fn splat(self, value: f64) -> Self::Four;
    /// Four numbers from memory.
    fn load(self, pack: &Pack) -> Self::Four;
    /// Four numbers that follow each other in memory.
    fn four(self, four: &[f64; LANES]) -> Self::Four;
    /// Four numbers to memory.
    fn store(self, four: Self::Four) -> Pack;
    /// Rows of four particles, turned into columns.
    fn columns(self, rows: [&Row; LANES]) -> [Self::Four; 6];
    /// The transpose of [`Registers::columns`].
    fn rows(self, columns: [Self::Four; 6]) -> [Row; LANES];

    /// A row as it lies in memory, in two overlapping halves: `[x, y, z, u]` and `[z, u, v, w]`.
    fn halves(self, row: &Row) -> [Self::Four; 2];
    /// Rows in halves, turned into columns.
    fn turned(self, rows: [[Self::Four; 2]; LANES]) -> [Self::Four; 6];

    /// Some packs from memory. Closures would not be compiled for the lanes; loops are.
    #[inline(always)]
    fn loads<const N: usize>(self, packs: &[Pack; N]) -> [Self::Four; N] {
        let mut fours = [self.splat(0.0); N];
        for i in 0..N {
            fours[i] = self.load(&packs[i]);
        }
        fours
    }

    /// Measures from memory.
    #[inline(always)]
    fn load_measures(self, measures: &Measures) -> Measures<Self::Four> {
        let Measures { membrane, curvature, shear } = measures;
        Measures {
            membrane: self.loads(membrane),
            curvature: self.loads(curvature),
            shear: self.loads(shear),
        }
    }
}

/// Rows of four particles, turned into columns.
#[inline(always)]
pub(crate) fn columns<R: Registers>(registers: R, [a, b, c, d]: &[Row; LANES]) -> [R::Four; 6] {
    registers.columns([a, b, c, d])
}

/// Four from number `first` on, or all there are and the last one again.
#[inline(always)]
pub(crate) fn four_of<T: Copy>(all: &[T], first: usize) -> [T; LANES] {
    let last = all.len() - 1;
    match all[first..].first_chunk() {
        Some(four) => *four,
        None => std::array::from_fn(|lane| all[(first + lane).min(last)]),
    }
}

/// Packs as any processor has them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Baseline;

impl Registers for Baseline {
    type Four = Pack;

    #[inline(always)]
    fn splat(self, value: f64) -> Pack {
        Pack::splat(value)
    }

    #[inline(always)]
    fn load(self, pack: &Pack) -> Pack {
        *pack
    }

    #[inline(always)]
    fn four(self, four: &[f64; LANES]) -> Pack {
        Pack::new(*four)
    }

    #[inline(always)]
    fn store(self, four: Pack) -> Pack {
        four
    }

    #[inline(always)]
    fn columns(self, [a, b, c, d]: [&Row; LANES]) -> [Pack; 6] {
        let mut columns = [Pack::ZERO; 6];
        for i in 0..6 {
            columns[i] = Pack::new([a[i], b[i], c[i], d[i]]);
        }
        columns
    }

    #[inline(always)]
    fn rows(self, columns: [Pack; 6]) -> [Row; LANES] {
        let columns = columns.map(Pack::lanes);
        let mut rows = [[0.0; 6]; LANES];
        for (lane, row) in rows.iter_mut().enumerate() {
            for i in 0..6 {
                row[i] = columns[i][lane];
            }
        }
        rows
    }

    #[inline(always)]
    fn halves(self, row: &Row) -> [Pack; 2] {
        let [x, y, z, u, v, w] = *row;
        [Pack::new([x, y, z, u]), Pack::new([z, u, v, w])]
    }

    #[inline(always)]
    fn turned(self, rows: [[Pack; 2]; LANES]) -> [Pack; 6] {
        let mut columns = [Pack::ZERO; 6];
        for i in 0..6 {
            // From the fourth number on, two places before in the second half.
            let (half, place) = if i < 4 { (0, i) } else { (1, i - 2) };
            columns[i] = Pack::new([
                rows[0][half].lanes()[place],
                rows[1][half].lanes()[place],
                rows[2][half].lanes()[place],
                rows[3][half].lanes()[place],
            ]);
        }
        columns
    }
}

impl<L: Lanes> Registers for L {
    type Four = Reals<L>;

    #[inline(always)]
    fn splat(self, value: f64) -> Reals<L> {
        self.same(value)
    }

    #[inline(always)]
    fn load(self, pack: &Pack) -> Reals<L> {
        self.read(pack.as_array())
    }

    #[inline(always)]
    fn four(self, four: &[f64; LANES]) -> Reals<L> {
        self.read(four)
    }

    #[inline(always)]
    fn store(self, four: Reals<L>) -> Pack {
        Pack::new(Lanes::store(self, four.four))
    }

    #[inline(always)]
    fn columns(self, [a, b, c, d]: [&Row; LANES]) -> [Reals<L>; 6] {
        let [x, y, z, u] = Lanes::columns(
            self,
            [
                &[a[0], a[1], a[2], a[3]],
                &[b[0], b[1], b[2], b[3]],
                &[c[0], c[1], c[2], c[3]],
                &[d[0], d[1], d[2], d[3]],
            ],
        );
        let [v, w] = self.columns_of_two([&[a[4], a[5]], &[b[4], b[5]], &[c[4], c[5]], &[d[4], d[5]]]);
        let of = self;
        [
            Reals { lanes: of, four: x },
            Reals { lanes: of, four: y },
            Reals { lanes: of, four: z },
            Reals { lanes: of, four: u },
            Reals { lanes: of, four: v },
            Reals { lanes: of, four: w },
        ]
    }

    #[inline(always)]
    fn rows(self, [x, y, z, u, v, w]: [Reals<L>; 6]) -> [Row; LANES] {
        let starts = Lanes::rows(self, [x.four, y.four, z.four, u.four]);
        let ends = self.rows_of_two([v.four, w.four]);
        let mut rows = [[0.0; 6]; LANES];
        for lane in 0..LANES {
            // Whole pieces: taken apart into numbers, they would be put together again across rows.
            let (start, end) = rows[lane].split_at_mut(LANES);
            start.copy_from_slice(&starts[lane]);
            end.copy_from_slice(&ends[lane]);
        }
        rows
    }

    #[inline(always)]
    fn halves(self, row: &Row) -> [Reals<L>; 2] {
        let [x, y, z, u, v, w] = *row;
        [self.four(&[x, y, z, u]), self.four(&[z, u, v, w])]
    }

    #[inline(always)]
    fn turned(self, [a, b, c, d]: [[Reals<L>; 2]; LANES]) -> [Reals<L>; 6] {
        let [x, y, z, u] = Lanes::rows(self, [a[0].four, b[0].four, c[0].four, d[0].four]);
        let [_, _, v, w] = Lanes::rows(self, [a[1].four, b[1].four, c[1].four, d[1].four]);
        [self.four(&x), self.four(&y), self.four(&z), self.four(&u), self.four(&v), self.four(&w)]
    }
}
