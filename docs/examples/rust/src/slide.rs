// SPDX-License-Identifier: MIT
//! Coins that may slip.
use crate::status::{checked_to, filled, number};
use crate::{
    ffi, Force, Friction, Losses, Params, Result, Slide, State, Status, Stopped,
};

/// Null where there are no losses.
fn pointer(l: Option<&Losses>) -> *const Losses {
    l.map_or(std::ptr::null(), |l| l)
}

impl Slide {
    /// A coin that may slip, and rolls now.
    pub fn of(s: &State, p: &Params) -> Result<Slide> {
        filled(|d| unsafe { ffi::coin_slide_of(d, s, p) })
    }

    /// Moves by any time: it rolls at the end, [`Status::slips`] or
    /// [`Status::rests`]; and the time moved by.
    pub fn advance(
        &mut self,
        p: &Params,
        friction: &Friction,
        l: Option<&Losses>,
        t: f64,
        tol: f64,
    ) -> std::result::Result<(Status, f64), Stopped<f64>> {
        let mut reached = 0.0;
        let status = unsafe {
            ffi::coin_slide_advance(
                self,
                p,
                friction,
                pointer(l),
                t,
                tol,
                &mut reached,
            )
        };
        checked_to(status, reached)
    }

    /// Kinetic and potential energy.
    pub fn energy(&self, p: &Params) -> Result<f64> {
        let energy = unsafe { ffi::coin_slide_energy(self, p) };
        number(energy, || self.velocity(p))
    }

    /// The force of the table, of rolling or of the slip.
    pub fn reaction(
        &self,
        p: &Params,
        friction: &Friction,
        l: Option<&Losses>,
    ) -> Result<Force> {
        filled(|force| unsafe {
            ffi::coin_slide_reaction(self, p, friction, pointer(l), force)
        })
    }

    /// The slip velocity, along x and z.
    pub fn velocity(&self, p: &Params) -> Result<[f64; 2]> {
        filled(|u: &mut [f64; 2]| unsafe {
            ffi::coin_slide_velocity(self, p, u.as_mut_ptr())
        })
    }
}
