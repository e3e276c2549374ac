//! `workbook`: a literate course workbook. Every figure is computed, and every claim is verified.
//!
//! # Words
//!
//! *chapter*: a markdown file as read. *experiment*: what a chapter asks to be computed. *plan*: all that is due, deduplicated.
//! *key*: the address of an experiment's result. *result*: the typed numbers. *exhibit*: a figure or table on a page. *page*: HTML.
//! *book*: every byte of the site. *claim*: a statement that is verified. *lock*: the committed record of results.
//! *entry*: a member of a catalogue. *n* points, *d* dimensions, *seed*.
//!
//! # Stages
//!
//! `workspace -> generate -> parse -> plan -> run -> exhibits -> render -> verify -> write`: see `compose`, which is the map. Each stage is a pure
//! function of what the one before returned, and returns its value *and* its diagnostics (`diag`), so that one run reports every
//! mistake. Only `workspace`, the cache and `write` touch the disk; only `cli` prints.
//!
//! # The mathematics
//!
//! `samplers`, `scrambles`, `integrands`, `scenes` and `stats` know no chapter, file, thread or plot, and build alone with
//! `--no-default-features`. Each method is one file, named in its folder's catalogue.
//!
//! # Invariants
//!
//! The same inputs give the same bytes on any number of threads, in any folder, under any locale and time zone. No input makes the
//! library panic. A cached result is used only under the very key that it was computed for. The site is replaced whole or not at all.

pub mod catalogue;
pub mod integrands;
pub mod metrics;
pub mod points;
pub mod samplers;
pub mod scenes;
pub mod scrambles;
pub mod seed;
pub mod stats;
pub mod vectors;

#[cfg(feature = "publish")]
pub mod chart;
#[cfg(feature = "publish")]
pub mod cli;
#[cfg(feature = "publish")]
pub mod compare;
#[cfg(feature = "publish")]
pub mod compose;
#[cfg(feature = "publish")]
pub mod diag;
#[cfg(feature = "publish")]
pub mod exhibits;
#[cfg(feature = "publish")]
pub mod explain;
#[cfg(feature = "publish")]
pub mod generate;
#[cfg(feature = "publish")]
pub mod kinds;
#[cfg(feature = "publish")]
pub mod parameters;
#[cfg(feature = "publish")]
pub mod parse;
#[cfg(feature = "publish")]
pub mod plan;
#[cfg(feature = "publish")]
pub mod raster;
#[cfg(feature = "publish")]
pub mod receipt;
#[cfg(feature = "publish")]
pub mod render;
#[cfg(feature = "publish")]
pub mod run;
#[cfg(feature = "publish")]
pub mod schema;
#[cfg(feature = "publish")]
pub mod serve;
#[cfg(feature = "publish")]
pub mod sources;
#[cfg(feature = "publish")]
pub mod starter;
#[cfg(feature = "publish")]
pub mod verify;
#[cfg(feature = "publish")]
pub mod workspace;
#[cfg(feature = "publish")]
pub mod write;

#[cfg(feature = "publish")]
pub use compose::compose;
