// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/double_word/double_word_pressure.hpp"

namespace edgeproof::contact {
namespace {

/// The bounds hold for this many operations in sequence (docs/double-words.md, lemma 2).
constexpr std::size_t most_knots = 10'000;

/// Returns the distance of a knot inwards from an edge. An exactly known distance has a radius only
/// if it needs more bits than the contact has.
Ball distance_of_knot(const Profile& profile, const BallContact& contact, Edge edge,
                      std::size_t i) {
    const bool right = edge == Edge::right;
    if (const auto& end = contact.known(edge)) {
        const formula::Expr knot = profile.knots()[i].expr();
        const formula::Expr distance = right ? end->expr() - knot : end->expr() + knot;
        if (const Rational* exact = distance.rational()) {
            return {*exact, contact.bits()};
        }
    }
    const Ball& knot = contact.slope().knots[i];
    return right ? contact.a() - knot : contact.b() + knot;
}

DoubleWordSlope slope_of(const Profile& profile, const BallContact& contact,
                         const BallContact& whole) {
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
            i,
            {to_precise_word(distance_of_knot(profile, whole, Edge::right, i)),
             to_precise_word(distance_of_knot(profile, whole, Edge::left, i))},
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

bool DoubleWordPressure::has_form(const Profile& profile) {
    return profile.piecewise_linear() ||
           (profile.has_closed_form() && DoubleWordPowerLaw::has(profile.parameters().at("m")));
}

DoubleWordPressure::DoubleWordPressure(const Profile& profile, const BallContact& contact,
                                       const BallContact& whole)
    : length_(to_precise_word(contact.a() + contact.b())), form_([&]() -> decltype(form_) {
          if (contact.piecewise_linear()) {
              return slope_of(profile, contact, whole);
          }
          return DoubleWordPowerLaw(profile.parameters().at("m"), contact, whole);
      }()),
      in_range_(in_double_words_as_constant(length_.first) &&
                std::visit([](const auto& form) { return contact::in_range(form); }, form_) &&
                contact.slope().knots.size() <= most_knots),
      kernel_(DoubleWordKernel<DoubleWordPressure>::chosen()) {}

} // namespace edgeproof::contact
