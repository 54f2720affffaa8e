//! The measuring commands of `cargo lab`.

use std::process::ExitCode;

use lab_measure::commands::Command;

fn main() -> ExitCode {
    lab_kit::command::main(|kit, command: Command| command.run(kit))
}

#[cfg(test)]
mod tests {
    use super::Command;

    #[test]
    fn each_help_shows_its_own_defaults() {
        let all = lab_kit::command::command_line::<Command>();
        for (name, rounds, seconds) in [
            ("race", "5", "30"),
            ("complexity", "3", "60"),
            ("scaling", "3", "90"),
            ("sweep", "3", "60"),
        ] {
            let command = all.find_subcommand(name).unwrap();
            let shown = ["rounds", "seconds"].map(|id| {
                let argument = command.get_arguments().find(|argument| argument.get_id() == id);
                argument.unwrap().get_default_values().to_vec()
            });
            assert_eq!(shown, [[rounds], [seconds]], "{name}");
        }
    }

    #[test]
    fn the_manifest_and_the_book_say_what_the_program_has() {
        lab_kit::command::expect_declared::<Command>(env!("CARGO_PKG_NAME"));
    }
}
