// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/coverage.hpp"

#include "edgeproof/scene/input/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgeproof::comparison {
namespace {

constexpr double most_off = 0.1;    ///< error of the rules for the exact pressure
constexpr double widest_gap = 0.25; ///< between neighbours inside, relative to a + b

class Coverage {
public:
    Coverage(const AlignedResult& data, const DataContact& of_exact, const ExactContact& exact)
        : data_(data), of_exact_(of_exact), exact_(exact) {}

    [[nodiscard]] std::vector<Undetermined> find() {
        for (const contact::Edge at : {contact::Edge::right, contact::Edge::left}) {
            if (!data_.half || *data_.half == at) {
                edge(at);
            }
        }
        force();
        largest();
        return std::move(list_);
    }

private:
    void add(Determined quantity, std::string why) { list_.push_back({quantity, std::move(why)}); }

    void edge(contact::Edge at) {
        const bool right = at == contact::Edge::right;
        const Determined quantity = right ? Determined::a : Determined::b;
        const char* const name = right ? "a" : "b";
        const double value = right ? exact_.a().value : exact_.b().value;
        const auto& found = right ? of_exact_.a : of_exact_.b;
        if (!of_exact_.reaches[index_of(at)]) {
            add(quantity,
                fmt::format("{} is not determined: the data end at x = {:.6g}, inside the "
                            "contact, before its {} edge",
                            name, right ? data_.nodes.back().x : data_.nodes.front().x,
                            scene::edge_name(at)));
        } else if (!found || !(std::abs(*found - value) <= most_off * exact_.length())) {
            add(quantity,
                fmt::format("{} is not determined: the exact pressure at these nodes gives {:.6g}, "
                            "but the exact value is {:.6g}",
                            name, found.value_or(0), value));
        }
    }

    /// The force by trapezoids of the exact pressure, without corners.
    [[nodiscard]] double exact_force_at_nodes() const {
        double force = 0;
        const Node* last = nullptr;
        for (const Node& node : data_.nodes) {
            if (node.exact.p) {
                force += last == nullptr
                             ? 0
                             : 0.5 * (node.x - last->x) * (*last->exact.p + *node.exact.p);
                last = &node;
            }
        }
        return data_.half ? 2 * force : force;
    }
    /// The widest interval between neighbours, limited to the contact.
    [[nodiscard]] double gap() const {
        double widest = 0;
        for (std::size_t i = 1; i < data_.nodes.size(); ++i) {
            const double from = std::max(data_.nodes[i - 1].x, -exact_.b().value);
            const double to = std::min(data_.nodes[i].x, exact_.a().value);
            widest = std::max(widest, to - from);
        }
        return widest;
    }
    /// The distance of the beginning of the half from the middle, if that is more than an element.
    [[nodiscard]] std::optional<double> missing_middle() const {
        if (!data_.half) {
            return {};
        }
        const auto& nodes = data_.nodes;
        const bool right = *data_.half == contact::Edge::right;
        const double first = right ? nodes.front().x : -nodes.back().x;
        const double element =
            right ? nodes[1].x - nodes[0].x : nodes.back().x - nodes[nodes.size() - 2].x;
        return std::abs(first) <= element * (1 + 1e-9) ? std::nullopt : std::optional(first);
    }
    void force() {
        const double value = exact_.force().value;
        const double found = exact_force_at_nodes();
        const double widest = gap();
        if (const auto from = missing_middle()) {
            add(Determined::force,
                fmt::format("P is not determined: the half of the contact begins "
                            "{:.6g} from its middle",
                            *from));
        } else if (!(widest <= widest_gap * exact_.length())) {
            add(Determined::force,
                fmt::format("P is not determined: {:.6g} of the contact's {:.6g} lie between two "
                            "neighbouring nodes",
                            widest, exact_.length()));
        } else if (!(std::abs(found / value - 1) <= most_off)) {
            add(Determined::force,
                fmt::format("P is not determined: the exact pressure at these nodes gives {:.6g}, "
                            "but the exact value is {:.6g}",
                            found, value));
        }
    }
    void largest() {
        double most = 0;
        for (const Node& node : data_.nodes) {
            most = std::max(most, node.exact.p.value_or(0));
        }
        if (!exact_.scale().mean && !(most >= (1 - most_off) * exact_.scale().value)) {
            add(Determined::largest,
                fmt::format("the largest p is not determined: it is {:.6g} at x = {:.6g}, and the "
                            "exact pressure at these nodes reaches {:.6g}",
                            exact_.scale().value, exact_.scale().x, most));
        }
    }

    const AlignedResult& data_;
    const DataContact& of_exact_;
    const ExactContact& exact_;
    std::vector<Undetermined> list_;
};

} // namespace

std::vector<Undetermined> undetermined(const AlignedResult& data, const DataContact& of_exact,
                                       const ExactContact& exact) {
    return Coverage(data, of_exact, exact).find();
}

} // namespace edgeproof::comparison
