//! Lists of students: CSV files exported by Canvas, Moodle, Gradescope or Classroom 50.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};
use csv::{ReaderBuilder, StringRecord};

use unicode_normalization::char::is_combining_mark;

use crate::submission::names::composed;
use lab_kit::files::read_bytes;

/// Columns with a student's whole name.
const NAMES: [&str; 2] = ["Student", "Full name"];
const NAME_PARTS: [(&str, &str); 4] = [
    ("First name", "Last name"),
    ("First name", "Surname"),
    ("First Name", "Last Name"),
    ("first_name", "last_name"),
];
const IDS: [&str; 12] = [
    "ID",
    "SIS User ID",
    "SIS Login ID",
    "Integration ID",
    "Identifier",
    "ID number",
    "Email address",
    "Username",
    "SID",
    "Email",
    "email",
    "username",
];

/// Name of the artificial student that Canvas adds.
const TEST_STUDENT: &str = "Student, Test";

/// Platform and kind of a file, which determine where the marks are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// Gradebook of Canvas: a column `Lab 3 (4711)`, and the possible points in an extra row.
    Canvas,
    /// Grading worksheet of one assignment in Moodle: a column `Grade`, and `Maximum Grade` beside
    /// it.
    Worksheet,
    /// Gradebook of Moodle: a column `Assignment: Lab 3 (Real)`.
    Gradebook,
    /// Roster of Gradescope: no marks, and a role for each person.
    Gradescope,
    /// Roster of Classroom 50, with GitHub user names: no marks.
    Classroom,
}

/// Columns by which the form of a file is known. The first column identifies a student. The first
/// form whose columns are present is used.
const FORMS: [(Form, &[&str]); 5] = [
    (Form::Canvas, &["ID", "Student"]),
    (Form::Worksheet, &["Identifier", "Full name", "Grade"]),
    (Form::Gradebook, &["Email address", "First name"]),
    (Form::Gradescope, &["Email", "First Name", "Last Name", "SID"]),
    (Form::Classroom, &["username", "first_name", "last_name"]),
];

/// The students of a class.
#[derive(Debug)]
pub(super) struct Roster {
    pub(super) path: PathBuf,
    pub(super) form: Form,
    pub(super) header: StringRecord,
    pub(super) rows: Vec<(u64, StringRecord)>,
    pub(super) students: Vec<Student>,
}

/// A student, from one row of the roster.
#[derive(Debug)]
pub(super) struct Student {
    pub(super) row: usize,
    pub(super) name: String,
    /// E-mail address, or else the platform's identifier of the student.
    pub(super) address: String,
    /// Names under which this student's submission may appear.
    pub(super) keys: Vec<String>,
}

impl Roster {
    pub(super) fn read(path: &Path) -> Result<Self> {
        let (header, rows) = table(path)?;
        let mut forms = FORMS.iter();
        let form = forms.find(|(_, names)| names.iter().all(|it| column(&header, it).is_some()));
        let (form, columns) = *form.with_context(|| {
            format!(
                "{}, line 1: there are neither Canvas's columns (Student, ID) nor Moodle's \
                 (Identifier, Full name, Grade; or First name, Last name, Email address), Gradescope's \
                 (First Name, Last Name, SID, Email) or Classroom 50's (username, first_name, last_name)",
                path.display()
            )
        })?;
        let mut roster = Self { path: path.to_owned(), form, header, rows, students: Vec::new() };
        roster.students = roster.read_students(columns[0])?;
        Ok(roster)
    }

    fn read_students(&self, id: &str) -> Result<Vec<Student>> {
        let mut seen = BTreeMap::new();
        let mut students = Vec::new();
        for (row, (line, cells)) in self.rows.iter().enumerate() {
            let cell = |name: &str| Some(cells[column(&self.header, name)?].trim());
            let full_name = NAMES.iter().find_map(|name| cell(name)).unwrap_or_default().to_owned();
            let parts =
                NAME_PARTS.iter().find_map(|(first, last)| Some([cell(first)?, cell(last)?]));
            let name = parts.map_or(full_name, |parts| parts.join(" "));
            let own = cell(id).unwrap_or_default();
            // Canvas adds rows that describe the columns.
            if self.form == Form::Canvas && (own.is_empty() || name == TEST_STUDENT) {
                continue;
            }
            // Gradescope's roster also lists the staff.
            if self.form == Form::Gradescope && cell("Role").is_some_and(|role| role != "Student") {
                continue;
            }
            let location = format!("{}, line {line}, column {id}", self.path.display());
            ensure!(!own.is_empty(), "{location}: it is empty");
            if let Some(first) = seen.insert(own.to_owned(), line) {
                bail!("{location}: {own} is in line {first} too");
            }
            let mut keys: Vec<String> = vec![key(&name)];
            keys.extend(name.split_once(',').map(|(last, first)| key(&format!("{first}{last}"))));
            keys.extend(parts.map(|[first, last]| key(&format!("{last}{first}"))));
            for id in IDS.iter().filter_map(|name| cell(name)) {
                keys.push(key(id));
                // Adds the name before an @, and the number in `Participant 4711`.
                keys.extend(id.split_once('@').map(|(own, _)| key(own)));
                keys.extend(id.strip_prefix("Participant ").map(key));
            }
            keys.retain(|key| !key.is_empty());
            let address = cell("Email address").filter(|address| !address.is_empty());
            let address = address.unwrap_or(own).to_owned();
            students.push(Student { row, name, address, keys });
        }
        ensure!(!students.is_empty(), "{} names no student", self.path.display());
        Ok(students)
    }
}

/// Reduces a name to lower-case letters (with their accents) and digits, for comparisons.
pub(super) fn key(name: &str) -> String {
    let lower = composed(&composed(name).to_lowercase());
    lower.chars().filter(|c| c.is_alphanumeric() || is_combining_mark(*c)).collect()
}

pub(super) fn column(header: &StringRecord, name: &str) -> Option<usize> {
    header.iter().position(|own| own.trim() == name)
}

/// Reads a CSV file: the first line, and the other lines with their numbers.
///
/// The delimiter is the comma, semicolon or tab, whichever is most frequent in the first line.
pub(super) fn table(path: &Path) -> Result<(StringRecord, Vec<(u64, StringRecord)>)> {
    let text = String::from_utf8(read_bytes(path)?).ok();
    let text = text.with_context(|| format!("{} is not in UTF-8", path.display()))?;
    let text = text.trim_start_matches('\u{feff}');
    let first = text.lines().next().unwrap_or_default();
    let delimiter = [b',', b';', b'\t'].into_iter().max_by_key(|delimiter| {
        let many = first.bytes().filter(|byte| byte == delimiter).count();
        (many, *delimiter == b',')
    });
    let mut reader = ReaderBuilder::new()
        .delimiter(delimiter.unwrap_or(b','))
        .flexible(true)
        .from_reader(text.as_bytes());
    let header = reader.headers().with_context(|| path.display().to_string())?.clone();
    let mut rows = Vec::new();
    for row in reader.records() {
        let row = row.with_context(|| path.display().to_string())?;
        let line = row.position().map_or(0, csv::Position::line);
        ensure!(
            row.len() == header.len(),
            "{}, line {line}: it has {} fields, the first line has {}",
            path.display(),
            row.len(),
            header.len()
        );
        rows.push((line, row));
    }
    Ok((header, rows))
}
