//! How a lab names its programs.
//!
//! A lab is a list of variants: `pub static VARIANTS: &[Variant<dyn Simulation>]`. The driver
//! runs one by name, the graders run all of them, the benchmarks time them side by side.

use thiserror::Error;

/// One way to simulate a model `S`: a row of a lab's list, of its tests and of its timings.
pub struct Variant<S: ?Sized> {
    /// The name on the command line, such as `region-locks`.
    pub name: &'static str,
    /// One line for `--list-variants`.
    pub about: &'static str,
    /// What its results may be compared with.
    pub reproducibility: Reproducibility,
    /// What `--param NAME=VALUE` can adjust.
    pub parameters: &'static [Parameter],
    /// Makes the engine. It holds no scene yet and can be loaded again and again.
    pub build: fn(&Config) -> Result<Box<S>, BuildError>,
}

/// How exactly a variant repeats its results, from the strictest to the loosest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reproducibility {
    /// The same bits as the naive program, on any scene and any number of workers.
    Bitwise,
    /// The same bits in every run and with any number of workers, but pairs are summed in an
    /// order of its own, so that the last digits differ from the naive program's.
    Deterministic,
    /// The right forces up to rounding; two runs may differ in the last digits.
    Tolerance,
}

/// A number that a variant lets its user choose.
pub struct Parameter {
    /// The name in `--param NAME=VALUE`.
    pub name: &'static str,
    /// Its meaning, with its unit.
    pub about: &'static str,
    /// The value if it is not set.
    pub default: f64,
    /// The least and the greatest value that make sense.
    pub range: (f64, f64),
}

impl Parameter {
    /// A parameter that is 1 for yes and 0 for no.
    pub const fn switch(name: &'static str, about: &'static str, default: bool) -> Self {
        Self { name, about, default: if default { 1.0 } else { 0.0 }, range: (0.0, 1.0) }
    }
}

/// The settings that a user gave to a variant.
#[derive(Clone, Debug)]
pub struct Config {
    /// How many threads may work (a serial variant uses one all the same).
    pub threads: usize,
    /// Whether [`statistics`](crate::soft::Simulation::statistics) will be asked for. Collecting
    /// costs time, which a run without statistics does not pay.
    pub statistics: bool,
    /// Whether the [`Event`](crate::Event)s of the ranks will be asked for.
    pub events: bool,
    parameters: Vec<(&'static str, f64)>,
}

/// A parameter that a variant does not have, or a value outside its range.
#[derive(Debug, Error, PartialEq)]
#[error("{0}")]
pub struct ParameterError(String);

/// Why an engine could not be made on this machine, such as a missing graphics adapter.
#[derive(Debug, Error, PartialEq)]
#[error("{0}")]
pub struct BuildError(pub String);

/// A variant with the bits of the naive program.
pub const fn bitwise<S: ?Sized>(
    name: &'static str,
    about: &'static str,
    parameters: &'static [Parameter],
    build: fn(&Config) -> Result<Box<S>, BuildError>,
) -> Variant<S> {
    Variant { name, about, reproducibility: Reproducibility::Bitwise, parameters, build }
}

/// A variant that gives the same bits in every run, and last digits of its own.
pub const fn deterministic<S: ?Sized>(
    name: &'static str,
    about: &'static str,
    parameters: &'static [Parameter],
    build: fn(&Config) -> Result<Box<S>, BuildError>,
) -> Variant<S> {
    Variant { name, about, reproducibility: Reproducibility::Deterministic, parameters, build }
}

impl<S: ?Sized> Variant<S> {
    /// One thread, no statistics, every parameter at its default.
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
                "parameter '{name}' of variant {variant} must lie in {least} to {greatest}, not {value}"
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
    /// The same with another number of threads.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.threads = threads;
        self
    }

    /// The value of a parameter that the variant declares.
    ///
    /// # Panics
    /// The variant does not declare it: a mistake in the lab, not in its input.
    pub fn parameter(&self, name: &str) -> f64 {
        let known = self.parameters.iter().find(|(known, _)| *known == name);
        known.unwrap_or_else(|| panic!("this variant declares no parameter '{name}'")).1
    }
}
