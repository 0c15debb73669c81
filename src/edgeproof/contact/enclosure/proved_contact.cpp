// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/proved_contact.hpp"

#include "edgeproof/algebra/identity.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::contact {

bool certainly_zero(const Expr& e) { return algebra::decided_sign(e) == 0; }

ProvedContact::ProvedContact(const Profile& profile, const Ball& modulus, long bits)
    : profile_(profile), bits_(bits), modulus_(modulus),
      slope_(linear_slope<Ball>(
          profile, [bits](const Expr& e) { return formula::enclosed_constant(e, bits); })),
      on_edge_(profile.knots().size()) {}

bool ProvedContact::edge_may_be_on_knot() const {
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        if (bends(i) && ((!known(Edge::right) && overlaps(slope_.knots[i], a_)) ||
                         (!known(Edge::left) && overlaps(-slope_.knots[i], b_)))) {
            return true;
        }
    }
    return false;
}

std::vector<Ball> ProvedContact::corners(Edge edge) const {
    std::vector<Ball> distances;
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        if (profile_.has_corner(i) && inside(i)) {
            distances.push_back(edge == Edge::right ? a_ - slope_.knots[i] : b_ + slope_.knots[i]);
        }
    }
    return distances;
}

void ProvedContact::find_knots_on_edges() {
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        const Expr knot = profile_.knots()[i].expr();
        if (known_a_ && overlaps(slope_.knots[i], constant(known_a_->expr())) &&
            certainly_zero(known_a_->expr() - knot)) {
            on_edge_[i] = Edge::right;
        } else if (const auto b = known(Edge::left);
                   b && overlaps(-slope_.knots[i], constant(b->expr())) &&
                   certainly_zero(b->expr() + knot)) {
            on_edge_[i] = Edge::left;
        }
    }
}

void ProvedContact::move_edges(const Ball& a, const Ball& b) {
    known_a_.reset();
    known_b_.reset();
    std::ranges::fill(on_edge_, std::nullopt);
    a_ = a;
    b_ = b;
}

// A tilt given by a ball is contained in the numbers of the slope and not in the profile.
void ProvedContact::mirror() {
    known_b_ = std::exchange(known_a_, known(Edge::left));
    std::swap(a_, b_);
    profile_ = profile_.reflected();
    for (Ball& knot : slope_.knots) {
        knot = -knot;
    }
    for (auto& piece : slope_.pieces) {
        piece.at_origin = -piece.at_origin;
    }
    std::ranges::reverse(slope_.knots);
    std::ranges::reverse(slope_.pieces);
    std::reverse(slope_.corners.begin(), slope_.corners.end()); // of bits
    std::ranges::reverse(on_edge_);
    slope_.origin = profile_.origin();
    if (!slope_.pieces.empty()) {
        slope_.find_jumps();
    }
    for (auto& edge : on_edge_) {
        edge = edge ? std::optional(opposite(*edge)) : std::nullopt;
    }
}

} // namespace edgeproof::contact
