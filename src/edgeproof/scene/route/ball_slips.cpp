// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/slip/slip_reach.hpp"
#include "edgeproof/formula/exact/identity.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/scene/route/ball_route.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::scene {
namespace {

/// The most bits used to separate a place from an edge of the stick zone.
constexpr long most_state_bits = 1330;

} // namespace

void BallRoute::check_slip() {
    if (std::exchange(slip_checked_, true)) {
        return;
    }
    const contact::ShearSpec& shear = *scene_.shear;
    if (scene_.load.kind == contact::Load::Kind::force && !scene_.history) {
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
    for (long bits = plan_.bits; bits <= last_bits(); bits *= 2) {
        BallLevel* level = at_level(bits);
        const contact::BallSlip* slip = level != nullptr ? level->slip() : nullptr;
        if (slip == nullptr) {
            if (level != nullptr && !std::exchange(looked, true)) {
                refuse_exactly_sliding(*level);
            }
            continue;
        }
        if (slip->sliding()) {
            refuse_sliding(scene_, level->whole_force().midpoint());
        }
        const Ball right = slip->size(contact::Edge::right);
        const Ball left = slip->size(contact::Edge::left);
        if (certainly_negative(right) || certainly_negative(left)) {
            refuse(*slip, certainly_negative(right) ? contact::Edge::right : contact::Edge::left,
                   false);
        }
        slip_level_ = level;
        lost_bits_ = lost_by(0);
        if (scene_.history && !scene_.history->stick) {
            return; // nothing slipped in the last step
        }
        if (certainly_positive(right) && certainly_positive(left)) {
            return;
        }
    }
    if (slip_level_ != nullptr && shear.bulk_tension.sign() != 0) {
        // The bits do not separate the size of a slip zone from 0.
        const contact::BallSlip& slip = *slip_level_->slip();
        const bool right = !certainly_positive(slip.size(contact::Edge::right));
        refuse(slip, right ? contact::Edge::right : contact::Edge::left, true);
    }
}

void BallRoute::refuse_exactly_sliding(const BallLevel& level) {
    const contact::ShearSpec& shear = *scene_.shear;
    const auto left = [&](ExactValues& exact) {
        const formula::ExactNumber Q = formula::ExactNumber::of(shear.Q.expr());
        return formula::ExactNumber::of(shear.friction->expr()) * exact.whole_force() -
               (shear.Q.sign() > 0 ? Q : -Q);
    };
    const Ball near = ball_of(*shear.friction, level.bits()) * level.whole_force() -
                      abs(ball_of(shear.Q, level.bits()));
    const auto zero = exact_value(left, level, near);
    if (zero && *zero == 0) {
        refuse_sliding(scene_, level.whole_force().midpoint());
    }
}

long BallRoute::lost_by(std::size_t n) const {
    if (slip_level_ == nullptr) {
        return 0;
    }
    const Ball& ratio = slip_level_->slip()->load_ratio();
    return static_cast<long>(n + 1) *
           std::max<long>(0, -arf_abs_bound_lt_2exp_si(arb_midref(ratio.data())));
}

contact::SlipState BallRoute::state(contact::Edge edge, const Distance& u) {
    std::optional<contact::SlipState> found;
    for (long bits = plan_.bits; bits <= last_bits(); bits *= 2) {
        BallLevel* level = at_level(bits);
        if (level == nullptr || level->slip() == nullptr) {
            continue;
        }
        found = level->slip()->state(edge, level->distance(u));
        if (*found != contact::SlipState::undecided || bits >= plan_.bits + most_state_bits) {
            break;
        }
    }
    return found ? *found : others().state(edge, u);
}

bool BallRoute::in_proportion() {
    return slip_level_ == nullptr ||
           (slip_level_->slip()->slips_from_the_first(contact::Edge::right) &&
            slip_level_->slip()->slips_from_the_first(contact::Edge::left));
}

std::vector<Row> BallRoute::slip_terms(const AskedValue& asked) {
    const auto of_series = [&](BallLevel& level) {
        const std::vector<Ball>& series = level.slip_series(asked.edge, scene_.ask.most_terms());
        return level.slip() == nullptr
                   ? series.front()
                   : contact::slip_sum(series, asked.k, level.slip()->load_ratio());
    };
    auto size = refine(of_series, nullptr, plan_.digits, plan_.bits);
    auto error = refine(
        [&](BallLevel& level) {
            return abs(Ball(1 - of_series(level) / level.slip_size(asked.edge)));
        },
        nullptr, plan_.error_digits(), plan_.bits, lost_by(asked.k));
    if (!size || !error) {
        return {};
    }
    std::vector<Row> rows = slip_rows(asked, {std::move(size->value), true, "series"},
                                      {std::move(error->value), true, "series"});
    if (asked.tolerance && slip_level_ != nullptr && in_proportion()) {
        find_reach(rows.back());
    }
    return rows;
}

void BallRoute::find_reach(Row& row) {
    contact::SlipReachSearch search(
        [&](long bits) -> const contact::BallSlip& {
            BallLevel* level = at_level(bits);
            if (level == nullptr || level->slip() == nullptr) {
                throw BudgetError("too few bits to enclose the stick zone");
            }
            return *level->slip();
        },
        row.asked.edge, row.asked.k, *row.asked.tolerance);
    for (long bits = plan_.bits; bits <= last_bits(); bits *= 2) {
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
