//! Sandbox in which submissions are built and run.
//!
//! In the sandbox, a submission has no network, no home folder, no file to write to, and limited
//! resources. Bubblewrap makes the sandbox from namespaces. It shows only those files of the
//! machine that a compiler and a program need, and makes them read-only. Root ignores limits on
//! processes, so a program never runs as root.

mod beside;
pub(crate) mod faults;
mod filter;
pub(crate) mod memory_guard;
mod nobody;
pub(crate) mod processes;
mod registry;
pub(crate) mod room;
mod scratch;
mod self_test;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result};
use rustix::process::getuid;
use tempfile::TempDir;

use lab_kit::Kit;
use registry::Registry;
use scratch::Scratch;

/// Limits of a submission.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Time limit of a program.
    pub(crate) run: Duration,
    /// Time limit of the compiler for one submission.
    pub(crate) build: Duration,
    /// Whether programs may connect to each other through the loopback network, as ranks do.
    pub(crate) loopback: bool,
}

/// Limits for each process of a program, as arguments of `prlimit`.
const PROGRAM: [&str; 5] =
    ["--nproc=256", "--fsize=67108864", "--core=0", "--nofile=256", "--as=4294967296"];

/// Size limit of a file that the build of a submission writes, in bytes.
pub(crate) const BUILT_FILE: u64 = 1 << 26;
/// Size limit of a file that the build of the solution writes, in bytes. It is larger, because this
/// build compiles the dependencies too.
pub(crate) const GIVEN_FILE: u64 = 1 << 30;

/// Bytes that the build of a submission may write.
///
/// This is enough for sixteen objects, a library, and two programs. Each program has an object and
/// a file that describes it.
pub(crate) const BUILD_QUOTA: u64 = 24 * BUILT_FILE;

/// Size limit of a program's temporary files, in bytes.
const TEMPORARY: &str = "67108864";
/// Size limit of the memory that a program's ranks share, in bytes.
const SHARED: &str = "134217728";
/// Size limit of a build's temporary files, in bytes.
const BUILDS: &str = "1073741824";

/// User and group number of nobody.
const NOBODY: &str = "65534";

/// Folders and files of the machine that are visible in the sandbox, read-only.
///
/// They contain libraries, the launcher of ranks, and Vulkan drivers. Devices are not visible: a
/// kernel driver is a large attack surface, and Mesa's software driver computes the same results.
const SYSTEM: [&str; 10] = [
    "/usr",
    "/bin",
    "/lib",
    "/lib64",
    "/etc/ld.so.cache",
    "/etc/alternatives",
    "/etc/openmpi",
    "/etc/mpich",
    "/etc/vulkan",
    "/etc/glvnd",
];

/// Options of Cargo: the compiler prints only errors, and programs contain no symbols.
const SETTINGS: [&str; 4] =
    ["--config", "build.rustflags=['-Awarnings']", "--config", "profile.release.strip='symbols'"];

/// Shell that opens a file for bubblewrap.
const SHELL: &str = "/bin/sh";

/// Folders in which programs are looked up.
const PATH: &str = "/usr/local/bin:/usr/bin:/bin";

/// Environment of a program. It names no home folder and no window system, and turns off caches.
const ENVIRONMENT: [(&str, &str); 8] = [
    ("PATH", PATH),
    ("HOME", "/tmp"),
    ("TMPDIR", "/tmp"),
    ("NODEVICE_SELECT", "1"),
    ("MESA_SHADER_CACHE_DISABLE", "true"),
    ("HWLOC_HIDE_ERRORS", "2"),
    // The component `x86` of hwloc queries each processor by running on it. But no program in the
    // sandbox may change its processor affinity.
    ("HWLOC_COMPONENTS", "-x86"),
    // Reading another rank's memory requires a permission that no rank has in the sandbox.
    ("OMPI_MCA_btl_vader_single_copy_mechanism", "none"),
];

/// Sandbox for submissions, or a replacement where the machine allows no sandbox.
#[derive(Debug)]
pub(crate) struct Sandbox {
    /// Folder of the compiler.
    sysroot: PathBuf,
    /// Folder in which Cargo keeps the sources of dependencies.
    cargo_home: PathBuf,
    /// Settings with which Cargo reaches the dependencies.
    registry: Registry,
    /// Whether a sandbox can be made on this machine.
    pub(crate) keeps: bool,
    /// Whether code runs as [`nobody`] because no sandbox can be made.
    as_nobody: bool,
    pub(crate) limits: Limits,
    scratch: Scratch,
    /// File with the [`filter`] of system calls; `None` if there is no filter.
    filter: Option<PathBuf>,
}

impl Sandbox {
    /// Checks whether a sandbox can be made on this machine.
    ///
    /// # Errors
    /// If no sandbox can be made and the code is not `trusted`. The message gives the reason.
    pub(crate) fn find(kit: &Kit, trusted: bool, limits: Limits) -> Result<Self> {
        let output = Command::new("rustc")
            .args(["--print", "sysroot"])
            .current_dir(kit.root())
            .output()
            .context("cannot ask rustc for its folder")?;
        let sysroot = PathBuf::from(String::from_utf8_lossy(&output.stdout).trim());
        let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
        let home = home.or_else(|| Some(std::env::home_dir()?.join(".cargo")));
        let cargo_home = home.context("there is no home folder with cargo's in it")?;
        let scratch = Scratch::below(&std::env::temp_dir())?;
        let filter = filter::write(scratch.path(), limits.loopback);
        let filter = filter.context("cannot write a filter")?;
        let registry = Registry::of(&cargo_home, scratch.path())?;
        let keeps = true;
        let as_nobody = false;
        let mut sandbox =
            Self { sysroot, cargo_home, registry, keeps, as_nobody, limits, scratch, filter };
        if let Err(why) = self_test::check(&sandbox) {
            let none = "foreign code cannot be kept in a sandbox here";
            if !trusted {
                let advice = "if you trust it, say --trusted (it then runs with all your rights)";
                return Err(why.context(format!("{none}; {advice}")));
            }
            eprintln!("{none}: {why:#}");
            sandbox.keeps = false;
            sandbox.as_nobody = nobody::can_build(&sandbox.sysroot, &sandbox.cargo_home);
            let rights = if sandbox.as_nobody { "as nobody" } else { "with all your rights" };
            eprintln!("NO SANDBOX: submissions run {rights}");
        }
        Ok(sandbox)
    }

    /// Returns the folders of this machine that may occur in messages of a program or the compiler.
    pub(crate) fn folders(&self) -> [&Path; 3] {
        [&self.sysroot, &self.cargo_home, self.scratch()]
    }

    /// Makes a new temporary folder that programs can read.
    pub(crate) fn folder(&self) -> Result<TempDir> {
        self.scratch.folder()
    }

    /// Checks that programs can be started in the sandbox now.
    ///
    /// # Errors
    /// If programs cannot be started. The message gives the reason.
    pub(crate) fn works(&self) -> Result<()> {
        if self.keeps { self_test::check(self) } else { Ok(()) }
    }

    /// Returns the folder that contains the temporary folders.
    pub(crate) fn scratch(&self) -> &Path {
        self.scratch.path()
    }

    /// Returns a command that runs Cargo in `tree` and writes no file of more than `most` bytes.
    ///
    /// Inside the sandbox `tree` is `/kit` and writable. No program of a submission runs during a
    /// build, because the compiler only reads its sources.
    pub(crate) fn cargo(&self, tree: &Path, most: u64) -> Command {
        let cargo = self.sysroot.join("bin/cargo");
        if !self.keeps {
            let mut command = Command::new(cargo);
            if self.as_nobody {
                command = nobody::cargo(&self.sysroot, &self.cargo_home, tree);
            }
            self.registry.set(&mut command);
            command.current_dir(tree).env("CARGO_TARGET_DIR", tree.join("target"));
            command.env("CARGO_INCREMENTAL", "0").args(SETTINGS);
            return command;
        }
        let mut command = launcher("prlimit");
        command.args(["--core=0", &format!("--fsize={most}"), "bwrap"]);
        namespaces(&mut command, BUILDS);
        command.arg("--bind").arg(tree).arg("/kit");
        command.arg("--ro-bind").arg(&self.sysroot).arg(&self.sysroot);
        command.args(["--dir", "/cargo"]);
        for part in ["registry", "git"] {
            let path = self.cargo_home.join(part);
            command.arg("--ro-bind-try").arg(path).arg(format!("/cargo/{part}"));
        }
        command.arg("--ro-bind").arg(self.registry.home.join("config.toml"));
        command.arg("/cargo/config.toml");
        for folder in &self.registry.folders {
            command.arg("--ro-bind-try").args([folder, folder]);
        }
        let path = format!("{}/bin:{PATH}", self.sysroot.display());
        for (name, value) in [
            ("PATH", path.as_str()),
            ("CARGO_HOME", "/cargo"),
            ("CARGO_TARGET_DIR", "/kit/target"),
            // Incremental data would be useless, because each submission is built once.
            ("CARGO_INCREMENTAL", "0"),
        ] {
            command.args(["--setenv", name, value]);
        }
        command.args(["--chdir", "/kit"]).arg(cargo).args(SETTINGS);
        command
    }

    /// Returns a command that runs the program `name` in `folder`.
    pub(crate) fn program(&self, folder: &Path, name: &str) -> Command {
        let mut command = Command::new(folder.join(name));
        if self.as_nobody {
            command = nobody::program(&folder.join(name));
        } else if self.keeps {
            command = self.inside(folder);
            command.arg(Path::new("/kit").join(name));
        }
        command
    }

    /// Returns a command that runs a shell, with `folder` as `/kit`.
    pub(crate) fn shell(&self, folder: &Path) -> Command {
        let mut command = self.inside(folder);
        command.arg(SHELL);
        command
    }

    /// Returns a command that starts the sandbox, with `folder` as `/kit`. The caller appends a
    /// program and its arguments.
    fn inside(&self, folder: &Path) -> Command {
        // The system counts processes by user. The limit is set inside the sandbox, so that only
        // the sandbox's own processes count. Otherwise one fork bomb would keep every other
        // submission from starting.
        let mut command = if getuid().is_root() {
            let mut command = launcher("setpriv");
            command.args(["--reuid", NOBODY, "--regid", NOBODY, "--clear-groups", SHELL]);
            command
        } else {
            launcher(SHELL)
        };
        if let Some(filter) = &self.filter {
            // Bubblewrap reads an open file to its end, so each sandbox opens the filter again.
            command.args(["-c", "exec bwrap --seccomp 3 \"$@\" 3<\"$0\""]).arg(filter);
        } else {
            command.args(["-c", "exec bwrap \"$@\"", "sh"]);
        }
        namespaces(&mut command, TEMPORARY);
        command.args(["--size", SHARED, "--tmpfs", "/dev/shm"]);
        command.arg("--ro-bind").arg(folder).arg("/kit");
        // A shared mapping of `/dev/zero` would be memory that no limit counts.
        command.args(["--ro-bind", "/dev/null", "/dev/zero"]);
        // Through `/proc/self/mem` a program could overwrite its own code.
        command.args(["--remount-ro", "/proc", "--remount-ro", "/dev", "--remount-ro", "/"]);
        command.args(["--chdir", "/kit"]);
        for (name, value) in ENVIRONMENT {
            command.args(["--setenv", name, value]);
        }
        command.arg("/usr/bin/prlimit").args(PROGRAM);
        command
    }
}

/// Returns a command that makes the sandbox.
///
/// Code inside the sandbox could read the environment of this command, and a shell also adds its
/// current folder to it. Therefore the environment contains only `PATH`.
fn launcher(program: &str) -> Command {
    let mut command = Command::new(program);
    command.env_clear().current_dir("/");
    command.envs(std::env::var_os("PATH").map(|path| ("PATH", path)));
    command
}

fn namespaces(command: &mut Command, temporary: &str) {
    command.args(["--unshare-all", "--uid", NOBODY, "--gid", NOBODY, "--cap-drop", "ALL"]);
    command.args(["--die-with-parent", "--new-session", "--clearenv", "--proc", "/proc"]);
    command.args(["--dev", "/dev", "--size", temporary, "--tmpfs", "/tmp"]);
    for path in SYSTEM {
        command.args(["--ro-bind-try", path, path]);
    }
}
