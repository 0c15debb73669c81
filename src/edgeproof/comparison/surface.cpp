// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace edgeproof::comparison {
namespace {

constexpr unsigned surface_digits = 12;

/// The exact values of one quantity along the surface of a scene.
class SurfaceValues {
public:
    SurfaceValues(const scene::Scene& scene, scene::Quantity quantity, scene::Body body)
        : scene_(scene), quantity_(quantity), body_(body) {}

    /// Nothing where the scene has no value: on an edge, or for a profile without a closed form.
    std::optional<double> operator()(double x) {
        check_interruption();
        scene::AskedValue asked;
        asked.quantity = quantity_;
        const formula::Exact place(formula::Expr::number(exact_rational(x)));
        if (quantity_ == scene::Quantity::sxx) {
            asked.in_body = scene::BodyPoint{place, formula::Exact(), body_};
        } else {
            asked.place =
                scene::Place::parse(exact_text(exact_rational(x)), scene::Place::From::origin, {})
                    .distance(contact::Edge::right);
        }
        try {
            if (!values_) {
                values_ = std::make_unique<scene::SceneValues>(
                    scene_, std::vector{asked},
                    scene::Digits{surface_digits, Rounding::nearest, false});
            }
            const scene::BoundedValue value = values_->value(asked);
            route_ = value.how();
            return value.value.midpoint().convert_to<double>();
        } catch (const Error& error) {
            why_ = error.what();
            return {};
        }
    }
    [[nodiscard]] const std::string& route() const { return route_; }
    [[nodiscard]] const std::string& why() const { return why_; }

private:
    const scene::Scene& scene_;
    scene::Quantity quantity_;
    scene::Body body_;
    std::unique_ptr<scene::SceneValues> values_;
    std::string route_;
    std::string why_;
};

class SurfaceComparison {
public:
    SurfaceComparison(FileComparison& file, const scene::Scene& scene, const ExactContact& exact,
                      const EdgeZone& zone)
        : file_(file), scene_(scene), exact_(exact), zone_(zone) {}

    void gap() {
        constexpr std::size_t fewest = 3; // nodes outside the contact: the gap near it is small
        std::size_t outside = 0;
        for (std::size_t i = 0; i < file_.data.nodes.size(); ++i) {
            const bool given = file_.table.rows[i].surface[0].has_value();
            outside += given && !file_.data.nodes[i].exact.inside() ? 1 : 0;
        }
        if (has(0) && outside < fewest) {
            note(
                fmt::format("the gap is not compared: {} of the nodes that have one {} outside the "
                            "contact",
                            outside, outside == 1 ? "lies" : "lie"));
            return;
        }
        compare(
            0, "gap", scene::Quantity::gap, scene::Body::A, {1}, [](const Node&) { return true; },
            "of the largest exact gap at these nodes");
    }
    void slip() {
        if (std::ranges::none_of(file_.table.rows, [](const ResultRow& row) {
                return row.surface[1].value_or(0) != 0;
            })) {
            return;
        }
        if (!scene_.shear || !scene_.shear->friction) {
            note("the slip is not compared: the scene has no friction");
            return;
        }
        compare(
            1, "slip", scene::Quantity::slip_displacement, scene::Body::A, {1, -1},
            [](const Node& node) { return node.exact.inside(); },
            "of the largest exact slip at these nodes");
    }
    void sxx() {
        if (!has(2)) {
            return;
        }
        const auto one = [&](scene::Body body) {
            const auto before = file_.surface.size();
            compare(
                2, "sxx", scene::Quantity::sxx, body, {1}, [](const Node&) { return true; },
                exact_.scale().mean ? "of the mean pressure" : "of the peak");
            return file_.surface.size() > before;
        };
        if (!one(scene::Body::A) || !scene_.shear) {
            return;
        }
        const SurfaceErrors of_A = file_.surface.back();
        file_.surface.pop_back();
        const bool of_B = one(scene::Body::B) && file_.surface.back().peak < of_A.peak;
        if (!of_B) {
            file_.surface.back() = of_A;
        }
        note(fmt::format("sxx is compared with that of body {}, which agrees better",
                         of_B ? "B" : "A"));
    }

private:
    [[nodiscard]] bool has(std::size_t k) const {
        return std::ranges::any_of(
            file_.table.rows, [k](const ResultRow& row) { return row.surface[k].has_value(); });
    }
    void note(std::string text) { file_.data.findings.push_back(std::move(text)); }

    template <class Counts>
    void compare(std::size_t k, const char* name, scene::Quantity quantity, scene::Body body,
                 std::initializer_list<double> signs, const Counts& counts, const char* reference) {
        if (!has(k)) {
            return;
        }
        SurfaceValues exact(scene_, quantity, body);
        struct Pair {
            std::size_t node;
            double data;
            double exact;
        };
        std::vector<Pair> pairs;
        double largest = 0;
        for (std::size_t i = 0; i < file_.data.nodes.size(); ++i) {
            const Node& node = file_.data.nodes[i];
            const auto& data = file_.table.rows[i].surface[k];
            if (!data || !is_counted(node, zone_, file_.contact) || !counts(node)) {
                continue;
            }
            const bool closed = quantity == scene::Quantity::gap && node.exact.inside();
            if (const auto value = closed ? std::optional(0.0) : exact(node.x)) {
                pairs.push_back({i, *data, *value});
                largest = std::max(largest, std::abs(*value));
            }
        }
        SurfaceErrors found{name, reference, exact.route(),
                            quantity == scene::Quantity::sxx ? exact_.scale().value : largest};
        if (!(largest > 0)) {
            note(
                fmt::format("{} is not compared: {}", name,
                            exact.why().empty() ? "the exact one is 0 at all nodes" : exact.why()));
            return;
        }
        found.nodes = pairs.size();
        found.peak = INFINITY;
        for (const double sign : signs) {
            SurfaceErrors one = found;
            one.peak = -1;
            for (const Pair& p : pairs) {
                const double error = std::abs(sign * p.data - p.exact) / found.scale;
                if (!(error <= one.peak)) {
                    one.peak = error;
                    one.worst = p.node;
                    one.data = sign * p.data;
                    one.exact = p.exact;
                }
            }
            if (one.peak < found.peak) {
                found = one;
            }
        }
        file_.surface.push_back(found);
    }

    FileComparison& file_;
    const scene::Scene& scene_;
    const ExactContact& exact_;
    const EdgeZone& zone_;
};

} // namespace

void compare_surface(FileComparison& file, const scene::Scene& scene, const ExactContact& exact,
                     const Tolerances& tolerances) {
    SurfaceComparison comparison(file, scene, exact, tolerances.zone);
    comparison.gap();
    comparison.slip();
    comparison.sxx();
    for (const SurfaceErrors& e : file.surface) {
        if (tolerances.surface && !(e.peak <= *tolerances.surface)) {
            const Node& node = file.data.nodes[e.worst];
            file.failures.push_back(fmt::format(
                "the error of {}, {:.3g} % {}, is more than {:.3g} %: line {}, x = {:.6g}, {} = "
                "{:.6g}, exact {:.6g}",
                e.name, 100 * e.peak, e.reference, 100 * *tolerances.surface, node.line, node.x,
                e.name, e.data, e.exact));
        }
    }
}

} // namespace edgeproof::comparison
