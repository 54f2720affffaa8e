//! Where submissions are built, one after another.

use anyhow::Result;

use super::Options;
use super::feedback::Bench;
use super::sandbox::Sandbox;
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
    /// Lays the first one; nothing is built in it yet.
    pub(super) fn lay(kit: &Kit, lab: Lab, options: &Options, sandbox: &Sandbox) -> Result<Self> {
        let bench = if options.no_tests { None } else { Some(Bench::lay(kit, lab, sandbox)?) };
        Ok(Self { tree: Tree::lay(kit, lab, sandbox)?, bench })
    }

    /// So many more, with what is built in this one.
    pub(super) fn copies(&self, count: usize, sandbox: &Sandbox) -> Result<Vec<Self>> {
        if let Some(bench) = &self.bench
            && (count > 0 || !bench.is_kept()?)
        {
            bench.warm(sandbox)?;
        }
        let copy = || {
            let bench = self.bench.as_ref().map(|bench| bench.copy(sandbox)).transpose()?;
            Ok(Self { tree: self.tree.copy(sandbox)?, bench })
        };
        (0..count).map(|_| copy()).collect()
    }
}
