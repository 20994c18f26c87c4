/* SPDX-License-Identifier: MIT */
/* camera.h: how a coin, its shadow and points of the table look to a camera.
 *
 * The camera looks down on the table along a plane x = constant.  Seen by it,
 * a circle is an ellipse, exactly: that of the dual conic. */
#ifndef EXAMPLE_CAMERA_H
#define EXAMPLE_CAMERA_H

#include <math.h>

typedef struct camera {
    double sth, cth;  /* sine and cosine of its elevation */
    double distance;  /* from the point that it looks at */
    double target[3]; /* this point */
    double at[2];     /* this point in the picture [px] */
    double scale;     /* of lengths there [px] */
} camera;

/* An ellipse in the picture: centre, half axes, and the direction of the
 * second, (-sin(tilt), cos(tilt)). */
typedef struct ellipse {
    double x, y, major, minor, tilt;
} ellipse;

/* Homogeneous coordinates in the picture of a point, or with w = 0 of a
 * direction. */
static inline void camera_image(const camera *c, const double r[3], double w,
                                double h[3])
{
    const double x = r[0] - w * c->target[0];
    const double y = r[1] - w * c->target[1], z = r[2] - w * c->target[2];
    const double depth = w * c->distance - (c->sth * y + c->cth * z);
    const double f = c->scale * c->distance;

    h[0] = f * x + c->at[0] * depth;
    h[1] = f * (c->sth * z - c->cth * y) + c->at[1] * depth;
    h[2] = depth;
}

/* A point in the picture, and how a velocity of it looks; v may be null. */
static inline void camera_point(const camera *c, const double r[3],
                                const double v[3], double at[2], double dat[2])
{
    double h[3], dh[3];

    camera_image(c, r, 1, h);
    at[0] = h[0] / h[2];
    at[1] = h[1] / h[2];
    if (v == 0)
        return;
    camera_image(c, v, 0, dh);
    dat[0] = (dh[0] - dh[2] * at[0]) / h[2];
    dat[1] = (dh[1] - dh[2] * at[1]) / h[2];
}

/* The circle r + U cos(t) + V sin(t).  The tilt is the one nearest to *near,
 * of those that differ by half turns. */
static inline ellipse camera_circle(const camera *c, const double r[3],
                                    const double U[3], const double V[3],
                                    double near)
{
    const double turn = acos(-1.0);
    double u[3], v[3], w[3], D[3][3];

    camera_image(c, U, 0, u);
    camera_image(c, V, 0, v);
    camera_image(c, r, 1, w);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            D[i][j] = u[i] * u[j] + v[i] * v[j] - w[i] * w[j];

    const double x = D[0][2] / D[2][2], y = D[1][2] / D[2][2];
    const double xx = x * x - D[0][0] / D[2][2];
    const double xy = x * y - D[0][1] / D[2][2];
    const double yy = y * y - D[1][1] / D[2][2];
    const double half = (xx - yy) / 2, off = hypot(half, xy);
    const double tilt = atan2(xy, half) / 2;
    const ellipse seen = {x, y, sqrt((xx + yy) / 2 + off),
                          sqrt(fmax((xx + yy) / 2 - off, 0)),
                          tilt + turn * floor((near - tilt) / turn + 0.5)};
    return seen;
}

#endif
