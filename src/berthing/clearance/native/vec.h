/* Vectors and rotations of three dimensions. Planar sets lie in z = 0. */
#ifndef VEC_H
#define VEC_H
#include <math.h>

typedef struct { double x, y, z; } V;
typedef struct { V x, y, z; } M; /* rows */

static inline V vec(double x, double y, double z) { V v = {x, y, z}; return v; }
static inline V add(V a, V b) { return vec(a.x + b.x, a.y + b.y, a.z + b.z); }
static inline V sub(V a, V b) { return vec(a.x - b.x, a.y - b.y, a.z - b.z); }
static inline V mul(double s, V a) { return vec(s * a.x, s * a.y, s * a.z); }
static inline double dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline double length(V a) { return sqrt(dot(a, a)); }
static inline V cross(V a, V b)
{
    return vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline V plus(V a, double s, V b) { return add(a, mul(s, b)); }
static inline V unit_or(V a, V otherwise)
{
    double n = length(a);
    return n > 0.0 ? mul(1.0 / n, a) : otherwise;
}
static inline double at(V v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }
static inline void put(V *v, int i, double value)
{
    if (i == 0) v->x = value;
    else if (i == 1) v->y = value;
    else v->z = value;
}

static inline V turn(const M *R, V v) { return vec(dot(R->x, v), dot(R->y, v), dot(R->z, v)); }
static inline V unturn(const M *R, V v)
{
    return plus(plus(mul(v.x, R->x), v.y, R->y), v.z, R->z);
}
static inline M transpose(const M *A)
{
    M T = {{A->x.x, A->y.x, A->z.x}, {A->x.y, A->y.y, A->z.y}, {A->x.z, A->y.z, A->z.z}};
    return T;
}
static inline M product(const M *A, const M *B)
{
    M T = transpose(B);
    M C = {turn(&T, A->x), turn(&T, A->y), turn(&T, A->z)};
    return C;
}

/* Two unit vectors that complete the unit vector n to a right-handed frame; in the plane, the
   second is z (Duff and others, J. Computer Graphics Techniques 6, 2017). */
static inline void tangents(V n, int dim, V *s, V *t)
{
    if (dim == 2) {
        *s = vec(-n.y, n.x, 0.0);
        *t = vec(0.0, 0.0, 1.0);
        return;
    }
    double sign = copysign(1.0, n.z), a = -1.0 / (sign + n.z), b = n.x * n.y * a;
    *s = vec(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x);
    *t = vec(b, sign + n.y * n.y * a, -n.y);
}
#endif
