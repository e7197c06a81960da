/* Normals at which the lowest member y of B - A jumps: at kinks, between two members, and at the
   corners where kinks meet, between three or four. The bound n·y is continuous there: it is where the
   planes of the members meet. */
#ifndef KINK_H
#define KINK_H
#include "simplex.h"

/* Angles to look to the side by: to notice a kink, to find how it bends, and once it is known where it
   is, for its members, which may slide fast beside it. */
static const double TURN = 1e-6, ROUND = 1e-5, FINE = 1e-9;
/* In terms of the size, per rad: where y moves so fast over TURN, a kink is looked for; if it still does
   over FINE, that is one. */
static const double STEEP = 1e2, JUMP = 1e5;
enum { MOST_LOOKS = 40, RING = 8 };

static V across_of(V y, V n) { return plus(y, -dot(y, n), n); }

static V turned_to(V n, V s, double angle) { return unit_or(plus(n, angle, s), n); }

static Vertex turned(Pair *pair, V n, V s, double angle)
{
    double bound;
    return lowest(pair, turned_to(n, s, angle), &bound);
}

/* `e` is across the kink, `high` the member to its side. */
typedef struct { V n, e; Vertex high, low; } Kink;

/* How fast the bound n·y rises from k's normal towards e, by the member to that side and the other. */
static double above(const Kink *k) { return dot(k->high.y, k->e); }
static double below(const Kink *k) { return dot(k->low.y, k->e); }

static int look_beside(Pair *pair, Kink *k, double angle)
{
    k->high = turned(pair, k->n, k->e, angle);
    k->low = turned(pair, k->n, k->e, -angle);
    return below(k) >= 0.0 && above(k) <= 0.0;
}

/* The part of the high member in the point between both that has nothing along e. */
static double part_of(const Kink *k)
{
    double gap = below(k) - above(k);
    return gap > 0.0 ? below(k) / gap : 0.5;
}

/* Faces that are but nearly flat have no kink: their members close up as one looks closer, and the
   normal is where what lies between them has nothing along e. */
static void close_up(Pair *pair, Kink *k)
{
    Kink closer = *k;
    V n = k->n;
    double down = -FINE, up = FINE;
    look_beside(pair, &closer, 1e-2 * FINE);
    if (below(&closer) - above(&closer) > 0.5 * (below(k) - above(k))) return;
    for (int halving = 0; halving < MOST_LOOKS && below(k) - above(k) > 1e-9 * pair->size; halving++) {
        double angle = down + (up - down) * (halving % 2 ? 0.5 : part_of(k));
        Vertex v = turned(pair, n, k->e, angle);
        if (dot(v.y, k->e) > 0.0) { k->low = v; down = angle; }
        else { k->high = v; up = angle; }
    }
    k->n = turned_to(n, k->e, down + (up - down) * part_of(k));
}

/* Along e, no further than `turn` from n to both sides, with members that have parts along e to both
   sides. Members found give the angle where their planes meet; that is looked beside. */
static int find_kink(Pair *pair, V n, V e, double turn, Kink *k)
{
    double up = turn, down = -turn;
    Vertex high = turned(pair, n, e, up), low = turned(pair, n, e, down);
    for (int look = 0; look < MOST_LOOKS; look++) {
        V jump = sub(high.y, low.y);
        if (dot(high.y, plus(e, -up, n)) > 0.0 || dot(low.y, plus(e, -down, n)) < 0.0) return 0;
        double angle = -dot(n, jump) / dot(e, jump);
        if (!(angle <= up && angle >= down)) return 0;
        k->n = turned_to(n, e, angle);
        k->e = unit_or(across_of(mul(-1.0, jump), k->n), e);
        if (dot(k->e, e) < 0.0) k->e = mul(-1.0, k->e);
        if (look_beside(pair, k, FINE)) {
            if (is_smooth(&pair->a) || is_smooth(&pair->b)) close_up(pair, k);
            return 1;
        }
        if (above(k) > 0.0) { low = k->high; down = angle + FINE; }
        else { high = k->low; up = angle - FINE; }
    }
    return 0;
}

static V mixed(double part, V p, V q) { return plus(mul(1.0 - part, q), part, p); }

static Vertex between(const Kink *k)
{
    double part = part_of(k);
    return (Vertex){mixed(part, k->high.a, k->low.a), mixed(part, k->high.b, k->low.b),
                    mixed(part, k->high.y, k->low.y)};
}

/* Of three members that have n·y least where they lie along n: that height, and where they are not all
   but in a line, their point there and the normal of their plane. */
static double height_of(const Vertex *p, const Vertex *q, const Vertex *r, V n, Vertex *foot, V *m)
{
    V e = sub(q->y, p->y), f = sub(r->y, p->y), c = cross(e, f);
    double area = dot(c, n), ee = dot(e, e), ff = dot(f, f);
    if (!(fabs(area) > 1e-3 * sqrt(ee * ff)) || !(area * area > 1e-8 * ee * ff)) return INFINITY;
    V o = mul(-1.0, p->y);
    double u = dot(cross(o, f), n) / area, v = dot(cross(e, o), n) / area, w = 1.0 - u - v;
    if (u < -1e-12 || v < -1e-12 || w < -1e-12) return INFINITY;
    foot->a = plus(plus(mul(w, p->a), u, q->a), v, r->a);
    foot->b = plus(plus(mul(w, p->b), u, q->b), v, r->b);
    foot->y = plus(plus(mul(w, p->y), u, q->y), v, r->y);
    *m = unit_or(area > 0.0 ? c : mul(-1.0, c), n);
    return dot(n, foot->y);
}

/* The normal of the members about n that bear it; 0 where none do. */
static int bearing(Pair *pair, double around, V *n, Vertex *foot)
{
    Vertex ring[RING], v;
    double least = INFINITY;
    V s, t, m, best = *n;
    tangents(*n, 3, &s, &t);
    for (int i = 0; i < RING; i++) {
        double angle = 0.3 + i * 6.283185307179586 / RING;
        ring[i] = turned(pair, *n, plus(mul(cos(angle), s), sin(angle), t), around);
    }
    for (int i = 0; i < RING; i++)
        for (int j = i + 1; j < RING; j++) {
            if (length(sub(ring[i].y, ring[j].y)) <= 2.0 * TURN * STEEP * pair->size) continue;
            for (int k = j + 1; k < RING; k++) {
                double height = height_of(&ring[i], &ring[j], &ring[k], *n, &v, &m);
                if (height < least) { least = height; best = m; *foot = v; }
            }
        }
    *n = best;
    return isfinite(least);
}

/* Turns n to the corner near it, with the point of its members that lies along n. */
static int find_corner(Pair *pair, V *n, Vertex *foot)
{
    for (double around = ROUND; around >= 0.9 * FINE; around *= 1e-2)
        if (!bearing(pair, around, n, foot)) return 0;
    V last = *n;
    return bearing(pair, FINE, n, foot) && length(sub(*n, last)) <= FINE;
}
#endif
