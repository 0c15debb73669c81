// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/quoted_extent.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

ContactsBySize::Fractions quotient(ContactsBySize::Fractions x,
                                   const ContactsBySize::Fractions& y) {
    for (std::size_t r = 0; r < x.size(); ++r) {
        x[r] /= y[r];
    }
    return x;
}

} // namespace

QuotedExtent read_quoted_extent(const Claim& claim) {
    const auto number = [&](std::string_view key) {
        return formula::Exact::parse(claim.text(key)).to<Float128>();
    };
    const auto terms = [&](std::string_view key) {
        const long n = claim.integer(key);
        if (n < 1 || n > 4) {
            claim.reject(key, "an approximation of " + std::to_string(n) + " terms",
                         "write 1 to 4");
        }
        return static_cast<std::size_t>(n);
    };
    QuotedExtent q;
    q.id = claim.id;
    for (const char* name : {"edge", "terms", "over_terms", "tolerance", "figure", "unit"}) {
        q.key += "/" + claim.text_or(name, "");
    }
    const contact::Edge edge = claim.edge();
    q.of = {edge, terms("terms"), number("tolerance")};
    if (claim.has("over_terms")) {
        q.over = ExtentOf{edge, terms("over_terms"), q.of.tolerance};
    }
    q.figure = formula::Exact::parse(claim.text("figure")).rational();
    q.unit = formula::Exact::parse(claim.text("unit")).rational();
    q.tolerance = formula::Exact::parse(claim.text("tolerance"));
    const Float128 half = number("unit") / 2;
    q.lower = number("figure") - half;
    q.upper = number("figure") + half;
    if (!(half > 0) || !(q.of.tolerance > 0)) {
        claim.reject("unit", "a unit or a tolerance that is not positive",
                     "give both as positive numbers, such as 1/100");
    }
    return q;
}

ContactsBySize::Fractions extents_of(const QuotedExtent& q, ContactsBySize::At& contact) {
    const ContactsBySize::Fractions x = contact.fractions(q.of);
    return q.over ? quotient(x, contact.fractions(*q.over)) : x;
}
ContactsBySize::Fractions rough_extents_of(const QuotedExtent& q, ContactsBySize::At& contact) {
    const ContactsBySize::Fractions x = contact.rough_fractions(q.of);
    return q.over ? quotient(x, contact.rough_fractions(*q.over)) : x;
}

std::vector<QuotedExtent> companion_extents(const Claim& claim, const AuditContext& context) {
    std::vector<QuotedExtent> all;
    if (!claim.has("together")) {
        return all;
    }
    for (const std::string& id : claim.list("together")) {
        const auto& claims = context.ledger().claims;
        const auto it = std::find_if(claims.begin(), claims.end(), [&](const Claim& c) {
            return c.id == id && c.kind == size_extent_kind_name &&
                   c.text("over") == claim.text("over");
        });
        if (it == claims.end()) {
            claim.reject("together",
                         "there is no claim " + id + " of this kind over the same scene",
                         "name claims of kind " + std::string(size_extent_kind_name) + " over " +
                             claim.text("over"));
        }
        all.push_back(read_quoted_extent(*it));
    }
    return all;
}

} // namespace edgeproof::audit
