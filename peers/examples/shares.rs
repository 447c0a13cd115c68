//! Balance, ghosts and partners of lattices cut in rows and along the curve: `cargo run -p peers --example shares`.

#[path = "../tests/lattice/mod.rs"]
mod lattice;

use lattice::{Numbering, Shares, block, sheet};

/// One line; rows are of so many numbers.
fn line(name: &str, numbering: Numbering, peers: usize, shares: &Shares, width: usize) {
    let numbering = format!("{numbering:?}");
    let Shares { most_over_mean, ghosts_over_own, partners, sent } = shares;
    let sent = (8 * width * sent) as f64 / 1e3;
    println!(
        "{name:<24}{numbering:<6}{peers:>6}{most_over_mean:>11.3}{ghosts_over_own:>12.3}{partners:>10.1}{sent:>12.1}"
    );
}

fn main() {
    println!(
        "lattice                 by     peers  most/mean  ghosts/own  partners  kB sent by one a step, at most"
    );
    for numbering in [Numbering::Rows, Numbering::Curve] {
        for (side, pack, peers) in
            [(100, 4, 2), (316, 4, 2), (1000, 4, 2), (1000, 4, 16), (1000, 4, 64), (1000, 1, 64)]
        {
            let name = format!("sheet {side}², packs of {pack}");
            line(&name, numbering, peers, &sheet(side, pack, numbering, peers), 6);
        }
        for peers in [8, 64] {
            line("block 64³, horizon 3", numbering, peers, &block(64, numbering, peers), 3);
        }
    }
}
