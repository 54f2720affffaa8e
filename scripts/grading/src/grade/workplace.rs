//! Where submissions are built, one after another.

use anyhow::Result;

use super::feedback::Bench;
use super::progress::stage;
use super::sandbox::Sandbox;
use super::tree::Tree;
use lab_kit::{Kit, Lab};

/// Where one submission after another is built.
pub(super) struct Workplace {
    /// With a probe.
    pub(super) tree: Tree,
    /// With the lab's own tests, if they are to run.
    pub(super) bench: Option<Bench>,
}

impl Workplace {
    /// Lays the first one, with tests if they are to run; nothing is built in it yet.
    pub(super) fn lay(kit: &Kit, lab: Lab, sandbox: &Sandbox, tests: bool) -> Result<Self> {
        let bench = tests.then(|| Bench::lay(kit, lab, sandbox)).transpose()?;
        Ok(Self { tree: Tree::lay(kit, lab, sandbox)?, bench })
    }

    /// This one, and so many more with what is built in it.
    pub(super) fn with_copies(self, count: usize, sandbox: &Sandbox) -> Result<Vec<Self>> {
        if let Some(bench) = &self.bench
            && (count > 0 || !bench.is_kept()?)
        {
            stage("Building its tests");
            bench.warm(sandbox)?;
        }
        let copy = || {
            let bench = self.bench.as_ref().map(|bench| bench.copy(sandbox)).transpose()?;
            Ok(Self { tree: self.tree.copy(sandbox)?, bench })
        };
        let copies = (0..count).map(|_| copy()).collect::<Result<Vec<_>>>()?;
        Ok([self].into_iter().chain(copies).collect())
    }
}
