// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/profile/slope.hpp"

#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/series/functions.hpp"

namespace edgeproof::contact {
namespace {

/// The environment in which an expression in x is evaluated over U, Real or Series<Real>. `lift`
/// makes a constant of that type.
template <class U, class Lift> class SlopeEnvironment {
public:
    SlopeEnvironment(const U& x, const Lift& lift) : x_(x), lift_(lift) {}
    [[nodiscard]] U number(const Rational& q) const { return lift_(from_rational<Real>(q)); }
    [[nodiscard]] U pi() const { return lift_(edgeproof::pi<Real>()); }
    [[nodiscard]] U symbol(std::string_view) const { return x_; }

private:
    const U& x_;
    const Lift& lift_;
};

} // namespace

RealSlope::RealSlope(const Profile& profile) : origin_(profile.origin()) {
    for (const Exact& knot : profile.knots()) {
        knots_.push_back(knot.to<Real>());
    }
    for (const SlopePiece& piece : profile.pieces()) {
        Piece p;
        p.expression = piece.slope;
        if (piece.linear) {
            p.linear = true;
            p.at_origin = Exact(piece.linear->at_origin).to<Real>();
            p.rate = Exact(piece.linear->rate).to<Real>();
        }
        pieces_.push_back(std::move(p));
    }
}

Real RealSlope::value(std::size_t piece, const Real& x) const {
    const Piece& p = pieces_[piece];
    if (p.linear) {
        return p.at_origin + p.rate * x;
    }
    const auto lift = [](const Real& c) { return c; };
    return evaluate<Real>(p.expression, SlopeEnvironment<Real, decltype(lift)>(x, lift));
}

Real RealSlope::rate(std::size_t piece, const Real& x) const {
    const Piece& p = pieces_[piece];
    if (p.linear) {
        return p.rate;
    }
    // Two terms of the Taylor series at x: the second is g''.
    using S = series::Series<Real>;
    const auto lift = [](const Real& c) { return S(c, 2); };
    return evaluate<S>(p.expression,
                       SlopeEnvironment<S, decltype(lift)>(S::variable(x, 2), lift))[1];
}

std::size_t RealSlope::piece_at(const Real& x) const {
    std::size_t i = 0;
    while (i < knots_.size() && !(x < knots_[i])) {
        ++i;
    }
    return i;
}

} // namespace edgeproof::contact
