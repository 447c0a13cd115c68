//! The fluid in time.

mod bounds;
mod march;
mod predictor_corrector;
