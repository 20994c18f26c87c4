// SPDX-License-Identifier: MIT
//! Bodies.
use crate::status::{checked, filled, number};
use crate::{ffi, Error, Params, Result};

impl Params {
    /// A uniform thin disc.
    pub fn disc(mass: f64, radius: f64, gravity: f64) -> Result<Params> {
        filled(|p| unsafe { ffi::coin_params_disc(p, mass, radius, gravity) })
    }

    /// A thin ring; `inner_radius` from 0, a disc, to `radius`, a hoop.
    pub fn ring(
        mass: f64,
        radius: f64,
        inner_radius: f64,
        gravity: f64,
    ) -> Result<Params> {
        filled(|p| unsafe {
            ffi::coin_params_ring(p, mass, radius, inner_radius, gravity)
        })
    }

    /// Any thin axisymmetric body, of its moments of inertia about a diameter
    /// and about the axis.
    pub fn body(
        mass: f64,
        radius: f64,
        gravity: f64,
        about_diameter: f64,
        about_axis: f64,
    ) -> Result<Params> {
        filled(|p| unsafe {
            ffi::coin_params_body(
                p,
                mass,
                radius,
                gravity,
                about_diameter,
                about_axis,
            )
        })
    }

    /// A uniform cylinder, for a [`Body`](crate::Body); `thickness` is 0, or
    /// 1e-4 to 4 radii.  Another body gets its rims by the member.
    pub fn cylinder(
        mass: f64,
        radius: f64,
        thickness: f64,
        gravity: f64,
    ) -> Result<Params> {
        filled(|p| unsafe {
            ffi::coin_params_cylinder(p, mass, radius, thickness, gravity)
        })
    }

    /// Whether they can be computed with.
    pub fn check(&self) -> Result<()> {
        checked(unsafe { ffi::coin_params_check(self) })?;
        Ok(())
    }

    /// The rate |wZ| above which straight rolling is stable.
    pub fn critical_roll(&self) -> Result<f64> {
        let rate = unsafe { ffi::coin_critical_roll(self) };
        number(rate, || Err::<(), _>(Error::Params))
    }

    /// The rate |wY| above which upright spinning is stable.
    pub fn critical_spin(&self) -> Result<f64> {
        let rate = unsafe { ffi::coin_critical_spin(self) };
        number(rate, || Err::<(), _>(Error::Params))
    }
}
