// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/witness/witness.hpp"
#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
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

/// Returns the contact of words such as "tilted-wedge phi=pi/16 alpha=pi/20 a=3/2 E=2" or
/// "piecewise symmetric knots=1/2 slopes=x;1/2+sinh(x-1/2) P=1/3"; the modulus is 7/3 unless E is
/// given.
inline Contact contact_of(const std::string& words) {
    std::map<std::string, std::string> value;
    std::istringstream in(words);
    std::string kind;
    in >> kind;
    for (std::string word; in >> word;) {
        const std::size_t equals = std::min(word.find('='), word.size());
        value[word.substr(0, equals)] = word.substr(std::min(equals + 1, word.size()));
    }
    const auto of = [&](const char* key) { return exact(value.at(key)); };
    const Profile profile =
        kind == "power-law"          ? Profile::power_law(of("C"), of("m"))
        : kind == "flat-and-rounded" ? Profile::flat_and_rounded(of("t"), of("R"))
        : kind == "tilted-wedge"     ? Profile::tilted_wedge(of("phi"), of("alpha"))
        : kind == "tilted-flat-and-rounded"
            ? Profile::tilted_flat_and_rounded(of("alpha"), of("t"), of("R"))
            : curve(value["knots"], value.at("slopes"), value.contains("symmetric"));
    return {words, profile, exact(value.contains("E") ? value["E"] : "7/3"),
            value.contains("a") ? Load::right_edge(of("a")) : Load::force(of("P"))};
}
inline std::vector<Contact> contacts(const std::vector<std::string>& words) {
    std::vector<Contact> all;
    std::ranges::transform(words, std::back_inserter(all), contact_of);
    return all;
}

inline std::vector<Contact> symmetric() {
    return contacts({"power-law m=0 C=0.3 a=3/2", "power-law m=1 C=1/70 a=0.02",
                     "power-law m=1/2 C=3 a=5", "power-law m=5/8 C=1e-3 a=7e4",
                     "power-law m=10 C=2 a=1.25", "power-law m=100 C=2 a=0.9",
                     "flat-and-rounded t=0.4 R=3 a=1.5 E=2.1e11",
                     "flat-and-rounded t=8e-4 R=0.1 a=1e-3 E=2.1e11",
                     "flat-and-rounded t=0.999999 R=40 a=1.000001 E=2.1e11",
                     "flat-and-rounded t=1e-6 R=2 a=1.5 E=2.1e11"});
}

/// Returns a g' with a corner at the origin, a bend and a piece that is not linear.
inline Contact own_symmetric() {
    return contact_of("piecewise symmetric knots=1/2 slopes=1/10+x^3;1/10+x^3+sinh(x-1/2) a=4/5");
}

/// A punch curved on both sides, with a bend at 1/3 and a corner at the origin.
inline Contact own_tilted() {
    return contact_of(
        "piecewise knots=0;1/3 slopes=-1/10+sinh(x);x^2+x/7;1/9+1/21+tanh(x-1/3) a=4/5");
}

inline std::vector<Contact> tilted() {
    // The punch of moore-hills.tex line 349 with the left edge in each of its three pieces.
    const std::string punch = "tilted-flat-and-rounded alpha=pi/16 t=1 R=2 a=";
    return contacts({"tilted-wedge phi=pi/16 alpha=pi/20 a=1.5",
                     "tilted-wedge phi=0.1 alpha=0.001 a=30",
                     "tilted-wedge phi=pi/3 alpha=-pi/7 a=0.01", punch + "0.2", punch + "0.5",
                     punch + "3", "tilted-flat-and-rounded alpha=0.01 t=0.5 R=70 a=0.9"});
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
