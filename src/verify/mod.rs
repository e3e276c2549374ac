//! Verifying: the book as its reader would meet it, held against what was reviewed.

pub mod drift;
pub mod lock;
pub mod site;
