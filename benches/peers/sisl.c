/* Loops over SISL's functions, so that a call from Python is not what is measured.
 *
 * A surface is given by its poles with the first parameter fastest, homogeneous (wx, wy, wz, w) when
 * `width` is 4. Functions return SISL's status: negative is an error. */
#include <math.h>
#include <sisl.h>
#include <stdlib.h>

void s6err(const char *routine, int status, int position) {
    (void)routine, (void)status, (void)position;
}

SISLSurf *surface(const double *poles, int width, int nu, int nv) {
    double knots[2][64];
    for (int i = 0; i < 2 * nu; i++) knots[0][i] = i >= nu;
    for (int i = 0; i < 2 * nv; i++) knots[1][i] = i >= nv;
    int kind = width == 4 ? 2 : 1, copy = 1;
    return newSurf(nu, nv, nu, nv, knots[0], knots[1], (double *)poles, kind, 3, copy);
}

/* Points[v][u]. */
int grid(SISLSurf *s, double *u, long nu, double *v, long nv, double *points) {
    int status = 0;
    s1506(s, 0, (int)nu, u, (int)nv, v, points, NULL, &status);
    return status;
}

/* Points[surface][v][u], the parameters the same along both axes. */
int grids(SISLSurf **surfaces, double *at, long side, double *points, long count) {
    int status = 0;
    for (long i = 0; i < count && status >= 0; i++)
        status = grid(surfaces[i], at, side, at, side, points + i * side * side * 3);
    return status;
}

/* Points[v][u] and unit normals[v][u]. */
int grid_with_normals(SISLSurf *s, double *u, long nu, double *v, long nv, double *points, double *normals) {
    int status = 0;
    long count = nu * nv;
    double *jets = malloc(count * 9 * sizeof *jets);
    s1506(s, 1, (int)nu, u, (int)nv, v, jets, normals, &status);
    for (long i = 0; i < count && status >= 0; i++) {
        double *n = normals + 3 * i, length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int k = 0; k < 3; k++) {
            points[3 * i + k] = jets[9 * i + k];
            n[k] /= length;
        }
    }
    free(jets);
    return status;
}

int scattered(SISLSurf *s, double *parameters, long count, double *points) {
    int status = 0, left_u = 0, left_v = 0;
    double normal[3];
    for (long i = 0; i < count && status >= 0; i++)
        s1421(s, 0, parameters + 2 * i, &left_u, &left_v, points + 3 * i, normal, &status);
    return status;
}

/* Parameters of the closest point; left alone where SISL finds none. */
int closest(SISLSurf *s, double *points, long count, double accuracy, double *parameters) {
    int status = 0;
    for (long i = 0; i < count && status >= 0; i++) {
        int found = 0, curves = 0;
        double *at = NULL;
        SISLIntcurve **along = NULL;
        s1954(s, points + 3 * i, 3, 0.0, accuracy, &found, &at, &curves, &along, &status);
        if (found) parameters[2 * i] = at[0], parameters[2 * i + 1] = at[1];
        free(at);
        if (along) freeIntcrvlist(along, curves);
    }
    return status;
}
