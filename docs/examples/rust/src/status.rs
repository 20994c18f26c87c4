// SPDX-License-Identifier: MIT
//! What a call says: done, or why not and how far.
use crate::ffi;
use std::ffi::CStr;
use std::fmt;

/// A negative status.  The state is then as before the call; see [`Stopped`]
/// for the calls that keep the progress made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Error(i32);

impl Error {
    /// Parameters, or losses, out of range.
    pub const PARAMS: Error = Error(ffi::COIN_EPARAMS);
    /// State out of range.
    pub const STATE: Error = Error(ffi::COIN_ESTATE);
    /// A step or a time that is not finite, negative where losses or slips
    /// forbid that, or too long.
    pub const STEP: Error = Error(ffi::COIN_ESTEP);
    /// Another argument out of range.
    pub const ARGUMENT: Error = Error(ffi::COIN_EARG);
    /// There is no such motion.
    pub const DOMAIN: Error = Error(ffi::COIN_EDOMAIN);
    /// The coin falls flat.
    pub const FLAT: Error = Error(ffi::COIN_EFLAT);
    /// phi, psi, x or z is at the end of its range.
    pub const RANGE: Error = Error(ffi::COIN_ERANGE);
    /// This build does not give the pinned bits.
    pub const BUILD: Error = Error(ffi::COIN_EBUILD);

    /// The number of coin.h.
    pub fn status(self) -> i32 {
        self.0
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let text = unsafe { CStr::from_ptr(ffi::coin_status_string(self.0)) };
        f.write_str(&text.to_string_lossy())
    }
}

impl std::error::Error for Error {}

/// What most calls return.
pub type Result<T> = std::result::Result<T, Error>;

/// An error on the way: the state is the last good one, and `done` says how
/// far that is, in steps, samples or time.  `?` makes an [`Error`] of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stopped<T> {
    /// Why.
    pub error: Error,
    /// How far.
    pub done: T,
}

impl<T> From<Stopped<T>> for Error {
    fn from(stopped: Stopped<T>) -> Error {
        stopped.error
    }
}

impl<T: fmt::Display> fmt::Display for Stopped<T> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}, after {}", self.error, self.done)
    }
}

impl<T: fmt::Display + fmt::Debug> std::error::Error for Stopped<T> {}

/// A status that is no error: done, as a rule without a word.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Status(i32);

impl Status {
    fn has(self, bit: u32) -> bool {
        self.0 & bit as i32 != 0
    }
    /// The bits of coin.h.
    pub fn bits(self) -> i32 {
        self.0
    }
    /// A real coin slips.
    pub fn slips(self) -> bool {
        self.has(ffi::COIN_SLIPS)
    }
    /// A real coin lifts off.
    pub fn lifts(self) -> bool {
        self.has(ffi::COIN_LIFTS)
    }
    /// A step was beyond the method's limit of full accuracy.
    pub fn coarse(self) -> bool {
        self.has(ffi::COIN_COARSE)
    }
    /// cos(theta) < 0.01.
    pub fn nearly_flat(self) -> bool {
        self.has(ffi::COIN_NEARLY_FLAT)
    }
    /// A slip has ended, and the coin rolls.
    pub fn rolls(self) -> bool {
        self.has(ffi::COIN_ROLLS)
    }
    /// The coin lies flat.
    pub fn rests(self) -> bool {
        self.has(ffi::COIN_RESTS)
    }
}

pub(crate) fn checked(status: i32) -> Result<Status> {
    if status < 0 {
        Err(Error(status))
    } else {
        Ok(Status(status))
    }
}

/// The same of a call that says how far it came.
pub(crate) fn checked_to<T>(
    status: i32,
    done: T,
) -> std::result::Result<(Status, T), Stopped<T>> {
    match checked(status) {
        Ok(status) => Ok((status, done)),
        Err(error) => Err(Stopped { error, done }),
    }
}

/// What a call writes, if it does well.
pub(crate) fn filled<T: Default>(call: impl Fn(&mut T) -> i32) -> Result<T> {
    let mut out = T::default();
    checked(call(&mut out))?;
    Ok(out)
}

/// A number, which is NaN on bad input: the error is that of `why`, or else
/// there is no such motion.
pub(crate) fn number<T>(
    value: f64,
    why: impl FnOnce() -> Result<T>,
) -> Result<f64> {
    if value.is_nan() {
        why()?;
        return Err(Error::DOMAIN);
    }
    Ok(value)
}
