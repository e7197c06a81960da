/* Signed distances of two placed convex sets, with proofs: see the headers, one idea each. */
#include <stdlib.h>
#include "pair.h"

/* Of an answer, in doubles: lower bound, upper bound, normal, witnesses, gradients with respect to
   the pose of A and that of B: force-like, then torque-like, about each pose's own origin. */
enum { WIDTH = 24 };

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
    out[2] = d;
    double *next = write3(write3(write3(out + 3, n), a), b);
    V middle = mul(0.5, add(a, b)); /* of the line on which both lie */
    next = write3(next, mul(-1.0, n));
    next = write3(next, cross(n, sub(middle, rA)));
    next = write3(next, n);
    write3(next, cross(sub(middle, rB), n));
}

/* k poses of each set as rotations (9) and positions (3), `step` doubles apart (0: one for all), in
   the order of a path: each search starts where the last one ended. Returns the number of answers
   whose bounds are further apart than the tolerance, or -1 without memory. */
long berthing_distances(const double *a, const double *b, int dim, long k, const double *RA,
                        const double *rA, long step_a, const double *RB, const double *rB,
                        long step_b, double tolerance, double depth_tolerance, double *out)
{
    Path path = {.pair = {.a = shape_from(a, dim), .b = shape_from(b, dim), .dim = dim}};
    long open = 0;
    path.hull = malloc(sizeof(Hull));
    if (!path.hull) return -1;
    path.pair.size = path.pair.a.size + path.pair.b.size;
    if (!(path.pair.size > 0.0)) path.pair.size = 1.0;
    path.pair.noise = path.pair.size * larger(noise_of(&path.pair.a), noise_of(&path.pair.b));
    path.tolerance = tolerance;
    path.depth_tolerance = depth_tolerance;
    path.smooth = newton_takes(&path.pair);
    for (long i = 0; i < k; i++, out += WIDTH) {
        M A = rows(RA + 9 * step_a * i), B = rows(RB + 9 * step_b * i), At = transpose(&A);
        V pa = three(rA + 3 * step_a * i), pb = three(rB + 3 * step_b * i);
        path.pair.R = product(&At, &B);
        path.pair.r = turn(&At, sub(pb, pa));
        Answer s = solve(&path);
        write_answer(out, &s, path.pair.a.pad, path.pair.b.pad, &A, pa, &B, pb);
        open += !(s.upper - s.lower <= tolerance);
    }
    free(path.hull);
    return open;
}
