/* Pushing a state out of what it is too near to, so that a search slides along things. */
#ifndef SLIDE_H
#define SLIDE_H
#include "scene.h"

/* How a state is settled: rounds of Newton steps, the pad beyond margins, how far in a state is given
   up, and by which share of the pad a push aims beyond it; singular values of the pushes below that
   share of the largest count little. */
typedef struct { double rounds, pad, deep, beyond, rank; } Settling;

static void add_pushes(const Scene *s, long i, double *push)
{
    const Link *l = &s->link[i];
    const double *row = s->row + WIDTH * i;
    V n = three(row + NORMAL);
    V middle = mul(0.5, add(three(row + WITNESSES), three(row + WITNESSES + 3)));
    long ends[2] = {l->a, l->b};
    memset(push, 0, sizeof(double) * STRIDE * s->vehicles);
    for (int e = 0; e < 2; e++) {
        long v = s->slot[ends[e]].vehicle;
        if (v < 0) continue;
        V force = e ? n : mul(-1.0, n), torque = cross(sub(middle, three(s->state + STATE * v)), force);
        double arm = s->arm[v] > 0.0 ? s->arm[v] : 1.0, *own = push + STRIDE * v;
        for (int k = 0; k < 3; k++) {
            own[k] += s->free[STRIDE * v + k] * at(force, k);
            own[3 + k] += s->free[STRIDE * v + 3 + k] * at(torque, k) / arm;
        }
    }
}

/* x of (N + mu) x = b, N of `n` columns in its lower part, by Cholesky's method; all in place. */
static void solve_damped(long n, double *N, double mu, double *b)
{
    for (long j = 0; j < n; j++) {
        double *Nj = N + n * j, d = Nj[j] + mu;
        for (long k = 0; k < j; k++) d -= Nj[k] * Nj[k];
        Nj[j] = d = sqrt(larger(d, 0.5 * mu));
        for (long k = 0; k < j; k++) b[j] -= Nj[k] * b[k];
        b[j] /= d;
        for (long i = j + 1; i < n; i++) {
            double *Ni = N + n * i, e = Ni[j];
            for (long k = 0; k < j; k++) e -= Ni[k] * Nj[k];
            Ni[j] = e / d;
        }
    }
    for (long j = n - 1; j >= 0; j--) {
        for (long i = j + 1; i < n; i++) b[j] -= N[n * i + j] * b[i];
        b[j] /= N[n * j + j];
    }
}

/* One step of least length that gives every pair what it lacks; 1 where none lacks anything, -1
   where one lacks too much. */
static int push_out(Scene *s, double *x, const Settling *how)
{
    long n = STRIDE * s->vehicles;
    double *N = s->work, *b = N + n * n, *push = b + n, trace = 0.0;
    memset(N, 0, sizeof(double) * (n * n + n));
    put_slots(s, x);
    for (long i = 0; i < s->links; i++) {
        double reach = s->link[i].required + how->pad;
        if (far_apart(&s->slot[s->link[i].a], &s->slot[s->link[i].b], reach)) continue;
        double lacks = reach - look(s, i, reach);
        if (!(lacks > 0.0)) continue;
        if (lacks > how->deep) return -1;
        lacks += how->beyond * how->pad;
        add_pushes(s, i, push);
        for (long j = 0; j < n; j++) {
            if (push[j] == 0.0) continue;
            trace += push[j] * push[j];
            b[j] += push[j] * lacks;
            for (long k = 0; k <= j; k++) N[n * j + k] += push[j] * push[k];
        }
    }
    if (!(trace > 0.0)) return 1;
    solve_damped(n, N, how->rank * how->rank * trace, b);
    for (long v = 0; v < s->vehicles; v++)
        for (int k = 3; k < STRIDE; k++) b[STRIDE * v + k] /= s->arm[v] > 0.0 ? s->arm[v] : 1.0;
    move_by(s->vehicles, x, b, 1.0, x);
    for (long v = 0; v < s->vehicles; v++)
        for (int k = 0; k < 3; k++) {
            double *r = &x[STATE * v + k];
            *r = fmin(fmax(*r, s->lower[3 * v + k]), s->upper[3 * v + k]);
        }
    return 0;
}

/* Moves x to a state near it that keeps margins and pad; 0 where none was found. */
static int settle_state(Scene *s, double *x, const Settling *how)
{
    for (int round = 0; round < (int)how->rounds; round++) {
        int found = push_out(s, x, how);
        if (found) return found > 0 && within(s, x);
    }
    return within(s, x) && room_at(s, x, how->pad, 0.0) >= 0.0;
}
#endif
