// SPDX-License-Identifier: MIT
// rollcoin.cs: every member where C has it, errors thrown, no array shorter than
// the library fills it.  header.py's layout is the input.
using System;
using System.Globalization;
using System.Runtime.InteropServices;
using Rollcoin;

static class Test
{
    static void Check(bool holds, string claim)
    {
        if (!holds)
            throw new Exception("not so: " + claim);
    }

    static T Throws<T>(Action call) where T : Exception
    {
        try
        {
            call();
        }
        catch (T error)
        {
            return error;
        }
        throw new Exception("no " + typeof(T).Name);
    }

    static Params Quarter()
    {
        Coin.ParamsDisc(out Params p, 0.00567, 0.01213, 9.80665);
        return p;
    }

    // coin_params.mass offset 0 size 8: Params.mass, or the first of an array;
    // what the library alone reads need not be there.
    static void MembersAreWhereCHasThem()
    {
        int found = 0;
        for (string line; (line = Console.ReadLine()) != null; )
        {
            var words = line.Split(' ');
            var names = words[0].Substring("coin_".Length).Split('.');
            var type = typeof(Coin).Assembly.GetType("Rollcoin." +
                CultureInfo.InvariantCulture.TextInfo.ToTitleCase(names[0]));
            if (names.Length == 1)
                Check(Marshal.SizeOf(type) == int.Parse(words[2]), line);
            else if (names[1] != "reserved" && !names[1].StartsWith("private_"))
            {
                var name = type.GetField(names[1]) != null ? names[1] : names[1] + "_0";
                Check((int)Marshal.OffsetOf(type, name) == int.Parse(words[2]), line);
                ++found;
            }
        }
        Check(found >= 48, "there are members");
    }

    static void StructsAreWhatTheLibraryReads()
    {
        var p = Quarter();
        var s = new State { theta = 0.3, wY = 5, wZ = 40 };
        Coin.Reaction(ref s, ref p, out Force f);
        Check(f.R_1 == f.normal && f.ratio == f.friction / f.normal, "a force");
        Coin.OrbitInit(out Orbit orbit, ref s, ref p);
        Coin.OrbitAt(ref orbit, orbit.period, out State later);
        Check(Math.Abs(later.theta - s.theta) < 1e-12, "an orbit is a period's");
        Check(orbit.conditioning >= 1 && orbit.conditioning < 100, "conditioning");
        Coin.Advance(ref s, ref p, orbit.period, 1e-12, out double reached);
        Check(reached == orbit.period, "the time reached");
        Check(Math.Abs(later.x - s.x) < 1e-9, "an orbit is as its steps");

        var table = new Table { mu_static = 0.4, mu_kinetic = 0.3, pull_0 = 5 };
        table.losses.flat = 1e-3;
        var body = new Body { vz = 2, vy = 1, y = 1 };
        Coin.TableCheck(ref table, ref p);
        Check(Coin.Move(ref body, ref p, ref table, 0.1, 1e-9, 0, out reached) ==
              Bits.LIFTS, "it flies");
        Check(Math.Abs(body.s.z - 0.2) + Math.Abs(body.vz - 2) < 1e-14, "a flight");
        table.losses.flat = 7;
        Check(Throws<CoinException>(() => Coin.TableCheck(ref table, ref p)).Status ==
              Status.EPARAMS, "the last loss is read");
    }

    static void ArraysAreFilledAndNotBeyond()
    {
        var p = Quarter();
        var s = new State { theta = 0.3, wY = 5, wZ = 40 };
        var q = new double[4];
        Coin.Quaternion(ref s, q);
        Check(Math.Abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1) < 1e-14,
              "a quaternion has length 1");
        Check(Throws<ArgumentException>(() => Coin.Quaternion(ref s, new double[3]))
              .Message.Contains("q has 3 elements, where 4 belong"), "its message");
        var coins = new[] { s, s };
        var status = new int[2];
        coins[1].wZ = 41;
        Coin.BatchRun(coins, ref p, Method.RK8, 1e-2, 100, status);
        Coin.Run(ref s, ref p, Method.RK8, 1e-2, 100, out ulong done);
        Check(coins[0].Equals(s) && !coins[1].Equals(s) && done == 100, "a batch");
        Throws<ArgumentException>(
            () => Coin.BatchRun(coins, ref p, Method.RK8, 1e-2, 100, new int[1]));
    }

    static void NullIsRefusedByName()
    {
        var p = Quarter();
        var s = new State();
        var three = new double[3];
        foreach (var call in new Action[] {
            () => Coin.Quaternion(ref s, null),
            () => Coin.StateFromMotion(out State made, ref p, null, three, 0, 0),
            () => Coin.BatchRun(null, ref p, Method.RK8, 1e-2, 1, null),
            () => Coin.Sample(ref s, ref p, Method.RK8, 1e-2, 1, null, out UIntPtr n) })
            Check(Throws<ArgumentNullException>(call).ParamName != null, "a name");
        Coin.BatchRun(new[] { s }, ref p, Method.RK8, 1e-2, 1, null);
        Coin.BatchRun(new State[0], ref p, Method.RK8, 1e-2, 1, null);
        Coin.Sample(ref s, ref p, Method.RK8, 1e-2, 1, new State[0], out UIntPtr none);
        Check(none == UIntPtr.Zero, "no coins");
    }

    static void ErrorsAreThrown()
    {
        var error = Throws<CoinException>(() => Coin.ParamsDisc(out Params p, -1, 1, 1));
        Check(error.Status == Status.EPARAMS &&
              error.Message == Coin.StatusString((int)Status.EPARAMS), "its words");
    }

    static void Main()
    {
        Check(Coin.Selftest() == 0, "the self-test");
        MembersAreWhereCHasThem();
        StructsAreWhatTheLibraryReads();
        ArraysAreFilledAndNotBeyond();
        NullIsRefusedByName();
        ErrorsAreThrown();
    }
}
