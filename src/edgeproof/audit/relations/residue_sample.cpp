// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/relations/residue_sample.hpp"

#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"

#include <vector>

namespace edgeproof::audit {
namespace {

bool is_numbered(std::string_view name, char letter) {
    return name.size() == 2 && name[0] == letter && name[1] >= '1' && name[1] <= '9';
}

} // namespace

ResidueSample::ResidueSample(const SymbolicCase& under, std::uint64_t seed)
    : under_(under), random_(seed), pi_(draw()) {
    const auto root = Residue::root(symbol("L"));
    if (!root) {
        throw DomainError("a + b is not a square modulo the prime");
    }
    root_ = *root;
}

Residue ResidueSample::draw() const { return Residue::of(random_() >> 3U); }

Residue ResidueSample::symbol(std::string_view name) const {
    const auto it = known_.find(name);
    if (it != known_.end()) {
        return it->second;
    }
    const Residue value = meaning(name);
    known_.emplace(std::string(name), value);
    return value;
}

Residue ResidueSample::meaning(std::string_view name) const {
    const bool right = name.starts_with("right_");
    if (right || name.starts_with("left_")) {
        const auto k = static_cast<std::size_t>(name.back() - '0');
        return name[name.size() - 2] == 'c' ? pressure_multiplier(right, k)
                                            : shear_multiplier(right, k);
    }
    if (name == "L") {
        return symbol("a") + symbol("b");
    }
    if (const auto given = under_.names.find(name); given != under_.names.end()) {
        return formula::evaluate<Residue>(given->second, *this);
    }
    const bool force = name == "P" || is_numbered(name, 'P');
    const bool edge = name == "b" || is_numbered(name, 'b');
    if ((force && under_.P) || (edge && (under_.b || under_.symmetric))) {
        return formula::evaluate<Residue>(derive(Expr::symbol(name), under_), *this);
    }
    return draw();
}

Residue ResidueSample::pressure_multiplier(bool right, std::size_t k) const {
    // The formula of the left edge loses one order.
    const std::size_t n = right ? k + 1 : k + 2;
    std::vector<Residue> rate;
    std::vector<Residue> b;
    Residue factorial(1);
    for (std::size_t j = 0; j < n; ++j) {
        factorial *= j > 0 ? Residue(static_cast<int>(j)) : Residue(1);
        rate.push_back(symbol("P" + std::to_string(j + 1)) / factorial);
        b.push_back(symbol(j == 0 ? "b" : "b" + std::to_string(j)) / factorial);
    }
    const contact::LawSeries<Residue> law{series::Series<Residue>(std::move(rate)),
                                          series::Series<Residue>(std::move(b))};
    const Residue a = symbol("a");
    const std::vector<Residue> brackets = right ? contact::right_edge_brackets(law, a)
                                                : contact::left_edge_derivation(law, a).brackets;
    return brackets.at(k) / (pi_ * root_);
}

Residue ResidueSample::shear_multiplier(bool right, std::size_t k) const {
    const auto s = contact::full_stick_brackets<Residue>(
        symbol("Q") / pi_, symbol("sig0"), symbol("L"), right ? Edge::right : Edge::left, k + 1);
    return s.back() / root_;
}

} // namespace edgeproof::audit
