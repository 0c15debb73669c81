// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/plan.hpp"
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::scene {
namespace {

constexpr unsigned guard_digits = 20;
constexpr std::size_t most_slip_terms = 60; ///< the work grows as their fourth power

[[noreturn]] void reject(const Scene& scene, const std::string& problem,
                         const std::string& instead) {
    throw InputError(problem, instead)
        .at(scene.file, scene.ask_line != 0 ? scene.ask_line : scene.profile_line);
}

std::string count_of(std::size_t n, const std::string& what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// Refuses a request for which the scene lacks the data.
void check(const Scene& scene) {
    const Ask& ask = scene.ask;
    const auto for_each = [&](const auto& check_group) {
        for (const GroupRow& row : group_rows()) {
            if (ask.wants(row.group)) {
                check_group(row);
            }
        }
    };
    for_each([&](const GroupRow& row) {
        if (row.points && ask.u.empty()) {
            reject(scene, "the scene asks for no points",
                   "add u = [\"1e-3\", \"0.1\"] (distances from the edge) to [ask]");
        }
    });
    for_each([&](const GroupRow& row) {
        if (const auto lack = lack_of(scene, row)) {
            reject(scene, lack->problem, lack->instead);
        }
    });
    if (ask.wants(QuantityGroup::slip) && ask.most_terms() > most_slip_terms) {
        reject(scene, "slip zones of " + std::to_string(ask.most_terms()) + " terms are asked for",
               "give " + std::to_string(most_slip_terms) + " terms at most");
    }
    for_each([&](const GroupRow& row) {
        if ((row.terms && ask.terms.empty()) || (row.tolerance && !ask.tolerance)) {
            reject(scene, std::string(row.incomplete), std::string(row.instead));
        }
    });
}

/// Returns at least `bits`, such that with the guard bits of the elementary functions whole words
/// are used: one bit more would need another word.
long whole_words(long bits) {
    constexpr long word = 64;
    constexpr long guard = 24;
    return (bits + guard + word - 1) / word * word - guard;
}

class Planner {
public:
    explicit Planner(const Scene& scene) : scene_(scene), ask_(scene.ask) {}

    Plan make() {
        plan_.digits = ask_.digits;
        plan_.working_digits = ask_.digits.count + guard_digits;
        plan_.edges = ask_.edges;
        plan_.mirrored = scene_.symmetric() && ask_.edges.size() == 2;
        plan_.print_pressure = ask_.wants(QuantityGroup::pressure);
        plan_.shear = ask_.wants(QuantityGroup::shear);
        plan_.extents = ask_.wants(QuantityGroup::extent);
        plan_.resultants = ask_.wants(QuantityGroup::contact);
        plan_.slip = ask_.wants(QuantityGroup::slip);
        plan_.peak = ask_.wants(QuantityGroup::peak);
        plan_.stress = ask_.wants(QuantityGroup::stress);
        plan_.displacement =
            ask_.wants(QuantityGroup::displacement) || ask_.wants(QuantityGroup::surface);
        plan_.partial_slip =
            scene_.slips() && (plan_.shear || plan_.slip || plan_.stress || plan_.displacement);
        const bool similar = scene_.together();
        plan_.pressure = plan_.print_pressure || (plan_.shear && similar);
        const bool others = std::ranges::any_of(quantity_rows(), [&](const QuantityRow& row) {
            return row.by_its_own_name() && ask_.wants(row.group);
        });
        plan_.points = plan_.pressure || plan_.shear || others ? ask_.u.size() : 0;
        const bool coefficients = ask_.wants(QuantityGroup::coefficients);
        const bool approximations = plan_.points > 0 && !ask_.terms.empty();
        plan_.terms = coefficients || approximations ? ask_.most_terms() : 0;
        // The expansions of q are those of full stick.
        plan_.expand_shear =
            scene_.shear && !scene_.round && !scene_.history &&
            (coefficients || (approximations && plan_.shear && !plan_.partial_slip));
        plan_.expand_pressure = coefficients || (approximations && plan_.print_pressure) ||
                                (plan_.expand_shear && similar);
        precision();
        contact();
        tractions();
        loads();
        return std::move(plan_);
    }

private:
    void add(const char* name, bool on, std::string why, std::size_t Counts::*counter = nullptr,
             std::size_t count = 0) {
        if (on && counter != nullptr) {
            plan_.counts.*counter += count;
        }
        plan_.effects.push_back({name, on, std::move(why), counter});
    }
    /// The route, the bits, and whether the values are proved.
    void precision() {
        const bool has_form =
            !scene_.profile || contact::BallContact::has_closed_form(*scene_.profile);
        const bool automatic = ask_.route == Route::automatic;
        plan_.route = !automatic ? ask_.route
                      : has_form ? Route::closed_form
                                 : Route::singular_integral;
        const long bits = formula::bits_for(ask_.digits.count);
        plan_.bits = bits + 96;
        plan_.narrow_bits = has_form ? std::min(whole_words(bits + 40), plan_.bits)
                                     : plan_.bits; // an integral costs more than fewer bits save
        closed_ = plan_.route == Route::closed_form;
        const bool integrated = scene_.profile && automatic && !closed_ &&
                                contact::IntegratedContact::handles(*scene_.profile);
        plan_.proved = closed_ || integrated;
        plan_.proved_why =
            closed_ ? "closed forms in ball arithmetic: every value is enclosed"
            : integrated
                ? "rigorous integration in ball arithmetic: every value is enclosed, where "
                  "g' is proved not to decrease in the contact"
            : !automatic ? "the route " + route_name(plan_.route) + " is asked for"
                         : "a function in g' is beyond the rigorous integration";
    }
    void contact() {
        const bool tilt = scene_.punch.has_value();
        add("tilt", tilt,
            tilt ? "P and M are given, the tilt is not" : "the tilt is given, or none",
            &Counts::tilts, 1);
        const Load::Kind load = scene_.load.kind;
        const bool force = load != Load::Kind::right_edge;
        add("size from force", force,
            scene_.round && scene_.round->law && scene_.round->load.kind != Load::Kind::right_edge
                ? scene_.round->load_text() + "; a is in closed form"
            : load == Load::Kind::force    ? "P is given"
            : load == Load::Kind::approach ? "delta is given"
                                           : "a is given",
            &Counts::load_inversions, 1);
        const bool consistency = !scene_.symmetric();
        add("consistency", consistency,
            consistency ? "b is not a: the profile is not symmetric" : "b = a: symmetric",
            &Counts::consistency, 1);
        for (const Edge edge : {Edge::right, Edge::left}) {
            const bool asked = std::ranges::find(ask_.edges, edge) != ask_.edges.end();
            add(edge == Edge::right ? "right edge" : "left edge", asked,
                !asked                       ? "not asked"
                : !plan_.mirrored            ? "asked"
                : edge == ask_.edges.front() ? "asked; the other one is its mirror image"
                                             : "asked; the mirror image of the other one");
        }
    }
    void tractions() {
        const bool similar = scene_.together();
        const std::size_t edges = ask_.edges.size();
        edges_of_p_ = plan_.mirrored ? 1 : edges;
        // A place x has no mirror image.
        const auto by_x = std::ranges::count_if(ask_.u, [](const AskedPoint& point) {
            return point.place && point.place->from() == Place::From::origin;
        });
        const std::size_t points_of_p =
            ask_.u.size() * edges_of_p_ + (plan_.mirrored ? static_cast<std::size_t>(by_x) : 0);
        const std::string points =
            count_of(ask_.u.size(), "point") + " at " + count_of(edges_of_p_, "edge");
        const std::string why = !plan_.pressure        ? "no pressure is asked for"
                                : plan_.print_pressure ? points
                                                       : points + ": q = (Q/P) p";
        const bool power_law = scene_.profile && !scene_.profile->piecewise_linear();
        const std::string route = way_of_pressure(scene_, plan_);
        add("pressure, closed form", plan_.pressure && closed_,
            !plan_.pressure ? why
            : closed_       ? why + (power_law ? "; Gauss's 2F1" : "; logarithms")
                            : "the route is " + route,
            &Counts::closed_forms, points_of_p);
        add("pressure, quadrature", plan_.pressure && !closed_,
            !plan_.pressure ? why
            : closed_       ? "there is a closed form"
                            : why + ", " + route,
            &Counts::quadratures, points_of_p);
        const std::string terms = count_of(plan_.terms, "term");
        const bool coefficients = ask_.wants(QuantityGroup::coefficients);
        add("expansion of p", plan_.expand_pressure,
            plan_.expand_pressure ? terms + (coefficients ? "" : " for the approximations")
            : plan_.terms == 0    ? "no terms are asked for"
                                  : "only shear is asked for",
            &Counts::expansions, edges_of_p_);
        const std::string none = scene_.shear ? "not asked for" : "there is no [shear]";
        add("shear", plan_.shear,
            !plan_.shear         ? none
            : similar            ? "similar to p: P and Q grow together"
            : scene_.history     ? "partial slip after the steps"
            : plan_.partial_slip ? "partial slip, P held"
                                 : "full stick, P held",
            &Counts::shear_points, similar ? points_of_p : ask_.u.size() * edges);
        add("expansion of q", plan_.expand_shear, plan_.expand_shear ? terms : none,
            &Counts::shear_expansions, similar ? edges_of_p_ : edges);
    }
    void loads() {
        const std::string none =
            !scene_.slips() ? "there is no friction" : "neither q nor a slip zone is asked for";
        add("partial slip", plan_.partial_slip,
            plan_.partial_slip ? "f = " + scene_.shear->friction->text() +
                                     (scene_.history ? ", after the steps" : ", P held")
                               : none,
            &Counts::stick_zones, 1);
        add("slip zones", plan_.slip,
            !plan_.slip ? (scene_.slips() ? "not asked for" : none)
            : ask_.terms.empty() || scene_.history
                ? "their sizes"
                : "their sizes, and of " + count_of(ask_.most_terms(), "term"),
            &Counts::slip_sizes, ask_.edges.size());
        add("extent", plan_.extents,
            plan_.extents ? "within " + ask_.tolerance->text() + " of p" : "not asked for",
            &Counts::extents, ask_.terms.size() * edges_of_p_);
        if (plan_.stress) {
            add("stress", true, count_of(ask_.in_bodies.size(), "point"), &Counts::stresses,
                ask_.in_bodies.size());
        }
        if (plan_.displacement) {
            add("displacement", true, count_of(ask_.u.size(), "place"), &Counts::displacements,
                ask_.u.size() * ((ask_.wants(QuantityGroup::displacement) ? 1 : 0) +
                                 (ask_.wants(QuantityGroup::surface) ? 1 : 0)));
        }
        add("peak pressure", plan_.peak, plan_.peak ? "the greatest one" : "not asked for");
        // The tilt solver, and a load given as P, need P internally; that is not counted here.
        const bool for_shear = scene_.together() && (plan_.shear || plan_.expand_shear);
        add("force and moment", plan_.resultants || for_shear,
            plan_.resultants ? (scene_.round ? "P" : "P and M")
            : for_shear      ? "P, since q = (Q/P) p"
                             : "not asked for",
            &Counts::resultants,
            (!plan_.resultants ? 0U
             : scene_.round    ? 1U
                               : 2U) +
                (for_shear ? 1U : 0U));
    }

    const Scene& scene_;
    const Ask& ask_;
    Plan plan_;
    bool closed_ = false;        ///< by the closed form
    std::size_t edges_of_p_ = 0; ///< at which p is computed
};

} // namespace

std::string way_of_pressure(const Scene& scene, const Plan& plan) {
    return scene.profile && scene.profile->axisymmetric() ? "Abel integral"
                                                          : route_name(plan.route);
}

Plan make_plan(const Scene& scene) {
    check(scene);
    return Planner(scene).make();
}

bool peaks_in_the_middle(const Scene& scene) {
    if (!scene.profile || scene.profile->kind() != Profile::Kind::power_law) {
        return false;
    }
    const Exact& m = scene.profile->parameters().at("m");
    return m.sign() > 0 && Exact(m.expr() - Expr::number(Rational(1))).sign() <= 0;
}

void refuse_infinite_peak(const Real& x) {
    throw DomainError("there is no greatest pressure: it is infinite at the corner x = " +
                      x.str(8));
}

} // namespace edgeproof::scene
