// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/side_search.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <deque>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr long cover_bits = 128;
constexpr long even_places = 28;
constexpr unsigned places_by_the_edge = 20;
constexpr std::size_t places_kept = 3;
constexpr unsigned finest_box = 70; ///< halvings of a range

struct ParameterBox {
    Rational lo;
    Rational hi;
    std::vector<Rational> places; ///< those that decided the parent box, or nearly did
    unsigned depth = 0;
};

/// The state of a box of parameters.
enum class BoxState {
    open,
    bounded, ///< no reach in it exceeds the target
    better,  ///< its middle seems to reach farther than the target
    excluded ///< every reach in it is less than one that is proved
};

class Cover {
public:
    Cover(const ReachProblem& problem, ParameterRange range, const Rational& shown,
          const DesignOptions& options)
        : problem_(problem), range_(std::move(range)), shown_(shown), target_(shown + options.gap),
          options_(options), tolerance_(problem.tolerance, cover_bits) {}

    /// Divides the widest boxes first, so that those left at the end of the budget are narrow.
    [[nodiscard]] CoveredRange run() {
        std::deque<ParameterBox> left{{range_.from, range_.to, {}, 0}};
        CoveredRange result;
        double done = 0;
        while (!left.empty() && result.boxes < options_.most_boxes) {
            check_interruption();
            ParameterBox& box = left.front();
            BoxState state = BoxState::open;
            try {
                state = decided(box);
            } catch (const BudgetError&) {
                break;
            }
            ++result.boxes;
            if (state == BoxState::bounded || state == BoxState::excluded) {
                if (state == BoxState::bounded) {
                    widen(result.best, box);
                }
                done +=
                    Rational((box.hi - box.lo) / (range_.to - range_.from)).convert_to<double>();
                if (options_.progress) {
                    options_.progress(static_cast<std::size_t>(done * 1000), 1000);
                }
            } else if (state == BoxState::better) {
                widen(result.better, box);
                break;
            } else if (box.depth > finest_box) {
                widen(result.open, box);
                widen(result.best, box);
            } else {
                split(box, left);
            }
            left.pop_front();
        }
        for (const ParameterBox& box : left) {
            widen(result.open, box);
            widen(result.best, box);
        }
        result.covered = !result.open;
        return result;
    }

private:
    static void widen(std::optional<ParameterRange>& hull, const ParameterBox& box) {
        hull = hull ? ParameterRange{std::min(hull->from, box.lo), std::max(hull->to, box.hi)}
                    : ParameterRange{box.lo, box.hi};
    }
    [[nodiscard]] bool beyond(const Ball& f) const { return is_beyond(side_of(f, tolerance_)); }
    [[nodiscard]] BoxState decided(ParameterBox& box) const {
        const Ball whole = Ball::hull(Ball(box.lo, cover_bits), Ball(box.hi, cover_bits));
        const Ball middle(Rational((box.lo + box.hi) / 2), cover_bits);
        const auto over = problem_.over(whole);
        const Ball part(problem_.part, cover_bits);
        for (const auto& f : over) {
            const Ball limit = f.length * part;
            if (limit.is_finite() && certainly_less(limit, Ball(target_, cover_bits))) {
                return certainly_less(limit, Ball(shown_, cover_bits)) ? BoxState::excluded
                                                                       : BoxState::bounded;
            }
        }
        const auto in_middle = problem_.over(middle);
        const auto decides = [&](const Rational& u) {
            const Ball place(u, cover_bits);
            for (std::size_t e = 0; e < over.size(); ++e) {
                if (beyond(over[e].at(place))) {
                    return true;
                }
                // Mean value form (moore-kearfott-cloud2009).
                const Ball f = in_middle[e].at(place);
                if (beyond(f) &&
                    beyond(f + over[e].along(place, Along::parameter)[1] * (whole - middle))) {
                    return true;
                }
            }
            return false;
        };
        const auto state_by = [&](const std::vector<Rational>& places) {
            const auto u = std::find_if(places.begin(), places.end(), decides);
            return u == places.end() ? BoxState::open
                   : *u > shown_     ? BoxState::bounded
                                     : BoxState::excluded;
        };
        const BoxState by_parents = state_by(box.places);
        if (by_parents == BoxState::excluded) {
            return by_parents;
        }
        std::vector<Rational> fresh = promising(in_middle);
        std::swap(fresh, box.places);
        if (box.places.empty() &&
            by_parents == BoxState::open) { // the middle may reach farther than all others
            if (certainly_less(Ball(target_, cover_bits), proved_at(middle))) {
                return BoxState::better;
            }
        }
        std::vector<Rational> places;
        for (const Rational& u : box.places) {
            if (std::find(fresh.begin(), fresh.end(), u) == fresh.end()) {
                places.push_back(u);
            }
        }
        const BoxState state = state_by(places);
        return state == BoxState::excluded || by_parents == BoxState::open ? state : by_parents;
    }
    /// Returns the reach for an exact parameter; 0 if it is not proved.
    [[nodiscard]] Ball proved_at(const Ball& parameter) const {
        try {
            return proved_reach(problem_, parameter).reach;
        } catch (const BudgetError&) {
            return {0, cover_bits};
        }
    }
    /// Returns places up to the target at which the error in the middle of the box exceeds the
    /// tolerance most, with extrema between samples. Those that exclude the box come first.
    [[nodiscard]] std::vector<Rational>
    promising(const std::vector<ErrorOverBox>& in_middle) const {
        std::vector<std::pair<double, Rational>> found;
        for (const auto& f : in_middle) {
            const auto excess = [&](const Rational& u) {
                const Ball e = abs(f.at(Ball(u, cover_bits))) - tolerance_;
                return e.is_finite() ? approximate(e) : -1.0;
            };
            std::vector<Rational> at;
            std::vector<double> e;
            // A knot near the edge may raise the error only there.
            for (unsigned k = places_by_the_edge; k > 0; --k) {
                at.emplace_back(target_ / (even_places * pow(Integer(2), k)));
            }
            for (long k = 1; k < even_places; ++k) {
                at.emplace_back(target_ * k / even_places);
            }
            at.push_back(shown_);
            at.push_back(target_);
            const Ball length = f.length;
            if (length.is_finite()) { // a power law's error may have a cusp in the middle
                at.push_back(std::min(target_, Rational(exact_value(length.midpoint()) / 2)));
            }
            std::sort(at.begin(), at.end());
            at.erase(std::unique(at.begin(), at.end()), at.end());
            for (const Rational& u : at) {
                e.push_back(excess(u));
            }
            for (std::size_t k = 0; k < at.size(); ++k) {
                if (e[k] > 0) {
                    found.emplace_back(e[k], at[k]);
                }
                if (k > 0 && k + 1 < at.size() && e[k] >= e[k - 1] && e[k] >= e[k + 1]) {
                    const Rational top = extremum_near(f, at[k]);
                    if (top > at[k - 1] && top < at[k + 1]) {
                        found.emplace_back(excess(top), top);
                    }
                }
            }
        }
        const auto rank = [&](const auto& x) { return std::pair(x.second > shown_, -x.first); };
        std::sort(found.begin(), found.end(),
                  [&](const auto& x, const auto& y) { return rank(x) < rank(y); });
        std::vector<Rational> places;
        for (const auto& [excess, u] : found) {
            if (excess > 0 && (places.size() < places_kept || u == target_)) {
                places.push_back(u);
            }
        }
        return places;
    }
    /// Applies Newton's method to f'. The result is only a place to try; nothing is proved.
    [[nodiscard]] static Rational extremum_near(const ErrorOverBox& f, const Rational& start) {
        Rational u = start;
        for (int k = 0; k < 5 && u > 0; ++k) {
            const BallSeries at = f.along(Ball(u, cover_bits), Along::u);
            const Ball step = at[1] / (at[2] * 2);
            if (!step.is_finite()) {
                break;
            }
            u = exact_value(Ball(Ball(u, 64) - step.with_bits(64)).with_bits(53).midpoint());
        }
        return u;
    }
    static void split(const ParameterBox& box, std::deque<ParameterBox>& into) {
        ParameterBox left = box;
        ParameterBox right = box;
        left.hi = right.lo = (box.lo + box.hi) / 2;
        ++left.depth;
        ++right.depth;
        into.push_back(std::move(left));
        into.push_back(std::move(right));
    }
    const ReachProblem& problem_;
    ParameterRange range_;
    Rational shown_;
    Rational target_;
    const DesignOptions& options_;
    Ball tolerance_;
};

} // namespace

CoveredRange covered_by_exits(const ReachProblem& problem, const ParameterRange& range,
                              const Rational& shown, const DesignOptions& options) {
    return Cover(problem, range, shown, options).run();
}

} // namespace edgeproof::contact
