//! How figures are got from particles: fields, spectra, fits.

pub mod field;
pub mod fit;
pub mod signal;
