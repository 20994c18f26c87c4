// SPDX-License-Identifier: MIT
//! A real coin: it rolls, slips and comes to rest.
use crate::status::{checked, checked_to, filled, number};
use crate::{ffi, Body, Force, Params, Result, State, Status, Stopped, Table};

impl Table {
    /// Whether it can be computed with.
    pub fn check(&self, p: &Params) -> Result<()> {
        checked(unsafe { ffi::coin_table_check(self, p) })?;
        Ok(())
    }
}

impl Body {
    /// A body that rolls.
    pub fn from_state(s: &State, p: &Params) -> Result<Body> {
        filled(|b| unsafe { ffi::coin_body_from_state(b, s, p) })
    }

    /// A body of an engine, in the air or on the table.
    pub fn from_motion(
        p: &Params,
        q: [f64; 4],
        omega: [f64; 3],
        r: [f64; 3],
        v: [f64; 3],
    ) -> Result<Body> {
        filled(|b| unsafe {
            ffi::coin_body_from_motion(
                b,
                p,
                q.as_ptr(),
                omega.as_ptr(),
                r.as_ptr(),
                v.as_ptr(),
            )
        })
    }

    /// Moves by a time, or until one of the bits of `stop` begins to hold: its
    /// mode, [`Status::SLIPS`], [`Status::LIFTS`], [`Status::RESTS`] or, if it
    /// rolls, [`Status::OK`], and the bits of `stop` that hold; and the time
    /// moved by.
    pub fn advance(
        &mut self,
        p: &Params,
        table: &Table,
        t: f64,
        tol: f64,
        stop: Status,
    ) -> std::result::Result<(Status, f64), Stopped<f64>> {
        let mut reached = 0.0;
        let stop = stop.bits() as i32;
        let status = unsafe {
            ffi::coin_move(self, p, table, t, tol, stop, &mut reached)
        };
        checked_to(status, reached)
    }

    /// Kinetic and potential energy.
    pub fn energy(&self, p: &Params) -> Result<f64> {
        let energy = unsafe { ffi::coin_body_energy(self, p) };
        number(energy, || self.slip(p))
    }

    /// The force of the table, of rolling or of the slip.
    pub fn reaction(&self, p: &Params, table: &Table) -> Result<Force> {
        filled(|force| unsafe {
            ffi::coin_body_reaction(self, p, table, force)
        })
    }

    /// The slip velocity, along x and z.
    pub fn slip(&self, p: &Params) -> Result<[f64; 2]> {
        filled(|u: &mut [f64; 2]| unsafe {
            ffi::coin_body_slip(self, p, u.as_mut_ptr())
        })
    }

    /// [`State::matrix`] with the body's own height.
    pub fn matrix(&self, p: &Params) -> Result<[f64; 16]> {
        filled(|m: &mut [f64; 16]| unsafe {
            ffi::coin_body_matrix(self, p, m.as_mut_ptr())
        })
    }
}
