/* Convex sets as numbers, and the support points of those with closed formulas.

   A set is a core and a pad: all within the distance `pad` of the core. The numbers are
   kind, pad, size, then those named beside the kind. `size` is a length that no two points of the
   core are farther apart than. */
#ifndef SHAPE_H
#define SHAPE_H
#include "vec.h"

enum {
    POINT,
    SEGMENT,        /* axis, half length */
    BOX,            /* half extents */
    ELLIPSOID,      /* semi axes */
    CYLINDER,       /* axis, radius, half length */
    FRUSTUM,        /* axis, radius at the lower end, at the upper end, half length */
    POLYTOPE,       /* count, vertices */
    SUPERELLIPSOID, /* reaches, exponents */
    LOG_SUM_EXP,    /* count, centre, rows Q a, offsets Q b */
    HALF_SPACE,     /* outward unit normal, offset */
    SMOOTHED_BOX,   /* middle m, exponents q, weights k, reaches (-ln k)/q */
    CONIC           /* counts, unit, reach, G, h: see conic.h */
};

typedef struct {
    int kind, dim;
    double pad, size;
    const double *data;
} Shape;

/* The last support point of a set, where the next search begins. */
typedef struct { V point; int known; } Memory;

/* h(n) <= n·point + slack for the core; the slack is 0 where a closed formula is used. */
typedef struct { V point; double slack; } Support;

static inline Shape shape_from(const double *numbers, int dim)
{
    Shape s = {(int)numbers[0], dim, numbers[1], numbers[2], numbers + 3};
    return s;
}

static inline V three(const double *d) { return vec(d[0], d[1], d[2]); }
static inline double signed_by(double size, double n) { return n < 0.0 ? -size : size; }

static inline double larger(double a, double b) { return a > b ? a : b; }

static inline V across_axis(V n, int axis)
{
    put(&n, axis, 0.0);
    return unit_or(n, vec(0.0, 0.0, 0.0));
}

/* The core is another convex set and all within this distance of it: the least radius of curvature
   of an ellipsoid, less what rounding takes. */
static double roundness(const Shape *s)
{
    if (s->kind != ELLIPSOID) return 0.0;
    double least = s->data[0], most = least;
    for (int i = 1; i < s->dim; i++) {
        most = larger(most, s->data[i]);
        if (s->data[i] < least) least = s->data[i];
    }
    return (1.0 - 1e-12) * least * least / most;
}

static inline V ellipsoid_point(const double *a, V n)
{
    V scaled = vec(a[0] * n.x, a[1] * n.y, a[2] * n.z);
    V u = unit_or(scaled, vec(0.0, 0.0, 0.0));
    return vec(a[0] * u.x, a[1] * u.y, a[2] * u.z);
}

static inline V frustum_point(const double *d, V n)
{
    int axis = (int)d[0];
    double along = at(n, axis), lower = d[1], upper = d[2], half = d[3];
    V flat = n;
    put(&flat, axis, 0.0);
    int up = half * along + 0.5 * (upper - lower) * length(flat) > 0.0;
    V p = mul(up ? upper : lower, unit_or(flat, vec(0.0, 0.0, 0.0)));
    put(&p, axis, up ? half : -half);
    return p;
}

static inline V polytope_point(const double *d, V n)
{
    int count = (int)d[0], best = 0;
    double most = -INFINITY;
    for (int i = 0; i < count; i++) {
        double value = dot(n, three(d + 1 + 3 * i));
        if (value > most) { most = value; best = i; }
    }
    return three(d + 1 + 3 * best);
}

/* Exact about 1, where boundaries are. */
static inline double log_near_one(double x)
{
    double d = x - 1.0;
    return fabs(d) < 1e-4 ? d * (1.0 - d * (0.5 - d * (1.0 / 3.0 - 0.25 * d))) : log(x);
}

/* The step that makes the logarithm of a sum of exponentials of -q s vanish, from the sum and those
   with the factors q and q^2: Halley's, or far from there Newton's, which cannot go astray on what is
   convex and falls. */
static inline double step_to_one(double total, double slope, double bend)
{
    double g = log_near_one(total), mean = slope / total;
    return fabs(g) > 0.5 ? g / mean : g / larger(mean - 0.5 * g * (bend / slope - mean), 0.5 * mean);
}

/* By the multiplier m of max n·x: (x_i/r_i)^(P_i - 1) = k_i/m with k_i = |n_i| r_i/P_i, and the
   terms (x_i/r_i)^P_i = (k_i/m)^q_i, q_i = P_i/(P_i - 1), make 1: an equation for ln m, whose
   logarithm is linear where all exponents are the same. */
static inline V superellipsoid_point(const double *d, V n)
{
    const double *r = d, *P = d + 3;
    double root[3], whole[3], s = 0.0, largest = 0.0, fall = 1.0;
    for (int i = 0; i < 3; i++) {
        whole[i] = fabs(at(n, i)) * r[i] / P[i];
        largest = larger(largest, whole[i]);
    }
    if (!(largest > 0.0)) return vec(0.0, 0.0, 0.0);
    for (int i = 0; i < 3; i++) {
        double k = whole[i] / largest;
        root[i] = P[i] == 2.0 || k == 0.0 || k == 1.0 ? k : exp(log(k) / (P[i] - 1.0));
        whole[i] = k * root[i];
    }
    int same = P[0] == P[1] && P[1] == P[2];
    for (int step = 0; step < 40; step++) {
        double total = 0.0, slope = 0.0, bend = 0.0;
        for (int i = 0; i < 3; i++) {
            double q = P[i] / (P[i] - 1.0);
            if (s > 0.0 && (i == 0 || P[i] != P[i - 1])) fall = exp(-q * s);
            total += whole[i] * fall;
            slope += q * whole[i] * fall;
            bend += q * q * whole[i] * fall;
        }
        double more = step_to_one(total, slope, bend);
        s += more;
        if (same || fabs(more) <= 1e-5) break; /* cubic */
    }
    V p;
    for (int i = 0; i < 3; i++) {
        if (i == 0 || P[i] != P[i - 1]) fall = exp(-s / (P[i] - 1.0));
        put(&p, i, copysign(r[i] * root[i] * fall, at(n, i)));
    }
    return p;
}
#endif
