// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/contact/slip/slip_reach.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/scene/route/scene_values.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::scene {

namespace {

Form exact_form(const Exact& x) { return contact::exact_form(x.expr()); }

/// The most bits used to separate a place from an edge of the stick zone.
constexpr long most_state_bits = 1330;

Row row_with(const AskedValue& asked, Quantity quantity, std::optional<BoundedValue> value) {
    Row row{asked, std::move(value)};
    row.asked.quantity = quantity;
    return row;
}

} // namespace

std::vector<Row> SceneValues::extent(const AskedValue& asked) {
    contact::BallExtentSearch search(
        [&](long bits) -> const ProvedContact& {
            BallLevel* level = at_level(bits);
            if (level == nullptr) {
                throw BudgetError("too few bits to enclose the edges");
            }
            return level->contact();
        },
        asked.edge, asked.k, *asked.tolerance, scene_.ask.part);
    const auto done = [&](const Ball& x, const std::optional<Rational>& q) {
        return q || has_digits(x, scene_.ask.digits);
    };
    std::optional<contact::EnclosedExtents> best;
    ExactExtents exact;
    for (long bits = plan_.bits; bits <= last_bits(); bits *= 2) {
        try {
            best = search.at(bits);
        } catch (const BudgetError&) {
            if (search.evaluations() > contact::BallExtentSearch::most_evaluations) {
                break;
            }
            continue;
        }
        exact = exact_extents(asked, *best, *at_level(bits));
        if (done(best->first_exit, exact.first_exit) && done(best->measure, exact.measure) &&
            std::ranges::equal(best->crossings, exact.crossings, done)) {
            break;
        }
    }
    if (!best) {
        throw BudgetError("the budget does not decide how far " + std::to_string(asked.k) +
                          " terms stay within " + asked.tolerance->text() + " of p at the " +
                          edge_name(asked.edge) + " edge");
    }
    std::vector<Row> rows;
    const auto add = [&](Quantity quantity, const Ball& x, const std::optional<Rational>& q) {
        rows.push_back(row_with(asked, quantity, BoundedValue{x, true, "sign changes", q}));
    };
    const auto add_both = [&](Quantity length, Quantity fraction, const Ball& x,
                              const std::optional<Rational>& q) {
        add(length, x, q);
        add(fraction, x / best->length,
            q && exact.length ? std::optional(Rational(*q / *exact.length)) : std::nullopt);
    };
    add_both(Quantity::extent, Quantity::extent_fraction, best->first_exit, exact.first_exit);
    rows[0].reached = rows[1].reached = best->leaves;
    add_both(Quantity::measure, Quantity::measure_fraction, best->measure, exact.measure);
    for (std::size_t j = 0; j < best->crossings.size(); ++j) {
        add(Quantity::crossing, best->crossings[j], exact.crossings[j]);
        rows.back().asked.j = j;
    }
    return rows;
}

SceneValues::ExactExtents SceneValues::exact_extents(const AskedValue& asked,
                                                     const contact::EnclosedExtents& found,
                                                     const BallLevel& level) {
    ExactExtents result;
    result.crossings.resize(found.crossings.size());
    const auto part = [&](const Exact& fraction) {
        return exact_value([&](ExactValues& e) { return e.length() * exact_form(fraction); }, level,
                           found.length * ball_of(fraction, found.length.bits()));
    };
    result.length = part(Exact::of(Rational(1)));
    if (!result.length) {
        return result;
    }
    bool all = true;
    for (std::size_t k = 0; k < found.crossings.size(); ++k) {
        result.crossings[k] =
            found.single[k] ? exact_crossing(asked, found.crossings[k], level) : std::nullopt;
        all = all && result.crossings[k];
    }
    const auto start = part(scene_.ask.part.from);
    const auto end = part(scene_.ask.part.to);
    result.first_exit = !found.starts_within ? start
                        : !found.leaves      ? end
                                             : result.crossings.front();
    if (!all || !start || !end) {
        return result;
    }
    Rational measure = 0;
    Rational entered = *start;
    bool within = found.starts_within;
    for (const auto& u : result.crossings) {
        measure += within ? Rational(*u - entered) : Rational(0);
        entered = *u;
        within = !within;
    }
    measure += within ? Rational(*end - entered) : Rational(0);
    if (contains(found.measure, measure)) {
        result.measure = measure;
    }
    return result;
}

std::optional<Rational> SceneValues::exact_crossing(const AskedValue& asked, const Ball& u,
                                                    const BallLevel& level) {
    const auto q = may_be_a_limit(u, scene_.ask.digits, has_digits(u, scene_.ask.digits))
                       ? contact::simplest_rational(u)
                       : std::nullopt;
    if (!q || *q <= 0) {
        return {};
    }
    const Form tolerance = exact_form(*asked.tolerance);
    const auto off = [&](ExactValues& e) {
        const Form error = e.relative_error(asked.edge, Form(*q), asked.k, false);
        return error == tolerance || error == -tolerance ? Form(*q) : throw contact::NoExactForm();
    };
    return exact_value(off, level, u);
}

void SceneValues::check_slip() {
    if (std::exchange(slip_checked_, true)) {
        return;
    }
    const ShearSpec& shear = *scene_.shear;
    if (scene_.load.kind == Load::Kind::force && !scene_.history) {
        // Balls cannot decide a load exactly on the limit.
        const Expr Q = shear.Q.sign() > 0 ? shear.Q.expr() : -shear.Q.expr();
        const auto sign =
            algebra::decided_sign(scene_.load.value.expr() * shear.friction->expr() - Q);
        if (sign && *sign <= 0) {
            refuse_sliding(scene_, scene_.load.value.to<Real>());
        }
    }
    bool looked = false;
    const auto refuse = [&](const BallSlip& slip, Edge edge, bool reached) {
        const Real one = slip.tension_limit(Edge::right).midpoint();
        const Real other = slip.tension_limit(Edge::left).midpoint();
        refuse_tension(scene_, edge, reached, std::min(one, other), std::max(one, other));
    };
    const bool separated = raise(plan_.bits, last_bits(), [&](BallLevel& level) {
        const BallSlip* slip = level.slip();
        if (slip == nullptr) {
            if (!std::exchange(looked, true)) {
                refuse_exactly_sliding(level);
            }
            return false;
        }
        if (slip->sliding()) {
            refuse_sliding(scene_, level.whole_force().midpoint());
        }
        if (slip->beyond()) {
            refuse(*slip, *slip->beyond(), false);
        }
        const Ball right = slip->size(Edge::right);
        const Ball left = slip->size(Edge::left);
        slip_level_ = &level;
        lost_bits_ = lost_by(0);
        const bool slipped = !scene_.history || scene_.history->stick; // in the last step
        return !slipped || (certainly_positive(right) && certainly_positive(left));
    });
    if (!separated && slip_level_ != nullptr && shear.bulk_tension.sign() != 0) {
        // The bits do not separate the size of a slip zone from 0.
        const BallSlip& slip = *slip_level_->slip();
        const bool right = !certainly_positive(slip.size(Edge::right));
        refuse(slip, right ? Edge::right : Edge::left, true);
    }
}

void SceneValues::refuse_exactly_sliding(const BallLevel& level) {
    const ShearSpec& shear = *scene_.shear;
    const auto left = [&](ExactValues& exact) {
        const Form Q = exact_form(shear.Q);
        return exact_form(*shear.friction) * exact.whole_force() - (shear.Q.sign() > 0 ? Q : -Q);
    };
    const Ball near = ball_of(*shear.friction, level.bits()) * level.whole_force() -
                      abs(ball_of(shear.Q, level.bits()));
    const auto zero = exact_value(left, level, near);
    if (zero && *zero == 0) {
        refuse_sliding(scene_, level.whole_force().midpoint());
    }
}

long SceneValues::lost_by(std::size_t n) const {
    if (slip_level_ == nullptr) {
        return 0;
    }
    const Ball& ratio = slip_level_->slip()->load_ratio();
    return static_cast<long>(n + 1) *
           std::max<long>(0, -arf_abs_bound_lt_2exp_si(arb_midref(ratio.data())));
}

contact::SlipState SceneValues::state(Edge edge, const Distance& u) {
    auto found = contact::SlipState::undecided;
    raise(plan_.bits, last_bits(), [&](BallLevel& level) {
        if (level.slip() == nullptr) {
            return false;
        }
        found = level.slip()->state(edge, level.distance(u));
        return found != contact::SlipState::undecided ||
               level.bits() >= plan_.bits + most_state_bits;
    });
    return found;
}

bool SceneValues::in_proportion() {
    return slip_level_ == nullptr || (slip_level_->slip()->slips_from_the_first(Edge::right) &&
                                      slip_level_->slip()->slips_from_the_first(Edge::left));
}

std::vector<Row> SceneValues::slip_terms(const AskedValue& asked) {
    check_slip();
    const auto of_series = [&](BallLevel& level) {
        const std::vector<Ball>& series = level.slip_series(asked.edge, scene_.ask.most_terms());
        return level.slip() == nullptr
                   ? series.front()
                   : contact::slip_sum(series, asked.k, level.slip()->load_ratio());
    };
    auto size = refine(of_series, nullptr, scene_.ask.digits, plan_.bits);
    auto error = refine(
        [&](BallLevel& level) {
            return abs(Ball(1 - of_series(level) / level.slip_size(asked.edge)));
        },
        nullptr, digits_of(Quantity::slip_rel, scene_.ask.digits), plan_.bits, lost_by(asked.k));
    if (!size || !error) {
        throw BudgetError("no number of bits encloses the slip zone by " + std::to_string(asked.k) +
                          " terms");
    }
    std::vector<Row> rows{
        row_with(asked, Quantity::slip_terms, BoundedValue{std::move(size->value), true, "series"}),
        row_with(asked, Quantity::slip_rel, BoundedValue{std::move(error->value), true, "series"}),
        row_with(asked, Quantity::slip_load, {})};
    if (asked.tolerance && slip_level_ != nullptr && in_proportion()) {
        find_reach(rows.back());
    }
    return rows;
}

void SceneValues::find_reach(Row& row) {
    contact::SlipReachSearch search(
        [&](long bits) -> const BallSlip& {
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
            if (!reach.leaves || has_digits(reach.ratio, scene_.ask.digits)) {
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
