//! Files of a submission, which are sources, may be sources, or are left out.

use std::collections::BTreeMap;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use anyhow::{Result, ensure};

use super::loose::{self, Loose};
use super::names::{ELSEWHERE, is_called_archive, is_macos, resolve};
use lab_kit::Lab;
use lab_kit::sources::{COUNT_LIMIT, FILE_LIMIT, NOT_PLAIN, Sources, TOO_LARGE};

/// Maximal number of omitted files whose names are shown.
pub(super) const NAMED: usize = 100;

/// Contents of a submission.
#[derive(Debug, Default)]
pub(crate) struct HandedIn {
    /// Sources by lab. Labs without any source are missing.
    pub(crate) labs: BTreeMap<Lab, Sources>,
    /// Files that are left out, with the reasons.
    pub(crate) left_out: Vec<(PathBuf, &'static str)>,
    /// Files in other folders that may be sources. They are left out too, unless they are the lab's
    /// only files.
    pub(super) loose: Vec<Loose>,
    /// Archives inside this archive.
    pub(super) archives: Vec<Vec<u8>>,
}

impl HandedIn {
    /// Adds a file if it is a source of a lab. Returns the number of bytes read.
    pub(super) fn add<R: Read>(
        &mut self,
        path: &Path,
        plain: bool,
        size: u64,
        open: impl FnOnce() -> io::Result<R>,
    ) -> Result<u64> {
        if is_macos(path) {
            return Ok(0);
        }
        let source = if plain { resolve(path) } else { Err(NOT_PLAIN) };
        let source =
            source.and_then(|found| if size > FILE_LIMIT { Err(TOO_LARGE) } else { Ok(found) });
        let may_count = source == Err(ELSEWHERE) && size <= FILE_LIMIT;
        let is_loose = may_count && loose::may_be(path);
        let is_archive = may_count && is_called_archive(path);
        if let Err(why) = source {
            self.leave_out(path, why);
        }
        let kept = self.loose.len() + self.archives.len();
        if source.is_err() && (!(is_loose || is_archive) || kept >= COUNT_LIMIT) {
            return Ok(0);
        }
        let mut bytes = Vec::new();
        // The size in an archive may be wrong, so the file itself is limited.
        open()?.take(FILE_LIMIT + 1).read_to_end(&mut bytes)?;
        let read = bytes.len() as u64;
        if read > FILE_LIMIT {
            self.leave_out(path, TOO_LARGE);
            return Ok(read);
        }
        let Ok((lab, below)) = source else {
            if is_archive {
                self.archives.push(bytes);
            } else {
                self.loose.push((path.to_owned(), bytes));
            }
            return Ok(read);
        };
        let files = self.labs.entry(lab).or_default();
        ensure!(files.len() < COUNT_LIMIT, "there are more than {COUNT_LIMIT} files in it");
        let twice = files.insert(below, bytes).is_some();
        ensure!(!twice, "{} is in it twice", path.display());
        Ok(read)
    }

    fn leave_out(&mut self, path: &Path, why: &'static str) {
        if self.left_out.len() < NAMED {
            self.left_out.push((path.to_owned(), why));
        }
    }
}
