// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/certificate.hpp"

#include "edgeproof/certificate/coq_files.hpp"
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/io/file_stem.hpp"
#include "edgeproof/precision/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace edgeproof::certificate {
std::string in_comment(std::string text) {
    text = printable_lines(text);
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"(*", "( *"}, {"*)", "* )"}, {"\"", "''"}}) {
        for (std::size_t at = text.find(from); at != std::string::npos;
             at = text.find(from, at + to.size())) {
            text.replace(at, from.size(), to);
        }
    }
    return text;
}

namespace {

/// The keywords of Coq's reference manual (chapter "Basic notions", 8.16; `exists`, `exists2`,
/// `IF`, `mod` and `using` of its notations and of earlier versions), words that begin a statement,
/// and the names of the library that theorems use.
constexpr auto words_of_coq = std::to_array<std::string_view>(
    {"_",     "Axiom", "CoFixpoint", "Definition", "Fixpoint", "Hypothesis", "Parameter",
     "Prop",  "SProp", "Set",        "Theorem",    "Type",     "Variable",   "as",
     "at",    "cofix", "else",       "end",        "fix",      "for",        "forall",
     "fun",   "if",    "in",         "let",        "match",    "return",     "then",
     "where", "with",  "IF",         "exists",     "exists2",  "mod",        "using",
     "by",    "is",    "of",         "Lemma",      "Proof",    "Qed",        "Print",
     "R",     "PI",    "sqrt",       "exp",        "ln",       "sin",        "cos",
     "tan",   "asin",  "acos",       "atan",       "Rabs",     "Rpower",     "Rmax",
     "Rmin",  "Rplus", "Rmult",      "Rdiv",       "Rinv",     "is_RInt",    "RInt"});

/// Whether a Coq file defines or states something of that name.
bool defines(std::string_view file, std::string_view name) {
    constexpr auto starts = std::to_array<std::string_view>(
        {"Definition ", "Fixpoint ", "Inductive ", "Record ", "Lemma ", "Theorem ", "Ltac "});
    return std::any_of(starts.begin(), starts.end(), [&](std::string_view start) {
        const std::string sought = std::string(start) + std::string(name);
        for (std::size_t at = file.find(sought); at != std::string_view::npos;
             at = file.find(sought, at + 1)) {
            const std::size_t end = at + sought.size();
            if (end == file.size() ||
                std::string_view(" :\n({.").find(file[end]) != std::string_view::npos) {
                return true;
            }
        }
        return false;
    });
}

} // namespace

std::string coq_name(const std::string& id) {
    std::string name = io::FileStem(id).text();
    for (char& c : name) {
        const bool plain =
            (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        c = plain ? c : '_';
    }
    const bool letter = !name.empty() && (name.front() < '0' || name.front() > '9');
    const bool is_taken =
        std::find(words_of_coq.begin(), words_of_coq.end(), name) != words_of_coq.end() ||
        std::any_of(theory_files().begin(), theory_files().end(), [&](const TheoryFile& f) {
            return f.name == name || defines(f.content, name);
        });
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

std::string file_comment(const audit::Claim& claim, const audit::Ledger& ledger) {
    return fmt::format(
        "(* Claim {} of the ledger {}, lines {} to {} of its source.\n   Printed: {}\n"
        "   Says: {} *)\n",
        in_comment(claim.id), in_comment(ledger.name), claim.lines.first, claim.lines.second,
        in_comment(claim.printed), claim.has("says") ? in_comment(claim.text("says")) : "in words");
}

std::string imports_text(const std::vector<std::string>& files) {
    std::string text = "From Coq Require Import Reals Lra.\nFrom Coquelicot Require Import "
                       "Coquelicot.\nFrom Interval Require Import Tactic.\nFrom Edgeproof Require "
                       "Import";
    for (const std::string& file : files) {
        text += " " + file;
    }
    return text + ".\nOpen Scope R_scope.\n\n";
}

std::string file_head(const audit::Claim& claim, const audit::Ledger& ledger,
                      const Theory& theory) {
    return file_comment(claim, ledger) + imports_text(theory.imports);
}

Certificate certify(const audit::ClaimResult& result, const audit::Ledger& ledger) {
    Certificate certificate;
    certificate.id = result.claim.id;
    certificate.verdict = std::string(name_of(result.outcome.verdict));
    certificate.file = coq_name(result.claim.id) + ".v";
    static const std::map<std::string_view, decltype(&certify_identity)> kinds{
        {"identity", certify_identity},     {"value", certify_value},
        {"extent", certify_extent},         {"expansion", certify_expansion},
        {"monotone", certify_monotone},     {"vanishing", certify_vanishing},
        {"uniformity", certify_uniformity}, {"figure", certify_figure}};
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
