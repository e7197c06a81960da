/* The best normal near a good one.

   At the best normal n the lowest member y of B - A lies along n. Near an axis the bound hardly tells
   one normal from the next, and the part of y across n does: Newton on that part, by differences over
   two tangents. Across an edge y jumps: see kink.h. There the normal stays on the kink, only the other
   tangent counts, and y is the point between the two members that lies along n. */
#ifndef ASCEND_H
#define ASCEND_H
#include "kink.h"

enum { MOST_CLIMBS = 8 };

/* The lowest member and what is left of it across n; `bend` are two directions across n, `rate` how far
   that moves along each as n turns (m/rad). */
typedef struct { V n, a, b, off, bend[2]; double rate[2], bound; int kinks; } Foot;

static void stand_on(Foot *f, const Vertex *v)
{
    f->a = v->a;
    f->b = v->b;
    f->off = across_of(v->y, f->n);
}

/* How far what is left moves along t, on a kink, as n turns towards t; infinity where it jumps. */
static double rate_on_kink(Pair *pair, const Kink *k, V t)
{
    for (double step = ROUND; step > FINE; step *= 1e-2) {
        Kink up, down;
        if (!find_kink(pair, turned_to(k->n, t, step), k->e, TURN, &up)) break;
        if (!find_kink(pair, turned_to(k->n, t, -step), k->e, TURN, &down)) break;
        V moved = sub(across_of(between(&up).y, up.n), across_of(between(&down).y, down.n));
        double rate = 0.5 / step * dot(t, moved);
        if (fabs(rate) <= (step == ROUND ? STEEP : JUMP) * pair->size) return rate;
    }
    return INFINITY;
}

static Foot foot_on_kink(Pair *pair, const Kink *k)
{
    V t = cross(k->n, k->e);
    Vertex v = between(k);
    Foot f = {.n = k->n, .bend = {k->e, t}, .rate = {INFINITY, INFINITY}, .kinks = 1};
    lowest(pair, f.n, &f.bound);
    stand_on(&f, &v);
    if (pair->dim == 3) f.rate[1] = rate_on_kink(pair, k, t);
    if (pair->dim == 3 && !isfinite(f.rate[1])) f.kinks = 2;
    return f;
}

static V moved_by(Pair *pair, V n, V s, double angle)
{
    double bound;
    V up = turned_to(n, s, angle), down = turned_to(n, s, -angle);
    return sub(across_of(lowest(pair, up, &bound).y, up), across_of(lowest(pair, down, &bound).y, down));
}

/* Symmetric but for rounding: its directions. */
static void bend_of(Foot *f, const V *s, const V *row)
{
    double p = dot(s[0], row[0]), r = dot(s[1], row[1]);
    double q = 0.5 * (dot(s[1], row[0]) + dot(s[0], row[1]));
    double angle = 0.5 * atan2(2.0 * q, p - r), c = cos(angle), d = sin(angle);
    f->bend[0] = plus(mul(c, s[0]), d, s[1]);
    f->bend[1] = plus(mul(-d, s[0]), c, s[1]);
    f->rate[0] = p * c * c + 2.0 * q * c * d + r * d * d;
    f->rate[1] = p * d * d - 2.0 * q * c * d + r * c * c;
}

static Foot foot_at(Pair *pair, V n)
{
    Foot f = {.n = n};
    Vertex v = lowest(pair, n, &f.bound);
    V s[2], row[2] = {{0, 0, 0}, {0, 0, 0}};
    int ways = pair->dim == 3 ? 2 : 1;
    stand_on(&f, &v);
    tangents(n, pair->dim, &s[0], &s[1]);
    double step = TURN;
    for (int k = 0; k < ways; k++) {
        V moved = moved_by(pair, n, s[k], step);
        row[k] = mul(0.5 / step, moved);
        if (step == FINE || length(row[k]) <= STEEP * pair->size) continue;
        V e = unit_or(across_of(moved, n), s[k]);
        Kink found;
        for (double turn = TURN; turn < 1e-2; turn *= 30.0)
            if (find_kink(pair, n, e, turn, &found)) return foot_on_kink(pair, &found);
        step = FINE; /* steep, but smooth */
        k = -1;
    }
    if (ways == 1) row[1] = mul(-1.0, s[1]);
    bend_of(&f, s, row);
    return f;
}

/* Newton's step; `far` is its angle. */
static V stepped(const Foot *f, double *far)
{
    double x = -dot(f->off, f->bend[0]) / f->rate[0], y = -dot(f->off, f->bend[1]) / f->rate[1];
    *far = sqrt(x * x + y * y);
    return unit_or(plus(plus(f->n, x, f->bend[0]), y, f->bend[1]), f->n);
}

/* 1 where `n` is improved: with its bound, and witnesses that lie along it. */
static int ascend(Pair *pair, V *n, double *bound, V *a, V *b)
{
    double far, enough = 1e-13 * pair->size;
    Foot f = foot_at(pair, *n);
    for (int i = 0; i < MOST_CLIMBS && f.kinks < 2 && length(f.off) > enough; i++) {
        V next = stepped(&f, &far);
        if (!(far <= 0.1)) break;
        Foot g = foot_at(pair, next);
        if (!(length(g.off) <= 0.5 * length(f.off)) && g.kinks < 2) {
            Kink between_them;
            V e = unit_or(across_of(sub(next, f.n), f.n), f.bend[0]);
            if (!find_kink(pair, turned_to(f.n, e, 0.5 * far), e, 0.5 * far + TURN, &between_them)) break;
            g = foot_on_kink(pair, &between_them);
            if (f.kinks == 1 && !(length(g.off) <= 0.5 * length(f.off))) break;
        }
        f = g;
    }
    if (f.kinks == 2) {
        Vertex v;
        if (!find_corner(pair, &f.n, &v)) return 0;
        lowest(pair, f.n, &f.bound);
        stand_on(&f, &v);
    }
    if (!(length(f.off) <= 1e-8 * pair->size) || !(f.bound >= *bound - 100.0 * pair->noise)) return 0;
    *n = f.n;
    *bound = f.bound;
    *a = f.a;
    *b = f.b;
    return 1;
}
#endif
