// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/sweep.hpp"

namespace edgeproof::audit {

Ledger with_parameter(const Ledger& ledger, const std::string& family, const std::string& parameter,
                      const Expr& value) {
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
        for (auto& [name, texts] : std::get<Field::Table>(at.fields.find("vary")->second.value)) {
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
