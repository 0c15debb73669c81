// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/counts/sample.hpp"

#include "edgeproof/contact/witness/witness.hpp"

#include <algorithm>

namespace edgeproof::validation {
namespace {

using scene::Quantity;

constexpr unsigned look_digits = 20;

using Section = scene::SceneEntries::Section;
using Texts = std::vector<std::string>;

/// One in this many contacts has a curved g', whose integrals take minutes per contact. These are
/// not the last contacts of a count, for which the other threads would wait.
constexpr std::size_t curved_every = 2000;
constexpr std::size_t first_curved = 7;

// One draw per statement, so that all compilers draw the same values from a seed.
Section profile_entries(Dice& dice, std::size_t profile, const std::string& a) {
    const auto fraction = [&] { return std::to_string(dice.between(1, 98)) + "/99"; };
    switch (profile) {
    case 0: {
        static constexpr std::array<const char*, 9> exponents{"0",   "1",   "2",  "3",     "1/2",
                                                              "5/8", "7/3", "10", "1/1000"};
        const std::string C = dice.decimal(4, dice.between(-3, 1));
        return {{"kind", "power-law"}, {"m", exponents.at(dice.below(9))}, {"C", C}};
    }
    case 1: {
        static constexpr std::array<const char*, 4> odd{"1/1000000", "999999/1000000", "0", "1/2"};
        const std::string ratio = dice.below(4) == 0 ? odd.at(dice.below(4)) : fraction();
        const std::string R = dice.decimal(3, dice.between(0, 3));
        return {{"kind", "flat-and-rounded"}, {"t", ratio + "*" + a}, {"R", R}};
    }
    case 2: {
        static constexpr std::array<const char*, 3> angles{"pi/16", "1/10", "pi/3"};
        const std::string phi = angles.at(dice.below(3));
        const char* const side = dice.below(2) == 0 ? "" : "-";
        return {{"kind", "tilted-wedge"}, {"phi", phi}, {"alpha", side + fraction() + "*" + phi}};
    }
    case 3: {
        const std::string R = dice.decimal(3, 0);
        const std::string t = fraction();
        return {{"kind", "tilted-flat-and-rounded"},
                {"alpha", fraction() + "/20"},
                {"t", t + "*" + a},
                {"R", R + "*" + a}};
    }
    case 4: {
        // Convex for any steepness: each piece starts at the end of the one before.
        const auto outer = std::to_string(dice.between(1, 50));
        const auto right = std::to_string(dice.between(6, 30));
        const auto left = std::to_string(dice.between(6, 30));
        const auto last_knot = std::to_string(dice.between(2, 9));
        const auto first_knot = std::to_string(dice.between(2, 9));
        return {{"kind", "piecewise"},
                {"knots", Texts{"-" + a + "/" + first_knot, "0", a + "/" + last_knot}},
                {"slopes",
                 Texts{"-1/5", "-1/" + left, "1/" + right, "1/5 + x/(" + outer + "*" + a + ")"}}};
    }
    default: {
        const auto slope = std::to_string(dice.between(2, 30));
        const auto knot = std::to_string(dice.between(2, 5));
        return {
            {"kind", "piecewise"},
            {"symmetric", true},
            {"knots", Texts{a + "/" + knot}},
            {"slopes", Texts{"x/(" + slope + "*" + a + ")", "x/(2*" + a + ") + (x/" + a + ")^3"}}};
    }
    }
}

scene::SceneEntries drawn_entries(Dice& dice, std::size_t profile, bool by_force) {
    const std::string a = dice.decimal(3, dice.between(-3, 2));
    scene::SceneEntries entries{"", profile_entries(dice, profile, a), {}};
    entries.load.push_back(by_force ? io::TomlEntry{"P", dice.decimal(3, dice.between(-4, 2))}
                                    : io::TomlEntry{"a", a});
    static constexpr std::array<const char*, 3> moduli{"1", "7/3", "2.1e11"};
    entries.load.push_back({"contact_modulus", moduli.at(by_force ? 0 : dice.below(3))});
    const char* const side = dice.below(2) == 0 ? "" : "-";
    const std::string tension = dice.decimal(3, dice.between(-3, 1));
    const std::string Q = side + dice.decimal(3, dice.between(-3, 1));
    entries.shear = {{"Q", Q}, {"bulk_tension", tension}};
    return entries;
}

class Drawing {
public:
    Drawing(Dice& dice, SampledContact& contact) : dice_(dice), contact_(contact) {
        const scene::Scene& scene = contact.scene;
        const contact::Witness look(*scene.profile, scene.contact_modulus, scene.load, look_digits);
        const PrecisionScope scope(look_digits);
        a_ = look.a();
        b_ = look.b();
    }

    [[nodiscard]] SampledValue draw(std::size_t i) {
        // 50 values are 40 pressures, 5 coefficients, 3 shear, 2 of P or b.
        SampledValue v;
        v.asked.edge = dice_.below(2) == 0 ? contact::Edge::right : contact::Edge::left;
        const std::size_t turn = i % 10;
        if (turn == 3 && i % 20 == 3) {
            v.regime = 7;
            const bool point = dice_.below(2) == 0;
            v.asked.quantity = point ? Quantity::q : Quantity::s;
            v.asked.k = dice_.below(3);
            if (point) {
                (void)place(v, dice_.below(3));
            }
            return v;
        }
        if (turn == 3) {
            v.regime = 6;
            v.asked.edge = contact::Edge::right;
            v.asked.quantity = dice_.below(2) == 0 ? Quantity::P : Quantity::b;
            return v;
        }
        if (turn == 7) {
            v.regime = 5;
            v.asked.quantity = Quantity::c;
            v.asked.k = dice_.below(4);
            return v;
        }
        v.asked.quantity = Quantity::p;
        v.regime = place(v, dice_.below(5));
        return v;
    }

private:
    /// Sets u and returns its regime.
    std::size_t place(SampledValue& v, std::size_t wanted) {
        const bool right = v.asked.edge == contact::Edge::right;
        const PrecisionScope scope(look_digits);
        const Real own = right ? a_ : b_;
        const Real length = a_ + b_;
        if (wanted == 4 && by_knot(v, right)) {
            return 4;
        }
        // A decimal of six digits in that part of the contact.
        Real u = length;
        std::size_t regime = wanted;
        if (wanted == 0) {
            u = own * pow(Real(10), -dice_.between(13, 300));
        } else if (wanted == 1) {
            u = own * pow(Real(10), -dice_.between(4, 12));
        } else if (wanted == 3) {
            u = own + (length - own) * dice_.between(1, 999) / 1000;
        } else {
            u = own * dice_.between(1, 999) / 1000;
            regime = 2;
        }
        v.asked.u =
            formula::Exact::parse(to_decimal(Real(u * dice_.between(900001, 999999) / 1000000), 6));
        return regime;
    }
    /// Sets u on either side of a knot, at 1e-3 to 1e-33 of a + b from it, if the edge is given.
    bool by_knot(SampledValue& v, bool right) {
        const scene::Scene& scene = contact_.scene;
        const bool given =
            scene.load.kind == contact::Load::Kind::right_edge && (right || scene.symmetric());
        std::vector<const formula::Exact*> inside;
        for (const formula::Exact& knot : scene.profile->knots()) {
            const Real at = knot.to<Real>();
            if (at < a_ * 99 / 100 && -at < b_ * 99 / 100) {
                inside.push_back(&knot);
            }
        }
        if (!given || inside.empty()) {
            return false;
        }
        const formula::Expr& a = scene.load.value.expr();
        const formula::Expr& knot = inside[dice_.below(inside.size())]->expr();
        const Real size = (a_ + b_) / 1000 * pow(Real(10), -dice_.between(0, 30));
        const formula::Expr distance = formula::Exact::parse(to_decimal(size, 3)).expr();
        const formula::Expr at = right ? a - knot : a + knot;
        v.asked.u = formula::Exact(dice_.below(2) == 0 ? at - distance : at + distance);
        return true;
    }

    Dice& dice_;
    SampledContact& contact_;
    Real a_;
    Real b_;
};

} // namespace

std::string Dice::decimal(unsigned digits, int exponent) {
    std::string text(1, static_cast<char>('1' + below(9)));
    text += ".";
    for (unsigned i = 1; i < digits; ++i) {
        text += static_cast<char>('0' + below(10));
    }
    return exponent == 0 ? text : text + "e" + std::to_string(exponent);
}

SampledContact sampled_contact(std::uint64_t seed, std::size_t number, std::size_t values) {
    Dice dice(Dice(seed ^ (0x632be59bd9b4e019U * (number + 1))).next());
    SampledContact contact;
    // Power laws, most of which have no logarithms, take ten times as long as the others: only one
    // contact in 17 has one.
    contact.profile = number % curved_every == first_curved ? 5 : (dice.below(17) + 3) / 4;
    const bool by_force = dice.below(4) == 0 && contact.profile != 5;
    const scene::SceneEntries entries = drawn_entries(dice, contact.profile, by_force);
    contact.text = scene_text(entries);
    contact.scene = scene::make_scene(entries);
    contact.scene.file = "contact " + std::to_string(number);
    Drawing drawing(dice, contact);
    for (std::size_t i = 0; i < values; ++i) {
        contact.values.push_back(drawing.draw(i));
    }
    return contact;
}

} // namespace edgeproof::validation
