/* States of vehicles, seven numbers each: position, and attitude as a quaternion, scalar first; and
   strides between them, six numbers each: translation, and rotation vector in inertial axes. */
#ifndef STRIDE_H
#define STRIDE_H
#include "vec.h"

enum { STATE = 7, STRIDE = 6 };

typedef struct { double w; V v; } Q;

static inline Q quaternion_at(const double *x) { return (Q){x[3], vec(x[4], x[5], x[6])}; }
static inline Q times(Q a, Q b)
{
    return (Q){a.w * b.w - dot(a.v, b.v),
               add(plus(mul(a.w, b.v), b.w, a.v), cross(a.v, b.v))};
}

static inline M turn_of(Q q)
{
    double w = q.w, x = q.v.x, y = q.v.y, z = q.v.z;
    return (M){{1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)},
               {2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)},
               {2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)}};
}

/* From x to y, the shorter way around. */
static void stride_between(long count, const double *x, const double *y, double *out)
{
    for (long i = 0; i < count; i++, x += STATE, y += STATE, out += STRIDE) {
        Q back = quaternion_at(x);
        back.v = mul(-1.0, back.v);
        Q q = times(quaternion_at(y), back);
        if (q.w < 0.0) q = (Q){-q.w, mul(-1.0, q.v)};
        double half = length(q.v), share = half > 1e-12 ? 2.0 * atan2(half, q.w) / half : 2.0;
        for (int k = 0; k < 3; k++) {
            out[k] = y[k] - x[k];
            out[3 + k] = share * at(q.v, k);
        }
    }
}

/* x after that share of a stride; x and out may be one. */
static void move_by(long count, const double *x, const double *by, double share, double *out)
{
    for (long i = 0; i < count; i++, x += STATE, by += STRIDE, out += STATE) {
        V r = mul(share, vec(by[3], by[4], by[5]));
        double half = 0.5 * length(r), s = half > 1e-12 ? 0.5 * sin(half) / half : 0.5;
        Q q = times((Q){cos(half), mul(s, r)}, quaternion_at(x));
        double size = sqrt(q.w * q.w + dot(q.v, q.v));
        for (int k = 0; k < 3; k++) {
            out[k] = x[k] + share * by[k];
            out[4 + k] = at(q.v, k) / size;
        }
        out[3] = q.w / size;
    }
}

/* In metres: turns count by the arm of each vehicle. */
static double stride_length(long count, const double *by, const double *arm)
{
    double total = 0.0;
    for (long i = 0; i < count; i++, by += STRIDE)
        for (int k = 0; k < 3; k++)
            total += by[k] * by[k] + arm[i] * arm[i] * by[3 + k] * by[3 + k];
    return sqrt(total);
}
#endif
