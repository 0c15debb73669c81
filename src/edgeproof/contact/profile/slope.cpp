// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/profile/slope.hpp"

#include "edgeproof/formula/evaluation/complex_taylor.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof::contact {
namespace {

constexpr long spare_bits = 32;

/// A ball of the number x, with more bits than the working precision.
Ball wider(const Real& x) { return {x, mpfr_get_prec(raw(Real())) + spare_bits}; }

/// The numbers of an expression are rounded to the working precision, as places are, so that
/// (x - 1/5)^(3/2) vanishes at the knot 1/5.
struct RoundedNumbers {
    const Ball& x;
    [[nodiscard]] static Ball number(const Rational& q) { return wider(from_rational<Real>(q)); }
    [[nodiscard]] static Ball pi() { return wider(edgeproof::pi<Real>()); }
    [[nodiscard]] Ball symbol(std::string_view) const { return x; }
};

Real rounded(const Ball& x) {
    if (!x.is_finite()) {
        throw DomainError("a slope has no value");
    }
    return at_working_precision(x.midpoint());
}

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
    const Ball at = wider(x);
    return rounded(evaluate<Ball>(p.expression, RoundedNumbers{at}));
}

Real RealSlope::rate(std::size_t piece, const Real& x) const {
    const Piece& p = pieces_[piece];
    if (p.linear) {
        return p.rate;
    }
    const Ball at = wider(x);
    return rounded(holomorphic_series(p.expression, Box(at), 2, at.bits())[1].real());
}

std::size_t RealSlope::piece_at(const Real& x) const {
    std::size_t i = 0;
    while (i < knots_.size() && !(x < knots_[i])) {
        ++i;
    }
    return i;
}

std::vector<Box> holomorphic_series(const Expr& slope, const Box& s, std::size_t terms, long bits) {
    AcbPolyValue g;
    formula::complex_taylor(g, slope, s.get(), static_cast<slong>(terms), bits);
    std::vector<Box> series(terms, Box(bits));
    for (std::size_t k = 0; k < terms; ++k) {
        acb_poly_get_coeff_acb(series[k].get(), g, static_cast<slong>(k));
    }
    return series;
}

} // namespace edgeproof::contact
