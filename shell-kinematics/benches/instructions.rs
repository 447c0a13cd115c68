//! Instructions and time of one point of a shell, by section: resultants of an elastic one, and of six slices at rest and in flow with and without
//! the new history.
//!
//! The program runs itself under `valgrind --tool=callgrind` twice, for some points and for more, and prints the difference. Without valgrind it
//! prints times alone. Four points lie side by side in the widest registers of the machine; a point is one of the four.

use std::hint::black_box;
use std::process::Command;
use std::time::Instant;

use lanes::{Lanes, Sweep, widest};
use shell_kinematics::{
    Hardening, Isotropic, IsotropicSection, LANES, Memory, Pack, Plastic, PlasticSection, SectionOf, Strains,
};

const PACKS: [usize; 2] = [1000, 5000];
const TIMED: usize = 20_000;
const REPEATS: usize = 30;

/// What is counted: its name, the curve, the strain over that of first yield, and whether the history is written.
const CASES: [(&str, Curve, f64, bool); 8] = [
    ("elastic section", Curve::None, 0.5, false),
    ("six slices, none flows", Curve::Linear, 0.5, false),
    ("six slices, none flows, with history", Curve::Linear, 0.5, true),
    ("six slices, all flow, linear", Curve::Linear, 20.0, false),
    ("six slices, all flow, linear, with history", Curve::Linear, 20.0, true),
    ("six slices, all flow, Voce", Curve::Voce, 20.0, false),
    ("six slices, all flow, Swift", Curve::Swift, 20.0, false),
    ("six slices, all flow, table of four", Curve::Table, 20.0, false),
];

#[derive(Clone, Copy, Debug)]
enum Curve {
    None,
    Linear,
    Voce,
    Swift,
    Table,
}

impl Curve {
    fn hardening(self) -> Hardening {
        let made = match self {
            Self::None | Self::Linear => Hardening::linear(250.0, 1000.0),
            Self::Voce => Hardening::voce(250.0, 200.0, 12.0),
            Self::Swift => Hardening::swift(500.0, 0.01, 0.2),
            Self::Table => Hardening::table(&[[0.0, 250.0], [0.02, 300.0], [0.1, 360.0], [0.3, 420.0]]),
        };
        made.expect("a hardening")
    }
}

/// Evaluations of four points, again and again from the history of rest.
struct Points<'a> {
    elastic: Option<&'a IsotropicSection>,
    section: &'a PlasticSection,
    strains: &'a Strains,
    history: &'a [Pack],
    trial: &'a mut [Pack],
    writes: bool,
    count: usize,
}

impl Sweep for Points<'_> {
    type Output = f64;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> f64 {
        let mut sum = lanes.same(0.0);
        for _ in 0..self.count {
            let strains = black_box(self.strains);
            let read = |pack: Pack| lanes.read(pack.as_array());
            let strains = Strains {
                membrane: [read(strains.membrane[0]), read(strains.membrane[1]), read(strains.membrane[2])],
                curvature: [
                    read(strains.curvature[0]),
                    read(strains.curvature[1]),
                    read(strains.curvature[2]),
                ],
                shear: [read(strains.shear[0]), read(strains.shear[1])],
            };
            let committed = |i: usize| lanes.read(self.history[i].as_array());
            let found = if let Some(elastic) = self.elastic {
                elastic.resultants_of(&strains)
            } else if self.writes {
                self.section.commit_in(&strains, f64::INFINITY, committed, |i, number| {
                    self.trial[i] = Pack::new(number.pack())
                })
            } else {
                self.section.resultants_in(&strains, committed)
            };
            for i in 0..3 {
                sum += found.membrane[i] + found.moment[i];
            }
            sum += found.shear[0] + found.shear[1];
        }
        sum.total()
    }
}

/// That many packs of a case.
fn run((_, curve, times, writes): (&str, Curve, f64, bool), count: usize) -> f64 {
    let material = Isotropic::new(200e3, 0.3).expect("a material");
    let elastic = IsotropicSection::new(material, 1.0).expect("a section");
    let section = PlasticSection::new(Plastic::new(material, curve.hardening()), 1.0, 6).expect("a section");
    let at = times * 250.0 / 200e3;
    let spread = |factor: f64| Pack::from_fn(|lane| at * factor * (1.0 + 0.1 * lane as f64));
    let strains = Strains {
        membrane: [spread(1.0), spread(0.2), spread(0.3)],
        curvature: [spread(0.2), spread(-0.1), spread(0.1)],
        shear: [spread(0.1), spread(0.1)],
    };
    let history = vec![Pack::ZERO; section.history_len()];
    let mut trial = history.clone();
    let elastic = matches!(curve, Curve::None).then_some(&elastic);
    let points = Points {
        elastic,
        section: &section,
        strains: &strains,
        history: &history,
        trial: &mut trial,
        writes,
        count,
    };
    widest(points)
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, child, which, count] = &arguments[..]
        && child == "--child"
    {
        let case = CASES[which.parse::<usize>().expect("a number")];
        black_box(run(case, count.parse().expect("a number")));
        return;
    }
    for (which, case) in CASES.into_iter().enumerate() {
        let nanoseconds = (0..REPEATS).fold(f64::INFINITY, |least, _| {
            let start = Instant::now();
            black_box(run(case, TIMED));
            least.min(start.elapsed().as_nanos() as f64 / (TIMED * LANES) as f64)
        });
        let counts = PACKS.map(|packs| count(which, packs));
        let instructions = match counts {
            [Some(few), Some(many)] => {
                format!("{:.0} instructions", (many - few) as f64 / ((PACKS[1] - PACKS[0]) * LANES) as f64)
            }
            _ => "instructions not counted: valgrind is not here".to_string(),
        };
        println!("{}: {instructions}, {nanoseconds:.1} ns a point", case.0);
    }
}

/// Instructions of a whole child run, from callgrind's closing line `Collected : N`.
fn count(which: usize, packs: usize) -> Option<u64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(std::env::current_exe().ok()?)
        .args(["--child", &which.to_string(), &packs.to_string()])
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = text.lines().find(|line| line.contains("Collected :"))?;
    line.rsplit(' ').next()?.parse().ok()
}
