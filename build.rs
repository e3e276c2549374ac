//! Embeds the sources of the library in the library, so that a listing shows, and a key hashes, the very text that was compiled.
//!
//! Writes `sources.rs` to `OUT_DIR`: a sorted table of every file below `src/`, and the text of `Cargo.lock`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    println!("cargo:rerun-if-changed=src");
    println!("cargo:rerun-if-changed=Cargo.lock");
    let mut files = Vec::new();
    collect(Path::new("src"), &mut files)?;
    files.sort();
    // Only the manifest's folder is joined at compile time: no absolute path stands in the table itself.
    let mut table = String::from("/// Every file below `src/`, sorted by its path there.\n");
    table.push_str("pub static FILES: &[(&str, &[u8])] = &[\n");
    for file in &files {
        let _ = writeln!(
            table,
            "    ({file:?}, include_bytes!(concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/src/\", {file:?}))),"
        );
    }
    table.push_str("];\n/// The locked dependencies.\npub static LOCKED: &str = ");
    table.push_str(if Path::new("Cargo.lock").is_file() {
        "include_str!(concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/Cargo.lock\"));\n"
    } else {
        "\"\";\n"
    });
    let out = env::var_os("OUT_DIR").map(PathBuf::from).ok_or_else(|| io::Error::other("OUT_DIR is not set"))?;
    fs::write(out.join("sources.rs"), table)
}

/// Adds the files below `folder` to `files`: paths from `src`, with `/` between folders.
fn collect(folder: &Path, files: &mut Vec<String>) -> io::Result<()> {
    for found in fs::read_dir(folder)? {
        let path = found?.path();
        if path.is_dir() {
            collect(&path, files)?;
        } else if let Ok(below) = path.strip_prefix("src") {
            let parts: Vec<_> = below.iter().map(|part| part.to_string_lossy()).collect();
            let hidden = parts.last().is_some_and(|name| name.starts_with('.') || name.ends_with('~'));
            if !hidden {
                files.push(parts.join("/"));
            }
        }
    }
    Ok(())
}
