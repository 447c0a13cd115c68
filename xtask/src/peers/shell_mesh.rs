//! Square meshes of shells with eight nodes an element, as CalculiX reads them: n elements a side.

use std::fmt::Write;

/// Sides of the square of parameters, and one of its corners.
pub const SETS: [&str; 5] = ["U0", "U1", "V0", "V1", "U1V0"];

/// `*NODE`, `*ELEMENT` and `*NSET` of n × n elements, nodes at places of parameters (u, v) from zero to one.
///
/// Sets: all nodes NALL, all elements EALL, the sides U0, U1, V0, V1, the corner U1V0.
pub fn deck(kind: &str, n: usize, place: impl Fn(f64, f64) -> [f64; 3]) -> String {
    let side = 2 * n + 1;
    let number = |i: usize, j: usize| 1 + i + side * j;
    let mut text = "*NODE, NSET=NALL\n".to_owned();
    for (i, j) in nodes(side) {
        let [x, y, z] = place(i as f64 / (side - 1) as f64, j as f64 / (side - 1) as f64);
        let _ = writeln!(text, "{}, {x:.14}, {y:.14}, {z:.14}", number(i, j));
    }
    let _ = writeln!(text, "*ELEMENT, TYPE={kind}, ELSET=EALL");
    for element in 0..n * n {
        let (i, j) = (2 * (element % n), 2 * (element / n));
        // Corners in turn, then the middles of the sides between them.
        let steps = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)];
        let of = steps.map(|(a, b)| number(i + a, j + b).to_string());
        let _ = writeln!(text, "{}, {}", element + 1, of.join(", "));
    }
    for set in SETS {
        let _ = writeln!(text, "*NSET, NSET={set}");
        for (i, j) in nodes(side).filter(|&(i, j)| lies_on(set, i, j, side - 1)) {
            let _ = writeln!(text, "{},", number(i, j));
        }
    }
    text
}

/// The nodes of a mesh: corners and middles of sides, no middles of elements.
fn nodes(side: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..side * side).map(move |k| (k % side, k / side)).filter(|(i, j)| i % 2 == 0 || j % 2 == 0)
}

fn lies_on(set: &str, i: usize, j: usize, end: usize) -> bool {
    match set {
        "U0" => i == 0,
        "U1" => i == end,
        "V0" => j == 0,
        "V1" => j == end,
        _ => i == end && j == 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_elements_a_side_have_their_nodes_and_sides() {
        let text = deck("S8R", 2, |u, v| [u, v, 0.0]);
        let block = |from: &str| -> Vec<&str> {
            text.lines()
                .skip_while(|line| *line != from)
                .skip(1)
                .take_while(|line| !line.starts_with('*'))
                .collect()
        };
        let nodes = block("*NODE, NSET=NALL");
        assert_eq!(nodes.len(), 21);
        assert_eq!(nodes[1], "2, 0.25000000000000, 0.00000000000000, 0.00000000000000");
        let elements = block("*ELEMENT, TYPE=S8R, ELSET=EALL");
        assert_eq!(elements.len(), 4);
        assert_eq!(elements[3], "4, 13, 15, 25, 23, 14, 20, 24, 18");
        assert_eq!(block("*NSET, NSET=U0"), ["1,", "6,", "11,", "16,", "21,"]);
        assert_eq!(block("*NSET, NSET=V1"), ["21,", "22,", "23,", "24,", "25,"]);
        assert_eq!(block("*NSET, NSET=U1V0"), ["5,"]);
    }
}
