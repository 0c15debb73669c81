// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/algebra/form.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace edgeproof::scene {

using algebra::Form;
using contact::Edge;
using formula::Exact;
using formula::Expr;

/// The distance of a point from an edge: an exact number, or a formula in a and b, the distances of
/// the edges from the origin. If a and b are solved for, the distance is only as accurate as they
/// are.
class Distance {
public:
    Distance(Exact u) : number_(std::move(u)) {} // NOLINT: most distances are numbers
    /// The distance of the point x, both as formulas in a and b. Throws DomainError for a formula
    /// without a real value.
    Distance(Expr u, Expr x);

    /// The distance, if it is a number.
    [[nodiscard]] const std::optional<Exact>& number() const { return number_; }
    /// The coordinate x, if it is a number although the distance is not.
    [[nodiscard]] const std::optional<Exact>& x() const {
        static const std::optional<Exact> none;
        return formulas_ ? formulas_->known_x : none;
    }

    /// The distance and x for a and b in these balls.
    [[nodiscard]] Ball enclosure(const Ball& a, const Ball& b, long bits) const;
    [[nodiscard]] Ball x_enclosure(const Ball& a, const Ball& b, long bits) const;
    /// The distance in exact algebra; `edge` gives the forms of a and b.
    [[nodiscard]] Form exactly(const std::function<Form(std::string_view)>& edge) const;

    /// Compares the formulas as they are written.
    friend bool operator==(const Distance& s, const Distance& t) {
        return s.number_ == t.number_ &&
               (s.formulas_ == t.formulas_ ||
                (s.formulas_ && t.formulas_ && s.formulas_->u == t.formulas_->u));
    }

private:
    struct Formulas {
        Expr u;
        Expr x;
        std::optional<Exact> known_x;
    };
    std::optional<Exact> number_;
    std::shared_ptr<const Formulas> formulas_; ///< null: the distance is a number
};

/// A point given with the names of a scene: "a/2", "50%" (of a + b) from an edge, or a coordinate
/// x.
class Place {
public:
    enum class From { edge, origin };
    /// The values of a scene's names; a and b are included if they are given.
    using Names = std::map<std::string, Expr, std::less<>>;

    /// Throws InputError for a text that is not a formula in these names, a and b.
    [[nodiscard]] static Place parse(std::string_view text, From from, const Names& names);

    /// from + t (to - from), between two places of one kind.
    [[nodiscard]] static Place between(const Place& from, const Place& to, const Rational& t);

    /// For example "a/2", "x = t + 1/10".
    [[nodiscard]] const std::string& text() const { return text_; }
    /// The distance from the edge, or x, if it depends on neither a nor b.
    [[nodiscard]] std::optional<Exact> number() const;
    [[nodiscard]] From from() const { return from_; }
    [[nodiscard]] Distance distance(Edge edge) const;
    /// Compares the places as they are written.
    friend bool operator==(const Place& s, const Place& t) {
        return s.from_ == t.from_ && s.text_ == t.text_;
    }

private:
    Place(std::string text, From from, Expr value, const Names& names);
    std::string text_;
    From from_;
    Expr value_;
    Expr a_; ///< the value of a, or the symbol a
    Expr b_;
};

} // namespace edgeproof::scene
