//! The tree of supernodes: which takes what from which.
//!
//! A supernode is a run of columns with the same rows below them. Its *front* is its columns and those rows. The parent of a supernode
//! has its first row below among its columns, and all of its rows in its own front: what it leaves goes to the parent alone
//! \[liu1992\]. What hangs below two children has nothing in common, and their work may be done at once.

use std::ops::Range;

use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::cholesky::SymbolicCholesky;

use crate::symbolic::{multiplications_of, supernodes};

/// Children are two tasks where each has at least this many multiplications: a task costs microseconds.
const WORTH_A_TASK: f64 = 2e5;
/// And at least this share of both: tasks within tasks are few then, and a stack holds them.
const SHARE_OF_A_TASK: f64 = 0.05;

/// What is done along the tree.
#[derive(Clone, Copy)]
pub(super) enum Work {
    /// The factor, from the leaves to the roots.
    Factor,
    /// A substitution with L, the same way.
    Forward,
    /// A substitution with Lᵀ, from the roots to the leaves.
    Back,
}

/// Neighbouring rows below a supernode that are neighbours in the front of its parent: place here, place there, number.
pub(super) struct Run {
    pub from: usize,
    pub to: usize,
    pub rows: usize,
}

/// Supernodes in an order in which each subtree is a run that ends with its root.
pub(crate) struct Tree {
    /// First column of each, and the number of columns.
    begin: Vec<usize>,
    /// Where the values of each begin, and their number: its columns, as high as its front.
    place: Vec<usize>,
    /// Rows below each, in rising order.
    rows: Lists<u32>,
    /// The same as runs in the front of the parent.
    runs: Lists<Run>,
    /// Children of each, and of none: the roots.
    children: Lists<u32>,
    /// Whether each is the first child of its parent.
    leads: Vec<bool>,
    /// First supernode of the subtree.
    first: Vec<usize>,
    /// First supernode of the second task below one that has two, else itself.
    middle: Vec<usize>,
    /// Those with two tasks that begin with a supernode, those with most of them last.
    tasks: Lists<u32>,
    /// Entries of the matrix in the columns of each: their number, their place among its values.
    entries: Lists<(u32, u32)>,
}

/// A supernode: its columns `begin..end`, the rows below them, and its values.
pub(super) struct Supernode<'a> {
    pub begin: usize,
    pub rows: &'a [u32],
    pub values: &'a [f64],
}

impl<'a> Supernode<'a> {
    /// Columns in order: number, pivot, what is below it in the square, what is below the square.
    pub fn columns(
        &self,
        width: usize,
    ) -> impl Iterator<Item = (usize, f64, &'a [f64], &'a [f64])> + use<'a> {
        let begin = self.begin;
        self.values.chunks_exact(width + self.rows.len()).enumerate().map(move |(j, column)| {
            let (square, rest) = column.split_at(width);
            (begin + j, square[j], &square[j + 1..], rest)
        })
    }
}

impl Tree {
    /// The tree of the analysis of a lower triangle.
    pub fn new(symbolic: &SymbolicCholesky<usize>, matrix: SymbolicSparseColMatRef<usize>) -> Self {
        let supernodes = supernodes(symbolic);
        let (count, columns) = (supernodes.n_supernodes(), symbolic.nrows());
        let begin: Vec<usize> =
            supernodes.supernode_begin()[..count].iter().copied().chain([columns]).collect();
        let mut of = vec![0; columns];
        (0..count).for_each(|s| of[begin[s]..begin[s + 1]].fill(s));
        let below = |s: usize| supernodes.supernode(s).pattern();
        let mut children = vec![Vec::new(); count + 1];
        let mut first: Vec<usize> = (0..=count).collect();
        let mut leads = vec![false; count];
        for s in 0..count {
            let parent = below(s).first().map_or(count, |&row| of[row]);
            leads[s] = children[parent].is_empty();
            children[parent].push(s as u32);
            first[parent] = first[parent].min(first[s]);
        }
        let mut tree = Self {
            begin,
            place: supernodes.col_ptr_for_val().to_vec(),
            rows: Lists::new((0..count).map(|s| below(s).iter().map(|&row| row as u32))),
            runs: Lists::new(std::iter::empty::<Vec<Run>>()),
            children: Lists::new(children),
            leads,
            first,
            middle: Vec::new(),
            tasks: Lists::new(std::iter::empty::<Vec<u32>>()),
            entries: Lists::new(std::iter::empty::<Vec<(u32, u32)>>()),
        };
        debug_assert!((0..=count).all(|s| tree.is_in_postorder(s)));
        tree.connect(symbolic, matrix, &of);
        tree.share();
        tree
    }

    /// Whether the subtrees of a supernode's children end right before it, one right after the other.
    fn is_in_postorder(&self, s: usize) -> bool {
        let end = self.children(s).iter().try_fold(self.first[s], |next, &child| {
            (self.first[child as usize] == next).then_some(child as usize + 1)
        });
        end == Some(s)
    }

    /// Places of rows in the fronts of the parents, and of the entries of the matrix among the values.
    fn connect(
        &mut self,
        symbolic: &SymbolicCholesky<usize>,
        matrix: SymbolicSparseColMatRef<usize>,
        of: &[usize],
    ) {
        let ordered = symbolic.perm().map(|perm| perm.arrays().1);
        let to = |unknown: usize| ordered.map_or(unknown, |to| to[unknown]);
        let mut entries = vec![Vec::new(); self.count()];
        for column in 0..matrix.ncols() {
            for slot in matrix.col_range(column) {
                let (a, b) = (to(matrix.row_idx()[slot]), to(column));
                entries[of[a.min(b)]].push((slot, a.max(b), a.min(b)));
            }
        }
        let mut local = vec![0; self.columns()];
        let mut runs: Vec<Vec<Run>> = (0..self.count()).map(|_| Vec::new()).collect();
        for (s, entries) in entries.iter_mut().enumerate() {
            let (begin, height) = (self.begin[s], self.height(s));
            (0..self.width(s)).for_each(|j| local[begin + j] = j);
            self.rows(s).iter().zip(self.width(s)..).for_each(|(&row, place)| local[row as usize] = place);
            for &child in self.children(s) {
                let rows = self.rows(child as usize).iter().map(|&row| local[row as usize]);
                runs[child as usize] = in_runs(rows);
            }
            entries.iter_mut().for_each(|(_, row, column)| *row = local[*row] + (*column - begin) * height);
            entries.sort_unstable_by_key(|&(_, place, _)| place);
        }
        self.runs = Lists::new(runs);
        let two = |&(slot, place, _): &(usize, usize, usize)| (slot as u32, place as u32);
        self.entries = Lists::new(entries.iter().map(|own| own.iter().map(two)));
    }

    /// Whose children are two tasks: by the tree alone, whatever the number of threads.
    fn share(&mut self) {
        let count = self.count();
        let mut work = vec![0.0; count];
        let mut tasks = vec![Vec::new(); count + 1];
        for s in 0..=count {
            let children = self.children(s);
            let all: f64 = children.iter().map(|&child| work[child as usize]).sum();
            let (mut before, mut most, mut middle) = (0.0, 0.0, s);
            for &child in children {
                let less = f64::min(before, all - before);
                if less > most {
                    (most, middle) = (less, self.first[child as usize]);
                }
                before += work[child as usize];
            }
            // Roots have no parent that would wait for both.
            if s == count || most < WORTH_A_TASK || most < SHARE_OF_A_TASK * all {
                middle = s;
            } else {
                tasks[self.first[s]].push(s as u32);
            }
            self.middle.push(middle);
            if s < count {
                work[s] = all + multiplications_of(self.width(s), self.rows(s).len());
            }
        }
        self.tasks = Lists::new(tasks);
    }

    /// Number of supernodes; as a supernode it stands for the parent of the roots.
    pub fn count(&self) -> usize {
        self.begin.len() - 1
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.begin[self.count()]
    }

    /// Number of values.
    pub fn values(&self) -> usize {
        self.place[self.count()]
    }

    /// First column of a supernode.
    pub fn begin(&self, s: usize) -> usize {
        self.begin[s]
    }

    /// Columns of a supernode; none of the parent of the roots.
    pub fn width(&self, s: usize) -> usize {
        self.begin.get(s + 1).map_or(0, |end| end - self.begin[s])
    }

    /// Rows of its front.
    pub fn height(&self, s: usize) -> usize {
        self.width(s) + self.rows(s).len()
    }

    /// Rows below its columns.
    pub fn rows(&self, s: usize) -> &[u32] {
        self.rows.get(s)
    }

    /// The same as runs in the front of the parent.
    pub fn runs(&self, s: usize) -> &[Run] {
        self.runs.get(s)
    }

    /// Entries of the matrix in its columns, and their places among its values.
    pub fn entries(&self, s: usize) -> &[(u32, u32)] {
        self.entries.get(s)
    }

    /// Its children.
    pub fn children(&self, s: usize) -> &[u32] {
        self.children.get(s)
    }

    /// Whether it is the first child of its parent.
    pub fn leads(&self, s: usize) -> bool {
        self.leads[s]
    }

    /// First supernode below it, itself where there is none.
    pub fn first(&self, s: usize) -> usize {
        self.first[s]
    }

    /// First supernode of the second of the two tasks below it; itself where there is one.
    pub fn middle(&self, s: usize) -> usize {
        self.middle[s]
    }

    /// Of those that begin with a supernode and have two tasks the largest before an end.
    pub fn task(&self, first: usize, end: usize) -> Option<usize> {
        self.tasks.get(first).iter().rev().map(|&s| s as usize).find(|&s| s < end)
    }

    /// Numbers that supernodes have for some work: values, or one for each column.
    pub fn extent(&self, range: Range<usize>, work: Work) -> usize {
        let of = match work {
            Work::Factor => &self.place,
            Work::Forward | Work::Back => &self.begin,
        };
        of[range.end] - of[range.start]
    }

    /// Numbers that a supernode leaves for its parent.
    pub fn update(&self, s: usize, work: Work) -> usize {
        let below = self.rows(s).len();
        match work {
            Work::Factor => below * below,
            Work::Forward | Work::Back => below,
        }
    }

    /// Numbers that its children leave for it.
    pub fn updates(&self, s: usize, work: Work) -> usize {
        self.children(s).iter().map(|&child| self.update(child as usize, work)).sum()
    }

    /// A supernode of a factor.
    pub fn supernode<'a>(&'a self, values: &'a [f64], s: usize) -> Supernode<'a> {
        Supernode {
            begin: self.begin[s],
            rows: self.rows(s),
            values: &values[self.place[s]..self.place[s + 1]],
        }
    }
}

fn in_runs(places: impl Iterator<Item = usize>) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for (from, to) in places.enumerate() {
        match runs.last_mut() {
            Some(run) if run.to + run.rows == to => run.rows += 1,
            _ => runs.push(Run { from, to, rows: 1 }),
        }
    }
    runs
}

/// Lists one after the other.
struct Lists<T> {
    starts: Vec<usize>,
    all: Vec<T>,
}

impl<T> Lists<T> {
    fn new(lists: impl IntoIterator<Item = impl IntoIterator<Item = T>>) -> Self {
        let (mut starts, mut all) = (vec![0], Vec::new());
        for list in lists {
            all.extend(list);
            starts.push(all.len());
        }
        Self { starts, all }
    }

    /// A list; empty beyond the last.
    fn get(&self, k: usize) -> &[T] {
        self.starts.get(k + 1).map_or(&[], |&end| &self.all[self.starts[k]..end])
    }
}
