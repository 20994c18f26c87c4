// SPDX-License-Identifier: MIT
//! Coins that slow down.
use crate::status::{checked, checked_to, filled, number};
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

    /// Moves by a time, or until the coin lies flat: [`Status::RESTS`]; and
    /// the time moved by.
    pub fn settle(
        &mut self,
        p: &Params,
        l: &Losses,
        t: f64,
        tol: f64,
    ) -> std::result::Result<(Status, f64), Stopped<f64>> {
        let mut reached = 0.0;
        let status =
            unsafe { ffi::coin_settle(self, p, l, t, tol, &mut reached) };
        checked_to(status, reached)
    }

    /// The time until it lies flat; infinity if nothing stops it.
    pub fn time_to_rest(&self, p: &Params, l: &Losses) -> Result<f64> {
        let time = unsafe { ffi::coin_time_to_rest(self, p, l) };
        number(time, || l.check(p).and_then(|()| self.state_check(p)))
    }
}
