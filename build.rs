//! Embeds the sources of the library in the library, so that a listing shows, and a key hashes, the very text that was compiled.
//!
//! Writes to `OUT_DIR`: `sources.rs`, a sorted table of every file below `src/` and the text of `Cargo.lock`; and `templates.rs`, a sorted
//! table of the templates and assets that every course has unless it brings its own.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    println!("cargo:rerun-if-changed=src");
    println!("cargo:rerun-if-changed=templates");
    println!("cargo:rerun-if-changed=Cargo.lock");
    let out = env::var_os("OUT_DIR").map(PathBuf::from).ok_or_else(|| io::Error::other("OUT_DIR is not set"))?;
    let mut sources = table("src", "FILES")?;
    sources.push_str("/// The locked dependencies.\npub static LOCKED: &str = ");
    sources.push_str(if Path::new("Cargo.lock").is_file() {
        "include_str!(concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/Cargo.lock\"));\n"
    } else {
        "\"\";\n"
    });
    fs::write(out.join("sources.rs"), sources)?;
    fs::write(out.join("templates.rs"), table("templates", "TEMPLATES")?)
}

/// The Rust text of a sorted table `name` of every file below `folder`, by its path there.
fn table(folder: &str, name: &str) -> io::Result<String> {
    let mut files = Vec::new();
    collect(Path::new(folder), Path::new(folder), &mut files)?;
    files.sort();
    let mut table = format!("/// Every file below `{folder}/`, sorted by its path there.\n");
    let _ = writeln!(table, "pub static {name}: &[(&str, &[u8])] = &[");
    for file in &files {
        // Only the manifest's folder is joined at compile time: no absolute path stands in the table itself.
        let path = format!("/{folder}/{file}");
        let _ = writeln!(table, "    ({file:?}, include_bytes!(concat!(env!(\"CARGO_MANIFEST_DIR\"), {path:?}))),");
    }
    table.push_str("];\n");
    Ok(table)
}

/// Adds the files below `folder` to `files`: paths from `top`, with `/` between folders.
fn collect(top: &Path, folder: &Path, files: &mut Vec<String>) -> io::Result<()> {
    for found in fs::read_dir(folder)? {
        let path = found?.path();
        if path.is_dir() {
            collect(top, &path, files)?;
        } else if let Ok(below) = path.strip_prefix(top) {
            let parts: Vec<_> = below.iter().map(|part| part.to_string_lossy()).collect();
            let hidden = parts.last().is_some_and(|name| name.starts_with('.') || name.ends_with('~'));
            if !hidden {
                files.push(parts.join("/"));
            }
        }
    }
    Ok(())
}
