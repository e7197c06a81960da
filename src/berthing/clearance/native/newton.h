/* Two smooth sets: Newton's method for the conditions of their closest points, the paper's
   Propositions 2 and 3.

   With w on A's boundary, p on B's, n the outward unit normal of A at w and s the signed distance,
   they read p - w = s n, and n is minus B's outward normal at p. Both multipliers are then known:
   |s| over the length of each gradient. What is left are tangential displacements u of w and v of
   p; with the curvatures K_A, K_B and the mismatches t = tangential p - w, m = n + B's normal:

       v = u + s K_A u - t,    (K_A + K_B + s K_B K_A) u = -m + K_B t,

   two by two, for either sign of s and for s = 0, where the multipliers vanish and the system
   with them as unknowns is singular. After each step both points return to their boundaries. */
#ifndef NEWTON_H
#define NEWTON_H
#include "gjk.h"

typedef struct { V w, p; int known; } Closest; /* own frames */

typedef struct {
    Level la, lb;
    V n, nb, e;
    double s, mismatch;
} State;

/* Both bounded by one smooth function, or one of them and the other a point. */
static int newton_takes(const Pair *pair)
{
    int a = is_smooth(&pair->a), b = is_smooth(&pair->b);
    return (a || pair->a.kind == POINT) && (b || pair->b.kind == POINT) && (a || b);
}

static const double SOLVED = 2e-14;
enum { MOST_NEWTON_STEPS = 20 };

/* A point has whatever normal the other set has there. */
static State state_of(const Pair *pair, V w, V p)
{
    State st;
    if (pair->a.kind != POINT) {
        st.la = level_of(&pair->a, w);
        st.n = mul(1.0 / length(st.la.g), st.la.g);
    }
    if (pair->b.kind != POINT) {
        st.lb = level_of(&pair->b, p);
        st.nb = turn(&pair->R, mul(1.0 / length(st.lb.g), st.lb.g));
    }
    if (pair->a.kind == POINT) st.n = mul(-1.0, st.nb);
    if (pair->b.kind == POINT) st.nb = mul(-1.0, st.n);
    st.e = difference(pair, w, p);
    st.s = dot(st.e, st.n);
    double t = length(plus(st.e, -st.s, st.n)), m = length(add(st.n, st.nb));
    st.mismatch = t + m * pair->size;
    return st;
}

/* Curvature of {f = 0} seen along two tangents: xx, xy, yy. */
static void curvature(const Level *l, V s1, V s2, double *k)
{
    double g = length(l->g);
    V h1 = hessian_times(l->h, s1), h2 = hessian_times(l->h, s2);
    k[0] = dot(s1, h1) / g;
    k[1] = dot(s1, h2) / g;
    k[2] = dot(s2, h2) / g;
}

/* Towards a point: (1 + s K) u = t, t the tangential part of the vector to it. */
static V towards_point(const Level *l, V t, double s, int dim, V n)
{
    V s1, s2;
    double k[3];
    tangents(n, dim, &s1, &s2);
    curvature(l, s1, s2, k);
    double a = 1.0 + s * k[0], b = s * k[1], d = 1.0 + s * k[2], p = dot(t, s1), q = dot(t, s2);
    double det = a * d - b * b;
    return plus(mul((d * p - b * q) / det, s1), (a * q - b * p) / det, s2);
}

static int newton_step(const Pair *pair, const State *st, V *u, V *v)
{
    V s1, s2, m = add(st->n, st->nb), none = vec(0.0, 0.0, 0.0);
    double A[3], B[3];
    if (pair->b.kind == POINT || pair->a.kind == POINT) {
        int to_b = pair->b.kind == POINT;
        V own_n = to_b ? st->n : unturn(&pair->R, st->nb);
        V own_e = to_b ? st->e : mul(-1.0, unturn(&pair->R, st->e));
        V d = towards_point(to_b ? &st->la : &st->lb, own_e, st->s, pair->dim, own_n);
        double far = length(d), most = 0.3 * pair->size;
        if (!isfinite(far)) return 0;
        if (far > most) d = mul(most / far, d);
        *u = to_b ? d : none;
        *v = to_b ? none : turn(&pair->R, d);
        return 1;
    }
    tangents(st->n, pair->dim, &s1, &s2);
    curvature(&st->la, s1, s2, A);
    curvature(&st->lb, unturn(&pair->R, s1), unturn(&pair->R, s2), B);
    double t1 = dot(st->e, s1), t2 = dot(st->e, s2), s = st->s;
    double r1 = -dot(m, s1) + B[0] * t1 + B[1] * t2, r2 = -dot(m, s2) + B[1] * t1 + B[2] * t2;
    double a = A[0] + B[0] + s * (B[0] * A[0] + B[1] * A[1]);
    double b = A[1] + B[1] + s * (B[0] * A[1] + B[1] * A[2]);
    double c = A[1] + B[1] + s * (B[1] * A[0] + B[2] * A[1]);
    double d = A[2] + B[2] + s * (B[1] * A[1] + B[2] * A[2]);
    /* Flat faces have no curvature: a little for each keeps the step finite. */
    double reg = 1e-13 * (fabs(a) + fabs(d)) + 1e-14 / pair->size;
    a += reg;
    d += reg;
    double det = a * d - b * c;
    if (!(fabs(det) > 0.0) || !isfinite(det)) return 0;
    double u1 = (d * r1 - b * r2) / det, u2 = (a * r2 - c * r1) / det;
    double v1 = u1 + s * (A[0] * u1 + A[1] * u2) - t1, v2 = u2 + s * (A[1] * u1 + A[2] * u2) - t2;
    double far = sqrt(larger(u1 * u1 + u2 * u2, v1 * v1 + v2 * v2)), most = 0.3 * pair->size;
    double cut = far > most ? most / far : 1.0;
    *u = mul(cut, plus(mul(u1, s1), u2, s2));
    *v = mul(cut, plus(mul(v1, s1), v2, s2));
    return isfinite(far);
}

/* Plane bound of the mean normal: each set lies behind its tangent plane, so that a normal off by
   half the mismatch m costs at most half of |m| times the size of the set. */
static Answer answer_of(const Pair *pair, const State *st, V w, V p)
{
    V n = unit_or(sub(st->n, st->nb), st->n);
    double loss = 0.5 * length(add(st->n, st->nb)) * (pair->a.size + pair->b.size);
    if (pair->a.kind != POINT) loss += larger(-st->la.f / length(st->la.g), 0.0);
    if (pair->b.kind != POINT) loss += larger(-st->lb.f / length(st->lb.g), 0.0);
    double lower = dot(n, st->e) - loss;
    Answer answer = {lower, st->s > 0.0 ? length(st->e) : INFINITY, n, w, p, st->s <= 0.0};
    return answer;
}

static V on_boundary(const Shape *s, V x) { return s->kind == POINT ? x : boundary(s, x); }

/* From the points at hand; 0 where it does not get to rounding, and others must find better ones.
   Steps are halved until the mismatch falls. */
static int newton(const Pair *pair, Closest *at, Answer *answer)
{
    V w = on_boundary(&pair->a, at->w), p = on_boundary(&pair->b, at->p);
    State st = state_of(pair, w, p);
    for (int step = 0; step < MOST_NEWTON_STEPS && st.mismatch > SOLVED * pair->size; step++) {
        V u, v;
        if (!newton_step(pair, &st, &u, &v)) return 0;
        double part = 1.0;
        int better = 0;
        for (; part > 0.03 && !better; part *= 0.4) {
            V w2 = on_boundary(&pair->a, plus(w, part, u));
            V p2 = on_boundary(&pair->b, plus(p, part, unturn(&pair->R, v)));
            State tried = state_of(pair, w2, p2);
            if (tried.mismatch < st.mismatch) { st = tried; w = w2; p = p2; better = 1; }
        }
        if (!better) break;
    }
    *answer = answer_of(pair, &st, w, p);
    if (!(st.mismatch <= 1e-10 * pair->size)) return 0;
    *at = (Closest){w, p, 1};
    return 1;
}
#endif
