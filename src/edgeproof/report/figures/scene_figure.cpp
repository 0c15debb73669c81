// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/figures/scene_figure.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/report/text/percent.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace edgeproof::report {
namespace {

constexpr unsigned picture_digits = 24; ///< shows errors down to 1e-20
constexpr int first_places = 61;        ///< from edge to edge, to which finer_places adds others
constexpr int most_halvings = 7;        ///< of a step between two of them
/// Pressures are drawn up to this multiple of the height that most of the contact has.
constexpr double tallest = 4;
/// The part of its height by which a chord may differ from a curve: less than a pixel.
constexpr double straight_enough = 1.0 / 500;
constexpr int decades = 6;
constexpr int places_a_decade = 10;
constexpr std::array scene_pens{
    Pen{Pen::Colour::purple, 2, {}, 2}, Pen{Pen::Colour::blue, 4, {}, 2},
    Pen{Pen::Colour::green, 3, {}, 2},  Pen{Pen::Colour::vermilion, 5, {}, 2},
    Pen{Pen::Colour::orange, 6, {}, 2}, Pen{Pen::Colour::sky_blue, 1, {}, 2}};
constexpr std::array<unsigned, 6> exit_points{7, 5, 9, 13, 11, 15};

std::string in_terms(std::size_t n) { return std::to_string(n) + (n == 1 ? " term" : " terms"); }

Pen pen_of(std::size_t i) { return scene_pens[i % scene_pens.size()]; }

class Painter {
public:
    Painter(const scene::Scene& scene, std::function<void(std::size_t, std::size_t)> progress)
        : scene_(scene), progress_(std::move(progress)), values_(scene, asked(scene), digits()),
          a_(number({scene::Quantity::a})), b_(number({scene::Quantity::b})) {}

    [[nodiscard]] std::vector<Plot> paint(Panels panels) {
        for (const contact::Edge edge : scene_.ask.edges) {
            std::vector<Real> c;
            for (std::size_t k = 0; k < scene_.ask.most_terms(); ++k) {
                c.push_back(number({scene::Quantity::c, k, edge}));
            }
            edges_.push_back({edge, std::move(c), {}});
            find_exits(edges_.back());
        }
        std::vector<Plot> plots;
        if (panels != Panels::errors) {
            plots.push_back(pressures());
        }
        if (panels != Panels::pressure) {
            std::ranges::transform(edges_, std::back_inserter(plots),
                                   [this](const OfEdge& edge) { return errors(edge); });
        }
        return plots;
    }

private:
    struct OfEdge {
        contact::Edge edge;
        std::vector<Real> c;
        std::vector<std::optional<Real>> exits; ///< by number of terms, in the order of the request
    };
    [[nodiscard]] static scene::Digits digits() { return {picture_digits, Rounding::nearest}; }
    /// False for curved slopes of revolution, for which a search may take minutes.
    [[nodiscard]] static bool has_extents(const scene::Scene& scene) {
        return !scene.curved_body();
    }
    [[nodiscard]] static std::vector<scene::AskedValue> asked(const scene::Scene& scene) {
        using scene::Quantity;
        const auto one = formula::Exact::parse("1");
        std::vector<scene::AskedValue> list{{.quantity = Quantity::a}, {.quantity = Quantity::b}};
        list.push_back({.quantity = Quantity::p, .u = one});
        if (scene.shear) {
            list.push_back({.quantity = Quantity::q, .u = one});
        }
        for (const contact::Edge edge : scene.ask.edges) {
            for (const std::size_t n : scene.ask.terms) {
                list.push_back({.quantity = Quantity::c, .k = n - 1, .edge = edge});
                if (has_extents(scene)) {
                    list.push_back({.quantity = Quantity::extent,
                                    .k = n,
                                    .edge = edge,
                                    .tolerance = scene.ask.tolerance});
                }
            }
        }
        return list;
    }
    [[nodiscard]] Real number(const scene::AskedValue& asked) {
        return values_.value(asked).value.midpoint();
    }
    /// Returns nothing on a corner, or if rounding moved the point beyond an edge.
    [[nodiscard]] std::optional<Real> at(scene::Quantity quantity, contact::Edge edge,
                                         const Real& u) {
        check_interruption();
        ++done_;
        progress_(done_, std::max(done_, count()));
        try {
            return number({.quantity = quantity,
                           .edge = edge,
                           .u = formula::Exact::of(contact::exact_value(u))});
        } catch (const DomainError&) {
            return {};
        }
    }
    [[nodiscard]] std::size_t count() const {
        return static_cast<std::size_t>(2 * first_places) * (scene_.shear ? 2 : 1) +
               scene_.ask.edges.size() * (decades * places_a_decade + 1);
    }
    void find_exits(OfEdge& of) {
        for (const std::size_t n : scene_.ask.terms) {
            check_interruption();
            if (!has_extents(scene_)) {
                of.exits.emplace_back();
                continue;
            }
            const scene::Row& e = values_.searched({.quantity = scene::Quantity::extent,
                                                    .k = n,
                                                    .edge = of.edge,
                                                    .tolerance = scene_.ask.tolerance});
            of.exits.push_back(e.reached ? std::optional(e.value->value.midpoint()) : std::nullopt);
        }
    }
    [[nodiscard]] static Real sum(const std::vector<Real>& c, std::size_t n, const Real& u) {
        Real total = 0;
        for (std::size_t k = n; k-- > 0;) {
            total = total * u + c[k];
        }
        return total * sqrt(u);
    }
    [[nodiscard]] Plot pressures() {
        Plot plot;
        plot.id = "pressure";
        plot.title = scene_.title.empty() ? "Contact pressure" : scene_.title;
        plot.description = "Exact contact pressure against position, with the sums of the first "
                           "terms at the edges and where each first leaves the tolerance.";
        const scene::Units units = scene_.units.value_or(scene::Units{});
        plot.x = {"x" + unit_label(units.length)};
        plot.y = {(scene_.shear ? "p, q" : "p") + unit_label(units.pressure)};
        plot.add_curve("p", "p, exact", {Pen::Colour::black, 1, {}, 2.5});
        if (scene_.shear) {
            plot.add_curve("q", "q, exact", {Pen::Colour::black, 3, {}, 1.5});
        }
        const std::vector<Place> sampled = finer_places();
        std::vector<Real> places; // 0 at the left edge, 1 at the right one
        for (const Place& place : sampled) {
            if (!place.p) {
                continue; // a corner
            }
            auto& row = plot.add_row((a_ + b_) * place.w - b_);
            row[1] = place.p;
            if (scene_.shear) {
                row[2] = place.q;
            }
            places.push_back(place.w);
        }
        std::size_t number = 0;
        for (const OfEdge& of : edges_) {
            for (std::size_t i = 0; i < scene_.ask.terms.size(); ++i) {
                add_sum(plot, of, i, places, number++);
            }
        }
        const Real top = height_ * 1.15;
        plot.y.range = {scene_.shear ? lowest(plot, top) : Real(0), top};
        return plot;
    }
    /// A place along the contact, and its values; none at a corner.
    struct Place {
        Real angle; ///< 0 to pi: w = (1 - cos angle)/2 is dense at the edges
        Real w;     ///< 0 at the left edge, 1 at the right one
        std::optional<Real> p;
        std::optional<Real> q;
    };
    [[nodiscard]] Place place_at(const Real& angle) {
        Place place{angle, Real((1 - cos(angle)) / 2), {}, {}};
        const Real u = (a_ + b_) * place.w;
        place.p = at(scene::Quantity::p, contact::Edge::left, u);
        if (scene_.shear) {
            place.q = at(scene::Quantity::q, contact::Edge::left, u);
        }
        return place;
    }
    /// Returns the places of the curves, from edge to edge: even in the angle, and finer where p or
    /// q is curved or has a peak. Sets height_.
    [[nodiscard]] std::vector<Place> finer_places() {
        std::vector<Place> first{{Real(0), Real(0), Real(0), {}}};
        for (int k = 1; k < first_places; ++k) {
            first.push_back(place_at(Real(k) * pi<Real>() / first_places));
        }
        first.push_back({pi<Real>(), Real(1), Real(0), {}});
        std::vector<Real> heights;
        for (const Place& place : first) {
            if (place.p) {
                heights.push_back(*place.p);
            }
        }
        std::ranges::sort(heights);
        const Real usual = heights[heights.size() * 9 / 10];
        height_ = usual * tallest; // where the steps end at a corner with an infinite pressure
        std::vector<Place> all{first.front()};
        for (std::size_t k = 1; k < first.size(); ++k) {
            halve_step(first[k - 1], first[k], most_halvings, all);
            all.push_back(first[k]);
        }
        Real highest = 0;
        for (const Place& place : all) {
            highest = place.p ? std::max(highest, *place.p) : highest;
        }
        // A higher pressure belongs to a corner: the range shows most of the contact.
        height_ = highest < height_ ? highest : Real(usual * 2);
        return all;
    }
    /// Adds the places between two others, in order: the step is halved, at most `most` times,
    /// until the curves are straight. The first halving is always made.
    void halve_step(const Place& from, const Place& to, int most, std::vector<Place>& all) {
        const Place middle = place_at((from.angle + to.angle) / 2);
        const bool again = most > 1 && (bends(from.w, from.p, middle.w, middle.p, to.w, to.p) ||
                                        bends(from.w, from.q, middle.w, middle.q, to.w, to.q));
        if (again) {
            halve_step(from, middle, most - 1, all);
        }
        all.push_back(middle);
        if (again) {
            halve_step(middle, to, most - 1, all);
        }
    }
    [[nodiscard]] bool bends(const Real& w0, const std::optional<Real>& y0, const Real& w,
                             const std::optional<Real>& y, const Real& w1,
                             const std::optional<Real>& y1) const {
        const auto drawn = [&](const std::optional<Real>& value) {
            return value ? std::clamp(*value, Real(-height_), height_) : height_;
        };
        if (!y0 && !y && !y1) {
            return false; // there is no such curve
        }
        const Real chord = drawn(y0) + (drawn(y1) - drawn(y0)) * (w - w0) / (w1 - w0);
        return abs(drawn(y) - chord) > height_ / tallest * straight_enough;
    }
    /// Under full stick q is infinite at the edges: its range extends down as far as p extends up.
    [[nodiscard]] static Real lowest(const Plot& plot, const Real& top) {
        Real least = 0;
        for (const auto& row : plot.rows) {
            least = row[2] ? std::min(least, *row[2]) : least;
        }
        return std::max(least, Real(-top));
    }
    /// Adds the curve of a sum, from its edge to the middle or to its exit, and a mark there.
    void add_sum(Plot& plot, const OfEdge& of, std::size_t i, const std::vector<Real>& places,
                 std::size_t number) const {
        const std::size_t n = scene_.ask.terms[i];
        const bool right = of.edge == contact::Edge::right;
        const std::string name = scene::edge_name(of.edge);
        const std::string id = name + std::to_string(n);
        plot.add_curve(id, (edges_.size() > 1 ? name + ": " : "") + reach_text(of, i),
                       pen_of(number));
        for (std::size_t k = 0; k < places.size(); ++k) {
            const Real part = right ? Real(1 - places[k]) : places[k];
            const Real u = (a_ + b_) * part;
            if (part * 2 <= 1 || (of.exits[i] && u <= *of.exits[i])) {
                plot.rows[k].back() = sum(of.c, n, u);
            }
        }
        if (of.exits[i]) {
            const Real& u = *of.exits[i];
            plot.add_curve(id + "_exit", "", exit_pen(number), plot.curves.size() - 1);
            plot.add_row(right ? Real(a_ - u) : Real(u - b_)).back() = sum(of.c, n, u);
        }
    }
    /// The name of a sum, and of the mark at its exit.
    [[nodiscard]] std::string reach_text(const OfEdge& of, std::size_t i) const {
        return in_terms(scene_.ask.terms[i]) +
               (of.exits[i] ? ", within " + in_percent(*scene_.ask.tolerance) +
                                  " up to u = " + of.exits[i]->str(3)
                            : "");
    }
    [[nodiscard]] static Pen exit_pen(std::size_t i) {
        return {pen_of(i).colour, 0, exit_points[i % exit_points.size()], 2};
    }
    [[nodiscard]] Plot errors(const OfEdge& of) {
        Plot plot;
        const std::string name = scene::edge_name(of.edge);
        plot.id = name + "-edge";
        plot.title = "Error at the " + name + " edge";
        plot.description = "Relative error of the first terms against the distance from the " +
                           name + " edge, both axes logarithmic, with the tolerance.";
        plot.x = {"distance from the edge u" +
                      unit_label(scene_.units.value_or(scene::Units{}).length),
                  true};
        plot.y = {
            .label = "relative error |1 - local/p| [%]", .logarithmic = true, .percent = true};
        plot.first_column = "u";
        for (std::size_t i = 0; i < scene_.ask.terms.size(); ++i) {
            const std::size_t n = scene_.ask.terms[i];
            plot.add_curve("e" + std::to_string(n), reach_text(of, i), pen_of(i));
        }
        const Real length = a_ + b_;
        Real least = 1;
        for (int k = -decades * places_a_decade; k <= 0; ++k) {
            const Real u = length * pow(Real(10), Real(k) / places_a_decade) * 0.99999;
            const auto p = at(scene::Quantity::p, of.edge, u);
            if (!p) {
                continue;
            }
            auto& row = plot.add_row(u);
            for (std::size_t i = 0; i < scene_.ask.terms.size(); ++i) {
                const Real error = abs(Real(1 - sum(of.c, scene_.ask.terms[i], u) / *p));
                if (error > Real(1e-20)) {
                    row[i + 1] = error;
                    least = std::min(least, error);
                }
            }
        }
        plot.level = {scene_.ask.tolerance->to<Real>() * 100,
                      "tolerance " + in_percent(*scene_.ask.tolerance)};
        for (std::size_t i = 0; i < scene_.ask.terms.size(); ++i) {
            if (of.exits[i]) {
                plot.add_curve("exit" + std::to_string(scene_.ask.terms[i]), "", exit_pen(i), i);
                plot.add_row(*of.exits[i]).back() = scene_.ask.tolerance->to<Real>();
            }
        }
        plot.x.range = {length * pow(Real(10), -decades), length};
        plot.y.range = {pow(Real(10), floor(log10(least)) + 2), 1000};
        return plot;
    }

    const scene::Scene& scene_;
    std::function<void(std::size_t, std::size_t)> progress_;
    scene::SceneValues values_;
    Real a_;
    Real b_;
    std::vector<OfEdge> edges_;
    Real height_ = 0; ///< of the pressures that are drawn
    std::size_t done_ = 0;
};

} // namespace

std::vector<Plot> scene_picture(scene::Scene scene,
                                const std::function<void(std::size_t, std::size_t)>& progress,
                                Panels panels) {
    if (scene.ask.terms.empty()) {
        scene.ask.terms = {1, 2, 3};
    }
    if (!scene.ask.tolerance) {
        scene.ask.tolerance = scene::parse_tolerance("1%");
    }
    const PrecisionScope scope(picture_digits + 10);
    return Painter(scene, progress).paint(panels);
}

} // namespace edgeproof::report
