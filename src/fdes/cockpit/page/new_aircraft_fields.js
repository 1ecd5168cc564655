/** What the form for a new aircraft asks: each field's place in the aircraft file, its quantity and its words. */

/** `at` is the place, `si` the SI unit of the quantity (null: a pure number), `us` its unit in the US sources. */
const field = (at, words, si, us = si, more = {}) => ({ at, name: at.split(".").at(-1), words, si, us, ...more });
const inertia = (name, words) => field(`mass.${name}`, words, "kg m^2", "slug ft^2");
const derivative = (name, words, optional = false) => field(`${TABLE}.${name}`, words, "1/rad", "1/rad", { optional });
const ratio = (name, words, optional = false) => field(`${TABLE}.${name}`, words, null, null, { optional });
const assumed = (name, words, si, us, value = "") => field(`assumed.${name}`, words, si, us, { value, assumed: true });

export const CONDITION = "conditions.0";
const TABLE = `${CONDITION}.derivatives`;
export const WHY = "chosen for this example";
export const THRUST = "assumed.max_thrust";

export const TEXTS = [
  ["id", "Short name", "my-aircraft"],
  ["name", "Name", "My aircraft"],
  ["summary", "Summary", "Entered in the form."],
  ["source", "Source of the numbers", "entered by hand"],
  ["condition_name", "Flight condition", "as entered"],
];

export const CHOICES = [
  ["engine", "Engine", ["jet", "propeller"]],
  ["aileron_sense", "Positive aileron", ["positive rolls right", "positive rolls left"]],
];

export const GROUPS = [
  [
    "Geometry",
    [field("geometry.S", "wing area", "m^2", "ft^2"), field("geometry.b", "span", "m", "ft"), field("geometry.c", "mean chord", "m", "ft")],
  ],
  [
    "Mass, inertias in body axes",
    [
      field("mass.W", "weight, as a mass", "kg", "lb"),
      field("mass.cg", "center of gravity, in chords", null, null, { optional: true }),
      inertia("Ix", "about the roll axis"),
      inertia("Iy", "about the pitch axis"),
      inertia("Iz", "about the yaw axis"),
      { ...inertia("Ixz", "product"), optional: true },
    ],
  ],
  [
    "Flight condition: Mach, speed, or both",
    [
      field(`${CONDITION}.mach`, "Mach number, unless the speed is given", null, null, { bare: true }),
      field(`${CONDITION}.speed`, "true airspeed, unless Mach is given", "m/s", "ft/s"),
      field(`${CONDITION}.altitude`, "altitude", "m", "ft"),
      field(`${CONDITION}.trim_alpha`, "trim angle of attack", "rad", "deg", { optional: true }),
      field(`${CONDITION}.density`, "air density, if not standard", "kg/m^3", "slug/ft^3", { optional: true }),
      field(`${CONDITION}.gravity`, "gravity, if not standard", "m/s^2", "ft/s^2", { optional: true }),
    ],
  ],
  [
    "Longitudinal derivatives",
    [
      ratio("CL", "lift"),
      ratio("CD", "drag"),
      derivative("CL_alpha", "lift-curve slope"),
      derivative("CD_alpha", "drag with angle of attack"),
      derivative("Cm_alpha", "pitch stiffness"),
      derivative("CL_alphadot", "lift, downwash lag", true),
      derivative("Cm_alphadot", "pitch, downwash lag", true),
      derivative("CL_q", "lift with pitch rate", true),
      derivative("Cm_q", "pitch damping"),
      ratio("CL_M", "lift with Mach", true),
      ratio("CD_M", "drag with Mach", true),
      ratio("Cm_M", "pitch with Mach", true),
      derivative("CL_de", "lift of elevator"),
      derivative("CD_de", "drag of elevator", true),
      derivative("Cm_de", "elevator power"),
    ],
  ],
  [
    "Lateral derivatives",
    [
      derivative("Cy_beta", "side force"),
      derivative("Cl_beta", "dihedral effect"),
      derivative("Cn_beta", "weathercock"),
      derivative("Cy_p", "side force, roll rate", true),
      derivative("Cl_p", "roll damping"),
      derivative("Cn_p", "yaw with roll rate"),
      derivative("Cy_r", "side force, yaw rate", true),
      derivative("Cl_r", "roll with yaw rate"),
      derivative("Cn_r", "yaw damping"),
      derivative("Cy_da", "side force of aileron", true),
      derivative("Cl_da", "aileron power"),
      derivative("Cn_da", "yaw of aileron"),
      derivative("Cy_dr", "side force of rudder"),
      derivative("Cl_dr", "roll of rudder"),
      derivative("Cn_dr", "rudder power"),
    ],
  ],
  [
    "Assumed: what no source gives, and why",
    [
      assumed("max_thrust", "largest thrust; left empty, twice the drag", "N", "lbf"),
      assumed("elevator_up_limit", "elevator up, from trim", "rad", "deg", 25),
      assumed("elevator_down_limit", "elevator down, from trim", "rad", "deg", 15),
      assumed("aileron_limit", "aileron, each way", "rad", "deg", 20),
      assumed("rudder_limit", "rudder, each way", "rad", "deg", 20),
      assumed("full_stick_elevator", "elevator at full stick", "rad", "deg", 8),
      assumed("full_stick_aileron", "aileron at full stick", "rad", "deg", 12),
      assumed("full_pedal_rudder", "rudder at full pedal", "rad", "deg", 6),
    ],
  ],
];
