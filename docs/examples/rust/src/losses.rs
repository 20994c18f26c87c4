// SPDX-License-Identifier: MIT
//! Coins that slow down.
use crate::status::{checked, filled, moved_to, number};
use crate::{ffi, Force, Losses, Params, Result, State, Status, Stopped};

impl Losses {
    /// Whether they can be computed with.
    pub fn check(&self, p: &Params) -> Result<()> {
        checked(unsafe { ffi::coin_losses_check(self, p) })?;
        Ok(())
    }

    /// All terms but `soft` and `flat` times one factor, so that a coin rests after
    /// `time`.
    pub fn fit(&self, s: &State, p: &Params, time: f64) -> Result<Losses> {
        let mut fitted = *self;
        checked(unsafe { ffi::coin_losses_fit(&mut fitted, s, p, time) })?;
        Ok(fitted)
    }
}

impl State {
    /// The power that the losses take.
    pub fn losses_power(&self, p: &Params, l: &Losses) -> Result<f64> {
        let power = unsafe { ffi::coin_losses_power(self, p, l) };
        number(power, || self.losses_rates(p, l))
    }

    /// [`State::rates`] with losses.
    pub fn losses_rates(&self, p: &Params, l: &Losses) -> Result<State> {
        filled(|rates| unsafe { ffi::coin_losses_rates(self, p, l, rates) })
    }

    /// [`State::reaction`] with losses.
    pub fn losses_reaction(&self, p: &Params, l: &Losses) -> Result<Force> {
        filled(|force| unsafe { ffi::coin_losses_reaction(self, p, l, force) })
    }

    /// Moves by a time, or until the coin rests: [`Status::RESTS`]; and the
    /// time moved by.  [`Status::MORE`] if an infinite time needs more than 100
    /// calls of the library.
    pub fn settle(
        &mut self,
        p: &Params,
        l: &Losses,
        t: f64,
        tol: f64,
    ) -> std::result::Result<(Status, f64), Stopped<f64>> {
        moved_to(t, |left, moved| unsafe {
            ffi::coin_settle(self, p, l, left, tol, moved)
        })
    }

    /// The time until it rests; infinity if nothing stops it.
    pub fn time_to_rest(
        &self,
        p: &Params,
        l: &Losses,
        tol: f64,
    ) -> Result<f64> {
        let time = unsafe { ffi::coin_time_to_rest(self, p, l, tol) };
        number(time, || Ok({ *self }.settle(p, l, 0.0, tol)?))
    }
}
