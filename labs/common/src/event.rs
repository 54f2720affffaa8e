//! Events of ranks: the times at which a rank computes, communicates or waits.
//!
//! The option `--events FILE` writes them to a file, one per line.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// An activity of a rank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Activity {
    /// The rank computes alone.
    Compute,
    /// The rank is in a call that involves other ranks, and its partners are in the same call.
    Communicate,
    /// The rank is in a call that involves other ranks, and one of its partners has not entered the
    /// call yet.
    Wait,
}

/// A period in which a rank has one activity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Number of the rank.
    pub rank: u32,
    /// Number of the step, counted from 0.
    pub step: u32,
    /// The activity.
    pub activity: Activity,
    /// Start of the period, in seconds from the start of the run.
    pub begin: f64,
    /// End of the period, in seconds from the start of the run.
    pub end: f64,
}

/// An error for a line that is not an event.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("expected 'rank step activity begin end', found '{0}'")]
pub struct EventError(String);

impl Activity {
    /// All activities.
    pub const ALL: [Self; 3] = [Self::Compute, Self::Communicate, Self::Wait];

    /// Returns the activity's name in a file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Compute => "compute",
            Self::Communicate => "communicate",
            Self::Wait => "wait",
        }
    }
}

/// Writes the event as a line: rank, step, activity, begin and end, with nine decimals.
impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rank, step, activity, begin, end } = self;
        write!(f, "{rank} {step} {} {begin:.9} {end:.9}", activity.name())
    }
}

impl FromStr for Event {
    type Err = EventError;

    fn from_str(line: &str) -> Result<Self, EventError> {
        Self::read(line).ok_or_else(|| EventError(line.into()))
    }
}

impl Event {
    /// Reads a line; `None` if the line is not an event.
    fn read(line: &str) -> Option<Self> {
        let [rank, step, name, begin, end] = line.split(' ').collect::<Vec<_>>()[..] else {
            return None;
        };
        Some(Self {
            rank: rank.parse().ok()?,
            step: step.parse().ok()?,
            activity: Activity::ALL.into_iter().find(|activity| activity.name() == name)?,
            begin: begin.parse().ok()?,
            end: end.parse().ok()?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_read_as_it_is_written() {
        let line = "2 17 wait 0.125000000 0.250000001";
        let event: Event = line.parse().unwrap();
        assert_eq!((event.activity, event.end), (Activity::Wait, 0.250_000_001));
        assert_eq!(event.to_string(), line);
        for odd in ["", "2 17 sleep 0 1", "2 17 wait 0", "2 17 wait 0 1 2"] {
            assert_eq!(odd.parse::<Event>(), Err(EventError(odd.into())));
        }
    }
}
