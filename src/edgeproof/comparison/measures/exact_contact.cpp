// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/exact_contact.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/roots/bracketed_root.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace edgeproof::comparison {
namespace {

constexpr unsigned value_digits = 20;
constexpr unsigned contact_digits = 40;
constexpr long tilt_bits = 192;       ///< for `contact_digits`
constexpr double on_a_corner = 1e-15; ///< relative to a + b
/// The same: within it, a distance from an edge in binary64 has too few digits for p.
constexpr double near_a_corner = 1e-3;

contact::Profile profile_of(const scene::Scene& scene) {
    return scene.profile ? *scene.profile
                         : enclose_tilt(*scene.punch, scene.contact_modulus, scene.load.value,
                                        *scene.moment, tilt_bits)
                               .near;
}

/// True if g' changes its formula there: the origin of a parabola is a knot without a change.
bool bends(const contact::Profile& profile, std::size_t knot) {
    const auto& before = profile.pieces()[knot].linear;
    const auto& behind = profile.pieces()[knot + 1].linear;
    return !before || !behind || profile.has_corner(knot) ||
           !contact::certainly_zero(before->rate - behind->rate);
}

ExactValue exact_value(const scene::BoundedValue& value) {
    const PrecisionScope scope(value_digits + 10);
    return {value.value.midpoint().convert_to<double>(), value.how()};
}

} // namespace

scene::AskedValue asked_at(scene::Quantity quantity, const Real& x) {
    const auto place = formula::Expr::number(contact::exact_value(x));
    return {.quantity = quantity,
            .place = scene::Distance(formula::Expr::symbol("a") - place, place)};
}

struct ExactContact::Solved {
    explicit Solved(const scene::Scene& asked) : scene(asked), profile(profile_of(asked)) {}

    /// The values of the contact, or its coefficients, with the digits of its edges.
    [[nodiscard]] scene::SceneResult values(scene::QuantityGroup group) const {
        scene::Scene of = scene.without_shear();
        of.ask = {};
        of.ask.edges = {contact::Edge::right, contact::Edge::left};
        of.ask.terms = {coefficients};
        of.ask.quantities = {group};
        of.ask.digits = {contact_digits, Rounding::nearest, false};
        return io::at_place(scene.file, scene.load_line, [&] { return run_scene(of); });
    }

    /// p or q at the place x, in full.
    [[nodiscard]] double in_full(scene::Quantity quantity, const Real& x) {
        const scene::AskedValue asked = asked_at(quantity, x);
        auto& values = quantity == scene::Quantity::p ? full_pressure : full_traction;
        if (!values) {
            values.emplace(quantity == scene::Quantity::p ? scene.without_shear() : scene,
                           std::vector{asked},
                           scene::Digits{value_digits, Rounding::nearest, false});
        }
        return exact_value(values->value(asked)).value;
    }

    scene::Scene scene;
    contact::Profile profile;
    std::optional<scene::Binary64Values> pressures; ///< made when needed
    std::optional<scene::Binary64Values> tractions; ///< the same
    std::optional<scene::SceneValues> full_pressure;
    std::optional<scene::SceneValues> full_traction;
    /// Set for a curved slope in the plane.
    std::optional<QuickPressure> quick;
    Real right; ///< a
    Real left;  ///< b
    std::optional<ExactShear> shear;
    std::map<contact::Edge, std::vector<ExactValue>> c; ///< c_0, ..., made when needed
};

ExactContact::ExactContact(const scene::Scene& scene) {
    if (scene.curved_body()) {
        throw InputError("compare does not compute curved slopes of revolution",
                         "give a power law or a piecewise linear g'")
            .at(scene.file, scene.profile_line);
    }
    io::at_place(scene.file, scene.load_line, [&] { solve(scene); });
}

void ExactContact::solve(const scene::Scene& scene) {
    solved_ = std::make_shared<Solved>(scene);
    Solved& s = *solved_;
    const scene::SceneResult result = s.values(scene::QuantityGroup::contact);
    a_ = exact_value(result.at(scene::Quantity::a));
    b_ = exact_value(result.at(scene::Quantity::b));
    force_ = exact_value(result.at(scene::Quantity::P));
    s.right = result.at(scene::Quantity::a).value.midpoint();
    s.left = result.at(scene::Quantity::b).value.midpoint();
    const PrecisionScope scope(place_digits);
    const contact::Profile& profile = s.profile;
    if (!profile.has_closed_form() && !profile.axisymmetric()) {
        s.quick.emplace(profile, scene.contact_modulus.to<double>(), a_.value, b_.value);
    }
    symmetric_ = profile.symmetric();
    axisymmetric_ = scene.round.has_value();
    if (scene.shear) {
        s.shear.emplace(scene, length());
    }
    radius_ = {length(), length()};
    for (std::size_t i = 0; i < profile.knots().size(); ++i) {
        const Real x = profile.knots()[i].to<Real>();
        for (const auto& [edge, from] : {std::pair{contact::Edge::right, Real(s.right - x)},
                                         {contact::Edge::left, Real(s.left + x)}}) {
            double& radius = radius_[index_of(edge)];
            radius = from > 0 ? std::min(radius, from.convert_to<double>()) : radius;
        }
        if (x < s.right && x > -s.left && bends(profile, i)) {
            knots_.push_back({x.convert_to<double>(), profile.has_corner(i)});
        }
    }
}

const ExactValue& ExactContact::c(contact::Edge edge, std::size_t k) const {
    auto& all = solved_->c;
    if (all.empty()) {
        const scene::SceneResult found = solved_->values(scene::QuantityGroup::coefficients);
        for (const scene::RowsAt& at : found.at_edges(scene::QuantityGroup::coefficients)) {
            for (std::size_t i = 0; i < coefficients; ++i) {
                all[at.edge()].push_back(exact_value(at.at(scene::Quantity::c, i)));
            }
        }
    }
    return all.at(edge).at(k);
}

/// Finds the largest p from samples, which are dense near knots, where p may rise steeply; then
/// refines the best sample between its neighbours. At the maximum p is flat, so an error of its
/// place has little effect.
const ExactContact::Scale& ExactContact::scale() const {
    if (!scale_) {
        scale_ = Scale{force_.value / area(), 0, true};
        if (std::ranges::none_of(knots_, &ContactKnot::corner)) {
            find_scale();
        }
    }
    return *scale_;
}

void ExactContact::find_scale() const {
    std::vector<double> samples;
    constexpr int even = 160;
    for (int i = 1; i < even; ++i) {
        samples.push_back(-b_.value + length() * i / even);
    }
    for (const ContactKnot& knot : knots_) {
        samples.push_back(knot.x);
        for (double step = 0.1 * length(); step > 1e-9 * length(); step /= 2.5) {
            samples.push_back(knot.x - step);
            samples.push_back(knot.x + step);
        }
    }
    std::erase_if(samples, [&](double x) { return x <= -b_.value || x >= a_.value; });
    std::ranges::sort(samples);
    std::size_t best = 0;
    double largest = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        check_interruption();
        const double p = quick_pressure(samples[i]).value_or(0);
        if (p > largest) {
            largest = p;
            best = i;
        }
    }
    constexpr int steps = 60;
    double x = roots::place_of_minimum(
        [&](double place) {
            check_interruption();
            return -quick_pressure(place).value_or(0);
        },
        samples[best > 0 ? best - 1 : best], samples[std::min(best + 1, samples.size() - 1)],
        steps);
    const double p = quick_pressure(x).value_or(0);
    x = p > largest ? x : samples[best];
    largest = std::max(p, largest);
    scale_ = Scale{at(Real(x)).p.value_or(largest), x, false};
}

std::string ExactContact::pressure_route() const {
    return axisymmetric_                 ? "by the Abel integral"
           : profile().has_closed_form() ? "in closed form"
                                         : "by rigorous integration";
}

const contact::Profile& ExactContact::profile() const { return solved_->profile; }

double ExactContact::area() const {
    return axisymmetric_ ? std::acos(-1) * a_.value * a_.value : length();
}

double ExactContact::force_width(double x) const {
    return axisymmetric_ ? std::acos(-1) * std::abs(x) : 1;
}

ExactContact::Place ExactContact::at(const Real& x) const {
    const PrecisionScope scope(place_digits);
    const Real right = solved_->right - x;
    const Real left = solved_->left + x;
    Place place{right.convert_to<double>(), left.convert_to<double>(), 0.0, {}};
    if (!(right > 0) || !(left > 0)) {
        return place;
    }
    const auto corner_within = [&](double share) {
        return std::ranges::any_of(knots_, [&](const ContactKnot& knot) {
            return knot.corner && abs(Real(x - knot.x)) <= share * length();
        });
    };
    if (corner_within(on_a_corner)) {
        place.p.reset();
        return place;
    }
    try {
        if (corner_within(near_a_corner)) {
            place.near_corner = x;
            place.p = solved_->in_full(scene::Quantity::p, x);
            return place;
        }
        if (!solved_->pressures) {
            solved_->pressures.emplace(solved_->scene.without_shear());
        }
        const double p = (*solved_->pressures)(place.nearer(), place.u());
        place.p = std::isfinite(p) ? std::optional(p) : std::nullopt;
    } catch (const Error&) { // not enclosed
        place.p.reset();
    }
    return place;
}

const ExactShear* ExactContact::shear() const {
    return solved_->shear ? &*solved_->shear : nullptr;
}

std::optional<double> ExactContact::traction(const Place& place) const {
    Solved& s = *solved_;
    if (!s.shear) {
        return {};
    }
    const double at_edge = length() * 1e-12; // the resolution of a place in binary64
    if (s.shear->singular() && std::abs(place.u()) < at_edge) {
        return {};
    }
    if (!place.inside()) {
        return 0.0;
    }
    if (!place.p && !s.shear->singular()) {
        return {};
    }
    try {
        if (place.near_corner) {
            return s.in_full(scene::Quantity::q, *place.near_corner);
        }
        if (!s.tractions) {
            s.tractions.emplace(s.scene, scene::Binary64Question{.quantity = scene::Quantity::q});
        }
        return (*s.tractions)(place.nearer(), place.u());
    } catch (const Error&) { // on a knot of the stick zone, where balls do not enclose q
        return {};
    }
}

std::optional<double> ExactContact::quick_pressure(double x) const {
    const auto& quick = solved_->quick;
    const auto p = quick && x < a_.value && x > -b_.value ? quick->at(x) : std::nullopt;
    return p ? p : at(Real(x)).p;
}

double ExactContact::pressure(double x) const { return quick_pressure(x).value_or(scale().value); }

ExactShear::ExactShear(const scene::Scene& scene, double length) {
    const PrecisionScope scope(ExactContact::place_digits);
    const contact::ShearSpec& spec = *scene.shear;
    const bool round = scene.round.has_value();
    const double area = round ? std::acos(-1) * length * length / 4 : length;
    const std::string area_text = round ? "(pi a^2)" : "(a + b)";
    force_ = spec.Q.to<double>();
    singular_ = !spec.friction && spec.path != contact::LoadingPath::together;
    if (scene.history) {
        scale_ =
            spec.friction->to<double>() * scene.history->layers.back().force.to<double>() / area;
        scale_text_ = "f P/" + area_text;
        return;
    }
    scale_ = std::abs(force_) / area + std::abs(spec.bulk_tension.to<double>()) / 4;
    scale_text_ = "|Q|/" + area_text + (round ? "" : " + |bulk_tension|/4");
    if (spec.friction) {
        const scene::AskedValue right{scene::Quantity::stick_a};
        const scene::AskedValue left{scene::Quantity::stick_b};
        scene::SceneValues zone(scene, {right, left},
                                scene::Digits{value_digits, Rounding::nearest, false});
        stick_edges_ = {exact_value(zone.value(right)).value, -exact_value(zone.value(left)).value};
    }
}

} // namespace edgeproof::comparison
