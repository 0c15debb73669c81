// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/input/quantity.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace edgeproof::scene {

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

/// The rows of an extent: the first exit and the measure, both also as fractions of a + b, and the
/// crossings. `asked`: the extent; `leaves`: Row::reached of the first exit.
[[nodiscard]] std::vector<Row> extent_rows(const AskedValue& asked, BoundedValue first_exit,
                                           BoundedValue exit_fraction, BoundedValue measure,
                                           BoundedValue measure_fraction,
                                           std::vector<BoundedValue> crossings, bool leaves);

/// The rows of one place: of the contact, of an edge, or of a point. It refers to the rows of a
/// SceneResult, which must exist longer.
class RowsAt {
public:
    RowsAt() = default;
    explicit RowsAt(std::span<const Row> rows) : rows_(rows) {}

    [[nodiscard]] auto begin() const { return rows_.begin(); }
    [[nodiscard]] auto end() const { return rows_.end(); }
    [[nodiscard]] contact::Edge edge() const { return rows_.front().asked.edge; }
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
