//! The tests of the whole: one binary, so that it links once.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod battery;
mod bite;
mod checks;
mod enumeration;
mod expected;
mod measures;
mod statistics;
