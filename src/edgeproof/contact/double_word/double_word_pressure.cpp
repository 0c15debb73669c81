// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/double_word/double_word_pressure.hpp"

namespace edgeproof::contact {

namespace {

constexpr long bits = 256;
constexpr long coefficients = 400;
constexpr long largest_m = 64;

/// The coefficients of 2F1(1, (1 - n)/2; 3/2; y) (DLMF 15.2.1). The ratio of two,
/// (k + (1 - n)/2)/(k + 3/2), is below 1.
std::vector<Ball> edge_coefficients(const Rational& n) {
    std::vector<Ball> a{Ball(1, bits)};
    for (long k = 0; k + 1 < coefficients; ++k) {
        a.push_back(a.back() * Ball(Rational(2 * k + 1 - n), bits) / (2 * k + 3));
    }
    return a;
}
/// The coefficients beta_k/(n - 2k) (DLMF 15.8.4; docs/pressure.md, "Closed form: power laws"), at
/// most 2 in size, as beta_k <= 1 and n is 1/2 or 3/2.
std::vector<Ball> apex_coefficients(const Rational& n) {
    std::vector<Ball> a;
    Ball beta(1, bits);
    for (long k = 0; k < coefficients; ++k) {
        a.push_back(beta / Ball(Rational(n - 2 * k), bits));
        beta = beta * (2 * k + 1) / (2 * k + 2);
    }
    return a;
}
/// C = (sqrt(pi)/2) Gamma(-n/2)/Gamma((1 - n)/2) (DLMF 15.8.4).
DoubleWord apex_power(const Rational& n) {
    return to_double_word(sqrt(Ball::pi(bits)) / 2 * gamma(Ball(Rational(-n / 2), bits)) /
                          gamma(Ball(Rational((1 - n) / 2), bits)));
}

/// The bounds hold for this many operations in sequence (docs/double-words.md, lemma 2).
constexpr std::size_t most_knots = 10'000;

/// Returns the distance of a knot inwards from an edge. An exactly known distance has a radius only
/// if it needs more bits than the contact has.
Ball distance_of_knot(const Profile& profile, const BallContact& contact, Edge edge,
                      std::size_t i) {
    const bool right = edge == Edge::right;
    if (const auto& end = contact.known(edge)) {
        const Expr knot = profile.knots()[i].expr();
        const Expr distance = right ? end->expr() - knot : end->expr() + knot;
        if (const Rational* exact = distance.rational()) {
            return {*exact, contact.bits()};
        }
    }
    const Ball& knot = contact.slope().knots[i];
    return right ? contact.a() - knot : contact.b() + knot;
}

DoubleWordSlope slope_of(const Profile& profile, const BallContact& contact) {
    const LinearSlope<Ball>& slope = contact.slope();
    DoubleWordSlope words{{},
                          to_double_word(contact.arc()),
                          to_double_word(contact.a() + contact.b()),
                          to_double_word(contact.pressure_factor()),
                          &LogarithmTable::get()};
    for (std::size_t i = 0; i < slope.knots.size() && i < most_knots; ++i) {
        if (!contact.bends_inside(i)) {
            continue;
        }
        const Mark<Ball>& mark = contact.knot_marks()[i];
        DoubleWordSlope::Knot knot{
            {to_precise_word(distance_of_knot(profile, contact, Edge::right, i)),
             to_precise_word(distance_of_knot(profile, contact, Edge::left, i))},
            {to_double_word(mark.right), to_double_word(mark.left), {}, to_double_word(mark.w), {}},
            slope.has_corner(i),
            {},
            to_double_word(slope.rate_drop(i))};
        if (knot.corner) {
            knot.jump = to_double_word(slope.jump(i));
        }
        words.knots.push_back(knot);
    }
    return words;
}

bool in_range(const DoubleWordSlope& slope) {
    bool all = in_double_words_as_constant(slope.arc) && in_double_words_as_constant(slope.width) &&
               in_double_words_as_factor(slope.factor);
    for (const DoubleWordSlope::Knot& knot : slope.knots) {
        for (const DoubleWord& word : {knot.at.inset.first, knot.at.outset.first, knot.mark.right,
                                       knot.mark.left, knot.mark.w, knot.jump, knot.drop}) {
            all = all && in_double_words_as_constant(word);
        }
    }
    return all;
}
bool in_range(const DoubleWordPowerLaw& law) {
    bool all = in_double_words_as_factor(law.factor());
    for (const DoubleWord& word : law.constants()) {
        all = all && in_double_words_as_constant(word);
    }
    return all;
}

} // namespace

DoubleWordPowerLaw::Series::Series(const Rational& n)
    : edge(edge_coefficients(n), 1), apex(apex_coefficients(n), 2), power(apex_power(n)) {}

const DoubleWordPowerLaw::Series& DoubleWordPowerLaw::Series::of(Lowest n) {
    if (n == Lowest::half) {
        static const Series half(Rational(1, 2));
        return half;
    }
    static const Series three_halves(Rational(3, 2));
    return three_halves;
}

bool DoubleWordPowerLaw::has(const Exact& m) {
    return m.is_rational() && denominator(m.rational()) <= 2 && m.rational() <= largest_m;
}

DoubleWordPowerLaw::DoubleWordPowerLaw(const Exact& m, const BallContact& contact)
    : apex_{to_precise_word(contact.a()), to_precise_word(contact.b())},
      inverse_(to_double_word(1 / contact.a())),
      factor_(to_double_word(contact.pressure_factor())) {
    const auto halves = Rational(m.rational() * 2).convert_to<long>();
    n_ = static_cast<Lowest>(halves % 4);
    for (long k = halves % 4 + 4; k <= halves; k += 4) {
        steps_.push_back({to_double_word(Ball(Rational(2, k), bits)),
                          to_double_word(Ball(Rational(k - 2, k), bits))});
    }
    if (halves % 2 == 1) {
        series_ = &Series::of(n_);
    }
}

bool DoubleWordPressure::has_form(const Profile& profile) {
    return profile.piecewise_linear() ||
           (profile.has_closed_form() && DoubleWordPowerLaw::has(profile.parameters().at("m")));
}

DoubleWordPressure::DoubleWordPressure(const Profile& profile, const BallContact& contact)
    : length_(to_precise_word(contact.a() + contact.b())), form_([&]() -> decltype(form_) {
          if (contact.piecewise_linear()) {
              return slope_of(profile, contact);
          }
          return DoubleWordPowerLaw(profile.parameters().at("m"), contact);
      }()),
      in_range_(in_double_words_as_constant(length_.first) &&
                std::visit([](const auto& form) { return contact::in_range(form); }, form_) &&
                contact.slope().knots.size() <= most_knots),
      kernel_(DoubleWordKernel<DoubleWordPressure>::chosen()) {}

} // namespace edgeproof::contact
