//! The tests of the whole: one binary, so that it links once.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

#[cfg(feature = "publish")]
mod appendices;
#[cfg(feature = "publish")]
mod asked;
#[cfg(feature = "publish")]
mod atomic;
#[cfg(feature = "publish")]
mod audience;
mod battery;
#[cfg(feature = "publish")]
mod behaviour;
mod bite;
#[cfg(feature = "publish")]
mod cache;
#[cfg(feature = "publish")]
mod catalogue;
mod checks;
#[cfg(feature = "publish")]
mod cli;
#[cfg(feature = "publish")]
mod code;
#[cfg(feature = "publish")]
mod compare;
#[cfg(feature = "publish")]
mod course;
#[cfg(feature = "publish")]
mod determinism;
#[cfg(feature = "publish")]
mod drawings;
mod enumeration;
#[cfg(feature = "publish")]
mod estimation;
mod expected;
#[cfg(feature = "publish")]
mod explain;
#[cfg(feature = "publish")]
mod formulas;
#[cfg(feature = "publish")]
mod gallery;
#[cfg(feature = "publish")]
mod golden;
#[cfg(feature = "publish")]
mod guide;
#[cfg(all(unix, feature = "publish"))]
mod hardship;
#[cfg(feature = "publish")]
mod kinds;
#[cfg(feature = "publish")]
mod listings;
#[cfg(feature = "publish")]
mod lock;
mod measures;
#[cfg(feature = "publish")]
mod pages;
#[cfg(feature = "publish")]
mod parameters;
mod paths;
#[cfg(feature = "publish")]
mod pictures;
#[cfg(feature = "publish")]
mod point_kinds;
#[cfg(feature = "publish")]
mod point_questions;
#[cfg(feature = "publish")]
mod points;
#[cfg(feature = "publish")]
mod preview;
mod properties;
#[cfg(feature = "publish")]
mod reading;
#[cfg(feature = "publish")]
mod receipt;
#[cfg(feature = "publish")]
mod review;
#[cfg(feature = "publish")]
mod schema;
#[cfg(feature = "publish")]
mod search;
#[cfg(feature = "publish")]
mod serve;
mod settings;
#[cfg(feature = "publish")]
mod slides;
#[cfg(feature = "publish")]
mod spectral;
#[cfg(feature = "publish")]
mod starter;
mod statistics;
#[cfg(feature = "publish")]
mod steppers;
#[cfg(feature = "publish")]
mod terms;
#[cfg(feature = "publish")]
mod tidy;
#[cfg(feature = "publish")]
mod traps;
#[cfg(feature = "publish")]
mod typed;
#[cfg(feature = "publish")]
mod web;
