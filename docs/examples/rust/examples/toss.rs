// SPDX-License-Identifier: MIT
//! Ten thousand quarters are thrown, which takes some 20 s: how many show
//! heads.
//!
//!     cargo run --release --example toss [COINS]
use rollcoin::{Body, Face, Losses, Params, State, Status, Table};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let count = std::env::args().nth(1).map_or(Ok(10_000), |n| n.parse())?;
    let p = Params::disc(0.00567, 0.01213, 9.80665)?;
    let table = Table {
        mu_static: 0.4,
        mu_kinetic: 0.3,
        restitution: 0.5,
        losses: Losses {
            dry: 5e-3 * p.mass * p.gravity * p.radius,
            ..Losses::default()
        },
        ..Table::default()
    };

    let mut heads = 0;
    for i in 0..count {
        let mut coin = Body {
            s: State {
                theta: 1.0,                       // tails up
                wX: 200.0 + f64::from(i) / 100.0, // rad/s
                wZ: 5.0,
                ..State::default()
            },
            y: 0.5,  // m
            vy: 2.0, // m/s
            ..Body::default()
        };
        coin.move_by(&p, &table, f64::INFINITY, 1e-6, Status::OK)?;
        heads += i32::from(coin.face(&p)? == Face::Heads);
    }
    println!("{heads} of {count} show heads");
    Ok(())
}
