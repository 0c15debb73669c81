// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/double_word/double_word_shear.hpp"

#include <utility>

namespace edgeproof::contact {

DoubleWordShear::DoubleWordShear(Form form, bool in_range)
    : form_(std::move(form)), in_range_(in_range),
      kernel_(DoubleWordKernel<DoubleWordShear>::chosen()) {}

DoubleWordShear DoubleWordShear::full_stick(const BallContact& contact,
                                            const ShearLoad<Ball>& load) {
    // eqn:Shear_Adhered: Q/pi and sigma_0/8
    const Ball length = contact.a() + contact.b();
    const FullStick form{to_precise_word(length), to_double_word(load.Q / Ball::pi(contact.bits())),
                         to_double_word(load.bulk_tension / 8)};
    return {form, in_double_words_as_constant(form.length.first) &&
                      in_double_words_as_constant(form.Q_over_pi) &&
                      in_double_words_as_constant(form.tension)};
}

DoubleWordShear DoubleWordShear::similar(DoubleWordPressure pressure, const Ball& ratio) {
    const DoubleWord word = to_double_word(ratio);
    const bool in_range = pressure.in_range() && in_double_words_as_factor(word);
    return {Similar{std::move(pressure), word}, in_range};
}

DoubleWordShear DoubleWordShear::partial_slip(const Profile& profile, const BallContact& contact,
                                              const BallZone& stick, const Ball& traction) {
    const BallContact zone = contact.between(stick.a, stick.b);
    const Ball right = contact.a() - stick.a;
    const Ball left = contact.b() - stick.b;
    Slip form{{profile, contact},
              {profile, zone, contact},
              to_double_word(traction),
              {to_precise_word(right), to_precise_word(contact.b() + stick.a)},
              {to_precise_word(contact.a() + stick.b), to_precise_word(left)},
              {to_double_word(right), to_double_word(left), {}}};
    if (contact.piecewise_linear()) {
        form.zones.arc = to_double_word(contact.arc() - zone.arc());
    }
    // The arcs of a parabola are equal, so that their difference may be known only as a small ball
    // about 0.
    bool in_range = form.pressure.in_range() && form.stick.in_range() &&
                    in_double_words_as_constant(form.friction) &&
                    double_word::most(form.zones.arc) < 0x1p100;
    for (const DoubleWordMark& mark : {form.right, form.left}) {
        in_range = in_range && in_double_words_as_constant(mark.inset.first) &&
                   in_double_words_as_constant(mark.outset.first);
    }
    return {std::move(form), in_range};
}

DoubleWord DoubleWordShear::formula(Edge edge, const DoubleWord& u) const {
    if (const auto* stick = std::get_if<FullStick>(&form_)) {
        return stick->at(edge, u);
    }
    if (const auto* similar = std::get_if<Similar>(&form_)) {
        return similar->at(edge, u);
    }
    return std::get_if<Slip>(&form_)->at(edge, u);
}

} // namespace edgeproof::contact
