//! Seeds and streams (placeholder API).
