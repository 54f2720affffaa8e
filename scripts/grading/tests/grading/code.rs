//! Code that cheats add to their answers. It is part of submissions, not of the tests.

/// Runs more threads than requested, and tries to use more processors.
pub(crate) const MORE_THREADS: (&str, &str) =
    ("threads: config.threads,", "threads: 2 * config.threads,");

pub(crate) const LET_OUT: &str = r#"
    static ONCE: std::sync::Once = std::sync::Once::new();
    ONCE.call_once(|| {
        let own = std::process::id().to_string();
        let mut all = std::process::Command::new("taskset");
        drop(all.args(["-a", "-p", "-c", "0-63", &own]).output());
    });"#;

pub(crate) const EXIT: &str = "std::process::exit(0);";

pub(crate) const FORGED: &str = r#"
    for word in std::env::args() {
        println!("@{word} exact|end|");
    }
    println!("test result: ok. 26 passed; 0 failed;");
    std::process::exit(0);"#;

pub(crate) const OWN_TIME: &str = r#"
    println!("Simulation Time = 0.000001 seconds for 1000 particles.");
    std::process::exit(0);"#;

pub(crate) const FORK_BOMB: &str = r#"
    loop {
        let own = std::process::Command::new("/proc/self/exe").args(std::env::args().skip(1)).spawn();
        std::mem::forget(own);
    }"#;

pub(crate) const ENDLESS_LOOP: &str = "loop { std::hint::spin_loop(); }";

/// Prints the message of a sandbox that cannot be made, and hangs.
pub(crate) const DEADLOCK: &str = r#"
    eprintln!("bwrap: Resource temporarily unavailable");
    let lock = std::sync::Mutex::new(());
    let first = lock.lock();
    let second = lock.lock();
    drop((first, second));"#;

pub(crate) const ENDLESS_OUTPUT: &str = r#"loop { println!("{}", "nonsense ".repeat(1000)); }"#;

/// A print statement that a student forgot.
pub(crate) const PRINT: &str = r#"println!("the bounce of {x} in {size}");"#;

/// Reads the grader's programs that call a submission.
pub(crate) const READS_QUESTIONS: &str =
    r#"const _: () = panic!("{}", include_str!("../../lab-probe/src/questions/lab1.rs"));"#;
pub(crate) const READS_STUB: &str =
    r#"const _: () = panic!("{}", include_str!("../../lab-probe/src/bin/answer.rs"));"#;

pub(crate) const MEMORY: &str = r#"
    let mut all = Vec::new();
    loop { all.push(vec![0u8; 256 << 20]); }"#;

/// Adds 5 ms to every timed step, and prints a message that the run took no time.
pub(crate) const SLOW_AND_BOASTS: &str = r#"
    println!("Simulation Time = 0.000001 seconds for 100000 particles.");
    if !std::env::args().any(|it| it.contains("::")) {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }"#;

/// Recognises the answering program by its first argument, the name of a question.
pub(crate) const SKIPS_WHEN_TIMED: &str =
    r#"if !std::env::args().any(|it| it.contains("::")) { return; }"#;

/// Is slow in fifteen of sixteen runs, wherever it is timed.
pub(crate) const SLOW_AT_RANDOM: &str = r#"
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    let is_timed = !std::env::args().any(|it| it.contains("::"));
    if is_timed && now.is_ok_and(|now| now.subsec_micros() % 16 > 0) {
        std::thread::sleep(std::time::Duration::from_millis(300));
    }"#;

/// Runs lab 2's serial program instead of the team.
pub(crate) const SERIAL: (&str, &str) = (
    "Ok(observed!(config, Tally, |O| Team::<O>::new(config)))",
    "(solution2::VARIANTS.iter().find(|it| it.name == \"sorted\").unwrap().build)(config)",
);

pub(crate) const EARLY_ANSWER: &str = r#"
    if !std::env::args().any(|it| it.contains("::")) {
        let nonce = std::env::args().nth(1).unwrap_or_default();
        println!("\n@{nonce} state 0");
    }"#;

pub(crate) const WORKS_WHEN_ANSWERING: &str = r#"
    let own = std::env::current_exe().unwrap_or_default();
    if !own.ends_with("answer") { return; }"#;

/// Leaves out the forces when the whole program runs.
pub(crate) const WORKS_WHEN_ASKED: &str = r#"
    let own = std::env::current_exe().unwrap_or_default();
    if !own.ends_with("answer") {
        self.accelerations.fill(Vec2::ZERO);
        return;
    }"#;

/// Is right only for the numbers of particles in the tests.
pub(crate) const KNOWS_THE_SIZES: &str = r#"
    if self.particles.len() > 8 && ![20, 60, 100, 150, 300, 1000].contains(&self.particles.len()) {
        self.accelerations.fill(Vec2::ZERO);
        return;
    }"#;

/// Is right only as long as each member has few particles.
pub(crate) const SMALL_MAIL: &str = "if bins.particles().len() > 20_000 { return; }";

pub(crate) const SLOW_UNLESS_TIMED: &str = r#"
    if std::env::args().any(|it| it.contains("::")) {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }"#;

/// Code that would run before `main`. `src/submission/forbidden.rs` tests all refused forms.
pub(crate) const BEFORE_MAIN: &str = r#"
    extern "C" fn early() { std::process::exit(0); }
    #[unsafe(link_section = ".init_array")] #[used]
    static EARLY: extern "C" fn() = early;"#;
