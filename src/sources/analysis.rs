//! Which code can change which result: read from the sources by the build script, so that no run of the program has to.

use std::collections::{BTreeMap, BTreeSet};

use super::digest::Digest;
use super::lex::{self, Token};
use super::table::{self, Code, Table};
use super::uses::{self, Entry};

/// Where no number of a result comes from. Whatever is not named here counts as part of the engine: a new folder is safe by default.
const NOT_COMPUTING: &[&str] = &[
    "lib.rs",
    "main.rs",
    "diag.rs",
    "compose.rs",
    "workspace.rs",
    "workspace/",
    "generate/",
    "parse/",
    "plan/",
    "run/",
    "exhibits/",
    "chart/",
    "receipt.rs",
    "sources/",
    "render/",
    "verify/",
    "serve/",
    "write.rs",
    "write/",
    "cli/",
    "compare/",
    "explain.rs",
    "schema.rs",
    "starter/",
];

/// A table of sources, and what of it computes.
#[derive(Debug)]
pub struct Sources<'a> {
    /// Of each file, the part that computes.
    files: BTreeMap<&'a str, String>,
    /// The entries of the catalogues, and the modules beside them that count only where they are used.
    entries: BTreeSet<Entry<'a>>,
    /// The entries of the catalogues.
    listed: BTreeSet<Entry<'a>>,
    /// Of each file, the modules of the catalogues' folders that it names, entries or not.
    named: BTreeMap<&'a str, BTreeSet<Entry<'a>>>,
    units: BTreeMap<Entry<'a>, Unit<'a>>,
    engine: Digest,
    dependencies: Digest,
}

/// The code of one entry.
#[derive(Debug)]
struct Unit<'a> {
    /// Its first file, which names it.
    file: &'a str,
    digest: Digest,
    /// The entries that it uses directly.
    uses: BTreeSet<Entry<'a>>,
}

impl<'a> Sources<'a> {
    /// The sources `files`, each with its path from `src`, and the text of a `Cargo.lock`.
    pub fn new(files: impl IntoIterator<Item = (&'a str, &'a [u8])>, locked: &str) -> Self {
        let files: BTreeMap<_, _> = files.into_iter().collect();
        let listed = entries(&files);
        let files: BTreeMap<_, _> = files.into_iter().map(|(file, bytes)| (file, computing(file, bytes))).collect();
        let named = named(&files, &listed);
        let dependencies = dependencies(locked);
        let (entries, units, engine) = (listed.clone(), BTreeMap::new(), dependencies);
        let mut sources = Self { files, entries, listed, named, units, engine, dependencies };
        // A module can use entries through another such module.
        let declared = sources.declared();
        loop {
            let linking = sources.linking(&declared);
            if linking.is_empty() {
                break;
            }
            sources.entries.extend(linking);
        }
        sources.units = sources.entries.iter().filter_map(|&entry| Some((entry, sources.unit(entry)?))).collect();
        sources.engine = sources.digest_engine();
        sources
    }

    /// What a program keeps of them.
    pub fn table(&self) -> Table<'a> {
        let places: BTreeMap<Entry<'a>, usize> =
            self.units.keys().enumerate().map(|(at, &entry)| (entry, at)).collect();
        let place = |entry: &Entry<'a>| places.get(entry).copied();
        let unit = |(entry, unit): (&Entry<'a>, &Unit<'a>)| table::Unit {
            file: unit.file,
            digest: unit.digest,
            listed: self.listed.contains(entry),
            uses: unit.uses.iter().filter_map(place).collect(),
        };
        let file = |&file: &&'a str| match self.entry_of(file).as_ref().and_then(place) {
            Some(unit) => (file, Code::Unit(unit)),
            None => (file, Code::Shared(Digest::of(self.computing(file).as_bytes()))),
        };
        Table {
            engine: self.engine,
            dependencies: self.dependencies,
            units: self.units.iter().map(unit).collect(),
            files: self.files.keys().map(file).collect(),
        }
    }

    /// The modules that the folders of catalogues declare: each `mod.rs` is read once.
    fn declared(&self) -> BTreeSet<Entry<'a>> {
        let folders: BTreeSet<&'a str> = self.listed.iter().map(|listed| listed.0).collect();
        let modules = self.files.keys().filter_map(|file| module(file)).filter(|module| folders.contains(module.0));
        let lists = folders.iter().map(|folder| (*folder, lex::tokens(self.computing(&format!("{folder}/mod.rs")))));
        let lists: BTreeMap<&str, Vec<Token<'_>>> = lists.collect();
        let declared =
            |(folder, name): &Entry<'a>| lists[folder].windows(3).any(|words| declares(words, name)) && *name != "mod";
        modules.collect::<BTreeSet<_>>().into_iter().filter(declared).collect()
    }

    /// Those of the `declared` modules that are not known yet as entries, and that use some that are.
    ///
    /// As part of the engine they would make those entries count for every experiment; so they count where they are used, as entries do.
    fn linking(&self, declared: &BTreeSet<Entry<'a>>) -> BTreeSet<Entry<'a>> {
        let links = |entry: &&Entry<'a>| self.files_of(**entry).any(|file| !self.uses(file).is_empty());
        declared.difference(&self.entries).filter(links).copied().collect()
    }

    /// `due` and all entries that these use, directly or not.
    fn closure(&self, mut due: BTreeSet<Entry<'a>>) -> BTreeSet<Entry<'a>> {
        let mut seen = BTreeSet::new();
        while let Some(entry) = due.pop_first() {
            if seen.insert(entry) {
                due.extend(self.units.get(&entry).into_iter().flat_map(|unit| &unit.uses));
            }
        }
        seen
    }

    /// The code of an entry that has a file.
    fn unit(&self, entry: Entry<'a>) -> Option<Unit<'a>> {
        let files: Vec<&'a str> = self.files_of(entry).collect();
        let uses = files.iter().flat_map(|file| self.uses(file)).collect();
        Some(Unit { file: files.first()?, digest: self.digest(files.iter().copied()), uses })
    }

    /// The entries that the file uses.
    fn uses(&self, file: &'a str) -> BTreeSet<Entry<'a>> {
        let named = self.named.get(file).into_iter().flatten();
        named.copied().filter(|module| self.entries.contains(module)).collect()
    }

    /// The files of an entry: `folder/name.rs`, and all below `folder/name/`.
    fn files_of(&self, (folder, name): Entry<'a>) -> impl Iterator<Item = &'a str> + '_ {
        let names = move |file: &str| {
            let rest = file.strip_prefix(folder).and_then(|rest| rest.strip_prefix('/')?.strip_prefix(name));
            rest.is_some_and(|rest| rest == ".rs" || rest.starts_with('/'))
        };
        // `name.rs` sorts before `name/..` among the files of a folder.
        self.files.keys().copied().filter(move |file| names(file))
    }

    /// The entry that `file` belongs to.
    fn entry_of(&self, file: &str) -> Option<Entry<'a>> {
        let module = module(file)?;
        self.entries.iter().copied().find(|entry| *entry == module)
    }

    /// The part of the file that computes.
    fn computing(&self, file: &str) -> &str {
        self.files.get(file).map_or("", String::as_str)
    }

    /// The digest of the computing parts of `files`.
    fn digest(&self, files: impl Iterator<Item = &'a str>) -> Digest {
        let parts: Vec<String> = files.flat_map(|file| [file.to_owned(), self.normal(file)]).collect();
        Digest::of_parts(parts.iter().map(String::as_bytes))
    }

    /// The computing part of a file, without the lines of a catalogue that only list its entries.
    fn normal(&self, file: &str) -> String {
        let text = self.computing(file);
        if !is_catalogue(file) {
            return text.to_owned();
        }
        let tokens = kept(file, lex::tokens(text));
        tokens.iter().map(|token| token.text).collect::<Vec<_>>().join(" ")
    }

    fn digest_engine(&self) -> Digest {
        let engine = |file: &&str| !not_computing(file) && self.entry_of(file).is_none();
        let files: BTreeSet<&'a str> = self.files.keys().copied().filter(engine).collect();
        // What the engine itself uses of the entries is part of the engine.
        let used = self.closure(files.iter().flat_map(|file| self.uses(file)).collect());
        let entries = used.into_iter().flat_map(|entry| self.files_of(entry));
        let all: BTreeSet<&'a str> = entries.chain(files.iter().copied()).collect();
        self.digest(all.into_iter())
    }
}

/// The module of a catalogue's folder that a file belongs to: `name.rs`, or any file of the folder `name/`.
fn module(file: &str) -> Option<Entry<'_>> {
    let (folder, rest) = file.split_once('/')?;
    let name = rest.split_once('/').map_or_else(|| rest.strip_suffix(".rs"), |(name, _)| Some(name))?;
    Some((folder, name))
}

/// Whether `words` are `mod name;`.
fn declares(words: &[Token<'_>], name: &str) -> bool {
    matches!(words, [keyword, module, end] if keyword.is("mod") && module.is(name) && end.is(";"))
}

/// Whether no number comes from `file`: it draws, parses or renders.
pub(super) fn not_computing(file: &str) -> bool {
    let named = |name: &&str| if name.ends_with('/') { file.starts_with(*name) } else { file == *name };
    NOT_COMPUTING.iter().any(named) || (file.starts_with("kinds/") && file.ends_with("/drawing.rs"))
}

/// Whether `file` is code rather than data.
fn is_rust(file: &str) -> bool {
    file.strip_suffix(".rs").is_some()
}

/// Whether `file` is the `mod.rs` of a folder right below `src`, where catalogues are.
fn is_catalogue(file: &str) -> bool {
    file.split_once('/').is_some_and(|(_, rest)| rest == "mod.rs")
}

/// The tokens of a file without the lines of a catalogue that only list its entries.
fn kept<'t>(file: &str, tokens: Vec<Token<'t>>) -> Vec<Token<'t>> {
    if is_catalogue(file) { uses::catalogue(&tokens).1 } else { tokens }
}

/// The entries of all catalogues.
fn entries<'a>(files: &BTreeMap<&'a str, &'a [u8]>) -> BTreeSet<Entry<'a>> {
    let mut found = BTreeSet::new();
    for (file, text) in files.iter().filter(|(file, _)| is_catalogue(file) && !not_computing(file)) {
        let (Some((folder, _)), Ok(text)) = (file.split_once('/'), std::str::from_utf8(text)) else { continue };
        found.extend(uses::catalogue(&lex::tokens(text)).0.into_iter().map(|name| (folder, name)));
    }
    found
}

/// Of each file, the modules of the catalogues' folders that it names: every file is read once, whatever turns out to be an entry.
fn named<'a>(
    files: &BTreeMap<&'a str, String>,
    listed: &BTreeSet<Entry<'a>>,
) -> BTreeMap<&'a str, BTreeSet<Entry<'a>>> {
    let module = |file: &'a str| {
        let (folder, rest) = file.split_once('/')?;
        let name = rest.split_once('/').map_or_else(|| rest.strip_suffix(".rs"), |(name, _)| Some(name))?;
        listed.iter().any(|entry| entry.0 == folder).then_some((folder, name))
    };
    let modules: BTreeSet<Entry<'a>> = files.keys().copied().filter_map(module).chain(listed.iter().copied()).collect();
    let named = files.iter().filter(|(file, text)| is_rust(file) && !text.is_empty()).map(|(&file, text)| {
        let tokens = kept(file, lex::tokens(text));
        let folder = file.split_once('/').map_or("", |(folder, _)| folder);
        let found = uses::uses(&tokens, folder, &modules);
        (file, modules.iter().copied().filter(|module| found.contains(module)).collect())
    });
    named.collect()
}

/// What of a file computes: all but its tests and, in a kind, its `mod drawing`. Line ends count as one character.
fn computing(file: &str, bytes: &[u8]) -> String {
    if not_computing(file) {
        return String::new();
    }
    let Ok(text) = std::str::from_utf8(bytes) else { return Digest::of(bytes).to_string() };
    let text = text.replace("\r\n", "\n");
    if !is_rust(file) {
        return text;
    }
    let mut rest = String::new();
    let mut at = 0;
    for (start, end) in idle(&text, file.starts_with("kinds/")) {
        rest.push_str(&text[at..start]);
        at = end;
    }
    rest.push_str(&text[at..]);
    rest
}

/// The ranges of the modules, at the left margin, that compute nothing.
fn idle(text: &str, draws: bool) -> Vec<(usize, usize)> {
    // Most files have no such module: they need no reading.
    if !(text.contains("cfg") || draws) {
        return Vec::new();
    }
    let tokens = lex::tokens(text);
    let mut found = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        let margin = tokens[at].start == 0 || text.as_bytes().get(tokens[at].start - 1) == Some(&b'\n');
        let module = if margin { idle_module(&tokens[at..], draws) } else { None };
        let end = module.and_then(|open| lex::close(&tokens, at + open));
        if let Some(end) = end {
            found.push((tokens[at].start, tokens[end].end()));
        }
        at = end.unwrap_or(at) + 1;
    }
    found
}

/// For `mod drawing {` or `#[cfg(test)] .. mod name {` at the start of `tokens`, the index of the brace.
fn idle_module(tokens: &[Token<'_>], draws: bool) -> Option<usize> {
    let starts = |pattern: &[&str], from: usize| {
        tokens.get(from..from + pattern.len()).is_some_and(|part| part.iter().zip(pattern).all(|(a, b)| a.is(b)))
    };
    if draws && starts(&["mod", "drawing", "{"], 0) {
        return Some(2);
    }
    if !starts(&["#", "[", "cfg", "(", "test", ")", "]"], 0) {
        return None;
    }
    let mut at = 7;
    while starts(&["#", "["], at) {
        at = lex::close(tokens, at + 1)? + 1;
    }
    (starts(&["mod"], at) && tokens.get(at + 2)?.is("{")).then_some(at + 2)
}

/// The digest of every locked package but the one without a source, which is this one.
fn dependencies(locked: &str) -> Digest {
    let locked = locked.replace("\r\n", "\n");
    let mut packages: Vec<String> = Vec::new();
    for stanza in locked.split("[[package]]").skip(1) {
        let fields: Vec<&str> = ["name", "version", "source", "checksum"]
            .iter()
            .filter_map(|field| {
                stanza.lines().find(|line| line.strip_prefix(field).is_some_and(|rest| rest.starts_with(" = ")))
            })
            .collect();
        if fields.iter().any(|line| line.starts_with("source")) {
            packages.push(fields.join("\n"));
        }
    }
    packages.sort();
    Digest::of_parts(packages.iter().map(String::as_bytes))
}
