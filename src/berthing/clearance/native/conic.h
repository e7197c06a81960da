/* Support points of sets with a conic form {x : for some z that begins with x, G z + s = h, s in K}:
   a primal-dual interior-point method with Nesterov and Todd's scaling and Mehrotra's corrector, as
   geometry/conic_solver.py (Vandenberghe, as in cone_algebra.h, section 5). */
#ifndef CONIC_H
#define CONIC_H
#include <string.h>
#include "cone_algebra.h"

enum { MOST_COLUMNS = 24, MOST_CONE_ROWS = 256, MOST_ITERATIONS = 40 };

/* K: half-lines, then cones of p rows each; G (rows, size) and h are in terms of `unit` metres, and no
   z of the set is longer than `reach`. */
typedef struct {
    int size, lines, cones, p, rows;
    double unit, reach;
    const double *G, *h;
} Conic;

static inline Conic conic_from(const double *d)
{
    Conic c = {(int)d[0], (int)d[1], (int)d[2], (int)d[3], 0, d[4], d[5], d + 6, 0};
    c.rows = c.lines + c.cones * c.p;
    c.h = c.G + c.rows * c.size;
    return c;
}

typedef struct {
    double z[MOST_COLUMNS], s[MOST_CONE_ROWS], y[MOST_CONE_ROWS];
    double dual[MOST_COLUMNS], primal[MOST_CONE_ROWS], gap, worst; /* residuals */
} Iterate;

/* Scaled rows, their factors, lambda = W y, W itself, and a direction in scaled terms. */
typedef struct {
    double G[MOST_CONE_ROWS * MOST_COLUMNS], Q[MOST_CONE_ROWS * MOST_COLUMNS];
    double R[MOST_COLUMNS][MOST_COLUMNS], lambda[MOST_CONE_ROWS], w[MOST_CONE_ROWS];
    double sizes[MOST_CONE_ROWS], z[MOST_COLUMNS], s[MOST_CONE_ROWS], y[MOST_CONE_ROWS];
} Newton;

/* Of the gap and all residuals; and below which an iteration that gains nothing is the last. */
static const double CONIC_TOLERANCE = 1e-13, CONIC_ENOUGH = 1e-10;

static void residuals(const Conic *c, const double *cost, Iterate *v)
{
    double size = 1.0;
    v->gap = inner(v->s, v->y, c->rows);
    v->worst = v->gap;
    memcpy(v->dual, cost, c->size * sizeof(double));
    for (int i = 0; i < c->rows; i++) {
        const double *row = c->G + i * c->size;
        v->primal[i] = inner(row, v->z, c->size) + v->s[i] - c->h[i];
        v->worst = larger(v->worst, fabs(v->primal[i]));
        for (int j = 0; j < c->size; j++) v->dual[j] += row[j] * v->y[i];
    }
    for (int j = 0; j < c->size; j++) {
        v->worst = larger(v->worst, fabs(v->dual[j]));
        size = larger(size, fabs(v->z[j]));
    }
    v->worst /= size;
}

/* Q R = G by Gram and Schmidt, twice, so that Q is orthogonal to rounding. */
static void factor(const double *G, int rows, int size, double *Q, double R[][MOST_COLUMNS])
{
    memcpy(Q, G, rows * size * sizeof(double));
    for (int j = 0; j < size; j++) {
        for (int i = 0; i < size; i++) R[i][j] = 0.0;
        for (int twice = 0; twice < 2; twice++)
            for (int i = 0; i < j; i++) {
                double part = 0.0;
                for (int k = 0; k < rows; k++) part += Q[k * size + i] * Q[k * size + j];
                for (int k = 0; k < rows; k++) Q[k * size + j] -= part * Q[k * size + i];
                R[i][j] += part;
            }
        double square = 0.0;
        for (int k = 0; k < rows; k++) square += Q[k * size + j] * Q[k * size + j];
        R[j][j] = sqrt(square);
        for (int k = 0; k < rows; k++) Q[k * size + j] /= R[j][j];
    }
}

/* x becomes R^-1 x, or R^-T x. */
static void solve_upper(double R[][MOST_COLUMNS], int n, double *x)
{
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++) x[i] -= R[i][j] * x[j];
        x[i] /= R[i][i];
    }
}
static void solve_lower(double R[][MOST_COLUMNS], int n, double *x)
{
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < i; j++) x[i] -= R[j][i] * x[j];
        x[i] /= R[i][i];
    }
}

/* Moves x into K by the same shift in every half-line and head, if it is not inside. */
static void into_cones(const Conic *c, double *x)
{
    double outside = -INFINITY;
    for (int i = 0; i < c->lines; i++) outside = larger(outside, -x[i]);
    for (int i = c->lines; i < c->rows; i += c->p)
        outside = larger(outside, tail_length(x + i, c->p) - x[i]);
    double shift = outside < 0.0 ? 0.0 : 1.0 + outside;
    for (int i = 0; i < c->rows; i += i < c->lines ? 1 : c->p) x[i] += shift;
}

/* Least-squares points, moved into the cones. */
static void first_iterate(const Conic *c, const double *cost, Newton *work, Iterate *v)
{
    double y[MOST_COLUMNS];
    factor(c->G, c->rows, c->size, work->Q, work->R);
    for (int j = 0; j < c->size; j++) {
        v->z[j] = 0.0;
        for (int i = 0; i < c->rows; i++) v->z[j] += work->Q[i * c->size + j] * c->h[i];
        y[j] = -cost[j];
    }
    solve_upper(work->R, c->size, v->z);
    solve_lower(work->R, c->size, y);
    solve_upper(work->R, c->size, y);
    for (int i = 0; i < c->rows; i++) {
        v->s[i] = c->h[i] - inner(c->G + i * c->size, v->z, c->size);
        v->y[i] = inner(c->G + i * c->size, y, c->size);
    }
    into_cones(c, v->s);
    into_cones(c, v->y);
    residuals(c, cost, v);
}

static int inside(const Conic *c, const double *x)
{
    for (int i = 0; i < c->lines; i++)
        if (!(x[i] > 0.0)) return 0;
    for (int i = c->lines; i < c->rows; i += c->p)
        if (!(root_determinant(x + i, c->p) > 0.0)) return 0;
    return 1;
}

static void prepare(const Conic *c, const Iterate *v, Newton *work)
{
    int n = c->size, p = c->p;
    for (int i = 0; i < c->lines; i++) {
        work->sizes[i] = sqrt(v->s[i] / v->y[i]);
        work->lambda[i] = sqrt(v->s[i] * v->y[i]);
        for (int j = 0; j < n; j++) work->G[i * n + j] = c->G[i * n + j] / work->sizes[i];
    }
    for (int i = c->lines; i < c->rows; i += p) {
        double size = scaling_of(v->s + i, v->y + i, p, work->w + i);
        work->sizes[i] = size;
        memcpy(work->lambda + i, v->y + i, p * sizeof(double));
        scale(work->w + i, size, 1, p, work->lambda + i, 1);
        memcpy(work->G + i * n, c->G + i * n, p * n * sizeof(double));
        for (int j = 0; j < n; j++) scale(work->w + i, size, -1, p, work->G + i * n + j, n);
    }
    factor(work->G, c->rows, n, work->Q, work->R);
}

/* The direction that removes `share` of the residuals and has lambda o (W dy + W^-1 ds) = b, which it
   overwrites. Returns 1 over the longest step that it allows. */
static double direct(const Conic *c, const Iterate *v, Newton *work, double share, double *b)
{
    int n = c->size, p = c->p;
    double u[MOST_CONE_ROWS], inverse = 0.0;
    for (int i = 0; i < c->lines; i++) {
        b[i] /= work->lambda[i];
        u[i] = -share * v->primal[i] / work->sizes[i] - b[i];
    }
    for (int i = c->lines; i < c->rows; i += p) {
        cone_quotient(work->lambda + i, b + i, p, b + i);
        memcpy(u + i, v->primal + i, p * sizeof(double));
        scale(work->w + i, work->sizes[i], -1, p, u + i, 1);
        for (int k = i; k < i + p; k++) u[k] = -share * u[k] - b[k];
    }
    for (int j = 0; j < n; j++) work->z[j] = -share * v->dual[j];
    solve_lower(work->R, n, work->z);
    for (int i = 0; i < c->rows; i++)
        for (int j = 0; j < n; j++) work->z[j] += work->Q[i * n + j] * u[i];
    solve_upper(work->R, n, work->z);
    for (int i = 0; i < c->rows; i++) {
        work->y[i] = inner(work->G + i * n, work->z, n) - u[i];
        work->s[i] = b[i] - work->y[i];
    }
    for (int i = 0; i < c->lines; i++)
        inverse = larger(inverse, larger(-work->y[i], -work->s[i]) / work->lambda[i]);
    for (int i = c->lines; i < c->rows; i += p) {
        inverse = larger(inverse, inverse_step(work->lambda + i, work->y + i, p));
        inverse = larger(inverse, inverse_step(work->lambda + i, work->s + i, p));
    }
    return inverse;
}

/* Minus lambda o lambda, minus what the first direction adds, plus the target. */
static void aim(const Conic *c, const Newton *work, int again, double target, double *b)
{
    double other[MOST_CONE_ROWS];
    for (int i = 0; i < c->lines; i++)
        other[i] = work->s[i] * work->y[i], b[i] = -work->lambda[i] * work->lambda[i];
    for (int i = c->lines; i < c->rows; i += c->p) {
        cone_product(work->s + i, work->y + i, c->p, other + i);
        cone_product(work->lambda + i, work->lambda + i, c->p, b + i);
        for (int k = i; k < i + c->p; k++) b[k] = -b[k];
    }
    if (!again) return;
    for (int i = 0; i < c->rows; i++) b[i] -= other[i];
    for (int i = 0; i < c->rows; i += i < c->lines ? 1 : c->p) b[i] += target;
}

/* Towards the optimum first, to see how much to centre, then both at once. */
static void advance(const Conic *c, const double *cost, Newton *work, Iterate *v)
{
    double b[MOST_CONE_ROWS];
    prepare(c, v, work);
    memset(work->s, 0, sizeof work->s);
    memset(work->y, 0, sizeof work->y);
    aim(c, work, 0, 0.0, b);
    double short_of = 1.0 - 1.0 / larger(direct(c, v, work, 1.0, b), 1.0);
    double centring = short_of * short_of * short_of;
    aim(c, work, 1, centring * v->gap / (c->lines + c->cones), b);
    double t = 0.99 / larger(direct(c, v, work, 1.0 - centring, b), 0.99);
    for (int j = 0; j < c->size; j++) v->z[j] += t * work->z[j];
    for (int i = 0; i < c->lines; i++) {
        v->s[i] += t * work->s[i] * work->sizes[i];
        v->y[i] += t * work->y[i] / work->sizes[i];
    }
    for (int i = c->lines; i < c->rows; i += c->p) {
        scale(work->w + i, work->sizes[i], 1, c->p, work->s + i, 1);
        scale(work->w + i, work->sizes[i], -1, c->p, work->y + i, 1);
        for (int k = i; k < i + c->p; k++) {
            v->s[k] += t * work->s[k];
            v->y[k] += t * work->y[k];
        }
    }
    residuals(c, cost, v);
}

/* For y in K, cost·z >= -h·y + (cost + G'y)·z for every member z, and z is no longer than `reach`. */
static double proven_least(const Conic *c, const double *cost, Iterate *v)
{
    for (int i = 0; i < c->lines; i++) v->y[i] = larger(v->y[i], 0.0);
    for (int i = c->lines; i < c->rows; i += c->p)
        v->y[i] = larger(v->y[i], tail_length(v->y + i, c->p));
    residuals(c, cost, v);
    return -inner(v->y, c->h, c->rows) - sqrt(inner(v->dual, v->dual, c->size)) * c->reach;
}

static Iterate interior(const Conic *c, const double *cost)
{
    Newton work;
    Iterate v, best;
    first_iterate(c, cost, &work, &v);
    best = v;
    for (int i = 0; i < MOST_ITERATIONS; i++) {
        if (!(v.worst > CONIC_TOLERANCE) || !inside(c, v.s) || !inside(c, v.y)) break;
        advance(c, cost, &work, &v);
        if (v.worst < best.worst) best = v;
        else if (best.worst <= CONIC_ENOUGH) break;
    }
    return best;
}
#endif
