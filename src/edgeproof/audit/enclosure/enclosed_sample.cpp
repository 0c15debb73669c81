// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"

#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/stress/axisymmetric_stress.hpp"
#include "edgeproof/precision/rounding/text.hpp"

namespace edgeproof::audit {

EnclosedSample::EnclosedSample(Sample sample, long bits, unsigned integral_digits)
    : sample_(std::move(sample)), bits_(bits), integral_digits_(integral_digits),
      scene_(sample_.scene.as_scene()), profile_(*scene_->profile),
      contact_(sample_.scene.contact(bits_)) {
    if (contact_->closed_form() == nullptr &&
        contact::monotonicity_of_slope(profile_, contact_->a(), contact_->b()).kind !=
            contact::SlopeMonotonicity::Kind::rises) {
        throw Error("a slope that is not proved to rise over the contact has no enclosure");
    }
    for (const auto& [name, value] : sample_.scene.names()) {
        names_.emplace(name, ball_of(value, bits_));
    }
    for (const auto& [name, value] : sample_.variables) {
        names_.insert_or_assign(name, ball_of(value, bits_));
    }
    if (sample_.fraction) {
        u_.emplace(ball_of(*sample_.fraction, bits_) * length());
    }
}

Ball EnclosedSample::finite(const Expr& e) const {
    Ball value = evaluate(e);
    if (!value.is_finite()) {
        throw BudgetError("the balls do not exclude a point where it is undefined");
    }
    return value;
}

void EnclosedSample::set(const std::string& name, const Ball& value) {
    names_.insert_or_assign(name, value);
    overridden_.insert(name);
    slip_.reset();
    integrals_.clear();
}

void EnclosedSample::set_place(Edge edge, const Ball& u) {
    sample_.edge = edge;
    u_ = u;
    integrals_.clear();
}

Ball EnclosedSample::symbol(std::string_view name) const {
    if (const auto it = names_.find(name); it != names_.end()) {
        return it->second;
    }
    if (formulas_ && formulas_->constants().contains(name)) {
        return formulas_->constants().find(name)->second;
    }
    if (name == "u" || name == "x") {
        if (!u_) {
            throw Error("no place is given");
        }
        return name == "u" ? *u_ : x();
    }
    if (const auto value = quantity(name)) {
        return *value;
    }
    throw Error("'" + std::string(name) + "' has no enclosure");
}

std::optional<Ball> EnclosedSample::quantity(std::string_view name) const {
    if (name == "a" || name == "b") {
        return name == "a" ? contact().a() : contact().b();
    }
    if (name == "Es") {
        return ball_of(scene_->contact_modulus, bits_);
    }
    if (name == "L") {
        return length();
    }
    if (name == "P") {
        return axisymmetric() ? ball_of(*scene_->round->force, bits_) : contact().force();
    }
    if (axisymmetric() && name == "delta") {
        return ball_of(*scene_->round->approach, bits_);
    }
    if (name == "M") {
        return contact().moment();
    }
    if (is_greatest(name) || name == "p_max") {
        return greatest(name == "p_max" ? name : name.substr(name.find('_') + 1));
    }
    if (const auto k = order_behind(name, "P")) {
        return force_derivative(*k);
    }
    if (const auto k = order_behind(name, "b")) {
        return left_edge_derivative(*k);
    }
    for (const Edge edge : {Edge::right, Edge::left}) {
        const bool right = edge == Edge::right;
        const std::string side = right ? "right_" : "left_";
        if (const auto k = order_behind(name, side + "c")) {
            return coefficient(edge, *k);
        }
        if (const auto k = order_behind(name, side + "s")) {
            return full_stick_expansion(length(), load(), edge, *k + 1).back();
        }
        if (slips() && name == side + "d") {
            return partial_slip().proved.slip().size(edge);
        }
        if (slips() && name == (right ? "stick_a" : "stick_b")) {
            return partial_slip().proved.slip().stick().at(edge);
        }
    }
    return std::nullopt;
}

const EnclosedSample::PartialSlip& EnclosedSample::partial_slip() const {
    if (!slip_) {
        const Exact& modulus = scene_->contact_modulus;
        const contact::ShearLoad<Ball> shear = load();
        const auto force =
            axisymmetric() ? std::optional(ball_of(*scene_->round->force, bits_)) : std::nullopt;
        slip_.reset(new PartialSlip{contact::ProvedSlip(profile_, modulus, scene_->load, shear,
                                                        symbol("friction"), bits_, force),
                                    {}});
        const contact::ProvedSlip& proved = slip_->proved;
        if (proved.slip().admissible()) {
            const Ball& tension = shear.bulk_tension;
            slip_->parts.emplace(proved.slip(), plane(), profile_, modulus,
                                 !tension.is_exact() || !contains_zero(tension));
        }
    }
    if (!slip_->parts) {
        throw Error("no partial slip: the contact slides, or the stick zone leaves it");
    }
    return *slip_;
}

Ball EnclosedSample::poisson() const {
    for (const char* const name : {"nu", "nu1"}) {
        if (const auto it = names_.find(name); it != names_.end()) {
            return it->second;
        }
    }
    throw Error("a stress that depends on Poisson's ratio: add nu to the family");
}

contact::StressState EnclosedSample::stresses(const Expr& written, const Ball& x,
                                              const Ball& z) const {
    if (arb_is_nonnegative(z.data()) == 0) {
        throw DomainError("a stress at a depth that may be negative");
    }
    const bool sheared = names_.contains("Q") || names_.contains("sig0");
    if (axisymmetric()) {
        if (sheared) {
            throw Error("the stresses of a body of revolution are enclosed without shear");
        }
        const contact::AxisymmetricStress field(contact(), *quantity("P"), poisson());
        const bool on_axis = arb_is_zero(x.data()) != 0;
        contact::StressState at =
            on_axis ? field.on_axis(z)
            : arb_is_zero(z.data()) != 0
                ? field.on_surface(abs(x), constant(Expr::call("abs", {written})))
                : field.inside(abs(x), z);
        if (!on_axis && !certainly_positive(x)) {
            at.sxz = certainly_negative(x) ? -at.sxz : Ball::hull(at.sxz, -at.sxz);
        }
        return at;
    }
    const Box zeta(x, z);
    const contact::CauchyIntegral p = plane().cauchy_integral(zeta);
    contact::CauchyIntegral q = p * Ball(0, z.bits());
    if (slips()) {
        q = partial_slip().parts->integral(p, zeta);
    } else if (sheared) {
        q = cauchy_integral(contact::Extent<Ball>{contact().a(), contact().b()}, load(), zeta);
    }
    return stress_of(p, q, zeta, Ball(0, z.bits()));
}

Ball EnclosedSample::stress(const Expr& call, const Ball& x, const Ball& z) const {
    const contact::StressState at = stresses(call.arg(0), x, z);
    const std::string& name = call.name();
    return name == "sxx"       ? at.sxx
           : name == "szz"     ? at.szz
           : name == "sxz"     ? at.sxz
           : name == "tau_max" ? at.tau_max()
           : name == "syy"     ? at.syy(poisson())
           : name == "mises"   ? at.mises(poisson())
           : name == "tresca"  ? at.tresca(poisson())
                              : at.principal(poisson()).at(static_cast<std::size_t>(name[1] - '1'));
}

Ball EnclosedSample::greatest(std::string_view name) const {
    for (const std::string& given : overridden_) {
        if (sample_.scene.parameters.contains(given)) {
            throw Error("a greatest value has an enclosure for exact loads only");
        }
    }
    const bool of_place = name.ends_with("_x") || name.ends_with("_z");
    const auto stress = name == "p_max"
                            ? scene::Quantity::p_max
                            : scene::greatest_of(name.substr(0, name.size() - (of_place ? 2 : 0)));
    const auto digits = static_cast<unsigned>(std::max(10L, bits_ * 3 / 10 - 10));
    const auto found = sample_.scene.greatest(stress, digits);
    return !of_place ? found->value.value : name.ends_with("x") ? found->x.value : found->z.value;
}

Ball EnclosedSample::slip(const Ball& x) const {
    const PartialSlip& slip = partial_slip();
    if (!certainly_positive(contact().a() - x) || !certainly_positive(x + contact().b())) {
        throw DomainError("the slip at a place that may be outside the contact");
    }
    const auto& [zone, ratio] = slip.parts->parts.front();
    return ratio * zone->gap_at(x);
}

namespace {

/// The names of a slope.
struct AtPlace : formula::BallConstants {
    Ball x;
    [[nodiscard]] Ball symbol(std::string_view name) const {
        return name == "x" ? x : BallConstants::symbol(name);
    }
};

} // namespace

Ball EnclosedSample::slope(const Ball& x) const {
    const auto in_piece = [&](std::size_t piece) {
        return formula::evaluate<Ball>(profile_.pieces()[piece].slope, AtPlace{{bits_}, x});
    };
    std::size_t first = 0;
    std::size_t last = 0;
    for (const Exact& knot : profile_.knots()) {
        const Ball k = ball_of(knot, bits_);
        first += certainly_less(k, x) ? 1 : 0;
        last += certainly_less(x, k) ? 0 : 1;
    }
    Ball g = in_piece(first);
    while (first < last) {
        g = Ball::hull(g, in_piece(++first));
    }
    return g;
}

Ball EnclosedSample::gap(const Ball& x) const {
    const Ball beyond = x - contact().a();
    if (!certainly_positive(beyond) &&
        (axisymmetric() || !certainly_positive(-x - contact().b()))) {
        throw DomainError("the gap at a place that may be inside the contact");
    }
    return axisymmetric() ? axisymmetric_gap(closed_form("gap"), beyond) : plane().gap_at(x);
}

Ball EnclosedSample::call(const Expr& node, std::span<const Ball> args) const {
    const std::string& name = node.name();
    if (name == "p") {
        return pressure(node.arg(0), args[0]);
    }
    if (name == "q") {
        return traction(node.arg(0), args[0]);
    }
    if (name == "g1") {
        return slope(args[0]);
    }
    if (name == "gap") {
        return gap(args[0]);
    }
    if (is_stress(name)) {
        return stress(node, args[0], args[1]);
    }
    if (name == "slip") {
        return slip(args[0]);
    }
    if (name == "right_local") {
        return local(Edge::right, node, args);
    }
    if (name == "left_local") {
        return local(Edge::left, node, args);
    }
    if (name == "Pof" || name == "P1of" || name == "bof") {
        const contact::BallContact other = with_right_edge(name, node.arg(0), args[0]);
        return name == "Pof"    ? other.force()
               : name == "P1of" ? other.force_derivatives(2).back()
                                : other.b();
    }
    if (name == "exit" || name == "measure" || name == "best") {
        return reach(node);
    }
    if (name == "binv" && certainly_positive(args[0])) {
        return closed_form(name).mirrored().with_right_edge(args[0]).b();
    }
    throw Error("'" + name + "' has no enclosure");
}

std::optional<Ball> EnclosedSample::elsewhere(const Expr& call) const {
    if (call.name() == "next") {
        if (!sample_.next) {
            throw Error("next(f) has a value only in a claim with the key `along`");
        }
        if (!next_) {
            next_ = std::make_unique<EnclosedSample>(*sample_.next, bits_, integral_digits_);
        }
        return next_->evaluate(call.arg(0));
    }
    if (call.name() != "given") {
        return std::nullopt;
    }
    const std::string name = call.arg(1).kind() == Expr::Kind::symbol ? call.arg(1).name() : "";
    Sample other = sample_;
    const bool variable = other.variables.contains(name);
    const auto exact = constant(call.arg(2));
    if (!variable && !other.scene.parameters.contains(name)) {
        throw Error("given(...) needs a parameter of the family or a name of `vary`");
    }
    if (exact) {
        (variable ? other.variables[name] : other.scene.parameters[name]) = *exact;
    } else if (!variable && name != "Q" && name != "sig0") {
        throw Error("given(...) needs a number for a parameter of the profile");
    }
    EnclosedSample there(other, bits_, integral_digits_);
    for (const std::string& own : overridden_) {
        there.set(own, names_.at(own));
    }
    if (!exact) {
        there.set(name, formula::evaluate<Ball>(call.arg(2), *this));
    }
    if (u_) {
        there.set_place(sample_.edge, *u_);
    }
    return there.evaluate(call.arg(0));
}

namespace {

/// The names that ContactFormulas use.
constexpr const char* names_of_formulas[] = {"a", "b", "Q", "sig0"};

} // namespace

template <class Use> auto EnclosedSample::in_surroundings(const Expr& node, const Use& use) const {
    if (slips() && holds_call(node, "q")) {
        throw Error("q of partial slip has no enclosure inside an integral");
    }
    const bool renamed = std::ranges::any_of(names_of_formulas,
                                             [&](const char* name) {
                                                 return sample_.variables.contains(name) ||
                                                        node.arg(1).name() == name;
                                             }) ||
                         sample_.scene.parameters.contains("b");
    const bool with_contact = !renamed && holds_function(node);
    if (with_contact && !formulas_) {
        formulas_.emplace(profile_, closed_form("an integral"),
                          ball_of(scene_->contact_modulus, bits_));
    }
    // Limits such as k*a with k = 1 are compared with the edges by symbols.
    Expr with_values = node;
    for (const auto& [name, value] : sample_.variables) {
        if (!overridden_.contains(name)) {
            with_values = substitute(with_values, name, value.expr());
        }
    }
    IntegralSurroundings around;
    around.value = [&](const Expr& e) { return evaluate(e); };
    around.rational = [&](const Expr& e) -> std::optional<Rational> {
        const auto exact = constant(e);
        return exact && exact->is_rational() ? std::optional(exact->rational()) : std::nullopt;
    };
    around.contact = with_contact ? &*formulas_ : nullptr;
    around.law = profile_.symmetric() && !renamed ? EdgeLaw::symmetric : EdgeLaw::any;
    around.bits = bits_;
    return use(with_values, around);
}

Ball EnclosedSample::integral(const Expr& node) const {
    if (const auto known = integrals_.find(node); known != integrals_.end()) {
        if (const auto* problem = std::get_if<std::exception_ptr>(&known->second)) {
            std::rethrow_exception(*problem);
        }
        return std::get<Ball>(known->second);
    }
    try {
        const Ball value =
            in_surroundings(node, [&](const Expr& e, const IntegralSurroundings& around) {
                return enclosed_integral(e, around, integral_digits_);
            });
        integrals_.emplace(node, value);
        return value;
    } catch (...) {
        integrals_.emplace(node, std::current_exception());
        throw;
    }
}

bool EnclosedSample::diverges(const Expr& node) const {
    try {
        return in_surroundings(node, certainly_divergent);
    } catch (const Error&) {
        return false; // no enclosure of the integrand
    }
}

std::optional<Exact> exact_value(Expr e, const Sample& sample) {
    for (const auto& [name, value] : sample.variables) {
        e = substitute(e, name, value.expr());
    }
    for (const auto& [name, value] : sample.scene.parameters) {
        e = substitute(e, name, value.expr());
    }
    if (!free_symbols(e).empty() || holds_function(e)) {
        return std::nullopt;
    }
    return Exact(e);
}

std::string ball_text(const Ball& ball, unsigned digits) {
    // These exponents are not allowed for numbers in a text.
    constexpr long most_exponent = 330'000; // of two: about 1e100000
    const long exponent = arf_abs_bound_lt_2exp_si(arb_midref(ball.data()));
    if (exponent > most_exponent || (exponent < -most_exponent && !contains_zero(ball))) {
        return exponent > 0 ? "beyond 1e100000" : "within 1e-100000 of 0";
    }
    if (!ball.is_exact() && contains_zero(ball)) {
        return "0 +- " + bound_text(abs(ball).upper());
    }
    // Only two digits that the radius makes uncertain are shown.
    const long known =
        std::min(ball.relative_accuracy_bits(), formula::bits_for(digits)) * 301 / 1000 + 2;
    const Rounded middle =
        round_ball(Ball(ball.midpoint(), ball.bits()),
                   static_cast<unsigned>(std::clamp(known, 1L, static_cast<long>(digits))));
    // The rounding of the middle for the text is part of the error.
    const Ball off = abs(ball - Ball(middle.value.value(), ball.bits()));
    return middle.text + " +- " + bound_text(off.upper());
}

} // namespace edgeproof::audit
