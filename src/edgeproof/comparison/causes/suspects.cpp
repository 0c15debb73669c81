// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/causes/causes.hpp"
#include "edgeproof/diagnose/diagnose.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <tuple>
#include <utility>

namespace edgeproof::comparison {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// Makes suspects of one scene at the nodes used. Keeps references to all arguments.
class SuspectMaker {
public:
    SuspectMaker(const Observed& data, SuspectContacts& contacts, const ExactContact& exact)
        : data_(data), contacts_(contacts), exact_(exact) {}

    [[nodiscard]] std::vector<Suspect> of_pressure() && {
        factors();
        for (const diagnose::Mistake& mistake : diagnose::contact_mistakes(contacts_.scene())) {
            const auto change = [&](scene::Scene& other) {
                other = other.without_shear();
                mistake.change(other);
            };
            if (const ExactContact* const contact = changed(mistake, change)) {
                add(mistake.name, mistake.what, contact->a().value, contact->b().value,
                    [&](std::size_t i) { return pressure(*contact, data_[i].x); });
            }
        }
        for (const int rows : {1, -1}) {
            add("shifted-rows", "p is in the row next to that of its x",
                [&](std::size_t i) { return exact_pressure(i, rows); });
        }
        maps();
        means();
        nodal_forces();
        soft_penalty();
        shifts();
        terms();
        return std::move(list_);
    }

    [[nodiscard]] std::vector<Suspect> of_shear() && {
        const scene::Scene& scene = contacts_.scene();
        for (const auto& [name, what, k] :
             {std::tuple{"factor-2", "q is twice too large", 2.0},
              {"factor-2", "q is half as large", 0.5},
              {"factor-pi", "q is pi times too large", std::acos(-1)},
              {"factor-pi", "q is pi times too small", 1 / std::acos(-1)}}) {
            add(name, what, [this, k = k](std::size_t i) { return k * data_.right.values[i]; });
        }
        for (const diagnose::Mistake& mistake : diagnose::shear_mistakes(scene)) {
            if (const ExactContact* const contact = changed(mistake, mistake.change)) {
                add(mistake.name, mistake.what,
                    [&](std::size_t i) { return shear(*contact, data_[i].x); });
            }
        }
        if (scene.shear->friction) {
            const double f = scene.shear->friction->to<Real>().convert_to<double>();
            add("all-slips", "f p everywhere: full sliding",
                [&](std::size_t i) { return f * exact_pressure(i); });
        }
        if (!exact_.symmetric() || scene.shear->bulk_tension.sign() != 0) {
            add("mirrored", "x has the opposite direction", exact_.b().value, exact_.a().value,
                [&](std::size_t i) { return shear(exact_, -data_[i].x); });
        }
        return std::move(list_);
    }

private:
    using Value = std::function<double(std::size_t)>;
    /// Adds a suspect with `value` at each node used, on the contact -b < x < a.
    void add(std::string_view name, const std::string& what, double a, double b,
             const Value& value) {
        list_.push_back(data_.suspect(name, what, a, b, value));
    }
    /// Adds a suspect on the exact contact.
    void add(std::string_view name, const std::string& what, const Value& value) {
        add(name, what, exact_.a().value, exact_.b().value, value);
    }
    /// Null if the changed scene has no contact: if it slides, or slips in the other direction.
    [[nodiscard]] const ExactContact* changed(const diagnose::Mistake& mistake,
                                              const std::function<void(scene::Scene&)>& change) {
        return contacts_.with(std::string(mistake.name) + ": " + mistake.what, change);
    }
    /// The pressure and the shear traction of another contact; NaN where they are infinite.
    [[nodiscard]] static double pressure(const ExactContact& contact, double x) {
        return contact.quick_pressure(x).value_or(no_value);
    }
    [[nodiscard]] static double shear(const ExactContact& contact, double x) {
        return contact.q(contact.at(Real(x))).value_or(no_value);
    }
    /// The exact pressure `rows` rows after a node used; NaN if there is no such row.
    [[nodiscard]] double exact_pressure(std::size_t i, std::ptrdiff_t rows = 0) const {
        const auto at = static_cast<std::ptrdiff_t>(data_.nodes[i]) + rows;
        return at < 0 || at >= std::ssize(data_.data.nodes)
                   ? no_value
                   : data_.data.nodes[static_cast<std::size_t>(at)].p.exact.value_or(no_value);
    }

    void factors() {
        const double mean = exact_.force().value / exact_.area() / exact_.scale().value;
        for (const diagnose::NamedFactor& factor : diagnose::named_factors()) {
            const double named = factor.value.convert_to<double>();
            constexpr double same = 1e-9;
            const bool is_mean = factor.name == std::string_view("mean-for-peak");
            if (named < 0 || (is_mean && std::abs(named / mean - 1) > same)) {
                continue;
            }
            const bool psi = factor.name == std::string_view("unit-psi"); // of Pa, kPa or MPa
            for (const double k :
                 psi ? std::vector{named, 1e3 * named, 1e-3 * named} : std::vector{named}) {
                add(factor.name,
                    is_mean ? "the mean pressure, taken for the greatest"
                            : fmt::format("p is {:.6g} times the exact one", k),
                    [&](std::size_t i) { return k * exact_pressure(i); });
            }
        }
        const double origin = data_.data.origin; // undoes the shift that was found
        const auto scale = [&](const char* name, const std::string& what, double x, double p) {
            add(name, what, exact_.a().value * x - origin, exact_.b().value * x + origin,
                [&](std::size_t i) { return p * pressure(exact_, (data_[i].x + origin) / x); });
        };
        for (const auto& [name, k] : {std::pair{"power-of-ten", 10.0},
                                      {"power-of-ten", 1e2},
                                      {"power-of-ten", 1e3},
                                      {"power-of-ten", 1e6},
                                      {"unit-inch", 25.4},
                                      {"full-width-for-half", 2.0}}) {
            scale(name, fmt::format("x is {:g} times too large", k), k, 1);
            scale(name, fmt::format("x is {:g} times too large", 1 / k), 1 / k, 1);
        }
        scale("si-units", "x in m and p in Pa, for mm and MPa: --scale x=1e3,p=1e-6", 1e-3, 1e6);
    }

    void shifts() {
        std::vector<RoughPoint> points;
        for (std::size_t i = 0; i < data_.size(); ++i) {
            points.push_back({data_[i].x, data_[i].p.data});
        }
        if (const auto found = found_shift(points, data_.data.half, exact_)) {
            const double shift = found->exact.convert_to<double>();
            add("shifted-origin",
                fmt::format(
                    "x is shifted by {:.4g}: --origin {:.10g} if the data are measured from there",
                    shift, data_.data.origin + shift),
                exact_.a().value + shift, exact_.b().value - shift,
                [&](std::size_t i) { return moved_pressure(data_[i].x - shift); });
        }
    }

    /// The exact pressure at the place x, which the data give another coordinate. NaN near a
    /// corner, where the least shift can explain the noise of a node.
    [[nodiscard]] double moved_pressure(double x) const {
        constexpr double near = 0.02; // of a + b
        const bool by_corner = std::ranges::any_of(exact_.knots(), [&](const ContactKnot& knot) {
            return knot.corner && std::abs(x - knot.x) < near * exact_.length();
        });
        return by_corner ? no_value : pressure(exact_, x);
    }

    /// Adds suspects in which a program confused the coordinate x, as in the data.
    void maps() {
        struct Map {
            const char* name;
            const char* what;
            double right; ///< the ends of its contact in the x of the data
            double left;
            double from;            ///< the place is this, plus
            double (*by)(double x); ///< this
        };
        static constexpr auto along = [](double x) { return x; };
        static constexpr auto against = [](double x) { return -x; };
        const double a = exact_.a().value;
        const double b = exact_.b().value;
        const double whole = a + b;
        const double origin = data_.data.origin; // undoes the shift that was found
        const Map maps[] = {
            {"x-for-u", "x is measured from the left edge", whole, 0, -b, along},
            {"x-for-u", "x, understood as measured from the right edge inwards", whole, 0, a,
             against},
            {"x-for-u", "|x|, understood as measured from the right edge inwards", whole, whole, a,
             [](double x) { return -std::abs(x); }},
            {"x-for-u", "x is measured from the right edge", 0, whole, a, along},
            {"x-from-middle", "x is measured from the middle of the contact", whole / 2, whole / 2,
             (a - b) / 2, along},
            {"mirrored", "x has the opposite direction: the tilt is mirrored", b, a, 0, against},
            {"edges-swapped", "the edges are swapped: each distance is from the other one", a, b,
             a - b, against}};
        for (const Map& map : maps) {
            if (map.name == std::string_view("x-for-u") || !exact_.symmetric()) {
                add(map.name, map.what, map.right - origin, map.left + origin, [&](std::size_t i) {
                    return moved_pressure(map.from + map.by(data_[i].x + origin));
                });
            }
        }
    }

    /// Adds nodal values that are means over elements.
    void means() {
        struct Mean {
            const char* what;
            double before;
            double here;
            double behind;
        };
        for (const Mean& mean :
             {Mean{"p of a node is averaged over its two elements", 0.25, 0.5, 0.25},
              Mean{"the mean over an element is given at its left node", 0, 0.5, 0.5},
              Mean{"the mean over an element is given at its right node", 0.5, 0.5, 0}}) {
            add("element-average", mean.what, [&](std::size_t i) {
                const auto part = [&](double weight, int rows) {
                    return weight == 0 ? 0 : weight * exact_pressure(i, rows);
                };
                return part(mean.before, -1) + part(mean.here, 0) + part(mean.behind, 1);
            });
        }
        // The mean by Gauss's three points; this is inaccurate near an edge, where nodes are not
        // used.
        const auto& all = data_.data.nodes;
        add("element-average", "p is the mean over the width of a node", [&](std::size_t i) {
            const std::size_t at = data_.nodes[i];
            if (at == 0 || at + 1 >= all.size()) {
                return no_value;
            }
            const double middle = (all[at - 1].x + 2 * all[at].x + all[at + 1].x) / 4;
            const double half = (all[at + 1].x - all[at - 1].x) / 4;
            const double reach = half * std::sqrt(0.6);
            return (5 * pressure(exact_, middle - reach) + 8 * pressure(exact_, middle) +
                    5 * pressure(exact_, middle + reach)) /
                   18;
        });
    }

    /// Adds the forces of nodes, per unit of thickness: p at the node times half the width of its
    /// elements, the integral of the shape function times a linear p, and times p itself (by
    /// Simpson's rule, so not in the elements at an edge or a corner, where nodes are not used).
    /// These differ near a corner. Of quadratic elements, corner nodes have a third of the width of
    /// an element, the others two thirds.
    void nodal_forces() {
        if (contacts_.scene().round) {
            return;
        }
        const auto& all = data_.data.nodes;
        const auto of = [&](const std::string& elements, const auto& force) {
            add("nodal-forces",
                "forces of the nodes, p times the width of an element, instead of p" + elements,
                [&](std::size_t i) {
                    const std::size_t at = data_.nodes[i];
                    if (at == 0 || at + 1 >= all.size()) {
                        return no_value;
                    }
                    return force(i, -1, all[at].x - all[at - 1].x) +
                           force(i, 1, all[at + 1].x - all[at].x);
                });
        };
        of("", [&](std::size_t i, int, double width) { return exact_pressure(i) * width / 2; });
        of("", [&](std::size_t i, int side, double width) {
            return (2 * exact_pressure(i) + exact_pressure(i, side)) * width / 6;
        });
        of("", [&](std::size_t i, int side, double width) {
            const double middle = pressure(exact_, data_[i].x + side * width / 2);
            return (exact_pressure(i) + 2 * middle) * width / 6;
        });
        for (const std::size_t corner : {0U, 1U}) {
            of(": quadratic elements", [&](std::size_t i, int, double width) {
                const bool at_corner = data_.nodes[i] % 2 == corner;
                return exact_pressure(i) * width * (at_corner ? 1 : 2) / 3;
            });
        }
    }

    /// Adds the contact with springs of the stiffness that fits best, if it fits better than rigid
    /// ones.
    void soft_penalty() {
        const SoftContact& soft = contacts_.soft(exact_);
        const auto value = [&](const SoftContact::Solution& solution, std::size_t i) {
            return data_[i].p.exact.value_or(no_value) + soft.change(solution, data_[i].x);
        };
        const auto fitted = soft.fitted([&](const SoftContact::Solution& solution) {
            double sum = 0;
            for (std::size_t i = 0; i < data_.size(); ++i) {
                const double off = data_[i].p.data - value(solution, i);
                sum += std::isfinite(off) ? off * off : 0;
            }
            return sum;
        });
        if (fitted) {
            const double stiffness = 1 / fitted->softness;
            add("soft-penalty",
                fmt::format(
                    "a soft penalty: p is {:.2g}{} times the penetration, {:.2g} E*/(a + b); "
                    "the contact needs a larger stiffness",
                    soft.stiffness_unit() * stiffness, stiffness_label(), stiffness),
                fitted->a, fitted->b, [&](std::size_t i) { return value(*fitted, i); });
        }
    }
    [[nodiscard]] std::string stiffness_label() const {
        const auto& units = contacts_.scene().units;
        return units && units->pressure && units->length
                   ? fmt::format(" {}/{}", units->pressure->name, units->length->name)
                   : std::string();
    }

    void terms() {
        static constexpr std::array names{"one-term", "two-term", "three-term"};
        using OfPlace = contact::Edge (*)(const ExactContact::Place&);
        static constexpr std::pair<const char*, OfPlace> edges[] = {
            {"the nearer edge", [](const auto& place) { return place.nearer(); }},
            {"the right edge", [](const auto&) { return contact::Edge::right; }},
            {"the left edge", [](const auto&) { return contact::Edge::left; }}};
        for (std::size_t n = 1; n <= names.size(); ++n) {
            const std::string count = n == 1 ? "term" : fmt::format("{} terms", n);
            for (const auto& [where, edge_of] : edges) {
                add(names[n - 1],
                    fmt::format("the first {} of the expansion at {} instead of p", count, where),
                    [this, n, edge_of = edge_of](std::size_t i) {
                        const auto& place = data_[i].place;
                        const contact::Edge edge = edge_of(place);
                        const double u = place.from(edge);
                        double sum = 0;
                        for (std::size_t k = place.inside() ? n : 0; k-- > 0;) {
                            sum = sum * u + exact_.c(edge, k).value;
                        }
                        return place.inside() ? sum * std::sqrt(u) : 0;
                    });
            }
        }
    }

    const Observed& data_;
    SuspectContacts& contacts_;
    const ExactContact& exact_;
    std::vector<Suspect> list_;
};

} // namespace

const ExactContact* SuspectContacts::with(const std::string& mistake,
                                          const std::function<void(scene::Scene&)>& change) {
    const auto [found, is_new] = solved_.try_emplace(mistake);
    if (is_new) {
        try {
            scene::Scene other = scene_;
            change(other);
            found->second.emplace(other);
        } catch (const Error&) { // the changed scene has no contact
        }
    }
    return found->second ? &*found->second : nullptr;
}

const SoftContact& SuspectContacts::soft(const ExactContact& exact) {
    if (!soft_) {
        soft_.emplace(scene_, exact);
    }
    return *soft_;
}

std::vector<Suspect> pressure_suspects(const Observed& data, SuspectContacts& contacts,
                                       const ExactContact& exact) {
    const PrecisionScope scope(ExactContact::place_digits);
    return SuspectMaker(data, contacts, exact).of_pressure();
}

std::vector<Suspect> shear_suspects(const Observed& data, SuspectContacts& contacts,
                                    const ExactContact& exact) {
    const PrecisionScope scope(ExactContact::place_digits);
    return SuspectMaker(data, contacts, exact).of_shear();
}

} // namespace edgeproof::comparison
