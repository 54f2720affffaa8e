//! Variants: the programs of a lab.
//!
//! A lab is a list of variants: `pub static VARIANTS: &[Variant<dyn Simulation>]`. The driver runs
//! the variant that the user names, the graders run all variants, and the benchmarks time them in
//! turns.

use thiserror::Error;

/// A program that simulates a model `S`: an entry in a lab's list, in its tests and in its timings.
pub struct Variant<S: ?Sized> {
    /// The name on the command line, such as `region-locks`.
    pub name: &'static str,
    /// Description in one line for `--list-variants`.
    pub about: &'static str,
    /// The precision with which this variant repeats its results.
    pub reproducibility: Reproducibility,
    /// The parameters that `--param NAME=VALUE` can set.
    pub parameters: &'static [Parameter],
    /// Makes the engine, which has no scene yet and can be loaded any number of times.
    pub build: fn(&Config) -> Result<Box<S>, BuildError>,
}

/// The precision with which a variant repeats its results, from the strictest to the loosest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reproducibility {
    /// The same bits as the naive program, on any scene and any number of workers.
    Bitwise,
    /// The same bits in every run and with any number of workers. Pairs are summed in a different
    /// order than in the naive program, so the last digits differ from its results.
    Deterministic,
    /// The right forces up to rounding. Two runs may differ in the last digits.
    Tolerance,
}

/// A number that the user of a variant can choose.
pub struct Parameter {
    /// The name in `--param NAME=VALUE`.
    pub name: &'static str,
    /// Its meaning, with its unit.
    pub about: &'static str,
    /// The value if it is not set.
    pub default: f64,
    /// The least and the greatest allowed value.
    pub range: (f64, f64),
}

impl Parameter {
    /// Makes a parameter that is 1 for yes and 0 for no.
    pub const fn switch(name: &'static str, about: &'static str, default: bool) -> Self {
        Self { name, about, default: if default { 1.0 } else { 0.0 }, range: (0.0, 1.0) }
    }
}

/// The settings of a variant that the user chose.
#[derive(Clone, Debug)]
pub struct Config {
    /// Number of threads that may work. A serial variant uses one thread whatever this number is.
    pub threads: usize,
    /// Whether [`statistics`](crate::soft::Simulation::statistics) will be called.
    ///
    /// Collecting statistics takes time, which a run without statistics saves.
    pub statistics: bool,
    /// Whether the [`Event`](crate::Event)s of the ranks will be read.
    pub events: bool,
    parameters: Vec<(&'static str, f64)>,
}

/// An error for a parameter that a variant does not have, or for a value outside its range.
#[derive(Debug, Error, PartialEq)]
#[error("{0}")]
pub struct ParameterError(String);

/// The reason why an engine could not be made on this machine, such as a missing graphics adapter.
#[derive(Debug, Error, PartialEq)]
#[error("{0}")]
pub struct BuildError(pub String);

/// Makes a variant whose results equal those of the naive program bit for bit.
pub const fn bitwise<S: ?Sized>(
    name: &'static str,
    about: &'static str,
    parameters: &'static [Parameter],
    build: fn(&Config) -> Result<Box<S>, BuildError>,
) -> Variant<S> {
    Variant { name, about, reproducibility: Reproducibility::Bitwise, parameters, build }
}

/// Makes a variant whose results have the same bits in every run, but not the naive program's bits.
pub const fn deterministic<S: ?Sized>(
    name: &'static str,
    about: &'static str,
    parameters: &'static [Parameter],
    build: fn(&Config) -> Result<Box<S>, BuildError>,
) -> Variant<S> {
    Variant { name, about, reproducibility: Reproducibility::Deterministic, parameters, build }
}

impl<S: ?Sized> Variant<S> {
    /// Returns a configuration with one thread, without statistics, and with every parameter at its
    /// default.
    pub fn config(&self) -> Config {
        Config {
            threads: 1,
            statistics: false,
            events: false,
            parameters: self.parameters.iter().map(|k| (k.name, k.default)).collect(),
        }
    }

    /// Sets one parameter of `config`, which must come from [`Variant::config`].
    ///
    /// # Errors
    /// The variant has no such parameter, or the value is outside its range.
    pub fn set(&self, config: &mut Config, name: &str, value: f64) -> Result<(), ParameterError> {
        let variant = self.name;
        let Some(parameter) = self.parameters.iter().find(|k| k.name == name) else {
            let known: Vec<_> = self.parameters.iter().map(|k| k.name).collect();
            let has = if known.is_empty() { "" } else { "; it has: " };
            let what = format!("variant {variant} has no parameter '{name}'{has}");
            return Err(ParameterError(what + &known.join(", ")));
        };
        let (least, greatest) = parameter.range;
        if !(least..=greatest).contains(&value) {
            return Err(ParameterError(format!(
                "parameter '{name}' of variant {variant} must be {least} to {greatest}, not {value}"
            )));
        }
        for (known, current) in &mut config.parameters {
            if *known == parameter.name {
                *current = value;
            }
        }
        Ok(())
    }
}

impl Config {
    /// Changes the number of threads.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.threads = threads;
        self
    }

    /// Returns the value of a parameter that the variant declares.
    ///
    /// # Panics
    /// The variant does not declare the parameter. This is a mistake in the lab, not in its input.
    pub fn parameter(&self, name: &str) -> f64 {
        let known = self.parameters.iter().find(|(known, _)| *known == name);
        known.unwrap_or_else(|| panic!("this variant declares no parameter '{name}'")).1
    }
}
