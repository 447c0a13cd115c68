//! Whether a surface has come through itself: edges against faces, without anything that contact itself uses to find them.

use contact::Mesh;
use sph_core::{CellList, Vec3};
use sph_shell::Shell;

/// Pairs of an edge and a face that cross.
pub fn crossings(shell: &Shell) -> usize {
    let cloud = &shell.reference().cloud;
    let mesh = Mesh::new(&cloud.cells, &cloud.positions, |_| 1.0);
    let place =
        |vertex: &u32| mesh.surface().vertices()[*vertex as usize].place(|a| shell.position(a as usize));
    let edges: Vec<[Vec3; 2]> = mesh.edges().iter().map(|ends| [0, 1].map(|i| place(&ends[i]))).collect();
    let middles: Vec<Vec3> = edges.iter().map(|[a, b]| (a + b) * 0.5).collect();
    let longest = edges.iter().map(|[a, b]| (b - a).norm()).fold(0.0, f64::max);
    let near = CellList::new(&middles, 2.0 * longest);
    let (mut found, mut count) = (Vec::new(), 0);
    for face in mesh.faces() {
        let corners = [0, 1, 2].map(|i| place(&face[i]));
        let middle = corners.iter().sum::<Vec3>() / 3.0;
        near.within(&middle, 1.5 * longest, &mut found);
        let apart = |edge: &&u32| mesh.edges()[**edge as usize].iter().all(|end| !face.contains(end));
        count += found.iter().filter(apart).filter(|edge| crosses(edges[**edge as usize], corners)).count();
    }
    count
}

/// Whether a segment goes through a triangle by more than rounding: cells that lie in one plane touch along it.
fn crosses([p, q]: [Vec3; 2], [a, b, c]: [Vec3; 3]) -> bool {
    let volume = |x: Vec3, y: Vec3, z: Vec3, w: Vec3| (y - x).cross(&(z - x)).dot(&(w - x));
    let rounding = 1e-10 * (q - p).norm() * (b - a).norm() * (c - a).norm();
    let sides = [volume(a, b, c, p), volume(a, b, c, q)];
    if sides[0].max(sides[1]) < rounding || sides[0].min(sides[1]) > -rounding {
        return false;
    }
    let around = [volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)];
    around.iter().all(|v| *v > rounding) || around.iter().all(|v| *v < -rounding)
}
