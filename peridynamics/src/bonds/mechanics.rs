//! What resists: bonds between nodes, or two sheets of bonds on directors.

use implicit_statics::BlockPattern;
use nalgebra::Matrix3;

use super::couplings::Coupling;
use super::flow::Past;
use super::network::Row;
use crate::share::{Reach, Share};
use crate::unknowns::Unknowns;

/// The stored energy of a body as a function of its rows, and how bonds break.
pub(crate) trait Mechanics: Send + Sync {
    /// Internal forces `∂U/∂row` of own rows; returns the stored energy \[F L\], zero unless wanted.
    ///
    /// The last places of the rows are the mechanics' own. With `watch` it notes the bonds beyond their limit, for
    /// [`Mechanics::break_bonds`].
    fn evaluate(&mut self, rows: &mut [Row], forces: &mut [Row], wanted: Evaluation<'_>) -> f64;

    /// Second derivatives at `rows` times the displacements `along`, into `out`; the last places of all are its own.
    fn tangent(&mut self, rows: &mut [Row], along: &mut [Row], out: &mut [Row], share: &Share);

    /// Whether bonds may break.
    fn breaks(&self) -> bool;

    /// Whether bonds of own nodes were beyond their limit in the last evaluation.
    fn noted(&self, share: &Share) -> bool;

    /// Breaks the bonds noted in the last evaluation; returns the energy that the body loses at these rows, whose last
    /// places do not matter \[F L\].
    fn break_bonds(&mut self, rows: &[Row], share: &Share) -> f64;

    /// How far the bond that is nearest to its limit is taken in the rows last evaluated, one at the limit; zero where none breaks.
    fn utilisation(&self, rows: &[Row]) -> f64;

    /// Breaks the bonds taken so far or further in the rows last evaluated; counts a part of the energy that the body loses, and
    /// returns it \[F L\].
    fn break_from(&mut self, least: f64, counted: f64, rows: &[Row], share: &Share) -> f64;

    /// Pairs of rows with second derivatives, by all bonds, whole or broken.
    fn couplings(&self) -> BlockPattern;

    /// Second derivatives `∂²U/∂row∂row` at a state, one block a pair of the pattern; with a second state, the pulls of bonds
    /// are taken from there, all else from the first.
    fn second_derivatives(
        &self,
        states: (&[Row], Option<&[Row]>),
        pattern: &BlockPattern,
        blocks: &mut [Coupling],
        threads: usize,
    );

    /// `Σⱼ |K_ij|` over the unknowns at a state, or a bound of it, without a matrix; false where none is known.
    fn row_sums(&self, _rows: &[Row], _unknowns: &Unknowns, _out: &mut [f64]) -> bool {
        false
    }

    /// Whether the stiff directions of a body stay about where they are at rest, as those of a thin plate do: its deflection is
    /// softer than its plane, and a relaxation may move it with less mass.
    fn keeps_directions(&self) -> bool {
        false
    }

    /// The least of present over reference length of whole bonds, and the node that has it.
    fn shortest(&self, rows: &[Row]) -> (usize, f64);

    /// Memory of the bonds \[bytes\].
    fn bytes(&self) -> usize;

    /// Directed bonds.
    fn bonds(&self) -> usize;

    /// Pairs of nodes with the stiffness of the whole bonds between them, images counted with their nodes \[F/L\]; none of what is not made of bonds alone.
    fn pairs(&self) -> Option<Vec<(u32, u32, f64)>> {
        None
    }

    /// Bound of what contact adds to eigenvalues of the mass-scaled stiffness \[1/T²\].
    fn contact_spectrum(&self) -> f64 {
        0.0
    }

    /// The broken part of a node's family, by volume: zero whole, one free.
    fn damage(&self, node: usize) -> f64;

    /// The damage of a column in the upper sheet and in the lower one; none but of a plate of two.
    fn damage_of_sheets(&self, _node: usize) -> Option<[f64; 2]> {
        None
    }

    /// Energy that the broken bonds of a node held, half of each bond's \[F L\].
    fn fracture_energy(&self, node: usize) -> f64;

    /// Energy stored in the bonds of a node, for the rows last evaluated \[F L\].
    fn stored(&self, rows: &[Row], node: usize) -> f64;

    /// Volume times stress of a node, for the rows last evaluated \[F L\].
    fn virial(&self, rows: &[Row], node: usize) -> Matrix3<f64>;

    /// What the bonds of a node pull along an axis through its plane of symmetry on a side, −1 or 1, for the rows last evaluated
    /// \[F\].
    fn across(&self, rows: &[Row], node: usize, plane: (usize, i32)) -> f64;

    /// Nodes of each fragment.
    fn fragments(&self) -> Vec<usize>;

    /// Arrays of all that changes as bonds break.
    fn broken(&self) -> [Vec<f64>; 3];

    /// Takes up such arrays of the same body; false, and nothing changed, for those of another.
    fn take_up(&mut self, broken: [&[f64]; 3]) -> bool;

    /// Whether bonds yield.
    fn yields(&self) -> bool {
        false
    }

    /// Keeps what flowed in the rows last evaluated; returns the plastic work \[F L\].
    fn keep_flow(&mut self, _rows: &[Row], _share: &Share) -> f64 {
        0.0
    }

    /// What a node went through; nothing where bonds do not yield.
    fn past(&self, _node: usize) -> Option<Past> {
        None
    }

    /// Arrays of all that flow changes.
    fn flowed(&self) -> [Vec<f64>; 2] {
        Default::default()
    }

    /// Takes up such arrays of the same body; false, and nothing changed, for those of another.
    fn take_up_flow(&mut self, flowed: [&[f64]; 2]) -> bool {
        flowed.iter().all(|array| array.is_empty())
    }

    /// What its nodes need of each other.
    ///
    /// # Errors
    /// What is marched by one alone, in words.
    fn reach(&self) -> Result<Reach<'_>, &'static str>;

    /// Warms it by what each node would be strained by were it free, at level one \[–\]; returns the norm of what its bonds would pull with were
    /// they held \[F\]; none of what does not expand.
    fn warm(&mut self, _strains: &[f64]) -> Option<f64> {
        None
    }

    /// Gives it the lengths of a level of heat.
    fn expand(&mut self, _level: f64) {}

    /// Brings all that is read of nodes beside rows and forces to all who march it.
    fn bring(&mut self, share: &Share);
}

/// What an evaluation does.
#[derive(Clone, Copy)]
pub(crate) struct Evaluation<'a> {
    /// Whether the stored energy is summed.
    pub energy: bool,
    /// Whether bonds are held against their limits.
    pub watch: bool,
    /// Whose bonds are swept.
    pub share: &'a Share,
}
