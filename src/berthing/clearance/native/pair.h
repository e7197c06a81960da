/* The signed distance of one pair at one pose. */
#ifndef PAIR_H
#define PAIR_H
#include "ascend.h"
#include "expanding_plane.h"
#include "newton.h"

/* What one pose leaves for the next one of a path. */
typedef struct {
    Pair pair;
    Simplex simplex;
    Closest closest, before;
    Hull *hull;
    double tolerance, depth_tolerance;
    int smooth;
} Path;

/* Gap, in terms of the size, to which sets that overlap or nearly touch are parted. */
static const double PARTED = 0.05, TOUCHING = 1e-3;
/* Closest points that move further than this from pose to pose, in terms of the size, may go anywhere. */
static const double LEAP = 0.1;
enum { MOST_STEPS = 300, MOST_PARTINGS = 300 };

/* The direction that a slowing row of steps points to: each is q times the one before. */
static V extrapolated(V n, V step, V before)
{
    double q = dot(step, before) / dot(before, before);
    if (!(q > 0.0) || !isfinite(q)) return n;
    q = fmin(q, 0.995);
    return unit_or(plus(n, q / (1.0 - q), step), n);
}

/* The best normal near a given one. Parted along a normal n by s = |s| n, the sets have the
   distance bound(m) + m·s, m being the normal there: the largest such sum, so that bound(m) >=
   bound(n) + (n - m)·s >= bound(n). Repeated, this climbs to a normal that is its own; every third
   step goes on to where the last two point, if that is no worse. `still` tells whether it ended at such
a normal, or after that many steps. */
static Answer settle(Path *path, Answer start, int most, int *still)
{
    Pair *pair = &path->pair;
    V r = pair->r, n = start.normal, step = vec(0, 0, 0);
    Answer best = start;
    double bound, rounding = pair->noise, least = INFINITY;
    lowest(pair, n, &bound);
    best.lower = bound;
    *still = 0;
    for (int i = 0, idle = 0; i < most && idle < 3; i++) {
        pair->r = plus(r, PARTED * pair->size - bound, n);
        Answer parted = gjk(pair, &path->simplex, rounding, MOST_STEPS);
        pair->r = r;
        if (parted.overlap) { path->simplex.n = 0; break; }
        V before = step;
        double old = bound;
        step = sub(parted.normal, n);
        n = parted.normal;
        lowest(pair, n, &bound);
        idle = bound - old <= rounding ? idle + 1 : 0;
        /* Of normals equally good, the one that changed least has witnesses that fit it best. */
        double moved = length(step);
        double same = 1e3 * rounding;
        if (bound > best.lower + same || (bound >= best.lower - same && moved <= least)) {
            least = moved;
            best.lower = larger(bound, best.lower);
            best.normal = n;
            best.a = parted.a;
            best.b = parted.b;
        }
        *still = moved <= 1e-11;
        if (*still) break;
        if (i % 3 == 2) {
            V ahead = extrapolated(n, step, before);
            lowest(pair, ahead, &old);
            if (old >= bound - rounding) { n = ahead; bound = old; step = vec(0, 0, 0); }
        }
    }
    best.upper = length(difference(pair, best.a, best.b));
    return best;
}

static int half_space(const Pair *pair, Answer *answer)
{
    const Shape *wall = pair->a.kind == HALF_SPACE ? &pair->a : &pair->b;
    const Shape *other = wall == &pair->a ? &pair->b : &pair->a;
    Memory memory = {{0, 0, 0}, 0};
    if (wall->kind != HALF_SPACE) return 0;
    V own = three(wall->data);
    V n = wall == &pair->a ? own : mul(-1.0, turn(&pair->R, own));
    V towards = wall == &pair->a ? mul(-1.0, unturn(&pair->R, n)) : n;
    Support s = support(other, towards, &memory, 0.0);
    V deepest = s.point, world = wall == &pair->a ? add(pair->r, turn(&pair->R, deepest)) : deepest;
    V in_wall = wall == &pair->a ? world : unturn(&pair->R, sub(world, pair->r));
    double gap = dot(own, in_wall) - wall->data[3];
    V on_wall = plus(in_wall, -gap, own);
    *answer = (Answer){gap - s.slack, gap, n, wall == &pair->a ? on_wall : deepest,
                       wall == &pair->a ? deepest : on_wall, gap < 0.0};
    return 1;
}

/* A few partings come near enough for Newton's method; where it fails they go on. */
static Answer settled(Path *path, Answer start)
{
    int still;
    Answer near = settle(path, start, 3, &still);
    still = still && path->pair.noise <= 2e-15 * path->pair.size; /* exact support points */
    if (still || ascend(&path->pair, &near.normal, &near.lower, &near.a, &near.b)) return near;
    near = settle(path, near, MOST_PARTINGS, &still);
    if (!still) ascend(&path->pair, &near.normal, &near.lower, &near.a, &near.b);
    return near;
}

/* Sets that overlap, or so nearly that the vector between them has no clear direction. */
static Answer overlapping(Path *path, Answer known)
{
    Pair *pair = &path->pair;
    Depth depth = {known.lower, isfinite(known.upper) ? known.upper : 0.0, known.normal};
    Cap cap = path->closest.known ? cap_of(pair, &known) : NO_CAP;
    if (!path->closest.known) path->hull->owner = 0;
    if (pair->dim == 2) depth = expand_plane(pair, path->hull, depth, path->depth_tolerance);
    else depth = expand(pair, path->hull, &cap, depth, path->depth_tolerance);
    Answer best = known;
    if (depth.lower > known.lower || !isfinite(known.lower)) {
        best.normal = length(depth.normal) > 0.0 ? depth.normal : first_direction(pair);
        best.lower = depth.lower;
        if (path->smooth) {
            double bound;
            Vertex v = lowest(pair, best.normal, &bound);
            Closest at = {v.a, v.b, 1};
            Answer polished;
            if (newton(pair, &at, &polished) && polished.lower >= depth.lower - path->depth_tolerance) {
                path->closest = at;
                polished.upper = larger(depth.upper, polished.lower);
                polished.overlap = 1;
                return polished;
            }
        }
        best = settled(path, best);
    }
    best.upper = larger(depth.upper, best.lower);
    best.overlap = 1;
    return best;
}

/* Along the straight line through the last two solutions, unless they are far apart. */
static Closest onwards(const Path *path)
{
    const Closest *now = &path->closest, *then = &path->before;
    V w = sub(now->w, then->w), p = sub(now->p, then->p);
    double far = sqrt(dot(w, w) + dot(p, p));
    if (!then->known || far > LEAP * path->pair.size) return *now;
    return (Closest){add(now->w, w), add(now->p, p), 1};
}

/* From the last solution along the path, or from where a rough search by support points ends. */
static int by_newton(Path *path, Answer *answer)
{
    Pair *pair = &path->pair;
    if (path->closest.known) {
        Closest at = onwards(path);
        path->before = path->closest;
        int there = newton(pair, &at, answer);
        if (there && (answer->overlap || answer->upper - answer->lower <= path->tolerance)) {
            path->closest = at;
            return 1;
        }
    }
    path->closest.known = path->before.known = 0;
    Answer rough = gjk(pair, &path->simplex, 1e-3 * pair->size, MOST_STEPS);
    if (rough.overlap) return 0;
    double bound;
    Vertex v = lowest(pair, rough.normal, &bound);
    Closest at = {v.a, v.b, 1};
    if (!newton(pair, &at, answer) || answer->overlap) return 0;
    if (answer->upper - answer->lower > path->tolerance) return 0;
    path->closest = at;
    return 1;
}

/* A normal is known to the root of twice the bracket by the distance. */
static const double VAGUE = 1e-13;

static void sharpen(Pair *pair, Answer *answer)
{
    Answer sharp = *answer;
    if (!ascend(pair, &sharp.normal, &sharp.lower, &sharp.a, &sharp.b)) return;
    sharp.upper = length(difference(pair, sharp.a, sharp.b));
    if (sharp.upper - sharp.lower < answer->upper - answer->lower) *answer = sharp;
}

static Answer solve(Path *path)
{
    Pair *pair = &path->pair;
    Answer answer;
    if (half_space(pair, &answer)) return answer;
    int newton_knows = path->smooth && by_newton(path, &answer);
    if (newton_knows && !answer.overlap) return answer;
    Answer found = gjk(pair, &path->simplex, pair->noise, MOST_STEPS);
    /* From the last pose's points Newton may get to where sets apart look as if they overlapped. */
    if (newton_knows && found.overlap) return overlapping(path, answer);
    path->closest.known = 0;
    answer = found;
    if (answer.overlap) {
        answer.lower = -INFINITY;
        answer.upper = 0.0;
        return overlapping(path, answer);
    }
    if (answer.upper <= TOUCHING * pair->size || answer.upper - answer.lower > path->tolerance) {
        int still;
        Answer tried = settle(path, answer, MOST_PARTINGS, &still);
        tried.upper = fmin(tried.upper, answer.upper);
        if (tried.lower >= answer.lower) answer = tried;
    }
    if (answer.upper - answer.lower > larger(VAGUE * answer.upper, 10.0 * pair->noise)) sharpen(pair, &answer);
    return answer.upper - answer.lower > path->tolerance ? overlapping(path, answer) : answer;
}
#endif
