/* The depth of sets that overlap: the expanding polytope of van den Bergen (Proceedings of the Game
   Developers Conference, 2001), here with its error known.

   The polytope is a hull of members of B - A, so its nearest face bounds the depth from below: the
   sets cannot part by less. Each normal bounds it from above, as planes do.

   Where B - A is another set and all within `round` of it, the hull is that of the other set, and
   every face is that much farther out, provided that the origin is in the hull: what is nearly round
   takes few points. */
#ifndef EXPANDING_H
#define EXPANDING_H
#include "cap.h"
#include "face_heap.h"

/* What the search found: at best the sets part by -`lower` along `normal`, and not by less
   than -`upper`. */
typedef struct { double lower, upper; V normal; } Depth;

/* The member of the inner set that is lowest along n, and the plane bound of n for B - A. */
static Vertex innermost(Pair *pair, const Hull *h, V n, double *bound)
{
    Vertex v = lowest(pair, n, bound);
    v.y = plus(v.y, h->round, n);
    return v;
}

static inline double depth_of(const Hull *h, int f) { return -h->f[f].d - h->round; }

static int set_face(Hull *h, int f, int a, int b, int c)
{
    Face *face = &h->f[f];
    V p = h->p[a].y, m = cross(sub(h->p[b].y, p), sub(h->p[c].y, p));
    double size = length(m);
    face->v[0] = a; face->v[1] = b; face->v[2] = c;
    face->alive = 1;
    face->place = -1;
    if (!(size > 0.0)) { face->m = vec(0, 0, 0); face->d = INFINITY; return 0; }
    face->m = mul(1.0 / size, m);
    /* The mean of the corners' offsets rounds least. */
    face->d = (dot(face->m, p) + dot(face->m, h->p[b].y) + dot(face->m, h->p[c].y)) / 3.0;
    return 1;
}

static int first_hull(Hull *h)
{
    static const int corner[4][3] = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    static const int across[4][3] = {{1, 3, 2}, {2, 3, 0}, {0, 3, 1}, {1, 2, 0}};
    V a = h->p[0].y;
    double six = volume(sub(h->p[1].y, a), sub(h->p[2].y, a), sub(h->p[3].y, a));
    if (six > 0.0) { Vertex t = h->p[1]; h->p[1] = h->p[2]; h->p[2] = t; }
    for (int i = 0; i < 4; i++) {
        if (!set_face(h, i, corner[i][0], corner[i][1], corner[i][2])) return 0;
        for (int j = 0; j < 3; j++) h->f[i].next[j] = across[i][j];
    }
    h->faces = 4;
    h->n_free = h->waiting = 0;
    return 1;
}

/* The hull grows from any four members with a volume, wherever the origin lies. Returns the number
   of dimensions that B - A has; where fewer than three, `flat` is a normal of it. */
static int first_points(Pair *pair, Hull *h, V *flat)
{
    double bound, thin = 1e-9 * pair->size;
    V n = first_direction(pair), s, t;
    h->points = 0;
    h->p[h->points++] = innermost(pair, h, n, &bound);
    tangents(n, 3, &s, &t);
    V tried[3] = {mul(-1.0, n), s, t};
    double farthest = 0.0;
    for (int i = 0; i < 3 && farthest <= 0.1 * pair->size; i++) {
        Vertex v = innermost(pair, h, tried[i], &bound);
        double away = length(sub(v.y, h->p[0].y));
        if (away > farthest) { farthest = away; h->p[1] = v; }
    }
    *flat = n;
    if (farthest <= thin) return 0;
    V e = mul(1.0 / farthest, sub(h->p[1].y, h->p[0].y));
    tangents(e, 3, &s, &t);
    *flat = s;
    double widest = thin;
    int found = 0;
    for (int i = 0; i < 8 && widest <= 0.1 * pair->size; i++) {
        double angle = 2.4 * i;
        Vertex v = innermost(pair, h, plus(mul(cos(angle), s), sin(angle), t), &bound);
        double away = length(cross(e, sub(v.y, h->p[0].y)));
        if (away > widest) { widest = away; h->p[2] = v; found = 1; }
    }
    if (!found) return 1;
    V m = unit_or(cross(e, sub(h->p[2].y, h->p[0].y)), s);
    *flat = m;
    Vertex up = innermost(pair, h, m, &bound), down = innermost(pair, h, mul(-1.0, m), &bound);
    double below = fabs(dot(m, sub(up.y, h->p[0].y)));
    double above = fabs(dot(m, sub(down.y, h->p[0].y)));
    if (larger(below, above) <= thin) return 2;
    h->p[3] = below > above ? up : down;
    h->points = 4;
    return 3;
}

/* Faces that the point sees, from `seed` outwards, and the loop of edges about them. */
static int horizon(Hull *h, int seed, V y, double thin, int *n_seen)
{
    int n_edges = 0, *seen = h->seen, (*edge)[3] = h->edge;
    *n_seen = 0;
    seen[(*n_seen)++] = seed;
    h->f[seed].alive = 0;
    for (int i = 0; i < *n_seen; i++) {
        Face *f = &h->f[seen[i]];
        for (int k = 0; k < 3; k++) {
            int g = f->next[k];
            if (!h->f[g].alive) continue;
            if (dot(h->f[g].m, y) > h->f[g].d + thin) {
                h->f[g].alive = 0;
                seen[(*n_seen)++] = g;
            }
        }
    }
    for (int i = 0; i < *n_seen; i++) {
        Face *f = &h->f[seen[i]];
        for (int k = 0; k < 3; k++) {
            int g = f->next[k];
            if (!h->f[g].alive) continue;
            edge[n_edges][0] = f->v[k];
            edge[n_edges][1] = f->v[(k + 1) % 3];
            edge[n_edges++][2] = g;
        }
    }
    return n_edges;
}

static void link_across(Hull *h, int f, int a, int b, int g)
{
    for (int k = 0; k < 3; k++)
        if (h->f[f].v[k] == a && h->f[f].v[(k + 1) % 3] == b) h->f[f].next[k] = g;
}

/* Adds the last point, which sees the face `seed`. Returns the number of faces made, or 0 where
   rounding leaves no sound hull. */
static int grow(Hull *h, int seed, double thin)
{
    int n_seen, p = h->points - 1, *seen = h->seen, (*edge)[3] = h->edge, *made = h->made;
    int n_edges = horizon(h, seed, h->p[p].y, thin, &n_seen);
    if (n_edges < 3) return 0;
    for (int i = 0; i < n_edges; i++) {
        int f = i < n_seen ? seen[i] : h->n_free > 0 ? h->free[--h->n_free] : h->faces++;
        if (f >= MOST_FACES) return 0;
        made[i] = f;
    }
    for (int i = 0; i < n_seen; i++) withdraw(h, seen[i]);
    for (int i = n_edges; i < n_seen; i++) h->free[h->n_free++] = seen[i];
    for (int i = 0; i < n_edges; i++) {
        if (!set_face(h, made[i], edge[i][0], edge[i][1], p)) return 0;
        h->f[made[i]].next[0] = edge[i][2];
        h->f[made[i]].next[1] = h->f[made[i]].next[2] = -1;
        link_across(h, edge[i][2], edge[i][1], edge[i][0], made[i]);
    }
    for (int i = 0; i < n_edges; i++)
        for (int j = 0; j < n_edges; j++)
            if (edge[j][0] == edge[i][1]) {
                if (h->f[made[i]].next[1] >= 0) return 0;
                h->f[made[i]].next[1] = made[j];
                h->f[made[j]].next[2] = made[i];
            }
    for (int i = 0; i < n_edges; i++)
        if (h->f[made[i]].next[1] < 0 || h->f[made[i]].next[2] < 0) return 0;
    return n_edges;
}

/* New faces wait to be looked at, unless they or the cap prove enough as they are. Returns the most that one of
   those leaves open, or the `passed` before. */
static double sort_out(Hull *h, const Cap *cap, const int *faces, int n, double enough, double passed)
{
    for (int i = 0; i < n; i++) {
        const Face *f = &h->f[faces[i]];
        double depth = depth_of(h, faces[i]);
        if (depth <= enough) passed = larger(passed, depth);
        else if (in_cap(cap, f->m, f->d, -enough)) passed = larger(passed, cap->lower);
        else enter(h, faces[i]);
    }
    return passed;
}

/* Until the faces at hand prove what is found, or points run out; `sound` tells whether the origin is
   in the hull. If not, its faces prove nothing: what is peeled is too much. */
static Depth refine(Pair *pair, Hull *h, const Cap *cap, Depth found, double tolerance, double passed,
                    int *sound)
{
    pair->slack = 0.1 * tolerance;
    for (;;) {
        int f = h->waiting ? h->heap[0] : -1;
        double bound, depth = larger(passed, f < 0 ? -INFINITY : depth_of(h, f));
        *sound = depth <= -h->round;
        if (*sound) found.upper = fmin(found.upper, depth);
        if (f < 0 || found.lower >= depth_of(h, f) - tolerance) break;
        V n = mul(-1.0, h->f[f].m);
        const Vertex *near = &h->p[h->f[f].v[0]];
        pair->memory_a.point = near->a;
        pair->memory_b.point = near->b;
        Vertex v = innermost(pair, h, n, &bound);
        if (bound > found.lower) { found.lower = bound; found.normal = n; }
        if (dot(h->f[f].m, v.y) - h->f[f].d <= tolerance || h->points == MOST_POINTS) break;
        h->p[h->points++] = v;
        int made = grow(h, f, 1e-14 * pair->size);
        if (!made) { *sound = 0; break; }
        passed = sort_out(h, cap, h->made, made, found.lower + tolerance, passed);
    }
    pair->slack = 0.0;
    return found;
}

/* With the hull that of the set peeled by `round`. */
static Depth expand_peeled(Pair *pair, Hull *h, const Cap *cap, Depth found, double tolerance,
                           double round, int *sound)
{
    static const int first[4] = {0, 1, 2, 3};
    double bound;
    V flat;
    h->round = round;
    *sound = 0;
    if (first_points(pair, h, &flat) < 3) {
        lowest(pair, flat, &bound);
        *sound = round == 0.0;
        if (!*sound || bound <= found.lower) return found;
        return (Depth){bound, larger(bound, 0.0), flat};
    }
    if (!first_hull(h)) return found;
    double passed = sort_out(h, cap, first, 4, found.lower + tolerance, -INFINITY);
    found = refine(pair, h, cap, found, tolerance, passed, sound);
    if (*sound && round == 0.0) h->owner = pair;
    return found;
}

/* The hull of another pose: its members only move, and its faces still close around the origin if all
   have it to their inner side. They need not make a convex body: each direction is covered by a face,
   which is no nearer than its plane. */
static Depth go_on(Pair *pair, Hull *h, const Cap *cap, Depth found, double tolerance, int *sound)
{
    double passed = -INFINITY;
    *sound = 0;
    h->waiting = 0;
    for (int i = 0; i < h->points; i++) h->p[i].y = difference(pair, h->p[i].a, h->p[i].b);
    for (int f = 0; f < h->faces; f++) {
        const int *v = h->f[f].v;
        if (!h->f[f].alive) continue;
        if (!set_face(h, f, v[0], v[1], v[2]) || h->f[f].d <= 0.0) return found;
        passed = sort_out(h, cap, &f, 1, found.lower + tolerance, passed);
    }
    return refine(pair, h, cap, found, tolerance, passed, sound);
}

/* From a normal whose bound is known; ends where no other normal can be better by more than the
   tolerance, or where points run out: `upper` says how much is left open. What is peeled is less than
   the depth, or the origin would be left outside. */
static Depth expand(Pair *pair, Hull *h, const Cap *cap, Depth found, double tolerance)
{
    double most = cap->sine > 0.0 ? 0.0 : roundness(&pair->a) + roundness(&pair->b);
    int sound = 0;
    if (h->owner == pair && h->points <= MOST_CARRIED) {
        found = go_on(pair, h, cap, found, tolerance, &sound);
        if (sound) return found;
    }
    h->owner = 0;
    for (double part = 0.8; part > 0.1 && most > 0.0; part -= 0.4) {
        double round = fmin(most, isfinite(found.lower) ? -part * found.lower : most);
        if (round <= 10.0 * tolerance) break;
        found = expand_peeled(pair, h, cap, found, tolerance, round, &sound);
        if (sound) return found;
    }
    return expand_peeled(pair, h, cap, found, tolerance, 0.0, &sound);
}
#endif
