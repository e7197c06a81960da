/* The same in the plane: a polygon in counter-clockwise order. */
#ifndef EXPANDING_PLANE_H
#define EXPANDING_PLANE_H
#include "expanding.h"

static double edge_of(const Vertex *p, int i, int n, V *m)
{
    V a = p[i].y, b = p[(i + 1) % n].y, e = sub(b, a);
    double size = length(e);
    if (!(size > 0.0)) return INFINITY;
    *m = vec(e.y / size, -e.x / size, 0.0);
    return 0.5 * (dot(*m, a) + dot(*m, b));
}

/* A triangle, or fewer points where B - A is flat; then `flat` is a normal of it. */
static int first_triangle(Pair *pair, Vertex *p, V *flat)
{
    double bound, thin = 1e-9 * pair->size;
    V n = first_direction(pair), across = vec(-n.y, n.x, 0.0);
    V tried[4] = {n, mul(-1.0, n), across, mul(-1.0, across)};
    int count = 0;
    for (int i = 0; i < 4; i++) {
        Vertex v = lowest(pair, tried[i], &bound);
        if (count == 0 || (count == 1 && length(sub(v.y, p[0].y)) > thin)) p[count++] = v;
    }
    *flat = n;
    if (count < 2) return count;
    V e = unit_or(sub(p[1].y, p[0].y), n), m = vec(-e.y, e.x, 0.0);
    *flat = m;
    Vertex low = lowest(pair, m, &bound), high = lowest(pair, mul(-1.0, m), &bound);
    double below = -dot(m, sub(low.y, p[0].y)), above = dot(m, sub(high.y, p[0].y));
    if (larger(below, above) <= thin) return 2;
    if (above >= below) { p[2] = high; return 3; }
    p[2] = p[1];
    p[1] = low;
    return 3;
}

static Depth expand_plane(Pair *pair, Hull *h, Depth found, double tolerance)
{
    double bound;
    V flat, m = vec(0, 0, 0), lowest_m = m;
    int n = first_triangle(pair, h->p, &flat);
    if (n < 3) {
        lowest(pair, flat, &bound);
        return bound > found.lower ? (Depth){bound, larger(bound, 0.0), flat} : found;
    }
    for (;;) {
        double d = INFINITY;
        int at_edge = -1;
        for (int i = 0; i < n; i++) {
            double offset = edge_of(h->p, i, n, &m);
            if (offset < d) { d = offset; at_edge = i; lowest_m = m; }
        }
        if (at_edge < 0) break;
        if (d >= 0.0) found.upper = fmin(found.upper, -d);
        if (found.lower >= -d - tolerance) break;
        V normal = mul(-1.0, lowest_m);
        Vertex v = lowest(pair, normal, &bound);
        if (bound > found.lower) { found.lower = bound; found.normal = normal; }
        if (dot(lowest_m, v.y) - d <= tolerance || n == MOST_POINTS) break;
        for (int i = n++; i > at_edge + 1; i--) h->p[i] = h->p[i - 1];
        h->p[at_edge + 1] = v;
    }
    return found;
}
#endif
