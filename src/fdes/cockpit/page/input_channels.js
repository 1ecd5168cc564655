/** What inputs move, the units they are said in (the first is offered first), and how far a slider goes in it. */

const ANGLE = { deg: 1, rad: Math.PI / 180 };
const SPEED = { "m/s": 1, "ft/s": 1 / 0.3048, kt: 3600 / 1852 };

export const CHANNELS = {
  elevator: { words: "elevator δe (+ nose down)", si: "rad", units: ANGLE, reach: 10, start: 2 },
  aileron: { words: "aileron δa (+ rolls right)", si: "rad", units: ANGLE, reach: 10, start: 5 },
  rudder: { words: "rudder δr (+ nose left)", si: "rad", units: ANGLE, reach: 10, start: 5 },
  throttle: { words: "throttle (+ open)", si: "1", units: { "of 1": 1 }, reach: 0.5, start: 0.1 },
  gust_u: { words: "gust u (+ from behind)", si: "m/s", units: SPEED, reach: 15, start: 3 },
  gust_v: { words: "gust v (+ from left)", si: "m/s", units: SPEED, reach: 15, start: 3 },
  gust_w: { words: "gust w (+ downward)", si: "m/s", units: SPEED, reach: 15, start: -3 },
  alpha_g: { words: "gust angle αg (+ upward)", si: "rad", units: ANGLE, reach: 8, start: 2 },
  beta_g: { words: "gust angle βg (+ from right)", si: "rad", units: ANGLE, reach: 8, start: 2 },
};

/** A value as it is said to the server: ``2deg``; a share has no unit. */
export const said = (value, unit) => `${value === "" ? "nothing" : value}${unit === "of 1" ? "" : unit}`;
