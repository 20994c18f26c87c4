// SPDX-License-Identifier: MIT
//! Motion without steps.
use crate::status::{checked, filled};
use crate::{ffi, Orbit, Params, Result, State};

impl State {
    /// This steady motion at any time.
    pub fn steady_at(&self, p: &Params, t: f64) -> Result<State> {
        filled(|out| unsafe { ffi::coin_steady_at(self, p, t, out) })
    }
}

impl Orbit {
    /// A motion solved for all times: 32 KiB.
    pub fn new(s: &State, p: &Params) -> Result<Box<Orbit>> {
        let mut orbit = Box::<Orbit>::default();
        checked(unsafe { ffi::coin_orbit_init(&mut *orbit, s, p) })?;
        Ok(orbit)
    }

    /// The state at any time.
    pub fn at(&self, t: f64) -> Result<State> {
        filled(|out| unsafe { ffi::coin_orbit_at(self, t, out) })
    }
}
