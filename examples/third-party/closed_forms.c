/* SPDX-License-Identifier: BSD-3-Clause */
/* Answers the questions of `edgeproof points` in double precision (C99).
 *
 *     cc -O2 -o closed_forms closed_forms.c -lm
 *     edgeproof check questions.toml --exec ./closed_forms --digits 13
 *
 * Contacts: wedge and cylinder (power-law, m = 0 and 1), flat-and-rounded punch. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { longest_line = 65536, most_columns = 64 };

struct row {
    int columns;
    char* cell[most_columns];
};

static struct row split(char* line) {
    struct row r = {0, {0}};
    line[strcspn(line, "\r\n")] = '\0';
    for (char* p = line; p != NULL && r.columns < most_columns;) {
        r.cell[r.columns++] = p;
        p = strchr(p, ',');
        if (p != NULL) {
            *p++ = '\0';
        }
    }
    return r;
}

static const char* text(const struct row* header, const struct row* r, const char* name) {
    for (int i = 0; i < header->columns && i < r->columns; ++i) {
        if (strcmp(header->cell[i], name) == 0) {
            return r->cell[i];
        }
    }
    return "";
}

static double wedge(double a, double scale, double u, const char* name) {
    const double pi = acos(-1.0);
    if (strcmp(name, "P") == 0) {
        return scale * a;
    }
    if (strcmp(name, "c_0") == 0) {
        return scale / pi * sqrt(2 / a);
    }
    return scale / pi * asinh(sqrt(u * (2 * a - u)) / fabs(a - u));
}

static double cylinder(double a, double scale, double u, const char* name) {
    if (strcmp(name, "P") == 0) {
        return scale / 2 * acos(-1.0) * a * a / 2;
    }
    if (strcmp(name, "c_0") == 0) {
        return scale / 2 * sqrt(2 * a);
    }
    if (strcmp(name, "c_1") == 0) {
        return -scale / 2 * sqrt(2 * a) / (4 * a);
    }
    return scale / 2 * sqrt(u * (2 * a - u));
}

/* The real part, on either side of 1. */
static double real_atanh(double z) { return fabs(z) < 1 ? atanh(z) : atanh(1 / z); }

static double flat_and_rounded(double a, double t, double scale, double u, const char* name) {
    const double pi = acos(-1.0);
    const double flat = asin(t / a);
    if (strcmp(name, "P") == 0) {
        return scale * a * a / 4 * (pi - 2 * flat - sin(2 * flat));
    }
    scale *= a / (2 * pi);
    if (strcmp(name, "c_0") == 0) {
        return scale * (pi - 2 * flat) * sqrt(2 / a);
    }
    const double s = fabs(a - u) / a, c = sqrt(u * (2 * a - u)) / a;
    return scale * ((pi - 2 * flat) * c + 2 * s * real_atanh(tan(flat) * c / s) -
                    2 * sin(flat) * real_atanh(c / cos(flat)));
}

int main(void) {
    static char line[longest_line], names[longest_line];
    struct row header = {0, {0}};
    while (fgets(line, sizeof line, stdin) != NULL) {
        if (line[0] == '#') {
            continue;
        }
        if (header.columns == 0) {
            strcpy(names, line);
            header = split(names);
            puts("id,value");
            continue;
        }
        const struct row r = split(line);
        const char* const name = text(&header, &r, "quantity");
        const double a = atof(text(&header, &r, "a")), u = atof(text(&header, &r, "u"));
        const double modulus = atof(text(&header, &r, "contact_modulus"));
        const double slope = modulus * atof(text(&header, &r, "C"));
        double value;
        if (strcmp(text(&header, &r, "kind"), "flat-and-rounded") == 0) {
            value = flat_and_rounded(a, atof(text(&header, &r, "t")),
                                     modulus / atof(text(&header, &r, "R")), u, name);
        } else if (atof(text(&header, &r, "m")) == 0) {
            value = wedge(a, slope, u, name);
        } else {
            value = cylinder(a, slope, u, name);
        }
        printf("%s,%.17g\n", text(&header, &r, "id"), value);
    }
    return 0;
}
