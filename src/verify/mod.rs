//! The book as a reader would meet it.

pub mod site;
