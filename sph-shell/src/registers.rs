//! Registers that hold a number of each of four points, or of eight, and how constants, rows of particles and forces come and go.
//!
//! [`Baseline`] computes with [`Pack`], whatever the processor. The [`Lanes`] that the processor chooses carry a whole pack
//! in one register; [`Reals`] give them the operators in which the point formulas are written. In registers of AVX-512 two packs lie side by side
//! (`eights.rs`). All give the same bits.

use lanes::{Lanes, Reals};
use shell_kinematics::{LANES, Measures, Number, Pack};

/// Position and director of a particle, or the forces on them: `[x, y, z, d_x, d_y, d_z]`.
pub(crate) type Row = [f64; 6];

/// Registers that hold the numbers of `P` packs; a token that is handed down to wherever something is loaded.
pub(crate) trait Registers<const P: usize = 1>: Copy {
    /// A number of each point.
    type Numbers: Number;
    /// Registers for one pack, for what is left over.
    type Single: Fours<Single = Self::Single>;

    /// Those for one pack.
    fn single(self) -> Self::Single;
    /// The same number in every lane.
    fn splat(self, value: f64) -> Self::Numbers;
    /// The numbers of packs from memory.
    fn load(self, packs: [&Pack; P]) -> Self::Numbers;
    /// Numbers that follow each other in memory.
    fn read(self, numbers: &[[f64; LANES]; P]) -> Self::Numbers;
    /// Numbers to memory.
    fn store(self, numbers: Self::Numbers) -> [[f64; LANES]; P];
    /// Rows of particles, turned into columns.
    fn columns(self, rows: [[&Row; LANES]; P]) -> [Self::Numbers; 6];
    /// The transpose of [`Registers::columns`].
    fn rows(self, columns: [Self::Numbers; 6]) -> [[Row; LANES]; P];

    /// Columns of the forces on the particles of the groups.
    fn gathered(self, groups: impl Groups) -> [Self::Numbers; 6];

    /// Some numbers of packs from memory. Closures would not be compiled for the lanes; loops are.
    #[inline(always)]
    fn loads<const N: usize>(self, packs: [&[Pack; N]; P]) -> [Self::Numbers; N] {
        let mut numbers = [self.splat(0.0); N];
        for i in 0..N {
            numbers[i] = self.load(in_all(packs, |of| &of[i]));
        }
        numbers
    }

    /// Measures from memory.
    #[inline(always)]
    fn load_measures(self, of: [&Measures; P]) -> Measures<Self::Numbers> {
        Measures {
            membrane: self.loads(in_all(of, |of| &of.membrane)),
            curvature: self.loads(in_all(of, |of| &of.curvature)),
            shear: self.loads(in_all(of, |of| &of.shear)),
        }
    }
}

/// Registers for one pack, in which a row lies as in memory.
pub(crate) trait Fours: Registers {
    /// A row in two overlapping halves: `[x, y, z, u]` and `[z, u, v, w]`.
    fn halves(self, row: &Row) -> [Self::Numbers; 2];
    /// Rows in halves, turned into columns.
    fn turned(self, rows: [[Self::Numbers; 2]; LANES]) -> [Self::Numbers; 6];
}

/// Groups of four particles on which forces are summed.
pub(crate) trait Groups {
    /// The sums of a group, counted from the first, in halves.
    fn sums<R: Fours>(&self, registers: R, group: usize) -> [[R::Numbers; 2]; LANES];
}

/// One thing of each pack; in a loop, since closures handed on to a library's function need not be compiled for the registers.
#[inline(always)]
pub(crate) fn in_all<T: Copy, U: Copy, const P: usize>(packs: [T; P], thing: impl Fn(T) -> U) -> [U; P] {
    let mut all = [thing(packs[0]); P];
    for i in 1..P {
        all[i] = thing(packs[i]);
    }
    all
}

/// The numbers of one pack to memory.
#[inline(always)]
pub(crate) fn pack_of<R: Registers>(registers: R, numbers: R::Numbers) -> Pack {
    let [four] = registers.store(numbers);
    Pack::new(four)
}

/// Rows of particles that follow each other, turned into columns.
#[inline(always)]
pub(crate) fn columns<const P: usize, R: Registers<P>>(
    registers: R,
    rows: &[[Row; LANES]; P],
) -> [R::Numbers; 6] {
    let [a, b, c, d] = &rows[0];
    let mut all = [[a, b, c, d]; P];
    for i in 1..P {
        all[i] = rows[i].each_ref();
    }
    registers.columns(all)
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
    type Numbers = Pack;
    type Single = Self;

    #[inline(always)]
    fn single(self) -> Self {
        self
    }

    #[inline(always)]
    fn splat(self, value: f64) -> Pack {
        Pack::splat(value)
    }

    #[inline(always)]
    fn load(self, [pack]: [&Pack; 1]) -> Pack {
        *pack
    }

    #[inline(always)]
    fn read(self, [four]: &[[f64; LANES]; 1]) -> Pack {
        Pack::new(*four)
    }

    #[inline(always)]
    fn store(self, four: Pack) -> [[f64; LANES]; 1] {
        [four.lanes()]
    }

    #[inline(always)]
    fn columns(self, [[a, b, c, d]]: [[&Row; LANES]; 1]) -> [Pack; 6] {
        let mut columns = [Pack::ZERO; 6];
        for i in 0..6 {
            columns[i] = Pack::new([a[i], b[i], c[i], d[i]]);
        }
        columns
    }

    #[inline(always)]
    fn rows(self, columns: [Pack; 6]) -> [[Row; LANES]; 1] {
        let columns = columns.map(Pack::lanes);
        let mut rows = [[0.0; 6]; LANES];
        for (lane, row) in rows.iter_mut().enumerate() {
            for i in 0..6 {
                row[i] = columns[i][lane];
            }
        }
        [rows]
    }

    #[inline(always)]
    fn gathered(self, groups: impl Groups) -> [Pack; 6] {
        self.turned(groups.sums(self, 0))
    }
}

impl Fours for Baseline {
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
    type Numbers = Reals<L>;
    type Single = Self;

    #[inline(always)]
    fn single(self) -> Self {
        self
    }

    #[inline(always)]
    fn splat(self, value: f64) -> Reals<L> {
        self.same(value)
    }

    #[inline(always)]
    fn load(self, [pack]: [&Pack; 1]) -> Reals<L> {
        Lanes::read(self, pack.as_array())
    }

    #[inline(always)]
    fn read(self, [four]: &[[f64; LANES]; 1]) -> Reals<L> {
        Lanes::read(self, four)
    }

    #[inline(always)]
    fn store(self, four: Reals<L>) -> [[f64; LANES]; 1] {
        [Lanes::store(self, four.four)]
    }

    #[inline(always)]
    fn columns(self, [[a, b, c, d]]: [[&Row; LANES]; 1]) -> [Reals<L>; 6] {
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
    fn rows(self, [x, y, z, u, v, w]: [Reals<L>; 6]) -> [[Row; LANES]; 1] {
        let starts = Lanes::rows(self, [x.four, y.four, z.four, u.four]);
        let ends = self.rows_of_two([v.four, w.four]);
        let mut rows = [[0.0; 6]; LANES];
        for lane in 0..LANES {
            // Whole pieces: taken apart into numbers, they would be put together again across rows.
            let (start, end) = rows[lane].split_at_mut(LANES);
            start.copy_from_slice(&starts[lane]);
            end.copy_from_slice(&ends[lane]);
        }
        [rows]
    }

    #[inline(always)]
    fn gathered(self, groups: impl Groups) -> [Reals<L>; 6] {
        self.turned(groups.sums(self, 0))
    }
}

impl<L: Lanes> Fours for L {
    #[inline(always)]
    fn halves(self, row: &Row) -> [Reals<L>; 2] {
        let [x, y, z, u, v, w] = *row;
        [Lanes::read(self, &[x, y, z, u]), Lanes::read(self, &[z, u, v, w])]
    }

    #[inline(always)]
    fn turned(self, [a, b, c, d]: [[Reals<L>; 2]; LANES]) -> [Reals<L>; 6] {
        let [x, y, z, u] = Lanes::rows(self, [a[0].four, b[0].four, c[0].four, d[0].four]);
        let [_, _, v, w] = Lanes::rows(self, [a[1].four, b[1].four, c[1].four, d[1].four]);
        let mut columns = [self.same(0.0); 6];
        for (column, four) in columns.iter_mut().zip([x, y, z, u, v, w]) {
            *column = Lanes::read(self, &four);
        }
        columns
    }
}
