//! Tests of rosters, clocks, decisions, and entries in `class.toml`.
//!
//! The rosters have the formats of the platforms. Some entries are valid and some are invalid.

use std::fs;

use tempfile::TempDir;

use super::ClassFile;
use crate::record::{Attempt, Record, Status};
use crate::score::score;
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
    let task = |points| TaskFacts { points, ..TaskFacts::default() };
    let tasks = [("1.1", 60.0), ("1.2", 40.0)].map(|(id, points)| (id.to_owned(), task(points)));
    let speed = Timed { points: 25.0, variant: "all-pairs".into(), n: 1000 };
    Facts { tasks: tasks.into(), speed: Some(speed), ..Facts::default() }
}

/// Makes a folder with these files, among them `class.toml`.
fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    files.iter().for_each(|(name, text)| fs::write(folder.path().join(name), text).unwrap());
    folder
}

/// Returns the error of an invalid class.
fn error(files: &[(&str, &str)]) -> String {
    let folder = folder(files);
    let error = ClassFile::read(folder.path(), &rubric()).unwrap_err();
    format!("{error:#}").replace(&format!("{}/", folder.path().display()), "")
}

/// Marks copies of Ada's record under other names, and returns the roster with marks.
fn marked(
    files: &[(&str, &str)],
    names: &[&str],
) -> (Vec<Record>, super::Attendance, Option<String>) {
    let folder = folder(files);
    let class = ClassFile::read(folder.path(), &rubric()).unwrap();
    let mut records: Vec<Record> = names
        .iter()
        .map(|name| {
            let mut record = Record::sample_called(name);
            record.marked.handed_in = Some("2026-11-21T10:00:00Z".parse().unwrap());
            record
        })
        .collect();
    class.tell(&mut records);
    records.iter_mut().for_each(|record| score(record, &rubric()).unwrap());
    let attendance = class.attendance(&mut records);
    let marks = class.marks(&records, &attendance).unwrap();
    (records, attendance, marks)
}

#[test]
fn canvas_gets_its_own_columns_back() {
    let files = [("class.toml", "roster = \"r.csv\""), ("r.csv", CANVAS)];
    let names = ["lovelaceada_11_4242_lab1", "ghost"];
    let (records, attendance, marks) = marked(&files, &names);
    assert_eq!(records[0].marked.student.as_deref(), Some("Lovelace, Ada"));
    assert_eq!((attendance.absent, attendance.strangers), (vec!["Hopper, Grace".into()], vec![1]));
    // 60 of 100 points become 30 of 50 points. The rest of the file is unchanged.
    let marks = marks.unwrap();
    assert!(marks.contains("\"Lovelace, Ada\",11,S1,ada,One,30,3\n"), "{marks}");
    assert!(marks.contains("\"Hopper, Grace\",12,S2,ghopper,One,,\n"), "{marks}");
    assert!(marks.starts_with("Student,ID,"), "{marks}");
}

#[test]
fn a_column_that_is_not_there_is_added() {
    let text =
        CANVAS.replace(",Lab 1 (77)", "").replace(",50,100", ",100").replace("One,,", "One,");
    let files = [("class.toml", "roster = \"r.csv\""), ("r.csv", text.as_str())];
    let (_, _, marks) = marked(&files, &["ada"]);
    let marks = marks.unwrap();
    assert!(marks.starts_with("Student,ID,SIS User ID,SIS Login ID,Section,Lab 2 (78),Lab 1\n"));
    assert!(marks.contains(",100,100\n") && marks.contains("ada,One,3,60\n"), "{marks}");
}

#[test]
fn moodle_tells_two_of_one_name_apart() {
    let files = [("class.toml", "roster = \"r.csv\""), ("r.csv", WORKSHEET)];
    let (_, attendance, marks) = marked(&files, &["Ada Lovelace_4712_assignsubmission_file"]);
    assert_eq!(attendance.present, [(1, 0)].into());
    assert_eq!(attendance.absent, ["Ada Lovelace (ada@example.org)"]);
    let marks = marks.unwrap();
    assert!(
        marks.contains("Participant 4712,Ada Lovelace,ada2@example.org,,30,\"50,00\""),
        "{marks}"
    );
    // The submission's name fits both students.
    let (_, attendance, _) = marked(&files, &["Ada Lovelace"]);
    assert_eq!(attendance.strangers, [0]);
}

#[test]
fn moodles_gradebook_is_joined_by_address_and_by_hand() {
    let class_toml =
        "roster = \"r.csv\"\ncolumn = \"First lab\"\n[names]\nx17 = \"grace@example.org\"";
    let (_, attendance, marks) = marked(
        &[("class.toml", class_toml), ("r.csv", GRADEBOOK)],
        &["ada@example.org", "x17", "hoppergrace"],
    );
    let marks = marks.unwrap();
    assert!(marks.starts_with("First name,Last name,ID number,Email address,First lab\n"));
    assert!(marks.contains("ada@example.org,60\n"), "{marks}");
    assert_eq!(attendance.twice, [("Grace Hopper".to_owned(), None, vec![1, 2])]);
    assert!(marks.contains("grace@example.org,\n"), "of two submissions none counts: {marks}");
}

#[test]
fn a_pair_shares_one_submission_and_the_latest_or_the_best_counts() {
    let class_toml = "attempts = \"latest\"\nroster = \"r.csv\"\n[names]\npair = [\"7\", \"8\"]";
    let files = |class_toml: &'static str| [("class.toml", class_toml), ("r.csv", GRADEBOOK)];
    let (records, attendance, _) = marked(&files(class_toml), &["pair", "7"]);
    assert_eq!(records[0].marked.student.as_deref(), Some("Ada Lovelace and Grace Hopper"));
    assert_eq!(attendance.present, [(0, 1), (1, 0)].into(), "of equal times the last");
    assert_eq!(attendance.twice, [("Ada Lovelace".to_owned(), Some(1), vec![0, 1])]);
    let (what, who) = &attendance.words(&records)[0];
    assert!(what.ends_with("the latest that has a mark counts"), "{what}");
    assert_eq!(*who, ["Ada Lovelace (7, not pair)"]);
    let best = "attempts = \"best\"\nroster = \"r.csv\"\n[[override]]\nstudent = \"7_a\"\npoints = 99\nreason = \"x\"";
    let (_, attendance, marks) = marked(&files(best), &["7_a", "7_b"]);
    assert_eq!(attendance.present, [(0, 0)].into());
    assert!(marks.unwrap().contains("ada@example.org,99\n"));
}

#[test]
fn who_cannot_be_read_has_no_mark() {
    let folder = folder(&[("class.toml", "roster = \"r.csv\""), ("r.csv", GRADEBOOK)]);
    let class = ClassFile::read(folder.path(), &rubric()).unwrap();
    let mut record = Record::sample_called("7");
    record.found.status = Status::Unreadable;
    let mut records = [record];
    let attendance = class.attendance(&mut records);
    let marks = class.marks(&records, &attendance).unwrap().unwrap();
    assert!(marks.contains("ada@example.org,\n"), "{marks}");
    assert_eq!(attendance.unmarked, [0]);
}

#[test]
fn names_of_nobody_are_pointed_out() {
    let class_toml = "roster = \"r.csv\"\n[names]\npear = [\"7\", \"9\"]\npair = \"8\"";
    let folder = folder(&[("class.toml", class_toml), ("r.csv", GRADEBOOK)]);
    let class = ClassFile::read(folder.path(), &rubric()).unwrap();
    let records = [Record::sample_called("pair")];
    let join = super::Join::new(class.students.as_ref(), &class.names, &class.export, &records);
    assert_eq!(
        join.wrong(&class.names, &records),
        ["no submission is called 'pear'", "'9' is not one student of the roster"]
    );
}

#[test]
fn a_broken_attempt_leaves_the_mark_of_an_older_one() {
    let attempts = |class_toml: &str, is_graded: [bool; 2]| {
        let class = format!("{class_toml}\nroster = \"r.csv\"");
        let folder = folder(&[("class.toml", &class), ("r.csv", GRADEBOOK)]);
        let class = ClassFile::read(folder.path(), &rubric()).unwrap();
        let mut records = ["7_1", "7_2"].map(Record::sample_called);
        for (record, is_graded) in records.iter_mut().zip(is_graded) {
            record.found.status = if is_graded { Status::Graded } else { Status::Unreadable };
        }
        let attendance = class.attendance(&mut records);
        let words = attendance.words(&records).into_iter().flat_map(|(_, who)| who);
        let words = words.collect::<Vec<_>>().join("; ");
        (records.map(|record| record.marked.attempt), attendance.unmarked, words)
    };
    let latest = "attempts = \"latest\"";
    let (own, unmarked, words) = attempts(latest, [true, false]);
    assert_eq!((own, unmarked), ([Attempt::Counts, Attempt::Another], vec![]));
    assert!(words.contains("Ada Lovelace (7_1, not 7_2)"), "{words}");
    let (own, unmarked, _) = attempts(latest, [false; 2]);
    assert_eq!((own, unmarked), ([Attempt::Counts; 2], vec![0, 1]));
    let (own, unmarked, _) = attempts("", [true; 2]);
    assert_eq!((own, unmarked), ([Attempt::Undecided; 2], vec![]));
}

#[test]
fn a_class_toml_may_lie_beside_the_submissions() {
    let beside = folder(&[("class.toml", "roster = \"r.csv\""), ("r.csv", GRADEBOOK)]);
    let records = folder(&[]);
    let path = beside.path().join("class.toml");
    super::link(&path, records.path()).unwrap();
    super::link(&path, records.path()).unwrap();
    assert!(ClassFile::read(records.path(), &rubric()).unwrap().students.is_some());
    let other = folder(&[("class.toml", "")]);
    let error = super::link(&path, other.path()).unwrap_err().to_string();
    assert!(error.contains("keep one"), "{error}");
}

#[test]
fn a_bad_roster_is_named_with_line_and_column() {
    let bad = |text: &str| error(&[("class.toml", "roster = \"r.csv\""), ("r.csv", text)]);
    assert!(bad("name,mark\nada,1\n").contains("r.csv, line 1: there are neither Canvas's"));
    let short = CANVAS.replace(",One,,3", ",One,3");
    assert_eq!(bad(&short), "class.toml: r.csv, line 3: it has 6 fields, the first line has 7");
    let twice = CANVAS.replace(",12,", ",11,");
    assert_eq!(bad(&twice), "class.toml: r.csv, line 4, column ID: 11 is in line 3 too");
    let empty = GRADEBOOK.replace("grace@example.org", "");
    assert_eq!(bad(&empty), "class.toml: r.csv, line 3, column Email address: it is empty");
    assert!(bad("Student,ID\n").contains("names no student"));
    assert!(error(&[("class.toml", "roster = \"r.csv\"")]).contains("cannot read r.csv"));
}

#[test]
fn days_begin_after_the_grace() {
    let lost = |late: &str| {
        let class_toml = format!("[late]\ndeadline = \"2026-11-20T10:00:00Z\"\n{late}");
        let (records, ..) = marked(&[("class.toml", &class_toml)], &["ada"]);
        (records[0].marked.late.as_ref().map_or(0, |late| late.days), records[0].marked.points)
    };
    // The submission has 60 points, and was handed in exactly a day after the deadline.
    assert_eq!(lost("penalty = 10"), (1, 54.0));
    assert_eq!(lost("penalty = 10\ngrace = 1440"), (0, 60.0));
    assert_eq!(lost("penalty = 10\ndays = 0"), (1, 0.0));
    let excused = "penalty = 10\n[[override]]\nstudent = \"ada\"\ndays = 0\nreason = \"ill\"";
    assert_eq!(lost(excused), (0, 60.0));
}

#[test]
fn days_are_those_of_the_calendar_in_the_course_s_zone() {
    let days = |late: &str, time: &str| {
        let class_toml = format!("[late]\n{late}\npenalty = 10\ntimes = \"t.csv\"");
        let times = format!("student,time\nada,{time}\n");
        let (records, ..) = marked(&[("class.toml", &class_toml), ("t.csv", &times)], &["ada"]);
        records[0].marked.late.as_ref().map_or(0, |late| late.days)
    };
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
    let class_toml = |late: &str| format!("[late]\npenalty = 1\n{late}");
    let words = |late: &str| {
        let folder = folder(&[("class.toml", &class_toml(late))]);
        ClassFile::read(folder.path(), &rubric()).unwrap().deadline().unwrap()
    };
    let berlin = "deadline = \"2026-10-24 23:59\"\nzone = \"Europe/Berlin\"";
    assert_eq!(words(berlin), "2026-10-24 23:59, UTC+02:00 (Europe/Berlin)");
    let why =
        error(&[("class.toml", &class_toml("deadline = \"2026-10-24 23:59\"\nzone = \"Berlin\""))]);
    assert_eq!(why, "class.toml: late: zone: there is no time zone 'Berlin'; one is Europe/Berlin");
}

#[test]
fn accents_count_however_they_are_written() {
    let roster = "First name,Last name,ID number,Email address\n\
        Jos\u{e9},Ruiz,7,jose7@example.org\nJose,Ruiz,8,jose8@example.org\nZo\u{eb},Li,9,zoe@example.org\n";
    let class_toml = "roster = \"r.csv\"\n[names]\n\"ka\u{308}fer\" = \"9\"";
    let files = [("class.toml", class_toml), ("r.csv", roster)];
    // The accented letter is one character in one name. In the other name it is two characters, as
    // in file names of macOS.
    let names =
        ["Jos\u{e9} Ruiz_1", "Jose\u{301} Ruiz_2", "JOSE\u{301} RUIZ", "Jose Ruiz", "k\u{e4}fer"];
    let (records, ..) = marked(&files, &names);
    let students: Vec<_> = records.iter().map(|record| record.marked.student.as_deref()).collect();
    let jose = Some("Jos\u{e9} Ruiz");
    assert_eq!(students, [jose, jose, jose, Some("Jose Ruiz"), Some("Zo\u{eb} Li")]);
}

#[test]
fn nobody_is_guessed_between_two() {
    let roster = "First name,Last name,ID number,Email address\n\
        Ada,Li,7,ada@example.org\nAda,Li,8,li@example.org\nBob,Wu,9,bob@example.org\n";
    let files = [("class.toml", "roster = \"r.csv\""), ("r.csv", roster)];
    let names = ["Ada Li_4711_lab1", "Ada Li_8_lab1", "Ada Li_9_lab1", "Bob Wu_8_lab1", "bob_ada"];
    let (records, attendance, _) = marked(&files, &names);
    let students: Vec<_> = records.iter().map(|record| record.marked.student.as_deref()).collect();
    assert_eq!(students, [None, Some("Ada Li"), None, Some("Bob Wu"), None]);
    assert_eq!(
        (attendance.strangers, attendance.present),
        (vec![0, 2, 4], [(1, 1), (2, 3)].into())
    );
}

#[test]
fn a_byte_order_mark_is_nobodys_name() {
    let files = [("class.toml", "\u{feff}roster = \"r.csv\""), ("r.csv", CANVAS)];
    let (records, ..) = marked(&files, &["ada"]);
    assert_eq!(records[0].marked.student.as_deref(), Some("Lovelace, Ada"));
}

#[test]
fn a_deadline_is_a_moment() {
    let bad = |deadline: &str| {
        error(&[("class.toml", &format!("[late]\npenalty = 1\ndeadline = \"{deadline}\""))])
    };
    for deadline in ["2026-11-20", "2026-11-20 25:00", "tonight"] {
        let expected = format!("'{deadline}' is no time such as 2026-11-20 23:59");
        let location = "for key `late.deadline`";
        assert_eq!(bad(deadline), format!("class.toml: {expected} {location}"));
    }
}

#[test]
fn a_wrong_word_has_no_place_and_a_wrong_form_has() {
    let bad = |class_toml: &str| error(&[("class.toml", class_toml)]);
    let unknown = bad("\n[late]\npenality = 1\n");
    assert!(unknown.contains("`penality`") && !unknown.contains(" at line "), "{unknown}");
    let form = bad("attempts = \"latest\"\nroster = r.csv\n");
    assert!(form.contains("at line 2 column"), "{form}");
}

#[test]
fn a_list_of_times_goes_before_the_files() {
    let class_toml = "[late]\ndeadline = \"2026-11-20T10:00:00Z\"\npenalty = 10\ntimes = \"t.csv\"";
    let times = |text: &str| [("class.toml", class_toml.to_owned()), ("t.csv", text.to_owned())];
    let list = times("\u{feff}student,time\nada,2026-11-22T10:01:00Z\n");
    let list = list.each_ref().map(|(name, text)| (*name, text.as_str()));
    let (records, ..) = marked(&list, &["ada"]);
    assert_eq!(records[0].marked.late.as_ref().unwrap().days, 3);
    let bad = times("student,time\nada,tomorrow\n");
    let bad = error(&bad.each_ref().map(|(name, text)| (*name, text.as_str())));
    assert!(bad.contains("t.csv, line 2, column time: 'tomorrow' is no time"), "{bad}");
}

#[test]
fn what_was_decided_counts() {
    let class_toml = "[[override]]\nstudent = \"ada\"\ntask = \"1.2\"\npoints = 25\nreason = \"nearly\"\n\
        [[override]]\nstudent = \"ada\"\ntask = \"speed\"\npoints = 20\nreason = \"measured here\"\n\
        [[override]]\nstudent = \"bob\"\npoints = 5\nreason = \"said it aloud\"";
    let (records, ..) = marked(&[("class.toml", class_toml)], &["ada", "bob", "eve"]);
    let points: Vec<f64> = records.iter().map(|record| record.marked.points).collect();
    assert_eq!(points, [105.0, 5.0, 60.0]);
}

#[test]
fn a_decision_that_cannot_be_is_refused() {
    let bad = |class_toml: &str| {
        error(&[(
            "class.toml",
            &format!("[[override]]\nstudent = \"ada\"\nreason = \"r\"\n{class_toml}"),
        )])
    };
    assert_eq!(bad("task = \"1.9\""), "class.toml: override 1: there is no task or measure 1.9");
    let much = bad("task = \"1.2\"\npoints = 41");
    assert_eq!(much, "class.toml: override 1: 41 points cannot be given where there are 40");
    assert!(bad("points = -1").contains("-1 points cannot be given"));
    assert!(bad("points = 1e308").ends_with("1e308 points cannot be given where there are 1000"));
    assert!(bad("task = \"1.1\"\ndays = 1").contains("days are of a submission"));
    assert!(bad("pionts = 1").contains("pionts"));
}

#[test]
fn a_pseudonym_hides_a_name_and_can_be_spoken_of() {
    let (records, ..) = marked(&[("class.toml", "pseudonyms = \"key\"")], &["ada"]);
    let pseudonym = records[0].marked.pseudonym.clone().unwrap();
    let mut record = records[0].clone();
    record.found.message = "ada.tar.gz cannot be unpacked".into();
    let shown = record.shown();
    assert_eq!(
        (&shown.found.name, shown.found.message),
        (&pseudonym, format!("{pseudonym}.tar.gz cannot be unpacked"))
    );
    let class_toml = format!(
        "pseudonyms = \"key\"\n[[override]]\nstudent = \"{pseudonym}\"\npoints = 1\nreason = \"r\""
    );
    let (records, ..) = marked(&[("class.toml", &class_toml)], &["ada"]);
    assert_eq!(records[0].marked.points, 1.0);
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
    let late = "roster = \"roster.csv\"\n[late]\ndeadline = \"2026-11-21T06:00Z\"\npenalty = 10\n";
    let files =
        [("class.toml", late), ("roster.csv", GRADESCOPE), ("submission_metadata.yml", EXPORT)];
    let (records, attendance, marks) = marked(&files, &["submission_1", "submission_2"]);
    assert_eq!(records[0].marked.student.as_deref(), Some("Ada Lovelace"));
    assert_eq!(records[1].marked.student.as_deref(), Some("Grace Hopper and Linus Pauling"));
    assert_eq!(records[0].marked.late, None);
    assert_eq!(records[1].marked.late.as_ref().unwrap().days, 2);
    assert!(attendance.words(&records).is_empty(), "{:?}", attendance.words(&records));
    assert_eq!(marks.unwrap().matches("@example.org,Student,").count(), 3);

    let (records, _, _) = marked(&files[2..], &["submission_2", "submission_3"]);
    assert_eq!(
        records[0].marked.student.as_deref(),
        Some("Grace Hopper and Linus"),
        "without a roster too"
    );
    assert_eq!(records[1].marked.student, None);
}

#[test]
fn a_roster_of_classroom_50_knows_users_of_github() {
    let roster =
        "username,first_name,last_name,email,section,github_id\nada-l,Ada,Lovelace,,One,4711\n";
    let files = [("class.toml", "roster = \"roster.csv\"\n"), ("roster.csv", roster)];
    let (records, _, _) = marked(&files, &["ada-l"]);
    assert_eq!(records[0].marked.student.as_deref(), Some("Ada Lovelace"));
}

#[test]
fn optional_tasks_are_worth_nothing_where_only_the_core_counts() {
    let mut rubric = rubric();
    rubric.tasks.get_mut("1.2").unwrap().optional = true;
    for (class, points, times) in [("", [60.0, 40.0], 1), ("core = true", [100.0, 0.0], 0)] {
        let folder = folder(&[("class.toml", class)]);
        let own = ClassFile::read(folder.path(), &rubric).unwrap().rubric(&rubric);
        assert!(own.tasks.values().map(|task| task.points).eq(points), "{class}");
        assert_eq!(own.timed().count(), times, "{class}");
    }
}
