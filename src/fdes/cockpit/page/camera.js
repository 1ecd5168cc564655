/**
 * The eye: at the aircraft, looking along the body x axis, or outside it (outside_view.js). Both worlds and the head-up
 * display take their geometry from here, so that a symbol drawn over the horizon lies on the horizon.
 *
 * Screen: x right, y down [px]. A direction (x, y, z) in body axes (forward, right, down) appears at
 * (cx + f y/x, cy + f z/x).
 */

const FIELD_OF_VIEW = 0.7; // rad, top to bottom
const LIFT = 0.06; // share of the height by which the center sits above the middle: more ground, less sky
const LOWEST_EYE = 2.5; // m: on the ground the eye is still above it

/** The camera for a picture of `width` by `height` [px] from an aircraft in `state`; `field` [rad] from top to bottom. */
export function camera(width, height, state, field = FIELD_OF_VIEW) {
  return {
    width,
    height,
    f: height / 2 / Math.tan(field / 2),
    cx: width / 2,
    cy: height * (0.5 - LIFT),
    lift: LIFT,
    north: state.north,
    east: state.east,
    eye: Math.max(LOWEST_EYE, state.h),
    phi: state.phi,
    theta: state.theta,
    psi: state.psi,
    axes: bodyAxes(state),
  };
}

/** Body x, y, z axes in north-east-down components: nine numbers, one axis after another. */
export function bodyAxes({ phi, theta, psi }) {
  const [sp, cp] = [Math.sin(phi), Math.cos(phi)];
  const [st, ct] = [Math.sin(theta), Math.cos(theta)];
  const [ss, cs] = [Math.sin(psi), Math.cos(psi)];
  return [
    [ct * cs, ct * ss, -st],
    [sp * st * cs - cp * ss, sp * st * ss + cp * cs, sp * ct],
    [cp * st * cs + sp * ss, cp * st * ss - sp * cs, cp * ct],
  ].flat();
}

/** A vector in north-east-down components, in body axes. */
export function toBody(axes, n, e, d) {
  return [
    axes[0] * n + axes[1] * e + axes[2] * d,
    axes[3] * n + axes[4] * e + axes[5] * d,
    axes[6] * n + axes[7] * e + axes[8] * d,
  ];
}

/**
 * Where a world with this camera has its horizon: y [px] in the middle column, tilt [rad], positive right end down.
 * Found by projecting two level directions through the same axes as everything else in the world.
 */
export function worldHorizon(cam) {
  const points = [-0.2, 0.2].map((aside) => {
    const heading = cam.psi + aside;
    const [x, y, z] = toBody(cam.axes, Math.cos(heading), Math.sin(heading), 0);
    return [cam.cx + (cam.f * y) / x, cam.cy + (cam.f * z) / x];
  });
  const [[x0, y0], [x1, y1]] = points;
  return { y: y0 + ((cam.cx - x0) * (y1 - y0)) / (x1 - x0), tilt: Math.atan2(y1 - y0, x1 - x0) };
}
