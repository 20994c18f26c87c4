// SPDX-License-Identifier: MIT
// sound.js: what the motion sounds like.  Impacts ring by their speed, the contact of
// a coin that whirls hums at its rate, rolling and slipping are a quiet noise.

const sound = { on: true, context: null, heard: 0 };

const remember = on => { try { localStorage.setItem("rollcoin-sound", on ? "1" : "0"); } catch { /* not allowed */ } };
function remembered() {
  try { return localStorage.getItem("rollcoin-sound") !== "0"; } catch { return true; }
}

// A buffer of some seconds, of a function of time.
function samples(context, duration, f) {
  const buffer = context.createBuffer(1, duration * context.sampleRate, context.sampleRate);
  buffer.getChannelData(0).forEach((_, k, data) => { data[k] = f(k / context.sampleRate); });
  return buffer;
}

// A metal disc on wood: some partials that die away, and a knock.
const RING = [[1, 0.34, 9], [1.73, 0.22, 13], [2.33, 0.16, 16], [3.9, 0.1, 26]]; // rate, size, decay
const knock = t => 0.5 * (2 * Math.random() - 1) * Math.exp(-t * 260) + 0.5 * Math.sin(1100 * t) * Math.exp(-t * 70);
const strike = base => t => knock(t) +
  RING.reduce((x, [rate, size, decay]) => x + size * Math.sin(2 * Math.PI * base * rate * t) * Math.exp(-t * decay), 0);

// Browsers allow sound after a gesture.  All sources run on, and are silent until
// the motion opens their gains.
function beginSound() {
  if (sound.context?.state === "suspended") sound.context.resume();
  if (!sound.on || sound.context || !globalThis.AudioContext) return;
  const context = sound.context = new AudioContext(), now = context.currentTime;
  const node = (kind, settings, to) => {
    const made = context["create" + kind]();
    for (const [name, value] of Object.entries(settings))
      if (made[name] instanceof AudioParam) made[name].setValueAtTime(value, now);
      else made[name] = value;
    if (to) made.connect(to);
    made.start?.();
    return made;
  };
  sound.analyser = node("Analyser", { fftSize: 2048 }, context.destination);
  sound.master = node("Gain", { gain: 0 }, sound.analyser);
  sound.strike = samples(context, 0.7, strike(3900));
  sound.heavy = samples(context, 1.2, strike(1500));
  const noise = samples(context, 2, () => 2 * Math.random() - 1);
  const band = (type, frequency, Q) => {
    const gain = node("Gain", { gain: 0 }, sound.master), filter = node("BiquadFilter", { type, frequency, Q }, gain);
    node("BufferSource", { buffer: noise, loop: true }, filter);
    return gain;
  };
  sound.roll = band("bandpass", 420, 0.7);
  sound.slip = band("bandpass", 2600, 0.8);
  // The hum: noise that swells with each turn of the contact, and its tone.
  const swell = node("Gain", { gain: 0.5 }, sound.hum = node("Gain", { gain: 0 }, sound.master));
  const rush = node("BiquadFilter", { type: "bandpass", frequency: 900, Q: 0.6 }, swell);
  node("BufferSource", { buffer: noise, loop: true }, rush);
  sound.turn = [node("Oscillator", { frequency: 5 }, node("Gain", { gain: 0.5 }, swell.gain)),
    node("Oscillator", { type: "sawtooth", frequency: 5 }, node("BiquadFilter", { type: "lowpass", frequency: 700 },
      node("Gain", { gain: 0.35 }, sound.hum)))];
  for (const frequency of [2100, 3630]) node("Oscillator", { frequency }, node("Gain", { gain: 0.03 }, swell));
}

const toward = (parameter, value, quick = 0.02) => parameter.setTargetAtTime(value, sound.context.currentTime, quick);

// The impacts of the time that has passed, in as many seconds.
function soundImpacts(from, to, passed) {
  const list = doubles(lib.page_impacts(), 2 * lib.page_impact_count()), { context } = sound;
  for (let k = 0; k < list.length; k += 2) {
    const [t, speed] = [list[k], metersPerSecond(list[k + 1])];
    if (t <= from || t > to || speed < 0.004) continue;
    const source = context.createBufferSource(), gain = context.createGain();
    source.buffer = sceneName() === "disk" ? sound.heavy : sound.strike;
    source.playbackRate.value = 0.97 + 0.06 * chance(t, speed);
    gain.gain.value = Math.min(0.5 * speed ** 0.7, 0.8);
    source.connect(gain).connect(sound.master);
    source.start(context.currentTime + 0.02 + passed * (t - from) / (to - from));
    ++sound.heard;
  }
}

// What is heard while the coin touches: [rate of the contact, hum, roll, slip].
function tones() {
  const s = motion.moment, cosine = Math.cos(s[AT.theta]), rate = Math.abs(turns(s[AT.wY] / cosine));
  if (s[AT.bits] & (COIN.lifts | COIN.rests) || m.now >= motion.end) return [rate, 0, 0, 0];
  const whirls = clamp(1.25 - 1.6 * cosine, 0, 1) * clamp(rate / 8, 0, 1);
  const rolls = Math.abs(metersPerSecond(m.radius * (s[AT.wZ] + s[AT.wY] * Math.tan(s[AT.theta]))));
  const slips = metersPerSecond(s[AT.slip]);
  return [Math.min(rate, 900), 0.5 * whirls, Math.min(0.25 * rolls, 0.12), Math.min(0.5 * slips, 0.1)];
}

// Called in each frame, with the time of the motion before and now.
function soundOn(from, to, passed) {
  if (!sound.context) return;
  const heard = sound.on && playing && direction > 0, [rate, hum, roll, slip] = heard ? tones() : [5, 0, 0, 0];
  toward(sound.master.gain, heard || m.now >= motion.end && sound.on ? 0.8 : 0);
  for (const oscillator of sound.turn) toward(oscillator.frequency, Math.max(rate * m.speed * slow / second(), 0.5));
  toward(sound.hum.gain, hum, hum ? 0.03 : 0.008);
  toward(sound.roll.gain, roll);
  toward(sound.slip.gain, slip);
  if (heard && passed > 0 && to > from) soundImpacts(from, to, passed);
}

function switchSound(on) {
  sound.on = on;
  remember(on);
  showSound();
  beginSound();
  wake();
}

function showSound() {
  $("sound").setAttribute("aria-pressed", sound.on);
  $("sound").querySelector("span").textContent = sound.on ? "Sound on" : "Sound off";
}
