//! Where submissions are built, one after another.

mod cache;
mod clean;
mod lab_tests;
pub(crate) mod tree;

use anyhow::Result;

use crate::sandbox::Sandbox;
use lab_kit::{Kit, Lab};
use lab_tests::Bench;
use tree::Tree;

/// Where one submission after another is built.
pub(crate) struct Workplace {
    /// With a probe.
    pub(crate) tree: Tree,
    /// With the lab's own tests, if they are to run.
    pub(crate) bench: Option<Bench>,
}

impl Workplace {
    /// Lays the first one, with tests if they are to run; nothing is built in it yet.
    pub(crate) fn lay(kit: &Kit, lab: Lab, sandbox: &Sandbox, tests: bool) -> Result<Self> {
        let bench = tests.then(|| Bench::lay(kit, lab, sandbox)).transpose()?;
        Ok(Self { tree: Tree::lay(kit, lab, sandbox)?, bench })
    }

    /// This one, and so many more with what is built in it.
    pub(crate) fn with_copies(self, count: usize, sandbox: &Sandbox) -> Result<Vec<Self>> {
        if let Some(bench) = &self.bench
            && (count > 0 || !bench.is_kept()?)
        {
            eprintln!("Building its tests");
            bench.cache(sandbox)?;
        }
        let copy = || {
            let bench = self.bench.as_ref().map(|bench| bench.copy(sandbox)).transpose()?;
            Ok(Self { tree: self.tree.copy(sandbox)?, bench })
        };
        let copies = (0..count).map(|_| copy()).collect::<Result<Vec<_>>>()?;
        Ok([self].into_iter().chain(copies).collect())
    }
}
