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
    pub promise: Promise,
    /// What `--set NAME=VALUE` can adjust.
    pub knobs: &'static [Knob],
    /// Makes the engine. It holds no scene yet and can be loaded again and again.
    pub build: fn(&Settings) -> Result<Box<S>, BuildError>,
}

/// What a variant's results may be compared with, from the strictest to the loosest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Promise {
    /// The same bits as the naive program, on any scene and any number of workers.
    Canonical,
    /// The same bits in every run and with any number of workers, but pairs are summed in an
    /// order of its own, so that the last digits differ from the naive program's.
    Repeatable,
    /// The right forces up to rounding; two runs may differ in the last digits.
    Rounded,
}

/// A number that a variant lets its user choose.
pub struct Knob {
    /// The name in `--set NAME=VALUE`.
    pub name: &'static str,
    /// What it is, with its unit.
    pub about: &'static str,
    /// The value if nobody sets it.
    pub default: f64,
    /// The least and the greatest value that make sense.
    pub range: (f64, f64),
}

/// What a user asked of a variant.
#[derive(Clone, Debug)]
pub struct Settings {
    /// How many threads may work (a serial variant uses one all the same).
    pub threads: usize,
    /// Whether [`statistics`](crate::soft::Simulation::statistics) will be asked for. Collecting
    /// costs time, so nobody pays for it who does not look.
    pub statistics: bool,
    knobs: Vec<(&'static str, f64)>,
}

/// A setting that a variant does not have, or a value outside its range.
#[derive(Debug, Error, PartialEq)]
pub enum SettingsError {
    /// No knob of that name.
    #[error("variant {variant} has no setting '{name}'{}", known(.knobs))]
    Unknown {
        /// The variant's name.
        variant: &'static str,
        /// What was asked for.
        name: String,
        /// What there is.
        knobs: Vec<&'static str>,
    },
    /// The knob does not turn that far.
    #[error("setting '{name}' of variant {variant} must lie in {least} to {greatest}, not {value}")]
    Range {
        /// The variant's name.
        variant: &'static str,
        /// The knob's name.
        name: &'static str,
        /// What was asked for.
        value: f64,
        /// The least value.
        least: f64,
        /// The greatest value.
        greatest: f64,
    },
}

/// Why an engine could not be made on this machine, such as a missing graphics adapter.
#[derive(Debug, Error, PartialEq)]
#[error("{0}")]
pub struct BuildError(pub String);

impl<S: ?Sized> Variant<S> {
    /// One thread, no statistics, every knob at its default.
    pub fn settings(&self) -> Settings {
        Settings {
            threads: 1,
            statistics: false,
            knobs: self.knobs.iter().map(|k| (k.name, k.default)).collect(),
        }
    }

    /// Turns one knob of `settings`, which must come from [`Variant::settings`].
    ///
    /// # Errors
    /// The variant has no such knob, or the value is outside its range.
    pub fn set(
        &self,
        settings: &mut Settings,
        name: &str,
        value: f64,
    ) -> Result<(), SettingsError> {
        let Some(knob) = self.knobs.iter().find(|k| k.name == name) else {
            return Err(SettingsError::Unknown {
                variant: self.name,
                name: name.into(),
                knobs: self.knobs.iter().map(|k| k.name).collect(),
            });
        };
        let (least, greatest) = knob.range;
        if !(least..=greatest).contains(&value) {
            return Err(SettingsError::Range {
                variant: self.name,
                name: knob.name,
                value,
                least,
                greatest,
            });
        }
        for (known, current) in &mut settings.knobs {
            if *known == knob.name {
                *current = value;
            }
        }
        Ok(())
    }
}

impl Settings {
    /// The same settings with another number of threads.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.threads = threads;
        self
    }

    /// The same settings with statistics collected.
    #[must_use]
    pub fn with_statistics(mut self) -> Self {
        self.statistics = true;
        self
    }

    /// The value of a knob that the variant declares.
    ///
    /// # Panics
    /// The variant does not declare it: a mistake in the lab, not in its input.
    pub fn knob(&self, name: &str) -> f64 {
        let known = self.knobs.iter().find(|(known, _)| *known == name);
        known.unwrap_or_else(|| panic!("this variant declares no knob '{name}'")).1
    }
}

fn known(knobs: &[&'static str]) -> String {
    if knobs.is_empty() { String::new() } else { format!("; it has: {}", knobs.join(", ")) }
}
