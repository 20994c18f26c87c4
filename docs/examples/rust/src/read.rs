// SPDX-License-Identifier: MIT
//! States, and what can be read off one.
use crate::status::{checked, filled, number};
use crate::{ffi, Force, Method, Params, Result, State, Status};

impl State {
    /// Whether it can be computed with.
    pub fn state_check(&self, p: &Params) -> Result<()> {
        checked(unsafe { ffi::coin_state_check(self, p) })?;
        Ok(())
    }

    /// The state of a coin that an engine holds as a rotation `q` (w, x, y, z,
    /// body to table) and an angular velocity in the table's frame.
    pub fn from_motion(
        p: &Params,
        q: [f64; 4],
        omega: [f64; 3],
        x: f64,
        z: f64,
    ) -> Result<State> {
        filled(|s| unsafe {
            ffi::coin_state_from_motion(s, p, q.as_ptr(), omega.as_ptr(), x, z)
        })
    }

    /// What a renderer loads: 16 numbers, by columns.
    pub fn matrix(&self, p: &Params) -> Result<[f64; 16]> {
        filled(|m: &mut [f64; 16]| unsafe {
            ffi::coin_matrix(self, p, m.as_mut_ptr())
        })
    }

    /// The energy.
    pub fn energy(&self, p: &Params) -> Result<f64> {
        let energy = unsafe { ffi::coin_energy(self, p) };
        number(energy, || self.velocity(p))
    }

    /// How fast the coin turns and falls now, W.
    pub fn fastest_rate(&self, p: &Params) -> Result<f64> {
        let rate = unsafe { ffi::coin_fastest_rate(self, p) };
        number(rate, || self.velocity(p))
    }

    /// K_Y and K_Z.
    pub fn integrals(&self, p: &Params) -> Result<[f64; 2]> {
        filled(|k: &mut [f64; 2]| unsafe {
            ffi::coin_integrals(self, p, k.as_mut_ptr())
        })
    }

    /// The force of the table.
    pub fn reaction(&self, p: &Params) -> Result<Force> {
        filled(|force| unsafe { ffi::coin_reaction(self, p, force) })
    }

    /// The rates of change, in the members of that name.
    pub fn rates(&self, p: &Params) -> Result<State> {
        filled(|rates| unsafe { ffi::coin_rates(self, p, rates) })
    }

    /// x, y, z of the centre of mass.
    pub fn center(&self, p: &Params) -> Result<[f64; 3]> {
        filled(|r: &mut [f64; 3]| unsafe {
            ffi::coin_center(self, p, r.as_mut_ptr())
        })
    }

    /// The velocity of the centre of mass.
    pub fn velocity(&self, p: &Params) -> Result<[f64; 3]> {
        filled(|v: &mut [f64; 3]| unsafe {
            ffi::coin_velocity(self, p, v.as_mut_ptr())
        })
    }

    /// The point of contact, and its velocity along the table.
    pub fn contact(&self, p: &Params) -> Result<([f64; 3], [f64; 3])> {
        filled(|out: &mut ([f64; 3], [f64; 3])| unsafe {
            ffi::coin_contact(self, p, out.0.as_mut_ptr(), out.1.as_mut_ptr())
        })
    }

    /// The angular velocity in the table's frame.
    pub fn angular_velocity(&self) -> Result<[f64; 3]> {
        filled(|omega: &mut [f64; 3]| unsafe {
            ffi::coin_angular_velocity(self, omega.as_mut_ptr())
        })
    }

    /// The coin's frame: e_X, e_Y, e_Z.
    pub fn axes(&self) -> Result<[f64; 9]> {
        filled(|axes: &mut [f64; 9]| unsafe {
            ffi::coin_axes(self, axes.as_mut_ptr())
        })
    }

    /// The rotation w, x, y, z of the body.
    pub fn quaternion(&self) -> Result<[f64; 4]> {
        filled(|q: &mut [f64; 4]| unsafe {
            ffi::coin_quaternion(self, q.as_mut_ptr())
        })
    }

    /// Whether the rolling model and a step hold.
    pub fn check(
        &self,
        p: &Params,
        method: Method,
        dt: f64,
        mu: f64,
    ) -> Result<Status> {
        checked(unsafe { ffi::coin_check(self, p, method as i32, dt, mu) })
    }
}
