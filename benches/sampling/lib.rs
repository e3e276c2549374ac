//! Nothing of its own: the benches beside this file measure the samplers and measures of `workbook`.
