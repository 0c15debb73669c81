// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <sstream>

namespace edgeproof::contact {
namespace {

constexpr long cover_bits = 128;
constexpr long even_places = 28;
constexpr unsigned places_by_the_edge = 20;
constexpr std::size_t places_kept = 3;
constexpr unsigned finest_box = 70; ///< halvings of a range

struct ParameterBox {
    std::vector<Rational> lo;
    std::vector<Rational> hi;
    std::vector<Rational> places; ///< that decided the box it comes from, or came near
    unsigned depth = 0;
};

class Cover {
public:
    Cover(const ReachProblem& problem, const std::vector<ParameterRange>& ranges,
          const Rational& target, const DesignOptions& options)
        : problem_(problem), ranges_(ranges), target_(target), options_(options),
          tolerance_(problem.tolerance, cover_bits) {}

    [[nodiscard]] CoveredRange run() {
        ParameterBox all;
        for (const ParameterRange& r : ranges_) {
            all.lo.push_back(r.from);
            all.hi.push_back(r.to);
        }
        std::vector<ParameterBox> left{all};
        CoveredRange result;
        double done = 0;
        while (!left.empty()) {
            check_interruption();
            ParameterBox box = std::move(left.back());
            left.pop_back();
            ++result.boxes;
            if (decided(box)) {
                done += share_of(box);
                if (options_.progress) {
                    options_.progress(static_cast<std::size_t>(done * 1000), 1000);
                }
                continue;
            }
            if (result.boxes > options_.most_boxes ||
                box.depth > finest_box * static_cast<unsigned>(ranges_.size())) {
                result.where = text_of(box);
                for (std::size_t i = 0; i < box.lo.size(); ++i) {
                    result.middle.push_back(
                        Rational((box.lo[i] + box.hi[i]) / 2).convert_to<double>());
                }
                return result;
            }
            split(box, left);
        }
        result.covered = true;
        return result;
    }

private:
    [[nodiscard]] bool beyond(const Ball& f) const {
        return f.is_finite() && certainly_less(tolerance_, abs(f));
    }
    [[nodiscard]] bool decided(ParameterBox& box) const {
        std::vector<Ball> whole;
        std::vector<Ball> middles;
        std::vector<Ball> offsets;
        for (std::size_t i = 0; i < box.lo.size(); ++i) {
            const Rational m = (box.lo[i] + box.hi[i]) / 2;
            whole.push_back(Ball::hull(Ball(box.lo[i], cover_bits), Ball(box.hi[i], cover_bits)));
            middles.emplace_back(m, cover_bits);
            offsets.push_back(whole.back() - middles.back());
        }
        const auto over = problem_.over(whole);
        for (const auto& f : over) {
            const Ball limit = f->length() * Ball(problem_.part, cover_bits);
            if (limit.is_finite() && certainly_less(limit, Ball(target_, cover_bits))) {
                return true;
            }
        }
        const auto middle = problem_.over(middles);
        const auto decides = [&](const Rational& u) {
            const Ball place(u, cover_bits);
            for (std::size_t e = 0; e < over.size(); ++e) {
                if (beyond(over[e]->at(place))) {
                    return true;
                }
                // The mean value theorem.
                const Jet rates = over[e]->jet(place);
                Ball f = middle[e]->at(place);
                for (std::size_t i = 0; i < offsets.size(); ++i) {
                    f += rates.g[i + 1] * offsets[i];
                }
                if (beyond(f)) {
                    return true;
                }
            }
            return false;
        };
        if (std::any_of(box.places.begin(), box.places.end(), decides)) {
            return true;
        }
        const std::vector<Rational> kept = box.places;
        box.places = promising(middle);
        return std::any_of(box.places.begin(), box.places.end(), [&](const Rational& u) {
            return std::find(kept.begin(), kept.end(), u) == kept.end() && decides(u);
        });
    }
    /// Places up to the target at which the error in the middle of the box is farthest beyond the
    /// tolerance, extrema between samples included, and the target itself.
    [[nodiscard]] std::vector<Rational>
    promising(const std::vector<std::unique_ptr<ErrorOverBox>>& middle) const {
        std::vector<std::pair<double, Rational>> found;
        for (const auto& f : middle) {
            const auto excess = [&](const Rational& u) {
                const Ball e = abs(f->at(Ball(u, cover_bits))) - tolerance_;
                return e.is_finite() ? arf_get_d(arb_midref(e.data()), ARF_RND_NEAR) : -1.0;
            };
            std::vector<Rational> at;
            std::vector<double> e;
            // A knot by the edge may lift the error there only.
            for (unsigned k = places_by_the_edge; k > 0; --k) {
                at.emplace_back(target_ / (even_places * pow(Integer(2), k)));
            }
            for (long k = 1; k <= even_places; ++k) {
                at.emplace_back(target_ * k / even_places);
            }
            for (const Rational& u : at) {
                e.push_back(excess(u));
            }
            for (std::size_t k = 0; k < at.size(); ++k) {
                if (e[k] > 0) {
                    found.emplace_back(e[k], at[k]);
                }
                if (k > 0 && k + 1 < at.size() && e[k] >= e[k - 1] && e[k] >= e[k + 1]) {
                    const Rational top = extremum_near(*f, at[k]);
                    if (top > at[k - 1] && top < at[k + 1]) {
                        found.emplace_back(excess(top), top);
                    }
                }
            }
        }
        std::sort(found.begin(), found.end(),
                  [](const auto& x, const auto& y) { return x.first > y.first; });
        std::vector<Rational> places{target_};
        for (const auto& [excess, u] : found) {
            if (excess > 0 && places.size() < places_kept) {
                places.push_back(u);
            }
        }
        return places;
    }
    /// By Newton's method on f': proves nothing, and need not.
    [[nodiscard]] static Rational extremum_near(const ErrorOverBox& f, const Rational& start) {
        Rational u = start;
        for (int k = 0; k < 5 && u > 0; ++k) {
            const Jet at = f.jet(Ball(u, cover_bits));
            const Ball step = at.g[0] / at.h[Jet::second(0, 0)];
            if (!step.is_finite()) {
                break;
            }
            u = exact_value(Ball(Ball(u, 64) - step.with_bits(64)).with_bits(53).midpoint());
        }
        return u;
    }
    void split(const ParameterBox& box, std::vector<ParameterBox>& into) const {
        // The widest beside its range.
        std::size_t widest = 0;
        const auto width = [&](std::size_t i) {
            return Rational((box.hi[i] - box.lo[i]) / (ranges_[i].to - ranges_[i].from));
        };
        for (std::size_t i = 1; i < box.lo.size(); ++i) {
            widest = width(i) > width(widest) ? i : widest;
        }
        ParameterBox left = box;
        ParameterBox right = box;
        left.hi[widest] = right.lo[widest] = (box.lo[widest] + box.hi[widest]) / 2;
        ++left.depth;
        ++right.depth;
        into.push_back(std::move(right));
        into.push_back(std::move(left));
    }
    [[nodiscard]] double share_of(const ParameterBox& box) const {
        double share = 1;
        for (std::size_t i = 0; i < box.lo.size(); ++i) {
            share *= Rational((box.hi[i] - box.lo[i]) / (ranges_[i].to - ranges_[i].from))
                         .convert_to<double>();
        }
        return share;
    }
    [[nodiscard]] static std::string text_of(const ParameterBox& box) {
        std::ostringstream text;
        text.precision(12);
        for (std::size_t i = 0; i < box.lo.size(); ++i) {
            text << (i > 0 ? ", " : "") << box.lo[i].convert_to<double>() << " ... "
                 << box.hi[i].convert_to<double>();
        }
        return text.str();
    }

    const ReachProblem& problem_;
    const std::vector<ParameterRange>& ranges_;
    Rational target_;
    const DesignOptions& options_;
    Ball tolerance_;
};

} // namespace

CoveredRange covered_by_exits(const ReachProblem& problem,
                              const std::vector<ParameterRange>& ranges, const Rational& target,
                              const DesignOptions& options) {
    return Cover(problem, ranges, target, options).run();
}

} // namespace edgeproof::contact
