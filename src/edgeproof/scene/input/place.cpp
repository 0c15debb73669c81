// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/input/place.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"

#include <set>
#include <utility>

namespace edgeproof::scene {
namespace {

/// The arithmetic in which a formula in a and b is evaluated.
struct EdgesInBalls {
    const Ball& a;
    const Ball& b;
    formula::BallConstants constants;
    [[nodiscard]] Ball number(const Rational& q) const { return constants.number(q); }
    [[nodiscard]] Ball pi() const { return constants.pi(); }
    [[nodiscard]] Ball symbol(std::string_view name) const { return name == "a" ? a : b; }
};

/// The value of a constant, if exact algebra knows it to be rational.
std::optional<Rational> known_rational(const Expr& e) {
    try {
        return algebra::form_of(e, [](auto) { return Form(); }).rational();
    } catch (const Error&) { // no exact form
        return {};
    }
}

bool constant(const Expr& e) { return formula::free_symbols(e).empty(); }

/// Returns the value of an expression without names, with a short text if it is rational.
Exact number_of(const Expr& e) {
    return e.rational() != nullptr ? Exact::of(*e.rational()) : Exact(e);
}

/// Returns the value of a formula in which a and b cancel.
std::optional<Exact> without_edges(const Expr& x) {
    const auto in_a = contact::as_linear(x, "a");
    const auto in_b = in_a ? contact::as_linear(in_a->at_origin, "b") : std::nullopt;
    const auto vanishes = [](const Expr& e) { return constant(e) && contact::certainly_zero(e); };
    return in_b && vanishes(in_a->rate) && vanishes(in_b->rate) && constant(in_b->at_origin)
               ? std::optional(number_of(in_b->at_origin))
               : std::nullopt;
}

} // namespace

Distance::Distance(Expr u, Expr x) {
    if (constant(u)) {
        number_ = number_of(u);
    }
    formulas_ =
        std::make_shared<Formulas>(Formulas{u, x, number_ ? std::nullopt : without_edges(x)});
}

Ball Distance::enclosure(const Ball& a, const Ball& b, long bits) const {
    return number_ ? formula::ball_of(*number_, bits)
                   : formula::evaluate<Ball>(formulas_->u, EdgesInBalls{a, b, {bits}});
}

Ball Distance::x_enclosure(const Ball& a, const Ball& b, long bits) const {
    return x() ? formula::ball_of(*x(), bits)
               : formula::evaluate<Ball>(formulas_->x, EdgesInBalls{a, b, {bits}});
}

Form Distance::exactly(const std::function<Form(std::string_view)>& edge) const {
    return algebra::form_of(number_ ? number_->expr() : formulas_->u, edge);
}

Place::Place(std::string text, From from, Expr value, const Names& names)
    : text_(std::move(text)), from_(from), value_(std::move(value)) {
    const auto edge = [&](std::string_view name) {
        const auto known = names.find(name);
        return known == names.end() ? Expr::symbol(name) : known->second;
    };
    a_ = edge("a");
    b_ = edge("b");
}

Place Place::parse(std::string_view text, From from, const Names& names) {
    const bool percent = !text.empty() && text.back() == '%';
    require(!percent || from != From::origin, "a percentage is of the length a + b, from an edge",
            "give it as u, or x as a place, such as \"a/2\"");
    std::set<std::string> known{"a", "b"};
    for (const auto& [name, value] : names) {
        known.insert(name);
    }
    Expr value =
        formula::parse(percent ? text.substr(0, text.size() - 1) : text, formula::Symbols(known));
    require(!formula::has_binder(value), "an integral or a sum is no place",
            "write a formula such as \"a/2\"");
    if (percent) {
        value = value / Expr::number(Rational(100)) * (Expr::symbol("a") + Expr::symbol("b"));
    }
    // The name a is replaced last: where b = a, the name b is replaced by a.
    for (const auto& [name, meaning] : names) {
        if (name != "a") {
            value = formula::substitute(value, name, meaning);
        }
    }
    if (const auto a = names.find("a"); a != names.end()) {
        value = formula::substitute(value, "a", a->second);
    }
    Place place((from == From::origin ? "x = " : "") + std::string(text), from, std::move(value),
                names);
    return place;
}

Place Place::between(const Place& from, const Place& to, const Rational& t) {
    if (t == 0 || t == 1) {
        return t == 0 ? from : to;
    }
    Expr value = from.value_ * Expr::number(Rational(1 - t)) + to.value_ * Expr::number(t);
    const auto in_a = contact::as_linear(value, "a");
    if (const auto in_b = in_a ? contact::as_linear(in_a->at_origin, "b") : std::nullopt) {
        const Expr one = Expr::number(Rational(1));
        std::optional<Expr> sum;
        for (const auto& [factor, of] : {std::pair(in_a->rate, Expr::symbol("a")),
                                         {in_b->rate, Expr::symbol("b")},
                                         {in_b->at_origin, one}}) {
            const auto q = known_rational(factor);
            if (!q || *q != 0) {
                const Expr number = q ? Expr::number(*q) : factor;
                const Expr term = of == one ? number : q && *q == 1 ? of : number * of;
                sum = sum ? *sum + term : term;
            }
        }
        value = sum.value_or(Expr::number(Rational(0)));
    }
    Place place = from;
    place.value_ = value;
    place.text_ = (from.from_ == From::origin ? "x = " : "") + formula::to_text(value);
    return place;
}

std::optional<Exact> Place::number() const {
    return constant(value_) ? std::optional(number_of(value_)) : std::nullopt;
}

Distance Place::distance(Edge edge) const {
    const bool right = edge == Edge::right;
    if (from_ == From::origin) {
        return {right ? a_ - value_ : value_ + b_, value_};
    }
    return {value_, right ? a_ - value_ : value_ - b_};
}

} // namespace edgeproof::scene
