// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/double_word/double_word.hpp"
#include "edgeproof/precision/double_word/function_tables.hpp"

#include <cfenv>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

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

/// v - x for a point v given by its distances from the edges.
struct DoubleWordMark {
    PreciseWord inset;  ///< a - v
    PreciseWord outset; ///< v + b
    /// Returns v - x for the place at the distance `u` from an edge.
    [[nodiscard]] DoubleWord offset(Edge edge, const DoubleWord& u) const {
        return edge == Edge::right ? u - inset : outset - u;
    }
};

/// A place given by its distances from both edges.
struct DoubleWordPlace {
    DoubleWord right;
    DoubleWord left;

    /// The place at the distance `u` from an edge; `length` is a + b.
    DoubleWordPlace(const PreciseWord& length, Edge edge, const DoubleWord& u)
        : right(edge == Edge::right ? u : length - u), left(edge == Edge::right ? length - u : u) {}
    /// True if the place is inside the contact.
    [[nodiscard]] bool inside() const { return right.high > 0 && left.high > 0; }
};

/// True if double words can represent `u` with their bounds, and the thread rounds to nearest.
[[nodiscard]] inline bool in_double_words(const DoubleWord& u) {
    // With extended precision of intermediate results the bounds would not hold for the sums.
    return FLT_EVAL_METHOD == 0 && u.high > 0x1p-300 && u.high < 0x1p100 &&
           std::fegetround() == FE_TONEAREST;
}
/// True if no product with this number of the contact overflows or underflows. `most`: 2^100, or
/// 2^200 for factors of the result (docs/double-words.md, "Nothing underflows").
[[nodiscard]] inline bool in_double_words_as_constant(const DoubleWord& w, double most = 0x1p100) {
    const double size = std::fabs(w.high);
    return w.radius <= size && (w.high == 0 || (size > 1 / most && size < most));
}
[[nodiscard]] inline bool in_double_words_as_factor(const DoubleWord& w) {
    return in_double_words_as_constant(w, 0x1p200);
}

/// Form::formula, compiled for processors with and without fused multiply-add.
template <class Form> struct DoubleWordKernel {
    using Function = DoubleWord (*)(const Form&, Edge, const DoubleWord&);

    static DoubleWord portable(const Form& form, Edge edge, const DoubleWord& u) {
        return form.formula(edge, u);
    }
#if defined(__x86_64__) && defined(__GNUC__)
    [[gnu::target("fma"), gnu::flatten]] static DoubleWord fused(const Form& form, Edge edge,
                                                                 const DoubleWord& u) {
        return form.formula(edge, u);
    }
    static Function chosen() { return __builtin_cpu_supports("fma") != 0 ? fused : portable; }
#else
    static Function chosen() { return portable; }
#endif
};

/// p of a piecewise linear slope by the formula of law/linear_measure.hpp (docs/pressure.md,
/// "Closed form: piecewise linear slopes").
struct DoubleWordSlope {
    struct Knot {
        DoubleWordMark at;
        Mark<DoubleWord> mark;
        bool corner;
        DoubleWord jump; ///< of g'
        DoubleWord drop; ///< of g''
    };
    std::vector<Knot> knots; ///< those inside the contact where g' jumps or bends
    DoubleWord arc;
    DoubleWord width; ///< a + b
    DoubleWord factor;
    const LogarithmTable* table;

    /// (v - x) G where v - x is nearly 0: G <= ln(1 + 4 D/|v - x|), and r ln(1 + 4 D/r) increases
    /// with r, D < 2^100 (docs/double-words.md, lemma 6).
    static DoubleWord moment_near_knot(const DoubleWord& offset) {
        const double r = std::fabs(offset.high) + std::fabs(offset.low) + offset.radius;
        return {0, 0, 400 * std::fmax(r, 0x1p-400)};
    }

    struct Green {
        DoubleWord value;  ///< G
        DoubleWord moment; ///< (v - x) G
    };
    static constexpr double smallest_excess = 0x1p-520;

    /// The members that logarithmic_sum requires of a slope.
    [[nodiscard]] bool has_corner(std::size_t i) const { return knots[i].corner; }
    [[nodiscard]] const DoubleWord& jump(std::size_t i) const { return knots[i].jump; }
    [[nodiscard]] const DoubleWord& rate_drop(std::size_t i) const { return knots[i].drop; }

    /// Returns ln(1 + y).
    [[nodiscard]] DoubleWord logarithm(const DoubleWord& y) const {
        if (!double_word::well_known(y) || !(y.high > smallest_excess)) [[unlikely]] {
            return double_word::about_zero(y); // ln(1 + y) <= y
        }
        return log1p(y, *table);
    }
    /// Returns G(x, v) of a knot. `offset`: v - x, not zero within its radius.
    [[nodiscard]] Green green(const Knot& knot, const DoubleWord& offset, const DoubleWordPlace& x,
                              const DoubleWord& w_x) const {
        const DoubleWord excess =
            green_excess(knot.mark, x.right, x.left, w_x, offset.high > 0 ? 1 : -1);
        const DoubleWord G = logarithm(excess / (width * abs(offset)));
        return {G, offset * G};
    }

    /// Returns p (stress) at a place of the contact; infinite exactly on a corner.
    /// @param x distances from the edges of the contact (length)
    /// @param edge,u edge from which the distances of the knots are measured, and the distance
    /// from it
    [[nodiscard]] DoubleWord pressure(const DoubleWordPlace& x, Edge edge,
                                      const DoubleWord& u) const {
        if (!x.inside()) {
            return double_word::unknown();
        }
        const DoubleWord w_x = sqrt(x.right * x.left);
        bool on_corner = false;
        const DoubleWord sum = logarithmic_sum(
            *this, knots.size(), arc * w_x, [](std::size_t) { return true; },
            [&](std::size_t i) {
                const Knot& knot = knots[i];
                const DoubleWord offset = knot.at.offset(edge, u);
                if (!double_word::well_known(offset)) {
                    on_corner =
                        on_corner || (knot.corner && offset.high == 0 && offset.radius == 0);
                    return Green{double_word::unknown(), moment_near_knot(offset)};
                }
                return green(knot, offset, x, w_x);
            });
        if (on_corner) {
            return {std::numeric_limits<double>::infinity(), 0, 0};
        }
        return sum * factor;
    }
};

/// p of a power law whose exponent m is a multiple of 1/2, m <= 64: P'(a)/pi times I_m(|x|/a)
/// (docs/pressure.md, "Closed form: power laws"). The recurrence m I_m = sqrt(y) + (m - 1) q^2
/// I_(m-2) is applied upwards, where all terms are positive. It begins with I_0, a logarithm, with
/// I_1 = sqrt(y), or with I_(1/2) or I_(3/2), which are power series about the edge, or about the
/// apex with a power of q.
class DoubleWordPowerLaw {
public:
    /// True if there is such a formula for the exponent `m`.
    [[nodiscard]] static bool has(const Exact& m);
    /// The contact of such a law in balls; `m`: its exponent.
    DoubleWordPowerLaw(const Exact& m, const BallContact& contact);

    /// Returns p (stress) at a place of the contact.
    /// @param x distances from the edges of the contact (length)
    /// @param edge,u edge from which the distance of the apex is measured, and the distance from it
    [[nodiscard]] DoubleWord pressure(const DoubleWordPlace& x, Edge edge,
                                      const DoubleWord& u) const {
        if (!x.inside()) {
            return double_word::unknown();
        }
        // y = 1 - q^2 = u (D - u)/a^2 (docs/pressure.md, "Closed form: power laws")
        const DoubleWord y = x.right * x.left * inverse_ * inverse_;
        const DoubleWord root = sqrt(y);
        const DoubleWord q = abs(apex_.offset(edge, u)) * inverse_;
        const DoubleWord square = q * q;
        DoubleWord I = lowest(y, root, q, square);
        for (const Step& step : steps_) {
            I = step.inverse * root + step.ratio * square * I;
        }
        return I * factor_;
    }

    [[nodiscard]] const DoubleWord& factor() const { return factor_; }
    /// All other numbers of the contact.
    [[nodiscard]] std::vector<DoubleWord> constants() const {
        return {apex_.inset.first, apex_.outset.first, inverse_};
    }

private:
    /// n, the exponent at which the recurrence begins.
    enum class Lowest : std::uint8_t { zero, half, one, three_halves };
    struct Step {
        DoubleWord inverse; ///< 1/m
        DoubleWord ratio;   ///< (m - 1)/m
    };
    struct Series {
        explicit Series(const Rational& n);
        PiecewiseSeries edge; ///< I_n/sqrt(y) in y
        PiecewiseSeries apex; ///< I_n without the power of q, in q^2
        DoubleWord power;     ///< factor of the power of q
        static const Series& of(Lowest n);
    };

    /// Returns I_n (docs/pressure.md, "Closed form: power laws").
    [[nodiscard]] DoubleWord lowest(const DoubleWord& y, const DoubleWord& root,
                                    const DoubleWord& q, const DoubleWord& square) const {
        constexpr double farthest = 0x1p500; // largest argument of the logarithm
        if (n_ == Lowest::one) {
            return root;
        }
        const bool at_apex = q.high == 0 && q.radius == 0;
        if (n_ == Lowest::zero && at_apex) {
            return {}; // the next step takes q^2 I_0, which is 0
        }
        if (n_ == Lowest::zero) {
            // I_0 = arcosh(1/q) = ln((1 + sqrt(y))/q)
            const DoubleWord excess = (root + y / (q + DoubleWord{1, 0, 0})) / q;
            return double_word::well_known(excess) && excess.high < farthest &&
                           excess.high > 1 / farthest
                       ? log1p(excess, *table_)
                       : double_word::about_zero(excess); // ln(1 + y) <= y
        }
        if (y.high <= 0.5) {
            return root * series_->edge(y);
        }
        if (at_apex) {
            return series_->apex(square);
        }
        const DoubleWord half_power = sqrt(q);
        return series_->apex(square) +
               series_->power * (n_ == Lowest::half ? half_power : q * half_power);
    }

    DoubleWordMark apex_;
    DoubleWord inverse_; ///< 1/a
    DoubleWord factor_;
    Lowest n_ = Lowest::one;
    std::vector<Step> steps_;
    const Series* series_ = nullptr;
    const LogarithmTable* table_ = &LogarithmTable::get();
};

/// p in closed form, correctly rounded to binary64: the formulas of a piecewise linear slope and of
/// power laws with integer and half-integer exponents in double words, which carry bounds
/// (docs/double-words.md). Balls decide the rest.
///
/// The object is immutable: many threads may use it.
class DoubleWordPressure {
public:
    /// The precision that a contact should have, so that places near knots keep their accuracy.
    static constexpr long contact_bits = 192;

    /// For a contact with such a slope. If a number of the contact is not 0 and its size is not
    /// between 2^-100 and 2^100, then every place is undecided.
    /// @param profile g'(x)
    /// @param contact the contact in balls
    DoubleWordPressure(const Profile& profile, const BallContact& contact);

    /// True if there is a formula in double words.
    [[nodiscard]] static bool has_form(const Profile& profile);

    /// Returns p (stress) at the distance `u` from an edge (length), for every u within its radius.
    /// Unknown (a radius that is not finite) for u outside the contact, for u that its radius does
    /// not separate from a corner, for u below 2^-300 or not finite, and in a thread that does not
    /// round to nearest. Infinite, without a radius, exactly on a corner.
    [[nodiscard]] DoubleWord at(Edge edge, const DoubleWord& u) const {
        return in_range_ && in_double_words(u) ? kernel_(*this, edge, u) : double_word::unknown();
    }
    /// Returns the binary64 nearest to p (ties to even) at exactly the distance `u`: proved.
    /// Nothing where that is undecided.
    [[nodiscard]] std::optional<double> nearest(Edge edge, double u) const {
        return nearest_binary64(at(edge, {u, 0, 0}));
    }

    /// `at` without its checks.
    [[nodiscard]] DoubleWord formula(Edge edge, const DoubleWord& u) const {
        const DoubleWordPlace x(length_, edge, u);
        const auto* slope = std::get_if<DoubleWordSlope>(&form_);
        return slope != nullptr ? slope->pressure(x, edge, u)
                                : std::get_if<DoubleWordPowerLaw>(&form_)->pressure(x, edge, u);
    }

private:
    PreciseWord length_;
    std::variant<DoubleWordSlope, DoubleWordPowerLaw> form_;
    bool in_range_ = true;
    DoubleWordKernel<DoubleWordPressure>::Function kernel_;
};

} // namespace edgeproof::contact
