// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/profile/slope_at_root.hpp"

#include <utility>

namespace edgeproof::contact {

std::vector<quadrature::ThetaSpan> IntegratedContact::piece_spans(const Ball& a,
                                                                  const Ball& b) const {
    // The order is from the right, where theta = 0. A knot that may lie on an edge is set to that
    // edge.
    std::vector<quadrature::ThetaSpan> list;
    Ball from(0, bits_);
    for (std::size_t i = knots_.size() + 1; i-- > 0;) {
        const auto here = i > 0 ? on_edge_[i - 1] : std::optional<Edge>(Edge::left);
        const Mark<Ball> next =
            here ? end_mark(Extent<Ball>{a, b}, *here) : clamped_mark({a, b}, knots_[i - 1]);
        if (i > 0 && next.end == Edge::right) {
            continue;
        }
        list.push_back({.piece = i, .from = from, .to = next.h, .formula = i});
        from = next.h;
        if (next.end) {
            break;
        }
    }
    return list;
}

const IntegratedContact::Roots& IntegratedContact::roots() const {
    if (!roots_) {
        Roots found;
        for (const SlopePiece& piece : profile_.pieces()) {
            found.formulas.push_back(piece.slope);
        }
        for (std::size_t i = 0; i < profile_.knots().size(); ++i) {
            std::array<Roots::Root, 2> sides;
            for (const std::size_t side : {0U, 1U}) {
                const SlopePiece& piece = profile_.pieces()[i + side];
                auto root_form =
                    piece.linear
                        ? std::nullopt
                        : slope_at_root(piece.slope, profile_.knots()[i].expr(), side == 1);
                if (root_form) {
                    sides.at(side) = {found.formulas.size(), root_form->root};
                    found.formulas.push_back(std::move(root_form->slope));
                }
            }
            found.of_knots.push_back(sides);
        }
        roots_ = std::make_shared<const Roots>(std::move(found));
    }
    return *roots_;
}

// docs/curved-slopes.md, "What is integrated": a branch point on a knot, |s - v| = w^n.
std::vector<quadrature::ThetaSpan> IntegratedContact::spans(const Ball& a, const Ball& b) const {
    const Ball centre = (a - b) / 2;
    const Ball half = (a + b) / 2;
    std::vector<quadrature::ThetaSpan> list;
    for (const quadrature::ThetaSpan& whole : piece_spans(a, b)) {
        Ball middle((whole.from + whole.to) / 2);
        arb_get_mid_arb(middle.data(), middle.data());
        const Ball s = centre + half * cos(middle);
        // Next to the knot at the right end of the piece, and next to the knot at its left end.
        const auto rooted = [&](std::size_t knot, std::size_t side) {
            const Roots::Root& root = roots().of_knots[knot].at(side);
            const Ball distance = side == 0 ? knots_[knot] - s : s - knots_[knot];
            std::optional<quadrature::ThetaSpan> span;
            if (root.root != 0 && certainly_less(knots_[knot], a) &&
                certainly_less(-b, knots_[knot]) && certainly_positive(distance)) {
                span = {.piece = whole.piece,
                        .from = Ball(0, bits_),
                        .to = pow(distance, Rational(1, root.root)),
                        .formula = root.formula,
                        .root = root.root,
                        .side = side == 0 ? -1 : 1,
                        .knot = knots_[knot]};
            }
            return span;
        };
        const auto right = whole.piece < knots_.size() ? rooted(whole.piece, 0) : std::nullopt;
        const auto left = whole.piece > 0 ? rooted(whole.piece - 1, 1) : std::nullopt;
        if (!right && !left) {
            list.push_back(whole);
            continue;
        }
        quadrature::ThetaSpan part = whole;
        part.to = middle;
        list.push_back(right ? *right : part);
        part.from = middle;
        part.to = whole.to;
        list.push_back(left ? *left : part);
    }
    return list;
}

SlopeIntegrand IntegratedContact::integrand(const quadrature::ThetaSpan& span, const Ball& a,
                                            const Ball& b) const {
    return {&profile_.pieces()[span.piece].slope, &roots().formulas[span.formula], (a - b) / 2,
            (a + b) / 2};
}

} // namespace edgeproof::contact
