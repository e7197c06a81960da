/* A hull of members of B - A, and its faces that wait in the order of their distance. */
#ifndef FACE_HEAP_H
#define FACE_HEAP_H
#include <stdlib.h>
#include "gjk.h"

/* Enough for a ring of directions that are equally good, as of bodies about one axis; and so many
   points a pose may hand on to the next. */
enum { MOST_CARRIED = 32, MOST_POINTS = 40000, MOST_FACES = 2 * MOST_POINTS };

/* next[i] lies across v[i] v[i+1]; `place` is that in the heap, or -1. */
typedef struct { int v[3], next[3], alive, place; V m; double d; } Face;

typedef struct {
    double round;
    Vertex p[MOST_POINTS];
    Face f[MOST_FACES];
    const Pair *owner; /* whose faces close around the origin, 0 for none */
    int points, faces, free[MOST_FACES], n_free, heap[MOST_FACES], waiting;
    int seen[MOST_FACES], edge[MOST_FACES][3], made[MOST_FACES]; /* while it grows */
} Hull;

static Hull *new_hull(void)
{
    Hull *h = malloc(sizeof(Hull));
    if (h) h->owner = 0;
    return h;
}

static inline void put_at(Hull *h, int i, int f)
{
    h->heap[i] = f;
    h->f[f].place = i;
}

static void rise(Hull *h, int i, int f)
{
    for (int up; i > 0 && h->f[h->heap[up = (i - 1) / 2]].d > h->f[f].d; i = up)
        put_at(h, i, h->heap[up]);
    put_at(h, i, f);
}

static void enter(Hull *h, int f) { rise(h, h->waiting++, f); }

static void withdraw(Hull *h, int f)
{
    int i = h->f[f].place;
    if (i < 0) return;
    h->f[f].place = -1;
    int last = h->heap[--h->waiting];
    if (last == f) return;
    for (int child; (child = 2 * i + 1) < h->waiting; i = child) {
        if (child + 1 < h->waiting && h->f[h->heap[child + 1]].d < h->f[h->heap[child]].d) child++;
        if (h->f[h->heap[child]].d >= h->f[last].d) break;
        put_at(h, i, h->heap[child]);
    }
    rise(h, i, last);
}
#endif
