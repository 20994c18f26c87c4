// SPDX-License-Identifier: MIT
//! What a call says: done, or why not and how far.
use crate::ffi;
use std::ffi::CStr;
use std::fmt;

/// A negative status.  The state is then as before the call; see [`Stopped`]
/// for the calls that keep the progress made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
#[non_exhaustive]
pub enum Error {
    /// Parameters, a table or losses out of range.
    Params = ffi::COIN_EPARAMS,
    /// State or body out of range.
    State = ffi::COIN_ESTATE,
    /// A step or a time out of range, or a step beyond its method.
    Step = ffi::COIN_ESTEP,
    /// Another argument out of range.
    Argument = ffi::COIN_EARG,
    /// There is no such motion.
    Domain = ffi::COIN_EDOMAIN,
    /// The coin falls flat.
    Flat = ffi::COIN_EFLAT,
    /// This build does not give the pinned bits.
    Build = ffi::COIN_EBUILD,
    /// phi, psi, a place or a rate would leave its range.
    Range = ffi::COIN_ERANGE,
}

impl Error {
    fn of(status: i32) -> Error {
        use Error::*;
        [Params, State, Step, Domain, Flat, Build, Range]
            .into_iter()
            .find(|error| error.status() == status)
            .unwrap_or(Argument)
    }

    /// The number of coin.h.
    pub fn status(self) -> i32 {
        self as i32
    }
}

impl fmt::Display for Error {
    /// The text of `coin_status_string()`.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let text =
            unsafe { CStr::from_ptr(ffi::coin_status_string(self.status())) };
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

/// A status that is no error: a set of bits, most often [`Status::OK`].
///
/// ```
/// use rollcoin::Status;
/// let stop = Status::SLIPS | Status::TOUCHES;
/// assert!(stop.contains(Status::SLIPS) && !stop.contains(Status::LIFTS));
/// assert_eq!(format!("{stop:?}"), "SLIPS | TOUCHES");
/// assert_eq!(stop - Status::SLIPS, Status::TOUCHES);
/// ```
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub struct Status(u32);

impl Status {
    /// Done, and nothing to say; of a body: it rolls.
    pub const OK: Status = Status(0);
    /// A real coin slips.
    pub const SLIPS: Status = Status(ffi::COIN_SLIPS);
    /// A real coin lifts off; of a body: it is off the table.
    pub const LIFTS: Status = Status(ffi::COIN_LIFTS);
    /// A step was beyond the method's limit of full accuracy.
    pub const COARSE: Status = Status(ffi::COIN_COARSE);
    /// cos(theta) < 0.01.
    pub const NEARLY_FLAT: Status = Status(ffi::COIN_NEARLY_FLAT);
    /// The coin lies flat, or stands, and stays.
    pub const RESTS: Status = Status(ffi::COIN_RESTS);
    /// Event of [`Body::move_by`](crate::Body::move_by): a slip or a flight has
    /// ended, and the coin rolls.
    pub const ROLLS: Status = Status(ffi::COIN_ROLLS);
    /// Event of the same: it comes down on the table.
    pub const TOUCHES: Status = Status(ffi::COIN_TOUCHES);
    /// An infinite time needs more than 100 calls of the library.
    pub const MORE: Status = Status(ffi::COIN_MORE);
    /// Event of [`Body::move_by`](crate::Body::move_by), without a pull: which
    /// side ends up is decided.
    pub const DECIDED: Status = Status(ffi::COIN_DECIDED);

    const NAMES: [(Status, &'static str); 9] = [
        (Status::SLIPS, "SLIPS"),
        (Status::LIFTS, "LIFTS"),
        (Status::COARSE, "COARSE"),
        (Status::NEARLY_FLAT, "NEARLY_FLAT"),
        (Status::RESTS, "RESTS"),
        (Status::ROLLS, "ROLLS"),
        (Status::TOUCHES, "TOUCHES"),
        (Status::MORE, "MORE"),
        (Status::DECIDED, "DECIDED"),
    ];

    /// Whether all bits of another are among these.
    pub const fn contains(self, other: Status) -> bool {
        self.0 & other.0 == other.0
    }

    /// The bits of coin.h.
    pub const fn bits(self) -> u32 {
        self.0
    }
}

impl std::ops::BitOr for Status {
    type Output = Status;
    fn bitor(self, other: Status) -> Status {
        Status(self.0 | other.0)
    }
}

/// The bits that the other has not.  A slip begins where `(status - before)`
/// has [`Status::SLIPS`], `before` the status of the call before.
impl std::ops::Sub for Status {
    type Output = Status;
    fn sub(self, other: Status) -> Status {
        Status(self.0 & !other.0)
    }
}

impl fmt::Debug for Status {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let names: Vec<_> = Status::NAMES
            .iter()
            .filter(|(bit, _)| self.contains(*bit))
            .map(|(_, name)| *name)
            .collect();
        f.write_str(if names.is_empty() { "OK" } else { "" })?;
        f.write_str(&names.join(" | "))
    }
}

pub(crate) fn checked(status: i32) -> Result<Status> {
    if status < 0 {
        Err(Error::of(status))
    } else {
        Ok(Status(status as u32))
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

/// What `call(time left, &mut moved)` says, and the time moved: calls again
/// where the steps of one call do not suffice, if `t` is infinite 100 times at
/// most.
pub(crate) fn moved_to(
    t: f64,
    mut call: impl FnMut(f64, &mut f64) -> i32,
) -> std::result::Result<(Status, f64), Stopped<f64>> {
    let mut said = (Status::MORE, 0.0);
    let mut calls = 0;
    while said.0.contains(Status::MORE) && (t < f64::INFINITY || calls < 100) {
        let mut part = 0.0;
        let status = call(t - said.1, &mut part);
        said = checked_to(status, said.1 + part)?;
        calls += 1;
    }
    Ok(said)
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
        return Err(Error::Domain);
    }
    Ok(value)
}
