/* Signed distances of two placed convex sets, with proofs: see the headers, one idea each. */
#include <stdlib.h>
#include "route_calls.h"

/* k poses of each set as rotations (9) and positions (3), `step` doubles apart (0: one for all), in
   the order of a path: each search starts where the last one ended. Returns the number of answers
   whose bounds are further apart than the tolerance, or -1 without memory. */
long berthing_distances(const double *a, const double *b, int dim, long k, const double *RA,
                        const double *rA, long step_a, const double *RB, const double *rB,
                        long step_b, double tolerance, double depth_tolerance, double *out)
{
    Path path = path_of(a, b, dim, tolerance, depth_tolerance);
    long open = 0;
    path.hull = new_hull();
    if (!path.hull) return -1;
    for (long i = 0; i < k; i++, out += WIDTH) {
        M A = rows(RA + 9 * step_a * i), B = rows(RB + 9 * step_b * i);
        V pa = three(rA + 3 * step_a * i), pb = three(rB + 3 * step_b * i);
        put_pair(&path.pair, &A, pa, &B, pb);
        Answer s = solve(&path);
        write_answer(out, &s, path.pair.a.pad, path.pair.b.pad, &A, pa, &B, pb);
        open += !(s.upper - s.lower <= tolerance);
    }
    free(path.hull);
    return open;
}
