// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/family.hpp"

#include "edgeproof/contact/axisymmetric/axisymmetric_power_law.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"
#include "edgeproof/precision/split_mix.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace edgeproof::audit {
namespace {

/// Returns the chosen parameters with references to other parameters replaced.
formula::Definitions resolved(const Family& family, const formula::Definitions& chosen) {
    try {
        return put_into_each_other(chosen);
    } catch (const InputError& error) {
        throw InputError("the parameters of family " + family.name + ": " + error.problem(),
                         "give at least one of them as a number");
    }
}

using contact::Profile;

Exact number(long n) { return Exact(Expr::number(n)); }

/// The constructor of a profile and the parameters that it needs.
struct ProfileMaker {
    std::string_view name;
    std::vector<std::string_view> keys;
    std::function<Profile(const SceneSpec&)> make;
};

const std::vector<ProfileMaker>& profile_makers() {
    static const std::vector<ProfileMaker> makers{
        {"power-law",
         {"m", "C"},
         [](const SceneSpec& s) { return Profile::power_law(s.parameter("C"), s.parameter("m")); }},
        {"flat-and-rounded",
         {"t", "R"},
         [](const SceneSpec& s) {
             return Profile::flat_and_rounded(s.parameter("t"), s.parameter("R"));
         }},
        {"tilted-wedge",
         {"phi", "alpha"},
         [](const SceneSpec& s) {
             return Profile::tilted_wedge(s.parameter("phi"), s.parameter("alpha"));
         }},
        {"tilted-flat-and-rounded",
         {"alpha", "t", "R"},
         [](const SceneSpec& s) {
             return Profile::tilted_flat_and_rounded(s.parameter("alpha"), s.parameter("t"),
                                                     s.parameter("R"));
         }},
        {"piecewise", {}, [](const SceneSpec& s) { return Profile::piecewise(s.knots, s.slopes); }},
        {"piecewise-symmetric",
         {},
         [](const SceneSpec& s) { return Profile::piecewise_symmetric(s.knots, s.slopes); }},
        {"flat-punch",
         {"P"},
         [](const SceneSpec&) { return Profile::power_law(number(1), number(1)); }},
    };
    return makers;
}

const ProfileMaker& maker_of(std::string_view profile) {
    for (const ProfileMaker& maker : profile_makers()) {
        if (maker.name == profile) {
            return maker;
        }
    }
    throw InputError("unknown profile '" + std::string(profile) + "'",
                     "write power-law, flat-and-rounded, tilted-wedge, tilted-flat-and-rounded, "
                     "piecewise, piecewise-symmetric or flat-punch");
}

constexpr long first_slip_bits = 128;
constexpr long last_slip_bits = 2048;
constexpr long last_curved_slip_bits = 512;
constexpr int shown_slip_digits = 8;

std::string shown(const Real& x) { return x.str(shown_slip_digits); }

/// Throws InputError if the slip is proved not to be partial.
void refuse_slip(const SceneSpec& scene, const contact::ProvedSlip& found) {
    const contact::BallSlip& slip = found.slip();
    if (slip.sliding()) {
        throw InputError("the contact slides in the scene " + scene.text() +
                             ": |Q| is not less than friction*P = " +
                             shown(Ball(slip.friction() * slip.force()).midpoint()),
                         "give a smaller Q, or a greater friction, so that |Q| < friction*P");
    }
    if (slip.beyond()) {
        const bool right = *slip.beyond() == Edge::right;
        const Real one = slip.tension_limit(Edge::right).midpoint();
        const Real other = slip.tension_limit(Edge::left).midpoint();
        throw InputError("sig0 draws the stick zone beyond the " +
                             std::string(right ? "right" : "left") + " edge in the scene " +
                             scene.text() + ": that edge would slip against Q",
                         "give a sig0 between " + shown(std::min(one, other)) + " and " +
                             shown(std::max(one, other)) + ", the bounds for this Q");
    }
}

} // namespace

const std::vector<std::string_view>& profile_keys(const std::string& profile) {
    return maker_of(profile).keys;
}

bool is_piecewise(std::string_view profile) { return profile.starts_with("piecewise"); }
bool is_flat_punch(std::string_view profile) { return profile == "flat-punch"; }

void require_partial_slip(const SceneSpec& scene) {
    if (scene.parameter("friction").sign() <= 0) {
        throw InputError("friction = " + scene.parameter("friction").text() + " is not positive",
                         "give a coefficient of friction > 0, or leave it out: the contact sticks "
                         "everywhere then");
    }
    if (scene.parameter("Q").sign() == 0) {
        throw InputError("Q = 0 in a scene with friction: no partial slip is defined",
                         "give a Q that is not zero, or leave friction out");
    }
    const bool closed = scene.make_profile().has_closed_form();
    const long last = closed ? last_slip_bits : last_curved_slip_bits;
    const std::string problem = look_closer(
        [&](long bits) {
            try {
                const contact::ProvedSlip found = scene.partial_slip(bits);
                refuse_slip(scene, found);
                return certainly_positive(found.slip().size(Edge::right)) &&
                       certainly_positive(found.slip().size(Edge::left));
            } catch (const DomainError&) {
                return false; // try again with more bits
            }
        },
        {first_slip_bits, last});
    if (problem.empty()) {
        return;
    }
    throw InputError(
        "no stick zone inside the contact is enclosed by " + std::to_string(last) +
            " bits in the scene " + scene.text() +
            ": |Q| may be friction*P, the stick zone may reach an edge of the contact, "
            "or end on a corner",
        "give another Q, sig0 or friction");
}

const Exact& SceneSpec::parameter(std::string_view name) const {
    const auto it = parameters.find(name);
    if (it == parameters.end() && name == "Es" && flat_punch()) {
        static const Exact any = number(1); // the pressure does not depend on it
        return any;
    }
    if (it == parameters.end()) {
        throw InputError("a scene of family " + family + " has no " + std::string(name),
                         "add " + std::string(name) + " = [\"...\"] to the family");
    }
    return it->second;
}

std::map<std::string, Exact, std::less<>> SceneSpec::names() const {
    auto all = parameters;
    if (flat_punch()) {
        all.insert_or_assign("Q", parameter("P"));
        all.insert_or_assign("sig0", number(0));
    }
    return all;
}

contact::Profile SceneSpec::make_profile() const {
    const Profile made = maker_of(profile).make(*this);
    return axisymmetric ? contact::AxisymmetricPowerLaw::of(made).plane() : made;
}

Exact SceneSpec::total_force() const {
    return contact::AxisymmetricPowerLaw::of(maker_of(profile).make(*this))
        .force(parameter("Es"), parameter("a"));
}

Exact SceneSpec::approach() const {
    return contact::AxisymmetricPowerLaw::of(maker_of(profile).make(*this))
        .approach(parameter("a"));
}

contact::ProvedSlip SceneSpec::partial_slip(long bits) const {
    return {make_profile(),
            parameter("Es"),
            contact::Load::right_edge(parameter("a")),
            {formula::ball_of(parameter("Q"), bits), formula::ball_of(parameter("sig0"), bits)},
            formula::ball_of(parameter("friction"), bits),
            bits,
            force_of_slip(bits)};
}

std::optional<Ball> SceneSpec::force_of_slip(long bits) const {
    return axisymmetric ? std::optional(formula::ball_of(total_force(), bits)) : std::nullopt;
}

std::string SceneSpec::text() const {
    std::string text;
    for (const auto& [name, value] : parameters) {
        text += (text.empty() ? "" : ", ") + name + " = " + value.text();
    }
    return text;
}

std::size_t stratified_index(std::string_view name, std::size_t size, std::size_t i) {
    if (size <= 1) {
        return 0;
    }
    SplitMix64 random(io::fnv1a(name) + 0x632be59bd9b4e019ULL * (i / size));
    std::vector<std::size_t> order(size);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t k = size - 1; k > 0; --k) {
        std::swap(order[k], order[random.below(k + 1)]);
    }
    return order[i % size];
}

std::vector<SceneSpec> draw_scenes(const Family& family, const std::vector<Family>& all) {
    std::vector<SceneSpec> scenes;
    for (const std::string& member : family.union_of) {
        const auto it =
            std::ranges::find_if(all, [&](const Family& f) { return f.name == member; });
        if (it == all.end()) {
            throw InputError("family " + family.name + " contains the unknown family '" + member +
                                 "'",
                             "name a family of this ledger");
        }
        std::vector<SceneSpec> drawn = draw_scenes(*it, all);
        if (family.count != 0 && drawn.size() > family.count) {
            drawn.erase(drawn.begin() + static_cast<std::ptrdiff_t>(family.count), drawn.end());
        }
        scenes.insert(scenes.end(), drawn.begin(), drawn.end());
    }
    if (!family.union_of.empty()) {
        return scenes;
    }
    for (std::size_t i = 0; i < family.count; ++i) {
        formula::Definitions chosen;
        for (const auto& [name, values] : family.parameters) {
            const std::size_t k = stratified_index(family.name + '/' + name, values.size(), i);
            chosen.emplace(name, values[k]);
        }
        std::vector<Expr> others = family.knots;
        others.insert(others.end(), family.slopes.begin(), family.slopes.end());
        SceneSpec scene;
        scene.family = family.name;
        scene.profile = family.profile;
        scene.axisymmetric = family.axisymmetric;
        const formula::Definitions parameters = resolved(family, chosen);
        for (const auto& [name, value] : parameters) {
            scene.parameters.emplace(name, Exact(value));
        }
        for (Expr& e : others) {
            e = put_in(parameters, e);
        }
        if (scene.slips()) {
            scene.parameters.try_emplace("sig0");
        }
        for (std::size_t k = 0; k < others.size(); ++k) {
            if (k < family.knots.size()) {
                scene.knots.emplace_back(others[k]);
            } else {
                scene.slopes.push_back(others[k]);
            }
        }
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

} // namespace edgeproof::audit
