// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/asked_contact.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::conformance {

/// A number that may be asked for: p and q at a point, c_k and s_k (the coefficients of u^(k+1/2)
/// in p, and those of q from its lowest power on) at an edge, a, b, P, M and alpha of a contact;
/// of the first k terms at an edge, the distance at which their relative error first reaches a
/// tolerance (extent_k) and the length of all that lies within it (measure_k).
struct Wanted {
    enum class Kind { p, q, c, s, a, b, P, M, alpha, extent, measure };
    Kind kind = Kind::p;
    std::size_t k = 0; ///< of c and s; terms of extent and measure

    [[nodiscard]] bool at_point() const { return kind == Kind::p || kind == Kind::q; }
    [[nodiscard]] bool of_terms() const { return kind == Kind::extent || kind == Kind::measure; }
    [[nodiscard]] bool at_edge() const {
        return at_point() || of_terms() || kind == Kind::c || kind == Kind::s;
    }
    friend bool operator==(const Wanted&, const Wanted&) = default;
};
/// "p", "c_0", "alpha", "extent_1", ... Nothing for other names, for k > 399 and for no terms.
[[nodiscard]] std::optional<Wanted> wanted_named(std::string_view name);
[[nodiscard]] std::string wanted_name(const Wanted& wanted);

struct Question {
    std::string id;
    std::size_t contact = 0; ///< index into Questions::contacts
    Wanted wanted;
    contact::Edge edge = contact::Edge::right;    ///< where wanted.at_edge()
    std::optional<formula::Exact> u;              ///< where wanted.at_point()
    std::optional<formula::Exact> tolerance = {}; ///< where wanted.of_terms()
    std::size_t line = 0;                         ///< of the file that asks it
};

/// Questions, in the order that they are asked in.
struct Questions {
    std::string file;
    std::vector<AskedContact> contacts;
    std::vector<Question> list;

    /// The keys of parameters that any contact has.
    [[nodiscard]] std::vector<std::string> columns() const;
    [[nodiscard]] bool has_tolerances() const;
};

/// The text of a parameter, empty where the contact does not have it.
[[nodiscard]] std::string parameter_text(const AskedContact& contact, std::string_view key);

/// The same questions with every number rounded to binary64, so that a program that computes in
/// binary64 is asked exactly what it can read.
[[nodiscard]] Questions rounded_to_binary64(const Questions& questions);

/// Throws InputError where a contact does not have what is asked of it: q or s without shear, alpha
/// where the tilt is given.
void check_askable(const AskedContact& contact, const Wanted& wanted, const std::string& file,
                   std::size_t line);

} // namespace edgeproof::conformance
