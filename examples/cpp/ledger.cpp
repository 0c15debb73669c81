// SPDX-License-Identifier: BSD-3-Clause
// Formulas as they are printed somewhere, verified: one that is right and one whose sign is wrong.
// The ledger could as well stand in a file: audit::read_ledger("paper.toml").
#include "edgeproof/audit/run.hpp"

#include <iostream>

int main() {
    using namespace edgeproof;

    const char* const text = R"toml(
[ledger]
name = "Hertz"
[[family]]                 # the contacts that formulas are evaluated for
name = "hertz"
profile = "power-law"
count = 4
u = ["1e-30", "1/5"]
[family.parameters]
m = ["1"]
C = ["3/7", "1e-6"]
a = ["3/2", "0.02"]
Es = ["7/3", "2.1e11"]
[[claim]]
id = "pressure"
kind = "compare"
says = "Es*C/2*sqrt(a^2 - x^2)"
of = "p(x)"
over = "hertz"
[[claim]]
id = "second-coefficient"
kind = "compare"
says = "Es*C/(4*sqrt(2*a))"
of = "right.c1"
over = "hertz"
)toml";
    try {
        const audit::Ledger ledger = audit::parse_ledger(text, "hertz.toml");
        audit::AuditOptions options;
        options.digits = 40;
        for (const audit::ClaimResult& r : audit::run_audit(ledger, options).claims) {
            std::cout << r.claim.id << ": " << audit::name_of(r.outcome.verdict) << '\n';
            if (r.outcome.correct) { // itself verified
                std::cout << "  correct: " << *r.outcome.correct << '\n';
            }
        }
    } catch (const Error& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
