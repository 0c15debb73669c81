// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/parameter_sweep.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

const std::vector<formula::Expr>* listed(const Family& family, const std::string& parameter) {
    const auto it = std::find_if(family.parameters.begin(), family.parameters.end(),
                                 [&](const auto& p) { return p.first == parameter; });
    return it == family.parameters.end() ? nullptr : &it->second;
}

} // namespace

Ledger with_parameter(const Ledger& ledger, const std::string& family, const std::string& parameter,
                      const formula::Expr& value) {
    Ledger fixed;
    fixed.name = ledger.name;
    fixed.file = ledger.file;
    fixed.families = ledger.families;
    for (Family& f : fixed.families) {
        if (f.name != family) {
            continue;
        }
        for (auto& [name, values] : f.parameters) {
            if (name == parameter) {
                values = {value};
            }
        }
    }
    return fixed;
}

ParameterSweep::ParameterSweep(const Claim& claim, const AuditContext& context, unsigned digits)
    : name_(claim.text("along")) {
    if (claim.has("where")) {
        claim.reject("where", "a claim along " + name_ + " leaves samples out",
                     "list admissible values only, and leave out `where`");
    }
    const std::string& over = claim.text("over");
    if (const auto* values = listed(context.ledger().family(over), name_)) {
        for (const formula::Expr& value : *values) {
            values_.push_back(to_text(value));
            const Ledger fixed = with_parameter(context.ledger(), over, name_, value);
            steps_.push_back(std::make_unique<EvaluatedSamples>(
                claim, AuditContext(fixed, context.digits()), digits));
        }
    } else if (claim.has("vary")) {
        for (const auto& [name, texts] : claim.table("vary")) {
            if (name != name_) {
                continue;
            }
            for (const std::string& text : texts) {
                values_.push_back(text);
                Claim at = claim;
                Field& field = at.fields.find("vary")->second;
                for (auto& [key, list] : std::get<Field::Table>(field.value)) {
                    if (key == name_) {
                        list = {text};
                    }
                }
                steps_.push_back(std::make_unique<EvaluatedSamples>(at, context, digits));
            }
        }
    }
    if (values_.size() < 3) {
        claim.reject("along", "'" + name_ + "' does not take three values",
                     "name a parameter of the family, or a name of `vary`, with a list of values");
    }
}

} // namespace edgeproof::audit
