// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/formula/parse.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace edgeproof::audit {

/// A field of a ledger: text, a list of texts, or a table of lists; and the line it stands on.
/// Integers are their text; floats of more than 15 significant digits must be quoted.
struct Field {
    using List = std::vector<std::string>;
    using Table = std::vector<std::pair<std::string, List>>;
    std::variant<std::string, List, Table> value;
    std::size_t line = 0;
};
using Fields = std::map<std::string, Field, std::less<>>;

/// What a formula of a claim may name, and what stands for the names that the ledger defines.
struct Vocabulary {
    formula::Symbols symbols;
    /// Bodies for names defined by the ledger or the claim: `name` or `name(argument)`.
    struct Definition {
        std::string name;
        std::optional<std::string> argument;
        formula::Expr body;
    };
    std::vector<Definition> definitions;
    /// Names that have no meaning in the family of the claim: what is wrong, and what to write.
    struct Refusal {
        std::string problem;
        std::string instead;
    };
    std::map<std::string, Refusal, std::less<>> refused = {};
};

/// "lhs < rhs", with <, <=, >, >= or =.
struct Relation {
    enum class Op { less, less_equal, greater, greater_equal, equal };
    formula::Expr lhs;
    Op op = Op::less;
    formula::Expr rhs;
};
/// Whether the relation holds between two values.
template <class Number>
[[nodiscard]] bool compare(Relation::Op op, const Number& lhs, const Number& rhs) {
    switch (op) {
    case Relation::Op::less:
        return lhs < rhs;
    case Relation::Op::less_equal:
        return lhs <= rhs;
    case Relation::Op::greater:
        return lhs > rhs;
    case Relation::Op::greater_equal:
        return lhs >= rhs;
    case Relation::Op::equal:
        break;
    }
    return lhs == rhs;
}

/// All of them must hold: "0 < x and x < a". "0 < x < a" is two.
using Condition = std::vector<Relation>;

/// One printed claim: a row's part, as the ledger has it. Its formulas are parsed once, when the
/// ledger is read.
struct Claim {
    std::string id;
    std::string kind;
    std::string printed;                       ///< TeX, letter for letter
    std::pair<std::size_t, std::size_t> lines; ///< of the source
    std::string file;                          ///< the ledger
    std::size_t line = 0;                      ///< in the ledger
    Fields fields;                             ///< all keys but id, lines, printed, kind
    /// The claim under each other way to take its words: what a reading gives in place of the
    /// claim's own fields, and the rest of them.
    std::vector<Claim> readings;
    /// Names in `says` that the source does not define.
    std::vector<std::string> undefined;
    std::string reading; ///< of a reading: its text
    Vocabulary vocabulary;

    [[nodiscard]] bool has(std::string_view key) const { return fields.contains(key); }
    /// nullptr if there is none.
    [[nodiscard]] const Field* find(std::string_view key) const;
    /// The readers below throw InputError naming the line, if the field is missing or not of the
    /// kind asked for.
    [[nodiscard]] const std::string& text(std::string_view key) const;
    [[nodiscard]] std::string text_or(std::string_view key, std::string_view otherwise) const;
    /// The edge that it speaks of: the right one, unless `edge` says otherwise.
    [[nodiscard]] contact::Edge edge() const;
    [[nodiscard]] long integer(std::string_view key) const;
    [[nodiscard]] long integer_or(std::string_view key, long otherwise) const;
    [[nodiscard]] const Field::List& list(std::string_view key) const;
    [[nodiscard]] const Field::Table& table(std::string_view key) const;
    /// The fields that are formulas, as read below: with all definitions put in, so that only names
    /// that an EvaluatedScene knows are left ...
    [[nodiscard]] const formula::Expr& formula(std::string_view key) const;
    [[nodiscard]] const Condition& condition(std::string_view key) const;
    [[nodiscard]] const std::vector<formula::Expr>& formulas(std::string_view key) const;
    /// ... and as written. The second: nullptr for a field that is no formula, or none at all.
    [[nodiscard]] const formula::Expr& written(std::string_view key) const;
    [[nodiscard]] const formula::Expr* find_written(std::string_view key) const;

    /// Parse a field in the vocabulary: a formula, a condition, a list of formulas, a table of them
    /// (whose formulas stand in the table's order). Throw InputError at the field's line.
    void read_formula(std::string_view key);
    void read_condition(std::string_view key);
    void read_formulas(std::string_view key);
    void read_formula_table(std::string_view key);
    /// Another text for a formula, which is read.
    void replace_formula(std::string_view key, std::string text);

    /// `problem; instead` at the line of a field (or of the claim, if it has no such field).
    [[noreturn]] void reject(std::string_view key, const std::string& problem,
                             const std::string& instead) const;

private:
    struct Parsed {
        std::vector<formula::Expr> written;
        std::vector<formula::Expr> formulas;
        Condition condition;
    };
    void read(std::string_view key, const std::vector<std::string>& texts);
    [[nodiscard]] const Parsed& parsed(std::string_view key) const;
    std::map<std::string, Parsed, std::less<>> parsed_;
};

/// Parses text in a vocabulary, dotted names ("right.c1") being one name with an underscore.
/// Throws FormulaError.
[[nodiscard]] formula::Expr parse_formula(std::string_view text, const Vocabulary& vocabulary);
[[nodiscard]] Condition parse_condition(std::string_view text, const Vocabulary& vocabulary);
/// The expression with all definitions put in. Throws InputError for definitions in a circle and
/// for names that the vocabulary refuses.
[[nodiscard]] formula::Expr expand_definitions(const formula::Expr& e,
                                               const Vocabulary& vocabulary);

} // namespace edgeproof::audit
