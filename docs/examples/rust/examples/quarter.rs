// SPDX-License-Identifier: MIT
//! A US quarter rolls for a second: the same as quarter.c.
//!
//!     cargo run --example quarter
use rollcoin::{Method, Params, Result, State};

fn main() -> Result<()> {
    let p = Params::disc(0.00567, 0.01213, 9.80665)?;
    let mut s = State {
        theta: 0.3, // rad
        wY: 5.0,    // rad/s
        wZ: 40.0,
        ..State::default()
    };

    for tenth in 1..=10 {
        s.run(&p, Method::Rk8, 1e-2, 10)?;
        let t = f64::from(tenth) / 10.0;
        println!(
            "{:.1} s  lean {:.9}  centre ({:.9}, {:.9}) m",
            t, s.theta, s.x, s.z
        );
    }
    println!(
        "energy {:.9} J, F/N {:.9}",
        s.energy(&p)?,
        s.reaction(&p)?.ratio
    );
    Ok(())
}
