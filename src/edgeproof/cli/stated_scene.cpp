// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/stated_scene.hpp"

#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace edgeproof::cli {
namespace {

struct StatedProfile {
    std::string_view kind;
    std::string_view help;
};
constexpr std::array stated_profiles{
    StatedProfile{"power-law", "g' = C x^m: --m, --C"},
    StatedProfile{"hertz", "two cylinders, or one on a flat: --R, or --R1 and --R2"},
    StatedProfile{"cylinder-on-flat", "--R"},
    StatedProfile{"flat-and-rounded", "--t (or --flat-width), --R"},
    StatedProfile{"tilted-wedge", "--phi, --alpha"},
    StatedProfile{"tilted-flat-and-rounded", "--alpha, --t, --R"},
};

enum class StatedSection { profile, load, shear, ask };
struct StatedQuantity {
    std::string_view key; ///< in a scene's file; an underscore is a hyphen on the command line
    StatedSection section;
    std::string_view help;
};
constexpr std::array stated_quantities{
    StatedQuantity{"m", StatedSection::profile, "exponent of g'"},
    StatedQuantity{"C", StatedSection::profile, "factor of g'"},
    StatedQuantity{"R", StatedSection::profile, "radius"},
    StatedQuantity{"R1", StatedSection::profile, "radius of the one body"},
    StatedQuantity{"R2", StatedSection::profile, "radius of the other, negative for a hollow"},
    StatedQuantity{"t", StatedSection::profile, "half the length of the flat"},
    StatedQuantity{"flat_width", StatedSection::profile, "length of the flat"},
    StatedQuantity{"phi", StatedSection::profile, "slope of a wedge's flanks"},
    StatedQuantity{"alpha", StatedSection::profile, "tilt"},
    StatedQuantity{"a", StatedSection::load, "the right edge"},
    StatedQuantity{"width", StatedSection::load, "the contact's width, where it is symmetric"},
    StatedQuantity{"P", StatedSection::load, "normal force per length"},
    StatedQuantity{"M", StatedSection::load, "moment per length, with P, of an unknown tilt"},
    StatedQuantity{"contact_modulus", StatedSection::load, "E*"},
    StatedQuantity{"E1", StatedSection::load, "Young's modulus of the one body"},
    StatedQuantity{"nu1", StatedSection::load, "its Poisson's ratio"},
    StatedQuantity{"E2", StatedSection::load, "Young's modulus of the other"},
    StatedQuantity{"nu2", StatedSection::load, "its Poisson's ratio"},
    StatedQuantity{"Q", StatedSection::shear, "shear force per length"},
    StatedQuantity{"bulk_tension", StatedSection::shear, "difference of the bulk tensions"},
    StatedQuantity{"friction", StatedSection::shear, "coefficient of friction"},
    StatedQuantity{"path", StatedSection::shear, "normal-first or together"},
    StatedQuantity{"u", StatedSection::ask, "points by their distances from the edge: 1e-3,a/2"},
    StatedQuantity{"x", StatedSection::ask, "points by their places: 0,a/2"},
    StatedQuantity{"process_zone", StatedSection::ask, "a length from the edge"},
};

std::string option_of(std::string_view key) {
    std::string name = "--" + std::string(key);
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

} // namespace

std::vector<std::string> parts_of(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        parts.push_back(text.substr(at, comma - at));
        at = comma + 1;
    }
    return parts;
}

void StatedScene::add_options(CLI::App& sub) {
    const char* const group = "A scene by its quantities, in place of a file";
    const char* const ask_group = "What is asked, in place of what the scene's file asks";
    for (const StatedProfile& profile : stated_profiles) {
        sub.add_flag("--" + std::string(profile.kind), profiles_[std::string(profile.kind)],
                     std::string(profile.help))
            ->group(group);
    }
    for (const StatedQuantity& quantity : stated_quantities) {
        sub.add_option(option_of(quantity.key), quantities_[std::string(quantity.key)],
                       std::string(quantity.help))
            ->group(quantity.section == StatedSection::ask ? ask_group : group);
    }
}

bool StatedScene::given() const {
    return std::any_of(profiles_.begin(), profiles_.end(),
                       [](const auto& p) { return p.second; }) ||
           std::any_of(stated_quantities.begin(), stated_quantities.end(),
                       [this](const StatedQuantity& q) {
                           return q.section != StatedSection::ask &&
                                  !quantities_.at(std::string(q.key)).empty();
                       });
}

scene::SceneEntries::Section StatedScene::asked() const {
    scene::SceneEntries::Section asked;
    for (const char* const key : {"u", "x"}) {
        if (const std::string& list = quantities_.at(key); !list.empty()) {
            asked.push_back({key, parts_of(list)});
        }
    }
    if (const std::string& zone = quantities_.at("process_zone"); !zone.empty()) {
        asked.push_back({"process_zone", zone});
    }
    return asked;
}

scene::SceneEntries StatedScene::entries() const {
    std::string kind;
    for (const auto& [name, asked] : profiles_) {
        if (asked && !kind.empty()) {
            throw InputError(fmt::format("both --{} and --{} are given", kind, name),
                             "give one profile");
        }
        kind = asked ? name : kind;
    }
    if (kind.empty()) {
        std::string all;
        for (const StatedProfile& profile : stated_profiles) {
            all += (all.empty() ? "--" : ", --") + std::string(profile.kind);
        }
        throw InputError("no profile is given", "add one of " + all + ", or name a scene's file");
    }
    scene::SceneEntries entries;
    entries.profile.push_back({"kind", kind});
    for (const StatedQuantity& quantity : stated_quantities) {
        const std::string& text = quantities_.at(std::string(quantity.key));
        if (text.empty()) {
            continue;
        }
        const std::string key(quantity.key);
        switch (quantity.section) {
        case StatedSection::profile:
            entries.profile.push_back({key, text});
            break;
        case StatedSection::load:
            entries.load.push_back({key, text});
            break;
        case StatedSection::shear:
            entries.shear.push_back({key, text});
            break;
        case StatedSection::ask:
            break;
        }
    }
    entries.ask = asked();
    return entries;
}

} // namespace edgeproof::cli
