// SPDX-License-Identifier: MIT
//! Steady motions.
use crate::status::filled;
use crate::{ffi, Params, Result, State};

impl State {
    /// Straight rolling, upright.
    #[allow(non_snake_case)]
    pub fn steady_roll(p: &Params, wZ: f64) -> Result<State> {
        filled(|s| unsafe { ffi::coin_steady_roll(s, p, wZ) })
    }

    /// Spinning with the centre at rest, leaning.
    pub fn steady_spin(p: &Params, theta: f64) -> Result<State> {
        filled(|s| unsafe { ffi::coin_steady_spin(s, p, theta) })
    }

    /// Spinning upright about a diameter.
    #[allow(non_snake_case)]
    pub fn steady_upright_spin(p: &Params, wY: f64) -> Result<State> {
        filled(|s| unsafe { ffi::coin_steady_upright_spin(s, p, wY) })
    }

    /// Rolling along a circle at a constant lean; `branch` is 1 or -1.
    #[allow(non_snake_case)]
    pub fn steady_circle(
        p: &Params,
        theta: f64,
        wZ: f64,
        branch: i32,
    ) -> Result<State> {
        filled(|s| unsafe { ffi::coin_steady_circle(s, p, theta, wZ, branch) })
    }

    /// Rolling at this lean; the centre's circle has this radius.
    pub fn steady_turn(p: &Params, theta: f64, radius: f64) -> Result<State> {
        filled(|s| unsafe { ffi::coin_steady_turn(s, p, theta, radius) })
    }

    /// Rolling along a circle at a speed, at the lean that this needs.
    pub fn steady_ride(p: &Params, speed: f64, radius: f64) -> Result<State> {
        filled(|s| unsafe { ffi::coin_steady_ride(s, p, speed, radius) })
    }

    /// The radii of the circles of the centre and of the contact.
    pub fn steady_radii(&self, p: &Params) -> Result<(f64, f64)> {
        filled(|out: &mut (f64, f64)| unsafe {
            ffi::coin_steady_radii(self, p, &mut out.0, &mut out.1)
        })
    }

    /// lambda^2: > 0, a small lean away grows as exp(sqrt(lambda^2) t).
    pub fn stability(&self, p: &Params) -> Result<f64> {
        filled(|lambda2| unsafe { ffi::coin_stability(self, p, lambda2) })
    }
}
