// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/certificate.hpp"

#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/stated_contact.hpp"
#include "edgeproof/certificate/theory/theory.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

namespace edgeproof::certificate {
namespace {

using scene::BoundedValue;
using scene::Quantity;

std::string edge_name(Edge edge) { return edge == Edge::right ? "right" : "left"; }

/// The text "Rabs (p0 - (value)) <= half a unit of its last digit", and the value as printed.
struct Rounded {
    std::string conclusion;
    std::string text;
};
Rounded rounded(const std::string& name, const BoundedValue& value, const scene::Digits& digits) {
    const std::string text = printed(value, digits).text;
    const CoqDecimal decimal = coq_decimal(text);
    // A value that is not distinguished from zero is printed as zero: it has the digits asked for.
    const long last = decimal.value == 0 ? -static_cast<long>(digits.count) : decimal.last;
    return {fmt::format("Rabs ({} - ({})) <= {}", name, decimal.text,
                        last <= 0 ? fmt::format("5 / 10 ^ {}", 1 - last)
                                  : fmt::format("5 * 10 ^ {}", last - 1)),
            text};
}

/// Returns the right edge: as given, or computed from the force where there is a closed form.
Exact right_edge(const scene::Scene& scene) {
    if (scene.load.kind == contact::Load::Kind::right_edge) {
        return scene.load.value;
    }
    std::map<std::string, Exact> parameters = scene.profile->parameters();
    parameters.insert_or_assign("P", scene.load.value);
    parameters.insert_or_assign("Es", scene.contact_modulus);
    const auto of_these = [&](const std::string& text) {
        formula::Symbols symbols;
        for (const auto& [name, value] : parameters) {
            symbols.add(name);
        }
        Expr e = formula::parse(text, symbols);
        for (const auto& [name, value] : parameters) {
            e = substitute(e, name, value.expr());
        }
        return Exact(e);
    };
    const auto m = parameters.find("m");
    if (scene.profile->kind() == contact::Profile::Kind::tilted_wedge) {
        return of_these("P/(Es*phi)/sqrt((1 - sin(pi*alpha/(2*phi)))/(1 + sin(pi*alpha/(2*phi))))");
    }
    if (m != parameters.end() && m->second.is_rational() && m->second.rational() == 0) {
        return of_these("P/(Es*C)");
    }
    if (m != parameters.end() && m->second.is_rational() && m->second.rational() == 1) {
        return of_these("sqrt(4*P/(pi*Es*C))");
    }
    throw NotStated("a contact given by its force is stated for wedges and parabolas only, because "
                    "the edge of other contacts is the root of an equation; give a");
}

class SceneTheorems {
public:
    SceneTheorems(const scene::Scene& scene, const scene::SceneResult& result)
        : scene_(scene), result_(result) {}

    std::vector<Certificate> all() {
        add("load", [&](Certificate& c) { load(c); });
        for (const scene::RowsAt& edge : result_.at_edges(scene::QuantityGroup::coefficients)) {
            add("coefficients." + edge_name(edge.edge()),
                [&](Certificate& c) { coefficients(c, edge); });
        }
        for (const Edge edge : scene_.ask.edges) {
            pressures(edge);
        }
        for (const scene::Row& row : result_.rows) {
            if (row.asked.quantity == Quantity::extent) {
                add(fmt::format("extent.{}.{}", edge_name(row.asked.edge), row.asked.k),
                    [&](Certificate& c) { first_exit(c, row); });
            }
        }
        if (scene_.shear) {
            add("shear", [](Certificate&) { throw NotStated("shear is not stated"); });
        }
        using Group = scene::QuantityGroup;
        if (scene_.ask.wants(Group::stress)) {
            add("stress", [&](Certificate& c) { stresses(c); });
        }
        for (const Group group : {Group::peak, Group::displacement, Group::surface}) {
            if (scene_.ask.wants(group)) {
                add(scene::group_name(group),
                    [](Certificate&) { throw NotStated("no theory is about this quantity"); });
            }
        }
        return std::move(certificates_);
    }

private:
    /// Adds a certificate, or the reason why there is none.
    void add(const std::string& id, const std::function<void(Certificate&)>& state) {
        Certificate c;
        c.id = id;
        c.verdict = "value";
        c.file = coq_name(id) + ".v";
        try {
            state(c);
        } catch (const NotStated& reason) {
            c.theorems.clear();
            c.text.clear();
            c.leaves_out = reason.what();
        }
        certificates_.push_back(std::move(c));
    }

    const StatedContact& contact() {
        if (!scene_.profile) {
            throw NotStated("a contact is stated if its tilt is given, not P and M");
        }
        if (!contact_) {
            contact_ = stated_contact(*scene_.profile, right_edge(scene_), scene_.contact_modulus);
        }
        return *contact_;
    }
    [[nodiscard]] std::string comment() const {
        std::string name = scene_.title.empty() ? scene_.file : scene_.title;
        return "(* Of the scene: " + in_comment(std::move(name)) + " *)\n";
    }
    /// Returns the proof for a value at the distance u from the edge.
    [[nodiscard]] std::string proof_by_bits(double u = 1, double length = 1) const {
        const double lost = std::max(0.0, std::log2(length / u)); // roots of small numbers
        return fmt::format("plain constants; integrals; interval with (i_prec {})",
                           static_cast<long>(3.33 * scene_.ask.digits.count + 64 + lost));
    }

    void load(Certificate& c) {
        const Fact& fact = contact().load;
        if (result_.find(Quantity::P) == nullptr) {
            throw NotStated("the load was not computed");
        }
        const Rounded value = rounded("P0", result_.at(Quantity::P), scene_.ask.digits);
        c.text =
            contact().head(comment()) +
            theorem_text("load_rounded",
                         "exists P0,\n  " + fact.statement + " /\\\n  " + value.conclusion,
                         "  eexists. split. { " + fact.proof + ". }\n  " + proof_by_bits() + ".\n");
        c.theorems = {{"load_rounded", "P = " + value.text + ", rounded"}};
        c.leaves_out = "that there is no other contact with this right edge";
    }

    void coefficients(Certificate& c, const scene::RowsAt& values) {
        const Fact& series = contact().at(values.edge()).series;
        std::string conclusions;
        std::string states;
        const std::size_t count = std::min<std::size_t>(result_.plan.terms, 3);
        for (std::size_t k = 0; k < count; ++k) {
            const Rounded value =
                rounded(series.unknowns[k], values.at(Quantity::c, k), scene_.ask.digits);
            conclusions += " /\\\n  " + value.conclusion;
            states += fmt::format("{}c_{} = {}", k == 0 ? "" : ", ", k, value.text);
        }
        const std::string name = "coefficients_" + edge_name(values.edge());
        c.text = contact().head(comment()) +
                 theorem_text(name, "exists r0 r1 r2,\n  " + series.statement + conclusions,
                              "  eexists. eexists. eexists. split. { " + series.proof +
                                  ". }\n  repeat split; " + proof_by_bits() + ".\n");
        c.theorems = {{name, states + ", rounded"}};
        c.leaves_out = count < result_.plan.terms ? "coefficients beyond the third" : "";
        if (contact().at(values.edge()).rises.empty()) {
            c.leaves_out += (c.leaves_out.empty() ? "" : "; ") +
                            std::string("that there are no other coefficients");
        }
    }

    void pressures(Edge edge) {
        Certificate all;
        all.id = "pressure." + edge_name(edge);
        all.verdict = "value";
        all.file = coq_name(all.id) + ".v";
        std::vector<Certificate> others;
        for (const scene::Row& row : result_.rows) {
            if (row.asked.quantity != Quantity::p || row.asked.edge != edge) {
                continue;
            }
            try {
                pressure(all, row);
            } catch (const NotStated& reason) {
                add(fmt::format("{}: u = {}", all.id, scene_.ask.u[row.point].text()),
                    [&](Certificate&) { throw NotStated(reason); });
            }
        }
        if (!all.theorems.empty()) {
            all.text = contact().head(comment()) + all.text;
            all.leaves_out =
                contact().at(edge).rises.empty() ? "that there is no other pressure" : "";
            certificates_.push_back(std::move(all));
        }
    }
    void pressure(Certificate& c, const scene::Row& row) {
        const StatedEdge& edge = contact().at(row.asked.edge);
        if (row.asked.place) {
            throw NotStated("only places given by a distance u are stated; give u");
        }
        const Exact& distance = *row.asked.u;
        const auto u = distance.to<double>();
        const auto proofs = edge.at(u, "u = " + distance.text());
        const Rounded value = rounded("p0", *row.value, scene_.ask.digits);
        const std::string name =
            fmt::format("pressure_{}_{}", edge_name(row.asked.edge), c.theorems.size() + 1);
        c.text += theorem_text(name,
                               "exists p0,\n  " + edge.pressure_at(in_coq(distance), "p0") +
                                   " /\\\n  " + value.conclusion,
                               "  eexists. split. { " + proofs.pressure + ". }\n  " +
                                   proof_by_bits(u, edge.distance) + ".\n");
        c.theorems.push_back(
            {name, fmt::format("p = {} at u = {} from the {} edge, rounded", value.text,
                               scene_.ask.u[row.point].text(), edge_name(row.asked.edge))});
    }

    /// States sxx, szz and sxz under a parabola, to 10 digits at most: the integrals take a minute
    /// for each point.
    void stresses(Certificate& c) {
        constexpr unsigned most_digits = 10;
        const auto& parameters =
            scene_.profile ? scene_.profile->parameters() : std::map<std::string, Exact>();
        const auto m = parameters.find("m");
        if (scene_.round || scene_.shear || m == parameters.end() || !m->second.is_rational() ||
            m->second.rational() != 1) {
            throw NotStated("stresses are stated under a parabola in the plane, without shear");
        }
        scene::Digits digits = scene_.ask.digits;
        digits.count = std::min(digits.count, most_digits);
        c.text = contact().head(comment()) + "\n" + std::string(theory_text("Stress"));
        for (const scene::RowsAt& at : result_.at_places(scene::QuantityRow::Place::body)) {
            const scene::BodyPoint& point = scene_.ask.in_bodies[at.point()];
            if (point.z.sign() <= 0) {
                throw NotStated("stresses are stated inside a body, for z > 0");
            }
            const std::string place = in_coq(point.x) + " " + in_coq(point.z);
            std::string conclusions;
            std::string states;
            for (const Quantity q : {Quantity::sxx, Quantity::szz, Quantity::sxz}) {
                const std::string symbol(row_of(q).name);
                const Rounded value = rounded(symbol, at.at(q), digits);
                conclusions += " /\\\n  " + value.conclusion;
                states += (states.empty() ? "" : ", ") + symbol + " = " + value.text;
            }
            const std::string name = fmt::format("stress_{}", c.theorems.size() + 1);
            c.text += theorem_text(
                name,
                "exists p sxx szz sxz,\n"
                "  are_the_pressures Es (Symmetric.slope punch) a a p /\\\n"
                "  are_the_stresses p a a " +
                    place + " sxx szz sxz" + conclusions,
                "  destruct (stresses_of_parabola Es " + in_coq(parameters.at("C")) + " a " +
                    place +
                    ") as (p & Hp & Hs); try (constants; interval).\n"
                    "  exists p. eexists. eexists. eexists. split; [exact Hp | split; [exact Hs "
                    "|]].\n"
                    "  constants. repeat split; integral with (i_prec 60, i_degree 12, i_fuel "
                    "3000).\n");
            c.theorems.push_back({name, fmt::format("{} at x = {}, z = {}, rounded", states,
                                                    point.x.text(), point.z.text())});
        }
        c.leaves_out = "the other stresses";
    }

    void first_exit(Certificate& c, const scene::Row& extent) {
        const std::size_t n = extent.asked.k;
        const StatedEdge& edge = contact().at(extent.asked.edge);
        if (!extent.reached) {
            throw NotStated("there is no first exit");
        }
        const auto u = static_cast<double>(extent.value->value.midpoint());
        // Round to four digits on both sides, at least a tenth of a unit of the last digit away.
        const double tenth = std::pow(10.0, std::floor(std::log10(u)) - 4);
        const ExtentStatement statement{n, *scene_.ask.tolerance, coq_decimal(u - tenth, 4, false),
                                        coq_decimal(u + tenth, 4, true), ""};
        const std::string name = fmt::format("extent_{}_{}", edge_name(extent.asked.edge), n);
        c.text = contact().head(comment()) + extent_theorem(name, edge, statement);
        c.theorems = {{name, fmt::format("{} terms stay within {} for u up to {}, and not at {}", n,
                                         scene_.ask.tolerance->text(), statement.within.text,
                                         statement.beyond.text)}};
        c.leaves_out = "the measure, and later crossings";
    }

    const scene::Scene& scene_;
    const scene::SceneResult& result_;
    std::optional<StatedContact> contact_;
    std::vector<Certificate> certificates_;
};

} // namespace

std::vector<Certificate> certify_scene(const scene::Scene& scene,
                                       const scene::SceneResult& result) {
    return SceneTheorems(scene, result).all();
}

} // namespace edgeproof::certificate
