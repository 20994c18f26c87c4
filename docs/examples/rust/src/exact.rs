// SPDX-License-Identifier: MIT
//! Motion without steps, and which model a scene needs.
use crate::status::{checked, filled};
use crate::{ffi, Orbit, Params, Result, State};

/// Models of a motion, from the cheapest on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Model {
    /// [`State::steady_at`].
    Steady = ffi::COIN_MODEL_STEADY as isize,
    /// [`State::wobble_at`].
    Wobble = ffi::COIN_MODEL_WOBBLE as isize,
    /// [`Orbit::at`].
    Orbit = ffi::COIN_MODEL_ORBIT as isize,
    /// [`State::run`] or [`State::advance`].
    Steps = ffi::COIN_MODEL_STEPS as isize,
}

impl State {
    /// This steady motion at any time.
    pub fn steady_at(&self, p: &Params, t: f64) -> Result<State> {
        filled(|out| unsafe { ffi::coin_steady_at(self, p, t, out) })
    }

    /// A small wobble about this steady motion, at any time.
    pub fn wobble_at(
        &self,
        p: &Params,
        start: &State,
        t: f64,
    ) -> Result<State> {
        filled(|out| unsafe { ffi::coin_wobble_at(self, p, start, t, out) })
    }

    /// The cheapest model that keeps the pose within `tol` for so long.
    pub fn model_needed(
        &self,
        p: &Params,
        horizon: f64,
        tol: f64,
    ) -> Result<Model> {
        let model =
            checked(unsafe { ffi::coin_model_needed(self, p, horizon, tol) })?;
        Ok([Model::Steady, Model::Wobble, Model::Orbit]
            .into_iter()
            .find(|&known| known as i32 == model.bits())
            .unwrap_or(Model::Steps))
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
