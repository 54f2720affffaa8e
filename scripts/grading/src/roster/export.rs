//! Reads Gradescope's `submission_metadata.yml`.
//!
//! The file contains the students and the hand-in time of each exported submission.

use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use jiff::Timestamp;
use yaml_rust2::{Yaml, YamlLoader};

use crate::submission::names::METADATA;

/// Hand-ins by the names of their folders; empty if there is no file.
#[derive(Debug, Default)]
pub(super) struct Export(BTreeMap<String, HandIn>);

/// Hand-in of one student or of a group.
#[derive(Debug, Default)]
pub(super) struct HandIn {
    pub(super) members: Vec<Member>,
    pub(super) time: Option<Timestamp>,
}

/// A student, as Gradescope lists them.
#[derive(Debug)]
pub(super) struct Member {
    pub(super) name: String,
    /// E-mail address, number and name, as far as the file contains them.
    pub(super) keys: Vec<String>,
}

impl Export {
    /// Reads the file in a folder of records.
    ///
    /// # Errors
    /// If the file cannot be read, or is not an export of Gradescope.
    pub(super) fn read(folder: &Path) -> Result<Self> {
        let path = folder.join(METADATA);
        match fs::read_to_string(&path) {
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(Self::default()),
            text => Self::parse(&text?),
        }
        .with_context(|| format!("cannot read {}", path.display()))
    }

    fn parse(text: &str) -> Result<Self> {
        let documents = YamlLoader::load_from_str(text)?;
        let all = documents.first().and_then(Yaml::as_hash);
        let all = all.context("it does not begin with the name of a submission")?;
        let mut submissions = BTreeMap::new();
        for (name, about) in all {
            let name = name.as_str().context("a submission has no name")?;
            let hand_in = HandIn::of(about).with_context(|| name.to_owned())?;
            submissions.insert(name.to_owned(), hand_in);
        }
        Ok(Self(submissions))
    }

    /// Returns the hand-in of a submission; `None` if the file does not list it.
    pub(super) fn of(&self, submission: &str) -> Option<&HandIn> {
        self.0.get(submission)
    }

    /// Whether the file lists no submission.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl HandIn {
    fn of(about: &Yaml) -> Result<Self> {
        let submitters = about[":submitters"].as_vec().context("it has no :submitters:")?;
        let members: Vec<Member> = submitters.iter().map(Member::of).collect();
        ensure!(members.iter().all(|member| !member.keys.is_empty()), "a submitter has no name");
        let time = about[":created_at"].as_str().map(time).transpose()?;
        Ok(Self { members, time })
    }

    /// Returns all names, for a class without a roster.
    pub(super) fn names(&self) -> String {
        let names: Vec<&str> = self.members.iter().map(|member| member.name.as_str()).collect();
        names.join(" and ")
    }
}

impl Member {
    fn of(submitter: &Yaml) -> Self {
        let fields = [":email", ":sid", ":name"].map(|field| match &submitter[field] {
            Yaml::String(text) => text.clone(),
            Yaml::Integer(number) => number.to_string(),
            _ => String::new(),
        });
        let name = fields[2].clone();
        let mut keys = Vec::from(fields);
        keys.retain(|key| !key.is_empty());
        Self { name, keys }
    }
}

/// Parses a time such as `2026-11-20 21:59:03.123456000 Z`, with a space before the zone.
fn time(text: &str) -> Result<Timestamp> {
    let parts: Vec<&str> = text.split_whitespace().collect();
    let [day, rest @ ..] = &parts[..] else { return Ok(text.parse()?) };
    let time = format!("{day}T{}", rest.concat()).parse();
    time.with_context(|| format!("'{text}' is no time such as 2026-11-20 21:59:03 Z"))
}

#[cfg(test)]
mod tests {
    use super::Export;

    const GROUP: &str = "---\nsubmission_7:\n  :submitters:\n  - :name: \"Zo\\xEB O'Neil: PhD\"\n    :sid: '0042'\n    \
                         :email: zoe@example.org\n  - :name: Ada Lovelace\n    :sid:\n    :email: ada@example.org\n  \
                         :created_at: 2026-11-20 13:59:03.123456000 -08:00\n  :score: 0.0\n  :history:\n  - :id: 6\n    \
                         :created_at: 2026-11-19 13:00:00 Z\n";

    #[test]
    fn a_group_and_its_time_are_read() {
        let export = Export::parse(GROUP).unwrap();
        let group = export.of("submission_7").unwrap();
        assert_eq!(group.names(), "Zo\u{eb} O'Neil: PhD and Ada Lovelace");
        assert_eq!(group.members[0].keys[..2], ["zoe@example.org", "0042"]);
        assert_eq!(group.members[1].keys, ["ada@example.org", "Ada Lovelace"]);
        assert_eq!(group.time.unwrap().to_string(), "2026-11-20T21:59:03.123456Z");
        assert!(export.of("submission_8").is_none());
    }

    #[test]
    fn another_file_of_that_name_is_refused() {
        for (text, why) in [
            ("- a\n", "does not begin"),
            ("submission_7:\n  :score: 1\n", "submission_7: it has no :submitters:"),
            (
                "submission_7:\n  :submitters:\n  - :name: A\n  :created_at: noon\n",
                "'noon' is no time",
            ),
            ("a: [", "while parsing"),
        ] {
            let error = format!("{:#}", Export::parse(text).unwrap_err());
            assert!(error.contains(why), "{error}");
        }
    }
}
