//! Forces that supports exert, node by node.
//!
//! What the internal forces lack of the loads is borne by the conditions: with rows `A_c = φ(X_c) n_c` of the equations
//! `Σ_J φ_J(X_I) n·d_J = λū` there are multipliers with `Aᵀμ = f_int − f_ext`, and `μ_c n_c` is the force of the support on the node
//! of row c: it does the work `μ_c n_c·u(X_c)`. In equilibrium they are exact; where they are not unique, rows that depend on others
//! bear nothing.
//!
//! In a plane of symmetry the row of a node is over the nodes of the plane alone, and what it bears is their share of `Aᵀμ`. Nodes off the plane
//! and their images balance each other in the whole, but not in the half: with the forces r′ on images that is `2 r′·n`, which the plane
//! bears; r′ without what other supports bring to images.

use sph_core::Vec3;

use crate::body::Galerkin;
use crate::essential::row;
use crate::parts::{Condition, Essential};

/// Nodes nearer to a plane than this part of the support lie on it.
const ON_PLANE: f64 = 1e-9;
/// A pivot of `AAᵀ` below this share of the first is a row that depends on others.
const DEPENDENT: f64 = 1e-14;

/// The rows of all conditions, factorised: what turns a residual into forces of supports.
pub struct Supports {
    nodes: Vec<u32>,
    directions: Vec<Vec3>,
    /// Parameters with the coefficients of each row.
    rows: Vec<Vec<(u32, f64)>>,
    /// Rows that do not depend on others, in the order of their pivots.
    order: Vec<usize>,
    /// How each row is imposed.
    essential: Vec<Essential>,
    /// Whether a row holds a node in a plane with images behind.
    mirrored: Vec<bool>,
    /// Images with the normal of their plane and the node on it that is nearest before them.
    behind: Vec<(u32, Vec3, u32)>,
    /// Lower triangle of Cholesky's factor of `AAᵀ` in that order.
    factor: Vec<Vec<f64>>,
}

impl Supports {
    /// The conditions that a body was built with, and a node that a force holds where a motion is sought.
    pub fn new(
        body: &Galerkin,
        conditions: &[Condition],
        essential: Essential,
        sought: Option<(u32, Vec3)>,
    ) -> Self {
        let mut out = Self {
            nodes: Vec::new(),
            directions: Vec::new(),
            rows: Vec::new(),
            essential: Vec::new(),
            mirrored: Vec::new(),
            behind: Vec::new(),
            order: Vec::new(),
            factor: Vec::new(),
        };
        for condition in conditions {
            let n = condition.direction.normalize();
            condition.nodes.iter().for_each(|&node| out.add(body, essential, node, n));
        }
        if let Some((node, direction)) = sought {
            out.add(body, Essential::Collocation, node, direction.normalize());
        }
        out.factorise(3 * body.nodes());
        out.find_behind(body);
        out
    }

    fn add(&mut self, body: &Galerkin, essential: Essential, node: u32, n: Vec3) {
        let shape = &body.space.nodal[node as usize];
        self.rows.push(row(&body.space, essential, shape, (node, n)));
        let (place, slack) = (&body.space.nodes[node as usize], ON_PLANE * body.radii[0]);
        self.mirrored.push(body.space.images.plane(place, &n, slack).is_some());
        self.essential.push(essential);
        self.nodes.push(node);
        self.directions.push(n);
    }

    /// Finds for every image the node held in its plane that is nearest before it.
    fn find_behind(&mut self, body: &Galerkin) {
        let held: Vec<usize> = (0..self.rows.len()).filter(|&row| self.mirrored[row]).collect();
        for (image, normal, foot) in body.space.images.behind() {
            let of_plane = held.iter().filter(|&&row| self.directions[row].dot(&normal).abs() > 0.5);
            let distance = |row: &usize| (body.space.nodes[self.nodes[*row] as usize] - foot).norm_squared();
            let nearest = of_plane.min_by(|a, b| distance(a).total_cmp(&distance(b)));
            self.behind.extend(nearest.map(|&row| (image, normal, self.nodes[row])));
        }
    }

    /// Cholesky's factor of `AAᵀ` with diagonal pivots, until what is left depends on it.
    fn factorise(&mut self, parameters: usize) {
        let count = self.rows.len();
        let mut spread = vec![0.0; parameters];
        let mut product = vec![vec![0.0; count]; count];
        for (i, row) in self.rows.iter().enumerate() {
            row.iter().for_each(|&(p, a)| spread[p as usize] += a);
            for (j, other) in self.rows.iter().enumerate().take(i + 1) {
                let dot: f64 = other.iter().map(|&(p, b)| spread[p as usize] * b).sum();
                (product[i][j], product[j][i]) = (dot, dot);
            }
            row.iter().for_each(|&(p, _)| spread[p as usize] = 0.0);
        }
        let mut open: Vec<usize> = (0..count).collect();
        let mut left: Vec<f64> = (0..count).map(|i| product[i][i]).collect();
        let first = left.iter().copied().fold(0.0, f64::max);
        // Column of the factor by pivot, over all rows.
        let mut columns: Vec<Vec<f64>> = Vec::new();
        while let Some(at) = (0..open.len()).max_by(|&a, &b| left[open[a]].total_cmp(&left[open[b]])) {
            let pivot = open[at];
            if left[pivot] <= DEPENDENT * first {
                break;
            }
            open.swap_remove(at);
            let root = left[pivot].sqrt();
            let mut column = vec![0.0; count];
            column[pivot] = root;
            for &i in &open {
                let known: f64 = columns.iter().map(|c| c[i] * c[pivot]).sum();
                column[i] = (product[i][pivot] - known) / root;
                left[i] -= column[i] * column[i];
            }
            self.order.push(pivot);
            columns.push(column);
        }
        self.factor = self.order.iter().map(|&row| columns.iter().map(|c| c[row]).collect()).collect();
    }

    /// Forces of the supports on all nodes at a level \[F\].
    pub fn forces(&self, body: &mut Galerkin, level: f64, out: &mut [Vec3]) {
        body.evaluate_internal(level);
        body.evaluate_external(level);
        let (internal, external) = (&body.internal, &body.external);
        let residual = |&(p, a): &(u32, f64)| a * (internal[p as usize] - external[p as usize]);
        let mut sought: Vec<f64> =
            self.order.iter().map(|&row| self.rows[row].iter().map(residual).sum()).collect();
        let count = sought.len();
        for i in 0..count {
            let known: f64 = (0..i).map(|j| self.factor[i][j] * sought[j]).sum();
            sought[i] = (sought[i] - known) / self.factor[i][i];
        }
        for i in (0..count).rev() {
            let known: f64 = (i + 1..count).map(|j| self.factor[j][i] * sought[j]).sum();
            sought[i] = (sought[i] - known) / self.factor[i][i];
        }
        out.fill(Vec3::zeros());
        let mut forces = if self.behind.is_empty() { Vec::new() } else { body.forces_on_images(level) };
        for (&row, multiplier) in self.order.iter().zip(sought) {
            if self.mirrored[row] {
                let shares = self.rows[row].iter().map(|&(p, a)| (p as usize, a * multiplier));
                shares.for_each(|(p, force)| out[p / 3][p % 3] += force);
                continue;
            }
            let force = self.directions[row] * multiplier;
            out[self.nodes[row] as usize] += force;
            // What the support brings to images is none of the plane's.
            let shape = &body.space.nodal[self.nodes[row] as usize];
            let seen = shape
                .nodes
                .iter()
                .zip(&shape.values)
                .filter(|_| self.essential[row] == Essential::Collocation);
            for (&number, phi) in seen {
                if let Some(own) =
                    (number as usize).checked_sub(body.nodes()).and_then(|at| forces.get_mut(at))
                {
                    *own -= force * *phi;
                }
            }
        }
        for &(image, normal, node) in &self.behind {
            out[node as usize] += normal * (2.0 * normal.dot(&forces[image as usize - body.nodes()]));
        }
    }
}
