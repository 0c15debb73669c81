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

/// Distances from an edge: listed, or a range of them with the line that gives it.
struct AskedPoints {
    std::vector<scene::AskedPoint> listed;
    std::optional<scene::PointRange> range = {};
    std::size_t range_line = 0;

    [[nodiscard]] std::size_t size() const { return range ? range->size() : listed.size(); }
    [[nodiscard]] scene::AskedPoint at(std::size_t i) const {
        return range ? scene::AskedPoint{range->at(i), range_line} : listed.at(i);
    }
};

/// What one contact of a recipe is asked, in the order of the rows; ids are without the contact's
/// part. A question at a point is made when it is asked for: what is kept does not grow with the
/// points of a range.
class AskedList {
public:
    AskedList() = default;
    explicit AskedList(AskedPoints points) : points_(std::move(points)) {}
    /// Each in turn behind those that there are.
    void add(const std::vector<Question>& questions);
    /// At every point: `at_each`, whose ids are what follows the point's.
    void add_at_points(const std::string& before_point, const std::vector<Question>& at_each);

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Question at(std::size_t i) const;
    /// The same without a point.
    [[nodiscard]] const Question& pattern(std::size_t i) const;
    /// All, but of a range, whose points differ as they ascend, those at the first: what has to be
    /// looked at to find what is asked twice, or cannot be asked.
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
