/* What searches for routes ask, a whole extension, leg or batch of states in one call. */
#ifndef ROUTE_CALLS_H
#define ROUTE_CALLS_H
#include "slide.h"

/* Numbers of a slot that is given: rotation, place, middle of its ball, radius. */
enum { SLOT_NUMBERS = 16 };

void berthing_scene_free(Scene *s)
{
    if (!s) return;
    free(s->slot);
    free(s->link);
    free(s->path);
    free(s->row);
    free(s->hull);
    free(s->state);
    free(s);
}

static double *put_by(double **next, long count)
{
    double *here = *next;
    *next += count;
    return here;
}

static double *copied(double **next, const double *from, long count)
{
    return memcpy(put_by(next, count), from, sizeof(double) * count);
}

/* Parts by slot, with their vehicle or -1; pairs by the slots of both (links, 2), the numbers of
   both sets (links, 2) and what is required. Of the vehicles, as Scene names them: free, arm, lower,
   upper. What sets are given by has to outlive the scene. 0 without memory. */
Scene *berthing_scene_new(long vehicles, long slots, long links, int dim, const long *vehicle,
                          const double *slot, const long *ends, const double *const *sets,
                          const double *required, const double *of_vehicles, double tolerance,
                          double depth_tolerance)
{
    long n = STRIDE * vehicles;
    Scene *s = calloc(1, sizeof(Scene));
    if (!s) return 0;
    *s = (Scene){.vehicles = vehicles, .slots = slots, .links = links};
    s->slot = calloc(slots + 1, sizeof(Slot));
    s->link = calloc(links + 1, sizeof(Link));
    s->path = calloc(links + 1, sizeof(Path));
    s->row = calloc(WIDTH * (links + 1), sizeof(double));
    s->hull = new_hull();
    double *next = s->state = calloc((2 * STATE + 13) * vehicles + n * n + 3 * n + 1, sizeof(double));
    if (!s->slot || !s->link || !s->path || !s->row || !s->hull || !next) {
        berthing_scene_free(s);
        return 0;
    }
    put_by(&next, STATE * vehicles);
    s->free = copied(&next, of_vehicles, n);
    s->arm = copied(&next, of_vehicles + n, vehicles);
    s->lower = copied(&next, of_vehicles + n + vehicles, 3 * vehicles);
    s->upper = copied(&next, of_vehicles + n + 4 * vehicles, 3 * vehicles);
    s->work = next;
    for (long i = 0; i < slots; i++, slot += SLOT_NUMBERS) {
        M turn = rows(slot);
        V place = three(slot + 9), centre = three(slot + 12);
        s->slot[i] = (Slot){vehicle[i], turn, turn, place, centre, place, centre, slot[15], 0.0};
    }
    for (long i = 0; i < links; i++) {
        s->link[i] = (Link){ends[2 * i], ends[2 * i + 1], required[i], -INFINITY, 0.0};
        s->path[i] = path_of(sets[2 * i], sets[2 * i + 1], dim, tolerance, depth_tolerance);
        s->path[i].hull = s->hull;
        s->mutual |= vehicle[ends[2 * i]] >= 0 && vehicle[ends[2 * i + 1]] >= 0;
    }
    return s;
}

/* Of states (k, vehicles, STATE): 1 for those that keep limits, margins and pad. */
void berthing_scene_valid(Scene *s, long k, const double *x, double pad, unsigned char *out)
{
    for (long i = 0; i < k; i++, x += STATE * s->vehicles)
        out[i] = within(s, x) && room_at(s, x, pad, 0.0) >= 0.0;
}

int berthing_scene_settle(Scene *s, double *x, const double *how)
{
    const Settling *own = (const Settling *)how;
    return settle_state(s, x, own);
}

/* States from `from` towards the target, a step apart at most, each settled, as far as they lead
   nearer by `progress` each. Where `whole`, a target within a step is met as it is. Returns how many
   there are in `out`, at most `most`. */
long berthing_scene_extend(Scene *s, const double *from, const double *target, double step,
                           double progress, int whole, const double *how, long most, double *out,
                           int *met)
{
    long count = s->vehicles, size = STATE * count;
    double *way = s->work + STRIDE * count * (STRIDE * count + 2);
    stride_between(count, from, target, way);
    double left = stride_length(count, way, s->arm);
    *met = 0;
    for (long i = 0; i < most; i++, out += size) {
        int last = left <= step;
        if (last) memcpy(out, target, sizeof(double) * size);
        else move_by(count, from, way, step / left, out);
        if (last && whole) {
            *met = 1;
            return i + 1;
        }
        if (!berthing_scene_settle(s, out, how)) return i;
        stride_between(count, out, target, way);
        double ahead = stride_length(count, way, s->arm);
        if (ahead > left - progress) return i;
        left = ahead;
        from = out;
        if (last) return i + 1;
    }
    return most;
}

/* Glances at a leg before it is looked at from end to end: at eighths. And beyond how many steps of
   room no more is gained by knowing of it. */
static const double LEAST_GLANCE = 0.125, AMPLE = 3.0;

/* At states (k, vehicles, STATE), the pairs that keep less than `reach` beyond what is required: the
   state of each, how much it keeps, and how that grows by a stride, turns times the arm (vehicles,
   STRIDE). Returns how many there are, of which `most` at most are written. */
long berthing_scene_near(Scene *s, long k, const double *x, double reach, long most, long *state,
                         double *slack, double *gradient)
{
    long count = 0;
    for (long j = 0; j < k; j++, x += STATE * s->vehicles) {
        put_slots(s, x);
        for (long i = 0; i < s->links; i++) {
            double upto = s->link[i].required + reach;
            if (far_apart(&s->slot[s->link[i].a], &s->slot[s->link[i].b], upto)) continue;
            double d = look(s, i, upto);
            if (!(d < upto)) continue;
            if (count++ >= most) continue;
            *state++ = j;
            *slack++ = d - s->link[i].required;
            add_pushes(s, i, gradient);
            gradient += STRIDE * s->vehicles;
        }
    }
    return count;
}

/* How fast any point of a part moves on a leg, in the length of the leg. */
static double fastest(const Scene *s, const double *way)
{
    double most = 0.0;
    for (long i = 0; i < s->slots; i++) {
        const Slot *own = &s->slot[i];
        if (own->vehicle < 0) continue;
        const double *by = way + STRIDE * own->vehicle;
        most = larger(most, length(three(by)) + length(three(by + 3)) * (length(own->own_centre) + own->radius));
    }
    return most;
}

/* The room at a share of the leg `way` from a, as room_at has it. */
static double room_on(Scene *s, const double *a, const double *way, double share, double pad, double ample)
{
    double *x = s->work + STRIDE * s->vehicles * (STRIDE * s->vehicles + 3);
    move_by(s->vehicles, a, way, share, x);
    return room_at(s, x, pad, ample);
}

/* A fraction of the leg from a to b that lacks limits, margins or pad; 2 where none is found, and
   then all of it is clear but for stretches of `step` (metres of the point that moves most) between
   two clear states. Of both ends only their limits are looked at: these hold in between then. */
double berthing_scene_blocked(Scene *s, const double *a, const double *b, double step, double pad)
{
    double *way = s->work + STRIDE * s->vehicles * (STRIDE * s->vehicles + 2);
    if (!within(s, a) || !within(s, b)) return !within(s, b);
    stride_between(s->vehicles, a, b, way);
    double speed = fastest(s, way), least = step / speed;
    /* What is blocked is so in the middle, as often as not. */
    for (double part = 0.5; part >= LEAST_GLANCE && part > least; part *= 0.5)
        for (double at = part; at < 1.0; at += 2.0 * part)
            if (room_on(s, a, way, at, pad, 0.0) < 0.0) return at;
    for (double at = least; at < 1.0;) {
        double room = room_on(s, a, way, at, pad, AMPLE * step);
        if (room < 0.0) return at;
        at += fmax(least, room / (s->mutual ? 2.0 * speed : speed));
    }
    return 2.0;
}
#endif
