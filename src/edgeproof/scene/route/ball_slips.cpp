// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/ball_slips.hpp"

#include "edgeproof/contact/slip/slip_reach.hpp"
#include "edgeproof/formula/exact/identity.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::scene {
namespace {

/// The most bits used to separate a place from an edge of the stick zone.
constexpr long most_state_bits = 1330;

formula::ExactNumber no_exact_form(ExactValues& /*values*/) {
    return formula::ExactNumber::unknown();
}

} // namespace

void BallSlips::check() {
    if (std::exchange(checked_, true)) {
        return;
    }
    const contact::ShearSpec& shear = *scene_.shear;
    if (scene_.load.kind == contact::Load::Kind::force) {
        // Balls cannot decide a load exactly on the limit.
        const formula::Expr Q = shear.Q.sign() > 0 ? shear.Q.expr() : -shear.Q.expr();
        const auto sign =
            formula::decided_sign(scene_.load.value.expr() * shear.friction->expr() - Q);
        if (sign && *sign <= 0) {
            refuse_sliding(scene_, scene_.load.value.to<Real>());
        }
    }
    bool looked = false;
    const auto refuse = [&](const contact::BallSlip& slip, contact::Edge edge, bool reached) {
        const Real one = slip.tension_limit(contact::Edge::right).midpoint();
        const Real other = slip.tension_limit(contact::Edge::left).midpoint();
        refuse_tension(scene_, edge, reached, std::min(one, other), std::max(one, other));
    };
    for (long bits = plan_.bits; bits <= balls_.last_bits(); bits *= 2) {
        BallLevel* level = balls_.at_level(bits);
        const contact::BallSlip* slip = level != nullptr ? level->slip() : nullptr;
        if (slip == nullptr) {
            if (level != nullptr && !std::exchange(looked, true)) {
                refuse_exactly_sliding(*level);
            }
            continue;
        }
        if (slip->sliding()) {
            refuse_sliding(scene_, level->force().midpoint());
        }
        const Ball right = slip->size(contact::Edge::right);
        const Ball left = slip->size(contact::Edge::left);
        if (certainly_negative(right) || certainly_negative(left)) {
            refuse(*slip, certainly_negative(right) ? contact::Edge::right : contact::Edge::left,
                   false);
        }
        level_ = level;
        balls_.expect_lost(lost_by(0));
        if (certainly_positive(right) && certainly_positive(left)) {
            return;
        }
    }
    if (level_ != nullptr && shear.bulk_tension.sign() != 0) { // bits do not separate d from 0
        const contact::BallSlip& slip = *level_->slip();
        const bool right = !certainly_positive(slip.size(contact::Edge::right));
        refuse(slip, right ? contact::Edge::right : contact::Edge::left, true);
    }
}

/// Refuses |Q| = f P, decided by the exact form of P.
void BallSlips::refuse_exactly_sliding(const BallLevel& level) {
    const contact::ShearSpec& shear = *scene_.shear;
    const auto left = [&](ExactValues& exact) {
        const formula::ExactNumber Q = formula::ExactNumber::of(shear.Q.expr());
        return formula::ExactNumber::of(shear.friction->expr()) * exact.force() -
               (shear.Q.sign() > 0 ? Q : -Q);
    };
    const Ball near = ball_of(*shear.friction, level.bits()) * level.force() -
                      abs(ball_of(shear.Q, level.bits()));
    const auto zero = balls_.exact_value(left, level, near);
    if (zero && *zero == 0) {
        refuse_sliding(scene_, level.force().midpoint());
    }
}

std::optional<BoundedValue> BallSlips::bounded(const BallRefinement::InBalls& f,
                                               const Digits& digits, const char* route, long lost) {
    auto found = balls_.refine(f, no_exact_form, digits, 0, lost);
    return found ? std::optional(BoundedValue{std::move(found->value), true, route, {}})
                 : std::nullopt;
}

long BallSlips::lost_by(std::size_t n) const {
    if (level_ == nullptr) {
        return 0;
    }
    const Ball& ratio = level_->slip()->load_ratio();
    return static_cast<long>(n + 1) *
           std::max<long>(0, -arf_abs_bound_lt_2exp_si(arb_midref(ratio.data())));
}

std::optional<contact::SlipState> BallSlips::state(contact::Edge edge, const Distance& u) {
    std::optional<contact::SlipState> found;
    for (long bits = plan_.bits; bits <= balls_.last_bits(); bits *= 2) {
        BallLevel* level = balls_.at_level(bits);
        if (level == nullptr || level->slip() == nullptr) {
            continue;
        }
        found = level->slip()->state(edge, level->distance(u));
        if (*found != contact::SlipState::undecided || bits >= plan_.bits + most_state_bits) {
            break;
        }
    }
    return found;
}

bool BallSlips::in_proportion() {
    return level_ == nullptr || (level_->slip()->slips_from_the_first(contact::Edge::right) &&
                                 level_->slip()->slips_from_the_first(contact::Edge::left));
}

std::vector<Row> BallSlips::terms(contact::Edge edge, std::size_t n) {
    const std::size_t most = scene_.ask.most_terms();
    const auto of_series = [edge, n, most](BallLevel& level) {
        const Ball& first = level.slip_series(edge, most).front();
        return level.slip() == nullptr ? first
                                       : contact::slip_sum(level.slip_series(edge, most), n,
                                                           level.slip()->load_ratio());
    };
    auto size = bounded(of_series, plan_.digits, "series");
    auto error = bounded(
        [&](BallLevel& level) { return abs(Ball(1 - of_series(level) / level.slip_size(edge))); },
        plan_.error_digits(), "series", lost_by(n));
    if (!size || !error) {
        return {};
    }
    const AskedValue asked{Quantity::slip_terms, n, edge, {}, scene_.ask.tolerance};
    std::vector<Row> rows{{asked, std::move(size)}, {asked, std::move(error)}, {asked}};
    rows[1].asked.quantity = Quantity::slip_rel;
    rows[2].asked.quantity = Quantity::slip_load;
    if (scene_.ask.tolerance && level_ != nullptr && in_proportion()) {
        find_reach(rows[2]);
    }
    return rows;
}

void BallSlips::find_reach(Row& row) {
    contact::SlipReachSearch search(
        [&](long bits) -> const contact::BallSlip& {
            BallLevel* level = balls_.at_level(bits);
            if (level == nullptr || level->slip() == nullptr) {
                throw BudgetError("too few bits to enclose the stick zone");
            }
            return *level->slip();
        },
        row.asked.edge, row.asked.k, *scene_.ask.tolerance);
    for (long bits = plan_.bits; bits <= balls_.last_bits(); bits *= 2) {
        try {
            const contact::EnclosedReach reach = search.at(bits);
            row.reached = reach.leaves;
            row.value = BoundedValue{reach.ratio, true, "sign changes",
                                     reach.leaves ? std::nullopt : std::optional(Rational(1))};
            if (!reach.leaves || has_digits(reach.ratio, plan_.digits)) {
                return;
            }
        } catch (const BudgetError&) {
            if (search.zones() > contact::SlipReachSearch::most_zones) {
                return;
            }
        }
    }
}

} // namespace edgeproof::scene
