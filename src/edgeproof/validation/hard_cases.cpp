// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/validation/hard_cases.hpp"

#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/scene/input/file_kind.hpp"
#include "edgeproof/validation/second_route.hpp"

namespace edgeproof::validation {
namespace {

/// Divided differences, the second route to a coefficient, take digits and points with its order.
constexpr long most_asked_terms = 20;

scene::Scene read_case_scene(const io::TomlSection& section) {
    (void)section.section("profile"); // a missing profile is reported first
    try {
        return scene::read_contact(section);
    } catch (const InputError& error) {
        throw InputError(error.problem(), error.instead()).at(section.file(), section.line());
    }
}

const scene::QuantityRow& quantity_of(const io::TomlSection& section) {
    const std::string name = section.text("quantity");
    std::vector<std::string_view> names;
    for (const scene::Quantity quantity : second_route_quantities()) {
        const scene::QuantityRow& row = row_of(quantity);
        if (row.name == name) {
            return row;
        }
        names.push_back(row.name);
    }
    const std::string near(near_name(name, names));
    std::string advice = near.empty() ? "" : "did you mean " + near + "? ";
    for (std::size_t i = 0; i < names.size(); ++i) {
        advice += (i == 0                  ? "write "
                   : i + 1 == names.size() ? " or "
                                           : ", ") +
                  std::string(names[i]);
    }
    section.reject("quantity", "unknown quantity '" + name + "'", advice);
}

scene::AskedValue read_asked(const io::TomlSection& section, const scene::Scene& scene) {
    using Index = scene::QuantityRow::Index;
    scene::AskedValue asked;
    const scene::QuantityRow& row = quantity_of(section);
    asked.quantity = row.quantity;
    if (section.has("edge")) {
        const std::string name = section.text("edge");
        const auto edge = scene::edge_named(name);
        if (!edge) {
            section.reject("edge", "there is no edge '" + name + "'", "write right or left");
        }
        asked.edge = *edge;
    }
    if (row.at_point()) {
        asked.u = section.exact("u");
    }
    if (row.tolerance) {
        asked.tolerance = scene::parse_tolerance(section.text("tolerance"));
    }
    if (row.index != Index::none) {
        asked.k = section.count("n", row.index == Index::terms ? 1 : 0, most_asked_terms);
    }
    if (row.of_shear() && !scene.shear) {
        section.reject(section.line(), "a quantity of the shear is requested and there is no shear",
                       "add shear = { Q = \"...\" }");
    }
    if (!scene.profile) {
        section.reject("load", "the tilt is not given",
                       "give alpha: a tilt that is found as an estimate proves nothing");
    }
    return asked;
}

} // namespace

std::vector<HardCase> parse_hard_cases(std::string_view text, const std::string& file) {
    const io::TomlSection top = io::TomlSection::parse(text, file);
    expect_file_kind(top, scene::FileKind::hard_cases);
    top.allow({"cases"});
    std::vector<HardCase> cases;
    const io::TomlSection all = top.section("cases");
    if (all.keys().empty()) {
        all.reject(all.line(), "the file has no cases",
                   "add a case, such as [cases.hertz-40] with class, reason and quantity");
    }
    for (const std::string& name : all.keys()) {
        const io::TomlSection section = all.section(name);
        section.allow({"class", "reason", "undecided", "quantity", "edge", "u", "n", "tolerance",
                       "profile", "load", "shear"});
        HardCase c;
        c.line = section.line();
        c.family = section.text("class");
        c.reason = section.text("reason");
        c.undecided = section.has("undecided") ? section.text("undecided") : "";
        c.name = name;
        c.scene = read_case_scene(section);
        c.asked = io::at_place(file, c.line, [&] { return read_asked(section, c.scene); });
        cases.push_back(std::move(c));
    }
    return cases;
}

} // namespace edgeproof::validation
