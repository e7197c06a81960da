/* Of an answer, in doubles: lower bound, upper bound, distance, normal, witnesses, gradients with
   respect to the pose of A and that of B: force-like, then torque-like, about each pose's own
   origin. */
#ifndef ANSWER_ROW_H
#define ANSWER_ROW_H
#include "pair.h"

enum { WIDTH = 24, DISTANCE = 2, NORMAL = 3, WITNESSES = 6 };

static M rows(const double *d) { return (M){three(d), three(d + 3), three(d + 6)}; }
static double *write3(double *out, V v)
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
    return out + 3;
}

static void write_answer(double *out, const Answer *s, double pad_a, double pad_b, const M *RA, V rA,
                         const M *RB, V rB)
{
    V n = turn(RA, s->normal);
    V a = plus(add(rA, turn(RA, s->a)), pad_a, n), b = plus(add(rB, turn(RB, s->b)), -pad_b, n);
    double upper = s->upper - pad_a - pad_b, lower = s->lower - pad_a - pad_b;
    out[0] = lower;
    out[1] = upper;
    double d = s->overlap ? lower : fmax(lower, fmin(upper, dot(n, sub(b, a))));
    out[DISTANCE] = d;
    double *next = write3(write3(write3(out + NORMAL, n), a), b);
    V middle = mul(0.5, add(a, b)); /* of the line on which both lie */
    next = write3(next, mul(-1.0, n));
    next = write3(next, cross(n, sub(middle, rA)));
    next = write3(next, n);
    write3(next, cross(sub(middle, rB), n));
}

/* A search of one pair, at no pose yet; its hull is not made. */
static Path path_of(const double *a, const double *b, int dim, double tolerance, double depth_tolerance)
{
    Path path = {.pair = {.a = shape_from(a, dim), .b = shape_from(b, dim), .dim = dim}};
    path.pair.size = path.pair.a.size + path.pair.b.size;
    if (!(path.pair.size > 0.0)) path.pair.size = 1.0;
    path.pair.noise = path.pair.size * larger(noise_of(&path.pair.a), noise_of(&path.pair.b));
    path.tolerance = tolerance;
    path.depth_tolerance = depth_tolerance;
    path.smooth = newton_takes(&path.pair);
    return path;
}

static void put_pair(Pair *pair, const M *A, V at_a, const M *B, V at_b)
{
    M At = transpose(A);
    pair->R = product(&At, B);
    pair->r = turn(&At, sub(at_b, at_a));
}
#endif
