/* SPDX-License-Identifier: BSD-3-Clause */
/* Arb's rigorous integrator. Reads lines of id family digits u m t K W (a = 1; decimals), writes
 * id, value, evaluations, processor seconds per value (the median of the repeats).
 *
 * s^2 = x^2 + w^2 removes the singularity at s = x; x below the end of the flat: s = t/cos(phi).
 * With the argument "mapped" the singularities near the interval are moved away as well:
 * w = d sinh(y), phi = d sinh(y), where d is their distance. With "parts" the flat-and-rounded
 * integral is integrated by parts first, which leaves an algebraic integrand:
 *   sqrt(1 - x^2) acos(t) - t times the integral of sqrt(s^2 - x^2)/(s sqrt(s^2 - t^2)),
 * with s^2 = x^2 + w^2, or t^2 + w^2 for x below the end of the flat. */
#if __has_include(<flint/acb_calc.h>)
#include <flint/acb.h>
#include <flint/acb_calc.h>
#include <flint/acb_hypgeom.h>
#include <flint/arb.h>
#else
#include <acb.h>
#include <acb_calc.h>
#include <acb_hypgeom.h>
#include <arb.h>
#endif
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef struct {
    int flat, above, mapped, parts;
    arb_t x, t, m, d;
    long evaluations;
} contact;

/* t w^2/((x^2 + w^2) sqrt(w^2 + d^2)); below: t sqrt(w^2 + d^2)/(w^2 + t^2). */
static int by_parts(acb_ptr out, const acb_t w, void* param, slong order, slong prec) {
    contact* c = param;
    acb_t square, root;
    ++c->evaluations;
    acb_init(square), acb_init(root);
    acb_mul(square, w, w, prec);
    acb_set(root, square);
    arb_addmul(acb_realref(root), c->d, c->d, prec);
    acb_sqrt_analytic(root, root, order != 0, prec);
    if (c->above) {
        acb_set(out, square);
        arb_addmul(acb_realref(square), c->x, c->x, prec);
        acb_mul(square, square, root, prec);
    } else {
        acb_set(out, root);
        arb_addmul(acb_realref(square), c->t, c->t, prec);
    }
    acb_div(out, out, square, prec);
    acb_mul_arb(out, out, c->t, prec);
    acb_clear(square), acb_clear(root);
    return 0;
}

/* f is analytic where sqrt and acos are. For order 1 it must be indeterminate elsewhere. */
static int integrand(acb_ptr out, const acb_t z, void* param, slong order, slong prec) {
    contact* c = param;
    acb_t w, s, jacobian;
    ++c->evaluations;
    acb_init(w), acb_init(s), acb_init(jacobian);
    if (c->mapped) {
        acb_sinh_cosh(w, jacobian, z, prec);
        acb_mul_arb(w, w, c->d, prec);
        acb_mul_arb(jacobian, jacobian, c->d, prec);
    } else {
        acb_set(w, z);
        acb_one(jacobian);
    }
    if (!c->flat) { /* (x^2 + w^2)^((m - 1)/2) */
        acb_t e;
        acb_init(e);
        acb_mul(s, w, w, prec);
        arb_addmul(acb_realref(s), c->x, c->x, prec);
        acb_set_arb(e, c->m);
        acb_sub_ui(e, e, 1, prec);
        acb_mul_2exp_si(e, e, -1);
        if (c->mapped) { /* x^2 (1 + sinh^2) = (x cosh)^2, real and positive where it is needed */
            acb_set(s, jacobian);
            acb_mul_2exp_si(e, e, 1);
        }
        acb_pow_analytic(out, s, e, order != 0, prec);
        acb_clear(e);
    } else if (c->above) { /* acos(t/s) = atan(sqrt(s^2 - t^2)/t), s^2 - t^2 = d^2 + w^2 */
        if (c->mapped) {   /* d^2 + w^2 = (d cosh(y))^2, and that root is the jacobian */
            acb_set(s, jacobian);
        } else {
            acb_mul(s, w, w, prec);
            arb_addmul(acb_realref(s), c->d, c->d, prec);
            acb_sqrt_analytic(s, s, order != 0, prec);
        }
        acb_div_arb(s, s, c->t, prec);
        if (order != 0 && !arb_is_positive(acb_realref(s))) {
            acb_indeterminate(s); /* atan is cut along the imaginary axis */
        }
        acb_atan(out, s, prec);
    } else { /* phi t^2 sin/cos^3 / sqrt(t^2/cos^2 - x^2) = phi t^2 sin/cos^2/sqrt(t^2 - x^2 cos^2)
              */
        acb_t sine, cosine, root;
        acb_init(sine), acb_init(cosine), acb_init(root);
        acb_sin_cos(sine, cosine, w, prec);
        acb_mul_arb(root, cosine, c->x, prec);
        acb_mul(root, root, root, prec);
        acb_neg(root, root);
        arb_addmul(acb_realref(root), c->t, c->t, prec);
        acb_sqrt_analytic(root, root, order != 0, prec);
        acb_mul(cosine, cosine, cosine, prec);
        acb_mul(root, root, cosine, prec);
        acb_mul(out, w, sine, prec);
        acb_mul_arb(out, out, c->t, prec);
        acb_mul_arb(out, out, c->t, prec);
        acb_div(out, out, root, prec);
        acb_clear(sine), acb_clear(cosine), acb_clear(root);
    }
    acb_mul(out, out, jacobian, prec);
    acb_clear(w), acb_clear(s), acb_clear(jacobian);
    return 0;
}

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int ascending(const void* a, const void* b) {
    const double x = *(const double*)a, y = *(const double*)b;
    return (x > y) - (x < y);
}

static void pressure(arb_t p, contact* c, const arb_t u, const arb_t K, slong goal, slong prec) {
    acb_t lo, hi, sum;
    arb_t r, w;
    mag_t tolerance;
    acb_init(lo), acb_init(hi), acb_init(sum), arb_init(r), arb_init(w), mag_init(tolerance);
    c->evaluations = 0;
    arb_sub_ui(c->x, u, 1, prec);
    arb_neg(c->x, c->x);
    if (c->parts && !c->above) { /* w to sqrt(1 - t^2), d^2 = (t - x)(t + x) */
        arb_sqr(w, c->t, prec);
        arb_sub_ui(w, w, 1, prec);
        arb_neg(w, w);
        arb_sqrt(w, w, prec);
        arb_sub(c->d, c->t, c->x, prec);
        arb_add(r, c->x, c->t, prec);
        arb_mul(c->d, c->d, r, prec);
        arb_sqrt(c->d, c->d, prec);
    } else if (c->flat && !c->above) { /* phi to acos(t) */
        arb_acos(w, c->t, prec);
        arb_div(r, c->t, c->x, prec);
        arb_acosh(c->d, r, prec);
    } else { /* w to sqrt(1 - x^2) = sqrt(u (2 - u)) */
        arb_sub_ui(w, u, 2, prec);
        arb_neg(w, w);
        arb_mul(w, w, u, prec);
        arb_sqrt(w, w, prec);
        arb_set(c->d, c->x);
        if (c->flat) { /* d^2 = (x - t)(x + t) */
            arb_sub(c->d, c->x, c->t, prec);
            arb_add(r, c->x, c->t, prec);
            arb_mul(c->d, c->d, r, prec);
            arb_sqrt(c->d, c->d, prec);
        }
    }
    if (c->mapped) {
        arb_div(w, w, c->d, prec);
        arb_asinh(w, w, prec);
    }
    acb_set_arb(hi, w);
    mag_set_ui_2exp_si(tolerance, 1, -goal - 64);
    acb_calc_integrate_opt_t options;
    acb_calc_integrate_opt_init(options);
    acb_calc_integrate(sum, c->parts ? by_parts : integrand, c, lo, hi, goal, tolerance, options,
                       prec);
    if (c->parts) {
        arb_sub_ui(r, u, 2, prec);
        arb_mul(r, r, u, prec);
        arb_neg(r, r);
        arb_sqrt(r, r, prec);
        arb_acos(w, c->t, prec);
        arb_mul(r, r, w, prec);
        arb_sub(acb_realref(sum), r, acb_realref(sum), prec);
    }
    arb_mul(p, acb_realref(sum), K, prec);
    arb_const_pi(r, prec);
    arb_div(p, p, r, prec);
    acb_clear(lo), acb_clear(hi), acb_clear(sum), arb_clear(r), arb_clear(w), mag_clear(tolerance);
}

int main(int argc, char** argv) {
    const int mapped = argc > 1 && strcmp(argv[1], "mapped") == 0;
    const int parts = argc > 1 && strcmp(argv[1], "parts") == 0;
    const double enough = argc > 2 ? atof(argv[2]) : 5e-3; /* seconds a point */
    static char line[1 << 16], id[64], family[16], text[5][8192];
    long digits;
    while (fgets(line, sizeof line, stdin) != NULL &&
           sscanf(line, "%63s %15s %ld %8191s %8191s %8191s %8191s", id, family, &digits, text[0],
                  text[1], text[2], text[3]) == 7) {
        const slong goal = (slong)((double)digits * 3.3219281) + 4, prec = goal + 30;
        contact c;
        arb_t u, K, p;
        arb_init(u), arb_init(K), arb_init(p);
        arb_init(c.x), arb_init(c.t), arb_init(c.m), arb_init(c.d);
        arb_set_str(u, text[0], prec + 400);
        arb_set_str(c.m, text[1], prec);
        arb_set_str(c.t, text[2], prec + 400);
        arb_set_str(K, text[3], prec);
        c.flat = strcmp(family, "flat") == 0;
        c.mapped = mapped && strtod(text[0], NULL) < 1; /* at x = 0 no singularity is near */
        arb_sub_ui(p, u, 1, prec + 400);
        arb_neg(p, p);
        c.parts = parts && c.flat;
        c.above = !c.flat || arb_ge(p, c.t);
        double times[64];
        size_t n = 0;
        double spent = 0;
        do {
            const double begun = seconds();
            pressure(p, &c, u, K, goal, prec);
            times[n] = seconds() - begun;
            spent += times[n++];
        } while (spent < enough && n < 64);
        qsort(times, n, sizeof *times, ascending);
        char* value = arb_get_str(p, digits + 10, ARB_STR_NO_RADIUS);
        printf("%s %s %ld %.6g\n", id, value, c.evaluations, times[n / 2]);
        fflush(stdout);
        flint_free(value);
        arb_clear(u), arb_clear(K), arb_clear(p);
        arb_clear(c.x), arb_clear(c.t), arb_clear(c.m), arb_clear(c.d);
    }
    flint_cleanup();
    return 0;
}
