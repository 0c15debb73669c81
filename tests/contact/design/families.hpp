// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

/// Errors as functions of a parameter, for the tests.
namespace edgeproof::families {

inline formula::Expr in(const std::string& text, const std::set<std::string>& names) {
    return formula::parse(text, formula::Symbols(names));
}

inline ErrorQuestion about(std::size_t terms = 1, Edge edge = Edge::right) {
    ErrorQuestion q;
    q.terms = terms;
    q.edge = edge;
    return q;
}

inline bool holds(const Ball& x, const char* decimal, long slack_digits) {
    const Ball exact(Rational(parse_decimal(decimal)), x.bits());
    Rational slack(1);
    for (long k = 0; k < slack_digits; ++k) {
        slack /= 10;
    }
    return certainly_less(abs(x - exact), Ball(slack, x.bits()));
}

/// Compares jets with values: second-order Taylor with a step so small that its remainder is below
/// 1e-18.
inline void check_jet(const ErrorFamily& family, const Rational& u, const Rational& parameter) {
    constexpr long bits = 300;
    const Rational h(1, 10'000'000'000L);
    const auto value = [&](const Rational& x, const Rational& t) {
        return family.over(Ball(t, bits)).at(Ball(x, bits));
    };
    const Jet jet = family.over(Ball(parameter, bits)).jet(Ball(u, bits));
    const Ball tiny(Rational(1, 1'000'000'000'000L), bits);
    const auto close = [&](const Ball& x, const Ball& y) {
        CHECK(x.is_finite());
        CHECK(certainly_less(abs(x - y), tiny * (abs(y) + 1)));
    };
    const Ball two_h(Rational(2 * h), bits);
    const Ball hh(Rational(h * h), bits);
    const Rational t = parameter;
    close(jet.v, value(u, t));
    close(jet.g[0], (value(u + h, t) - value(u - h, t)) / two_h);
    close(jet.g[1], (value(u, t + h) - value(u, t - h)) / two_h);
    close(jet.h[0], (value(u + h, t) - value(u, t) * 2 + value(u - h, t)) / hh);
    close(jet.h[2], (value(u, t + h) - value(u, t) * 2 + value(u, t - h)) / hh);
    close(jet.h[1],
          (value(u + h, t + h) - value(u + h, t - h) - value(u - h, t + h) + value(u - h, t - h)) /
              (hh * 4));
}

} // namespace edgeproof::families
