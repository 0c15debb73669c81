// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/exact_contact.hpp"
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/batch/batch_pressure.hpp"
#include "edgeproof/contact/double_word/double_word_pressure.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/partial_slip.hpp"
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::comparison {
namespace {

constexpr unsigned value_digits = 20;
constexpr unsigned contact_digits = 40;
/// The error of a and b at `contact_digits`, relative to a + b.
constexpr double edge_error = 1e-37;
constexpr double closed_form_error = 1e-20;

contact::Profile profile_of(const scene::Scene& scene) {
    return scene.profile ? *scene.profile
                         : solve_tilt(*scene.punch, scene.contact_modulus, scene.load.value,
                                      *scene.moment, contact_digits)
                               .profile;
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

/// The pressure at a place, to the digits of the place. Throws DomainError on a corner. Where the
/// place is on a bend to within all digits, the enclosure is too wide: then the place is moved by
/// 1e-20 a, which changes p by the order of 1e-19 (its slope there is a logarithm).
Real abel_pressure(const contact::AxisymmetricContact& contact, const contact::Profile& profile,
                   const contact::Point<Real>& place) {
    const Real moved = Real("1e-20") * (place.right + place.left) / 2;
    for (std::size_t i = 0; i < profile.knots().size(); ++i) {
        if (profile.has_corner(i) &&
            abs(Real(profile.knots()[i].to<Real>() - place.x)) <= 2 * moved) {
            throw DomainError("the place is on a corner");
        }
    }
    const bool by_right = place.right < place.left;
    const contact::Edge edge = by_right ? contact::Edge::right : contact::Edge::left;
    const Ball u = Ball(by_right ? place.right : place.left, contact.bits());
    const auto is_narrow = [](const Ball& p) {
        return p.is_finite() && p.relative_accuracy_bits() >= 64;
    };
    Ball p = contact.pressure(edge, u);
    if (!is_narrow(p) && !contains_zero(u)) {
        p = contact.pressure(edge, u * (1 - Ball(parse_decimal("1e-20"), contact.bits())));
    }
    if (!p.is_finite()) {
        throw DomainError("the place is on a corner");
    }
    return p.midpoint();
}

} // namespace

struct ExactContact::Solved {
    explicit Solved(const scene::Scene& scene) : profile(profile_of(scene)) {
        if (profile.axisymmetric()) {
            by_abel.emplace(profile, scene.contact_modulus, scene.load,
                            formula::bits_for(contact_digits));
            const PrecisionScope scope(place_digits);
            left = right = by_abel->a().midpoint();
            radius = {by_abel->reach(contact::Edge::right).midpoint().convert_to<double>(),
                      by_abel->reach(contact::Edge::left).midpoint().convert_to<double>()};
            return;
        }
        const contact::NormalContact contact(profile, scene.contact_modulus, scene.load,
                                             contact_digits);
        batch.emplace(contact, value_digits);
        right = contact.a();
        left = contact.b();
        force = contact.force();
        for (const contact::Edge edge : {contact::Edge::right, contact::Edge::left}) {
            radius[index_of(edge)] = contact.convergence_radius(edge).convert_to<double>();
        }
        if (contact::DoubleWordPressure::has_form(profile)) {
            length = Real(right + left).convert_to<double>();
            try {
                words.emplace(profile,
                              contact::BallContact(profile, scene.contact_modulus, scene.load,
                                                   contact::DoubleWordPressure::contact_bits));
            } catch (const BudgetError&) {
                // Bits do not separate an edge from a corner: the batch rule is used instead.
            }
        }
    }

    /// Returns nothing if the closed form does not have the digits, for example near a corner.
    [[nodiscard]] std::optional<Real> closed_form(const Real& from_right,
                                                  const Real& from_left) const {
        if (!words) {
            return {};
        }
        const bool by_right = from_right < from_left;
        const Real& u = by_right ? from_right : from_left;
        DoubleWord distance = to_double_word(u);
        distance.radius += edge_error * length;
        const DoubleWord p =
            words->at(by_right ? contact::Edge::right : contact::Edge::left, distance);
        if (!(p.radius <= std::abs(p.high) * closed_form_error)) {
            return {};
        }
        return Real(p.high) + Real(p.low);
    }

    /// Throws DomainError on a corner.
    [[nodiscard]] Real pressure(const contact::Point<Real>& place) const {
        return by_abel ? abel_pressure(*by_abel, profile, place) : (*batch)(place).value;
    }

    contact::Profile profile;
    std::optional<contact::BatchPressure> batch;
    /// Replaces the batch rule for an axisymmetric contact whose profile is not a power law.
    std::optional<contact::AxisymmetricContact> by_abel;
    /// The closed form, if there is one.
    std::optional<contact::DoubleWordPressure> words;
    double length = 0;
    Real right;                     ///< a
    Real left;                      ///< b
    Real force;                     ///< of the plane contact
    std::array<double, 2> radius{}; ///< of convergence, by index_of(edge)
    std::optional<ExactShear> shear;
};

ExactContact::ExactContact(const scene::Scene& scene) {
    if (scene.curved_body()) {
        throw InputError("compare does not compute curved slopes of revolution",
                         "give a power law or a piecewise linear g'")
            .at(scene.file, scene.profile_line);
    }
    io::at_place(scene.file, scene.load_line, [&] { solve(scene); });
    scale_ = {force_.value / area(), 0, true};
    if (std::ranges::none_of(knots_, &ContactKnot::corner)) {
        find_scale();
    }
}

void ExactContact::solve(const scene::Scene& scene) {
    solved_ = std::make_shared<Solved>(scene);
    Solved& s = *solved_;
    scene::Scene asked = scene.without_shear();
    asked.ask = {};
    asked.ask.edges = {contact::Edge::right, contact::Edge::left};
    asked.ask.terms = {coefficients};
    asked.ask.quantities = {scene::QuantityGroup::contact, scene::QuantityGroup::coefficients};
    asked.ask.digits = {value_digits, Rounding::nearest, false};
    const scene::SceneResult result = run_scene(asked);
    a_ = exact_value(result.at(scene::Quantity::a));
    b_ = exact_value(result.at(scene::Quantity::b));
    force_ = exact_value(result.at(scene::Quantity::P));
    for (const scene::RowsAt& edge : result.at_edges(scene::QuantityGroup::coefficients)) {
        for (std::size_t k = 0; k < coefficients; ++k) {
            c_[index_of(edge.edge())][k] = exact_value(edge.at(scene::Quantity::c, k));
        }
        radius_[index_of(edge.edge())] = s.radius[index_of(edge.edge())];
    }
    const PrecisionScope scope(place_digits);
    const contact::Profile& profile = s.profile;
    symmetric_ = profile.symmetric();
    axisymmetric_ = scene.round.has_value();
    if (scene.shear) {
        s.shear.emplace(scene, profile, contact::Extent<Real>{s.right, s.left}, s.force);
    }
    for (std::size_t i = 0; i < profile.knots().size(); ++i) {
        const Real x = profile.knots()[i].to<Real>();
        if (x < s.right && x > -s.left && bends(profile, i)) {
            knots_.push_back({x.convert_to<double>(), profile.has_corner(i)});
        }
    }
}

/// Finds the largest p from samples, which are dense near knots, where p may rise steeply; then
/// refines the best sample between its neighbours. At the maximum p is flat, so an error of its
/// place has little effect.
void ExactContact::find_scale() {
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
        const double p = pressure(samples[i]);
        if (p > largest) {
            largest = p;
            best = i;
        }
    }
    double lower = best > 0 ? samples[best - 1] : samples[best];
    double upper = best + 1 < samples.size() ? samples[best + 1] : samples[best];
    double x = samples[best];
    constexpr double golden = 0.381966011250105;
    for (int i = 0; i < 60 && upper - lower > 1e-12 * length(); ++i) {
        check_interruption();
        const double s1 = lower + golden * (upper - lower);
        const double s2 = upper - golden * (upper - lower);
        const double p1 = pressure(s1);
        const double p2 = pressure(s2);
        for (const auto& [place, p] : {std::pair{s1, p1}, std::pair{s2, p2}}) {
            if (p > largest) {
                largest = p;
                x = place;
            }
        }
        (p1 < p2 ? lower : upper) = p1 < p2 ? s1 : s2;
    }
    scale_ = {largest, x, false};
}

std::string ExactContact::pressure_route() const {
    return solved_->words     ? "in closed form"
           : solved_->by_abel ? "by the Abel integral"
                              : "by the batch rule";
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
    if (const auto p = solved_->closed_form(right, left)) {
        place.exact_p = *p;
        place.p = place.exact_p.convert_to<double>();
        return place;
    }
    try {
        place.exact_p = solved_->pressure(contact::Point<Real>{right, left, x});
        place.p = place.exact_p.convert_to<double>();
    } catch (const DomainError&) { // on a corner
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
    return solved_->shear->at({right, left, x}, place.exact_p).convert_to<double>();
}

double ExactContact::pressure(double x) const { return at(Real(x)).p.value_or(scale_.value); }

namespace {

constexpr unsigned traction_digits = 20;
constexpr unsigned zone_digits = 40;
constexpr unsigned slip_digits = 16; ///< for PartialSlip, which needs a quadrature for each place

} // namespace

struct ExactShear::Solved {
    Solved(const scene::Scene& asked, const contact::Profile& shape,
           const contact::Extent<Real>& extent, const Real& normal)
        : spec(*asked.shear), profile(shape), axisymmetric(asked.round.has_value()), whole(extent),
          P(normal), load{spec.Q.to<Real>(), spec.bulk_tension.to<Real>()} {
        if (!spec.friction) {
            return;
        }
        friction = spec.friction->to<Real>();
        if (asked.history) {
            most_force =
                Real(friction * asked.history->layers.back().force.to<Real>()).convert_to<double>();
            after_steps = std::make_unique<scene::SceneValues>(
                asked, std::vector{traction_at(formula::Expr::number(Rational(0)))},
                scene::Digits{traction_digits, Rounding::nearest, false});
            return;
        }
        friction *= spec.Q.sign();
        scene::Scene zone = asked;
        zone.ask = {};
        zone.ask.quantities = {scene::QuantityGroup::slip};
        zone.ask.digits = {zone_digits, Rounding::nearest, false};
        const scene::SceneResult result = run_scene(zone);
        stick = {result.at(scene::Quantity::stick_a).value.midpoint(),
                 result.at(scene::Quantity::stick_b).value.midpoint()};
        if (spec.bulk_tension.sign() != 0 && profile.symmetric()) {
            normal_contact.emplace(profile, asked.contact_modulus, asked.load, slip_digits);
            slip.emplace(*normal_contact, spec);
            return;
        }
        const PrecisionScope scope(zone_digits + 20);
        if (profile.axisymmetric()) {
            const contact::AxisymmetricContact contact(profile, asked.contact_modulus, asked.load,
                                                       formula::bits_for(contact_digits));
            by_abel = contact.with_radius(Ball(stick.a, contact.bits()));
            return;
        }
        stick_pressure.emplace(profile, asked.contact_modulus.to<Real>(), stick, traction_digits);
    }
    /// The question about q at the place x.
    static scene::AskedValue traction_at(const formula::Expr& x) {
        scene::AskedValue asked;
        asked.quantity = scene::Quantity::q;
        asked.place = scene::Distance(formula::Expr::symbol("a") - x, x);
        return asked;
    }
    /// The pressure of the stick zone, in which the place lies.
    [[nodiscard]] Real pressure(const contact::Point<Real>& place) const {
        return by_abel ? abel_pressure(*by_abel, profile, place) : (*stick_pressure)(place).value;
    }

    contact::ShearSpec spec;
    contact::Profile profile;
    bool axisymmetric;
    contact::Extent<Real> whole;
    Real P;
    contact::ShearLoad<Real> load;
    Real friction; ///< in the direction of Q
    contact::Extent<Real> stick{};
    std::optional<contact::BatchPressure> stick_pressure;
    std::optional<contact::AxisymmetricContact> by_abel; ///< as in ExactContact
    std::optional<contact::NormalContact> normal_contact;
    std::optional<contact::PartialSlip> slip;
    std::unique_ptr<scene::SceneValues> after_steps; ///< if the scene has a load history
    double most_force = 0;                           ///< f P, in this case
};

ExactShear::ExactShear(const scene::Scene& scene, const contact::Profile& profile,
                       const contact::Extent<Real>& whole, const Real& force)
    : solved_(std::make_shared<Solved>(scene, profile, whole, force)) {}

Real ExactShear::at(const contact::Point<Real>& place, const Real& p) const {
    const Solved& s = *solved_;
    if (s.slip) {
        const bool right = place.right <= place.left;
        return s.slip->traction(right ? contact::Edge::right : contact::Edge::left,
                                formula::Exact(formula::Expr::number(exact_rational(
                                    (right ? place.right : place.left).convert_to<double>()))));
    }
    if (s.after_steps) {
        const auto x = formula::Expr::number(contact::exact_value(place.x));
        return s.after_steps->value(Solved::traction_at(x)).value.midpoint();
    }
    if (s.spec.path == contact::LoadingPath::together) {
        return s.load.Q / s.P * p;
    }
    if (!s.spec.friction) {
        return contact::full_stick_traction(place, s.load);
    }
    const Real right = s.stick.a - place.x;
    const Real left = s.stick.b + place.x;
    if (!(right > 0) || !(left > 0)) {
        return s.friction * p;
    }
    return s.friction * (p - s.pressure({right, left, place.x}));
}

double ExactShear::scale() const {
    const Solved& s = *solved_;
    const double length = s.whole.length().convert_to<double>();
    const double area = s.axisymmetric ? std::acos(-1) * length * length / 4 : length;
    if (s.after_steps) {
        return s.most_force / area;
    }
    return std::abs(force()) / area + std::abs(s.load.bulk_tension.convert_to<double>()) / 4;
}
std::string ExactShear::scale_text() const {
    const std::string area = solved_->axisymmetric ? "(pi a^2)" : "(a + b)";
    return solved_->after_steps    ? "f P/" + area
           : solved_->axisymmetric ? "|Q|/" + area
                                   : "|Q|/" + area + " + |bulk_tension|/4";
}
double ExactShear::force() const { return solved_->load.Q.convert_to<double>(); }
std::vector<double> ExactShear::stick_edges() const {
    const Solved& s = *solved_;
    return s.spec.friction && !s.after_steps
               ? std::vector{s.stick.a.convert_to<double>(), Real(-s.stick.b).convert_to<double>()}
               : std::vector<double>();
}
bool ExactShear::singular() const {
    return !solved_->spec.friction && solved_->spec.path != contact::LoadingPath::together;
}

} // namespace edgeproof::comparison
