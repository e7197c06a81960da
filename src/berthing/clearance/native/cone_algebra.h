/* Second-order cones {(a, v) : |v| <= a} of p rows each: the algebra of Vandenberghe, The CVXOPT linear
   and quadratic cone program solvers, 2010, sections 2 and 4; as geometry/second_order_cone.py. */
#ifndef CONE_ALGEBRA_H
#define CONE_ALGEBRA_H
#include "shape.h"

static inline double inner(const double *a, const double *b, int n)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

static inline double tail_length(const double *a, int p) { return sqrt(inner(a + 1, a + 1, p - 1)); }

/* The root of a^2 - |v|^2, factored so that nothing cancels twice; 0 outside the cone. */
static inline double root_determinant(const double *a, int p)
{
    double tail = tail_length(a, p);
    return sqrt(larger((a[0] - tail) * (a[0] + tail), 0.0));
}

/* out = a o b. */
static inline void cone_product(const double *a, const double *b, int p, double *out)
{
    double head = inner(a, b, p);
    for (int i = 1; i < p; i++) out[i] = a[0] * b[i] + b[0] * a[i];
    out[0] = head;
}

/* The out with a o out = b, a inside the cone; out may be b. */
static inline void cone_quotient(const double *a, const double *b, int p, double *out)
{
    double root = root_determinant(a, p);
    double head = (a[0] * b[0] - inner(a + 1, b + 1, p - 1)) / (root * root);
    for (int i = 1; i < p; i++) out[i] = (b[i] - head * a[i]) / a[0];
    out[0] = head;
}

/* 1 over the longest step t with a + t d in the cone, a inside it; <= 0 where none leaves it. */
static inline double inverse_step(const double *a, const double *d, int p)
{
    double root = root_determinant(a, p);
    double along = (a[0] * d[0] - inner(a + 1, d + 1, p - 1)) / root;
    double pull = (along + d[0]) / (a[0] / root + 1.0), square = 0.0;
    for (int i = 1; i < p; i++) {
        double tail = d[i] - pull * a[i] / root;
        square += tail * tail;
    }
    return (sqrt(square) - along) / root;
}

/* w and the size of the symmetric W with W y = W^-1 s, that of Nesterov and Todd. */
static inline double scaling_of(const double *s, const double *y, int p, double *w)
{
    double root_s = root_determinant(s, p), root_y = root_determinant(y, p);
    double both = inner(s, y, p) / (root_s * root_y), gamma = sqrt(0.5 * (1.0 + both));
    for (int i = 0; i < p; i++)
        w[i] = (s[i] / root_s + (i == 0 ? y[i] : -y[i]) / root_y) / (2.0 * gamma);
    return sqrt(root_s / root_y);
}

/* v becomes W v for side 1, W^-1 v for side -1; its entries lie `step` apart. */
static inline void scale(const double *w, double size, int side, int p, double *v, int step)
{
    double across = 0.0, head = v[0];
    for (int i = 1; i < p; i++) across += side * w[i] * v[i * step];
    double f = side > 0 ? size : 1.0 / size, g = head + across / (1.0 + w[0]);
    v[0] = f * (w[0] * head + across);
    for (int i = 1; i < p; i++) v[i * step] = f * (v[i * step] + side * w[i] * g);
}
#endif
