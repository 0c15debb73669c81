// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/scene/input/points.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::conformance {

/// Distances from an edge: a list, or a range with its line.
struct AskedPoints {
    std::vector<scene::AskedPoint> listed;
    std::optional<scene::PointRange> range = {};
    std::size_t range_line = 0;

    [[nodiscard]] std::size_t size() const { return range ? range->size() : listed.size(); }
    [[nodiscard]] scene::AskedPoint at(std::size_t i) const {
        return range ? scene::AskedPoint{range->at(i), range_line} : listed.at(i);
    }
};

/// The questions for one contact of a recipe, in the order of the rows; ids lack the part of the
/// contact. A question at a point is made on demand, so that memory does not grow with the points
/// of a range.
class AskedList {
public:
    AskedList() = default;
    explicit AskedList(AskedPoints points) : points_(std::move(points)) {}
    void add(const std::vector<Question>& questions);
    /// Appends the questions `at_each` for every point; their ids are the part after the point.
    void add_at_points(const std::string& before_point, const std::vector<Question>& at_each);

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Question at(std::size_t i) const;
    /// The question i without its point.
    [[nodiscard]] const Question& pattern(std::size_t i) const;
    /// Returns all questions, but for a range only those at the first point: enough to find
    /// duplicates and questions that cannot be asked.
    [[nodiscard]] std::vector<Question> telling() const;
    [[nodiscard]] const AskedPoints& points() const { return points_; }

private:
    struct Part {
        std::size_t first = 0;
        std::vector<Question> each;
        bool at_points = false;
        std::string before_point = {};
    };
    [[nodiscard]] const Part& part_of(std::size_t i) const;

    AskedPoints points_;
    std::vector<Part> parts_;
    std::size_t size_ = 0;
};

} // namespace edgeproof::conformance
