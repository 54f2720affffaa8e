//! Finds an MPI library and translates its header to Rust. Without a library, `src/absent.rs` is used.

use std::env;
use std::error::Error;
use std::path::Path;

/// Types that are distinct types in Rust, although the library may define them as integers or pointers.
const HANDLES: &str = "MPI_(Comm|Datatype|Errhandler|Group|Info|Message|Op|Request|Session|Win)";

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=src/symbols.c");
    println!("cargo::rerun-if-changed=src/symbols.h");
    println!("cargo::rerun-if-env-changed=MPICC");
    println!("cargo::rustc-check-cfg=cfg(no_mpi)");
    let Ok(mpi) = build_probe_mpi::probe() else {
        println!("cargo::rustc-cfg=no_mpi");
        // The file never exists, so the next build looks again: a library may have been installed.
        println!("cargo::rerun-if-changed=src/no-such-file");
        return Ok(());
    };
    let mut compiler = cc::Build::new();
    compiler.file("src/symbols.c").includes(&mpi.include_paths);
    if let Some(mpicc) = &mpi.mpicc {
        compiler.compiler(mpicc);
    }
    compiler.compile("symbols");
    for folder in &mpi.lib_paths {
        println!("cargo::rustc-link-search=native={}", folder.display());
    }
    for library in &mpi.libs {
        println!("cargo::rustc-link-lib={library}");
    }
    bindgen::builder()
        .header("src/symbols.h")
        .clang_args(mpi.include_paths.iter().map(|folder| format!("-I{}", folder.display())))
        .new_type_alias(HANDLES)
        .derive_partialeq(true)
        .generate()?
        .write_to_file(Path::new(&env::var("OUT_DIR")?).join("library.rs"))?;
    Ok(())
}
