/* The best normal near a good one, for sets that overlap.

   At the best normal n the lowest member y of B - A lies along n. Near an axis the bound hardly tells
   one normal from the next, and the part of y across n does: Newton on that part, by differences over
   two tangents. Across an edge y jumps; the normal stays on that kink, only the other tangent counts,
   and y is the point of the edge between the two members that lies along n. */
#ifndef ASCEND_H
#define ASCEND_H
#include "simplex.h"

static const double TURN = 1e-6, ROUND = 1e-5, KINK = 1e3;
enum { MOST_CLIMBS = 8 };

static V across_of(V y, V n) { return plus(y, -dot(y, n), n); }

/* The lowest member and what is left of it across n; `bend` are two directions across n, `rate` how far
   that moves along each as n turns (m/rad). */
typedef struct { V n, a, b, off, bend[2]; double rate[2], bound; int kinks; } Foot;

static Vertex turned(Pair *pair, V n, V s, double angle, double *bound)
{
    return lowest(pair, unit_or(plus(n, angle, s), n), bound);
}

static V mixed(double part, V p, V q) { return plus(mul(1.0 - part, q), part, p); }

/* On a kink along e: the point between the members to both sides that has nothing along e. */
static int on_kink(Pair *pair, V n, V e, Vertex *v)
{
    double bound;
    V along = unit_or(across_of(e, n), e);
    Vertex high = turned(pair, n, along, TURN, &bound), low = turned(pair, n, along, -TURN, &bound);
    double above = dot(high.y, along), below = dot(low.y, along), part = below / (below - above);
    if (!(part >= 0.0 && part <= 1.0)) return 0;
    *v = (Vertex){mixed(part, high.a, low.a), mixed(part, high.b, low.b), mixed(part, high.y, low.y)};
    return 1;
}

/* Where the bounds of the members to both sides are one: a step round leaves the kink by its square. */
static V onto_kink(Pair *pair, V n, V e)
{
    double up, down;
    Vertex high = turned(pair, n, e, TURN, &up), low = turned(pair, n, e, -TURN, &down);
    double above = dot(high.y, e), below = dot(low.y, e);
    double angle = (down - up + TURN * (below + above)) / (above - below);
    return fabs(angle) <= TURN ? unit_or(plus(n, angle, e), n) : n;
}

static Foot foot_on_kink(Pair *pair, Foot f, V e)
{
    f.n = onto_kink(pair, f.n, e);
    e = unit_or(across_of(e, f.n), e);
    lowest(pair, f.n, &f.bound);
    V t = cross(f.n, e), up = unit_or(plus(f.n, ROUND, t), f.n), down = unit_or(plus(f.n, -ROUND, t), f.n);
    Vertex v, high, low;
    f.bend[0] = e;
    f.bend[1] = t;
    f.rate[0] = INFINITY;
    f.kinks = 2;
    if (!on_kink(pair, f.n, e, &v) || !on_kink(pair, up, e, &high) || !on_kink(pair, down, e, &low)) return f;
    f.rate[1] = 0.5 / ROUND * dot(t, sub(across_of(high.y, up), across_of(low.y, down)));
    if (fabs(f.rate[1]) > KINK * pair->size) return f;
    f.kinks = 1;
    f.a = v.a;
    f.b = v.b;
    f.off = across_of(v.y, f.n);
    return f;
}

static Foot foot_at(Pair *pair, V n)
{
    Foot f = {.n = n};
    Vertex v = lowest(pair, n, &f.bound);
    V s[2], row[2];
    f.a = v.a;
    f.b = v.b;
    f.off = across_of(v.y, n);
    tangents(n, 3, &s[0], &s[1]);
    for (int k = 0; k < 2; k++) {
        V up = unit_or(plus(n, TURN, s[k]), n), down = unit_or(plus(n, -TURN, s[k]), n);
        double bound;
        V jump = sub(across_of(turned(pair, n, s[k], TURN, &bound).y, up),
                     across_of(turned(pair, n, s[k], -TURN, &bound).y, down));
        row[k] = mul(0.5 / TURN, jump);
        if (length(row[k]) > KINK * pair->size)
            return foot_on_kink(pair, f, unit_or(across_of(jump, n), s[k]));
    }
    /* Symmetric but for rounding: its directions. */
    double p = dot(s[0], row[0]), r = dot(s[1], row[1]);
    double q = 0.5 * (dot(s[1], row[0]) + dot(s[0], row[1]));
    double angle = 0.5 * atan2(2.0 * q, p - r), c = cos(angle), d = sin(angle);
    f.bend[0] = plus(mul(c, s[0]), d, s[1]);
    f.bend[1] = plus(mul(-d, s[0]), c, s[1]);
    f.rate[0] = p * c * c + 2.0 * q * c * d + r * d * d;
    f.rate[1] = p * d * d - 2.0 * q * c * d + r * c * c;
    return f;
}

/* 1 where `n` is improved: with its bound, and witnesses that lie along it. */
static int ascend(Pair *pair, double tolerance, V *n, double *bound, V *a, V *b)
{
    Foot f = foot_at(pair, *n);
    for (int i = 0; i < MOST_CLIMBS && f.kinks < 2 && length(f.off) > 1e-13 * pair->size; i++) {
        double x = -dot(f.off, f.bend[0]) / f.rate[0], y = -dot(f.off, f.bend[1]) / f.rate[1];
        if (!(x * x + y * y <= 0.01)) break;
        Foot g = foot_at(pair, unit_or(plus(plus(f.n, x, f.bend[0]), y, f.bend[1]), f.n));
        if (!(length(g.off) <= 0.5 * length(f.off)) || g.kinks > 1) break;
        f = g;
    }
    if (f.kinks > 1 || length(f.off) > 1e-8 * pair->size || !(f.bound >= *bound - tolerance)) return 0;
    *n = f.n;
    *bound = f.bound;
    *a = f.a;
    *b = f.b;
    return 1;
}
#endif
