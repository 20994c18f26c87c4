// SPDX-License-Identifier: MIT
//! librollcoin in Rust: coins that roll without slipping.
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
//! status is an [`Error`], a positive one [`Warnings`].  `ffi` has all of its
//! functions, as bindgen writes them; what is safe here are those that most
//! programs want.
use std::ffi::CStr;
use std::fmt;

#[allow(non_camel_case_types, non_snake_case, non_upper_case_globals)]
#[allow(dead_code, missing_docs)]
pub mod ffi;

pub use ffi::{
    coin_force as Force, coin_params as Params, coin_state as State,
};

/// A negative status.  The state is then as before the call; after a run it is
/// the last good one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Error(i32);

impl Error {
    pub const PARAMS: Error = Error(ffi::COIN_EPARAMS as i32);
    pub const STATE: Error = Error(ffi::COIN_ESTATE as i32);
    pub const STEP: Error = Error(ffi::COIN_ESTEP as i32);
    pub const ARGUMENT: Error = Error(ffi::COIN_EARG as i32);
    pub const DOMAIN: Error = Error(ffi::COIN_EDOMAIN as i32);
    pub const FLAT: Error = Error(ffi::COIN_EFLAT as i32);
    pub const BUILD: Error = Error(ffi::COIN_EBUILD as i32);

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

pub type Result<T> = std::result::Result<T, Error>;

/// What came with a result: nothing, as a rule.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Warnings(i32);

impl Warnings {
    pub fn bits(self) -> i32 {
        self.0
    }
    pub fn slips(self) -> bool {
        self.0 & ffi::COIN_SLIPS as i32 != 0
    }
    pub fn lifts(self) -> bool {
        self.0 & ffi::COIN_LIFTS as i32 != 0
    }
    pub fn coarse(self) -> bool {
        self.0 & ffi::COIN_COARSE as i32 != 0
    }
    pub fn nearly_flat(self) -> bool {
        self.0 & ffi::COIN_NEARLY_FLAT as i32 != 0
    }
}

fn checked(status: i32) -> Result<Warnings> {
    if status < 0 {
        Err(Error(status))
    } else {
        Ok(Warnings(status))
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    Rk4 = ffi::COIN_RK4 as isize,
    Rk8 = ffi::COIN_RK8 as isize,
    Symplectic2 = ffi::COIN_SYMPLECTIC2 as isize,
    Symplectic4 = ffi::COIN_SYMPLECTIC4 as isize,
}

impl Params {
    /// A uniform thin disc.
    pub fn disc(mass: f64, radius: f64, gravity: f64) -> Result<Params> {
        let mut p = Params::default();
        checked(unsafe {
            ffi::coin_params_disc(&mut p, mass, radius, gravity)
        })?;
        Ok(p)
    }

    /// A thin ring; `inner_radius` from 0, a disc, to `radius`, a hoop.
    pub fn ring(
        mass: f64,
        radius: f64,
        inner_radius: f64,
        gravity: f64,
    ) -> Result<Params> {
        let mut p = Params::default();
        checked(unsafe {
            ffi::coin_params_ring(&mut p, mass, radius, inner_radius, gravity)
        })?;
        Ok(p)
    }
}

impl State {
    /// One classical Runge-Kutta step.
    pub fn step(&mut self, p: &Params, dt: f64) -> Result<Warnings> {
        checked(unsafe { ffi::coin_step(self, p, dt) })
    }

    /// Moves by a number of steps.
    pub fn run(
        &mut self,
        p: &Params,
        method: Method,
        dt: f64,
        steps: u64,
    ) -> Result<Warnings> {
        checked(unsafe {
            ffi::coin_run(
                self,
                p,
                method as i32,
                dt,
                steps,
                std::ptr::null_mut(),
            )
        })
    }

    /// Moves by any time to an accuracy; returns the time moved.
    pub fn advance(&mut self, p: &Params, t: f64, tol: f64) -> Result<f64> {
        let mut reached = 0.0;
        checked(unsafe { ffi::coin_advance(self, p, t, tol, &mut reached) })?;
        Ok(reached)
    }

    /// Fills `path` with states `steps_per_sample` steps apart, this one first.
    pub fn sample(
        &self,
        p: &Params,
        method: Method,
        dt: f64,
        steps_per_sample: u64,
        path: &mut [State],
    ) -> Result<Warnings> {
        checked(unsafe {
            ffi::coin_sample(
                self,
                p,
                method as i32,
                dt,
                steps_per_sample,
                path.len(),
                path.as_mut_ptr(),
                std::ptr::null_mut(),
            )
        })
    }

    /// The energy; `Error::STATE` if it is not a number.
    pub fn energy(&self, p: &Params) -> Result<f64> {
        let energy = unsafe { ffi::coin_energy(self, p) };
        if energy.is_nan() {
            checked(unsafe { ffi::coin_state_check(self, p) })?;
        }
        Ok(energy)
    }

    /// The force of the table.
    pub fn reaction(&self, p: &Params) -> Result<Force> {
        let mut force = Force::default();
        checked(unsafe { ffi::coin_reaction(self, p, &mut force) })?;
        Ok(force)
    }

    /// x, y, z of the centre of mass.
    pub fn center(&self, p: &Params) -> Result<[f64; 3]> {
        let mut r = [0.0; 3];
        checked(unsafe { ffi::coin_center(self, p, r.as_mut_ptr()) })?;
        Ok(r)
    }

    /// The rotation w, x, y, z of the body.
    pub fn quaternion(&self) -> Result<[f64; 4]> {
        let mut q = [0.0; 4];
        checked(unsafe { ffi::coin_quaternion(self, q.as_mut_ptr()) })?;
        Ok(q)
    }

    /// Whether the rolling model and a step hold.
    pub fn check(
        &self,
        p: &Params,
        method: Method,
        dt: f64,
        mu: f64,
    ) -> Result<Warnings> {
        checked(unsafe { ffi::coin_check(self, p, method as i32, dt, mu) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quarter() -> (Params, State) {
        let p = Params::disc(0.00567, 0.01213, 9.80665).unwrap();
        (
            p,
            State {
                theta: 0.3,
                wY: 5.0,
                wZ: 40.0,
                ..State::default()
            },
        )
    }

    #[test]
    fn a_negative_status_is_an_error_and_touches_nothing() {
        let (p, mut s) = quarter();
        let before = s;
        assert_eq!(Params::disc(-1.0, 1.0, 1.0), Err(Error::PARAMS));
        assert_eq!(s.run(&p, Method::Rk4, 1.0, 1), Err(Error::STEP));
        assert_eq!(s.run(&p, Method::Rk4, f64::NAN, 1), Err(Error::STEP));
        s.theta = 2.0;
        assert_eq!(s.energy(&p), Err(Error::STATE));
        assert_eq!(s.center(&p), Err(Error::STATE));
        s.theta = before.theta;
        assert_eq!(s, before);
        assert_eq!(Error::FLAT.to_string(), "the coin falls flat");
        assert_eq!(Error::BUILD.status(), -7);
    }

    #[test]
    fn a_positive_status_is_a_warning() {
        let (p, mut s) = quarter();
        assert!(!s.run(&p, Method::Rk8, 1e-2, 10).unwrap().coarse());
        assert!(s.run(&p, Method::Rk4, 1e-2, 1).unwrap().coarse());
        let bits = s.check(&p, Method::Rk4, 1e-3, 0.01).unwrap();
        assert!(bits.slips() && !bits.lifts() && !bits.nearly_flat());
    }

    #[test]
    fn steps_runs_and_samples_agree() {
        let (p, s) = quarter();
        let (mut one, mut other, mut path) = (s, s, [State::default(); 3]);
        one.step(&p, 1e-3).unwrap();
        other.run(&p, Method::Rk4, 1e-3, 1).unwrap();
        assert_eq!(one, other);
        other = s;
        other.run(&p, Method::Rk8, 1e-3, 10).unwrap();
        s.sample(&p, Method::Rk8, 1e-3, 5, &mut path).unwrap();
        assert_eq!((path[0], path[2]), (s, other));
        assert_eq!(one.advance(&p, 0.0, 1e-9).unwrap(), 0.0);
    }

    #[test]
    fn a_falling_coin_is_an_error_too() {
        let p = Params::ring(1.0, 1.0, 0.5, 1.0).unwrap();
        let mut s = State {
            theta: 0.3,
            ..State::default()
        };
        assert_eq!(s.advance(&p, 100.0, 1e-9), Err(Error::FLAT));
        assert!(s.theta > 1.57);
    }
}
