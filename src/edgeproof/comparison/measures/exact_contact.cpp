// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/exact_contact.hpp"
#include "edgeproof/comparison/measures/quick_pressure.hpp"
#include "edgeproof/contact/double_word/double_word_pressure.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/roots/bracketed_root.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace edgeproof::comparison {
namespace {

constexpr unsigned value_digits = 20;
constexpr unsigned contact_digits = 40;
constexpr long tilt_bits = 192; ///< for `contact_digits`
/// The error of a and b at `contact_digits`, relative to a + b.
constexpr double edge_error = 1e-37;
constexpr double closed_form_error = 1e-20;

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

/// The question about a quantity at the place x.
scene::AskedValue asked_at(scene::Quantity quantity, const Real& x) {
    const auto place = formula::Expr::number(contact::exact_value(x));
    return {.quantity = quantity,
            .place = scene::Distance(formula::Expr::symbol("a") - place, place)};
}

std::unique_ptr<scene::SceneValues> values_of(const scene::Scene& scene, scene::Quantity quantity,
                                              unsigned digits) {
    return std::make_unique<scene::SceneValues>(scene, std::vector{asked_at(quantity, Real(0))},
                                                scene::Digits{digits, Rounding::nearest, false});
}

} // namespace

struct ExactContact::Solved {
    explicit Solved(const scene::Scene& asked) : scene(asked), profile(profile_of(asked)) {
        if (contact::DoubleWordPressure::has_form(profile) && !profile.axisymmetric()) {
            try {
                words.emplace(profile,
                              contact::BallContact(profile, scene.contact_modulus, scene.load,
                                                   contact::DoubleWordPressure::contact_bits));
            } catch (const BudgetError&) {
                // Bits do not separate an edge from a corner: `pressures` is used instead.
            }
        }
    }

    /// Returns nothing if double words do not have the digits, for example near a corner.
    [[nodiscard]] std::optional<Real> in_words(const Real& from_right,
                                               const Real& from_left) const {
        if (!words) {
            return {};
        }
        const bool by_right = from_right < from_left;
        DoubleWord distance = to_double_word(by_right ? from_right : from_left);
        distance.radius += edge_error * Real(right + left).convert_to<double>();
        const DoubleWord p =
            words->at(by_right ? contact::Edge::right : contact::Edge::left, distance);
        if (!(p.radius <= std::abs(p.high) * closed_form_error)) {
            return {};
        }
        return Real(p.high) + Real(p.low);
    }

    /// Throws DomainError on a corner.
    [[nodiscard]] Real pressure(const Real& x) {
        for (std::size_t i = 0; i < profile.knots().size(); ++i) {
            if (profile.has_corner(i) &&
                abs(Real(profile.knots()[i].to<Real>() - x)) <= Real("1e-20") * (right + left)) {
                throw DomainError("the place is on a corner");
            }
        }
        if (!pressures) {
            pressures = values_of(scene, scene::Quantity::p, value_digits);
        }
        return pressures->value(asked_at(scene::Quantity::p, x)).value.midpoint();
    }
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

    scene::Scene scene;
    contact::Profile profile;
    std::unique_ptr<scene::SceneValues> pressures; ///< made when needed
    /// Used where they have the digits.
    std::optional<contact::DoubleWordPressure> words;
    /// Set for a curved slope in the plane.
    std::optional<QuickPressure> quick;
    Real right; ///< a
    Real left;  ///< b
    Real force; ///< P
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
    s.force = result.at(scene::Quantity::P).value.midpoint();
    const PrecisionScope scope(place_digits);
    const contact::Profile& profile = s.profile;
    if (!profile.has_closed_form() && !profile.axisymmetric()) {
        s.quick.emplace(profile, scene.contact_modulus.to<double>(), a_.value, b_.value);
    }
    symmetric_ = profile.symmetric();
    axisymmetric_ = scene.round.has_value();
    if (scene.shear) {
        s.shear.emplace(scene, contact::Extent<Real>{s.right, s.left}, s.force);
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
    return axisymmetric_    ? "by the Abel integral"
           : solved_->words ? "in closed form"
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
    Place place{right.convert_to<double>(), left.convert_to<double>(), 0.0, Real(0)};
    if (!(right > 0) || !(left > 0)) {
        return place;
    }
    if (const auto p = solved_->in_words(right, left)) {
        place.exact_p = *p;
        place.p = place.exact_p.convert_to<double>();
        return place;
    }
    try {
        place.exact_p = solved_->pressure(x);
        place.p = place.exact_p.convert_to<double>();
    } catch (const Error&) { // on a corner, or not enclosed
        place.p.reset();
    }
    return place;
}

const ExactShear* ExactContact::shear() const {
    return solved_->shear ? &*solved_->shear : nullptr;
}

std::optional<double> ExactContact::traction(const Real& x, const Place& place) const {
    if (!solved_->shear) {
        return {};
    }
    const PrecisionScope scope(place_digits);
    const Real right = solved_->right - x;
    const Real left = solved_->left + x;
    const bool singular = solved_->shear->singular();
    const Real at_edge = length() * 1e-12; // the resolution of a place in binary64
    if (singular && std::min(Real(abs(right)), Real(abs(left))) < at_edge) {
        return {};
    }
    if (!(right > 0) || !(left > 0)) {
        return 0.0;
    }
    if (!place.p && !singular) {
        return {};
    }
    try {
        return solved_->shear->at({right, left, x}, place.exact_p).convert_to<double>();
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

namespace {

constexpr unsigned traction_digits = 20;
constexpr unsigned zone_digits = 40;

} // namespace

struct ExactShear::Solved {
    Solved(const scene::Scene& asked, const contact::Extent<Real>& extent, const Real& normal)
        : spec(*asked.shear), axisymmetric(asked.round.has_value()), whole(extent),
          P(normal), load{spec.Q.to<Real>(), spec.bulk_tension.to<Real>()} {
        if (!spec.friction) {
            return;
        }
        in_slip = values_of(asked, scene::Quantity::q, traction_digits);
        if (asked.history) {
            most_force =
                Real(spec.friction->to<Real>() * asked.history->layers.back().force.to<Real>())
                    .convert_to<double>();
            return;
        }
        scene::Scene zone = asked;
        zone.ask = {};
        zone.ask.quantities = {scene::QuantityGroup::slip};
        zone.ask.digits = {zone_digits, Rounding::nearest, false};
        const scene::SceneResult result = run_scene(zone);
        stick_edges = {
            result.at(scene::Quantity::stick_a).value.midpoint().convert_to<double>(),
            Real(-result.at(scene::Quantity::stick_b).value.midpoint()).convert_to<double>()};
    }

    contact::ShearSpec spec;
    bool axisymmetric;
    contact::Extent<Real> whole;
    Real P;
    contact::ShearLoad<Real> load;
    std::unique_ptr<scene::SceneValues> in_slip; ///< with friction
    std::vector<double> stick_edges;             ///< empty after steps
    std::optional<double> most_force;            ///< f P after steps
};

ExactShear::ExactShear(const scene::Scene& scene, const contact::Extent<Real>& whole,
                       const Real& force)
    : solved_(std::make_shared<Solved>(scene, whole, force)) {}

Real ExactShear::at(const contact::Point<Real>& place, const Real& p) const {
    Solved& s = *solved_;
    if (s.in_slip) {
        return s.in_slip->value(asked_at(scene::Quantity::q, place.x)).value.midpoint();
    }
    return s.spec.path == contact::LoadingPath::together
               ? Real(s.load.Q / s.P * p)
               : contact::full_stick_traction(place, s.load);
}

double ExactShear::scale() const {
    const Solved& s = *solved_;
    const double length = s.whole.length().convert_to<double>();
    const double area = s.axisymmetric ? std::acos(-1) * length * length / 4 : length;
    if (s.most_force) {
        return *s.most_force / area;
    }
    return std::abs(force()) / area + std::abs(s.load.bulk_tension.convert_to<double>()) / 4;
}
std::string ExactShear::scale_text() const {
    const std::string area = solved_->axisymmetric ? "(pi a^2)" : "(a + b)";
    return solved_->most_force     ? "f P/" + area
           : solved_->axisymmetric ? "|Q|/" + area
                                   : "|Q|/" + area + " + |bulk_tension|/4";
}
double ExactShear::force() const { return solved_->load.Q.convert_to<double>(); }
const std::vector<double>& ExactShear::stick_edges() const { return solved_->stick_edges; }
bool ExactShear::singular() const {
    return !solved_->spec.friction && solved_->spec.path != contact::LoadingPath::together;
}

} // namespace edgeproof::comparison
