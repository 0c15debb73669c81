// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/batch/double_word_pressure.hpp"

#include "edgeproof/contact/law/logarithmic_pressure.hpp"
#include "edgeproof/precision/double_word/double_word_ball.hpp"

#include <cfenv>
#include <cfloat>
#include <cmath>

namespace edgeproof::contact {

template <> struct Field<DoubleWord> {
    static bool vanishes(const DoubleWord& x) { return x.high == 0 && x.radius == 0; }
    static DoubleWord times(const DoubleWord& weight, const DoubleWord& x) { return weight * x; }
    static void add_product(DoubleWord& sum, const DoubleWord& x, const DoubleWord& y) {
        sum = sum + x * y;
    }
    static DoubleWord twice(const DoubleWord& x) { return scaled(x, 2); }
    static DoubleWord smaller(const DoubleWord& x, const DoubleWord& y) {
        const bool first = x.high < y.high || (x.high == y.high && x.low < y.low);
        const DoubleWord& least = first ? x : y;
        return {least.high, least.low, std::fmax(x.radius, y.radius)};
    }
};

namespace {

// With extra precision in between, sums are not what the bounds are of.
constexpr bool binary64_throughout = FLT_EVAL_METHOD == 0;

constexpr double smallest = 0x1p-100;
constexpr double smallest_u = 0x1p-300;
constexpr double smallest_excess = 0x1p-520;
/// Radii are corrected for that many operations in a row.
constexpr std::size_t most_knots = 10'000;

} // namespace

/// The formula, compiled for processors with and without a fused multiply-add.
struct DoubleWordKernel {
    struct Green {
        DoubleWord value;
        DoubleWord moment;
    };

    static DoubleWord pressure(const DoubleWordPressure& c, Edge edge, double u) {
        const DoubleWord near{u, 0, 0};
        const DoubleWord far = c.length_ - near;
        const DoubleWord& right = edge == Edge::right ? near : far;
        const DoubleWord& left = edge == Edge::right ? far : near;
        if (!(far.high > 0)) {
            return double_word::unknown();
        }
        const DoubleWord w_x = sqrt(right * left);
        const LogarithmTable& table = *c.table_;
        return logarithmic_sum(
                   Slope{c.knots_}, c.knots_.size(), c.arc_ * w_x, [](std::size_t) { return true; },
                   [&](std::size_t i) {
                       const auto& knot = c.knots_[i];
                       const DoubleWord offset =
                           edge == Edge::right ? near - knot.inset : knot.outset - near;
                       if (!double_word::well_known(offset)) {
                           return Green{double_word::unknown(), double_word::unknown()};
                       }
                       const DoubleWord excess =
                           green_excess(knot.mark, right, left, w_x, offset.high > 0 ? 1 : -1);
                       const DoubleWord y = excess / (c.length_ * abs(offset));
                       if (!double_word::well_known(y) || !(y.high > smallest_excess)) {
                           return Green{double_word::unknown(), double_word::unknown()};
                       }
                       const DoubleWord G = log1p(y, table);
                       return Green{G, offset * G};
                   }) *
               c.factor_;
    }

    /// What logarithmic_sum asks of a slope.
    struct Slope {
        const std::vector<DoubleWordPressure::Knot>& knots;
        [[nodiscard]] bool has_corner(std::size_t i) const { return knots[i].corner; }
        [[nodiscard]] const DoubleWord& jump(std::size_t i) const { return knots[i].jump; }
        [[nodiscard]] const DoubleWord& rate_drop(std::size_t i) const { return knots[i].drop; }
    };
};

namespace {

DoubleWord pressure_portable(const DoubleWordPressure& c, Edge edge, double u) {
    return DoubleWordKernel::pressure(c, edge, u);
}

#if defined(__x86_64__) && defined(__GNUC__)
[[gnu::target("fma"), gnu::flatten]] DoubleWord pressure_fma(const DoubleWordPressure& c, Edge edge,
                                                             double u) {
    return DoubleWordKernel::pressure(c, edge, u);
}
auto chosen_kernel() {
    return __builtin_cpu_supports("fma") != 0 ? pressure_fma : pressure_portable;
}
#else
auto chosen_kernel() { return pressure_portable; }
#endif

} // namespace

DoubleWordPressure::DoubleWordPressure(const BallContact& contact)
    : kernel_(chosen_kernel()), table_(&LogarithmTable::get()) {
    const auto word = [&](const Ball& x) {
        const DoubleWord w = to_double_word(x);
        const double size = std::fabs(w.high);
        in_range_ = in_range_ && w.radius <= size &&
                    (w.high == 0 || (size > smallest && size < 1 / smallest));
        return w;
    };
    length_ = word(contact.a() + contact.b());
    arc_ = word(contact.arc());
    factor_ = word(contact.pressure_factor());
    const LinearSlope<Ball>& slope = contact.slope();
    for (std::size_t i = 0; i < slope.knots.size() && i < most_knots; ++i) {
        if (!contact.bends_inside(i)) {
            continue;
        }
        const Mark<Ball>& mark = contact.knot_marks()[i];
        Knot knot{word(contact.a() - slope.knots[i]),
                  word(contact.b() + slope.knots[i]),
                  {word(mark.right), word(mark.left), {}, word(mark.w), {}},
                  slope.has_corner(i),
                  {},
                  word(slope.rate_drop(i))};
        if (knot.corner) {
            knot.jump = word(slope.jump(i));
        }
        knots_.push_back(knot);
    }
    in_range_ = in_range_ && slope.knots.size() <= most_knots;
}

std::optional<double> DoubleWordPressure::nearest(Edge edge, double u) const {
    if (!binary64_throughout || !in_range_ || !(u > smallest_u && u < 1 / smallest) ||
        std::fegetround() != FE_TONEAREST) {
        return {};
    }
    return nearest_binary64(kernel_(*this, edge, u));
}

} // namespace edgeproof::contact
