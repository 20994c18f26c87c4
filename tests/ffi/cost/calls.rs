// SPDX-License-Identifier: MIT
//! As many calls of one step as the argument says.
use rollcoin::{Method, Params, Result, State};

fn main() -> Result<()> {
    let n: u64 = std::env::args().nth(1).unwrap().parse().unwrap();
    let p = Params::disc(0.00567, 0.01213, 9.80665)?;
    let mut s = State { theta: 0.3, wY: 5.0, wZ: 40.0, ..State::default() };
    for _ in 0..n {
        s.run(&p, Method::Rk4, 1e-3, 1)?;
    }
    Ok(())
}
