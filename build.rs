//! Embeds the sources of the library in the library, so that a listing shows, and a key hashes, the very text that was compiled.
//!
//! Writes to `OUT_DIR`: `sources.rs`, a sorted table of every file below `src/`; `digests.rs`, the digests of these and of `Cargo.lock` for
//! the keys of results, which a run would take longer to compute than all else that it repeats, and that of the whole program; `templates.rs`, a sorted table
//! of the templates and assets that every course has unless it brings its own; `starter.rs`, the files of the course that `init` writes;
//! and `explain.rs`, the explanations of diagnostics.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// The library's own reading of its sources.
#[cfg(feature = "publish")]
#[path = "src/sources"]
#[allow(dead_code, unused_imports, reason = "the library uses the rest")]
mod sources {
    pub mod analysis;
    pub mod digest;
    mod lex;
    pub mod table;
    mod uses;
}

fn main() -> io::Result<()> {
    println!("cargo:rerun-if-changed=src");
    println!("cargo:rerun-if-changed=templates");
    println!("cargo:rerun-if-changed=starter");
    println!("cargo:rerun-if-changed=explain");
    println!("cargo:rerun-if-changed=Cargo.lock");
    println!("cargo:rerun-if-changed=Cargo.toml");
    println!("cargo:rerun-if-changed=build.rs");
    let out = env::var_os("OUT_DIR").map(PathBuf::from).ok_or_else(|| io::Error::other("OUT_DIR is not set"))?;
    fs::write(out.join("sources.rs"), table("src", "FILES")?)?;
    #[cfg(feature = "publish")]
    fs::write(out.join("digests.rs"), digests()?)?;
    fs::write(out.join("explain.rs"), table("explain", "EXPLANATIONS")?)?;
    fs::write(out.join("starter.rs"), table("starter", "STARTER")?)?;
    fs::write(out.join("templates.rs"), table("templates", "TEMPLATES")?)
}

/// The Rust text of the digests of every file below `src/`.
#[cfg(feature = "publish")]
fn digests() -> io::Result<String> {
    use sources::analysis::Sources;
    use sources::digest::Digest;
    use sources::table::Code;

    let mut names = Vec::new();
    collect(Path::new("src"), Path::new("src"), &mut names)?;
    let files = names.iter().map(|name| Ok((name.as_str(), fs::read(Path::new("src").join(name))?)));
    let files = files.collect::<io::Result<Vec<_>>>()?;
    let locked = if Path::new("Cargo.lock").is_file() { fs::read_to_string("Cargo.lock")? } else { String::new() };
    let read = Sources::new(files.iter().map(|(name, bytes)| (*name, bytes.as_slice())), &locked).table();
    let digest = |digest: &Digest| format!("Digest::new({:?})", digest.bytes());
    let mut text = String::from("/// The digests of the sources, as the build script read them.\n");
    text.push_str("pub static DIGESTS: Table<'static> = Table {\n");
    let _ = writeln!(text, "    engine: {},", digest(&read.engine));
    let _ = writeln!(text, "    dependencies: {},\n    units: Borrowed(&[", digest(&read.dependencies));
    for unit in read.units.iter() {
        let (file, listed, uses) = (unit.file, unit.listed, &unit.uses);
        let digest = digest(&unit.digest);
        let _ = writeln!(
            text,
            "        Unit {{ file: {file:?}, digest: {digest}, listed: {listed}, uses: Borrowed(&{uses:?}) }},"
        );
    }
    text.push_str("    ]),\n    files: Borrowed(&[\n");
    for (file, code) in read.files.iter() {
        let code = match code {
            Code::Unit(unit) => format!("Code::Unit({unit})"),
            Code::Shared(shared) => format!("Code::Shared({})", digest(shared)),
        };
        let _ = writeln!(text, "        ({file:?}, {code}),");
    }
    text.push_str("    ]),\n};\n");
    let _ = writeln!(
        text,
        "/// The digest of everything that the program is made of.\npub static PROGRAM: Digest = {};",
        digest(&program()?)
    );
    Ok(text)
}

/// The digest of every source, template and locked dependency.
#[cfg(feature = "publish")]
fn program() -> io::Result<sources::digest::Digest> {
    let mut files = vec!["Cargo.toml".to_owned(), "Cargo.lock".to_owned(), "build.rs".to_owned()];
    for folder in ["src", "templates"] {
        let mut found = Vec::new();
        collect(Path::new(folder), Path::new(folder), &mut found)?;
        files.extend(found.into_iter().map(|file| format!("{folder}/{file}")));
    }
    files.sort();
    let mut parts = Vec::new();
    for file in files.into_iter().filter(|file| Path::new(file).is_file()) {
        let bytes = fs::read(&file)?;
        parts.extend([file.into_bytes(), bytes]);
    }
    Ok(sources::digest::Digest::of_parts(parts.iter().map(Vec::as_slice)))
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
