//! Where foreign code is built and run: no network, no home, nothing to write to, limits.
//!
//! Bubblewrap makes it: namespaces of its own, and of the machine only what a compiler and
//! a program need, read-only. Root ignores limits on processes, so a program never runs as root.

mod beside;
pub(crate) mod faults;
mod filter;
pub(crate) mod memory;
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

/// What foreign code may have.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// The longest time of a program.
    pub(crate) run: Duration,
    /// The longest time of the compiler, for one submission.
    pub(crate) build: Duration,
    /// Whether programs may connect to each other through the network's loopback, as ranks do.
    pub(crate) loopback: bool,
}

/// What a process of a program may have.
const PROGRAM: [&str; 5] =
    ["--nproc=256", "--fsize=67108864", "--core=0", "--nofile=256", "--as=4294967296"];

/// Bytes of a file that the build of a submission may write, and of one that the build of the solution may write: it
/// compiles what the lab depends on.
pub(crate) const BUILT_FILE: u64 = 1 << 26;
pub(crate) const GIVEN_FILE: u64 = 1 << 30;

/// Bytes that the build of a submission may write: its objects, of which there are sixteen, its library, and two programs
/// with an object and a file that describes each.
pub(crate) const BUILD_QUOTA: u64 = 24 * BUILT_FILE;

/// Bytes of a program's own temporary files, of memory that its ranks share, of a build's temporary files.
const TEMPORARY: &str = "67108864";
const SHARED: &str = "134217728";
const BUILDS: &str = "1073741824";

/// Nobody's number, of user and group.
const NOBODY: &str = "65534";

/// What of the machine is there, read-only: libraries, the ranks' launcher, drivers of Vulkan. No device is: what
/// its driver has in the system's core is a large thing to show to strangers, and Mesa's software driver
/// computes the same.
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

/// Only errors are printed, and programs have no symbols.
const SETTINGS: [&str; 4] =
    ["--config", "build.rustflags=['-Awarnings']", "--config", "profile.release.strip='symbols'"];

/// What opens a file for bubblewrap.
const SHELL: &str = "/bin/sh";

/// Where programs are looked for.
const PATH: &str = "/usr/local/bin:/usr/bin:/bin";

/// Where a program finds the file that it may write.
const WRITTEN: &str = "/written";

/// What a program is told. There is no home, no window system, and nothing is kept for later.
const ENVIRONMENT: [(&str, &str); 8] = [
    ("PATH", PATH),
    ("HOME", "/tmp"),
    ("TMPDIR", "/tmp"),
    ("NODEVICE_SELECT", "1"),
    ("MESA_SHADER_CACHE_DISABLE", "true"),
    ("HWLOC_HIDE_ERRORS", "2"),
    // It would go to each processor to ask what it is, which no program may.
    ("HWLOC_COMPONENTS", "-x86"),
    // One rank reading another's memory needs a right that no rank has here.
    ("OMPI_MCA_btl_vader_single_copy_mechanism", "none"),
];

/// How foreign code is kept in; or that it is not.
#[derive(Debug)]
pub(crate) struct Sandbox {
    /// The compiler's folder.
    sysroot: PathBuf,
    /// Where cargo keeps the sources of dependencies.
    cargo_home: PathBuf,
    /// And how it reaches them.
    registry: Registry,
    /// Whether code is kept in: it can be made here.
    pub(crate) keeps: bool,
    /// Whether code runs at least as [`nobody`], where nothing keeps it in.
    as_nobody: bool,
    pub(crate) limits: Limits,
    scratch: Scratch,
    /// See [`filter`].
    filter: Option<PathBuf>,
}

impl Sandbox {
    /// Finds out whether a sandbox can be made here.
    ///
    /// # Errors
    /// It cannot, and the code is not `trusted`; the message says why.
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
            eprintln!("NO SANDBOX: what was handed in runs {rights}");
        }
        Ok(sandbox)
    }

    /// Folders of this machine that a program or the compiler may name.
    pub(crate) fn folders(&self) -> [&Path; 3] {
        [&self.sysroot, &self.cargo_home, self.scratch()]
    }

    /// A new temporary folder, into which programs can look.
    pub(crate) fn folder(&self) -> Result<TempDir> {
        self.scratch.folder()
    }

    /// Whether programs can be started in it now.
    ///
    /// # Errors
    /// They cannot; the message says why.
    pub(crate) fn works(&self) -> Result<()> {
        if self.keeps { self_test::check(self) } else { Ok(()) }
    }

    /// Where its temporary folders are.
    pub(crate) fn scratch(&self) -> &Path {
        self.scratch.path()
    }

    /// Cargo, in `tree`, which is `/kit` inside and may be written: no program of a submission
    /// runs during a build, the compiler only reads its sources. It writes no larger file than `most` bytes.
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
            // Nobody's sources are built twice.
            ("CARGO_INCREMENTAL", "0"),
        ] {
            command.args(["--setenv", name, value]);
        }
        command.args(["--chdir", "/kit"]).arg(cargo).args(SETTINGS);
        command
    }

    /// A program that lies in `folder` and may write one file, whose name is then its first argument, or none.
    pub(crate) fn program(&self, folder: &Path, name: &str, written: Option<&Path>) -> Command {
        let mut command = Command::new(folder.join(name));
        if self.as_nobody {
            command = nobody::program(&folder.join(name));
        } else if self.keeps {
            command = self.inside(folder, written);
            command.arg(Path::new("/kit").join(name));
        }
        command.args(written.map(|file| if self.keeps { Path::new(WRITTEN) } else { file }));
        command
    }

    /// A shell, with `folder` as `/kit`.
    pub(crate) fn shell(&self, folder: &Path) -> Command {
        let mut command = self.inside(folder, None);
        command.arg(SHELL);
        command
    }

    /// Whatever is given next runs in the sandbox, with `folder` as `/kit`, and may write a file.
    fn inside(&self, folder: &Path, written: Option<&Path>) -> Command {
        // Processes are counted by user. The limit is set inside, where only this sandbox's own
        // count: set outside, one fork bomb would keep every other submission from starting.
        let mut command = if getuid().is_root() {
            let mut command = launcher("setpriv");
            command.args(["--reuid", NOBODY, "--regid", NOBODY, "--clear-groups", SHELL]);
            command
        } else {
            launcher(SHELL)
        };
        if let Some(filter) = &self.filter {
            // Bubblewrap wants an open file, and reads it to its end: each needs one of its own.
            command.args(["-c", "exec bwrap --seccomp 3 \"$@\" 3<\"$0\""]).arg(filter);
        } else {
            command.args(["-c", "exec bwrap \"$@\"", "sh"]);
        }
        namespaces(&mut command, TEMPORARY);
        command.args(["--size", SHARED, "--tmpfs", "/dev/shm"]);
        command.arg("--ro-bind").arg(folder).arg("/kit");
        if let Some(file) = written {
            command.arg("--bind").arg(file).arg(WRITTEN);
        }
        // A shared mapping of it would be memory that no limit counts.
        command.args(["--ro-bind", "/dev/null", "/dev/zero"]);
        // Through /proc/self/mem a program could change what it is.
        command.args(["--remount-ro", "/proc", "--remount-ro", "/dev", "--remount-ro", "/"]);
        command.args(["--chdir", "/kit"]);
        for (name, value) in ENVIRONMENT {
            command.args(["--setenv", name, value]);
        }
        command.arg("/usr/bin/prlimit").args(PROGRAM);
        command
    }
}

/// A program that makes the sandbox. Who is inside could read its environment, where a shell puts its folder too: so
/// there is nothing but where programs are.
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
