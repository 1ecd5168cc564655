// The equations of kernel_model.py in C++, as a batch of aircraft in lanes: what the compiled Python is measured against.
//
//     advance(x, held, numbers, count, h, steps)     arrays of rows, `count` aircraft in each, as fdes.kernel has them
//
// LANES is how many aircraft a vector holds; 1 makes the scalar build, with the C library's functions.
#include <algorithm>
#include <cmath>
#include <cstdint>

#ifndef LANES
#define LANES 8
#endif

namespace {

constexpr int STATES = 14, INPUTS = 4, NUMBERS = 36, STAGES = 4;
constexpr double G0 = 9.80665;

#if LANES == 1
using Real = double;
inline Real sqrt_(Real x) { return std::sqrt(x); }
inline Real exp_(Real x) { return std::exp(x); }
inline Real pow_(Real x, double y) { return std::pow(x, y); }
inline Real atan2_(Real y, Real x) { return std::atan2(y, x); }
#else
// Vectors of the compiler, one number of each aircraft. The functions are those of fdes.lanes.
typedef double Real __attribute__((vector_size(8 * LANES)));
typedef std::int64_t Whole __attribute__((vector_size(8 * LANES)));

inline Real sqrt_(Real x) {
    Real y;
    for (int i = 0; i < LANES; ++i) y[i] = std::sqrt(x[i]);
    return y;
}
inline Real floor_(Real x) {
    Real y;
    for (int i = 0; i < LANES; ++i) y[i] = std::floor(x[i]);
    return y;
}
inline Real number(double x) { return Real{} + x; }
inline Real abs_(Real x) { return x < 0.0 ? -x : x; }

inline Real exp_(Real x) {
    const Real k = floor_(x * 1.4426950408889634 + 0.5);
    const Real r = (x - k * 6.93147180369123816490e-01) - k * 1.90821492927058770002e-10;
    Real p = number(1.0 / 6227020800.0);
    p = p * r + 1.0 / 479001600.0;
    p = p * r + 1.0 / 39916800.0;
    p = p * r + 1.0 / 3628800.0;
    p = p * r + 1.0 / 362880.0;
    p = p * r + 1.0 / 40320.0;
    p = p * r + 1.0 / 5040.0;
    p = p * r + 1.0 / 720.0;
    p = p * r + 1.0 / 120.0;
    p = p * r + 1.0 / 24.0;
    p = p * r + 1.0 / 6.0;
    p = p * r + 0.5;
    p = p * r * r + r + 1.0;
    return p * (Real)((__builtin_convertvector(k, Whole) + 1023) << 52);
}

inline Real log_(Real x) {
    const Whole bits = (Whole)x;
    Real k = __builtin_convertvector((bits >> 52) - 1023, Real);
    Real m = (Real)((bits & 0xFFFFFFFFFFFFF) | (std::int64_t{1023} << 52));
    const Whole big = m > 1.4142135623730951;
    m = big ? 0.5 * m : m;
    k = big ? k + 1.0 : k;
    const Real f = m - 1.0, s = f / (m + 1.0), z = s * s;
    Real p = number(2.0 / 23.0);
    p = p * z + 2.0 / 21.0;
    p = p * z + 2.0 / 19.0;
    p = p * z + 2.0 / 17.0;
    p = p * z + 2.0 / 15.0;
    p = p * z + 2.0 / 13.0;
    p = p * z + 2.0 / 11.0;
    p = p * z + 2.0 / 9.0;
    p = p * z + 2.0 / 7.0;
    p = p * z + 2.0 / 5.0;
    p = p * z + 2.0 / 3.0;
    return k * 6.93147180369123816490e-01 - ((s * (f - z * p) - k * 1.90821492927058770002e-10) - f);
}

inline Real pow_(Real x, double y) { return exp_(y * log_(x)); }

inline Real atan2_(Real y, Real x) {
    const Real ax = abs_(x), ay = abs_(y);
    const Whole steep = ay > ax;
    const Real low = steep ? ax : ay, high = steep ? ay : ax;
    const Whole far = low > 0.41421356237309503 * high;
    const Real above = far ? low - high : low, below = far ? low + high : high;
    const Real t = above / (below > 0.0 ? below : number(1.0)), z = t * t;
    Real P = number(-8.750608600031904122785e-1);
    P = P * z - 1.615753718733365076637e1;
    P = P * z - 7.500855792314704667340e1;
    P = P * z - 1.228866684490136173410e2;
    P = P * z - 6.485021904942025371773e1;
    Real Q = z + 2.485846490142306297962e1;
    Q = Q * z + 1.650270098316988542046e2;
    Q = Q * z + 4.328810604912902668951e2;
    Q = Q * z + 4.853903996359136964868e2;
    Q = Q * z + 1.945506571482613964425e2;
    Real angle = t + t * (z * P / Q);
    angle = far ? 0.78539816339744830962 + (angle + 3.061616997868383e-17) : angle;
    angle = steep ? 1.57079632679489661923 - (angle - 6.123233995736766e-17) : angle;
    angle = x < 0.0 ? 3.14159265358979323846 - angle : angle;
    return y < 0.0 ? -angle : angle;
}
#endif

inline Real density(Real h) {
    const Real low = h < 11000.0 ? h : h * 0.0 + 11000.0;
    const Real troposphere = 1.225 * pow_(1.0 - 2.25576956e-5 * low, 4.25587981);
    const Real stratosphere = 0.36391803 * exp_(-1.57688485e-4 * (h - 11000.0));
    return h < 11000.0 ? troposphere : stratosphere;
}

struct Block {
    Real y[STATES], u[INPUTS], k[NUMBERS], x[STATES], d[STAGES][STATES];
};

inline void derivative(const Block& s, Real (&d)[STATES]) {
    const Real h = s.y[2], u = s.y[3], v = s.y[4], w = s.y[5];
    const Real e0 = s.y[6], e1 = s.y[7], e2 = s.y[8], e3 = s.y[9];
    const Real p = s.y[10], q = s.y[11], r = s.y[12], power = s.y[13];
    const Real de = s.u[0], da = s.u[1], dr = s.u[2], throttle = s.u[3];
    const Real m = s.k[0], S = s.k[1], b = s.k[2], c = s.k[3];
    const Real Ix = s.k[4], Iy = s.k[5], Iz = s.k[6], Ixz = s.k[7], T_max = s.k[8], lag = s.k[9];
    const auto a = [&](int i) { return s.k[10 + i]; };
    const Real level = sqrt_(u * u + w * w), V = sqrt_(u * u + v * v + w * w);
    const Real rho = density(h), qS = 0.5 * rho * V * V * S;
    const Real b2 = b / (2.0 * V), c2 = c / (2.0 * V);
    const Real alpha = atan2_(w, u), beta = atan2_(v, level), p_hat = b2 * p, q_hat = c2 * q, r_hat = b2 * r;
    const Real CL = a(0) + a(1) * alpha + a(2) * q_hat + a(3) * de;
    const Real CD = a(4) + a(5) * CL * CL + a(6) * de * de;
    const Real Cy = a(7) * beta + a(8) * p_hat + a(9) * r_hat + a(10) * da + a(11) * dr;
    const Real Cl = a(12) * beta + a(13) * p_hat + a(14) * r_hat + a(15) * da + a(16) * dr;
    const Real Cm = a(17) + a(18) * alpha + a(19) * q_hat + a(20) * de;
    const Real Cn = a(21) * beta + a(22) * p_hat + a(23) * r_hat + a(24) * da + a(25) * dr;
    const Real ca = u / level, sa = w / level;
    const Real X = qS * (CL * sa - CD * ca) + T_max * power * (rho / 1.225), Y = qS * Cy, Z = -qS * (CL * ca + CD * sa);
    const Real L = qS * b * Cl, M = qS * c * Cm, N = qS * b * Cn;
    const Real D = 1.0 / (Ix * Iz - Ixz * Ixz);
    const Real roll = L + (Iy - Iz) * q * r + Ixz * p * q, yaw = N + (Ix - Iy) * p * q - Ixz * q * r;
    const Real drift = 1.0 - (e0 * e0 + e1 * e1 + e2 * e2 + e3 * e3);
    const Real nx = e0 * e0 + e1 * e1 - e2 * e2 - e3 * e3, ny = 2.0 * (e1 * e2 - e0 * e3), nz = 2.0 * (e1 * e3 + e0 * e2);
    const Real ex = 2.0 * (e1 * e2 + e0 * e3), ey = e0 * e0 - e1 * e1 + e2 * e2 - e3 * e3, ez = 2.0 * (e2 * e3 - e0 * e1);
    const Real dx = 2.0 * (e1 * e3 - e0 * e2), dy = 2.0 * (e2 * e3 + e0 * e1), dz = e0 * e0 - e1 * e1 - e2 * e2 + e3 * e3;
    d[0] = nx * u + ny * v + nz * w;
    d[1] = ex * u + ey * v + ez * w;
    d[2] = -(dx * u + dy * v + dz * w);
    d[3] = r * v - q * w + G0 * dx + X / m;
    d[4] = p * w - r * u + G0 * dy + Y / m;
    d[5] = q * u - p * v + G0 * dz + Z / m;
    d[6] = 0.5 * (-p * e1 - q * e2 - r * e3) + drift * e0;
    d[7] = 0.5 * (p * e0 + r * e2 - q * e3) + drift * e1;
    d[8] = 0.5 * (q * e0 - r * e1 + p * e3) + drift * e2;
    d[9] = 0.5 * (r * e0 + q * e1 - p * e2) + drift * e3;
    d[10] = (Iz * roll + Ixz * yaw) * D;
    d[11] = (M + (Iz - Ix) * p * r - Ixz * (p * p - r * r)) / Iy;
    d[12] = (Ix * yaw + Ixz * roll) * D;
    d[13] = (throttle - power) / lag;
}

inline double& lane(Real& x, int l) { return reinterpret_cast<double*>(&x)[l]; }

}  // namespace

extern "C" void advance(double* x, const double* held, const double* numbers, std::int64_t count, double h, std::int64_t steps) {
    constexpr double A[STAGES] = {0.0, 0.5, 0.5, 1.0}, B[STAGES] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    Block s;
    for (std::int64_t start = 0; start < count; start += LANES) {
        const auto column = [&](int l) { return std::min<std::int64_t>(start + l, count - 1); };
        for (int l = 0; l < LANES; ++l) {
            for (int i = 0; i < STATES; ++i) lane(s.x[i], l) = x[i * count + column(l)];
            for (int i = 0; i < INPUTS; ++i) lane(s.u[i], l) = held[i * count + column(l)];
            for (int i = 0; i < NUMBERS; ++i) lane(s.k[i], l) = numbers[i * count + column(l)];
        }
        for (std::int64_t n = 0; n < steps; ++n) {
            for (int stage = 0; stage < STAGES; ++stage) {
                for (int i = 0; i < STATES; ++i)
                    s.y[i] = stage ? s.x[i] + (h * A[stage]) * s.d[stage - 1][i] : s.x[i];
                derivative(s, s.d[stage]);
            }
            for (int i = 0; i < STATES; ++i)
                s.x[i] += h * (B[0] * s.d[0][i] + B[1] * s.d[1][i] + B[2] * s.d[2][i] + B[3] * s.d[3][i]);
        }
        for (int l = 0; l < LANES && start + l < count; ++l)
            for (int i = 0; i < STATES; ++i) x[i * count + start + l] = lane(s.x[i], l);
    }
}
