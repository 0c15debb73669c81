// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/input/quantity.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgeproof::scene {

/// The place lies outside the contact or on an edge, where p and q are 0.
class OutsideContact : public DomainError {
public:
    explicit OutsideContact(const char* where = "lies outside the contact")
        : DomainError(std::string("the point ") + where) {}
};

/// The place is on an edge or on a corner of the profile, or no number of bits tried distinguishes
/// it from that.
class IndistinctPlace : public DomainError {
public:
    IndistinctPlace(bool corner, const char* what) : DomainError(what), on_corner(corner) {}
    bool on_corner;
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

} // namespace edgeproof::scene
