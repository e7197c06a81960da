/* Support points of every core. */
#ifndef SUPPORT_H
#define SUPPORT_H
#include "conic_polish.h"
#include "smooth.h"

enum { MOST_ROWS = 256 };

/* Slack, in terms of the size, above which a smoothed polytope is approached another way. */
static const double ASTRAY = 1e-13;

/* By way of rounder sets, with exponents 1/64, 1/16 and 1/4 as large: each is easy from the one
   before. Those that have nothing left are passed over. */
static Support by_rounder_sets(const Shape *s, V n)
{
    int count = (int)s->data[0];
    double scaled[4 + 4 * MOST_ROWS];
    V start = plus(middle(s), s->size, n);
    if (count <= MOST_ROWS) {
        for (double part = 1.0 / 64.0; part < 1.0; part *= 4.0) {
            Shape round = *s;
            memcpy(scaled, s->data, 4 * sizeof(double));
            for (int i = 4; i < 4 + 4 * count; i++) scaled[i] = part * s->data[i];
            round.data = scaled;
            if (level_of(&round, middle(s)).f < -1e-3) start = climb(&round, n, start, 0.0).point;
        }
    }
    return climb(s, n, start, 0.0);
}

static Support log_sum_exp_point(const Shape *s, V n, Memory *memory, double enough)
{
    double limit = larger(ASTRAY * s->size, enough);
    V straight = plus(middle(s), s->size, n);
    Support found = climb(s, n, memory->known ? memory->point : straight, enough);
    if (found.slack > limit && memory->known) {
        Support again = climb(s, n, straight, enough);
        if (again.slack < found.slack) found = again;
    }
    if (found.slack > limit) {
        Support again = by_rounder_sets(s, n);
        if (again.slack < found.slack) found = again;
    }
    *memory = (Memory){found.point, 1};
    return found;
}

/* Of support points, in terms of the size: rounding. */
static inline double noise_of(const Shape *s) { return s->kind == CONIC ? 1e-14 : 1e-15; }

/* Along the unit vector n, in the set's own frame; a search may stop at a slack that is enough. */
static Support support(const Shape *s, V n, Memory *memory, double enough)
{
    const double *d = s->data;
    V p = vec(0.0, 0.0, 0.0);
    switch (s->kind) {
    case POINT:
        break;
    case SEGMENT:
        put(&p, (int)d[0], signed_by(d[1], at(n, (int)d[0])));
        break;
    case BOX:
        p = vec(signed_by(d[0], n.x), signed_by(d[1], n.y), signed_by(d[2], n.z));
        break;
    case ELLIPSOID:
        p = ellipsoid_point(d, n);
        break;
    case CYLINDER:
        p = mul(d[1], across_axis(n, (int)d[0]));
        put(&p, (int)d[0], signed_by(d[2], at(n, (int)d[0])));
        break;
    case FRUSTUM:
        p = frustum_point(d, n);
        break;
    case POLYTOPE:
        p = polytope_point(d, n);
        break;
    case SUPERELLIPSOID:
        p = superellipsoid_point(d, n);
        break;
    case SMOOTHED_BOX:
        p = box_point(d, s->dim, n);
        break;
    case CONIC:
        return conic_point(d, s->dim, n);
    case LOG_SUM_EXP:
        return log_sum_exp_point(s, n, memory, enough);
    default:
        break;
    }
    return (Support){p, 0.0};
}
#endif
