/* What rounding leaves of an interior-point answer, taken off: Newton's method for the conditions
   cost + sum y_i df_i = 0, f_i = 0 of the rows that hold the optimum, f a line's excess or a cone's
   tail less its head. Both are smooth there, and so well scaled as the set is. */
#ifndef CONIC_POLISH_H
#define CONIC_POLISH_H
#include "conic.h"

enum { MOST_ACTIVE = 24, MOST_UNKNOWNS = MOST_COLUMNS + MOST_ACTIVE };

typedef struct {
    int n, row[MOST_ACTIVE]; /* where each begins */
    double y[MOST_ACTIVE];
} Active;

/* Rows whose slack has left them to their multiplier. 0 where there are too many, or one that is not
   smooth: a cone held at its tip. */
static int find_active(const Conic *c, const Iterate *v, Active *a)
{
    a->n = 0;
    for (int i = 0; i < c->rows; i += i < c->lines ? 1 : c->p) {
        double slack = v->s[i];
        if (i >= c->lines) slack -= tail_length(v->s + i, c->p);
        if (slack >= v->y[i]) continue;
        if (a->n == MOST_ACTIVE) return 0;
        if (i >= c->lines && v->s[i] < 1e-6) return 0;
        a->row[a->n] = i;
        a->y[a->n++] = v->y[i];
    }
    return a->n > 0;
}

/* f, its gradient (size) and, for a cone, its Hessian times `weight` added to H. */
static double excess(const Conic *c, int row, const double *z, double weight, double *g, double *H)
{
    int n = c->size, p = row < c->lines ? 1 : c->p;
    const double *G = c->G + row * n;
    double s[MOST_CONE_ROWS];
    for (int i = 0; i < p; i++) s[i] = c->h[row + i] - inner(G + i * n, z, n);
    memcpy(g, G, n * sizeof(double));
    if (p == 1) return -s[0];
    double tail = tail_length(s, p);
    double inwards[MOST_COLUMNS] = {0.0};
    for (int i = 1; i < p; i++)
        for (int j = 0; j < n; j++) inwards[j] += s[i] / tail * G[i * n + j];
    for (int j = 0; j < n; j++) g[j] -= inwards[j];
    for (int j = 0; j < n; j++)
        for (int k = 0; k < n; k++) {
            double bend = -inwards[j] * inwards[k];
            for (int i = 1; i < p; i++) bend += G[i * n + j] * G[i * n + k];
            H[j * MOST_UNKNOWNS + k] += weight * bend / tail;
        }
    return tail - s[0];
}

/* x becomes the solution of M x = x, by elimination; 0 where M is singular. */
static int eliminate(double *M, double *x, int n)
{
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            if (fabs(M[i * MOST_UNKNOWNS + k]) > fabs(M[best * MOST_UNKNOWNS + k])) best = i;
        double pivot = M[best * MOST_UNKNOWNS + k];
        if (!(fabs(pivot) > 1e-14)) return 0;
        for (int j = 0; j < n && best != k; j++) {
            double t = M[k * MOST_UNKNOWNS + j];
            M[k * MOST_UNKNOWNS + j] = M[best * MOST_UNKNOWNS + j];
            M[best * MOST_UNKNOWNS + j] = t;
        }
        double t = x[k]; x[k] = x[best]; x[best] = t;
        for (int i = k + 1; i < n; i++) {
            double f = M[i * MOST_UNKNOWNS + k] / pivot;
            for (int j = k; j < n; j++) M[i * MOST_UNKNOWNS + j] -= f * M[k * MOST_UNKNOWNS + j];
            x[i] -= f * x[k];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++) x[i] -= M[i * MOST_UNKNOWNS + j] * x[j];
        x[i] /= M[i * MOST_UNKNOWNS + i];
    }
    return 1;
}

static const double STILL = 1e-13, BROKEN = 1e-14, DONE = 1e-15;

/* Newton's step of the point, and after it those of the multipliers. Returns what the conditions
   are off by, or infinity where there is no step. */
static double polish_step(const Conic *c, const double *cost, const Active *a, const double *z, double *x)
{
    double M[MOST_UNKNOWNS * MOST_UNKNOWNS], g[MOST_COLUMNS];
    int n = c->size, all = n + a->n;
    for (int i = 0; i < all; i++) memset(M + i * MOST_UNKNOWNS, 0, all * sizeof(double));
    for (int j = 0; j < n; j++) x[j] = -cost[j];
    for (int k = 0; k < a->n; k++) {
        x[n + k] = -excess(c, a->row[k], z, a->y[k], g, M);
        for (int j = 0; j < n; j++) {
            M[j * MOST_UNKNOWNS + n + k] = M[(n + k) * MOST_UNKNOWNS + j] = g[j];
            x[j] -= a->y[k] * g[j];
        }
    }
    double off = 0.0;
    for (int j = 0; j < all; j++) off = larger(off, fabs(x[j]));
    /* Flat faces leave the point free, and redundant rows their multipliers: neither then moves. */
    for (int j = 0; j < all; j++) M[j * MOST_UNKNOWNS + j] += j < n ? STILL : -STILL;
    return eliminate(M, x, all) ? off : INFINITY;
}

/* Multipliers that leave the least of the cost: without them a cone that is new has no curvature.
   Rows that would pull are let go. */
static int estimate(const Conic *c, const double *cost, const double *z, Active *a)
{
    double M[MOST_UNKNOWNS * MOST_UNKNOWNS], x[MOST_UNKNOWNS], g[MOST_COLUMNS];
    int n = c->size, all = n + a->n;
    for (int i = 0; i < all; i++) memset(M + i * MOST_UNKNOWNS, 0, all * sizeof(double));
    for (int j = 0; j < all; j++) {
        x[j] = j < n ? -cost[j] : 0.0;
        M[j * MOST_UNKNOWNS + j] = j < n ? 1.0 : -STILL;
    }
    for (int k = 0; k < a->n; k++) {
        excess(c, a->row[k], z, 0.0, g, M);
        for (int j = 0; j < n; j++) M[j * MOST_UNKNOWNS + n + k] = M[(n + k) * MOST_UNKNOWNS + j] = g[j];
    }
    if (!eliminate(M, x, all)) return 0;
    int kept = 0;
    for (int k = 0; k < a->n; k++) {
        if (x[n + k] < 0.0) continue;
        a->row[kept] = a->row[k];
        a->y[kept++] = x[n + k];
    }
    a->n = kept;
    return 1;
}

static void slacks(const Conic *c, const double *z, double part, const double *step, double *s)
{
    double at[MOST_COLUMNS];
    for (int j = 0; j < c->size; j++) at[j] = z[j] + part * step[j];
    for (int i = 0; i < c->rows; i++) s[i] = c->h[i] - inner(c->G + i * c->size, at, c->size);
}

static inline double violation(const Conic *c, const double *s, int row)
{
    return row < c->lines ? -s[row] : tail_length(s + row, c->p) - s[row];
}

static int is_active(const Active *a, int row)
{
    for (int k = 0; k < a->n; k++)
        if (a->row[k] == row) return 1;
    return 0;
}

/* The part of a step that breaks no other row, and the row that a longer one would, or -1. */
static double room_for(const Conic *c, const Active *a, const double *z, const double *step, int *row)
{
    double s[MOST_CONE_ROWS], part = 1.0;
    *row = -1;
    for (int i = 0; i < c->rows; i += i < c->lines ? 1 : c->p) {
        slacks(c, z, part, step, s);
        if (is_active(a, i) || !(violation(c, s, i) > BROKEN)) continue;
        double low = 0.0;
        for (int halving = 0; halving < 50; halving++) {
            double middle = 0.5 * (low + part);
            slacks(c, z, middle, step, s);
            if (violation(c, s, i) > BROKEN) part = middle;
            else low = middle;
        }
        part = low;
        *row = i;
    }
    return part;
}

/* The part of a step along which the cones held are nearly what their tangent planes are. */
static double short_of_bends(const Conic *c, const Active *a, const double *z, const double *step)
{
    double here[MOST_CONE_ROWS], there[MOST_CONE_ROWS], part = 1.0;
    for (int k = 0; k < a->n; k++) {
        int i = a->row[k];
        if (i < c->lines) continue;
        slacks(c, z, 0.0, step, here);
        slacks(c, z, 1.0, step, there);
        double far = 0.0;
        for (int j = i + 1; j < i + c->p; j++) far += (there[j] - here[j]) * (there[j] - here[j]);
        part = fmin(part, 0.5 * tail_length(here + i, c->p) / sqrt(far));
    }
    return part;
}

/* Multipliers of the polished point, on the cones, so that no gap is left. */
static void complete(const Conic *c, const double *cost, const Active *a, Iterate *v)
{
    slacks(c, v->z, 0.0, v->z, v->s);
    memset(v->y, 0, c->rows * sizeof(double));
    for (int k = 0; k < a->n; k++) {
        int i = a->row[k], p = i < c->lines ? 1 : c->p;
        v->y[i] = a->y[k];
        double tail = tail_length(v->s + i, p);
        for (int j = 1; j < p; j++) v->y[i + j] = -a->y[k] * v->s[i + j] / tail;
    }
    residuals(c, cost, v);
}

/* Drops the row that pulls the most; 0 if none does. */
static int drop(Active *a)
{
    int worst = 0;
    for (int k = 1; k < a->n; k++)
        if (a->y[k] < a->y[worst]) worst = k;
    if (!(a->y[worst] < 0.0)) return 0;
    a->row[worst] = a->row[--a->n];
    a->y[worst] = a->y[a->n];
    return 1;
}

enum { MOST_POLISHES = 30 };

/* Replaces the answer if another one is better by its own proof. */
static void polish(const Conic *c, const double *cost, Iterate *v)
{
    double x[MOST_UNKNOWNS];
    Active a;
    Iterate tried = *v;
    if (!find_active(c, v, &a)) return;
    for (int round = 0; round < MOST_POLISHES && a.n > 0; round++) {
        int blocked;
        double off = polish_step(c, cost, &a, tried.z, x);
        if (!isfinite(off)) return;
        if (off <= DONE) {
            if (drop(&a)) continue;
            break;
        }
        double part = short_of_bends(c, &a, tried.z, x);
        for (int j = 0; j < c->size + a.n; j++) x[j] *= part;
        part = room_for(c, &a, tried.z, x, &blocked);
        for (int j = 0; j < c->size; j++) tried.z[j] += part * x[j];
        for (int k = 0; k < a.n; k++) a.y[k] += part * x[c->size + k];
        if (blocked >= 0) {
            if (a.n == MOST_ACTIVE) return;
            a.row[a.n++] = blocked;
            if (!estimate(c, cost, tried.z, &a)) return;
        }
    }
    for (int k = 0; k < a.n; k++)
        if (!(a.y[k] >= 0.0)) return;
    complete(c, cost, &a, &tried);
    for (int i = 0; i < c->rows; i += i < c->lines ? 1 : c->p)
        if (!(violation(c, tried.s, i) <= 2.0 * BROKEN)) return;
    if (tried.worst < v->worst) *v = tried;
}

static Support conic_point(const double *d, int dim, V n)
{
    Conic c = conic_from(d);
    double cost[MOST_COLUMNS] = {-n.x, -n.y, dim == 3 ? -n.z : 0.0};
    Iterate best = interior(&c, cost);
    polish(&c, cost, &best);
    double least = proven_least(&c, cost, &best);
    V p = vec(c.unit * best.z[0], c.unit * best.z[1], dim == 3 ? c.unit * best.z[2] : 0.0);
    return (Support){p, larger(-c.unit * least - dot(n, p), 0.0)};
}
#endif
