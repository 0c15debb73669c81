// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/witness/witness.hpp"
#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <algorithm>
#include <string>
#include <vector>

/// Contacts for the tests, given exactly. No parameter equals 1, so that an error in the dimensions
/// shows.
namespace edgeproof::scenes {

inline Exact exact(const std::string& text) { return Exact::parse(text); }

/// Returns the profile with these knots and slopes, each a list with ";" in between; a symmetric
/// one is given for x > 0.
inline Profile curve(const std::string& knots, const std::string& slopes, bool symmetric = false) {
    const auto each = [](std::string list, const auto& take) {
        for (std::size_t end = 0; !list.empty(); list.erase(0, end)) {
            end = std::min(list.find(';'), list.size());
            take(list.substr(0, end));
            end += end < list.size() ? 1 : 0;
        }
    };
    std::vector<Exact> at;
    std::vector<Expr> pieces;
    each(knots, [&](const std::string& knot) { at.push_back(exact(knot)); });
    each(slopes, [&](const std::string& piece) { pieces.push_back(parse(piece, Symbols{"x"})); });
    return symmetric ? Profile::piecewise_symmetric(at, pieces) : Profile::piecewise(at, pieces);
}

struct Contact {
    std::string name;
    Profile profile;
    Exact modulus;
    Load load;
};

inline std::vector<Contact> symmetric() {
    const auto power = [](const char* m, const char* C, const char* a) {
        return Contact{std::string("power-law m=") + m, Profile::power_law(exact(C), exact(m)),
                       exact("7/3"), Load::right_edge(exact(a))};
    };
    const auto flat = [](const char* t, const char* R, const char* a) {
        return Contact{std::string("flat-and-rounded t=") + t,
                       Profile::flat_and_rounded(exact(t), exact(R)), exact("2.1e11"),
                       Load::right_edge(exact(a))};
    };
    return {power("0", "0.3", "3/2"),
            power("1", "1/70", "0.02"),
            power("1/2", "3", "5"),
            power("5/8", "1e-3", "7e4"),
            power("10", "2", "1.25"),
            power("100", "2", "0.9"),
            flat("0.4", "3", "1.5"),
            flat("8e-4", "0.1", "1e-3"),
            flat("0.999999", "40", "1.000001"),
            flat("1e-6", "2", "1.5")};
}

/// Returns a g' with a corner at the origin, a bend and a piece that is not linear.
inline Contact own_symmetric() {
    return {"own symmetric", curve("1/2", "1/10 + x^3; 1/10 + x^3 + sinh(x - 1/2)", true),
            exact("7/3"), Load::right_edge(exact("4/5"))};
}

/// A punch curved on both sides, with a bend at 1/3 and a corner at the origin.
inline Contact own_tilted() {
    return {"own, not symmetric",
            curve("0; 1/3", "-1/10 + sinh(x); x^2 + x/7; 1/9 + 1/21 + tanh(x - 1/3)"), exact("7/3"),
            Load::right_edge(exact("4/5"))};
}

inline std::vector<Contact> tilted() {
    const auto wedge = [](const char* phi, const char* alpha, const char* a) {
        return Contact{std::string("tilted wedge alpha=") + alpha,
                       Profile::tilted_wedge(exact(phi), exact(alpha)), exact("7/3"),
                       Load::right_edge(exact(a))};
    };
    const auto punch = [](const char* alpha, const char* t, const char* R, const char* a) {
        return Contact{std::string("tilted flat-and-rounded a=") + a,
                       Profile::tilted_flat_and_rounded(exact(alpha), exact(t), exact(R)),
                       exact("7/3"), Load::right_edge(exact(a))};
    };
    // The punch of moore-hills.tex line 349 with the left edge in each of its three pieces.
    return {wedge("pi/16", "pi/20", "1.5"),   wedge("0.1", "0.001", "30"),
            wedge("pi/3", "-pi/7", "0.01"),   punch("pi/16", "1", "2", "0.2"),
            punch("pi/16", "1", "2", "0.5"),  punch("pi/16", "1", "2", "3"),
            punch("0.01", "0.5", "70", "0.9")};
}

/// A shear force and a bulk tension, each as text.
struct ShearCase {
    const char* Q;
    const char* sigma;
};
inline const ShearCase all_signs[] = {{"0.3", "0.7"},   {"0.3", "-0.7"}, {"-0.3", "0.7"},
                                      {"-0.3", "-0.7"}, {"0.3", "0"},    {"0", "0.7"},
                                      {"2e6", "1e-3"}};

inline int common_digits(const Real& x, const Real& y) {
    if (x == y) {
        return 1000;
    }
    return static_cast<int>(floor(-log10(abs(x - y) / abs(y))));
}

inline bool agree(const Real& x, const Real& y, int digits) {
    return abs(Real(x - y)) <= abs(y) * pow(Real(10), -digits);
}

} // namespace edgeproof::scenes
