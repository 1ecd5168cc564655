/**
 * Shaders of the WebGL world. One pass over the whole screen casts a ray for each pixel and paints sky or land; a
 * second pass draws trees and buildings as solids. Sizes and places come from scenery.js.
 *
 * Coordinates are north-east-down in meters; uAxes has the body axes as columns; screen sizes in CSS pixels.
 */

import {
  APRONS,
  CLOUD_BASE,
  COUNTRY,
  FIELD,
  LAKELAND,
  RIVER_WIDTH,
  ROAD_SPACING,
  ROAD_WIDTH,
  RUNWAY,
  RUNWAY_PAINT,
  TOWN,
} from "./scenery.js";

const real = (value) => (Number.isInteger(value) ? `${value}.0` : String(value));

const COMMON = `
uniform mat3 uAxes; uniform vec2 uPlace, uSize, uCenter; uniform float uF, uEye;
uniform vec3 uHaze;
vec3 tone(vec3 c) { return pow(clamp(c, 0.0, 1.0), vec3(0.96)); }
float hazeAt(float distance) { float h = 1.0 - exp(-distance / 42000.0); return h * h * 0.98 + 0.02 * h; }
`;

export const SCREEN_VERTEX = `#version 300 es
void main() {
  vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2); // one triangle that covers the screen
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}`;

export const LAND_FRAGMENT = `#version 300 es
precision highp float; precision highp int;
${COMMON}
uniform sampler2D uSkyline, uNoise; uniform vec3 uCrops[7];
uniform vec3 uSun, uSunColor, uLight, uZenith, uSky, uHorizon, uCloud, uCloudShade, uRange0, uRange1;
uniform vec3 uWood, uWater, uRoad, uApron, uRunway, uPaint, uGrass; uniform float uLamps; uniform vec2 uPixel;
out vec4 color;

const float SOUTH = ${real(RUNWAY.south)}, NORTH = ${real(RUNWAY.south + RUNWAY.length)};
const float HALF = ${real(RUNWAY.width / 2)}, FIELD = ${real(FIELD)}, COUNTRY = ${real(COUNTRY)};
const float LAKELAND = ${real(LAKELAND)}, ROADS = ${real(ROAD_SPACING)};

float hash(ivec2 cell, int salt) { // the same as hash() of scenery.js
  uint h = (uint(cell.x) * 0x8da6b343u) ^ (uint(cell.y) * 0xd8163841u) ^ (uint(salt) * 0xcb1ab31fu);
  h ^= h >> 16; h *= 0x7feb352du; h ^= h >> 15; h *= 0x846ca68bu; h ^= h >> 16;
  return float(h) / 4294967296.0;
}
// Soft noise from a texture that repeats: red has one octave, 1 per texel; green heaped octaves, 1 per 16 texels.
float noise(vec2 p) { return texture(uNoise, p / 256.0).r; }
float heap(vec2 p) { return texture(uNoise, p / 16.0).g; }

// Share of a pixel of size px that lies inside a shape whose edge is at signed distance d (negative inside).
float inside(float d, float px) { return clamp(0.5 - d / px, 0.0, 1.0); }
float rectangle(vec2 p, vec4 r, vec2 px) {
  vec2 d = max(vec2(r.x, r.z) - p, p - vec2(r.y, r.w)) / px;
  vec2 size = (vec2(r.y, r.w) - vec2(r.x, r.z)) / px;
  vec2 share = clamp(0.5 - d, 0.0, 1.0) * min(vec2(1.0), size);
  return share.x * share.y;
}
float riverEast(float n) { return -5200.0 + 1400.0 * sin(n / 5200.0) + 500.0 * sin(n / 1700.0 + 1.0); }
bool isClear(vec2 p, float margin) {
  bool airfield = abs(p.y) < 900.0 + margin
    && p.x > SOUTH - 1800.0 - margin && p.x < NORTH + 1500.0 + margin;
  bool town = distance(p, vec2(${real(TOWN.north)}, ${real(TOWN.east)})) < 2300.0 + margin;
  return !airfield && !town && abs(p.y - riverEast(p.x)) > 150.0 + margin;
}

vec3 crops(vec2 p, float px) {
  ivec2 cell = ivec2(floor(p / FIELD)); vec2 at = fract(p / FIELD);
  float split = hash(cell, 1), middle = 0.3 + 0.4 * hash(cell, 5);
  float along = split < 0.35 ? 0.0 : split < 0.68 ? at.x : at.y;
  int second = split >= 0.35 && along > middle ? 1 : 0;
  vec3 c = uCrops[int(hash(cell, 2 + second) * 7.0)];
  float furrow = sin((split < 0.68 ? p.y : p.x) * 0.35); // rows of the crop, seen from low down
  c *= 1.0 + 0.05 * furrow * (1.0 - smoothstep(1.0, 6.0, px));
  vec2 edge = min(at, 1.0 - at) * FIELD;
  float hedge = min(edge.x, edge.y);
  if (split >= 0.35) hedge = min(hedge, abs(along - middle) * FIELD);
  return mix(c, uWood * 1.15, inside(hedge - 5.0, max(px, 3.0)) * 0.75 * min(1.0, 12.0 / px));
}

float wood(vec2 p, float px) {
  ivec2 cell = ivec2(floor(p / COUNTRY));
  if (hash(cell, 11) > 0.5) return 0.0;
  float k = hash(cell, 12), radius = 140.0 + 420.0 * k * k;
  vec2 middle = vec2(cell) * COUNTRY + radius + (COUNTRY - 2.0 * radius) * vec2(hash(cell, 13), hash(cell, 14));
  if (!isClear(middle, radius)) return 0.0;
  vec2 d = p - middle;
  float edge = 0.92 + 0.14 * sin(3.0 * atan(d.y, d.x) + float(cell.x)) + 0.12 * (noise(p / 60.0) - 0.5);
  return inside(length(d) - radius * edge, px);
}

float lake(vec2 p, float px) {
  ivec2 cell = ivec2(floor(p / LAKELAND));
  if (hash(cell, 21) > 0.55) return 0.0;
  float radius = 380.0 + 620.0 * hash(cell, 22), room = 1.4 * radius, phase = 6.28 * hash(cell, 25);
  vec2 middle = vec2(cell) * LAKELAND + room + (LAKELAND - 2.0 * room) * vec2(hash(cell, 23), hash(cell, 24));
  if (!isClear(middle, room)) return 0.0;
  vec2 d = p - middle; float angle = atan(d.y, d.x);
  float shore = 1.0 + 0.2 * sin(2.0 * angle + phase) + 0.12 * sin(3.0 * angle + 2.0 * phase);
  return inside(length(d) - radius * shore, px);
}

// Uniforms, not constants: a constant array may be built anew for each pixel.
uniform vec4 uMarks[${RUNWAY_PAINT.length}], uAprons[${APRONS.length}];

vec3 airfield(vec3 c, vec2 p, vec2 px) {
  if (p.x < SOUTH - 900.0 || p.x > NORTH + 400.0 || abs(p.y) > 460.0) return c;
  vec3 mown = uGrass * (0.94 + 0.12 * noise(p / 25.0));
  c = mix(c, mown, rectangle(p, vec4(SOUTH - 120.0, NORTH + 120.0, -95.0, 95.0), px));
  vec3 concrete = uApron * (0.95 + 0.1 * noise(p / 9.0));
  for (int i = 0; i < ${APRONS.length}; i++) c = mix(c, concrete, rectangle(p, uAprons[i], px));
  vec3 asphalt = uRunway * (0.9 + 0.2 * noise(p * vec2(0.02, 0.12)));
  c = mix(c, asphalt, rectangle(p, vec4(SOUTH, NORTH, -HALF, HALF), px));
  if (abs(p.y) > HALF || p.x < SOUTH || p.x > NORTH) return c;
  for (int i = 0; i < ${RUNWAY_PAINT.length}; i++) c = mix(c, uPaint, rectangle(p, uMarks[i], px));
  return c;
}

// Distance to the nearest multiple of spacing.
float nearest(float x, float spacing) { return (fract(x / spacing + 0.5) - 0.5) * spacing; }

vec3 lamps(vec2 p, vec2 px) {
  vec2 size = max(px * 0.9, vec2(0.7));
  float along = nearest(p.x - SOUTH, 60.0);
  float edge = exp(-pow(along / size.x, 2.0) - pow((abs(p.y) - HALF - 2.0) / size.y, 2.0));
  edge *= step(SOUTH - 5.0, p.x) * step(p.x, NORTH + 5.0);
  float row = nearest(p.x - SOUTH, 30.0), across = nearest(p.y, 4.5);
  float approach = exp(-pow(row / size.x, 2.0) - pow(across / size.y, 2.0));
  approach *= step(abs(p.y), 10.0) * step(SOUTH - 610.0, p.x) * step(p.x, SOUTH - 20.0);
  return vec3(1.0, 0.91, 0.66) * edge + vec3(1.0, 0.96, 0.87) * approach;
}

vec3 land(vec3 d) {
  float distance_ = uEye / d.z; vec2 p = uPlace + d.xy * distance_;
  // Size of the pixel on the ground: across the ray, and along it, where it is stretched.
  float across = distance_ * uPixel.y / uF, grazing = across / max(d.z, 1e-4);
  vec2 ray = normalize(d.xy + 1e-7);
  vec2 px = sqrt(vec2(across * across) + (grazing * grazing) * ray * ray) + 1e-3;
  float coarse = sqrt(px.x * px.y);

  vec3 far = mix(uCrops[1], uCrops[5], 0.5 + 0.5 * noise(p / 9000.0));
  vec3 c = mix(crops(p, coarse), far, smoothstep(150.0, 1400.0, coarse));
  float grain = mix(noise(p / 14.0), 0.5, smoothstep(2.0, 12.0, coarse)) * (1.0 - smoothstep(2.0, 60.0, coarse));
  c *= 0.93 + 0.14 * grain + 0.07 * noise(p / 900.0);
  c = mix(c, uWood * (0.85 + 0.3 * mix(noise(p / 16.0), 0.5, smoothstep(4.0, 20.0, coarse))), wood(p, coarse) * 0.92);
  vec2 off = abs(fract(p / ROADS) - 0.5) * ROADS; // from the middle of the cell, where the road runs
  vec2 road = clamp(0.5 + (${real(ROAD_WIDTH / 2)} - off) / px, 0.0, 1.0) * min(vec2(1.0), ${real(ROAD_WIDTH)} / px);
  c = mix(c, uRoad, max(road.x, road.y) * 0.9);
  float wet = max(lake(p, coarse), inside(abs(p.y - riverEast(p.x)) - ${real(RIVER_WIDTH / 2)}, px.y));
  vec3 mirror = mix(uSky, uHorizon, 0.5);
  float glint = pow(max(0.0, dot(reflect(d, vec3(0, 0, -1)), uSun)), 220.0);
  c = airfield(c, p, px);
  c *= uLight * (1.0 - 0.26 * smoothstep(0.52, 0.7, heap((p + uSun.xy * 2600.0) / 5200.0)));
  vec3 water = mix(uWater * mix(vec3(1.0), uLight, 0.5), mirror, pow(1.0 - d.z, 3.0) * 0.6) + uSunColor * glint * 0.7;
  c = mix(c, water, wet);
  if (uLamps > 0.5) c += lamps(p, px);
  return mix(c, uHaze, hazeAt(distance_));
}

vec3 air(vec3 d) {
  float up = -d.z, sun = max(0.0, dot(d, uSun));
  vec3 c = mix(uHorizon, uSky, smoothstep(0.0, 0.16, up)); c = mix(c, uZenith, smoothstep(0.06, 0.55, up));
  float disc = smoothstep(0.99945, 0.99975, sun) * 1.5;
  return c + uSunColor * (disc + pow(sun, 420.0) * 0.55 + pow(sun, 18.0) * mix(0.16, 0.4, uLamps));
}

// A layer of heaped clouds; seen from below or, high up, from above.
vec4 clouds(vec3 d) {
  float rise = ${real(CLOUD_BASE)} - uEye;
  if (rise * -d.z <= 0.0) return vec4(0.0);
  float reach = rise / -d.z; if (reach > 70000.0) return vec4(0.0);
  vec2 p = (uPlace + d.xy * reach) / 5200.0;
  float dense = smoothstep(0.5, 0.72, heap(p)), lit = smoothstep(-0.16, 0.2, heap(p) - heap(p + uSun.xy * 0.12));
  float fade = smoothstep(70000.0, 18000.0, reach) * smoothstep(0.0, 900.0, reach);
  return vec4(mix(uCloudShade, uCloud, 0.35 + 0.65 * lit), dense * 0.88 * fade);
}

void main() {
  vec2 s = vec2(gl_FragCoord.x * uPixel.x, uSize.y - gl_FragCoord.y * uPixel.y) - uCenter;
  vec3 d = uAxes * normalize(vec3(uF, s));
  vec3 c;
  if (d.z > 0.0) c = land(d);
  else {
    c = air(d);
    vec4 cloud = clouds(d); c = mix(c, cloud.rgb, cloud.a);
    vec2 hills = texture(uSkyline, vec2(atan(d.y, d.x) / 6.2831853, 0.5)).rg * 0.04;
    float soft = 1.2 * uPixel.y / uF, up = asin(clamp(-d.z, 0.0, 1.0));
    c = mix(c, uRange0, inside(up - hills.x, soft)); c = mix(c, uRange1, inside(up - hills.y, soft));
    c = mix(c, uHaze, 0.5 * (1.0 - smoothstep(0.0, 0.006, up)));
  }
  if (d.z > 0.0) { vec4 cloud = clouds(d); c = mix(c, cloud.rgb, cloud.a); }
  color = vec4(tone(c), 1.0);
}`;

/** Solids: one unit shape, many instances: footing (north, east, deep, wide), shape (height, round), two colors. */
export const SOLID_VERTEX = `#version 300 es
${COMMON}
layout(location=0) in vec3 corner; layout(location=1) in vec3 normal;
layout(location=2) in vec4 footing; layout(location=3) in vec2 shape;
layout(location=4) in vec3 wall; layout(location=5) in vec3 roof;
uniform vec3 uSun, uLight; uniform float uRound;
out vec3 paint; out float far;
void main() {
  vec3 at = vec3(footing.xy + (corner.xy - 0.5) * footing.zw, -corner.z * shape.x);
  vec3 body = transpose(uAxes) * (at - vec3(uPlace, -uEye));
  float lit = uRound > 0.5 ? 0.62 + 0.5 * corner.z : 0.62 + 0.42 * max(0.0, dot(normal, uSun)) + 0.1 * -normal.z;
  paint = (normal.z < -0.5 ? roof : wall) * lit * uLight; far = length(body);
  vec2 screen = vec2(body.y, body.z) * uF + (uCenter - 0.5 * uSize) * body.x;
  float near = 4.0;
  gl_Position = vec4(screen.x * 2.0 / uSize.x, -screen.y * 2.0 / uSize.y, body.x - 2.0 * near, body.x);
}`;

export const SOLID_FRAGMENT = `#version 300 es
precision highp float;
${COMMON}
in vec3 paint; in float far; out vec4 color;
void main() { color = vec4(tone(mix(paint, uHaze, hazeAt(far))), 1.0); }`;
