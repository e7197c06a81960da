/* Sets {f <= 0} with one smooth f: superellipsoids, ellipsoids, balls and smoothed polytopes. */
#ifndef SMOOTH_H
#define SMOOTH_H
#include "smooth_box.h"

static inline double power(double x, int n)
{
    double y = 1.0;
    for (; n; n >>= 1, x *= x)
        if (n & 1) y *= x;
    return y;
}

static inline Level power_level(const double *r, const double *P, int dim, V x)
{
    Level l = {-1.0, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};
    for (int i = 0; i < dim; i++) {
        double u = at(x, i) / r[i];
        double low = power(u, (int)P[i] - 2);
        l.f += low * u * u;
        put(&l.g, i, P[i] * low * u / r[i]);
        l.h[i] = P[i] * (P[i] - 1.0) * low / (r[i] * r[i]);
    }
    return l;
}

/* ln of the sum of exp(Q a·x - Q b), safe against overflow. */
static inline Level exponential_level(const double *d, V x)
{
    int count = (int)d[0];
    const double *rows = d + 4, *offsets = rows + 3 * count;
    double largest = -INFINITY, total = 0.0;
    Level l = {0.0, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};
    for (int j = 0; j < count; j++) largest = larger(largest, dot(three(rows + 3 * j), x) - offsets[j]);
    for (int j = 0; j < count; j++) {
        V a = three(rows + 3 * j);
        double z = dot(a, x) - offsets[j] - largest;
        if (z < -45.0) continue; /* below rounding */
        double w = exp(z);
        total += w;
        l.g = plus(l.g, w, a);
        l.h[0] += w * a.x * a.x; l.h[1] += w * a.y * a.y; l.h[2] += w * a.z * a.z;
        l.h[3] += w * a.x * a.y; l.h[4] += w * a.x * a.z; l.h[5] += w * a.y * a.z;
    }
    l.f = largest + log(total);
    l.g = mul(1.0 / total, l.g);
    double gg[6] = {l.g.x * l.g.x, l.g.y * l.g.y, l.g.z * l.g.z,
                    l.g.x * l.g.y, l.g.x * l.g.z, l.g.y * l.g.z};
    for (int i = 0; i < 6; i++) l.h[i] = l.h[i] / total - gg[i];
    return l;
}

/* f and its slope along a ray. */
static inline double exponential_along(const double *d, V x, V ray, double *slope)
{
    int count = (int)d[0];
    const double *rows = d + 4, *offsets = rows + 3 * count;
    double largest = -INFINITY, total = 0.0, rise = 0.0;
    for (int j = 0; j < count; j++) largest = larger(largest, dot(three(rows + 3 * j), x) - offsets[j]);
    for (int j = 0; j < count; j++) {
        V a = three(rows + 3 * j);
        double z = dot(a, x) - offsets[j] - largest;
        if (z < -45.0) continue;
        double w = exp(z);
        total += w;
        rise += w * dot(a, ray);
    }
    *slope = rise / total;
    return largest + log(total);
}

static const double TWOS[3] = {2.0, 2.0, 2.0};

static inline int is_smooth(const Shape *s)
{
    return s->kind == ELLIPSOID || s->kind == SUPERELLIPSOID || s->kind == LOG_SUM_EXP ||
           s->kind == SMOOTHED_BOX;
}

static inline Level level_of(const Shape *s, V x)
{
    if (s->kind == LOG_SUM_EXP) return exponential_level(s->data, x);
    if (s->kind == SMOOTHED_BOX) return box_level(s->data, s->dim, x);
    return power_level(s->data, s->kind == ELLIPSOID ? TWOS : s->data + 3, s->dim, x);
}

static inline V middle(const Shape *s)
{
    if (s->kind == SMOOTHED_BOX) return three(s->data);
    return s->kind == LOG_SUM_EXP ? three(s->data + 1) : vec(0.0, 0.0, 0.0);
}

/* Along a ray through the origin: steps of ln c, c the factor of x. */
static inline V power_boundary(const double *r, const double *P, int dim, V x)
{
    for (int step = 0; step < 60; step++) {
        double total = 0.0, slope = 0.0, bend = 0.0;
        for (int i = 0; i < dim; i++) {
            double term = power(at(x, i) / r[i], (int)P[i]);
            total += term;
            slope += P[i] * term;
            bend += P[i] * P[i] * term;
        }
        if (!(total > 0.0) || !isfinite(total)) return x;
        double less = step_to_one(total, slope, bend);
        x = mul(fabs(less) < 1e-4 ? 1.0 - less * (1.0 - less * (0.5 - less / 6.0)) : exp(-less), x);
        if (fabs(less) < 1e-6) break; /* cubic */
    }
    return x;
}

/* Where the ray from the middle through x leaves the set. f is convex along it, so that Newton's
   method comes from outside and stays there. */
static inline V boundary(const Shape *s, V x)
{
    if (s->kind == SMOOTHED_BOX) return box_boundary(s->data, s->dim, x);
    if (s->kind != LOG_SUM_EXP)
        return power_boundary(s->data, s->kind == ELLIPSOID ? TWOS : s->data + 3, s->dim, x);
    V c = middle(s), ray = sub(x, c);
    double t = 1.0;
    for (int step = 0; step < 60; step++) {
        double slope, f = exponential_along(s->data, plus(c, t, ray), ray, &slope);
        double more = slope > 0.0 ? -f / slope : t;
        t += more;
        if (fabs(more) <= 1e-8 * t) break; /* quadratic */
    }
    return plus(c, t, ray);
}

static inline V hessian_times(const double *h, V v)
{
    return vec(h[0] * v.x + h[3] * v.y + h[4] * v.z, h[3] * v.x + h[1] * v.y + h[5] * v.z,
               h[4] * v.x + h[5] * v.y + h[2] * v.z);
}

/* One step uphill along the boundary towards n, halved until it pays; 0 if none does. */
static inline int uphill(const Shape *s, V n, V *x, const Level *l, V left, double rise)
{
    V e1, e2;
    double g = length(l->g), m = larger(rise / g, 1e-16);
    tangents(mul(1.0 / g, l->g), s->dim, &e1, &e2);
    double a = m * dot(e1, hessian_times(l->h, e1)), b = m * dot(e1, hessian_times(l->h, e2));
    double c = m * dot(e2, hessian_times(l->h, e2)), reg = 1e-14 * (a + c) + 1e-16 / s->size;
    a += reg;
    c += reg;
    double p = dot(left, e1), q = dot(left, e2), det = a * c - b * b;
    double i = det > 0.0 ? (c * p - b * q) / det : p / (a + c);
    double j = det > 0.0 ? (a * q - b * p) / det : q / (a + c);
    V step = plus(mul(i, e1), j, e2);
    double far = length(step), before = dot(n, *x);
    if (!isfinite(far)) return 0;
    if (far > s->size) step = mul(s->size / far, step);
    double gain = dot(left, step), noise = 1e-15 * (s->size + fabs(before));
    for (double part = 1.0; part > 1e-6; part *= 0.5) {
        V tried = boundary(s, plus(*x, part, step));
        if (dot(n, tried) >= before + 1e-4 * part * gain - noise) { *x = tried; return 1; }
    }
    return 0;
}

/* The support point along the unit vector n by Newton's method on the boundary. Every iterate is a
   member, and the tangent plane there bounds the set: h(n) <= n·x + |n - its part along ∇f| size. */
static inline Support climb(const Shape *s, V n, V start, double enough)
{
    V x = boundary(s, start);
    Level l = level_of(s, x);
    if (dot(n, l.g) <= 0.0) x = boundary(s, plus(middle(s), s->size, n));
    Support best = {x, INFINITY};
    for (int step = 0, stalled = 0; step < 60 && stalled < 3; step++) {
        l = level_of(s, x);
        double g = length(l.g), rise = dot(n, l.g) / g;
        V left = plus(n, -rise / g, l.g);
        double slack = length(left) * s->size + larger(-l.f / g, 0.0);
        stalled = slack < 0.5 * best.slack ? 0 : stalled + (best.slack < 1e-9 * s->size);
        if (slack < best.slack) best = (Support){x, slack};
        if (slack <= larger(1e-14 * s->size, enough) || !uphill(s, n, &x, &l, left, rise)) break;
    }
    return best;
}
#endif
