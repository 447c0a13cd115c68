//! Who moves which particles, and whose particles each has to know.
//!
//! Cells belong to those who march the fluid, along a curve, by the pairs that are looked at in them. A particle belongs to the owner
//! of the cell in which it was dealt out until all are dealt out anew, wherever it goes meanwhile; he moves it. Each knows his own and
//! all that stood in cells so near to his that no other can come into the sums of what he sweeps before none has gone farther than
//! [`FARTHEST`].
//!
//! With w the farthest way, D the reach of the kernel and cells of W = 1.02 D: particles that he moves or that stand in his cells are not
//! farther than w from these, those they see not farther than w + D now, so 2w + D then: two rings of cells. Points of walls that they
//! see take means of what they see in turn: 2w + 2D, three rings.

use std::ops::Range;

use peers::{Cut, Lists, Partner, along_curve};
use sph_core::Vec3;

use crate::cells::Grid;
use crate::sorted::Sorted;

/// How far a particle may go before all are dealt out anew, over the reach of the kernel: at most 0.52 by the above.
pub(crate) const FARTHEST: f64 = 0.5;
/// Owner of a cell that no particle can reach.
const NOBODY: u32 = u32::MAX;

/// Of one kind of particles: whose they are.
#[derive(Clone, Debug)]
pub(crate) struct Dealt {
    /// All, by owner, those of one by their numbers; and where those of each begin.
    pub order: Vec<u32>,
    pub cut: Cut,
}

impl Dealt {
    fn new(owners: &[u32], count: usize) -> Self {
        let mut order: Vec<u32> = (0..owners.len() as u32).collect();
        order.sort_by_key(|&i| owners[i as usize]);
        let border = |rank: usize| order.partition_point(|&i| (owners[i as usize] as usize) < rank);
        let cut = Cut::at((0..=count).map(border).collect());
        Self { order, cut }
    }
}

/// What one of several has to know.
#[derive(Clone, Debug)]
pub(crate) struct Deal {
    grid: Grid,
    /// By cell: its owner.
    owners: Vec<u32>,
    rank: u32,
    pub particles: Dealt,
    /// Numbers of the particles that he knows, ascending.
    pub known: Vec<u32>,
    /// By particle known: whether he moves it.
    pub moves: Vec<bool>,
    /// What is exchanged, by places among those known.
    pub lists: Lists,
    pub points: Dealt,
    /// The points of structures, by their numbers among these.
    pub wet: Dealt,
    /// By point of the boundary: whether its forces are his, and whether what he sweeps may see it.
    pub owns: Vec<bool>,
    pub near: Vec<bool>,
    /// Whether everyone knows all.
    pub everything: bool,
}

/// What is dealt out: all particles and points, in a grid; `everything` to be known by everyone.
pub(crate) struct All<'a> {
    pub dimensions: usize,
    pub grid: Grid,
    pub positions: &'a [Vec3],
    pub points: &'a [Vec3],
    /// Those of structures.
    pub wet: Range<usize>,
    pub everything: bool,
}

impl Deal {
    /// The share of a rank of so many. Everyone finds the same owners.
    pub fn new(all: &All<'_>, rank: usize, count: usize) -> Self {
        let All { dimensions, ref grid, positions, points, ref wet, everything } = *all;
        let mut sorted = Sorted::default();
        sorted.sort(1, grid, positions.len(), |i, _| Some(positions[i].into()));
        let rings = if points.is_empty() { 2 } else { 3 };
        let owners = owners(dimensions, grid, &sorted, count, rings);
        let rank = rank as u32;
        let mine = near(grid, rings, owners.iter().map(|&owner| owner == rank).collect());
        let place = |at: &Vec3| grid.nearest_cell(&(*at).into());
        let owner = |at: &Vec3| if owners[place(at)] == NOBODY { 0 } else { owners[place(at)] };
        let is_near = |at: &Vec3| everything || mine[place(at)];

        let of: Vec<u32> = positions.iter().map(owner).collect();
        let known: Vec<u32> = (0..).zip(positions).filter(|(_, at)| is_near(at)).map(|(i, _)| i).collect();
        let moves: Vec<bool> = known.iter().map(|&i| of[i as usize] == rank).collect();
        let mut partners: Vec<Partner> =
            (0..count).map(|rank| Partner { rank, send: Vec::new(), take: Vec::new() }).collect();
        let mut who: Vec<Option<Vec<u32>>> = vec![None; grid.len()];
        for (k, &i) in (0..).zip(&known) {
            if of[i as usize] != rank {
                partners[of[i as usize] as usize].take.push(k);
                continue;
            }
            let cell = place(&positions[i as usize]);
            let others = who[cell].get_or_insert_with(|| {
                let all = || (0..count as u32).collect();
                if everything { all() } else { about(grid, rings, cell, &owners) }
            });
            let others = others.iter().filter(|&&other| other != rank);
            others.for_each(|&other| partners[other as usize].send.push(k));
        }
        let of_points: Vec<u32> = points.iter().map(owner).collect();
        Self {
            rank,
            particles: Dealt::new(&of, count),
            moves,
            known,
            lists: Lists::new(partners),
            points: Dealt::new(&of_points, count),
            wet: Dealt::new(&of_points[wet.clone()], count),
            owns: of_points.iter().map(|&owner| owner == rank).collect(),
            near: points.iter().map(is_near).collect(),
            grid: grid.clone(),
            owners,
            everything,
        }
    }

    /// Whether this one adds what is in a cell of a grid of now.
    pub fn adds(&self, grid: &Grid, cell: usize) -> bool {
        let owner = self.owners[self.grid.nearest_cell_to(grid, cell)];
        owner == self.rank || owner == NOBODY && self.rank == 0
    }
}

/// By cell: who owns it. Those with particles are cut along a curve into parts of equal weight; empty ones around go with one beside them.
fn owners(dimensions: usize, grid: &Grid, sorted: &Sorted, count: usize, rings: usize) -> Vec<u32> {
    let particles = |cell: usize| u64::from(sorted.starts[cell + 1] - sorted.starts[cell]);
    let filled: Vec<usize> = (0..grid.len()).filter(|&cell| particles(cell) > 0).collect();
    let order = if dimensions == 2 {
        let places: Vec<[f64; 2]> =
            filled.iter().map(|&cell| grid.column(cell).map(|k| k as f64)).map(|[i, j, _]| [i, j]).collect();
        along_curve(&places)
    } else {
        let places: Vec<[f64; 3]> = filled.iter().map(|&cell| grid.column(cell).map(|k| k as f64)).collect();
        along_curve(&places)
    };
    let weight = |cell: usize| {
        let beside = grid.beside(cell as u32, &sorted.starts);
        particles(cell) * beside.filled().iter().map(|&(from, to)| u64::from(to - from)).sum::<u64>()
    };
    let whole: u128 = filled.iter().map(|&cell| u128::from(weight(cell))).sum();
    let mut owners = vec![NOBODY; grid.len()];
    let mut before = 0;
    for cell in order.iter().map(|&k| filled[k as usize]) {
        // A cell belongs to the part in which its middle lies.
        let own = u128::from(weight(cell));
        owners[cell] = ((2 * before + own) * count as u128 / (2 * whole)) as u32;
        before += own;
    }
    let mut front = filled;
    for _ in 0..rings {
        let mut next = Vec::new();
        for &cell in &front {
            let owner = owners[cell];
            grid.each_near(cell, 1, |other| {
                if owners[other] == NOBODY {
                    owners[other] = owner;
                    next.push(other);
                }
            });
        }
        front = next;
    }
    owners
}

/// Those who own cells so many rings about one.
fn about(grid: &Grid, rings: usize, cell: usize, owners: &[u32]) -> Vec<u32> {
    let mut found = Vec::new();
    grid.each_near(cell, rings, |other| {
        let owner = owners[other];
        if owner != NOBODY && !found.contains(&owner) {
            found.push(owner);
        }
    });
    found
}

/// The cells so many rings about those marked, themselves included.
fn near(grid: &Grid, rings: usize, mut marked: Vec<bool>) -> Vec<bool> {
    let counts = grid.counts();
    let mut stride = 1;
    for count in counts {
        let before = marked.clone();
        for (cell, mark) in marked.iter_mut().enumerate() {
            let k = cell / stride % count;
            let (low, high) = (rings.min(k), rings.min(count - 1 - k));
            *mark = (cell - low * stride..=cell + high * stride).step_by(stride).any(|other| before[other]);
        }
        stride *= count;
    }
    marked
}
