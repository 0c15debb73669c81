// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"
#include "edgeproof/certificate/certificate.hpp"

#include <string>

namespace edgeproof::test {

/// Returns the certificate of the only claim of a ledger with these definitions.
inline certificate::Certificate only_certificate(const std::string& family,
                                                 const std::string& claim,
                                                 const std::string& define = "") {
    const audit::Ledger ledger = audit::parse_ledger(
        "[ledger]\nname = \"own\"\n[define]\n" + define + "[[family]]\nname = \"family\"\n" +
            family + "[[claim]]\nid = \"own\"\nprinted = \"own\"\nover = \"family\"\n" + claim,
        "own.toml");
    audit::AuditOptions options;
    options.digits = 30;
    const audit::AuditResult result = audit::run_audit(ledger, options);
    return certificate::certify(result.claims.at(0), ledger);
}

/// A family of two flat punches with rounded edges.
inline std::string flat(const std::string& t, const std::string& a) {
    return "profile = \"flat-and-rounded\"\ncount = 2\n[family.parameters]\nt = " + t +
           "\nR = [\"3\"]\na = " + a + "\nEs = [\"7/3\"]\n";
}

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

} // namespace edgeproof::test
