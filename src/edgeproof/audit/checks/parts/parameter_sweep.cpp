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

ParameterSweep::ParameterSweep(const Claim& claim, const AuditContext& context)
    : claim_(claim), context_(context), name_(claim.text("along")) {
    if (claim.has("where")) {
        claim.reject("where", "a claim along " + name_ + " leaves samples out",
                     "list admissible values only, and leave out `where`");
    }
    const auto add_step = [&](const std::vector<Sample>& samples) {
        std::vector<SweptSample>& step = steps_.emplace_back();
        for (const Sample& sample : samples) {
            if (sample.scene.slips()) {
                require_partial_slip(sample.scene);
            }
            step.push_back({sample, sample.scene.family + ": " + sample.text()});
        }
    };
    const std::string& over = claim.text("over");
    if (const auto* values = listed(context.ledger().family(over), name_)) {
        of_family_ = true;
        for (const formula::Expr& value : *values) {
            values_.push_back(to_text(value));
            const Ledger fixed = with_parameter(context.ledger(), over, name_, value);
            add_step(AuditContext(fixed, context.digits()).samples(claim));
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
                add_step(context.samples(at));
            }
        }
    }
    if (values_.size() < 3) {
        claim.reject("along", "'" + name_ + "' does not take three values",
                     "name a parameter of the family, or a name of `vary`, with a list of values");
    }
}

const formula::Exact& ParameterSweep::value_at(std::size_t value, std::size_t sample) const {
    const Sample& at = sample_at(value, sample).sample;
    return of_family_ ? at.scene.parameter(name_) : at.variables.find(name_)->second;
}

Sample ParameterSweep::sample_with(const formula::Exact& value, std::size_t sample) const {
    if (of_family_) {
        const Ledger fixed =
            with_parameter(context_.ledger(), claim_.text("over"), name_, value.expr());
        return AuditContext(fixed, context_.digits()).samples(claim_)[sample];
    }
    Sample at = sample_at(0, sample).sample;
    at.variables.insert_or_assign(name_, value);
    return at;
}

} // namespace edgeproof::audit
