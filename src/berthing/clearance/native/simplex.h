/* The nearest point to the origin of a hull of at most four points y = (r + R b) - a. */
#ifndef SIMPLEX_H
#define SIMPLEX_H
#include "support.h"

/* Two cores: B's frame lies at R, r in A's. `size` is what tolerances refer to, and support points
   are exact to `noise`. */
typedef struct {
    Shape a, b;
    M R;
    V r;
    double size, noise, slack; /* what support points may fall short by, where a search finds them */
    int dim;
    Memory memory_a, memory_b;
} Pair;

/* a in A's frame, b in B's frame. */
typedef struct { V a, b, y; } Vertex;

typedef struct {
    Vertex p[4];
    double w[4];
    int n;
} Simplex;

static inline V difference(const Pair *pair, V a, V b)
{
    return sub(add(pair->r, turn(&pair->R, b)), a);
}

/* The member of B - A that is lowest along the unit vector n, and the plane bound of n. */
static Vertex lowest(Pair *pair, V n, double *bound)
{
    Support a = support(&pair->a, n, &pair->memory_a, pair->slack);
    Support b = support(&pair->b, mul(-1.0, unturn(&pair->R, n)), &pair->memory_b, pair->slack);
    Vertex v = {a.point, b.point, difference(pair, a.point, b.point)};
    *bound = dot(n, v.y) - a.slack - b.slack;
    return v;
}

typedef struct { double square; int n, index[4]; double w[4]; } Nearest;

static inline void consider(Nearest *best, const Simplex *s, int n, const int *index, const double *w)
{
    V v = vec(0.0, 0.0, 0.0);
    for (int i = 0; i < n; i++) v = plus(v, w[i], s->p[index[i]].y);
    double square = dot(v, v);
    if (square < best->square) {
        best->square = square;
        best->n = n;
        for (int i = 0; i < n; i++) { best->index[i] = index[i]; best->w[i] = w[i]; }
    }
}

static inline void consider_edge(Nearest *best, const Simplex *s, int i, int j)
{
    V p = s->p[i].y, e = sub(s->p[j].y, p);
    double ee = dot(e, e), t = -dot(e, p);
    if (t <= 0.0 || t >= ee) return;
    int index[2] = {i, j};
    double w[2] = {1.0 - t / ee, t / ee};
    consider(best, s, 2, index, w);
}

static inline double square_between(const Simplex *s, int i, int j)
{
    V e = sub(s->p[i].y, s->p[j].y);
    return dot(e, e);
}

/* About the corner opposite the longest edge: slivers are solved as exactly from there as edges. */
static inline void consider_face(Nearest *best, const Simplex *s, int i, int j, int k)
{
    double ij = square_between(s, i, j), jk = square_between(s, j, k), ki = square_between(s, k, i);
    if (ij > jk && ij > ki) { int t = i; i = k; k = t; }
    else if (ki > jk) { int t = i; i = j; j = t; }
    V p = s->p[i].y, e = sub(s->p[j].y, p), f = sub(s->p[k].y, p), m = cross(e, f);
    double ee = dot(e, e), ff = dot(f, f), ef = dot(e, f), mm = dot(m, m);
    double ep = -dot(e, p), fp = -dot(f, p);
    double u = ff * ep - ef * fp, v = ee * fp - ef * ep;
    if (!(mm > 0.0) || u <= 0.0 || v <= 0.0 || u + v >= mm) return;
    int index[3] = {i, j, k};
    double w[3] = {1.0 - (u + v) / mm, u / mm, v / mm};
    consider(best, s, 3, index, w);
}

static inline double volume(V a, V b, V c) { return dot(a, cross(b, c)); }

/* Whether the origin lies in the tetrahedron. */
static int encloses(const Simplex *s)
{
    V a = s->p[0].y, b = s->p[1].y, c = s->p[2].y, d = s->p[3].y;
    double whole = volume(sub(b, a), sub(c, a), sub(d, a));
    double w[4] = {volume(b, c, d), -volume(a, c, d), volume(a, b, d), -volume(a, b, c)};
    for (int i = 0; i < 4; i++)
        if (w[i] * whole < 0.0) return 0;
    return whole != 0.0;
}

/* Keeps the members that the nearest point needs, with their weights; among all faces, so that
   rounding cannot choose a worse one. Returns 1 where the hull has the origin inside. */
static int reduce(Simplex *s)
{
    Nearest best = {INFINITY, 0, {0}, {0.0}};
    double one = 1.0;
    if (s->n == 4 && encloses(s)) return 1;
    for (int i = 0; i < s->n; i++) {
        consider(&best, s, 1, &i, &one);
        for (int j = i + 1; j < s->n; j++) {
            consider_edge(&best, s, i, j);
            for (int k = j + 1; k < s->n; k++) consider_face(&best, s, i, j, k);
        }
    }
    Simplex kept = {.n = best.n};
    for (int i = 0; i < best.n; i++) { kept.p[i] = s->p[best.index[i]]; kept.w[i] = best.w[i]; }
    *s = kept;
    return 0;
}

static inline V combined_a(const Simplex *s)
{
    V v = vec(0.0, 0.0, 0.0);
    for (int i = 0; i < s->n; i++) v = plus(v, s->w[i], s->p[i].a);
    return v;
}
static inline V combined_b(const Simplex *s)
{
    V v = vec(0.0, 0.0, 0.0);
    for (int i = 0; i < s->n; i++) v = plus(v, s->w[i], s->p[i].b);
    return v;
}
static inline V nearest(const Simplex *s)
{
    V v = vec(0.0, 0.0, 0.0);
    for (int i = 0; i < s->n; i++) v = plus(v, s->w[i], s->p[i].y);
    return v;
}
#endif
