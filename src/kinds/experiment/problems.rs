//! Problems: what is wrong with parameters that are each right but cannot go together.

use std::ops::Range;

use crate::diag::Code;
use crate::parameters::{Complaint, Fields, place_of};
use crate::samplers::{Method, Refused};

/// Where a kind complains of its parameters before anything runs.
pub struct Problems<'p, 'a> {
    fields: &'p mut Fields<'a>,
}

impl<'p, 'a> Problems<'p, 'a> {
    /// Complaints go to `fields`, which know the places.
    pub fn new(fields: &'p mut Fields<'a>) -> Self {
        Self { fields }
    }

    /// Complains of the parameter `name`.
    pub fn at(&mut self, name: &str, code: Code, message: impl Into<String>, help: Option<String>) {
        let place = self.fields.place(name);
        self.fields.complaints.push(Complaint::new(code, place, message).help_if(help));
    }

    /// Complains of element `index` of the list `name` (called `alias` perhaps).
    pub fn element(&mut self, name: &str, index: usize, code: Code, message: impl Into<String>, help: Option<String>) {
        let place = self.element_place(name, index);
        self.fields.complaints.push(Complaint::new(code, place, message).help_if(help));
    }

    /// Complains of every count of the parameter `n`, and of every dimension, that one of `methods` cannot give.
    /// `samplers` names the parameter that holds the methods.
    pub fn admit(&mut self, samplers: &str, methods: &[Method], counts: &[usize], d: usize) {
        for (index, method) in methods.iter().enumerate() {
            let mut refused: Vec<(Range<usize>, Refusals)> = Vec::new();
            for &n in counts {
                match method.admits(n, d) {
                    Ok(()) => {}
                    Err(Refused::Count { n, below, above, rule }) => {
                        let place = self.count_place(n);
                        let same = refused.iter_mut().find(|(other, _)| *other == place);
                        match same {
                            Some((_, refusals)) => refusals.counts.push((n, below, above)),
                            None => refused.push((place, Refusals { rule, counts: vec![(n, below, above)] })),
                        }
                    }
                    Err(other) => {
                        let help = "choose another sampler, or an integrand of fewer dimensions".to_owned();
                        let message = format!("`{}`: {other}", method.name());
                        self.element(samplers, index, Code::Combination, message, Some(help));
                        break;
                    }
                }
            }
            for (place, refusals) in refused {
                let message = refusals.message(method, d);
                let complaint = Complaint::new(Code::Count, place, message).help(refusals.offer());
                self.fields.complaints.push(complaint);
            }
        }
    }

    fn element_place(&self, name: &str, index: usize) -> Range<usize> {
        let singular = name.strip_suffix('s').unwrap_or(name);
        let value = self.fields.value(name).or_else(|| self.fields.value(singular));
        let Some(value) = value else { return self.fields.place(name) };
        let element = value.get_ref().as_array().and_then(|elements| elements.get(index));
        element.unwrap_or(value).span()
    }

    fn count_place(&self, n: usize) -> Range<usize> {
        self.fields.value("n").map_or_else(|| self.fields.place("n"), |value| place_of(value, n))
    }
}

/// The counts at one place that a sampler refused, each with the nearest below and above.
struct Refusals {
    rule: &'static str,
    counts: Vec<(usize, Option<usize>, Option<usize>)>,
}

impl Refusals {
    fn message(&self, method: &Method, d: usize) -> String {
        let counts: Vec<String> = self.counts.iter().map(|(n, ..)| n.to_string()).collect();
        let counts = match counts.as_slice() {
            [one] => one.clone(),
            [first, .., last] if counts.len() > 4 => format!("{} counts from {first} to {last}", counts.len()),
            [most @ .., last] => format!("{} or {last}", most.join(", ")),
            [] => String::new(),
        };
        let name = method.name();
        let s = if d == 1 { "" } else { "s" };
        format!("`{name}` cannot give {counts} points in {d} dimension{s}: n must be {}", self.rule)
    }

    fn offer(&self) -> String {
        let nearest = |(n, below, above): &(usize, Option<usize>, Option<usize>)| {
            let offers: Vec<String> = [below, above].into_iter().flatten().map(usize::to_string).collect();
            let offers = if offers.is_empty() { "none".to_owned() } else { offers.join(" and ") };
            if self.counts.len() == 1 { offers } else { format!("{offers} for {n}") }
        };
        let shown: Vec<String> = self.counts.iter().take(3).map(nearest).collect();
        let more = if self.counts.len() > 3 { ", ..." } else { "" };
        format!("the nearest counts are {}{more}", shown.join(", "))
    }
}
