//! Shares of lattices: a sheet of cells, swept one by one or in packs, and a block whose bonds reach three spacings.

use peers::{Cut, Lists, along_curve, plan};

/// How a lattice is numbered.
#[derive(Clone, Copy, Debug)]
pub enum Numbering {
    Rows,
    Curve,
}

/// A cut of a lattice into equal shares of whole chunks, as means over all peers.
#[derive(Debug)]
pub struct Shares {
    pub most_over_mean: f64,
    pub ghosts_over_own: f64,
    pub partners: f64,
    /// What the peer that sends most sends, in rows.
    pub sent: usize,
}

/// Points of a square: a peer needs all points of a pack of cells of which it owns any. Cells are numbered as points are.
pub fn sheet(side: usize, pack: usize, numbering: Numbering, peers: usize) -> Shares {
    let number = numbers([side; 2], numbering);
    let cut = Cut::by_weights(&vec![1; number.len()], peers);
    let corners = |first: usize| [0, 1, side, side + 1].map(|step| number[first + step]);
    let mut cells = vec![[0; 4]; (side - 1) * (side - 1)];
    for (cell, n) in numbers([side - 1; 2], numbering).into_iter().enumerate() {
        cells[n as usize] = corners(cell / (side - 1) * side + cell % (side - 1));
    }
    let mut needs = vec![Vec::new(); peers];
    for pack in cells.chunks(pack) {
        let points = pack.as_flattened();
        let mut owners: Vec<usize> = points.iter().map(|&a| cut.owner(a as usize)).collect();
        owners.sort_unstable();
        owners.dedup();
        owners.into_iter().for_each(|owner| needs[owner].extend(points));
    }
    shares(&cut, &needs)
}

/// Points of a cube: a peer needs all within three spacings of its own.
pub fn block(side: usize, numbering: Numbering, peers: usize) -> Shares {
    let number = numbers([side; 3], numbering);
    let cut = Cut::by_weights(&vec![1; number.len()], peers);
    let mut order = vec![0; number.len()];
    number.iter().enumerate().for_each(|(point, &n)| order[n as usize] = point);
    let near = |x: usize| x.saturating_sub(3)..(x + 4).min(side);
    let mut last = vec![usize::MAX; number.len()];
    let mut needs = vec![Vec::new(); peers];
    for (rank, needs) in needs.iter_mut().enumerate() {
        for &point in &order[cut.own(rank)] {
            let [x, y, z] = coordinates(point, side);
            for (i, j, k) in near(z).flat_map(|k| near(y).flat_map(move |j| near(x).map(move |i| (i, j, k))))
            {
                let far = i.abs_diff(x).pow(2) + j.abs_diff(y).pow(2) + k.abs_diff(z).pow(2) > 9;
                let other = i + side * (j + side * k);
                if !far && std::mem::replace(&mut last[other], rank) != rank {
                    needs.push(number[other]);
                }
            }
        }
    }
    shares(&cut, &needs)
}

fn coordinates<const D: usize>(point: usize, side: usize) -> [usize; D] {
    std::array::from_fn(|i| point / side.pow(i as u32) % side)
}

/// The number of each point, which are counted in rows.
fn numbers<const D: usize>(sides: [usize; D], numbering: Numbering) -> Vec<u32> {
    let points = sides.iter().product();
    match numbering {
        Numbering::Rows => (0..points as u32).collect(),
        Numbering::Curve => {
            let places: Vec<[f64; D]> =
                (0..points).map(|point| coordinates(point, sides[0]).map(|x| x as f64)).collect();
            let mut number = vec![0; points];
            (0..).zip(along_curve(&places)).for_each(|(n, point)| number[point as usize] = n);
            number
        }
    }
}

fn shares(cut: &Cut, needs: &[Vec<u32>]) -> Shares {
    let lists = plan(cut, needs);
    let (points, peers) = (cut.particles(), cut.peers() as f64);
    let ghosts: usize = lists.iter().map(Lists::ghosts).sum();
    let partners: usize = lists.iter().map(|lists| lists.partners().len()).sum();
    Shares {
        most_over_mean: cut.most_over_mean(&vec![1; points]),
        ghosts_over_own: ghosts as f64 / points as f64,
        partners: partners as f64 / peers,
        sent: lists.iter().map(Lists::sent).max().unwrap_or(0),
    }
}
