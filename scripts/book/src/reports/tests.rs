use std::path::Path;

use super::{check, table};
use lab_kit::Kit;

/// A kit with a chapter, a solution and a measurement of lab 1, and one figure.
fn files(entry: &str) -> [(&'static str, String); 6] {
    let tool = "[package]\nname = 'tool'\n[package.metadata.lab]\ntitle = 'Tool'\ncommands = [['run', 'Run']]";
    let page = "# They\n\n## They, us\n\nThey print 1.25, we 2,500 (3).\n\n## Others\n\n7.";
    let data = r#"{"command": "cargo lab run 1 -n 9 --json book/data/race.json", "results": {"programs": [
        {"program": "a", "seconds": {"min": 5.0}, "steps": 2},
        {"program": "b", "seconds": {"min": 2.0}, "steps": 2},
        {"program": "c", "own_efficiency": 0.7071, "workers": 2, "seconds": {"min": 0.000513}, "steps": 1}
    ]}}"#;
    let entry =
        format!("[[figure]]\nreport = 'cs267'\nnumber = 'Table 1'\nwhat = 'times'\n{entry}");
    [
        ("book/src/lab1.md", page.into()),
        ("book/data/race.json", data.into()),
        ("solutions/lab1/Cargo.toml", String::new()),
        ("Cargo.toml", "[workspace]\nmembers = ['tool']".into()),
        ("tool/Cargo.toml", tool.into()),
        ("book/figures.toml", entry),
    ]
}

fn kit(folder: &Path, files: &[(&str, String)]) -> Kit {
    let files: Vec<_> = files.iter().map(|(path, text)| (*path, text.as_str())).collect();
    Kit::of_files(folder, &files)
}

fn with(entry: &str, test: impl FnOnce(&Kit)) {
    let folder = tempfile::tempdir().unwrap();
    test(&kit(folder.path(), &files(entry)));
}

fn fault(entry: &str) -> String {
    let mut fault = String::new();
    with(entry, |kit| fault = check(kit).unwrap().join("\n"));
    fault
}

#[test]
fn a_figure_has_a_page_and_a_command_or_a_reason() {
    let drawing = "page = 'lab1.md'\nnumberless = true";
    let drawn_by = |command| fault(&format!("{drawing}\ncommand = '{command}'"));
    assert_eq!(drawn_by("cargo lab run 1 -n 500"), "");
    assert_eq!(fault(drawing), "", "by hand");
    assert_eq!(fault("left_out = 'a logo'"), "");
    assert!(fault("").contains("needs either"));
    assert!(fault("page = 'lab1.md'").contains("both numbers"));
}

/// An entry whose number is the one of `row` and `column` in race.json.
fn pair(there: &str, is: &str, row: &str, column: &str) -> String {
    format!(
        "page = 'lab1.md'\nthere = {{ number = '{there}', is = '{is}' }}\n\
         here = {{ data = 'race.json', row = '{row}', column = '{column}' }}"
    )
}

#[test]
fn the_table_shows_both_numbers_and_the_data_s_command() {
    with(&pair("1.25", "ms a step", "programs program=a", "least"), |kit| {
        let row = "| [1.25 – 2,500](lab1.md) ms a step, `cargo lab run 1 -n 9` |";
        let table = table(kit).unwrap();
        assert!(table.contains(row), "{table}");
    });
}

#[test]
fn the_section_shows_both_numbers() {
    let numbers = |there, row| fault(&pair(there, "ms a step", row, "least"));
    assert_eq!(numbers("1.25", "programs program=a"), "");
    for number in ["1.2", "25", "500", "1.3"] {
        let fault = numbers(number, "programs program=a");
        assert!(fault.contains(&format!("does not show {number}")), "{fault}");
    }
    assert!(numbers("1.25", "programs program=b").contains("does not show 1000.0000"));
    let elsewhere = pair("1.25", "ms a step", "programs program=a", "least");
    let elsewhere = |section| fault(&elsewhere.replace("lab1.md", section));
    assert_eq!(elsewhere("lab1.md#they-us"), "");
    assert!(elsewhere("lab1.md#others").contains("lab1.md#others does not show 1.25"));
    assert!(elsewhere("lab1.md#gone").contains("no section #gone"));
}

#[test]
fn a_number_of_the_kit_s_is_read_and_not_typed() {
    let row = "page = 'lab1.md'\nthere = { number = '1.25', is = 'ms a step' }\n";
    with(&format!("{row}here = '2,500'"), |kit| assert!(check(kit).is_err()));
    assert!(fault(row).contains("both numbers"));
    let whole = pair("1.25", "ms a step", "programs program=a", "least");
    assert!(fault(&format!("{whole}\nnumberless = true")).contains("both"));
    let command = fault(&format!("{whole}\ncommand = 'cargo lab run 1 -n 500000'"));
    assert!(command.contains("its command is the one in the data file"));
}

/// A report's number and its quantity, the row and the column of the data beside it, the number that the page shows in
/// its stead, and why they do not belong together.
const WRONG: [([&str; 5], &str); 4] = [
    (["617", "ms a step", "programs program=a", "least", "298"], "show 2500.0"),
    (["0.406", "efficiency", "programs program=c", "own efficiency", "0.60"], "show 0.707"),
    (["4.3", "s", "programs program=c", "least", "0.513"], "s there and ms a step here"),
    (
        ["0.30", "efficiency", "programs program=c", "speed-up", "1.41"],
        "efficiency there and speed-up",
    ),
];

#[test]
fn pairs_that_do_not_belong_together_are_refused() {
    for ([there, is, row, column, shown], why) in WRONG {
        let folder = tempfile::tempdir().unwrap();
        let entry = pair(there, is, row, column);
        let mut files = files(&entry);
        files[0].1 = format!("| report | {there} |\n|---|---|\n| kit | {shown} |\n");
        let fault = check(&kit(folder.path(), &files)).unwrap().join("\n");
        assert!(fault.contains(why), "{there} and {shown}: {fault}");
    }
}

#[test]
fn the_command_must_parse_and_the_page_exist() {
    let by =
        |command| fault(&format!("page = 'lab1.md'\nnumberless = true\ncommand = '{command}'"));
    assert!(by("cargo lab dance 1").contains("dance"));
    assert!(by("make plots").contains("not a command"));
    assert!(fault("page = 'lab9.md'\nnumberless = true").contains("no page lab9.md"));
}

#[test]
fn the_table_names_what_is_left_out() {
    with("left_out = 'a logo'", |kit| {
        assert!(table(kit).unwrap().contains("| Table 1 | times | left out: a logo |"));
    });
}
