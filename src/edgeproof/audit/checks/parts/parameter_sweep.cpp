// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/parameter_sweep.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::audit {

Ledger with_parameter(const Ledger& ledger, const std::string& family, const std::string& parameter,
                      const formula::Expr& value) {
    Ledger fixed;
    fixed.name = ledger.name;
    fixed.file = ledger.file;
    fixed.families = ledger.families;
    for (Family& f : fixed.families) {
        for (auto& [name, values] : f.parameters) {
            if (f.name == family && name == parameter) {
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
    for (const auto& [name, values] : context.ledger().family(claim.text("over")).parameters) {
        of_family_ = of_family_ || name == name_;
        for (std::size_t i = 0; name == name_ && i < values.size(); ++i) {
            add_step(to_text(values[i]), samples_with(values[i]));
        }
    }
    if (!of_family_ && claim.has("vary")) {
        Claim at = claim;
        for (auto& [name, texts] : std::get<Field::Table>(at.fields.find("vary")->second.value)) {
            for (const std::string& text : name == name_ ? Field::List(texts) : Field::List()) {
                texts = {text};
                add_step(text, context.samples(at));
            }
        }
    }
    if (values_.size() < 3) {
        claim.reject("along", "'" + name_ + "' does not take three values",
                     "name a parameter of the family, or a name of `vary`, with a list of values");
    }
}

std::vector<Sample> ParameterSweep::samples_with(const formula::Expr& value) const {
    const Ledger fixed = with_parameter(context_.ledger(), claim_.text("over"), name_, value);
    return AuditContext(fixed, context_.digits()).samples(claim_);
}

void ParameterSweep::add_step(std::string value, std::vector<Sample> samples) {
    for (const Sample& sample : samples) {
        if (sample.scene.slips()) {
            require_partial_slip(sample.scene);
        }
    }
    values_.push_back(std::move(value));
    steps_.push_back(std::move(samples));
}

const formula::Exact& ParameterSweep::value_at(std::size_t value, std::size_t sample) const {
    const Sample& at = sample_at(value, sample);
    return of_family_ ? at.scene.parameter(name_) : at.variables.find(name_)->second;
}

Sample ParameterSweep::sample_with(const formula::Exact& value, std::size_t sample) const {
    if (of_family_) {
        return samples_with(value.expr())[sample];
    }
    Sample at = sample_at(0, sample);
    at.variables.insert_or_assign(name_, value);
    return at;
}

} // namespace edgeproof::audit
