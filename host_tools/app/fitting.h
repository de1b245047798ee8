/* fitting - how near a camera may come that sees all of some points
 *
 * A camera that looks along -back sees a point if it lies between four planes through the eye.
 * For each of them the point that is farthest out decides, so four numbers say all that a view
 * must know of any number of points, and the nearest eye follows from them without a search.
 *
 * SPDX-License-Identifier: MIT */
#ifndef FITTING_H
#define FITTING_H

/* Unit vectors at right angles, from the scene to the eye and across; where they begin; and the
 * tangents of half the angles that points may lie in. */
typedef struct fitting {
    double right[3], above[3], back[3], origin[3];
    double tan_x, tan_y;
    double most[4]; /* of all points: x + tan_x z, -x + tan_x z, y + tan_y z, -y + tan_y z */
} fitting;

/* What the eye may do to come nearer. */
enum fitting_freedom {
    FITTING_ASIDE,  /* it moves across, and looks past the origin */
    FITTING_CIRCLE, /* up and down alone: it is to circle around the axis */
    FITTING_FIXED   /* neither: the origin stays in the middle of the picture */
};

double vector_dot(const double a[3], const double b[3]);
void vector_cross(const double a[3], const double b[3], double to[3]);
int vector_normalise(double v[3]); /* 0: it has no length, and is as it was */

/* No points yet. `back` and `up` are unit vectors, not along each other. */
void fitting_begin(fitting *f, const double origin[3], const double back[3], const double up[3],
                   double tan_x, double tan_y);

/* A point, and how much farther it may reach across than it says. */
void fitting_add(fitting *f, const double point[3], double more_x, double more_y);

/* All corners of a box. */
void fitting_add_box(fitting *f, const double lo[3], const double hi[3]);

/* How far the nearest corner of a box is from the origin, along back. */
double fitting_depth(const fitting *f, const double lo[3], const double hi[3]);

/* All that `other` holds, of the same tangents: of other axes, as if it were turned to these. */
void fitting_join(fitting *f, const fitting *other);
/* Not more than `other` holds. */
void fitting_limit(fitting *f, const fitting *other);

/* How far back width and height alone would have the eye. */
void fitting_need(const fitting *f, enum fitting_freedom freedom, double need[2]);

/* Where the eye is, and the point it looks at, at least `least` away from it, or 1 where no
 * distance is asked for. `up`: the axis of a circle. */
void fitting_solve(const fitting *f, enum fitting_freedom freedom, const double up[3], double least,
                   double eye[3], double look[3]);

#endif
