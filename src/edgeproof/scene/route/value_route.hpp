// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/route/plan.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace edgeproof::scene {

/// The place lies outside the contact, where p and q are 0.
class OutsideContact : public DomainError {
public:
    OutsideContact() : DomainError("the point lies outside the contact") {}
};

/// The sum of the first n terms of an expansion at the distance u from its edge, by Horner's rule.
/// The first term is c_0 sqrt(u), or c_0/sqrt(u) if it is `singular`.
template <class T, class C>
[[nodiscard]] T sum_of_terms(const C& c, std::size_t n, const T& u, bool singular) {
    T total = c[n - 1];
    for (std::size_t k = n - 1; k-- > 0;) {
        total = total * u + c[k];
    }
    return singular ? T(total / sqrt(u)) : T(total * sqrt(u));
}

/// A power series in u whose coefficients are enclosed, with |c_k| <= most/radius^k for all k.
struct BoundedSeries {
    std::function<std::vector<Ball>(std::size_t)> coefficients; ///< the first n coefficients
    Ball most;
    Ball radius;
};

/// Returns the sum of c_k u^k over all k >= n, without a difference of nearly equal numbers: enough
/// terms for the bits of u, and a bound of the others. The result is not finite unless u is less
/// than a 16th of the radius.
[[nodiscard]] inline Ball omitted_terms(const BoundedSeries& series, std::size_t n, const Ball& u) {
    const long bits = u.bits();
    const Ball part = u / series.radius;
    const Ball limit(Rational(1, 16), bits);
    if (!series.most.is_finite() || !part.is_finite() || !certainly_less(abs(part), limit)) {
        Ball unknown(0, bits);
        arb_indeterminate(unknown.data());
        return unknown;
    }
    // Each term is at most a 16th of the term before.
    const std::size_t smallness = static_cast<std::size_t>(
        std::max<slong>(4, -arf_abs_bound_lt_2exp_si(arb_midref(part.data()))));
    const std::size_t count = n + static_cast<std::size_t>(bits) / smallness + 2;
    const std::vector<Ball> c = series.coefficients(count);
    Ball sum =
        Magnitude(series.most * pow_int(part, static_cast<long>(count)) / (1 - part)).ball(bits);
    for (std::size_t k = count; k-- > n;) {
        sum += c[k] * pow_int(u, static_cast<long>(k));
    }
    return sum;
}

/// One asked value with its result.
struct Row {
    AskedValue asked;
    /// The value; empty if it exists but no route found it.
    std::optional<BoundedValue> value = {};
    std::size_t point = 0; ///< for a value at a point: its index in Ask::u
    /// For the first exit of an extent and for a slip load: false if the error stays within the
    /// tolerance; the value is then the end of the part considered.
    bool reached = true;
    std::optional<contact::SlipState> state = {}; ///< for q, if there is friction
};

/// The rows of one place: of the contact, of an edge, or of a point. It refers to the rows of a
/// SceneResult, which must exist longer.
class RowsAt {
public:
    RowsAt() = default;
    explicit RowsAt(std::span<const Row> rows) : rows_(rows) {}

    [[nodiscard]] auto begin() const { return rows_.begin(); }
    [[nodiscard]] auto end() const { return rows_.end(); }
    [[nodiscard]] Edge edge() const { return rows_.front().asked.edge; }
    [[nodiscard]] std::size_t point() const { return rows_.front().point; }
    /// Null if there is no such row.
    [[nodiscard]] const Row* find(Quantity quantity, std::size_t k = 0, std::size_t j = 0) const;
    /// Throws Error if there is no such row.
    [[nodiscard]] const Row& row(Quantity quantity, std::size_t k = 0) const;
    /// Throws Error if there is no such row, or if its value was not found.
    [[nodiscard]] const BoundedValue& at(Quantity quantity, std::size_t k = 0) const;

private:
    std::span<const Row> rows_;
};

/// The rows of an extent. `asked`: the edge, the number of terms and the tolerance; `values`: the
/// first exit and the measure, each followed by the same as a fraction of a + b; `leaves`:
/// Row::reached of the first exit.
[[nodiscard]] std::vector<Row> extent_rows(const AskedValue& asked,
                                           const std::array<BoundedValue, 4>& values,
                                           const std::vector<BoundedValue>& crossings, bool leaves);
/// The rows of a slip zone by the first terms: its size, its error, and a slip load without a
/// value.
[[nodiscard]] std::vector<Row> slip_rows(const AskedValue& asked, BoundedValue size,
                                         BoundedValue error);

/// Computes the values of a scene, each with its error and the name of the route, and counts the
/// work. One object belongs to one thread.
class ValueRoute {
public:
    virtual ~ValueRoute() = default;

    /// One number, by the evaluators of its row (quantity.hpp); the plan must contain it. Throws
    /// DomainError if there is no value (outside the contact, on a corner); InputError, with the
    /// line of the friction, for a value of the slip if the contact slides or if the stick zone
    /// would extend beyond it.
    [[nodiscard]] virtual BoundedValue value(const AskedValue& asked) = 0;
    /// For a scene with friction.
    [[nodiscard]] virtual contact::SlipState state(Edge edge, const Distance& u) = 0;
    /// The rows of a search for a quantity with `searched`, with the edge and the number of terms
    /// of `asked`. Extents: the first exit, the measure, both as fractions of a + b, and all
    /// crossings, for the tolerance of the scene. Slip zones: the size by these terms, the error,
    /// and with a tolerance the load ratio up to which the error stays within it.
    [[nodiscard]] virtual std::vector<Row> search(const AskedValue& asked) = 0;
    /// True if |sigma_0 (a + b)/Q| < 8/pi: both edges slip in the direction of Q from the beginning
    /// of loading if Q and sigma_0 grow in proportion.
    [[nodiscard]] virtual bool in_proportion() = 0;

    /// The row of a quantity with `searched`. The search at each place is made once.
    [[nodiscard]] const Row& searched(const AskedValue& asked);

private:
    std::map<std::tuple<QuantityGroup, Edge, std::size_t>, std::vector<Row>> searched_;
};

/// Makes the route of a plan, in balls with proved values (BallContact, IntegratedContact,
/// shear.hpp): more and more bits until each value rounds correctly. p is an estimate by
/// Plan::witness where the scene asks for that. Keeps references to all three arguments. Throws
/// InputError, with its line, if no contact carries the load, and if g' is not proved to rise in
/// the contact; BudgetError where no number of bits tried encloses a value.
[[nodiscard]] std::unique_ptr<ValueRoute> make_route(const Scene& scene, const Plan& plan,
                                                     Work& work);

} // namespace edgeproof::scene
