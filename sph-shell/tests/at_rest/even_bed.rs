//! Beds over lines and areas meet every linear motion with the stiffness and the moments of an even bed.

use crate::common::{disordered_flat, flat};
use sph_core::{Cloud, Side, Vec3};
use sph_shell::even_bed;

const SIZE: [f64; 2] = [3.0, 2.0];

/// `∫ f² / ∫ 1` by the bed.
fn mean(cloud: &Cloud, particles: &[u32], f: impl Fn(&Vec3) -> f64) -> f64 {
    let bed = even_bed(cloud, particles);
    let at = |a: u32| f(&cloud.positions[a as usize]);
    let apart = |[a, b]: [u32; 2]| at(a) - at(b);
    bed.shares.iter().map(|&(a, share)| share * at(a) * at(a)).sum::<f64>()
        - bed.pairs.iter().map(|&(pair, part)| part * apart(pair) * apart(pair)).sum::<f64>()
}

#[test]
fn linear_motions_meet_an_even_bed() {
    let [a, b] = SIZE;
    for (name, cloud) in [
        ("one", flat([2, 2], SIZE)),
        ("three", flat([3, 4], SIZE)),
        ("even", flat([7, 5], SIZE)),
        ("uneven", disordered_flat([7, 5], SIZE)),
    ] {
        let all: Vec<u32> = (0..cloud.len() as u32).collect();
        let edge = cloud.sides.as_ref().unwrap().edge(Side::V0).to_vec();
        let mut lines = vec![edge];
        lines.extend(
            cloud.lattice.filter(|_| name == "three" || name == "even").map(|lattice| lattice.row(1)),
        );
        let mut off = lines
            .iter()
            .flat_map(|line| {
                let apart = |x: &Vec3| x.x - a / 2.0;
                [
                    mean(&cloud, line, |_| 1.0) - 1.0,
                    mean(&cloud, line, |x| x.x) - a * a / 3.0,
                    mean(&cloud, line, apart) - a * a / 12.0,
                ]
            })
            .collect::<Vec<f64>>();
        let turned = |x: &Vec3| 0.7 * (x.x - a / 2.0) - 0.4 * (x.y - b / 2.0);
        off.push(mean(&cloud, &all, |_| 1.0) - 1.0);
        off.push(mean(&cloud, &all, |x| x.y) - b * b / 3.0);
        off.push(mean(&cloud, &all, turned) - (0.49 * a * a + 0.16 * b * b) / 12.0);
        let most = off.iter().fold(0.0_f64, |most, off| most.max(off.abs()));
        println!("{name}: {most:.1e}");
        assert!(most < 1e-13, "{name}: {off:?}");
    }
}

/// Lines share by lengths, as forces do; particles without an edge between them share equally, and of a rim nothing is left over.
#[test]
fn lines_share_by_lengths_and_single_particles_equally() {
    let cloud = flat([7, 5], [6.0, 4.0]);
    let edge = cloud.sides.as_ref().unwrap().edge(Side::V0).to_vec();
    for ((_, share), weight) in
        even_bed(&cloud, &edge).shares.into_iter().zip([0.5, 1.0, 1.0, 1.0, 1.0, 1.0, 0.5])
    {
        assert!((6.0 * share - weight).abs() < 1e-14, "{share} {weight}");
    }
    let corners = even_bed(&cloud, &[edge[0], edge[6]]);
    assert!(corners.pairs.is_empty() && corners.shares.iter().all(|share| share.1 == 0.5));
    let rim: Vec<u32> = (0..cloud.len() as u32).filter(|&a| cloud.edge_lengths[a as usize] > 0.0).collect();
    let rim = even_bed(&cloud, &rim);
    assert!(rim.pairs.len() == 20 && rim.shares.iter().all(|share| (share.1 * 20.0 - 1.0).abs() < 1e-14));
}
