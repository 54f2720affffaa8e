//! Where submissions are built, one after another.

use anyhow::Result;

use super::Options;
use super::feedback::Bench;
use super::tree::Tree;
use crate::kit::{Kit, Lab};

/// Where one submission after another is built.
pub(super) struct Workplace {
    /// With a probe.
    pub(super) tree: Tree,
    /// With the lab's own tests, if they are to run.
    pub(super) bench: Option<Bench>,
}

impl Workplace {
    pub(super) fn lay(kit: &Kit, lab: Lab, options: &Options) -> Result<Self> {
        let bench = if options.no_tests { None } else { Some(Bench::lay(kit, lab)?) };
        Ok(Self { tree: Tree::lay(kit, lab)?, bench })
    }
}
