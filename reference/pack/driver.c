/* SPDX-License-Identifier: BSD-3-Clause */
/* Holds a contact code against the conformance pack (C99).
 *
 *     cc -O2 -o driver driver.c example.c -lm      (your file in place of example.c)
 *     ./driver A level-a.csv
 *     ./driver B cases.csv hard-cases.csv
 *
 * Levels A, B and C; README.md says what they ask. Exit status 0: every answer is within the level;
 * 1: one is not; 2: there was nothing to hold. */
#include "edgeproof_case.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { longest_line = 2048, columns = 24, most_shown = 10 };
static const double same_ratio = 0.01; /* ratios that agree to this are one factor */

static const char* const header =
    "id,kind,m,C,phi,alpha,t,R,a,P,M,E,Q,S,edge,u,quantity,scale,value,bound,binary64,hex,"
    "condition,ulps";

static void copy(char* to, size_t size, const char* from) {
    strncpy(to, from, size - 1);
    to[size - 1] = '\0';
}

static int split(char* line, char** cell) {
    int n = 0;
    line[strcspn(line, "\r\n")] = '\0';
    for (char* p = line; p != NULL && n < columns; ++n) {
        cell[n] = p;
        p = strchr(p, ',');
        if (p != NULL) {
            *p++ = '\0';
        }
    }
    return n;
}

/* Whether an answer is within the level: a NaN is not. */
static int within(char level, double value, double exact, double scale, double ulps) {
    const double error = fabs(value - exact);
    if (level == 'A') {
        return error <= 0.01 * scale;
    }
    if (level == 'B') {
        return error <= ulps * (nextafter(fabs(exact), INFINITY) - fabs(exact));
    }
    return value == exact;
}

/* Wrong answers by the first letter of the quantity: their number, and the range of answer/exact.
 */
static struct ratios {
    long rows;
    double low;
    double high;
} wrong_ratios[128];

static void count_ratio(char quantity, double ratio) {
    struct ratios* const r = &wrong_ratios[quantity & 127];
    r->low = !isfinite(ratio) ? -INFINITY : r->rows == 0 || ratio < r->low ? ratio : r->low;
    r->high = !isfinite(ratio) ? INFINITY : r->rows == 0 || ratio > r->high ? ratio : r->high;
    ++r->rows;
}

/* Names the factor where all wrong answers of a quantity, three or more, have the same one. */
static void print_causes(void) {
    for (int k = 0; k < 128; ++k) {
        const struct ratios* const r = &wrong_ratios[k];
        const double middle = (r->low + r->high) / 2;
        if (r->rows < 3 || !(r->high - r->low <= same_ratio * fabs(middle)) ||
            fabs(middle - 1) <= same_ratio) {
            continue;
        }
        printf("likely cause: the %ld wrong answers for %c are %.6g times the exact ones: ",
               r->rows, k, middle);
        char line[128];
        int named = 0;
        FILE* const file = fopen("factors.txt", "r");
        while (file != NULL && fgets(line, sizeof line, file) != NULL) {
            char name[64];
            double value;
            if (sscanf(line, "%63s %lf", name, &value) == 2 &&
                fabs(middle / value - 1) <= same_ratio) {
                printf("%s%s", named++ > 0 ? " or " : "", name);
            }
        }
        if (file != NULL) {
            fclose(file);
        }
        printf(named > 0 ? "\n" : "factor\n");
    }
}

int main(int argc, char** argv) {
    if (argc < 3 || strlen(argv[1]) != 1 || strchr("ABC", argv[1][0]) == NULL) {
        fprintf(stderr, "usage: driver A|B|C FILE...\n");
        return 2;
    }
    const char level = argv[1][0];
    long answered = 0;
    long wrong = 0;
    long not_there = 0;
    for (int i = 2; i < argc; ++i) {
        FILE* file = fopen(argv[i], "r");
        if (file == NULL) {
            fprintf(stderr, "%s: cannot be read\n", argv[i]);
            return 2;
        }
        static char line[longest_line];
        int in_rows = 0;
        long rows = 0;
        long stated = -1;
        while (fgets(line, sizeof line, file) != NULL) {
            char* cell[columns];
            if (line[0] == '#') {
                sscanf(line, "# rows: %ld", &stated);
                continue;
            }
            if (!in_rows) {
                line[strcspn(line, "\r\n")] = '\0';
                if (strcmp(line, header) != 0) {
                    fprintf(stderr, "%s: the columns are those of another pack\n", argv[i]);
                    return 2;
                }
                in_rows = 1;
                continue;
            }
            if (split(line, cell) != columns) {
                fprintf(stderr, "%s: a row is cut off\n", argv[i]);
                return 2;
            }
            ++rows;
            struct edgeproof_case c;
            copy(c.id, sizeof c.id, cell[0]);
            copy(c.kind, sizeof c.kind, cell[1]);
            double* const numbers[] = {&c.m, &c.C, &c.phi, &c.alpha, &c.t, &c.R,
                                       &c.a, &c.P, &c.M,   &c.E,     &c.Q, &c.S};
            for (int k = 0; k < 12; ++k) {
                *numbers[k] = strtod(cell[2 + k], NULL);
            }
            copy(c.edge, sizeof c.edge, cell[14]);
            c.u = strtod(cell[15], NULL);
            copy(c.quantity, sizeof c.quantity, cell[16]);
            const double exact = strtod(cell[20], NULL);
            double value = NAN;
            if (!edgeproof_answer(&c, &value)) {
                ++not_there;
                continue;
            }
            ++answered;
            if (!within(level, value, exact, strtod(cell[17], NULL), strtod(cell[23], NULL))) {
                count_ratio(c.quantity[0], value / exact);
                if (++wrong <= most_shown) {
                    printf("%s: %.17g, exact %.17g\n", c.id, value, exact);
                }
            }
        }
        fclose(file);
        if (rows != stated) {
            fprintf(stderr,
                    "%s: the file is not whole: it has %ld rows, and its line # rows has "
                    "another number\n",
                    argv[i], rows);
            return 2;
        }
    }
    printf("level %c: %ld answered, %ld wrong, %ld not answered\n", level, answered, wrong,
           not_there);
    print_causes();
    return wrong > 0 ? 1 : answered > 0 ? 0 : 2;
}
