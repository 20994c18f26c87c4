// SPDX-License-Identifier: MIT
// numbers.js: numbers as text, and in the units of a US quarter.

// As C prints them by "%.17g".
function g17(x) {
  if (x === 0) return Object.is(x, -0) ? "-0" : "0";
  if (!Number.isFinite(x)) return x > 0 ? "inf" : x < 0 ? "-inf" : "nan";
  const [digits, e] = x.toExponential(16).split("e"), trim = s => s.replace(/\.?0+$/, "");
  if (e >= -4 && e < 17) return e < 16 ? trim(x.toFixed(16 - e)) : x.toFixed(0);
  return trim(digits) + "e" + (e < 0 ? "-" : "+") + String(Math.abs(e)).padStart(2, "0");
}

// Short, for people: so many significant digits, and a true minus.
function short(x, digits = 3) {
  if (!Number.isFinite(x)) return x > 0 ? "∞" : "–";
  const size = Math.abs(x);
  if (size < 1e-12) return "0"; // rounding
  if (size >= 1e6 || size < 1e-3) return power(x, digits - 1);
  const text = x.toPrecision(digits);
  return (text.includes("e") ? String(Number(text)) : text).replace("-", "−");
}

const raised = e => [...String(e)].map(c => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]).join("");
function power(x, digits = 1) {
  const [d, e] = x.toExponential(digits).split("e");
  return d.replace("-", "−") + "·10" + raised(Number(e));
}

// Scenes in natural units are shown as those of a quarter.
const QUARTER = { radius: 0.01213, gravity: 9.80665, thickness: 0.00175 };
const isNatural = scene => sceneWord(scene, 2) !== "s";
const secondOf = scene => isNatural(scene) ? Math.sqrt(QUARTER.gravity / QUARTER.radius) : 1;
const second = () => secondOf(m.scene); // in units of time
const mm = x => x * (isNatural(m.scene) ? QUARTER.radius : 1) * 1e3;
const meters = mm => mm / mm1();
const mm1 = () => mm(1);
const turns = w => w / (2 * Math.PI) * second(); // in a second
const perTurn = x => x * 2 * Math.PI / second();
const degrees = x => x * 180 / Math.PI;
const metersPerSecond = v => mm(v) * second() / 1e3;

const timeText = (t, digits = 3) => t / second() < 0.1 && t > 0 ? short(t / second() * 1e3, digits) + " ms"
  : short(t / second(), digits) + " s";
const clockText = t => (t / second()).toFixed(motion.end < second() ? 3 : 2) + " s";
const lengthText = (x, digits = 3) => short(mm(x), digits) + " mm";
