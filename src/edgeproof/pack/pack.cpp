// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/pack/pack.hpp"
#include "edgeproof/comparison/measures/exact_contact.hpp"
#include "edgeproof/conformance/causes/readings.hpp"
#include "edgeproof/conformance/questions/recipe.hpp"
#include "edgeproof/conformance/questions/reference.hpp"
#include "edgeproof/io/sha256.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

namespace edgeproof::pack {
namespace {

std::string head_of(const std::string& what) {
    return fmt::format("# Edgeproof conformance pack {}: {}\n", pack_version, what) +
           "# The columns are explained in README.md. Numbers of the contact, and u, are exact "
           "binary64.\n";
}

/// factors.txt: the factors with a name of the catalogue of mistakes.
std::string factors_text() {
    const PrecisionScope scope(30);
    std::string text =
        fmt::format("# Edgeproof conformance pack {}: factors by which programs are wrong, with "
                    "their names\n",
                    pack_version);
    for (const conformance::NamedFactor& factor : conformance::named_factors()) {
        text += fmt::format("{} {:.17g}\n", factor.name, factor.value.convert_to<double>());
    }
    return text;
}

} // namespace

std::vector<PackFile> make_pack(const PackOptions& options) {
    std::vector<PackFile> files;
    const auto add = [&](const char* name, const std::string& what, const PackRows& rows) {
        files.push_back({name, head_of(what) + fmt::format("# rows: {}\n", rows.rows) +
                                   pack_columns() + rows.text});
    };
    const auto text = [](std::size_t file) { return shipped_files[file].second; };
    add("level-a.csv", "level A, engineering", recipe_rows(text(1), "level-a.toml", true, options));
    add("cases.csv", "levels B, C and D", recipe_rows(text(0), "pack.toml", false, options));
    add("hard-cases.csv", "levels B, C and D, hard cases, with the reason of each",
        hard_case_rows(text(2), "hard-cases.toml", options));
    files.push_back({"factors.txt", factors_text()});
    for (const auto& [name, content] : shipped_files.subspan(3)) {
        files.push_back({std::string(name), std::string(content)});
    }
    return files;
}

std::string manifest(const std::vector<PackFile>& files, const Origin& origin) {
    std::string text = fmt::format("# pack: {}\n# program: {}\n# commit: {}\n# date: {}\n"
                                   "# command: {}\n# check: sha256sum -c {}\n",
                                   pack_version, origin.program, origin.commit, origin.date,
                                   origin.command, manifest_name);
    for (const PackFile& file : files) {
        text += io::sha256(file.text) + "  " + file.name + "\n";
    }
    return text;
}

namespace {

constexpr unsigned pack_digits = 50;
/// A row with a relative condition number up to this is well conditioned and allows 4 units in the
/// last place; others allow proportionally more.
constexpr double well_conditioned = 8;
constexpr double units_of_well_conditioned = 4;

/// The columns of the contact, and the keys in them.
constexpr std::pair<const char*, const char*> contact_columns[] = {{"kind", "kind"},
                                                                   {"m", "m"},
                                                                   {"C", "C"},
                                                                   {"phi", "phi"},
                                                                   {"alpha", "alpha"},
                                                                   {"t", "t"},
                                                                   {"R", "R"},
                                                                   {"a", "a"},
                                                                   {"P", "P"},
                                                                   {"M", "M"},
                                                                   {"E", "contact_modulus"},
                                                                   {"Q", "Q"},
                                                                   {"S", "bulk_tension"}};

std::string double_text(double x) { return fmt::format("{:.17g}", x); }

/// True if the columns can describe the contact.
bool has_columns(const conformance::AskedContact& contact) {
    return std::ranges::all_of(contact.parameters,
                               [](const conformance::Parameter& p) {
                                   return std::ranges::any_of(
                                       contact_columns, [&](const auto& column) {
                                           return p.key == column.second || p.key == "geometry";
                                       });
                               }) &&
           parameter_text(contact, "kind") != "piecewise";
}

std::string contact_cells(const conformance::AskedContact& contact) {
    std::string out;
    for (const auto& [column, key] : contact_columns) {
        const std::string text = parameter_text(contact, key);
        const bool word = std::string_view(column) == "kind";
        const bool round = word && parameter_text(contact, "geometry") == "axisymmetric";
        out += "," + (word           ? (round ? "axisymmetric-" : "") + text
                      : text.empty() ? std::string("nan")
                                     : double_text(formula::Exact::parse(text).to<double>()));
    }
    return out;
}

class RowWriter {
public:
    RowWriter(const conformance::Questions& questions, bool with_scale, const PackOptions& options)
        : questions_(questions), with_scale_(with_scale) {
        reference_options_.digits = {pack_digits, Rounding::nearest, true};
        reference_options_.threads = options.threads;
        reference_options_.progress = options.progress;
    }

    PackRows write(const std::vector<std::string>& reasons) {
        const auto answers = references_or_why(questions_, reference_options_);
        std::vector<conformance::Reference> references(answers.size());
        std::vector<std::size_t> which;
        std::vector<scene::PrintedValue> texts(answers.size());
        for (std::size_t i = 0; i < answers.size(); ++i) {
            if (!answers[i].reference || !answers[i].reference->value.proved) {
                continue;
            }
            references[i] = *answers[i].reference;
            texts[i] = printed(references[i].value, reference_options_.digits);
            if (texts[i].complete && !texts[i].undecided && texts[i].binary64 &&
                std::isnormal(*texts[i].binary64)) {
                which.push_back(i);
            }
        }
        reference_options_.progress = {};
        const auto conditions = conditioning(questions_, references, which, reference_options_);
        PackRows rows;
        for (const std::size_t i : which) {
            if (conditions[i]) {
                rows.text += reasons.empty() ? "" : "# " + reasons[i] + "\n";
                rows.text += row(i, texts[i], conditions[i]->number());
                ++rows.rows;
            }
        }
        rows.left_out = answers.size() - rows.rows;
        return rows;
    }

private:
    [[nodiscard]] std::string row(std::size_t i, const scene::PrintedValue& value,
                                  double condition) {
        const conformance::Question& q = questions_.list[i];
        const double units =
            units_of_well_conditioned * std::max(1.0, std::ceil(condition / well_conditioned));
        const auto& contact = questions_.contacts[q.contact];
        return q.id + contact_cells(contact) +
               fmt::format(",{},{},{},{},{},{},{},{},{:.3g},{:.0f}\n",
                           q.at_edge() ? scene::edge_name(q.edge) : "none",
                           q.u ? double_text(q.u->to<double>()) : "nan", symbol_of(q),
                           scale_of(q.contact), value.text, value.bound,
                           double_text(*value.binary64), hexadecimal(*value.binary64), condition,
                           std::min(units, 1e15));
    }
    [[nodiscard]] std::string scale_of(std::size_t contact) {
        if (!with_scale_) {
            return "nan";
        }
        const auto [found, is_new] = scales_.try_emplace(contact);
        if (is_new) {
            const comparison::ExactContact exact(questions_.contacts[contact].scene);
            found->second = fmt::format("{:.6g}", exact.scale().value);
        }
        return found->second;
    }

    const conformance::Questions& questions_;
    bool with_scale_;
    conformance::ReferenceOptions reference_options_;
    std::map<std::size_t, std::string> scales_;
};

/// The quantity of a hard case, by the names of questions; nothing if no row can hold it.
std::optional<scene::NamedQuantity> wanted_of(const io::TomlSection& hard_case) {
    const std::string quantity = hard_case.text("quantity");
    const std::string n = hard_case.written_or("n", "0");
    const std::pair<const char*, std::string> names[] = {{"pressure", "p"},
                                                         {"shear", "q"},
                                                         {"coefficient", "c_" + n},
                                                         {"shear-coefficient", "s_" + n},
                                                         {"load", "P"},
                                                         {"approach", "delta"},
                                                         {"left-edge", "b"}};
    const auto found =
        std::ranges::find(names, quantity, [](const auto& name) { return name.first; });
    return found == std::end(names) ? std::nullopt : scene::quantity_named(found->second);
}

} // namespace

std::string pack_columns() {
    std::string out = "id";
    for (const auto& [column, key] : contact_columns) {
        out += std::string(",") + column;
    }
    return out + ",edge,u,quantity,scale,value,bound,binary64,hex,condition,ulps\n";
}

PackRows recipe_rows(std::string_view text, const std::string& file, bool with_scale,
                     const PackOptions& options) {
    const conformance::Recipe recipe = conformance::parse_recipe(text, file);
    const conformance::Questions asked = rounded_to_binary64(recipe.questions);
    return RowWriter(asked, with_scale, options).write({});
}

PackRows hard_case_rows(std::string_view text, const std::string& file,
                        const PackOptions& options) {
    const io::TomlSection top = io::TomlSection::parse(text, file);
    const io::TomlSection cases = top.section("cases");
    conformance::Questions asked;
    asked.file = file;
    std::vector<std::string> reasons;
    for (const std::string& name : cases.keys()) {
        const io::TomlSection one = cases.section(name);
        const auto wanted = wanted_of(one);
        if (!wanted || one.has("undecided")) {
            continue;
        }
        std::vector<conformance::Parameter> parameters;
        for (const char* section : {"profile", "load", "shear"}) {
            if (one.has(section)) {
                const io::TomlSection part = one.section(section);
                for (const std::string& key : part.keys()) {
                    // No column can hold a list.
                    parameters.push_back({part.is_list(key) ? "slopes" : key,
                                          part.is_list(key) ? "" : part.written(key), 0});
                }
            }
        }
        try {
            if (!has_columns({parameters, {}})) {
                continue;
            }
            conformance::Question q;
            q.id = "hard:" + name;
            q.contact = asked.contacts.size();
            q.quantity = wanted->quantity;
            q.k = wanted->k;
            q.line = one.line();
            q.edge = one.has("edge") && one.text("edge") == "left" ? contact::Edge::left
                                                                   : contact::Edge::right;
            if (q.at_point()) {
                q.u = conformance::rounded_to_binary64(one.exact("u"));
            }
            asked.contacts.push_back(conformance::make_asked_contact(
                conformance::rounded_to_binary64(std::move(parameters)), file, one.line()));
            asked.list.push_back(std::move(q));
            reasons.push_back(one.text("class") + ": " + one.text("reason"));
        } catch (const Error&) {
            // Rounding to binary64 has changed the contact or the place: there is no question.
        }
    }
    return RowWriter(asked, false, options).write(reasons);
}

} // namespace edgeproof::pack
