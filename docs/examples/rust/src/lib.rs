// SPDX-License-Identifier: MIT
//! librollcoin in Rust: the motion of a coin on a table.
//!
//! ```
//! use rollcoin::{Method, Params, State};
//!
//! let quarter = Params::disc(0.00567, 0.01213, 9.80665)?; // kg, m, m/s^2
//! let mut s = State { theta: 0.3, wY: 5.0, wZ: 40.0, ..State::default() };
//! s.run(&quarter, Method::Rk8, 1e-2, 100)?;
//! # Ok::<(), rollcoin::Error>(())
//! ```
//!
//! coin.h is the reference.  Its structs are used as they are; a negative
//! status is an [`Error`], with the progress made in [`Stopped`], any other a
//! [`Status`].  `ffi` has the functions of coin.h and coinf.h as bindgen writes
//! them; all those of coin.h have a safe form here, but coin_sizeof().
#![warn(missing_docs)]

#[allow(non_camel_case_types, non_snake_case, non_upper_case_globals)]
#[allow(dead_code, missing_docs, clippy::all)]
#[rustfmt::skip] // as bindgen lays it out
pub mod ffi;

mod body;
mod exact;
mod losses;
mod motion;
mod params;
mod read;
mod status;
mod steady;
#[cfg(test)]
mod tests;

pub use body::Face;
pub use ffi::{
    coin_body as Body, coin_force as Force, coin_losses as Losses,
    coin_orbit as Orbit, coin_params as Params, coin_state as State,
    coin_table as Table,
};
pub use motion::{batch_run, Method};
pub use status::{Error, Result, Status, Stopped};

use std::ffi::CStr;

/// The library's version, 0xMMmmpp.
pub fn version() -> u32 {
    unsafe { ffi::coin_version() }
}

/// The same as text, such as "1.2.3".
pub fn version_string() -> &'static str {
    let text = unsafe { CStr::from_ptr(ffi::coin_version_string()) };
    text.to_str().unwrap_or_default()
}

/// Whether this build computes the pinned bits.
pub fn selftest() -> Result<()> {
    status::checked(unsafe { ffi::coin_selftest() })?;
    Ok(())
}
