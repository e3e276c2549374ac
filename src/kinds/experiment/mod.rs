//! The life of an experiment: a kind reads its parameters into an experiment, which runs into an outcome, which is drawn.

mod frame;
mod halt;
mod problems;
mod rest;
mod values;

use std::ops::Range;

use serde::Serialize;
use serde::de::DeserializeOwned;

pub use frame::{Entries, Frame};
pub use halt::{Halt, piece};
pub use problems::Problems;
pub use rest::Rest;
pub use values::{Measured, Value, Values};

use crate::catalogue::About;
use crate::chart::Drawing;
use crate::chart::{ChartError, Sheet};
use crate::parameters::{Fields, ParameterDoc, Parameters};
use crate::seed::Seed;

/// A kind of experiment: what can be asked for, how it is computed, and how it is drawn.
///
/// In its file, all above the line `mod drawing {` computes and is part of a result's key; all below only draws and states.
pub trait Kind: Sync + 'static {
    /// What a chapter can choose; declared with `parameters!`.
    type Parameters: Parameters;
    /// What running gives.
    type Data: Serialize + DeserializeOwned;

    /// What the kind tells about itself.
    fn about(&self) -> &'static About;

    /// Fills in what one parameter leaves to another, so that equal questions have equal canonical forms.
    fn settle(&self, _parameters: &mut Self::Parameters) {}

    /// Complains of parameters that cannot go together, before anything runs.
    fn check(&self, parameters: &Self::Parameters, problems: &mut Problems<'_, '_>);

    /// The members of catalogues that the run uses without the parameters naming them.
    fn uses(&self, _parameters: &Self::Parameters) -> Vec<&'static About> {
        Vec::new()
    }

    /// How much there is to compute, in evaluations of an integrand or placements of a point.
    fn weight(&self, parameters: &Self::Parameters) -> u64;

    /// Computes: pure, the same bits for the same arguments on any number of threads.
    fn run(&self, parameters: &Self::Parameters, seed: Seed) -> Result<Self::Data, Failure>;

    /// The named numbers of a result.
    fn values(&self, parameters: &Self::Parameters, data: &Self::Data) -> Values;

    /// The result as columns.
    fn tables(&self, parameters: &Self::Parameters, data: &Self::Data) -> Vec<Frame>;

    /// The result as a figure or a table.
    fn draw(&self, parameters: &Self::Parameters, data: &Self::Data, sheet: &Sheet) -> Result<Drawing, ChartError>;

    /// The result in words, for whoever cannot see it.
    fn alt(&self, parameters: &Self::Parameters, data: &Self::Data) -> Option<String>;
}

/// A kind whose types are hidden: what a catalogue of kinds holds.
pub trait AnyKind: Sync {
    /// What the kind tells about itself.
    fn about(&self) -> &'static About;

    /// Every parameter that a fence of this kind can have.
    fn parameters(&self) -> Vec<ParameterDoc>;

    /// Reads and checks a fence; `None` if anything is wrong, and then all that is wrong is in `fields`.
    fn plan(&'static self, fields: &mut Fields<'_>) -> Option<Box<dyn Experiment>>;
}

/// A validated experiment. How it was written can no longer be seen.
pub trait Experiment: Send + Sync {
    /// The kind of experiment.
    fn kind(&self) -> &'static dyn AnyKind;

    /// The parameters as an object, every default filled in: equal questions give equal objects.
    fn parameters(&self) -> serde_json::Value;

    /// The parameters that the result depends on: all but those that only the drawing reads.
    fn question(&self) -> serde_json::Value {
        self.parameters()
    }

    /// Whose sources belong in the key: the kind, the samplers, scrambles and integrands, by file, without repeats.
    fn abouts(&self) -> Vec<&'static About>;

    /// How much there is to compute, so that the heaviest starts first.
    fn weight(&self) -> u64;

    /// Computes the outcome.
    fn run(&self, seed: Seed) -> Result<Outcome, Failure>;

    /// The outcome that `bytes` encode; `None` if they are anything but a whole outcome of this experiment.
    fn revive(&self, bytes: Vec<u8>) -> Option<Outcome>;

    /// The outcome as a figure or a table.
    fn draw(&self, outcome: &Outcome, sheet: &Sheet) -> Result<Drawing, Failure>;

    /// The outcome in words.
    fn alt(&self, outcome: &Outcome) -> Option<String>;

    /// The outcome as columns.
    fn tables(&self, outcome: &Outcome) -> Vec<Frame>;
}

/// What running an experiment gave.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The typed data in its canonical encoding.
    pub bytes: Vec<u8>,
    /// The named numbers.
    pub values: Values,
}

/// Why an experiment could not be computed or drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// The parameter that is to blame, if one is.
    pub parameter: Option<&'static str>,
    /// What went wrong, in one line.
    pub message: String,
    /// What to do.
    pub help: Option<String>,
}

impl Failure {
    /// A failure that `parameter` is to blame for.
    pub fn of(parameter: &'static str, message: impl Into<String>) -> Self {
        Self { parameter: Some(parameter), message: message.into(), help: None }
    }

    /// With what to do.
    #[must_use]
    pub fn help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }
}

impl<K: Kind> AnyKind for K {
    fn about(&self) -> &'static About {
        Kind::about(self)
    }

    fn parameters(&self) -> Vec<ParameterDoc> {
        K::Parameters::docs()
    }

    fn plan(&'static self, fields: &mut Fields<'_>) -> Option<Box<dyn Experiment>> {
        let before = fields.complaints.len();
        let read = K::Parameters::read(fields);
        let known: Vec<&str> = K::Parameters::docs().iter().map(|doc| doc.name).collect();
        fields.finish(&known);
        let mut parameters = read?;
        self.settle(&mut parameters);
        let wrong: Vec<_> = fields.complaints[before..].iter().map(|complaint| complaint.range.clone()).collect();
        self.check(&parameters, &mut Problems::new(fields));
        // Of a parameter that is wrong, for which a default stands in, nothing more is to be said.
        let blamed = |name: &str| wrong.iter().any(|range| within(range, &fields.place(name)));
        let blamed: Vec<_> = known.iter().filter(|name| blamed(name)).map(|name| fields.place(name)).collect();
        let mut index = 0;
        fields.complaints.retain(|complaint| {
            index += 1;
            index <= before + wrong.len() || !blamed.iter().any(|place| within(&complaint.range, place))
        });
        (fields.complaints.len() == before).then(|| Box::new(Planned { kind: self, parameters }) as Box<dyn Experiment>)
    }
}

/// Whether `inner` lies in `outer`.
fn within(inner: &Range<usize>, outer: &Range<usize>) -> bool {
    outer.start <= inner.start && inner.end <= outer.end
}

/// A kind with its parameters.
struct Planned<K: Kind> {
    kind: &'static K,
    parameters: K::Parameters,
}

impl<K: Kind> Planned<K> {
    /// The data that `bytes` encode, if they are the one encoding of it.
    fn decode(bytes: &[u8]) -> Option<K::Data> {
        let (data, rest) = postcard::take_from_bytes::<K::Data>(bytes).ok()?;
        let again = postcard::to_stdvec(&data).ok()?;
        (rest.is_empty() && again == bytes).then_some(data)
    }
}

impl<K: Kind> Experiment for Planned<K> {
    fn kind(&self) -> &'static dyn AnyKind {
        self.kind
    }

    fn parameters(&self) -> serde_json::Value {
        self.parameters.canonical()
    }

    fn question(&self) -> serde_json::Value {
        let mut question = self.parameters.canonical();
        if let Some(object) = question.as_object_mut() {
            object.retain(|name, _| !K::Parameters::drawn().contains(&name.as_str()));
        }
        question
    }

    fn abouts(&self) -> Vec<&'static About> {
        let mut abouts = self.parameters.abouts();
        abouts.extend(self.kind.uses(&self.parameters));
        abouts.push(Kind::about(self.kind));
        abouts.sort_by_key(|about| about.file);
        abouts.dedup_by_key(|about| about.file);
        abouts
    }

    fn weight(&self) -> u64 {
        self.kind.weight(&self.parameters)
    }

    fn run(&self, seed: Seed) -> Result<Outcome, Failure> {
        let data = self.kind.run(&self.parameters, seed)?;
        let bytes = postcard::to_stdvec(&data).map_err(|error| Failure {
            parameter: None,
            message: format!("the result cannot be encoded: {error}"),
            help: None,
        })?;
        Ok(Outcome { bytes, values: self.kind.values(&self.parameters, &data) })
    }

    fn revive(&self, bytes: Vec<u8>) -> Option<Outcome> {
        let data = Self::decode(&bytes)?;
        Some(Outcome { values: self.kind.values(&self.parameters, &data), bytes })
    }

    fn draw(&self, outcome: &Outcome, sheet: &Sheet) -> Result<Drawing, Failure> {
        let data = Self::decode(&outcome.bytes).ok_or_else(|| Failure {
            parameter: None,
            message: "the result does not decode".to_owned(),
            help: Some("remove the cache and build again".to_owned()),
        })?;
        let drawn = self.kind.draw(&self.parameters, &data, sheet);
        drawn.map_err(|error| Failure { parameter: None, message: error.to_string(), help: None })
    }

    fn alt(&self, outcome: &Outcome) -> Option<String> {
        self.kind.alt(&self.parameters, &Self::decode(&outcome.bytes)?)
    }

    fn tables(&self, outcome: &Outcome) -> Vec<Frame> {
        Self::decode(&outcome.bytes).map(|data| self.kind.tables(&self.parameters, &data)).unwrap_or_default()
    }
}
