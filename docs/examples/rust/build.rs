// SPDX-License-Identifier: MIT
//! Links librollcoin.  It is taken from the first of these places:
//!
//! 1. the folder that ROLLCOIN_LIB names;
//! 2. where pkg-config finds it, if it is of this crate's version;
//! 3. the single header, compiled here by CC (cc) with CFLAGS (-O2): that of
//!    vendor/coin.h, or in a clone of rollcoin what `make single` writes.
use std::{
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};

fn main() {
    for name in ["ROLLCOIN_LIB", "PKG_CONFIG_PATH", "CC", "CFLAGS"] {
        println!("cargo:rerun-if-env-changed={name}");
    }
    let folder = env::var("ROLLCOIN_LIB")
        .map(PathBuf::from)
        .ok()
        .or_else(installed)
        .unwrap_or_else(compiled);
    let archive = folder.join("librollcoin.a").exists();
    let kind = if archive { "static" } else { "dylib" };
    println!("cargo:rustc-link-search=native={}", folder.display());
    println!("cargo:rustc-link-lib={kind}=rollcoin");
    println!("cargo:rustc-link-lib=m");
}

/// The folder of the library that pkg-config finds.
fn installed() -> Option<PathBuf> {
    let version = env::var("CARGO_PKG_VERSION").unwrap();
    let found = Command::new("pkg-config")
        .arg("--variable=libdir")
        .arg(format!("rollcoin = {version}"))
        .output()
        .ok()
        .filter(|found| found.status.success())?;
    let folder = String::from_utf8(found.stdout).ok()?;
    Some(PathBuf::from(folder.trim()))
}

/// The folder of a library compiled from the single header.
fn compiled() -> PathBuf {
    let out = PathBuf::from(env::var("OUT_DIR").unwrap());
    let header = single_header(&out);
    fs::write(
        out.join("coin.c"),
        "#define COIN_IMPLEMENTATION\n#include \"coin.h\"\n",
    )
    .unwrap();
    let flags = env::var("CFLAGS").unwrap_or_else(|_| "-O2".to_string());
    let cc = env::var("CC").unwrap_or_else(|_| "cc".to_string());
    let mut words = cc.split_whitespace();
    run(Command::new(words.next().expect("CC is blank"))
        .args(words)
        .args(flags.split_whitespace())
        .args(["-std=c99", "-fPIC", "-c", "coin.c", "-o", "coin.o"])
        .arg("-I")
        .arg(header)
        .current_dir(&out));
    run(Command::new("ar")
        .args(["rcs", "librollcoin.a", "coin.o"])
        .current_dir(&out));
    out
}

/// The folder of the single header; made in `out` if the crate has none.
fn single_header(out: &Path) -> PathBuf {
    let here = PathBuf::from(env::var("CARGO_MANIFEST_DIR").unwrap());
    let vendor = here.join("vendor");
    println!("cargo:rerun-if-changed={}", vendor.display());
    if vendor.join("coin.h").exists() {
        return vendor;
    }
    let clone = env::var("ROLLCOIN_CLONE")
        .map_or_else(|_| here.join("../../.."), PathBuf::from);
    assert!(
        clone.join("lib/about/single.awk").exists(),
        "no librollcoin: install it, set ROLLCOIN_LIB, or put the single \
         header into vendor/"
    );
    for folder in ["include", "lib"] {
        println!("cargo:rerun-if-changed={}", clone.join(folder).display());
    }
    run(Command::new("make")
        .args(["-s", "single"])
        .arg(format!("O={}", out.display()))
        .current_dir(&clone)
        .env_remove("MAKEFLAGS"));
    out.join("single")
}

fn run(command: &mut Command) {
    let status = command.status();
    assert!(
        status.map_or(false, |status| status.success()),
        "{command:?} failed"
    );
}
