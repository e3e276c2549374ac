//! The compiled form: a list of steps on a stack of numbers.

use super::{ExpressionError, Node, Operator, formula, parser};
use crate::stats::portable;
use std::sync::Arc;

/// Room on the stack that needs no allocation; deeper programs allocate theirs.
const STACK: usize = 16;

/// Whole exponents up to this size become multiplications.
const LARGEST_EXPONENT: f64 = 64.0;

/// An expression, compiled; cheap to clone, and shared between threads.
#[derive(Clone)]
pub struct Expression(Arc<Compiled>);

struct Compiled {
    tree: Node,
    steps: Vec<Step>,
    dimensions: usize,
    depth: usize,
}

/// A step of the program.
#[derive(Clone, Copy)]
enum Step {
    Push(f64),
    Variable(usize),
    Negate,
    Operate(Operator),
    /// An operator whose right operand is a number.
    OperateWith(Operator, f64),
    Raise(i32),
    Apply(fn(f64) -> f64),
    Combine(fn(f64, f64) -> f64),
}

impl Expression {
    /// Reads and compiles `text`.
    pub fn parse(text: &str) -> Result<Self, ExpressionError> {
        Ok(Self::compiled(parser::parse(text)?))
    }

    /// The program of `tree`.
    pub(super) fn compiled(tree: Node) -> Self {
        let mut steps = Vec::new();
        let depth = compile(&tree, &mut steps);
        let highest = steps.iter().map(|step| if let Step::Variable(index) = step { index + 1 } else { 0 }).max();
        Self(Arc::new(Compiled { tree, steps, dimensions: highest.unwrap_or(0), depth }))
    }

    /// The highest variable that it names: the dimensions that it needs.
    pub fn dimensions(&self) -> usize {
        self.0.dimensions
    }

    /// It as LaTeX.
    pub fn formula(&self) -> String {
        formula::latex(&self.0.tree)
    }

    /// Its value at `x`; coordinates that are missing count as NaN.
    pub fn evaluate(&self, x: &[f64]) -> f64 {
        if self.0.depth <= STACK { self.run(x, &mut [0.0; STACK]) } else { self.run(x, &mut vec![0.0; self.0.depth]) }
    }

    /// Runs the program; `stack` has room for its depth.
    fn run(&self, x: &[f64], stack: &mut [f64]) -> f64 {
        // The top of the stack stays in a register; below it, `stack[..height]`.
        let (mut top, mut height) = (f64::NAN, 0);
        for step in &self.0.steps {
            match *step {
                Step::Push(value) => {
                    stack[height] = top;
                    height += 1;
                    top = value;
                }
                Step::Variable(index) => {
                    stack[height] = top;
                    height += 1;
                    top = x.get(index).copied().unwrap_or(f64::NAN);
                }
                Step::Negate => top = -top,
                Step::OperateWith(operator, right) => top = operator.apply(top, right),
                Step::Raise(exponent) => top = portable::power(top, exponent),
                Step::Apply(function) => top = function(top),
                Step::Operate(operator) => {
                    height -= 1;
                    top = operator.apply(stack[height], top);
                }
                Step::Combine(function) => {
                    height -= 1;
                    top = function(stack[height], top);
                }
            }
        }
        top
    }
}

/// Appends the steps of `node`, folding constants; the stack that they need.
fn compile(node: &Node, steps: &mut Vec<Step>) -> usize {
    match node {
        Node::Number(value, _) => {
            steps.push(Step::Push(*value));
            1
        }
        Node::Variable(index, _) => {
            steps.push(Step::Variable(*index));
            1
        }
        Node::Negated(inner) => {
            let depth = compile(inner, steps);
            fold(steps, Step::Negate, |value| -value);
            depth
        }
        Node::Unary(function, inner) => {
            let depth = compile(inner, steps);
            fold(steps, Step::Apply(function.apply), function.apply);
            depth
        }
        Node::Binary(function, first, second) => {
            let depth = compile(first, steps).max(1 + compile(second, steps));
            steps.push(Step::Combine(function.apply));
            depth
        }
        Node::Operation(operator, left, right) => {
            let first = compile(left, steps);
            let start = steps.len();
            let second = compile(right, steps);
            if let [Step::Push(value)] = steps[start..] {
                steps.truncate(start);
                operate_with(steps, *operator, value);
                return first;
            }
            steps.push(Step::Operate(*operator));
            first.max(1 + second)
        }
    }
}

/// A step on the last value: done now if that is a number.
fn fold(steps: &mut Vec<Step>, step: Step, now: impl Fn(f64) -> f64) {
    match steps.last_mut() {
        // A lone number at the end is the whole operand: anything longer ends with an operation.
        Some(Step::Push(value)) => *value = now(*value),
        _ => steps.push(step),
    }
}

/// An operator with a number on the right.
fn operate_with(steps: &mut Vec<Step>, operator: Operator, right: f64) {
    let small = right.abs() <= LARGEST_EXPONENT && right.fract() == 0.0;
    if operator == Operator::Power && small {
        let exponent = right as i32;
        fold(steps, Step::Raise(exponent), |value| portable::power(value, exponent));
    } else {
        fold(steps, Step::OperateWith(operator, right), |left| operator.apply(left, right));
    }
}
