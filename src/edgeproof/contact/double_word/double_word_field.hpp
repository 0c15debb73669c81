// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/double_word/double_word.hpp"

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

} // namespace edgeproof::contact
