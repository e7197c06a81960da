/* Near the best normal the depth needs no polytope: how the sets bend there proves it.

   Let w on A and p on B be the closest points of sets that overlap by d, n their normal, K the
   curvature of a set there, seen along two tangents. Each set of one smooth function, a sum of
   functions of one coordinate each, has members

       x + u - q n_x,    q = u·(K + e) u / 2,    |u| <= U,    n_x its outward normal,

   if the excess e outweighs what a quadratic leaves out: with n = g/|g| and s the displacement, the
   function there is at most g·s + sum of f_i'' s_i^2 / 2 + C_i |s_i|^3 / 6, C_i bounding |f_i'''| as far
   as s_i reaches. As u lies across n, |u_i| <= |u| sqrt(1 - n_i^2), and what is left of it is

       |u|^2 (k |u| X/2 + k^2 |u|^2 Y/8 + |u| Z/6),    k the largest of K + e,
       X = sum of f_i'' c_i |n_i|, Y = sum of f_i'' n_i^2, Z = sum of C_i (c_i + k |u| |n_i|/2)^3,

   c_i = sqrt(1 - n_i^2), all over |g|: which grows with |u|, so that to compare it at U with e/2 is
   enough. A displacement t of B - A across n is split as P t for B and (P - 1) t for A. Then B - A
   has members y + t - q n', n' its outward normal at y = d n', whose q is at most |t|^2/(2 d) if the
   largest of P'(K_B + e)P + (1 - P)'(K_A + e)(1 - P) is at most 1/d: they lie no nearer to the origin
   than d, and fill all directions that differ from n' by at most the arc tangent of U/d. */
#ifndef CAP_H
#define CAP_H
#include "newton.h"

/* All directions whose cosine with `axis` is at least `cosine`: there B - A reaches as far as
   -`lower` from the origin. */
typedef struct { V axis; double cosine, sine, lower; } Cap;

static const Cap NO_CAP = {{0.0, 0.0, 0.0}, 2.0, 0.0, 0.0};

/* Excess curvatures are no more than so many by the size: more would make the members wander. */
static const double MOST_EXCESS = 8.0;
/* Of the excess, which leaves some to rounding. */
static const double SPARED = 0.99;
/* In terms of the size: a cap that reaches less far is none. */
static const double LEAST_CAP = 1e-3;
/* In terms of the size: what rounding leaves of closest points. */
static const double BLUR = 1e-13;

static inline int is_separable(const Shape *s)
{
    return s->kind == ELLIPSOID || s->kind == SUPERELLIPSOID || s->kind == SMOOTHED_BOX;
}

/* Bounds |f_i'''| up to `far` to both sides of x_i. */
static double third(const Shape *s, V x, int i, double far)
{
    const double *d = s->data;
    if (s->kind == SMOOTHED_BOX) {
        double q = exponents_of(d)[i];
        return q * q * q * weights_of(d)[i] * exp(q * (fabs(at(x, i) - d[i]) + far));
    }
    double P = s->kind == ELLIPSOID ? 2.0 : d[3 + i], r = d[i];
    if (P == 2.0) return 0.0;
    return P * (P - 1.0) * (P - 2.0) * power((fabs(at(x, i)) + far) / r, (int)P - 3) / (r * r * r);
}

/* U for the largest curvature k and the excess e that k includes. */
static double bend_reach(const Shape *s, V x, const Level *l, double k, double e)
{
    double g = length(l->g), second[3], n[3], c[3], X = 0.0, Y = 0.0;
    for (int i = 0; i < 3; i++) {
        n[i] = fabs(at(l->g, i)) / g;
        c[i] = sqrt(larger(1.0 - n[i] * n[i], 0.0));
        second[i] = l->h[i];
        /* The level of a smoothed box is the logarithm of the sum. */
        if (s->kind == SMOOTHED_BOX) second[i] += at(l->g, i) * at(l->g, i);
        X += second[i] * c[i] * n[i];
        Y += second[i] * n[i] * n[i];
    }
    double U = 0.5 * s->size, least = LEAST_CAP * s->size;
    while (U > least) {
        double Z = 0.0, q = 0.5 * k * U;
        for (int i = 0; i < 3; i++) {
            double part = c[i] + q * n[i];
            Z += third(s, x, i, part * U) * part * part * part;
        }
        double left = (q * X + 0.5 * q * q * Y + U * Z / 6.0) / g, part = 0.5 * e / left;
        if (part >= 1.0) return U;
        U *= part > 0.5 ? part : 0.6;
    }
    return 0.0;
}

/* A two-by-two matrix by rows. */
typedef struct { double a, b, c, d; } Two;

static Two two_times(Two p, Two q)
{
    return (Two){p.a * q.a + p.b * q.c, p.a * q.b + p.b * q.d, p.c * q.a + p.d * q.c, p.c * q.b + p.d * q.d};
}

static Two flipped(Two p) { return (Two){p.a, p.c, p.b, p.d}; }

/* Of a symmetric matrix. */
static double largest_of(Two p)
{
    double half = 0.5 * (p.a - p.d), off = 0.5 * (p.b + p.c);
    return 0.5 * (p.a + p.d) + sqrt(half * half + off * off);
}

/* The square of its norm. */
static double stretch(Two p) { return largest_of(two_times(flipped(p), p)); }

/* P = K_A/(K_A + K_B) gives the least curvature; faces that are both flat share. */
static Two share(Two A, Two B, double size)
{
    double little = 1e-6 / size, a = A.a + B.a + 2.0 * little, d = A.d + B.d + 2.0 * little, b = A.b + B.b;
    double det = a * d - b * b;
    Two own = {A.a + little, A.b, A.c, A.d + little}, inverse = {d / det, -b / det, -b / det, a / det};
    return two_times(own, inverse);
}

static Two bend_at(const Level *l, V s1, V s2)
{
    double k[3];
    curvature(l, s1, s2, k);
    return (Two){k[0], k[1], k[1], k[2]};
}

/* About what Newton's method ended at, by the answer. */
static Cap cap_of(const Pair *pair, const Answer *at)
{
    const Shape *a = &pair->a, *b = &pair->b;
    double depth = -at->lower;
    if (!is_separable(a) || !is_separable(b) || pair->dim != 3 || !(depth > 0.0)) return NO_CAP;
    Level la = level_of(a, at->a), lb = level_of(b, at->b);
    V s1, s2;
    tangents(at->normal, 3, &s1, &s2);
    Two A = bend_at(&la, s1, s2), B = bend_at(&lb, unturn(&pair->R, s1), unturn(&pair->R, s2));
    Two P = share(A, B, pair->size), rest = {1.0 - P.a, -P.b, -P.c, 1.0 - P.d};
    Two from_a = two_times(flipped(rest), two_times(A, rest)), from_b = two_times(flipped(P), two_times(B, P));
    Two both = {from_a.a + from_b.a, from_a.b + from_b.b, from_a.c + from_b.c, from_a.d + from_b.d};
    double by_a = stretch(rest), by_b = stretch(P);
    double e = SPARED * (1.0 / depth - largest_of(both)) / (by_a + by_b);
    e = fmin(e, MOST_EXCESS / pair->size);
    if (!(e > 0.0)) return NO_CAP;
    double far_a = bend_reach(a, at->a, &la, largest_of(A) + e, e) / sqrt(by_a);
    double far_b = bend_reach(b, at->b, &lb, largest_of(B) + e, e) / sqrt(by_b);
    double far = fmin(far_a, far_b), whole = sqrt(far * far + depth * depth);
    if (!(far > 0.0)) return NO_CAP;
    return (Cap){mul(-1.0, at->normal), depth / whole, far / whole, at->lower + BLUR * pair->size};
}

/* Whether the part of the face with the normal m and the offset d > 0 that is nearer to the origin
   than `depth` lies in the cap's directions: those within arc cosine d/depth of m. */
static int in_cap(const Cap *cap, V m, double d, double depth)
{
    double x = dot(m, cap->axis), y = d / depth;
    if (!(d > 0.0) || x <= cap->cosine || y <= cap->cosine) return 0;
    if (y >= 1.0) return 1;
    double sines = sqrt(larger((1.0 - x * x) * (1.0 - y * y), 0.0));
    return x * y - sines >= cap->cosine;
}
#endif
