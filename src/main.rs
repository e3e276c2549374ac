//! The program: hand the arguments to [`workbook::cli`], and exit as it says.

use std::process::ExitCode;

fn main() -> ExitCode {
    workbook::cli::run()
}
