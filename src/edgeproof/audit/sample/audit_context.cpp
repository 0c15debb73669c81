// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/sample/audit_context.hpp"

#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace edgeproof::audit {

std::vector<std::size_t> spread_first(std::size_t n, std::size_t first) {
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (first > 1 && first < n) {
        std::vector<bool> chosen(n, false);
        for (std::size_t k = 0; k < first; ++k) {
            chosen[k * (n - 1) / (first - 1)] = true;
        }
        std::stable_partition(order.begin(), order.end(),
                              [&](std::size_t i) { return bool{chosen[i]}; });
    }
    return order;
}

std::string Sample::text() const {
    std::string text = scene.text();
    if (fraction) {
        text += ", u = " + fraction->text() + " of the length from the " +
                (edge == Edge::right ? "right" : "left") + " edge";
    }
    for (const auto& [name, value] : variables) {
        text += ", " + name + " = " + value.text();
    }
    return text;
}

std::vector<SceneSpec> AuditContext::scenes(const Claim& claim) const {
    return draw_scenes(ledger_.family(claim.text("over")), ledger_.families);
}

std::vector<Sample> AuditContext::samples(const Claim& claim) const {
    const Edge edge = claim.edge();
    std::vector<Sample> samples;
    std::size_t i = 0;
    for (const SceneSpec& scene : scenes(claim)) {
        const Family& family = ledger_.family(scene.family);
        const auto points = static_cast<std::size_t>(
            std::max(1L, claim.integer_or("points", static_cast<long>(family.points))));
        for (std::size_t k = 0; k < points; ++k, ++i) {
            Sample sample{scene, std::nullopt, edge, {}};
            if (!family.u.empty()) {
                sample.fraction =
                    family.u[stratified_index(family.name + "/u", family.u.size(), i)];
            }
            if (claim.has("vary")) {
                for (const auto& [name, values] : claim.table("vary")) {
                    formula::Symbols names;
                    for (const auto& [parameter, value] : scene.parameters) {
                        names.add(parameter);
                    }
                    try {
                        Expr e =
                            parse(values[stratified_index(claim.id + '/' + name, values.size(), i)],
                                  names);
                        for (const auto& [parameter, value] : scene.parameters) {
                            e = substitute(e, parameter, value.expr());
                        }
                        sample.variables.emplace(name, Exact(e));
                    } catch (const InputError& error) {
                        claim.reject("vary", error.problem(), error.instead());
                    }
                }
            }
            samples.push_back(std::move(sample));
        }
    }
    return samples;
}

std::vector<Sample> AuditContext::different_samples(const Claim& claim) const {
    std::vector<Sample> samples = this->samples(claim);
    std::set<std::string> taken;
    std::erase_if(samples, [&](const Sample& sample) {
        return !taken.insert(sample.scene.family + ": " + sample.text()).second;
    });
    return samples;
}

namespace {

/// Returns the families of a ledger (without its claims), one of them changed.
template <class Change>
Ledger with_family(const Ledger& ledger, const std::string& name, const Change& change) {
    Ledger fixed;
    fixed.name = ledger.name;
    fixed.file = ledger.file;
    fixed.families = ledger.families;
    change(*std::ranges::find(fixed.families, name, &Family::name));
    return fixed;
}

/// The lists of values of the names in `vary`; null without any.
Field::Table* varied(Claim& claim) {
    const auto it = claim.fields.find("vary");
    return it == claim.fields.end() ? nullptr : &std::get<Field::Table>(it->second.value);
}

} // namespace

Ledger with_parameter(const Ledger& ledger, const std::string& family, const std::string& parameter,
                      const Expr& value) {
    return with_family(ledger, family, [&](Family& f) {
        for (auto& [name, values] : f.parameters) {
            if (name == parameter) {
                values = {value};
            }
        }
    });
}

std::vector<Sample> rows_of(const Claim& claim, const AuditContext& context, std::size_t rows) {
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < rows; ++i) {
        const auto pick = [&](const std::string& name, auto& values) {
            if (values.size() != 1 && values.size() != rows) {
                claim.reject("quoted",
                             "quoted has " + std::to_string(rows) + " figures, and " + name + " " +
                                 std::to_string(values.size()) + " values",
                             "give one value for each figure, or one for all");
            }
            values = {values.at(values.size() > 1 ? i : 0)};
        };
        Claim row = claim;
        if (Field::Table* const table = varied(row)) {
            std::ranges::for_each(*table, [&](auto& list) { pick(list.first, list.second); });
        }
        const Ledger fixed = with_family(context.ledger(), claim.text("over"), [&](Family& f) {
            if (!f.union_of.empty()) {
                claim.reject("over",
                             "a table of figures is over one family, and " + f.name + " is a union",
                             "name one of its families");
            }
            std::ranges::for_each(f.parameters, [&](auto& list) { pick(list.first, list.second); });
            if (!f.u.empty()) {
                pick("u", f.u);
            }
            f.count = f.points = 1;
        });
        samples.push_back(AuditContext(fixed, context.digits()).samples(row).front());
    }
    return samples;
}

Sweep sweep_of(const Claim& claim, const AuditContext& context) {
    const std::string& along = claim.text("along");
    if (claim.has("where")) {
        claim.reject("where", "a claim along " + along + " leaves samples out",
                     "list admissible values only, and leave out `where`");
    }
    Sweep sweep;
    const auto add = [&](std::string value, std::vector<Sample> samples) {
        for (const Sample& sample : samples) {
            if (sample.scene.slips()) {
                require_partial_slip(sample.scene);
            }
        }
        sweep.values.push_back(std::move(value));
        sweep.samples.push_back(std::move(samples));
    };
    const std::string& over = claim.text("over");
    for (const auto& [name, values] : context.ledger().family(over).parameters) {
        for (std::size_t i = 0; name == along && i < values.size(); ++i) {
            const Ledger fixed = with_parameter(context.ledger(), over, along, values[i]);
            add(to_text(values[i]), AuditContext(fixed, context.digits()).samples(claim));
        }
    }
    if (sweep.values.empty() && claim.has("vary")) {
        Claim at = claim;
        for (auto& [name, texts] : *varied(at)) {
            for (const std::string& text : name == along ? Field::List(texts) : Field::List()) {
                texts = {text};
                add(text, context.samples(at));
            }
        }
    }
    if (sweep.values.size() < 2) {
        claim.reject("along", "'" + along + "' does not take two values",
                     "name a parameter of the family, or a name of `vary`, with a list of values");
    }
    for (std::size_t j = sweep.values.size() - 1; j-- > 0;) {
        for (std::size_t k = 0; k < sweep.samples[j].size(); ++k) {
            sweep.samples[j][k].next = std::make_shared<const Sample>(sweep.samples[j + 1][k]);
        }
    }
    return sweep;
}

} // namespace edgeproof::audit
