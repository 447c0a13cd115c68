//! Writes a wavy sheet of n × n nodes as a mesh, to see how large surfaces are read.
//!
//! `cargo run --release -p coque --example wavy_mesh -- 317 wavy.msh`, then `coque mesh wavy.msh`. The ending chooses
//! the format: .msh or .inp (quadrangles), .obj (triangles).

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [count, file] = &arguments[..] else {
        eprintln!("write: wavy_mesh COUNT FILE, such as wavy_mesh 317 wavy.msh");
        return ExitCode::from(2);
    };
    let ending = Path::new(file).extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let text = count.parse().ok().filter(|n| (2..=5000).contains(n)).and_then(|n| mesh(n, ending));
    let Some(text) = text else {
        eprintln!("the count must be from 2 to 5000, the ending .msh, .inp or .obj");
        return ExitCode::from(2);
    };
    match std::fs::write(file, text) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("cannot write {file}: {error}");
            ExitCode::from(2)
        }
    }
}

/// The sheet z = sin(x) sin(y) / 5 over a square of side 6, in the format of an ending.
fn mesh(n: usize, ending: &str) -> Option<String> {
    let at = |i: usize| 6.0 * i as f64 / (n - 1) as f64;
    let pairs = |n: usize| (0..n).flat_map(move |i| (0..n).map(move |j| (i, j)));
    let places: Vec<[f64; 3]> =
        pairs(n).map(|(i, j)| [at(i), at(j), 0.2 * libm::sin(at(i)) * libm::sin(at(j))]).collect();
    let corners = |(i, j): (usize, usize)| {
        let a = i * n + j + 1;
        [a, a + n, a + n + 1, a + 1]
    };
    let faces: Vec<[usize; 4]> = pairs(n - 1).map(corners).collect();
    let nodes = |line: fn(usize, [f64; 3]) -> String| -> String {
        (1..).zip(&places).map(|(a, x)| line(a, *x)).collect()
    };
    let cells = |line: fn(usize, [usize; 4]) -> String| -> String {
        (1..).zip(&faces).map(|(e, c)| line(e, *c)).collect()
    };
    Some(match ending {
        "msh" => format!(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n{}$EndElements\n",
            places.len(),
            nodes(|a, [x, y, z]| format!("{a} {x} {y} {z}\n")),
            faces.len(),
            cells(|e, [a, b, c, d]| format!("{e} 3 2 1 1 {a} {b} {c} {d}\n"))
        ),
        "inp" => format!(
            "*Node\n{}*Element, type=S4R\n{}",
            nodes(|a, [x, y, z]| format!("{a}, {x}, {y}, {z}\n")),
            cells(|e, [a, b, c, d]| format!("{e}, {a}, {b}, {c}, {d}\n"))
        ),
        "obj" => {
            nodes(|_, [x, y, z]| format!("v {x} {y} {z}\n"))
                + &cells(|_, [a, b, c, d]| format!("f {a} {b} {c}\nf {a} {c} {d}\n"))
        }
        _ => return None,
    })
}
