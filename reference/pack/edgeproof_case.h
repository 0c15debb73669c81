/* SPDX-License-Identifier: BSD-3-Clause */
/* A question of the conformance pack, and the function that answers it. README.md explains both. */
#ifndef EDGEPROOF_CASE_H
#define EDGEPROOF_CASE_H

struct edgeproof_case {
    char id[160];
    char kind[32];     /* power-law, flat-and-rounded, tilted-wedge, tilted-flat-and-rounded */
    char edge[8];      /* right, left, none */
    char quantity[16]; /* p, q, c_0, s_0, ..., a, b, P, M, alpha */
    double m, C, phi, alpha, t, R; /* profile; NAN where it has none of that name */
    double a, P, M, E;             /* load: a, or P (and M); contact modulus */
    double Q, S;                   /* shear force and bulk tension; NAN where there is no shear */
    double u;                      /* distance inwards from the edge; NAN where there is none */
};

/* Yours: 1 and the value, or 0 where your code does not have this. */
int edgeproof_answer(const struct edgeproof_case* question, double* value);

#endif
