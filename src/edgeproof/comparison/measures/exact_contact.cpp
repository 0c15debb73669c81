// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/measures/exact_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/precision.hpp"
#include "edgeproof/quadrature/theta_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgeproof::comparison {
namespace {

constexpr unsigned contact_digits = 40;
constexpr std::size_t coefficients = 3;
constexpr double on_a_corner = 1e-15; ///< relative to a + b
/// The same: within it, a distance from an edge in binary64 has too few digits for p.
constexpr double near_a_corner = 1e-3;

/// Everything that is asked about a scene.
std::vector<scene::AskedValue> questions_about(const scene::Scene& scene) {
    using scene::Quantity;
    std::vector<scene::AskedValue> all{{Quantity::a},
                                       {Quantity::b},
                                       {Quantity::P},
                                       {Quantity::c, coefficients - 1},
                                       asked_at(Quantity::p, Real(0))};
    if (scene.punch) {
        all.push_back({Quantity::alpha});
    }
    if (scene.shear) {
        all.push_back(asked_at(Quantity::q, Real(0)));
    }
    return all;
}

/// True if g' changes its formula there: the origin of a parabola is a knot without a change.
bool bends(const contact::Profile& profile, std::size_t knot) {
    const auto& before = profile.pieces()[knot].linear;
    const auto& behind = profile.pieces()[knot + 1].linear;
    return !before || !behind || profile.has_corner(knot) ||
           !contact::certainly_zero(before->rate - behind->rate);
}

} // namespace

scene::AskedValue asked_at(scene::Quantity quantity, const Real& x) {
    const auto place = formula::Expr::number(contact::exact_value(x));
    return {.quantity = quantity,
            .place = scene::Distance(formula::Expr::symbol("a") - place, place)};
}

ExactContact::ExactContact(const scene::Scene& scene) : scene_(scene) {
    if (scene.curved_body()) {
        throw InputError("compare does not compute curved slopes of revolution",
                         "give a power law or a piecewise linear g'")
            .at(scene.file, scene.profile_line);
    }
    io::at_place(scene.file, scene.load_line, [&] { solve(); });
}

ExactValue ExactContact::value(const scene::AskedValue& asked) const {
    const PrecisionScope scope(place_digits);
    const scene::BoundedValue found = values_->value(asked);
    return {found.value.midpoint().convert_to<double>(), found.how()};
}

void ExactContact::solve() {
    const PrecisionScope scope(place_digits);
    values_ = std::make_unique<scene::SceneValues>(
        scene_, questions_about(scene_), scene::Digits{contact_digits, Rounding::nearest, false});
    const auto number = [&](scene::Quantity quantity) {
        return values_->value({quantity}).value.midpoint();
    };
    a_ = value({scene::Quantity::a});
    b_ = value({scene::Quantity::b});
    force_ = value({scene::Quantity::P});
    right_ = number(scene::Quantity::a);
    left_ = number(scene::Quantity::b);
    profile_ = scene_.profile ? *scene_.profile
                              : scene_.punch->at(formula::Exact(formula::Expr::number(
                                    contact::exact_value(number(scene::Quantity::alpha)))));
    const contact::Profile& profile = *profile_;
    if (!profile.has_closed_form() && !profile.axisymmetric()) {
        quick_.emplace(profile, scene_.contact_modulus.to<double>(), a_.value, b_.value);
    }
    symmetric_ = profile.symmetric();
    axisymmetric_ = scene_.round.has_value();
    if (scene_.shear) {
        find_shear();
    }
    radius_ = {length(), length()};
    for (std::size_t i = 0; i < profile.knots().size(); ++i) {
        const Real x = profile.knots()[i].to<Real>();
        for (const auto& [edge, from] : {std::pair{contact::Edge::right, Real(right_ - x)},
                                         {contact::Edge::left, Real(left_ + x)}}) {
            double& radius = radius_[index_of(edge)];
            radius = from > 0 ? std::min(radius, from.convert_to<double>()) : radius;
        }
        if (x < right_ && x > -left_ && bends(profile, i)) {
            knots_.push_back({x.convert_to<double>(), profile.has_corner(i)});
        }
    }
}

ExactValue ExactContact::c(contact::Edge edge, std::size_t k) const {
    std::vector<ExactValue>& known = c_[index_of(edge)];
    while (known.size() <= k) {
        known.push_back(value({scene::Quantity::c, known.size(), edge}));
    }
    return known[k];
}

const ExactContact::Scale& ExactContact::scale() const {
    if (!scale_) {
        const bool mean = std::ranges::any_of(knots_, &ContactKnot::corner);
        scale_ = mean ? Scale{force_.value / area(), true}
                      : Scale{value({scene::Quantity::p_max}).value, false};
    }
    return *scale_;
}

std::string ExactContact::pressure_route() const {
    return axisymmetric_                 ? "by the Abel integral"
           : profile().has_closed_form() ? "in closed form"
                                         : "by rigorous integration";
}

double ExactContact::area() const {
    return axisymmetric_ ? std::acos(-1) * a_.value * a_.value : length();
}

double ExactContact::force_width(double x) const {
    return axisymmetric_ ? std::acos(-1) * std::abs(x) : 1;
}

ExactContact::Place ExactContact::at(const Real& x) const {
    const PrecisionScope scope(place_digits);
    Place place{
        Real(right_ - x).convert_to<double>(), Real(left_ + x).convert_to<double>(), {}, {}};
    const auto corner_within = [&](double share) {
        return place.inside() && std::ranges::any_of(knots_, [&](const ContactKnot& knot) {
                   return knot.corner && abs(Real(x - knot.x)) <= share * length();
               });
    };
    place.on_corner = corner_within(on_a_corner);
    if (corner_within(near_a_corner)) {
        place.near_corner = x;
    }
    return place;
}

std::optional<double> ExactContact::p(const Place& place) const {
    if (!place.inside()) {
        return 0.0;
    }
    return place.on_corner ? std::nullopt : traction(scene::Quantity::p, place, pressures_);
}

std::optional<double> ExactContact::q(const Place& place) const {
    const double at_edge = length() * 1e-12; // the resolution of a place in binary64
    if (!shear_ || (shear_->singular && std::abs(place.u()) < at_edge)) {
        return {};
    }
    if (!place.inside()) {
        return 0.0;
    }
    return place.on_corner && !shear_->singular ? std::nullopt
                                                : traction(scene::Quantity::q, place, tractions_);
}

std::optional<double> ExactContact::traction(scene::Quantity quantity, const Place& place,
                                             std::optional<scene::Binary64Values>& values) const {
    try {
        if (place.near_corner) {
            return value(asked_at(quantity, *place.near_corner)).value;
        }
        if (!values) {
            const bool p = quantity == scene::Quantity::p;
            values.emplace(p ? scene_.without_shear() : scene_, scene::Binary64Question{quantity});
        }
        const double found = (*values)(place.nearer(), place.u());
        return std::isfinite(found) ? std::optional(found) : std::nullopt;
    } catch (const Error&) { // on a knot of the stick zone, where balls do not enclose q
        return {};
    }
}

std::optional<double> ExactContact::quick_pressure(double x) const {
    const auto found = quick_ && x < a_.value && x > -b_.value ? quick_->at(x) : std::nullopt;
    return found ? found : p(at(Real(x)));
}

double ExactContact::pressure(double x) const { return quick_pressure(x).value_or(scale().value); }

void ExactContact::find_shear() {
    const contact::ShearSpec& spec = *scene_.shear;
    const std::string area_text = axisymmetric_ ? "(pi a^2)" : "(a + b)";
    ExactShear& shear = shear_.emplace();
    shear.force = spec.force([](const formula::Exact& x) { return x.to<double>(); },
                             [&] { return value({scene::Quantity::P}).value; });
    shear.singular = !scene_.slips() && !scene_.proportional();
    if (scene_.history) {
        shear.scale =
            spec.friction->to<double>() * scene_.history->layers.back().force.to<double>() / area();
        shear.scale_text = "f P/" + area_text;
        return;
    }
    shear.scale = std::abs(shear.force) / area() + std::abs(spec.bulk_tension.to<double>()) / 4;
    shear.scale_text = "|Q|/" + area_text + (axisymmetric_ ? "" : " + |bulk_tension|/4");
    if (spec.friction) {
        shear.stick_edges = {value({scene::Quantity::stick_a}).value,
                             -value({scene::Quantity::stick_b}).value};
    }
}

namespace {

constexpr std::array<std::size_t, 2> nodes_of_a_piece{32, 64};
constexpr double most_difference = 1e-9; ///< between both rules, of p
constexpr unsigned digits_of_slope = 20;

} // namespace

// eqn:SIEPressure with its principal value taken out (docs/curved-slopes.md, "What is integrated"):
// p = E*/(2 pi) w(x) times the integral of (g'(s) - g'(x))/(s - x) over theta, s = c + d cos theta.
QuickPressure::QuickPressure(const contact::Profile& profile, double contact_modulus, double a,
                             double b)
    : slope_([&] {
          const PrecisionScope scope(digits_of_slope);
          return contact::RealSlope(profile);
      }()),
      factor_(contact_modulus / (2 * std::numbers::pi)), a_(a), b_(b) {
    const double centre = (a - b) / 2;
    const double half = (a + b) / 2;
    for (std::size_t k = 0; k < rules_.size(); ++k) {
        const auto rule = quadrature::gauss_legendre_balls(nodes_of_a_piece[k], 80);
        const auto add = [&](std::size_t piece, double from, double to) {
            for (std::size_t i = 0; i < rule->x.size(); ++i) {
                const double t = rule->x[i].midpoint().convert_to<double>();
                const double weight =
                    rule->weight[i].midpoint().convert_to<double>() * (to - from) / 2;
                for (const double side : {-1.0, 1.0}) {
                    const double theta = (from + to + side * t * (to - from)) / 2;
                    const double s = centre + half * std::cos(theta);
                    rules_[k].push_back({s, slope(piece, s), weight});
                }
            }
        };
        double from = 0; // theta, from the right edge
        for (std::size_t i = slope_.knots().size(); i-- > 0;) {
            const double knot = slope_.knots()[i].convert_to<double>();
            if (knot < a && knot > -b) {
                const double to = std::acos((knot - centre) / half);
                add(i + 1, from, to);
                from = to;
            }
        }
        add(slope_.piece_at(Real(std::nextafter(-b, a))), from, std::numbers::pi);
    }
}

double QuickPressure::slope(std::size_t piece, double x) const {
    const PrecisionScope scope(digits_of_slope);
    return slope_.value(piece, Real(x)).convert_to<double>();
}

std::optional<double> QuickPressure::at(double x) const {
    const double here = slope(slope_.piece_at(Real(x)), x);
    std::array<double, 2> sum{};
    for (std::size_t k = 0; k < rules_.size(); ++k) {
        for (const Node& node : rules_[k]) {
            sum[k] += node.weight * (node.slope - here) / (node.s - x);
        }
    }
    const bool agree = std::abs(sum[0] - sum[1]) <= most_difference * std::abs(sum[1]);
    return agree ? std::optional(factor_ * std::sqrt((a_ - x) * (x + b_)) * sum[1]) : std::nullopt;
}

} // namespace edgeproof::comparison
