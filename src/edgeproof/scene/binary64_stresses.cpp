// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/binary64_values.hpp"

#include "edgeproof/contact/stress/binary64_stress.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

namespace edgeproof::scene {
namespace {

using contact::Binary64Stress;

constexpr double most_error = 1e-12; ///< of the mean pressure
constexpr std::size_t points_of_a_piece = 4096;

class Stresses {
public:
    Stresses(const Scene& scene, Body body, std::span<const double> x, std::span<const double> z,
             const Binary64Stresses& out)
        : asked_(asking(scene, {AskedValue{Quantity::sxx}}, {20, Rounding::nearest, true})),
          body_(body), x_(x), z_(z), out_(out) {
        asked_.ask.in_bodies.clear();
        (void)make_plan(asked_); // refuses stresses that are not computed
        if (has_mises()) {
            const Ball nu = ball_of(*scene.poisson(body), Binary64Stress::field_bits);
            poisson_ = {(1 - nu * 2).midpoint().convert_to<double>(), 0x1p-52};
        }
        try {
            BallLevel level(asked_, Binary64Stress::field_bits);
            mean_pressure_ = Ball(level.force() / level.length()).midpoint().convert_to<double>();
            // of a body of revolution the closed form is that of a plane contact
            const BallContact* const closed =
                asked_.round ? nullptr : level.contact().closed_form();
            const auto field =
                closed != nullptr && closed->piecewise_linear() && has_binary64_balls()
                    ? level.stress_field(body)
                    : std::nullopt;
            if (field) {
                fast_.emplace(*field, full_stick_load(scene, body, Binary64Stress::field_bits));
            }
        } catch (const BudgetError&) { // run_scene has more bits
        } catch (const DomainError&) { // run_scene refuses it
        }
    }

    void piece(std::size_t from, std::size_t to) {
        check_interruption();
        std::vector<std::size_t> left;
        for (std::size_t i = from; i < to; ++i) {
            if (!std::isfinite(x_[i]) || !std::isfinite(z_[i])) {
                throw DomainError("a place is not a finite number");
            }
            if (z_[i] < 0) {
                throw InputError("z = " + exact_text(exact_rational(z_[i])) + " is negative",
                                 "give z >= 0, the depth into the body");
            }
            if (!at_once(i)) {
                left.push_back(i);
            }
        }
        if (!left.empty()) {
            by_scene(left);
        }
    }

private:
    [[nodiscard]] bool has_mises() const { return !out_.of.back().empty(); }
    [[nodiscard]] bool at_once(std::size_t i) const {
        if (!fast_) {
            return false;
        }
        const contact::Binary64StressState s = fast_->at(x_[i], z_[i]);
        const Binary64Ball tau = hypot(s.half_difference, s.sxz);
        const Binary64Ball root{1.7320508075688773, 0x1p-52};
        const Binary64Ball mises =
            hypot(root * tau, poisson_ * (s.sxx + s.szz) * Binary64Ball{0.5, 0});
        const Binary64Ball values[] = {s.sxx, s.szz, s.sxz, tau, mises};
        double bound = 0;
        double sum = 0; // not finite if one of the radii is not
        for (std::size_t k = 0; k < std::size(values) - (has_mises() ? 0 : 1); ++k) {
            out_.of[k][i] = values[k].middle;
            bound = std::max(bound, values[k].radius);
            sum += values[k].radius;
        }
        out_.bound[i] = bound;
        return std::isfinite(sum) && bound <= most_error * mean_pressure_;
    }
    void by_scene(const std::vector<std::size_t>& indices) const {
        Scene scene = asked_;
        for (const std::size_t i : indices) {
            scene.ask.in_bodies.push_back(
                {Exact::of(exact_rational(x_[i])), Exact::of(exact_rational(z_[i])), body_});
        }
        const SceneResult result = run_scene(scene);
        for (const RowsAt& at : result.at_places(QuantityRow::Place::body)) {
            const std::size_t i = indices[at.point()];
            double bound = 0;
            for (std::size_t k = 0; k < out_.of.size() && !out_.of[k].empty(); ++k) {
                const Ball& x = at.at(binary64_stresses[k]).value;
                const double nearest = x.midpoint().convert_to<double>();
                const Ball error = abs(Ball(x - Ball(exact_rational(nearest), x.bits())));
                bound =
                    std::max(bound, std::nextafter(error.upper().convert_to<double>(), HUGE_VAL));
                out_.of[k][i] = nearest;
            }
            out_.bound[i] = bound;
        }
    }

    Scene asked_;
    Body body_;
    std::span<const double> x_;
    std::span<const double> z_;
    Binary64Stresses out_;
    Binary64Ball poisson_; ///< 1 - 2 nu
    double mean_pressure_ = 0;
    std::optional<Binary64Stress> fast_;
};

} // namespace

void compute_binary64(const Scene& scene, Body body, std::span<const double> x,
                      std::span<const double> z, const Binary64Stresses& stresses,
                      unsigned threads) {
    Stresses all(scene, body, x, z, stresses);
    const std::size_t pieces = (x.size() + points_of_a_piece - 1) / points_of_a_piece;
    parallel::parallel_for(pieces, threads, [&](std::size_t k) {
        all.piece(k * points_of_a_piece, std::min(x.size(), (k + 1) * points_of_a_piece));
    });
}

} // namespace edgeproof::scene
