// SPDX-License-Identifier: MIT
// librollcoin in C#, for .NET, Mono and Unity: by `make bindings-update`.
//
//     using Rollcoin;
//     Coin.ParamsDisc(out Params p, 0.00567, 0.01213, 9.80665);
//
// coin.h is the reference: coin_body_face() is Coin.BodyFace().  A negative
// status is thrown, as a CoinException.  What C takes by a pointer is a ref, an
// out or an array, whose length need not be told.
using System;
using System.Runtime.InteropServices;

namespace Rollcoin
{
    public class CoinException : Exception
    {
        public readonly Status Status;
        public CoinException(int status) : base(Coin.StatusString(status))
        {
            Status = (Status)status;
        }
    }

    public enum Status
    {
        /// done
        OK = 0,
        /// parameters, losses or a table out of range
        EPARAMS = -1,
        /// a state or a body out of range
        ESTATE = -2,
        /// dt or t out of range, or a step beyond its method
        ESTEP = -3,
        /// null pointer, unknown method, branch or bit, tol
        EARG = -4,
        /// no such steady motion, period or losses; or not a steady motion
        EDOMAIN = -5,
        /// the coin falls flat within the time asked
        EFLAT = -6,
        /// not the pinned bits: coin_selftest()
        EBUILD = -7,
        /// phi, psi, a place or a rate would leave its range, or a step is refused within 16 rad or radii of its end
        ERANGE = -9,
    }

    [Flags]
    public enum Bits
    {
        /// F > mu N > 0: a real coin slips
        SLIPS = 1,
        /// N <= 0; of a body: it is off the table
        LIFTS = 2,
        /// |dt| coin_fastest_rate() is above 0.35 (RK4), 1 (RK8), 0.08, 0.16 (symplectic methods)
        COARSE = 4,
        /// cos(theta) < 0.01
        NEARLY_FLAT = 8,
        /// the coin lies flat, or stands, and stays
        RESTS = 16,
        /// a slip or a flight has ended, and it rolls
        ROLLS = 32,
        /// the coin comes down on the table
        TOUCHES = 64,
        /// the steps of one call did not suffice: it has moved by `reached`
        MORE = 128,
        /// which side ends up is decided
        DECIDED = 256,
    }

    public enum Face
    {
        /// the +Z side is up: theta < 0
        HEADS = 1,
        /// the other side is up
        TAILS = 2,
        /// upright, or it would fall back on its edge
        EDGE = 3,
    }

    public enum Method
    {
        /// classical Runge-Kutta, order 4
        RK4 = 0,
        /// Dormand-Prince, 12 stages, order 8
        RK8 = 1,
        /// kick-drift-kick with the exact drift, order 2
        SYMPLECTIC2 = 2,
        /// Chin 4A with the exact drift, order 4
        SYMPLECTIC4 = 3,
    }

    [StructLayout(LayoutKind.Sequential, Size = 64)]
    public struct Params
    {
        /// M [M]
        public double mass;
        /// a, of the rim that rolls [L]
        public double radius;
        /// g [L/T^2]
        public double gravity;
        /// I_X = I_Y, about a diameter [M L^2]
        public double inertia_X;
        /// I_Z, about the axis [M L^2]
        public double inertia_Z;
        /// between the two rims: 1e-4 to 4 radii; or 0, a thin coin, which most functions ask for [L]
        public double thickness;
    }

    [StructLayout(LayoutKind.Sequential, Size = 64)]
    public struct State
    {
        /// lean, -pi/2 < theta < pi/2 [rad]
        public double theta;
        /// heading, |phi| <= 2^31 [rad]
        public double phi;
        /// roll, |psi| <= 2^31 [rad]
        public double psi;
        /// of the centre [L]
        public double x;
        /// of the centre [L]
        public double z;
        /// omega_X = d(theta)/dt [1/T]
        public double wX;
        /// omega_Y [1/T]
        public double wY;
        /// omega_Z [1/T]
        public double wZ;
    }

    [StructLayout(LayoutKind.Sequential, Size = 48)]
    public struct Force
    {
        /// in the table frame x, y, z [M L/T^2]
        public double R_0, R_1, R_2;
        /// N = R_y [M L/T^2]
        public double normal;
        /// F = sqrt(R_x^2 + R_z^2) [M L/T^2]
        public double friction;
        /// F/N [1]; +infinity if N <= 0
        public double ratio;
    }

    [StructLayout(LayoutKind.Sequential, Size = 32768)]
    public struct Orbit
    {
        /// of theta; 0 if the motion is steady [T]
        public double period;
        /// what phi gains in it [rad]
        public double heading_per_period;
        /// what psi gains in it [rad]
        public double roll_per_period;
        /// the turning points of the lean [rad]
        public double theta_min;
        public double theta_max;
        /// x, z of the centre of the annulus that the path fills; NaN if it drifts [L]
        public double center_0, center_1;
        /// of the annulus; NaN if it drifts [L]
        public double radius_min;
        public double radius_max;
        /// x, z of the displacement per period, if heading_per_period is k 2 pi; else 0 [L]
        public double drift_0, drift_1;
        /// growth of rounding in a period, >= 1 [1]
        public double conditioning;
    }

    [StructLayout(LayoutKind.Sequential, Size = 96)]
    public struct Losses
    {
        /// a torque damping |d(psi)/dt| times the angular momentum; of a coin that rolls [1]
        public double damping;
        /// a torque against the rolling of the contact along the rim, independent of its rate [M L^2/T^2]
        public double dry;
        /// the same, proportional to that rate [M L^2/T]
        public double viscous;
        /// the same, to its power 3/2: the boundary layer of the air [M L^2/T^(1/2)]
        public double layer;
        /// the same, to the rate over cos(theta): the air in the gap below the coin [M L^2/T]
        public double gap;
        /// dry times cos(theta): the rolling moment of engines [M L^2/T^2]
        public double rolling;
        /// pivoting friction: a torque proportional to the turn about the vertical [M L^2/T]
        public double spin;
        /// the angular damping of engines: the torque -angular (I_X wX, I_X wY, I_Z wZ) [1/T]
        public double angular;
        /// the rate of roll below which dry and rolling fade; 0 stands for sqrt(g/a)/1024 [1/T]
        public double soft;
        /// a coin whose cos(theta) comes below this lies flat; 0 stands for 1e-6 [rad]
        public double flat;
    }

    [StructLayout(LayoutKind.Sequential, Size = 160)]
    public struct Table
    {
        /// of Coulomb's friction, before the contact slips; mu_kinetic to +infinity [1]
        public double mu_static;
        /// while it slips; 0 to the bound of Painleve, Eq. (86) [1]
        public double mu_kinetic;
        /// of an impact, 0 to 1 [1]
        public double restitution;
        /// acceleration along x and z, of a slope or a tray; of at most 100 gravity in size [L/T^2]
        public double pull_0, pull_1;
        readonly double reserved_0, reserved_1, reserved_2;
        /// damping must be 0
        public Losses losses;
    }

    [StructLayout(LayoutKind.Sequential, Size = 128)]
    public struct Body
    {
        /// where it is and how it turns
        public State s;
        /// height of the centre [L]
        public double y;
        /// velocity of the centre [L/T]
        public double vx;
        public double vy;
        public double vz;
    }

    public static class Coin
    {
        // What the system looks for: librollcoin.so, rollcoin.dll,
        // librollcoin.dylib.
        const string Library = "rollcoin";

        // The structs here must be those of the library.
        static Coin()
        {
            Agrees("coin_params", typeof(Params));
            Agrees("coin_state", typeof(State));
            Agrees("coin_force", typeof(Force));
            Agrees("coin_orbit", typeof(Orbit));
            Agrees("coin_losses", typeof(Losses));
            Agrees("coin_table", typeof(Table));
            Agrees("coin_body", typeof(Body));
        }

        static void Agrees(string type, Type here)
        {
            if (coin_sizeof(type) != Marshal.SizeOf(here))
                throw new TypeLoadException("rollcoin.cs is not of librollcoin "
                    + VersionString() + ": " + type);
        }

        static int Checked(int status)
        {
            if (status < 0)
                throw new CoinException(status);
            return status;
        }

        static void Holds(Array array, int length, string name)
        {
            if (array == null)
                throw new ArgumentNullException(name);
            if (array.Length < length)
                throw new ArgumentException(name + " has " + array.Length
                    + " elements, where " + length + " belong");
        }

        [DllImport(Library)]
        static extern int coin_step(ref State s, ref Params p, double dt);
        public static Bits Step(ref State s, ref Params p, double dt)
        {
            return (Bits)Checked(coin_step(ref s, ref p, dt));
        }

        [DllImport(Library)]
        static extern int coin_run(ref State s, ref Params p, Method method, double dt, ulong steps, out ulong done);
        public static Bits Run(ref State s, ref Params p, Method method, double dt, ulong steps, out ulong done)
        {
            return (Bits)Checked(coin_run(ref s, ref p, method, dt, steps, out done));
        }

        [DllImport(Library)]
        static extern int coin_sample(ref State start, ref Params p, Method method, double dt, ulong steps_per_sample, UIntPtr count, [In, Out] State[] result, out UIntPtr done);
        public static Bits Sample(ref State start, ref Params p, Method method, double dt, ulong steps_per_sample, State[] result, out UIntPtr done)
        {
            Holds(result, 0, "result");
            return (Bits)Checked(coin_sample(ref start, ref p, method, dt, steps_per_sample, (UIntPtr)result.Length, result, out done));
        }

        [DllImport(Library)]
        static extern int coin_batch_run([In, Out] State[] s, UIntPtr count, ref Params p, Method method, double dt, ulong steps, [In, Out] int[] status);
        public static Bits BatchRun(State[] s, ref Params p, Method method, double dt, ulong steps, int[] status)
        {
            Holds(s, 0, "s");
            if (status != null)
                Holds(status, s.Length, "status");
            return (Bits)Checked(coin_batch_run(s, (UIntPtr)s.Length, ref p, method, dt, steps, status));
        }

        [DllImport(Library)]
        static extern int coin_advance(ref State s, ref Params p, double t, double tol, out double reached);
        public static Bits Advance(ref State s, ref Params p, double t, double tol, out double reached)
        {
            return (Bits)Checked(coin_advance(ref s, ref p, t, tol, out reached));
        }

        [DllImport(Library)]
        static extern IntPtr coin_method_name(Method method);
        public static string MethodName(Method method)
        {
            return Marshal.PtrToStringAnsi(coin_method_name(method));
        }

        [DllImport(Library)]
        static extern int coin_params_disc(out Params p, double mass, double radius, double gravity);
        public static Bits ParamsDisc(out Params p, double mass, double radius, double gravity)
        {
            return (Bits)Checked(coin_params_disc(out p, mass, radius, gravity));
        }

        [DllImport(Library)]
        static extern int coin_params_ring(out Params p, double mass, double radius, double inner_radius, double gravity);
        public static Bits ParamsRing(out Params p, double mass, double radius, double inner_radius, double gravity)
        {
            return (Bits)Checked(coin_params_ring(out p, mass, radius, inner_radius, gravity));
        }

        [DllImport(Library)]
        static extern int coin_params_body(out Params p, double mass, double radius, double gravity, double inertia_X, double inertia_Z);
        public static Bits ParamsBody(out Params p, double mass, double radius, double gravity, double inertia_X, double inertia_Z)
        {
            return (Bits)Checked(coin_params_body(out p, mass, radius, gravity, inertia_X, inertia_Z));
        }

        [DllImport(Library)]
        static extern int coin_params_cylinder(out Params p, double mass, double radius, double thickness, double gravity);
        public static Bits ParamsCylinder(out Params p, double mass, double radius, double thickness, double gravity)
        {
            return (Bits)Checked(coin_params_cylinder(out p, mass, radius, thickness, gravity));
        }

        [DllImport(Library)]
        static extern int coin_params_check(ref Params p);
        public static Bits ParamsCheck(ref Params p)
        {
            return (Bits)Checked(coin_params_check(ref p));
        }

        [DllImport(Library)]
        static extern int coin_state_check(ref State s, ref Params p);
        public static Bits StateCheck(ref State s, ref Params p)
        {
            return (Bits)Checked(coin_state_check(ref s, ref p));
        }

        [DllImport(Library)]
        static extern int coin_state_from_motion(out State s, ref Params p, double[] q, double[] omega, double x, double z);
        public static Bits StateFromMotion(out State s, ref Params p, double[] q, double[] omega, double x, double z)
        {
            Holds(q, 4, "q");
            Holds(omega, 3, "omega");
            return (Bits)Checked(coin_state_from_motion(out s, ref p, q, omega, x, z));
        }

        [DllImport(Library)]
        static extern int coin_angular_velocity(ref State s, [In, Out] double[] omega);
        public static Bits AngularVelocity(ref State s, double[] omega)
        {
            Holds(omega, 3, "omega");
            return (Bits)Checked(coin_angular_velocity(ref s, omega));
        }

        [DllImport(Library)]
        static extern double coin_energy(ref State s, ref Params p);
        public static double Energy(ref State s, ref Params p)
        {
            return coin_energy(ref s, ref p);
        }

        [DllImport(Library)]
        static extern int coin_integrals(ref State s, ref Params p, [In, Out] double[] K);
        public static Bits Integrals(ref State s, ref Params p, double[] K)
        {
            Holds(K, 2, "K");
            return (Bits)Checked(coin_integrals(ref s, ref p, K));
        }

        [DllImport(Library)]
        static extern int coin_reaction(ref State s, ref Params p, out Force result);
        public static Bits Reaction(ref State s, ref Params p, out Force result)
        {
            return (Bits)Checked(coin_reaction(ref s, ref p, out result));
        }

        [DllImport(Library)]
        static extern int coin_rates(ref State s, ref Params p, out State result);
        public static Bits Rates(ref State s, ref Params p, out State result)
        {
            return (Bits)Checked(coin_rates(ref s, ref p, out result));
        }

        [DllImport(Library)]
        static extern int coin_center(ref State s, ref Params p, [In, Out] double[] r);
        public static Bits Center(ref State s, ref Params p, double[] r)
        {
            Holds(r, 3, "r");
            return (Bits)Checked(coin_center(ref s, ref p, r));
        }

        [DllImport(Library)]
        static extern int coin_velocity(ref State s, ref Params p, [In, Out] double[] v);
        public static Bits Velocity(ref State s, ref Params p, double[] v)
        {
            Holds(v, 3, "v");
            return (Bits)Checked(coin_velocity(ref s, ref p, v));
        }

        [DllImport(Library)]
        static extern int coin_contact(ref State s, ref Params p, [In, Out] double[] r, [In, Out] double[] v);
        public static Bits Contact(ref State s, ref Params p, double[] r, double[] v)
        {
            Holds(r, 3, "r");
            Holds(v, 3, "v");
            return (Bits)Checked(coin_contact(ref s, ref p, r, v));
        }

        [DllImport(Library)]
        static extern int coin_axes(ref State s, [In, Out] double[] R);
        public static Bits Axes(ref State s, double[] R)
        {
            Holds(R, 9, "R");
            return (Bits)Checked(coin_axes(ref s, R));
        }

        [DllImport(Library)]
        static extern int coin_quaternion(ref State s, [In, Out] double[] q);
        public static Bits Quaternion(ref State s, double[] q)
        {
            Holds(q, 4, "q");
            return (Bits)Checked(coin_quaternion(ref s, q));
        }

        [DllImport(Library)]
        static extern int coin_matrix(ref State s, ref Params p, [In, Out] double[] m);
        public static Bits Matrix(ref State s, ref Params p, double[] m)
        {
            Holds(m, 16, "m");
            return (Bits)Checked(coin_matrix(ref s, ref p, m));
        }

        [DllImport(Library)]
        static extern double coin_fastest_rate(ref State s, ref Params p);
        public static double FastestRate(ref State s, ref Params p)
        {
            return coin_fastest_rate(ref s, ref p);
        }

        [DllImport(Library)]
        static extern int coin_check(ref State s, ref Params p, Method method, double dt, double mu);
        public static Bits Check(ref State s, ref Params p, Method method, double dt, double mu)
        {
            return (Bits)Checked(coin_check(ref s, ref p, method, dt, mu));
        }

        [DllImport(Library)]
        static extern int coin_steady_roll(out State s, ref Params p, double wZ);
        public static Bits SteadyRoll(out State s, ref Params p, double wZ)
        {
            return (Bits)Checked(coin_steady_roll(out s, ref p, wZ));
        }

        [DllImport(Library)]
        static extern int coin_steady_spin(out State s, ref Params p, double theta);
        public static Bits SteadySpin(out State s, ref Params p, double theta)
        {
            return (Bits)Checked(coin_steady_spin(out s, ref p, theta));
        }

        [DllImport(Library)]
        static extern int coin_steady_upright_spin(out State s, ref Params p, double wY);
        public static Bits SteadyUprightSpin(out State s, ref Params p, double wY)
        {
            return (Bits)Checked(coin_steady_upright_spin(out s, ref p, wY));
        }

        [DllImport(Library)]
        static extern int coin_steady_circle(out State s, ref Params p, double theta, double wZ, int branch);
        public static Bits SteadyCircle(out State s, ref Params p, double theta, double wZ, int branch)
        {
            return (Bits)Checked(coin_steady_circle(out s, ref p, theta, wZ, branch));
        }

        [DllImport(Library)]
        static extern int coin_steady_turn(out State s, ref Params p, double theta, double radius);
        public static Bits SteadyTurn(out State s, ref Params p, double theta, double radius)
        {
            return (Bits)Checked(coin_steady_turn(out s, ref p, theta, radius));
        }

        [DllImport(Library)]
        static extern int coin_steady_ride(out State s, ref Params p, double speed, double radius);
        public static Bits SteadyRide(out State s, ref Params p, double speed, double radius)
        {
            return (Bits)Checked(coin_steady_ride(out s, ref p, speed, radius));
        }

        [DllImport(Library)]
        static extern int coin_steady_radii(ref State s, ref Params p, out double center, out double contact);
        public static Bits SteadyRadii(ref State s, ref Params p, out double center, out double contact)
        {
            return (Bits)Checked(coin_steady_radii(ref s, ref p, out center, out contact));
        }

        [DllImport(Library)]
        static extern int coin_stability(ref State s, ref Params p, out double lambda2);
        public static Bits Stability(ref State s, ref Params p, out double lambda2)
        {
            return (Bits)Checked(coin_stability(ref s, ref p, out lambda2));
        }

        [DllImport(Library)]
        static extern double coin_critical_roll(ref Params p);
        public static double CriticalRoll(ref Params p)
        {
            return coin_critical_roll(ref p);
        }

        [DllImport(Library)]
        static extern double coin_critical_spin(ref Params p);
        public static double CriticalSpin(ref Params p)
        {
            return coin_critical_spin(ref p);
        }

        [DllImport(Library)]
        static extern int coin_steady_at(ref State s, ref Params p, double t, out State result);
        public static Bits SteadyAt(ref State s, ref Params p, double t, out State result)
        {
            return (Bits)Checked(coin_steady_at(ref s, ref p, t, out result));
        }

        [DllImport(Library)]
        static extern int coin_orbit_init(out Orbit o, ref State s, ref Params p);
        public static Bits OrbitInit(out Orbit o, ref State s, ref Params p)
        {
            return (Bits)Checked(coin_orbit_init(out o, ref s, ref p));
        }

        [DllImport(Library)]
        static extern int coin_orbit_at(ref Orbit o, double t, out State result);
        public static Bits OrbitAt(ref Orbit o, double t, out State result)
        {
            return (Bits)Checked(coin_orbit_at(ref o, t, out result));
        }

        [DllImport(Library)]
        static extern int coin_losses_check(ref Losses l, ref Params p);
        public static Bits LossesCheck(ref Losses l, ref Params p)
        {
            return (Bits)Checked(coin_losses_check(ref l, ref p));
        }

        [DllImport(Library)]
        static extern double coin_losses_power(ref State s, ref Params p, ref Losses l);
        public static double LossesPower(ref State s, ref Params p, ref Losses l)
        {
            return coin_losses_power(ref s, ref p, ref l);
        }

        [DllImport(Library)]
        static extern int coin_losses_rates(ref State s, ref Params p, ref Losses l, out State result);
        public static Bits LossesRates(ref State s, ref Params p, ref Losses l, out State result)
        {
            return (Bits)Checked(coin_losses_rates(ref s, ref p, ref l, out result));
        }

        [DllImport(Library)]
        static extern int coin_losses_reaction(ref State s, ref Params p, ref Losses l, out Force result);
        public static Bits LossesReaction(ref State s, ref Params p, ref Losses l, out Force result)
        {
            return (Bits)Checked(coin_losses_reaction(ref s, ref p, ref l, out result));
        }

        [DllImport(Library)]
        static extern int coin_settle(ref State s, ref Params p, ref Losses l, double t, double tol, out double reached);
        public static Bits Settle(ref State s, ref Params p, ref Losses l, double t, double tol, out double reached)
        {
            return (Bits)Checked(coin_settle(ref s, ref p, ref l, t, tol, out reached));
        }

        [DllImport(Library)]
        static extern double coin_time_to_rest(ref State s, ref Params p, ref Losses l, double tol);
        public static double TimeToRest(ref State s, ref Params p, ref Losses l, double tol)
        {
            return coin_time_to_rest(ref s, ref p, ref l, tol);
        }

        [DllImport(Library)]
        static extern int coin_losses_fit(ref Losses l, ref State s, ref Params p, double time);
        public static Bits LossesFit(ref Losses l, ref State s, ref Params p, double time)
        {
            return (Bits)Checked(coin_losses_fit(ref l, ref s, ref p, time));
        }

        [DllImport(Library)]
        static extern int coin_table_check(ref Table table, ref Params p);
        public static Bits TableCheck(ref Table table, ref Params p)
        {
            return (Bits)Checked(coin_table_check(ref table, ref p));
        }

        [DllImport(Library)]
        static extern int coin_body_from_state(out Body b, ref State s, ref Params p);
        public static Bits BodyFromState(out Body b, ref State s, ref Params p)
        {
            return (Bits)Checked(coin_body_from_state(out b, ref s, ref p));
        }

        [DllImport(Library)]
        static extern int coin_body_from_motion(out Body b, ref Params p, double[] q, double[] omega, double[] r, double[] v);
        public static Bits BodyFromMotion(out Body b, ref Params p, double[] q, double[] omega, double[] r, double[] v)
        {
            Holds(q, 4, "q");
            Holds(omega, 3, "omega");
            Holds(r, 3, "r");
            Holds(v, 3, "v");
            return (Bits)Checked(coin_body_from_motion(out b, ref p, q, omega, r, v));
        }

        [DllImport(Library)]
        static extern int coin_move(ref Body b, ref Params p, ref Table table, double t, double tol, Bits stop, out double reached);
        public static Bits Move(ref Body b, ref Params p, ref Table table, double t, double tol, Bits stop, out double reached)
        {
            return (Bits)Checked(coin_move(ref b, ref p, ref table, t, tol, stop, out reached));
        }

        [DllImport(Library)]
        static extern double coin_body_energy(ref Body b, ref Params p);
        public static double BodyEnergy(ref Body b, ref Params p)
        {
            return coin_body_energy(ref b, ref p);
        }

        [DllImport(Library)]
        static extern int coin_body_reaction(ref Body b, ref Params p, ref Table table, out Force result);
        public static Bits BodyReaction(ref Body b, ref Params p, ref Table table, out Force result)
        {
            return (Bits)Checked(coin_body_reaction(ref b, ref p, ref table, out result));
        }

        [DllImport(Library)]
        static extern int coin_body_contact(ref Body b, ref Params p, [In, Out] double[] v);
        public static Bits BodyContact(ref Body b, ref Params p, double[] v)
        {
            Holds(v, 3, "v");
            return (Bits)Checked(coin_body_contact(ref b, ref p, v));
        }

        [DllImport(Library)]
        static extern int coin_body_strike(ref Body b, ref Params p, double[] J, double[] r);
        public static Bits BodyStrike(ref Body b, ref Params p, double[] J, double[] r)
        {
            Holds(J, 3, "J");
            Holds(r, 3, "r");
            return (Bits)Checked(coin_body_strike(ref b, ref p, J, r));
        }

        [DllImport(Library)]
        static extern int coin_body_face(ref Body b, ref Params p);
        public static Face BodyFace(ref Body b, ref Params p)
        {
            return (Face)Checked(coin_body_face(ref b, ref p));
        }

        [DllImport(Library)]
        static extern int coin_body_matrix(ref Body b, ref Params p, [In, Out] double[] m);
        public static Bits BodyMatrix(ref Body b, ref Params p, double[] m)
        {
            Holds(m, 16, "m");
            return (Bits)Checked(coin_body_matrix(ref b, ref p, m));
        }

        [DllImport(Library)]
        static extern uint coin_version();
        public static uint Version()
        {
            return coin_version();
        }

        [DllImport(Library)]
        static extern IntPtr coin_version_string();
        public static string VersionString()
        {
            return Marshal.PtrToStringAnsi(coin_version_string());
        }

        [DllImport(Library)]
        static extern IntPtr coin_status_string(int status);
        public static string StatusString(int status)
        {
            return Marshal.PtrToStringAnsi(coin_status_string(status));
        }

        [DllImport(Library)]
        static extern uint coin_sizeof(string type);
        public static uint Sizeof(string type)
        {
            return coin_sizeof(type);
        }

        [DllImport(Library)]
        static extern int coin_selftest();
        public static Bits Selftest()
        {
            return (Bits)Checked(coin_selftest());
        }
    }
}
