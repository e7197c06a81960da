/* Distances of sets apart by the algorithm of Gilbert, Johnson and Keerthi (IEEE J. Robotics and
   Automation 4, 1988). It needs support points only, each step shortens the vector between
   witnesses, and the plane of each step bounds what is left to gain: it cannot fail to converge. */
#ifndef GJK_H
#define GJK_H
#include "simplex.h"

/* In A's frame: the plane bound of the unit normal, and members a of A and b of B (its frame). */
typedef struct {
    double lower, upper;
    V normal, a, b;
    int overlap;
} Answer;

/* Shorter vectors than this, in terms of the size, are taken for none. */
static const double NONE = 1e-12;

/* Steps in a row that do not halve what is left to gain, once that is small: rounding is to blame. */
enum { STALLED = 6 };
static const double SMALL = 1e-11;

static inline int known(const Simplex *s, V y)
{
    for (int i = 0; i < s->n; i++)
        if (s->p[i].y.x == y.x && s->p[i].y.y == y.y && s->p[i].y.z == y.z) return 1;
    return 0;
}

/* Members found at another pose are members still: they only move. */
static void carry_over(const Pair *pair, Simplex *s)
{
    for (int i = 0; i < s->n; i++) s->p[i].y = difference(pair, s->p[i].a, s->p[i].b);
}

static inline V first_direction(const Pair *pair)
{
    V other = vec(1.0, 0.0, 0.0);
    return unit_or(pair->r, other);
}

static Answer gjk(Pair *pair, Simplex *s, double tolerance, int most_steps)
{
    Answer best = {-INFINITY, INFINITY, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0};
    double bound;
    if (s->n == 0) {
        s->p[0] = lowest(pair, first_direction(pair), &bound);
        s->w[0] = 1.0;
        s->n = 1;
    } else {
        carry_over(pair, s);
        if (reduce(s)) { best.overlap = 1; return best; }
    }
    double open = INFINITY;
    for (int step = 0, stalled = 0; step < most_steps && stalled < STALLED; step++) {
        V v = nearest(s);
        double gap = length(v);
        if (gap <= NONE * pair->size) { best.overlap = 1; return best; }
        if (gap >= best.upper && step > 0) break; /* rounding is all that moves */
        best.upper = gap;
        best.a = combined_a(s);
        best.b = combined_b(s);
        V n = mul(1.0 / gap, v);
        Vertex next = lowest(pair, n, &bound);
        if (bound > best.lower) { best.lower = bound; best.normal = n; }
        if (gap - best.lower <= tolerance || known(s, next.y)) break;
        if (gap - best.lower < 0.5 * open) { open = gap - best.lower; stalled = 0; }
        else stalled += open <= larger(SMALL * pair->size, 10.0 * pair->noise);
        s->p[s->n++] = next;
        if (reduce(s)) { best.overlap = 1; return best; }
    }
    return best;
}
#endif
