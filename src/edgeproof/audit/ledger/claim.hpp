// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/formula/parse.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace edgeproof::audit {

using contact::Edge;
using formula::Exact;
using formula::Expr;
using formula::order_behind;

/// A field of a ledger: text, a list of texts, or a table of lists, and its line in the file.
/// Integers are stored as text; floats of more than 15 significant digits must be quoted.
struct Field {
    using List = std::vector<std::string>;
    using Table = std::vector<std::pair<std::string, List>>;
    std::variant<std::string, List, Table> value;
    std::size_t line = 0;
    /// All texts, without the names of a table.
    [[nodiscard]] List texts() const;
};
using Fields = std::map<std::string, Field, std::less<>>;

/// The names that a formula of a claim may use, and the definitions of names by the ledger.
struct Vocabulary {
    formula::Symbols symbols;
    /// The body of a name that the ledger or the claim defines: `name` or `name(argument)`.
    struct Definition {
        std::string name;
        std::optional<std::string> argument;
        Expr body;
    };
    std::vector<Definition> definitions;
    /// A name without a meaning in the family: the problem, and what to write instead.
    struct Refusal {
        std::string problem;
        std::string instead;
    };
    std::map<std::string, Refusal, std::less<>> refused = {};
};

/// "lhs < rhs", with <, <=, >, >= or =.
struct Relation {
    enum class Op { less, less_equal, greater, greater_equal, equal };
    Expr lhs;
    Op op = Op::less;
    Expr rhs;
};
/// A conjunction of relations: "0 < x and x < a". "0 < x < a" is read as two relations.
using Condition = std::vector<Relation>;

struct CheckKind;
struct KeySpec;

/// One printed claim, as a row of the ledger gives it. Its formulas are parsed once, when the
/// ledger is read.
struct Claim {
    std::string id;
    std::string kind;
    const CheckKind* check = nullptr;          ///< that kind
    std::string printed;                       ///< TeX, exactly as printed
    std::pair<std::size_t, std::size_t> lines; ///< in the source
    std::string file;                          ///< the file of the ledger
    std::size_t line = 0;                      ///< in the ledger
    Fields fields;                             ///< all keys except id, lines, printed, kind
    /// The claim under each possible reading of its words: the fields given by the reading replace
    /// the claim's own fields.
    std::vector<Claim> readings;
    /// Names in `says` that the source does not define.
    std::vector<std::string> undefined;
    std::string reading; ///< the text of the reading, if this is one
    Vocabulary vocabulary;

    [[nodiscard]] bool has(std::string_view key) const { return fields.contains(key); }
    /// Returns nullptr if the field is missing.
    [[nodiscard]] const Field* find(std::string_view key) const;
    /// These throw InputError with the line if the field is missing or has another type.
    [[nodiscard]] const std::string& text(std::string_view key) const;
    [[nodiscard]] std::string text_or(std::string_view key, std::string_view otherwise) const;
    /// The edge that the claim is about: the right one, unless the field `edge` is given.
    [[nodiscard]] Edge edge() const;
    [[nodiscard]] long integer_or(std::string_view key, long otherwise) const;
    [[nodiscard]] const Field::List& list(std::string_view key) const;
    [[nodiscard]] const Field::Table& table(std::string_view key) const;
    /// Fields with all definitions put in, so that only names of an EnclosedSample are left.
    [[nodiscard]] const Expr& formula(std::string_view key) const;
    [[nodiscard]] const Condition& condition(std::string_view key) const;
    [[nodiscard]] const std::vector<Expr>& formulas(std::string_view key) const;
    /// Fields as written. find_written returns nullptr if there is no such formula.
    [[nodiscard]] const Expr& written(std::string_view key) const;
    [[nodiscard]] const Expr* find_written(std::string_view key) const;

    /// The text of a formula in the ledger if it is not the text that text() returns: LaTeX, or
    /// products without `*`, which read() replaces. nullptr otherwise.
    [[nodiscard]] const std::string* typed(std::string_view key) const;

    /// Checks the field of a key and parses its formulas in the vocabulary. Throws InputError at
    /// the field's line.
    void read(const KeySpec& key);

    /// Throws `problem; instead` at the line of a field (of the claim, if it has no such field).
    [[noreturn]] void reject(std::string_view key, const std::string& problem,
                             const std::string& instead) const;

private:
    struct Parsed {
        std::vector<Expr> written;
        std::vector<Expr> formulas;
        Condition condition;
    };
    template <class Value>
    [[nodiscard]] const Value& value(std::string_view key, const std::string& what,
                                     const std::string& example) const;
    [[nodiscard]] const Parsed& parsed(std::string_view key) const;
    std::map<std::string, Parsed, std::less<>> parsed_;
    std::map<std::string, std::string, std::less<>> typed_;
};

/// Returns a formula of a ledger as plain text with every `*` (formula::with_products,
/// formula::plain_from_tex). Throws InputError.
[[nodiscard]] std::string plain_formula(const std::string& text, const Vocabulary& vocabulary);

/// Parses a text in a vocabulary. A dotted name ("right.c1") is one name, with an underscore
/// instead of the dot. Throws FormulaError.
[[nodiscard]] Expr parse_formula(std::string_view text, const Vocabulary& vocabulary);
/// Reads a condition, and each side of its relations by `read_side`. Throws FormulaError.
[[nodiscard]] Condition parse_condition(std::string_view text,
                                        const std::function<Expr(std::string_view)>& read_side);
/// Returns the expression with all definitions put in. Throws InputError for circular definitions
/// and for names that the vocabulary refuses.
[[nodiscard]] Expr expand_definitions(const Expr& e, const Vocabulary& vocabulary);

class AuditContext;
struct Outcome;

/// A key of the claims of one kind.
struct KeySpec {
    enum class Type {
        text,      ///< any text
        figures,   ///< a text, or a list of texts, which is kept as one text with commas
        formula,   ///< parsed, with its names checked, when the ledger is read
        condition, ///< "x > 0 and x < a", parsed in the same way
        number,    ///< an exact constant: "1/100", not "1 %"
        integer,
        list,          ///< of texts
        formulas,      ///< a list of formulas
        table,         ///< name = text or list of texts
        formula_table, ///< name = formula
        choice,        ///< one of `choices`
    };
    std::string_view name;
    Type type = Type::text;
    bool required = false;
    std::vector<std::string_view> choices = {};
    std::string_view unless = {}; ///< not required if the claim has this key
};

/// A kind of claim, defined in checks/.
struct CheckKind {
    std::string_view name;
    /// First those of every kind: over, edge, where, with, vary, points, sizes, remark, decimals.
    std::vector<KeySpec> keys;
    std::function<Outcome(const Claim&, const AuditContext&)> check;
};

/// Returns all kinds, in the order of checks/kinds.cpp.
[[nodiscard]] const std::vector<CheckKind>& check_kinds();
} // namespace edgeproof::audit
