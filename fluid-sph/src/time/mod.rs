//! The fluid in time.

mod march;
mod predictor_corrector;
