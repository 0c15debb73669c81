// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/asked_list.hpp"

#include <algorithm>
#include <iterator>

namespace edgeproof::conformance {

void AskedList::add(const std::vector<Question>& questions) {
    if (!questions.empty()) {
        parts_.push_back({size_, questions});
        size_ += questions.size();
    }
}

void AskedList::add_at_points(const std::string& before_point,
                              const std::vector<Question>& at_each) {
    if (points_.size() > 0 && !at_each.empty()) {
        parts_.push_back({size_, at_each, true, before_point});
        size_ += points_.size() * at_each.size();
    }
}

const AskedList::Part& AskedList::part_of(std::size_t i) const {
    return *std::prev(std::upper_bound(parts_.begin(), parts_.end(), i,
                                       [](std::size_t n, const Part& p) { return n < p.first; }));
}

const Question& AskedList::pattern(std::size_t i) const {
    const Part& part = part_of(i);
    return part.each[(i - part.first) % part.each.size()];
}

Question AskedList::at(std::size_t i) const {
    const Part& part = part_of(i);
    Question q = part.each[(i - part.first) % part.each.size()];
    if (part.at_points) {
        scene::AskedPoint point = points_.at((i - part.first) / part.each.size());
        q.id = part.before_point + point.u.text() + q.id;
        q.u = std::move(point.u);
        q.line = point.line;
    }
    return q;
}

std::vector<Question> AskedList::telling() const {
    std::vector<Question> questions;
    for (const Part& part : parts_) {
        const bool first_only = part.at_points && points_.range;
        const std::size_t n =
            part.each.size() * (part.at_points && !first_only ? points_.size() : 1);
        for (std::size_t k = 0; k < n; ++k) {
            questions.push_back(at(part.first + k));
        }
    }
    return questions;
}

} // namespace edgeproof::conformance
