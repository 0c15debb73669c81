/* SPDX-License-Identifier: BSD-3-Clause */
/* Hertz's line contact in double, as an example of a code that answers some of the pack. */
#include "edgeproof_case.h"

#include <math.h>
#include <string.h>

int edgeproof_answer(const struct edgeproof_case* c, double* value) {
    const double pi = acos(-1.0);
    if (strcmp(c->kind, "power-law") != 0 || c->m != 1) {
        return 0;
    }
    const double a = isnan(c->a) ? sqrt(4 * c->P / (pi * c->E * c->C)) : c->a;
    const double k = c->E * c->C / 2; /* p = k sqrt(a^2 - x^2) */
    const char* const q = c->quantity;
    if (strcmp(q, "p") == 0) {
        *value = k * sqrt(c->u * (2 * a - c->u));
    } else if (strcmp(q, "c_0") == 0) {
        *value = k * sqrt(2 * a);
    } else if (strcmp(q, "c_1") == 0) {
        *value = -k * sqrt(2 * a) / (4 * a);
    } else if (strcmp(q, "c_2") == 0) {
        *value = -k * sqrt(2 * a) / (32 * a * a);
    } else if (strcmp(q, "P") == 0) {
        *value = k * pi * a * a / 2;
    } else if (strcmp(q, "a") == 0 || strcmp(q, "b") == 0) {
        *value = a;
    } else {
        return 0;
    }
    return 1;
}
