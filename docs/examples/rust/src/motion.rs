// SPDX-License-Identifier: MIT
//! What moves a coin, or many.
use crate::status::{checked, checked_to, moved_to};
use crate::{ffi, Error, Params, Result, State, Status, Stopped};
use std::ffi::CStr;

/// Methods of integration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Classical Runge-Kutta, order 4.
    Rk4 = ffi::COIN_RK4 as isize,
    /// Dormand-Prince, order 8.
    Rk8 = ffi::COIN_RK8 as isize,
    /// Kick-drift-kick with the exact drift, order 2.
    Symplectic2 = ffi::COIN_SYMPLECTIC2 as isize,
    /// Chin 4A with the exact drift, order 4.
    Symplectic4 = ffi::COIN_SYMPLECTIC4 as isize,
}

impl Method {
    /// "rk4", ...
    pub fn name(self) -> &'static str {
        let name =
            unsafe { CStr::from_ptr(ffi::coin_method_name(self as i32)) };
        name.to_str().unwrap_or_default()
    }
}

impl State {
    /// One classical Runge-Kutta step.
    pub fn step(&mut self, p: &Params, dt: f64) -> Result<Status> {
        checked(unsafe { ffi::coin_step(self, p, dt) })
    }

    /// Moves by a number of steps; an error says how many were done.
    pub fn run(
        &mut self,
        p: &Params,
        method: Method,
        dt: f64,
        steps: u64,
    ) -> std::result::Result<Status, Stopped<u64>> {
        let mut done = 0;
        let status = unsafe {
            ffi::coin_run(self, p, method as i32, dt, steps, &mut done)
        };
        Ok(checked_to(status, done)?.0)
    }

    /// Moves by any time to an accuracy; returns the time moved.
    pub fn advance(
        &mut self,
        p: &Params,
        t: f64,
        tol: f64,
    ) -> std::result::Result<f64, Stopped<f64>> {
        let said = moved_to(t, |left, moved| unsafe {
            ffi::coin_advance(self, p, left, tol, moved)
        });
        Ok(said?.1)
    }

    /// Fills `path` with states `steps_per_sample` steps apart, this one first;
    /// an error says how many were written.
    pub fn sample(
        &self,
        p: &Params,
        method: Method,
        dt: f64,
        steps_per_sample: u64,
        path: &mut [State],
    ) -> std::result::Result<Status, Stopped<usize>> {
        let mut done = 0;
        let status = unsafe {
            ffi::coin_sample(
                self,
                p,
                method as i32,
                dt,
                steps_per_sample,
                path.len(),
                path.as_mut_ptr(),
                &mut done,
            )
        };
        Ok(checked_to(status, done)?.0)
    }
}

/// [`State::run`] for many coins of one body, each with the bits that it gets
/// alone; returns what is said of each.  A coin that fails stays at its last
/// good state, and the others go on.  An error touched none.
pub fn batch_run(
    coins: &mut [State],
    p: &Params,
    method: Method,
    dt: f64,
    steps: u64,
) -> Result<Vec<Result<Status>>> {
    let mut statuses = vec![0; coins.len()];
    let first = checked(unsafe {
        ffi::coin_batch_run(
            coins.as_mut_ptr(),
            coins.len(),
            p,
            method as i32,
            dt,
            steps,
            statuses.as_mut_ptr(),
        )
    });
    match first {
        Err(error @ (Error::Params | Error::Argument)) => Err(error),
        _ => Ok(statuses.into_iter().map(checked).collect()),
    }
}
