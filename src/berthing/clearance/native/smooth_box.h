/* The smoothed polytope of a box, {x : sum of 2 k_i cosh(q_i (x_i - m_i)) <= 1}: its two faces of an
   axis share one exponential, and its support points have formulas. */
#ifndef SMOOTH_BOX_H
#define SMOOTH_BOX_H
#include "shape.h"

/* f, its gradient, and its Hessian as xx, yy, zz, xy, xz, yz. */
typedef struct { double f; V g; double h[6]; } Level;

static inline const double *exponents_of(const double *d) { return d + 3; }
static inline const double *weights_of(const double *d) { return d + 6; }
static inline const double *reaches_of(const double *d) { return d + 9; }

/* ln of the sum. Points lie within twice the box, so that nothing overflows. */
static inline Level box_level(const double *d, int dim, V x)
{
    const double *q = exponents_of(d), *k = weights_of(d);
    double total = 0.0, slope[3] = {0.0, 0.0, 0.0}, bend[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < dim; i++) {
        double e = exp(q[i] * (at(x, i) - d[i])), up = k[i] * e, down = k[i] / e;
        total += up + down;
        slope[i] = q[i] * (up - down);
        bend[i] = q[i] * q[i] * (up + down);
    }
    double part = 1.0 / total, a = part * slope[0], b = part * slope[1], c = part * slope[2];
    Level l = {log_near_one(total), {a, b, c},
               {part * bend[0] - a * a, part * bend[1] - b * b, part * bend[2] - c * c,
                -a * b, -a * c, -b * c}};
    return l;
}

/* Where the ray from the middle through x leaves the set: Newton's method on the convex f from the
   faces of the box, which lie outside, or from x, if that is nearer. */
static inline V box_boundary(const double *d, int dim, V x)
{
    const double *q = exponents_of(d), *k = weights_of(d), *reach = reaches_of(d);
    double ray[3], far = 0.0;
    for (int i = 0; i < dim; i++) {
        ray[i] = at(x, i) - d[i];
        far = larger(far, fabs(ray[i]) / reach[i]);
    }
    if (!(far > 0.0)) return x;
    double most = 1.0 / far, t = most < 1.0 ? most : 1.0;
    for (int step = 0; step < 60; step++) {
        double total = 0.0, slope = 0.0;
        for (int i = 0; i < dim; i++) {
            double u = q[i] * ray[i], e = exp(u * t), up = k[i] * e, down = k[i] / e;
            total += up + down;
            slope += u * (up - down);
        }
        double more = slope > 0.0 ? -log_near_one(total) * total / slope : most;
        if (!(t + more < most)) more = most - t;
        t += more;
        if (fabs(more) <= 1e-8 * t) break; /* quadratic */
    }
    V p = x;
    for (int i = 0; i < dim; i++) put(&p, i, d[i] + t * ray[i]);
    return p;
}

/* With n = L times the gradient of the sum, d_i = |n_i|/q_i and u_i = q_i (x_i - m_i), the terms of
   an axis differ by d_i/L and have the product k_i^2, so that their sum is
   sqrt(d_i^2 + 4 k_i^2 L^2)/L. All sums make 1: an equation for L, convex and falling, which
   Newton's method solves from below. */
static inline V box_point(const double *d, int dim, V n)
{
    const double *q = exponents_of(d), *k = weights_of(d);
    double flat[3], sum[3], L = 0.0;
    for (int i = 0; i < dim; i++) {
        flat[i] = fabs(at(n, i)) / q[i];
        L += flat[i];
    }
    if (!(L > 0.0)) return vec(d[0], d[1], dim == 3 ? d[2] : 0.0);
    for (int step = 0; step < 60; step++) {
        double total = 0.0, slope = 0.0;
        for (int i = 0; i < dim; i++) {
            double twice = 2.0 * k[i];
            sum[i] = sqrt(flat[i] * flat[i] + twice * twice * L * L);
            total += sum[i];
            slope += sum[i] > 0.0 ? twice * twice * L / sum[i] : 0.0;
        }
        double more = (total - L) / (1.0 - slope);
        L += more;
        if (more <= 1e-9 * L) break; /* quadratic */
    }
    V p = vec(0.0, 0.0, 0.0);
    for (int i = 0; i < dim; i++) {
        double twice = 2.0 * k[i] * L, s = sqrt(flat[i] * flat[i] + twice * twice);
        put(&p, i, d[i] + copysign(log((flat[i] + s) / twice) / q[i], at(n, i)));
    }
    return p;
}
#endif
