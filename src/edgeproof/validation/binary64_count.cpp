// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/validation/binary64_count.hpp"

#include "edgeproof/contact/batch/double_word_pressure.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/validation/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace edgeproof::validation {
namespace {

constexpr std::size_t places_a_contact = 10'000;
constexpr long first_bits = 128; // as scene/binary64_pressures.cpp has them
constexpr long second_bits = 320;

/// 0 <= x < 1, of 53 bits.
double uniform(SplitMix64& dice) { return static_cast<double>(dice.next() >> 11U) * 0x1p-53; }

struct Place {
    contact::Edge edge;
    double u;
    DrawnPlace where;
};

Place drawn(SplitMix64& dice, double length, const std::vector<double>& insets) {
    const contact::Edge edge = dice.below(2) == 0 ? contact::Edge::right : contact::Edge::left;
    const auto where = static_cast<DrawnPlace>(dice.below(insets.empty() ? 2 : drawn_places));
    switch (where) {
    case DrawnPlace::by_the_edge:
        return {edge, length * std::pow(10.0, -60 * uniform(dice)), where};
    case DrawnPlace::inside:
        return {edge, length * uniform(dice), where};
    case DrawnPlace::by_a_knot:
        break;
    }
    const double inset = insets[dice.below(insets.size())];
    const double at = edge == contact::Edge::right ? inset : length - inset;
    const double step = at * std::pow(10.0, -16 * uniform(dice));
    return {edge, at + (dice.below(2) == 0 ? step : -step), where};
}

} // namespace

Binary64Count::Cell Binary64Count::total() const {
    Cell all;
    for (const Cell& c : cells) {
        all.values += c.values;
        all.undecided += c.undecided;
        all.wrong += c.wrong;
    }
    return all;
}

Binary64Count count_binary64(std::uint64_t seed, std::size_t values,
                             const std::function<void(std::size_t, std::size_t)>& progress) {
    Binary64Count count;
    std::size_t done = 0;
    for (std::size_t number = 0; done < values; ++number) {
        const SampledContact sample = sampled_contact(seed, number, 1);
        if (!sample.scene.profile || !sample.scene.profile->piecewise_linear()) {
            continue;
        }
        const auto contact_in = [&](long bits) {
            return contact::BallContact(*sample.scene.profile, sample.scene.contact_modulus,
                                        sample.scene.load, bits);
        };
        const contact::BallContact first = contact_in(first_bits);
        const contact::BallContact second = contact_in(second_bits);
        const contact::DoubleWordPressure pressure(first);
        ++count.contacts;
        SplitMix64 dice(SplitMix64(seed).next() + number);
        const auto number_of = [](const Ball& x) { return x.midpoint().convert_to<double>(); };
        std::vector<double> insets;
        for (std::size_t i = 0; i < first.slope().knots.size(); ++i) {
            if (first.bends_inside(i)) {
                insets.push_back(number_of(first.a() - first.slope().knots[i]));
            }
        }
        const double length = number_of(first.a() + first.b());
        for (std::size_t i = std::min(places_a_contact, values - done); i > 0; --i, ++done) {
            check_interruption();
            const Place at = drawn(dice, length, insets);
            Binary64Count::Cell& cell = count.cells[static_cast<std::size_t>(at.where)];
            ++cell.values;
            const auto p = pressure.nearest(at.edge, at.u);
            if (!p) {
                ++cell.undecided;
                continue;
            }
            const auto right =
                nearest_binary64(second.pressure(at.edge, Ball(Rational(at.u), second_bits)));
            if (right != p) {
                ++cell.wrong;
                count.findings.push_back(fmt::format(
                    "{}\nu = {:a} from the {} edge: {:a}, where a ball of {} bits has {}",
                    sample.text, at.u, at.edge == contact::Edge::right ? "right" : "left", *p,
                    second_bits, right ? fmt::format("{:a}", *right) : "several"));
            }
        }
        if (progress) {
            progress(done, values);
        }
    }
    return count;
}

} // namespace edgeproof::validation
