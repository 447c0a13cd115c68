//! The runs that miss what is asked of them, with their errors \[%\]; the causes stand with the cases.

use super::common::Miss;
use crate::cases::dial::{NODAL_1, NODAL_2, NODAL_3, STATIC, WIDE_14};

/// Of the case disorder.
#[rustfmt::skip]
pub const DISORDER: [Miss; 0] = [];

/// Of the case thickness.
#[rustfmt::skip]
pub const THICKNESS: [Miss; 0] = [];
