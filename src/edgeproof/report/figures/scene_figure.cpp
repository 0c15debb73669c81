// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/scene_figure.hpp"

#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace edgeproof::report {
namespace {

constexpr unsigned picture_digits = 24; ///< shows errors down to 1e-20
constexpr int even_places = 121; ///< odd, so that no place is in the middle, where a corner may be
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

    [[nodiscard]] ScenePicture paint() {
        ScenePicture picture;
        for (const contact::Edge edge : scene_.ask.edges) {
            std::vector<Real> c;
            for (std::size_t k = 0; k < scene_.ask.most_terms(); ++k) {
                c.push_back(number({scene::Quantity::c, k, edge}));
            }
            edges_.push_back({edge, std::move(c), {}});
            find_exits(edges_.back(), picture.exits);
        }
        picture.plots.push_back(pressures());
        for (const OfEdge& edge : edges_) {
            picture.plots.push_back(errors(edge));
        }
        return picture;
    }

private:
    struct OfEdge {
        contact::Edge edge;
        std::vector<Real> c;
        std::vector<std::optional<Real>> exits; ///< by number of terms, in the order of the request
    };
    [[nodiscard]] static scene::Digits digits() { return {picture_digits, Rounding::nearest}; }
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
                list.push_back({.quantity = Quantity::extent,
                                .k = n,
                                .edge = edge,
                                .tolerance = scene.ask.tolerance});
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
        progress_(++done_, count());
        try {
            return number({.quantity = quantity,
                           .edge = edge,
                           .u = formula::Exact::of(contact::exact_value(u))});
        } catch (const DomainError&) {
            return {};
        }
    }
    [[nodiscard]] std::size_t count() const {
        return static_cast<std::size_t>(even_places) * (scene_.shear ? 2 : 1) +
               scene_.ask.edges.size() * (decades * places_a_decade + 1);
    }
    void find_exits(OfEdge& of, std::vector<std::string>& exits) {
        for (const std::size_t n : scene_.ask.terms) {
            check_interruption();
            const scene::Row& e = values_.searched({.quantity = scene::Quantity::extent,
                                                    .k = n,
                                                    .edge = of.edge,
                                                    .tolerance = scene_.ask.tolerance});
            const std::string head = scene::edge_name(of.edge) + " edge, " + in_terms(n) +
                                     ": within " + scene_.ask.tolerance->text() + " ";
            of.exits.push_back(e.reached ? std::optional(e.value->value.midpoint()) : std::nullopt);
            exits.push_back(e.reached ? head + "up to u = " + printed(*e.value, {6}).text +
                                            (e.value->proved ? "" : " (estimate)")
                                      : head + "everywhere in the part considered");
        }
    }
    [[nodiscard]] static Real sum(const std::vector<Real>& c, std::size_t n, const Real& u) {
        Real total = 0;
        for (std::size_t k = n; k-- > 0;) {
            total = total * u + c[k];
        }
        return total * sqrt(u);
    }
    [[nodiscard]] std::string units(std::optional<scene::Unit> scene::Units::*which) const {
        return scene_.units ? unit_label((*scene_.units).*which) : std::string();
    }

    [[nodiscard]] Plot pressures() {
        Plot plot;
        plot.id = "pressure";
        plot.title = scene_.title.empty() ? "Contact pressure" : scene_.title;
        plot.description = "Exact contact pressure against position, with the sums of the first "
                           "terms at the edges and where each first leaves the tolerance.";
        plot.x = {"x" + units(&scene::Units::length), false, {}};
        plot.y = {(scene_.shear ? "p, q" : "p") + units(&scene::Units::pressure), false, {}};
        plot.columns = {"x", "p"};
        plot.curves.push_back({"p", "p, exact", {Pen::Colour::black, 1, {}, 2.5}});
        if (scene_.shear) {
            plot.columns.push_back("q");
            plot.curves.push_back({"q", "q, exact", {Pen::Colour::black, 3, {}, 1.5}});
        }
        const std::size_t first = plot.columns.size();
        name_sums(plot);
        const Real length = a_ + b_;
        std::vector<Real> heights;
        for (int k = 0; k <= even_places; ++k) {
            const Real w = (1 - cos(Real(k) * pi<Real>() / even_places)) / 2; // 0 at the left edge
            std::vector<std::optional<Real>> row(plot.columns.size());
            row[0] = length * w - b_;
            const bool inside = k > 0 && k < even_places;
            row[1] = inside ? at(scene::Quantity::p, contact::Edge::left, Real(length * w))
                            : std::optional(Real(0));
            if (scene_.shear && inside) {
                row[2] = at(scene::Quantity::q, contact::Edge::left, Real(length * w));
            }
            if (row[1]) {
                heights.push_back(*row[1]);
            }
            add_sums(row, first, length, w);
            plot.rows.push_back(std::move(row));
        }
        add_exits(plot, first);
        // The pressure at a corner is infinite: the range shows most of the contact.
        std::ranges::sort(heights);
        const Real top =
            std::min(heights.back(), Real(heights[heights.size() * 9 / 10] * 2)) * 1.15;
        plot.y.range = {scene_.shear ? lowest(plot, top) : "0", top.str(6)};
        plot.key_below = true;
        return plot;
    }
    /// Under full stick q is infinite at the edges: its range extends down as far as p extends up.
    [[nodiscard]] static std::string lowest(const Plot& plot, const Real& top) {
        Real least = 0;
        for (const auto& row : plot.rows) {
            least = row[2] ? std::min(least, *row[2]) : least;
        }
        return std::max(least, Real(-top)).str(6);
    }
    /// A sum is shown from its edge to the middle.
    void name_sums(Plot& plot) const {
        std::size_t i = 0;
        for (const OfEdge& of : edges_) {
            for (const std::size_t n : scene_.ask.terms) {
                const std::string id = scene::edge_name(of.edge) + std::to_string(n);
                plot.columns.push_back(id);
                plot.curves.push_back(
                    {id, in_terms(n) + ", " + scene::edge_name(of.edge) + " edge", pen_of(i)});
                plot.columns.push_back(id + "_exit");
                plot.curves.push_back(
                    {id + "_exit", "leaves " + scene_.ask.tolerance->text(), exit_pen(i)});
                ++i;
            }
        }
    }
    [[nodiscard]] static Pen exit_pen(std::size_t i) {
        return {pen_of(i).colour, 0, exit_points[i % exit_points.size()], 2};
    }
    void add_sums(std::vector<std::optional<Real>>& row, std::size_t first, const Real& length,
                  const Real& w) const {
        std::size_t column = first;
        for (const OfEdge& of : edges_) {
            const Real part = of.edge == contact::Edge::left ? w : Real(1 - w);
            for (const std::size_t n : scene_.ask.terms) {
                if (part * 2 <= 1) {
                    row[column] = sum(of.c, n, Real(length * part));
                }
                column += 2;
            }
        }
    }
    void add_exits(Plot& plot, std::size_t first) const {
        std::size_t column = first + 1;
        for (const OfEdge& of : edges_) {
            for (std::size_t i = 0; i < scene_.ask.terms.size(); ++i, column += 2) {
                if (of.exits[i]) {
                    const Real& u = *of.exits[i];
                    std::vector<std::optional<Real>> row(plot.columns.size());
                    row[0] = of.edge == contact::Edge::right ? Real(a_ - u) : Real(u - b_);
                    row[column] = sum(of.c, scene_.ask.terms[i], u);
                    plot.rows.push_back(std::move(row));
                }
            }
        }
    }

    [[nodiscard]] Plot errors(const OfEdge& of) {
        Plot plot;
        const std::string name = scene::edge_name(of.edge);
        plot.id = name + "-edge";
        plot.title = "Error at the " + name + " edge";
        plot.description = "Relative error of the first terms against the distance from the " +
                           name + " edge, both axes logarithmic, with the tolerance.";
        plot.x = {"distance from the edge u" + units(&scene::Units::length), true, {}};
        plot.y = {"relative error |1 - local/p|", true, {}};
        plot.columns = {"u"};
        for (std::size_t i = 0; i < scene_.ask.terms.size(); ++i) {
            const std::size_t n = scene_.ask.terms[i];
            plot.columns.push_back("e" + std::to_string(n));
            plot.curves.push_back({plot.columns.back(), in_terms(n), pen_of(i)});
        }
        const Real length = a_ + b_;
        Real least = 1;
        for (int k = -decades * places_a_decade; k <= 0; ++k) {
            const Real u = length * pow(Real(10), Real(k) / places_a_decade) * 0.99999;
            const auto p = at(scene::Quantity::p, of.edge, u);
            if (!p) {
                continue;
            }
            std::vector<std::optional<Real>> row{u};
            for (const std::size_t n : scene_.ask.terms) {
                const Real error = abs(Real(1 - sum(of.c, n, u) / *p));
                row.emplace_back(error > Real(1e-20) ? std::optional(error) : std::nullopt);
                least = row.back() ? std::min(least, error) : least;
            }
            plot.rows.push_back(std::move(row));
        }
        plot.level = {scene_.ask.tolerance->to<Real>().str(12),
                      "tolerance " + scene_.ask.tolerance->text()};
        for (std::size_t i = 0; i < scene_.ask.terms.size(); ++i) {
            if (of.exits[i]) {
                plot.columns.push_back("exit" + std::to_string(scene_.ask.terms[i]));
                plot.curves.push_back(
                    {plot.columns.back(), "leaves it at u = " + of.exits[i]->str(3), exit_pen(i)});
                for (auto& row : plot.rows) {
                    row.emplace_back();
                }
                std::vector<std::optional<Real>> row(plot.columns.size());
                row.front() = *of.exits[i];
                row.back() = scene_.ask.tolerance->to<Real>();
                plot.rows.push_back(std::move(row));
            }
        }
        plot.y.range = {pow(Real(10), floor(log10(least))).str(3), "10"};
        plot.key_below = true;
        return plot;
    }

    const scene::Scene& scene_;
    std::function<void(std::size_t, std::size_t)> progress_;
    scene::SceneValues values_;
    Real a_;
    Real b_;
    std::vector<OfEdge> edges_;
    std::size_t done_ = 0;
};

} // namespace

ScenePicture scene_picture(const scene::Scene& scene,
                           const std::function<void(std::size_t, std::size_t)>& progress) {
    const PrecisionScope scope(picture_digits + 10);
    return Painter(scene, progress).paint();
}

} // namespace edgeproof::report
