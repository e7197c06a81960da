/* All parts of several vehicles and of what rests, at one state of the vehicles, and which pairs of
   them are near.

   A pair is asked for its distance only where nothing else shows it to be far enough: balls about
   the parts, or its last distance less the way that both parts have gone since, in all. */
#ifndef SCENE_H
#define SCENE_H
#include <stdlib.h>
#include <string.h>
#include "answer_row.h"
#include "stride.h"

/* `gone` bounds the way of every point of the part so far. */
typedef struct {
    long vehicle; /* -1: it rests */
    M own_turn, turn;
    V own_place, own_centre, place, centre;
    double radius, gone;
} Slot;

/* A pair of slots: what is asked, and the least distance known for when its parts had gone so far. */
typedef struct { long a, b; double required, least, when; } Link;

typedef struct {
    long vehicles, slots, links;
    int placed, mutual; /* parts of two vehicles are a pair */
    Slot *slot;
    Link *link;
    Path *path;  /* the searches of the links, */
    double *row; /* and their last answers (links, WIDTH) */
    Hull *hull;
    double *state;         /* (vehicles, STATE): where the parts are */
    double *free, *arm;    /* of strides (vehicles, STRIDE), 0 or 1; lengths (vehicles,) */
    double *lower, *upper; /* of positions (vehicles, 3) */
    double *work;          /* of Newton steps: see slide.h */
} Scene;

/* Of a first look, in terms of the size: enough to see that a pair is far away. */
static const double ROUGH = 0.02;

static void put_slots(Scene *s, const double *x)
{
    for (long i = 0; i < s->slots; i++) {
        Slot *own = &s->slot[i];
        if (own->vehicle < 0) continue;
        const double *now = x + STATE * own->vehicle, *old = s->state + STATE * own->vehicle;
        Q q = quaternion_at(now), p = quaternion_at(old);
        M frame = turn_of(q);
        V origin = three(now), centre = add(origin, turn(&frame, own->own_centre)), was = own->centre;
        own->turn = product(&frame, &own->own_turn);
        own->place = add(origin, turn(&frame, own->own_place));
        own->centre = centre;
        /* The chord of the turn, twice the sine of half its angle, is at most twice the shorter of
           q - p and q + p. */
        V less = sub(q.v, p.v), more = add(q.v, p.v);
        double one = dot(less, less) + (q.w - p.w) * (q.w - p.w);
        double other = dot(more, more) + (q.w + p.w) * (q.w + p.w);
        double way = length(sub(centre, was)) + 2.0 * sqrt(fmin(one, other)) * own->radius;
        own->gone += s->placed ? way : 0.0; /* not a number where the radius is infinite */
    }
    s->placed = 1;
    memcpy(s->state, x, sizeof(double) * STATE * s->vehicles);
}

/* Apart by more than that, at a glance. */
static int far_apart(const Slot *a, const Slot *b, double reach)
{
    double sum = reach + a->radius + b->radius;
    V between = sub(b->centre, a->centre);
    return sum < 0.0 || dot(between, between) > sum * sum;
}

static void know(Link *l, double least, double when)
{
    l->least = least;
    l->when = when;
}

/* The distance of a pair where it is `reach` at most, in its row too; else a bound above that. */
static double look(Scene *s, long i, double reach)
{
    Link *l = &s->link[i];
    Path *path = &s->path[i];
    double *row = s->row + WIDTH * i;
    const Slot *a = &s->slot[l->a], *b = &s->slot[l->b];
    double gone = a->gone + b->gone, known = l->least - (gone - l->when);
    if (known > reach) return known;
    Pair *pair = &path->pair;
    put_pair(pair, &a->turn, a->place, &b->turn, b->place);
    int wall = pair->a.kind == HALF_SPACE || pair->b.kind == HALF_SPACE;
    if (!wall) {
        Answer rough = gjk(pair, &path->simplex, ROUGH * pair->size, MOST_STEPS);
        double least = rough.lower - pair->a.pad - pair->b.pad;
        if (!rough.overlap && least > reach) {
            know(l, least, gone);
            return least;
        }
    }
    Answer found = solve(path);
    write_answer(row, &found, pair->a.pad, pair->b.pad, &a->turn, a->place, &b->turn, b->place);
    know(l, row[DISTANCE], gone);
    return l->least;
}

/* Bounds of positions are kept. */
static int within(const Scene *s, const double *x)
{
    for (long i = 0; i < s->vehicles; i++)
        for (int k = 0; k < 3; k++) {
            double r = x[STATE * i + k];
            if (!(r >= s->lower[3 * i + k] && r <= s->upper[3 * i + k])) return 0;
        }
    return 1;
}

/* What is left beyond margins and pad, at least, by all pairs at the state x; negative where one is
   short, and then no more are asked. A pair that has `ample` is not asked for more exactly. */
static double room_at(Scene *s, const double *x, double pad, double ample)
{
    double least = INFINITY;
    put_slots(s, x);
    for (long i = 0; i < s->links && least >= 0.0; i++) {
        Link *l = &s->link[i];
        double reach = l->required + pad, upto = reach + fmin(ample, least);
        if (far_apart(&s->slot[l->a], &s->slot[l->b], upto)) {
            least = fmin(least, ample);
            continue;
        }
        least = fmin(least, look(s, i, upto) - reach);
    }
    return least;
}
#endif
