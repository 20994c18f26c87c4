// SPDX-License-Identifier: MIT
//! Links librollcoin.a: of the folder that ROLLCOIN_LIB names, or else where
//! pkg-config finds it.
use std::{env, process::Command};

fn main() {
    println!("cargo:rerun-if-env-changed=ROLLCOIN_LIB");
    let folder = env::var("ROLLCOIN_LIB").unwrap_or_else(|_| {
        let found = Command::new("pkg-config")
            .args(["--variable=libdir", "rollcoin"])
            .output()
            .expect("needs pkg-config, or ROLLCOIN_LIB");
        assert!(found.status.success(), "pkg-config knows no rollcoin");
        String::from_utf8(found.stdout).unwrap().trim().to_string()
    });
    println!("cargo:rustc-link-search=native={folder}");
    println!("cargo:rustc-link-lib=static=rollcoin");
    println!("cargo:rustc-link-lib=m");
}
