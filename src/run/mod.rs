//! Running: experiments to results, in parallel, each once, and none whose result is kept.

pub mod code;
pub mod digest;
