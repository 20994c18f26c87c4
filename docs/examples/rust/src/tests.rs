// SPDX-License-Identifier: MIT
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
    assert_eq!(Params::disc(-1.0, 1.0, 1.0), Err(Error::Params));
    assert_eq!(s.step(&p, 1.0), Err(Error::Step));
    assert_eq!(s.step(&p, f64::NAN), Err(Error::Step));
    s.theta = 2.0;
    assert_eq!(s.energy(&p), Err(Error::State));
    assert_eq!(s.fastest_rate(&p), Err(Error::State));
    assert_eq!(s.energy(&Params::default()), Err(Error::Params));
    assert_eq!(s.center(&p), Err(Error::State));
    assert_eq!(s.state_check(&p), Err(Error::State));
    s.theta = before.theta;
    assert_eq!(s, before);
    assert_eq!(Params::default().critical_roll(), Err(Error::Params));
    assert_eq!(Error::Flat.to_string(), "the coin falls flat");
    assert_eq!(Error::Build.status(), -7);
}

#[test]
fn a_positive_status_is_a_warning() {
    let (p, mut s) = quarter();
    assert!(!s
        .run(&p, Method::Rk8, 1e-2, 10)
        .unwrap()
        .contains(Status::COARSE));
    assert!(s
        .run(&p, Method::Rk4, 1e-2, 1)
        .unwrap()
        .contains(Status::COARSE));
    let bits = s.check(&p, Method::Rk4, 1e-3, 0.01).unwrap();
    assert!(
        bits.contains(Status::SLIPS)
            && !bits.contains(Status::LIFTS)
            && !bits.contains(Status::NEARLY_FLAT)
    );
}

#[test]
fn an_error_on_the_way_keeps_the_progress() {
    let p = Params::ring(1.0, 1.0, 0.5, 1.0).unwrap();
    let start = State {
        theta: 0.3,
        ..State::default()
    };
    let (mut s, mut again) = (start, start);
    let stopped = s.run(&p, Method::Rk8, 0.05, 1000).unwrap_err();
    assert_eq!(stopped.error, Error::Step);
    again.run(&p, Method::Rk8, 0.05, stopped.done).unwrap();
    assert_eq!(s, again);
    let mut path = [State::default(); 1000];
    let cut = start
        .sample(&p, Method::Rk8, 0.05, 1, &mut path)
        .unwrap_err();
    assert_eq!(cut.done as u64, stopped.done + 1);
    assert_eq!(path[cut.done - 1], s);
    let fall = s.advance(&p, 100.0, 1e-9).unwrap_err();
    assert_eq!(fall.error, Error::Flat);
    assert!(fall.done > 0.0 && s.theta > 1.57);
    assert_eq!(Error::from(fall), Error::Flat);
    assert!(fall
        .to_string()
        .starts_with("the coin falls flat, after 0."));
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
    assert_eq!(Method::Rk8.name(), "rk8");
}

#[test]
fn a_batch_has_the_bits_of_runs_and_a_status_for_each() {
    let (p, s) = quarter();
    let mut coins = [s; 5];
    coins[2].theta = 2.0;
    let said = batch_run(&mut coins, &p, Method::Rk8, 1e-3, 9).unwrap();
    for (k, one) in said.iter().enumerate() {
        let bad = k == 2;
        let want = if bad {
            Err(Error::State)
        } else {
            Ok(Status::OK)
        };
        assert_eq!(*one, want);
    }
    let mut alone = s;
    alone.run(&p, Method::Rk8, 1e-3, 9).unwrap();
    assert_eq!(coins[4], alone);
    let none = Params::default();
    let refused = batch_run(&mut coins, &none, Method::Rk8, 1e-3, 1);
    assert_eq!(refused, Err(Error::Params));
    assert_eq!(coins[4], alone);
    let said = batch_run(&mut coins, &p, Method::Rk4, 1e-2, 1).unwrap();
    assert_eq!(said[0], Ok(Status::COARSE));
    assert_eq!(batch_run(&mut [], &p, Method::Rk4, 1e-2, 1), Ok(vec![]));
}

#[test]
fn statuses_say_what_they_are() {
    let (p, mut s) = quarter();
    assert_eq!(s.step(&p, 1e-3).unwrap(), Status::OK);
    assert_eq!(format!("{:?}", s.step(&p, 1e-3)), "Ok(OK)");
    let bits = s.check(&p, Method::Rk4, 1.0, 0.01).unwrap();
    assert_eq!(format!("{bits:?}"), "SLIPS | COARSE");
    assert_eq!(bits.bits(), 5);
    assert!(bits.contains(Status::COARSE) && !bits.contains(Status::RESTS));
    let both = Status::SLIPS | Status::LIFTS;
    assert_eq!(bits - both, Status::COARSE);
    assert_eq!(both - bits, Status::LIFTS);
    assert_eq!(bits - bits, Status::OK);
    for status in [-1, -2, -3, -4, -5, -6, -7, -9] {
        assert_eq!(status::checked(status).unwrap_err().status(), status);
    }
    let long = s.step(&p, 9.0).unwrap_err();
    assert!(long
        .to_string()
        .ends_with("too long for this motion: shorten it"));
    assert_eq!(format!("{long:?}"), "Step");
}

#[test]
fn what_is_read_off_a_state_is_consistent() {
    let (p, s) = quarter();
    let q = s.quaternion().unwrap();
    let omega = s.angular_velocity().unwrap();
    let back = State::from_motion(&p, q, omega, s.x, s.z).unwrap();
    assert!((back.theta - s.theta).abs() < 1e-14);
    assert!((back.wZ - s.wZ).abs() < 1e-12);
    assert!((q.iter().map(|c| c * c).sum::<f64>() - 1.0).abs() < 1e-14);
    assert_eq!(s.rates(&p).unwrap().theta, s.wX);
    assert_eq!(s.contact(&p).unwrap().0[1], 0.0);
    let axes = s.axes().unwrap();
    assert!((axes[7] + s.theta.sin()).abs() < 1e-14);
    assert_eq!(s.velocity(&p).unwrap().len(), 3);
    assert_eq!(s.integrals(&p).unwrap().len(), 2);
    p.check().unwrap();
}

#[test]
fn games_get_a_matrix_and_the_first_slip() {
    let (p, mut s) = quarter();
    let m = s.matrix(&p).unwrap();
    assert_eq!(m[12..15], s.center(&p).unwrap());
    let most = s.reaction(&p).unwrap().ratio;
    s.advance(&p, 0.05, 1e-9).unwrap(); // half a period of the lean
    let mu = (most + s.reaction(&p).unwrap().ratio) / 2.0;
    let table = Table {
        mu_static: mu,
        ..Table::default()
    };
    let mut b = Body::from_state(&s, &p).unwrap();
    let (status, reached) =
        b.move_by(&p, &table, 1.0, 1e-9, Status::SLIPS).unwrap();
    assert!(status.contains(Status::SLIPS) && reached < 0.06);
    assert!((b.s.reaction(&p).unwrap().ratio - mu).abs() < 1e-6);
    let refused = b
        .move_by(&p, &table, 1.0, 1e-9, Status::COARSE)
        .unwrap_err();
    assert_eq!(refused.error, Error::Argument);
}

#[test]
fn steady_motions_are_steady() {
    let (p, _) = quarter();
    let circle = State::steady_circle(&p, 0.4, 30.0, 1).unwrap();
    assert!(circle.stability(&p).unwrap() < 0.0);
    let (center, contact) = circle.steady_radii(&p).unwrap();
    assert!(center > 0.0 && contact > center);
    let later = circle.steady_at(&p, 0.1).unwrap();
    assert!((later.theta - 0.4).abs() < 1e-12);
    let turn = State::steady_turn(&p, 0.4, 0.04).unwrap();
    let ride = State::steady_ride(&p, turn.wZ * p.radius, 0.04).unwrap();
    assert!((ride.theta - 0.4).abs() < 1e-12);
    assert_eq!(State::steady_roll(&p, 9.0).unwrap().wZ, 9.0);
    assert_eq!(State::steady_upright_spin(&p, 9.0).unwrap().wY, 9.0);
    let none = State::steady_circle(&p, 0.0, 30.0, 1);
    assert_eq!(none, Err(Error::Domain));
    let ratio = p.critical_spin().unwrap() / p.critical_roll().unwrap();
    assert!((ratio * ratio - 2.4).abs() < 1e-12);
}

#[test]
fn an_orbit_gives_any_time() {
    let (p, mut s) = quarter();
    let orbit = Orbit::new(&s, &p).unwrap();
    assert!(orbit.period > 0.0);
    let at = orbit.at(0.5).unwrap();
    s.advance(&p, 0.5, 1e-13).unwrap();
    assert!((at.theta - s.theta).abs() < 1e-10);
    assert_eq!(orbit.at(f64::NAN), Err(Error::Step));
    assert_eq!(Orbit::default().at(0.0), Err(Error::Argument));
}

#[test]
fn losses_bring_a_coin_to_rest() {
    let (p, _) = quarter();
    let mut s = State::steady_spin(&p, 1.0).unwrap();
    let law = Losses {
        viscous: 1e-9,
        ..Losses::default()
    };
    let l = law.fit(&s, &p, 8.0).unwrap();
    l.check(&p).unwrap();
    assert!((s.time_to_rest(&p, &l, 1e-6).unwrap() - 8.0).abs() < 0.08);
    assert_eq!(
        s.time_to_rest(&p, &Losses::default(), 1e-6),
        Ok(f64::INFINITY)
    );
    assert!(s.losses_power(&p, &l).unwrap() > 0.0);
    assert_ne!(s.losses_rates(&p, &l), s.rates(&p));
    assert_ne!(s.losses_reaction(&p, &l), s.reaction(&p));
    let (status, reached) = s.settle(&p, &l, 60.0, 1e-6).unwrap();
    assert!(status.contains(Status::RESTS) && (reached - 8.0).abs() < 0.1);
    let negative = Losses {
        dry: -1.0,
        ..Losses::default()
    };
    assert_eq!(s.settle(&p, &l, -1.0, 1e-6).unwrap_err().error, Error::Step);
    s = State::default();
    s.theta = 2.0;
    assert_eq!(s.time_to_rest(&p, &l, 1e-6), Err(Error::State));
    assert_eq!(s.time_to_rest(&p, &negative, 1e-6), Err(Error::Params));
    assert_eq!(s.time_to_rest(&p, &negative, 1.0), Err(Error::Argument));
    assert_eq!(s.losses_power(&p, &negative), Err(Error::Params));
}

#[test]
fn a_body_slips_and_rolls_again() {
    let (p, s) = quarter();
    let table = Table {
        mu_static: 0.5,
        mu_kinetic: 0.5,
        ..Table::default()
    };
    table.check(&p).unwrap();
    let mut b = Body::from_state(&s, &p).unwrap();
    assert!(b.contact(&p).unwrap()[0].abs() < 1e-12);
    assert_eq!(b.matrix(&p).unwrap()[13], b.y);
    let energy = b.energy(&p).unwrap();
    assert!((energy - s.energy(&p).unwrap()).abs() < 1e-12);
    b.vx += 0.1;
    assert!(b.contact(&p).unwrap()[0] > 0.09);
    assert!((b.reaction(&p, &table).unwrap().ratio - 0.5).abs() < 1e-9);
    let (status, _) = b.move_by(&p, &table, 1e-3, 1e-9, Status::OK).unwrap();
    assert!(status.contains(Status::SLIPS));
    let (status, reached) =
        b.move_by(&p, &table, 1.0, 1e-9, Status::OK).unwrap();
    assert!(!status.contains(Status::SLIPS) && reached == 1.0);
    let high = [0.0, 1.0, 0.0];
    let mut air =
        Body::from_motion(&p, [1.0, 0.0, 0.0, 0.0], high, high, high).unwrap();
    let (status, reached) =
        air.move_by(&p, &table, 0.1, 1e-9, Status::OK).unwrap();
    assert!(status.contains(Status::LIFTS) && reached == 0.1);
    let (status, _) = air.move_by(&p, &table, 1.0, 1e-9, Status::OK).unwrap();
    assert!(!status.contains(Status::LIFTS));
    b.s.theta = 2.0;
    assert_eq!(b.energy(&p), Err(Error::State));
}

/// A chip as thick as half its width, and a table.
fn chip() -> (Params, Table) {
    let p = Params::cylinder(0.005, 0.01, 0.01, 9.80665).unwrap();
    let resists = 1e-2 * p.mass * p.gravity * p.radius;
    let table = Table {
        mu_static: 0.4,
        mu_kinetic: 0.3,
        restitution: 0.2,
        losses: Losses {
            dry: resists,
            spin: resists,
            ..Losses::default()
        },
        ..Table::default()
    };
    (p, table)
}

fn toss(theta: f64, rate: f64) -> Body {
    Body {
        s: State {
            theta,
            wX: rate,
            ..State::default()
        },
        y: 0.03,
        vy: 0.5,
        ..Body::default()
    }
}

const EVER: f64 = f64::INFINITY;

#[test]
fn a_cylinder_is_tossed_to_heads_to_tails_and_to_its_edge() {
    let (p, table) = chip();
    assert!((p.inertia_X - 5e-7 / 3.0).abs() < 1e-20);
    for (face, y, mut b) in [
        (Face::Heads, 0.005, toss(-1.0, 0.0)),
        (Face::Tails, 0.005, toss(1.0, 0.0)),
        (Face::Edge, 0.01, toss(-1.0, 10.0)),
    ] {
        let (said, _) =
            b.move_by(&p, &table, EVER, 1e-6, Status::DECIDED).unwrap();
        assert!(format!("{said:?}").ends_with("DECIDED"));
        assert!(!said.contains(Status::RESTS));
        assert_eq!(b.face(&p), Ok(face));
        let (said, _) = b.move_by(&p, &table, EVER, 1e-6, Status::OK).unwrap();
        assert_eq!(said, Status::RESTS);
        assert_eq!(b.face(&p), Ok(face));
        assert!((b.y - y).abs() < 1e-12);
    }
    assert_eq!(Params::cylinder(1.0, 1.0, 5.0, 1.0), Err(Error::Params));
    let s = State::default();
    assert_eq!(s.energy(&p), Err(Error::Params));
    assert_eq!(s.fastest_rate(&p), Err(Error::Params));
    assert_eq!(p.critical_roll(), Err(Error::Params));
    assert_eq!(p.critical_spin(), Err(Error::Params));
    assert_eq!(toss(2.0, 0.0).face(&p), Err(Error::State));
}

#[test]
fn a_slope_holds_a_coin_or_lets_it_slide() {
    let (p, mut table) = chip();
    let mut b = toss(1.0, 0.0);
    b.move_by(&p, &table, EVER, 1e-6, Status::OK).unwrap();
    table.pull[0] = 0.3 * p.gravity;
    let (said, _) = b.move_by(&p, &table, 0.1, 1e-9, Status::OK).unwrap();
    assert_eq!(said, Status::RESTS);
    table.pull[0] = 0.5 * p.gravity;
    let (said, _) = b.move_by(&p, &table, 0.1, 1e-9, Status::OK).unwrap();
    assert_eq!(said, Status::SLIPS);
    assert!((b.vx - (0.5 - 0.3) * p.gravity * 0.1).abs() < 1e-9);
    let refused = b.move_by(&p, &table, 0.1, 1e-9, Status::DECIDED);
    assert_eq!(refused.unwrap_err().error, Error::Argument);
}

#[test]
fn a_blow_turns_and_moves_a_body() {
    let (p, _) = chip();
    let mut b = Body::from_state(&State::default(), &p).unwrap();
    b.strike(&p, [0.0, 0.0, 1e-3], [0.0, p.radius, 0.0])
        .unwrap();
    assert!((b.vz - 1e-3 / p.mass).abs() < 1e-12);
    assert!((b.s.wX - 1e-3 * p.radius / p.inertia_X).abs() < 1e-9);
    let before = b;
    let refused = b.strike(&p, [1e30, 0.0, 0.0], [0.0; 3]);
    assert_eq!(refused, Err(Error::State));
    assert_eq!(b, before);
}

/// Where one call of the library does not suffice, for a time and for ever.
#[test]
fn a_call_goes_on_to_its_time() {
    let (p, start) = quarter();
    let table = Table {
        mu_static: f64::INFINITY,
        ..Table::default()
    };
    let mut b = Body::from_state(&start, &p).unwrap();
    let mut coin = b;
    let mut part = 0.0;
    let one = unsafe {
        ffi::coin_move(&mut coin, &p, &table, 1e3, 1e-2, 0, &mut part)
    };
    assert_eq!(one as u32, ffi::COIN_MORE);
    let (status, reached) =
        b.move_by(&p, &table, 1e3, 1e-2, Status::OK).unwrap();
    assert_eq!(status, Status::OK);
    assert!(part < 900.0 && (reached - 1e3).abs() < 1e-9);
    let (status, reached) = b
        .move_by(&p, &table, f64::INFINITY, 1e-2, Status::OK)
        .unwrap();
    assert_eq!(status, Status::MORE);
    assert!(90.0 * part < reached && reached < 110.0 * part);
    b.s.psi = 2f64.powi(31) - 2e4;
    let end = b.move_by(&p, &table, 1e3, 1e-2, Status::OK).unwrap_err();
    assert_eq!(end.error, Error::Range);
    assert!(400.0 < end.done && end.done < 600.0);

    let mut s = start;
    assert!((s.advance(&p, 4e4, 1e-2).unwrap() - 4e4).abs() < 1e-9);
    s = start;
    unsafe { ffi::coin_advance(&mut s, &p, 4e4, 1e-2, &mut part) };
    assert!(part < 4e4);
    let l = Losses {
        dry: 1e-15,
        ..Losses::default()
    };
    s = start;
    let (status, reached) = s.settle(&p, &l, 25e3, 1e-2).unwrap();
    assert_eq!(status, Status::OK);
    assert!((reached - 25e3).abs() < 1e-9);
    s = start;
    unsafe { ffi::coin_settle(&mut s, &p, &l, 25e3, 1e-2, &mut part) };
    assert!(part < 25e3);
}

#[test]
fn the_library_is_of_this_crates_version_and_computes_its_bits() {
    assert_eq!(version_string(), env!("CARGO_PKG_VERSION"));
    let number = version();
    let text =
        format!("{}.{}.{}", number >> 16, number >> 8 & 255, number & 255);
    assert_eq!(text, version_string());
    selftest().unwrap();
}
