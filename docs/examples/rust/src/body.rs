// SPDX-License-Identifier: MIT
//! A real coin: it flies, bounces, slips, rolls and comes to rest.
use crate::status::{checked, filled, moved_to, number};
use crate::{ffi, Body, Force, Params, Result, State, Status, Stopped, Table};

/// How a coin lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// The +Z side is up: theta < 0.
    Heads = ffi::COIN_HEADS as isize,
    /// The other side is up.
    Tails = ffi::COIN_TAILS as isize,
    /// It is upright, or would fall back on its edge.
    Edge = ffi::COIN_EDGE as isize,
}

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

    /// Moves by a time, or until it rests, or to the first of the moments that
    /// `stop` names: its mode, [`Status::SLIPS`], [`Status::LIFTS`],
    /// [`Status::RESTS`] or, if it rolls, [`Status::OK`], with the bits of the
    /// moment; and the time moved by.  [`Status::MORE`] if an infinite time
    /// needs more than 100 calls of the library.  `coin_move()`, as `move` is a
    /// word of Rust.
    pub fn move_by(
        &mut self,
        p: &Params,
        table: &Table,
        t: f64,
        tol: f64,
        stop: Status,
    ) -> std::result::Result<(Status, f64), Stopped<f64>> {
        let stop = stop.bits() as i32;
        moved_to(t, |left, moved| unsafe {
            ffi::coin_move(self, p, table, left, tol, stop, moved)
        })
    }

    /// Kinetic and potential energy.
    pub fn energy(&self, p: &Params) -> Result<f64> {
        let energy = unsafe { ffi::coin_body_energy(self, p) };
        number(energy, || self.contact(p))
    }

    /// The force of the table, of rolling or of the slip.
    pub fn reaction(&self, p: &Params, table: &Table) -> Result<Force> {
        filled(|force| unsafe {
            ffi::coin_body_reaction(self, p, table, force)
        })
    }

    /// The velocity of the lowest point: along x and z the slip; along y, where
    /// it touches, less than 0 by the speed of the impact.
    pub fn contact(&self, p: &Params) -> Result<[f64; 3]> {
        filled(|v: &mut [f64; 3]| unsafe {
            ffi::coin_body_contact(self, p, v.as_mut_ptr())
        })
    }

    /// A blow: gives it the impulse `impulse` at the place `r` from its centre,
    /// in the air or on the table.
    pub fn strike(
        &mut self,
        p: &Params,
        impulse: [f64; 3],
        r: [f64; 3],
    ) -> Result<()> {
        checked(unsafe {
            ffi::coin_body_strike(self, p, impulse.as_ptr(), r.as_ptr())
        })?;
        Ok(())
    }

    /// Which side is up.  After [`Status::DECIDED`] it is how the coin ends.
    pub fn face(&self, p: &Params) -> Result<Face> {
        let face = checked(unsafe { ffi::coin_body_face(self, p) })?;
        Ok(match face.bits() {
            ffi::COIN_HEADS => Face::Heads,
            ffi::COIN_TAILS => Face::Tails,
            _ => Face::Edge,
        })
    }

    /// [`State::matrix`] with the body's own height.
    pub fn matrix(&self, p: &Params) -> Result<[f64; 16]> {
        filled(|m: &mut [f64; 16]| unsafe {
            ffi::coin_body_matrix(self, p, m.as_mut_ptr())
        })
    }
}
