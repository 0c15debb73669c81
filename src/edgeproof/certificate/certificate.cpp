// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/certificate.hpp"

#include "edgeproof/certificate/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace edgeproof::certificate {
namespace {

/// Text inside a comment of Coq: no comment opens, closes, or begins a string in it.
std::string in_comment(std::string text) {
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"(*", "( *"}, {"*)", "* )"}, {"\"", "''"}}) {
        for (std::size_t at = text.find(from); at != std::string::npos;
             at = text.find(from, at + to.size())) {
            text.replace(at, from.size(), to);
        }
    }
    return text;
}

} // namespace

std::string coq_name(const std::string& id) {
    std::string name = id;
    for (char& c : name) {
        const bool plain =
            (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        c = plain ? c : '_';
    }
    // Names of the files that certificates are stated in, and words that Coq keeps to itself.
    static constexpr auto taken = std::to_array<std::string_view>(
        {"Contact",  "Coefficients", "Edges",       "FlatAndRounded",
         "Hertz",    "Tactics",      "TiltedWedge", "Shear",
         "PowerLaw", "Expansions",   "Definition",  "Lemma",
         "Theorem",  "Prop",         "Set",         "SProp",
         "Type",     "as",           "at",          "cofix",
         "else",     "end",          "exists",      "exists2",
         "fix",      "for",          "forall",      "fun",
         "if",       "in",           "let",         "match",
         "mod",      "return",       "then",        "using",
         "where",    "with"});
    const bool letter = !name.empty() && (name.front() < '0' || name.front() > '9');
    const bool is_taken = std::find(taken.begin(), taken.end(), name) != taken.end();
    return letter && !is_taken ? name : "claim_" + name;
}

std::vector<std::string> profiles_of(const audit::Ledger& ledger, std::string_view family) {
    const audit::Family& f = ledger.family(family);
    if (f.union_of.empty()) {
        return {f.profile};
    }
    std::vector<std::string> all;
    for (const std::string& member : f.union_of) {
        for (std::string& profile : profiles_of(ledger, member)) {
            all.push_back(std::move(profile));
        }
    }
    return all;
}

std::string file_head(const audit::Claim& claim, const audit::Ledger& ledger,
                      const Theory& theory) {
    std::string imports;
    for (const std::string& file : theory.imports) {
        imports += " " + file;
    }
    return fmt::format(
        "(* Claim {} of the ledger {}, lines {} to {} of its source.\n   Printed: {}\n   Says: {} "
        "*)\n"
        "From Coq Require Import Reals Lra.\nFrom Coquelicot Require Import Coquelicot.\n"
        "From Interval Require Import Tactic.\nFrom Edgeproof Require Import{}.\nOpen Scope "
        "R_scope.\n\n",
        in_comment(claim.id), in_comment(ledger.name), claim.lines.first, claim.lines.second,
        in_comment(claim.printed), claim.has("says") ? in_comment(claim.text("says")) : "in words",
        imports);
}

Certificate certify(const audit::ClaimResult& result, const audit::Ledger& ledger) {
    Certificate certificate;
    certificate.id = result.claim.id;
    certificate.verdict = std::string(name_of(result.outcome.verdict));
    certificate.file = coq_name(result.claim.id) + ".v";
    static const std::map<std::string_view, decltype(&certify_identity)> kinds{
        {"identity", certify_identity}, {"value", certify_value},
        {"extent", certify_extent},     {"expansion", certify_expansion},
        {"monotone", certify_monotone}, {"vanishing", certify_vanishing}};
    try {
        const auto kind = kinds.find(result.claim.kind);
        if (kind == kinds.end()) {
            throw NotStated(fmt::format("claims of kind {} are not stated", result.claim.kind));
        }
        kind->second(result, ledger, certificate);
    } catch (const NotStated& reason) {
        certificate.theorems.clear();
        certificate.text.clear();
        certificate.leaves_out = reason.what();
    }
    return certificate;
}

} // namespace edgeproof::certificate
