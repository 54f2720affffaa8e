//! Tests of rosters, clocks, decisions, and entries in `class.toml`.
//!
//! The rosters have the formats of the platforms. Some entries are valid and some are invalid.

use std::fs;

use tempfile::TempDir;

use super::{Attendance, ClassFile, Join};
use crate::record::{Attempt, Record, Status};
use lab_kit::Facts;
use lab_kit::facts::{TaskFacts, Timed};

const CANVAS: &str = "\u{feff}Student,ID,SIS User ID,SIS Login ID,Section,Lab 1 (77),Lab 2 (78)\n\
    \u{20}   Points Possible,,,,,50,100\n\
    \"Lovelace, Ada\",11,S1,ada,One,,3\n\
    \"Hopper, Grace\",12,S2,ghopper,One,,\n\
    \"Student, Test\",99,,x,One,,\n";

const WORKSHEET: &str = "Identifier;Full name;Email address;Status;Grade;Maximum Grade\n\
    Participant 4711;Ada Lovelace;ada@example.org;Submitted;;50,00\n\
    Participant 4712;Ada Lovelace;ada2@example.org;;;50,00\n";

const GRADEBOOK: &str = "First name,Last name,ID number,Email address\n\
    Ada,Lovelace,7,ada@example.org\n\
    Grace,Hopper,8,grace@example.org\n";

fn rubric() -> Facts {
    let tasks = [("1.1", 60.0), ("1.2", 40.0)]
        .map(|(id, points)| (id.to_owned(), TaskFacts { points, ..TaskFacts::default() }));
    let speed = Timed { points: 25.0, variant: "all-pairs".into(), n: 1000 };
    Facts { tasks: tasks.into(), speed: Some(speed), ..Facts::default() }
}

/// `class.toml` of a class that has only a roster.
const ROSTER: &str = "roster = \"f.csv\"";

/// Makes a folder with a `class.toml`, and with a file of students or times, which is `f.csv`.
fn folder(class_toml: &str, file: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("class.toml"), class_toml).unwrap();
    fs::write(folder.path().join("f.csv"), file).unwrap();
    folder
}

fn read(folder: &TempDir) -> ClassFile {
    ClassFile::read(folder.path(), &rubric()).unwrap()
}

/// Returns the error of an invalid class.
fn error(class_toml: &str, file: &str) -> String {
    let folder = folder(class_toml, file);
    let error = ClassFile::read(folder.path(), &rubric()).unwrap_err();
    format!("{error:#}").replace(&format!("{}/", folder.path().display()), "")
}

/// A class whose records were marked.
struct MarkedClass {
    records: Vec<Record>,
    attendance: Attendance,
    /// Roster with marks; empty if there is no roster.
    roster: String,
}

impl MarkedClass {
    /// Marks copies of Ada's record under other names.
    fn new(class_toml: &str, file: &str, names: &[&str]) -> Self {
        Self::of_folder(&folder(class_toml, file), names)
    }

    fn of_folder(folder: &TempDir, names: &[&str]) -> Self {
        let mut records: Vec<Record> = names.iter().map(|it| Record::sample_called(it)).collect();
        for record in &mut records {
            record.marked.handed_in = Some("2026-11-21T10:00:00Z".parse().unwrap());
        }
        let class = read(folder);
        let attendance = class.mark(&mut records, &rubric()).unwrap();
        let roster = class.marks(&records, &attendance).unwrap().unwrap_or_default();
        Self { records, attendance, roster }
    }

    fn students(&self) -> Vec<&str> {
        self.records.iter().map(|it| it.marked.student.as_deref().unwrap_or_default()).collect()
    }

    fn points(&self) -> Vec<f64> {
        self.records.iter().map(|record| record.marked.points).collect()
    }

    /// Returns the days by which the first submission was late.
    fn days(&self) -> u32 {
        self.records[0].marked.late.as_ref().map_or(0, |late| late.days)
    }

    /// Asserts that the roster with marks contains these texts.
    fn assert_roster(&self, texts: &[&str]) {
        for text in texts {
            assert!(self.roster.contains(text), "{text}: {}", self.roster);
        }
    }
}

#[test]
fn canvas_gets_its_own_columns_back() {
    let class = MarkedClass::new(ROSTER, CANVAS, &["lovelaceada_11_4242_lab1", "ghost"]);
    assert_eq!(class.students(), ["Lovelace, Ada", ""]);
    assert_eq!(class.attendance.absent, ["Hopper, Grace"]);
    assert_eq!(class.attendance.strangers, [1]);
    // 60 of 100 points become 30 of 50 points. The rest of the file is unchanged.
    class.assert_roster(&[
        "\"Lovelace, Ada\",11,S1,ada,One,30,3\n",
        "\"Hopper, Grace\",12,S2,ghopper,One,,\n",
    ]);
    assert!(class.roster.starts_with("Student,ID,"), "{}", class.roster);
}

#[test]
fn a_column_that_is_not_there_is_added() {
    let text =
        CANVAS.replace(",Lab 1 (77)", "").replace(",50,100", ",100").replace("One,,", "One,");
    let class = MarkedClass::new(ROSTER, &text, &["ada"]);
    class.assert_roster(&[
        "Student,ID,SIS User ID,SIS Login ID,Section,Lab 2 (78),Lab 1\n",
        ",100,100\n",
        "ada,One,3,60\n",
    ]);
}

#[test]
fn moodle_tells_two_of_one_name_apart() {
    let class = MarkedClass::new(ROSTER, WORKSHEET, &["Ada Lovelace_4712_assignsubmission_file"]);
    assert_eq!(class.attendance.present, [(1, 0)].into());
    assert_eq!(class.attendance.absent, ["Ada Lovelace (ada@example.org)"]);
    class.assert_roster(&["Participant 4712,Ada Lovelace,ada2@example.org,,30,\"50,00\""]);
    // The submission's name fits both students.
    let class = MarkedClass::new(ROSTER, WORKSHEET, &["Ada Lovelace"]);
    assert_eq!(class.attendance.strangers, [0]);
}

#[test]
fn moodles_gradebook_is_joined_by_address_and_by_hand() {
    let class_toml =
        "roster = \"f.csv\"\ncolumn = \"First lab\"\n[names]\nx17 = \"grace@example.org\"";
    let class = MarkedClass::new(class_toml, GRADEBOOK, &["ada@example.org", "x17", "hoppergrace"]);
    assert_eq!(class.attendance.twice, [("Grace Hopper".to_owned(), None, vec![1, 2])]);
    class.assert_roster(&[
        "First name,Last name,ID number,Email address,First lab\n",
        "ada@example.org,60\n",
        // Neither submission counts.
        "grace@example.org,\n",
    ]);
}

#[test]
fn a_pair_shares_one_submission_and_the_latest_or_the_best_counts() {
    let latest = "attempts = \"latest\"\nroster = \"f.csv\"\n[names]\npair = [\"7\", \"8\"]";
    let class = MarkedClass::new(latest, GRADEBOOK, &["pair", "7"]);
    assert_eq!(class.students()[0], "Ada Lovelace and Grace Hopper");
    let attendance = &class.attendance;
    assert_eq!(attendance.present, [(0, 1), (1, 0)].into(), "of equal times the last");
    assert_eq!(attendance.twice, [("Ada Lovelace".to_owned(), Some(1), vec![0, 1])]);
    let (what, who) = &attendance.words(&class.records)[0];
    assert!(what.ends_with("the latest that has a mark counts"), "{what}");
    assert_eq!(*who, ["Ada Lovelace (7, not pair)"]);
    let best = "attempts = \"best\"\nroster = \"f.csv\"\n[[override]]\nstudent = \"7_a\"\npoints = 99\nreason = \"x\"";
    let class = MarkedClass::new(best, GRADEBOOK, &["7_a", "7_b"]);
    assert_eq!(class.attendance.present, [(0, 0)].into());
    class.assert_roster(&["ada@example.org,99\n"]);
}

#[test]
fn who_cannot_be_read_has_no_mark() {
    let class = read(&folder(ROSTER, GRADEBOOK));
    let mut records = [Record::sample_called("7")];
    records[0].found.status = Status::Unreadable;
    let attendance = class.attendance(&mut records);
    let marks = class.marks(&records, &attendance).unwrap().unwrap();
    assert!(marks.contains("ada@example.org,\n"), "{marks}");
    assert_eq!(attendance.unmarked, [0]);
}

#[test]
fn names_of_nobody_are_pointed_out() {
    let class_toml = "roster = \"f.csv\"\n[names]\npear = [\"7\", \"9\"]\npair = \"8\"";
    let class = read(&folder(class_toml, GRADEBOOK));
    let records = [Record::sample_called("pair")];
    let join = Join::new(class.students.as_ref(), &class.names, &class.export, &records);
    assert_eq!(
        join.wrong(&class.names, &records),
        ["no submission is called 'pear'", "'9' is not one student of the roster"]
    );
}

#[test]
fn a_broken_attempt_leaves_the_mark_of_an_older_one() {
    let latest = "attempts = \"latest\"\nroster = \"f.csv\"";
    let newest_broken = [Status::Graded, Status::Unreadable];
    let cases = [
        (latest, newest_broken, [Attempt::Counts, Attempt::Another], vec![]),
        (latest, [Status::Unreadable; 2], [Attempt::Counts; 2], vec![0, 1]),
        (ROSTER, [Status::Graded; 2], [Attempt::Undecided; 2], vec![]),
    ];
    for (class_toml, statuses, attempts, unmarked) in cases {
        let class = read(&folder(class_toml, GRADEBOOK));
        let mut records = ["7_1", "7_2"].map(Record::sample_called);
        for (record, status) in records.iter_mut().zip(statuses) {
            record.found.status = status;
        }
        let attendance = class.attendance(&mut records);
        assert_eq!(attendance.unmarked, unmarked, "{statuses:?}");
        if statuses == newest_broken {
            let words = attendance.words(&records);
            assert_eq!(words[1].1, ["Ada Lovelace (7_1, not 7_2)"]);
        }
        assert_eq!(records.map(|record| record.marked.attempt), attempts, "{statuses:?}");
    }
}

#[test]
fn a_class_toml_may_lie_beside_the_submissions() {
    let beside = folder(ROSTER, GRADEBOOK);
    let records = tempfile::tempdir().unwrap();
    let path = beside.path().join("class.toml");
    super::link(&path, records.path()).unwrap();
    super::link(&path, records.path()).unwrap();
    assert!(read(&records).students.is_some());
    let error = super::link(&path, folder("", "").path()).unwrap_err().to_string();
    assert!(error.contains("keep one"), "{error}");
}

#[test]
fn a_bad_roster_is_named_with_line_and_column() {
    for (roster, why) in [
        ("name,mark\nada,1\n", "f.csv, line 1: there are neither Canvas's columns"),
        (
            &CANVAS.replace(",One,,3", ",One,3"),
            "f.csv, line 3: it has 6 fields, the first line has 7",
        ),
        (&CANVAS.replace(",12,", ",11,"), "f.csv, line 4, column ID: 11 is in line 3 too"),
        (
            &GRADEBOOK.replace("grace@example.org", ""),
            "f.csv, line 3, column Email address: it is empty",
        ),
        ("Student,ID\n", "f.csv names no student"),
    ] {
        let error = error(ROSTER, roster);
        assert!(error.starts_with(&format!("class.toml: {why}")), "{error}");
    }
    assert!(error("roster = \"r.csv\"", "").contains("cannot read r.csv"));
}

#[test]
fn days_begin_after_the_grace() {
    // The submission has 60 points, and was handed in exactly a day after the deadline.
    for (late, days, points) in [
        ("penalty = 10", 1, 54.0),
        ("penalty = 10\ngrace = 1440", 0, 60.0),
        ("penalty = 10\ndays = 0", 1, 0.0),
        ("penalty = 10\n[[override]]\nstudent = \"ada\"\ndays = 0\nreason = \"ill\"", 0, 60.0),
    ] {
        let class_toml = format!("[late]\ndeadline = \"2026-11-20T10:00:00Z\"\n{late}");
        let class = MarkedClass::new(&class_toml, "", &["ada"]);
        assert_eq!((class.days(), class.points()), (days, vec![points]), "{late}");
    }
}

/// Returns the days by which a submission of this time is late.
fn days(late: &str, time: &str) -> u32 {
    let class_toml = format!("[late]\n{late}\npenalty = 10\ntimes = \"f.csv\"");
    MarkedClass::new(&class_toml, &format!("student,time\nada,{time}\n"), &["ada"]).days()
}

#[test]
fn days_are_those_of_the_calendar_in_the_course_s_zone() {
    // Because of clock changes, the day after the deadline has 25 hours in October and 23 hours in
    // March.
    for (day, next) in [("10-24", "10-25"), ("03-28", "03-29"), ("11-20", "11-21")] {
        let late = format!("deadline = \"2026-{day} 23:59\"\nzone = \"Europe/Berlin\"");
        assert_eq!(days(&late, &format!("2026-{day} 23:59:59")), 0, "{day}");
        assert_eq!(days(&late, &format!("2026-{next} 00:00")), 1, "{day}");
        assert_eq!(days(&late, &format!("2026-{next} 23:59:30")), 1, "{day}");
        assert_eq!(days(&format!("{late}\ngrace = 10"), &format!("2026-{next} 00:09")), 0, "{day}");
    }
    let autumn = "deadline = \"2026-10-24 23:59\"\nzone = \"Europe/Berlin\"";
    assert_eq!(days(autumn, "2026-10-26 00:00"), 2);
    assert_eq!(days(autumn, "2026-10-25T22:59:00Z"), 1, "23:59 in Berlin");
    let spring = "deadline = \"2026-03-28 23:59\"\nzone = \"Europe/Berlin\"";
    assert_eq!(days(spring, "2026-03-30 00:00"), 2);
    let exact = "deadline = \"2026-11-20T10:00:00Z\"\nzone = \"Asia/Kolkata\"";
    assert_eq!(days(exact, "2026-11-20 15:30:59"), 0);
    assert_eq!(days(exact, "2026-11-20 15:31"), 1);
}

#[test]
fn a_deadline_is_said_with_its_zone() {
    let late = "[late]\npenalty = 1\ndeadline = \"2026-10-24 23:59\"\n";
    let class = read(&folder(&format!("{late}zone = \"Europe/Berlin\""), ""));
    assert_eq!(class.deadline().unwrap(), "2026-10-24 23:59, UTC+02:00 (Europe/Berlin)");
    let why = error(&format!("{late}zone = \"Berlin\""), "");
    assert_eq!(why, "class.toml: late: zone: there is no time zone 'Berlin'; one is Europe/Berlin");
}

#[test]
fn accents_count_however_they_are_written() {
    let roster = "First name,Last name,ID number,Email address\n\
        Jos\u{e9},Ruiz,7,jose7@example.org\nJose,Ruiz,8,jose8@example.org\nZo\u{eb},Li,9,zoe@example.org\n";
    let class_toml = "roster = \"f.csv\"\n[names]\n\"ka\u{308}fer\" = \"9\"";
    // The accented letter is one character in one name. In the other name it is two characters, as
    // in file names of macOS.
    let names =
        ["Jos\u{e9} Ruiz_1", "Jose\u{301} Ruiz_2", "JOSE\u{301} RUIZ", "Jose Ruiz", "k\u{e4}fer"];
    let class = MarkedClass::new(class_toml, roster, &names);
    let jose = "Jos\u{e9} Ruiz";
    assert_eq!(class.students(), [jose, jose, jose, "Jose Ruiz", "Zo\u{eb} Li"]);
}

#[test]
fn nobody_is_guessed_between_two() {
    let roster = "First name,Last name,ID number,Email address\n\
        Ada,Li,7,ada@example.org\nAda,Li,8,li@example.org\nBob,Wu,9,bob@example.org\n";
    let names = ["Ada Li_4711_lab1", "Ada Li_8_lab1", "Ada Li_9_lab1", "Bob Wu_8_lab1", "bob_ada"];
    let class = MarkedClass::new(ROSTER, roster, &names);
    assert_eq!(class.students(), ["", "Ada Li", "", "Bob Wu", ""]);
    assert_eq!(class.attendance.strangers, [0, 2, 4]);
    assert_eq!(class.attendance.present, [(1, 1), (2, 3)].into());
}

#[test]
fn a_byte_order_mark_is_nobodys_name() {
    let class = MarkedClass::new(&format!("\u{feff}{ROSTER}"), CANVAS, &["ada"]);
    assert_eq!(class.students(), ["Lovelace, Ada"]);
}

#[test]
fn a_deadline_is_a_moment() {
    for deadline in ["2026-11-20", "2026-11-20 25:00", "tonight"] {
        let error = error(&format!("[late]\npenalty = 1\ndeadline = \"{deadline}\""), "");
        let expected = format!("'{deadline}' is no time such as 2026-11-20 23:59");
        assert_eq!(error, format!("class.toml: {expected} for key `late.deadline`"));
    }
}

#[test]
fn a_wrong_word_has_no_place_and_a_wrong_form_has() {
    let unknown = error("\n[late]\npenality = 1\n", "");
    assert!(unknown.contains("`penality`") && !unknown.contains(" at line "), "{unknown}");
    let form = error("attempts = \"latest\"\nroster = r.csv\n", "");
    assert!(form.contains("at line 2 column"), "{form}");
}

#[test]
fn a_list_of_times_goes_before_the_files() {
    let late = "deadline = \"2026-11-20T10:00:00Z\"";
    let class_toml = format!("[late]\n{late}\npenalty = 10\ntimes = \"f.csv\"");
    let list = "\u{feff}student,time\nada,2026-11-22T10:01:00Z\n";
    assert_eq!(MarkedClass::new(&class_toml, list, &["ada"]).days(), 3);
    let bad = error(&class_toml, "student,time\nada,tomorrow\n");
    assert!(bad.contains("f.csv, line 2, column time: 'tomorrow' is no time"), "{bad}");
}

#[test]
fn what_was_decided_counts() {
    let class_toml = "[[override]]\nstudent = \"ada\"\ntask = \"1.2\"\npoints = 25\nreason = \"nearly\"\n\
        [[override]]\nstudent = \"ada\"\ntask = \"speed\"\npoints = 20\nreason = \"measured here\"\n\
        [[override]]\nstudent = \"bob\"\npoints = 5\nreason = \"said it aloud\"";
    let class = MarkedClass::new(class_toml, "", &["ada", "bob", "eve"]);
    assert_eq!(class.points(), [105.0, 5.0, 60.0]);
}

#[test]
fn a_decision_that_cannot_be_is_refused() {
    for (entry, why) in [
        ("task = \"1.9\"", "there is no task or measure 1.9"),
        ("task = \"1.2\"\npoints = 41", "41 points cannot be given where there are 40"),
        ("points = -1", "-1 points cannot be given where there are 1000"),
        ("points = 1e308", "1e308 points cannot be given where there are 1000"),
        ("task = \"1.1\"\ndays = 1", "days are of a submission, not a task"),
    ] {
        let class_toml = format!("[[override]]\nstudent = \"ada\"\nreason = \"r\"\n{entry}");
        assert_eq!(error(&class_toml, ""), format!("class.toml: override 1: {why}"));
    }
    assert!(error("[[override]]\nstudent = \"ada\"\npionts = 1", "").contains("pionts"));
}

#[test]
fn a_pseudonym_hides_a_name_and_can_be_spoken_of() {
    let class = MarkedClass::new("pseudonyms = \"key\"", "", &["ada"]);
    let mut record = class.records[0].clone();
    let pseudonym = record.marked.pseudonym.clone().unwrap();
    record.found.message = "ada.tar.gz cannot be unpacked".into();
    let shown = record.shown().found;
    assert_eq!(shown.name, pseudonym);
    assert_eq!(shown.message, format!("{pseudonym}.tar.gz cannot be unpacked"));
    let class_toml = format!(
        "pseudonyms = \"key\"\n[[override]]\nstudent = \"{pseudonym}\"\npoints = 1\nreason = \"r\""
    );
    assert_eq!(MarkedClass::new(&class_toml, "", &["ada"]).points(), [1.0]);
}

const GRADESCOPE: &str = "First Name,Last Name,SID,Email,Role\n\
    Ada,Lovelace,11,ada@example.org,Student\n\
    Grace,Hopper,12,grace@example.org,Student\n\
    Linus,Pauling,13,linus@example.org,Student\n\
    Tea,Cher,,staff@example.org,TA\n";

const EXPORT: &str = "submission_1:\n  :submitters:\n  - :name: Ada L.\n    :sid: '11'\n    :email: private@example.org\n  \
                      :created_at: 2026-11-20 22:00:00 Z\n\
                      submission_2:\n  :submitters:\n  - :name: Grace Hopper\n    :email: grace@example.org\n  - :name: Linus\n    \
                      :email: linus@example.org\n  :created_at: 2026-11-22 07:00:00 Z\n";

#[test]
fn an_export_of_gradescope_says_who_handed_in_and_when() {
    let late = "roster = \"f.csv\"\n[late]\ndeadline = \"2026-11-21T06:00Z\"\npenalty = 10\n";
    let folder = folder(late, GRADESCOPE);
    fs::write(folder.path().join("submission_metadata.yml"), EXPORT).unwrap();
    let class = MarkedClass::of_folder(&folder, &["submission_2", "submission_1"]);
    assert_eq!(class.students(), ["Grace Hopper and Linus Pauling", "Ada Lovelace"]);
    assert_eq!((class.days(), &class.records[1].marked.late), (2, &None));
    let words = class.attendance.words(&class.records);
    assert!(words.is_empty(), "{words:?}");
    assert_eq!(class.roster.matches("@example.org,Student,").count(), 3);

    // The export suffices without a roster.
    fs::remove_file(folder.path().join("class.toml")).unwrap();
    let class = MarkedClass::of_folder(&folder, &["submission_2", "submission_3"]);
    assert_eq!(class.students(), ["Grace Hopper and Linus", ""]);
}

#[test]
fn a_roster_of_classroom_50_knows_users_of_github() {
    let roster =
        "username,first_name,last_name,email,section,github_id\nada-l,Ada,Lovelace,,One,4711\n";
    assert_eq!(MarkedClass::new(ROSTER, roster, &["ada-l"]).students(), ["Ada Lovelace"]);
}

#[test]
fn optional_tasks_are_worth_nothing_where_only_the_core_counts() {
    let mut rubric = rubric();
    rubric.tasks.get_mut("1.2").unwrap().optional = true;
    for (class, points, times) in [("", [60.0, 40.0], 1), ("core = true", [100.0, 0.0], 0)] {
        let own = read(&folder(class, "")).rubric(&rubric);
        assert!(own.tasks.values().map(|task| task.points).eq(points), "{class}");
        assert_eq!(own.timed().count(), times, "{class}");
    }
}
