//! The templates and assets: embedded in the binary, overridden file by file by the course's folder `templates`.

use std::collections::BTreeMap;

use serde::Serialize;
use tera::{Context, Tera};

use crate::chart::palette;
use crate::diag::{Code, Diagnostic};
use crate::workspace::{TEMPLATES, Workspace, extension};

/// The templates and assets that every course has unless it brings its own.
mod embedded {
    include!(concat!(env!("OUT_DIR"), "/templates.rs"));
}

/// The embedded file `path` of the folder `templates`.
pub(super) fn embedded(path: &str) -> Option<&'static [u8]> {
    embedded::TEMPLATES.iter().find(|(file, _)| *file == path).map(|&(_, bytes)| bytes)
}

/// The folder of the book that holds style, script and fonts.
pub(super) const ASSETS: &str = "assets";

/// What every page has, as one file each: a file costs more than its bytes. Later rules win over earlier ones, and later scripts use earlier ones.
const JOINED: [(&str, &[&str]); 2] = [
    (
        "style.css",
        &[
            "style.css",
            "page.css",
            "text.css",
            "notes.css",
            "exhibits.css",
            "steppers.css",
            "code.css",
            "callouts.css",
            "matter.css",
            "tools.css",
            "listings.css",
            "search.css",
        ],
    ),
    ("page.js", &["keys.js", "folds.js", "contents.js", "previews.js", "copy.js", "pictures.js", "search.js"]),
];

/// The templates ready to be filled, and the assets beside them.
pub(super) struct Templates {
    tera: Tera,
    assets: BTreeMap<String, Vec<u8>>,
}

impl Templates {
    /// Loads the embedded files and the course's own over them; a broken template is told.
    pub(super) fn load(workspace: &Workspace, diagnostics: &mut Vec<Diagnostic>) -> Option<Self> {
        let mut files: BTreeMap<String, Vec<u8>> =
            embedded::TEMPLATES.iter().map(|(path, bytes)| ((*path).to_owned(), bytes.to_vec())).collect();
        let own = |path: &str| path.strip_prefix(TEMPLATES).and_then(|path| path.strip_prefix('/')).map(str::to_owned);
        for (path, source) in &workspace.texts {
            files.extend(own(path).map(|path| (path, source.text.as_bytes().to_vec())));
        }
        for (path, bytes) in &workspace.blobs {
            files.extend(own(path).map(|path| (path, bytes.to_vec())));
        }
        let mut tera = Tera::new();
        let pages = files.iter().filter(|(path, _)| extension(path) == Some("html"));
        let pages: Vec<(String, String)> =
            pages.map(|(path, bytes)| (path.clone(), String::from_utf8_lossy(bytes).into_owned())).collect();
        if let Err(error) = tera.add_raw_templates(pages) {
            diagnostics.push(broken(&error));
            return None;
        }
        let prefix = format!("{ASSETS}/");
        let mut assets: BTreeMap<String, Vec<u8>> =
            files.into_iter().filter(|(path, _)| path.starts_with(&prefix) && extension(path) != Some("md")).collect();
        assets.entry(format!("{ASSETS}/style.css")).or_default().extend(palette::css().into_bytes());
        join(&mut assets);
        Some(Self { tera, assets })
    }

    /// The assets by their path in the book.
    pub(super) fn assets(&self) -> BTreeMap<String, Vec<u8>> {
        self.assets.clone()
    }

    /// The asset at this path in the book.
    pub(super) fn asset(&self, path: &str) -> Option<&[u8]> {
        self.assets.get(path).map(Vec::as_slice)
    }

    /// Fills a template; a mistake in it is told, and then the text is empty.
    pub(super) fn fill(&self, name: &str, context: &impl Serialize, diagnostics: &mut Vec<Diagnostic>) -> String {
        let filled = Context::from_serialize(context).and_then(|context| self.tera.render(name, &context));
        filled.unwrap_or_else(|error| {
            diagnostics.push(broken(&error));
            String::new()
        })
    }
}

/// Puts the parts of each joined file in its place.
fn join(assets: &mut BTreeMap<String, Vec<u8>>) {
    for (whole, parts) in JOINED {
        let mut bytes = Vec::new();
        for part in parts.iter().filter_map(|part| assets.remove(&format!("{ASSETS}/{part}"))) {
            bytes.extend(part);
            bytes.push(b'\n');
        }
        assets.insert(format!("{ASSETS}/{whole}"), bytes);
    }
}

fn broken(error: &tera::Error) -> Diagnostic {
    Diagnostic::error(Code::Template, format!("a template is broken: {error}")).help(format!(
        "a file in `{TEMPLATES}/` stands in for the embedded one of the same name; remove it to get that back"
    ))
}
