// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/claim.hpp"

#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace edgeproof::audit {
namespace {

constexpr std::size_t most_shown_reading = 60;

bool is_name_start(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Replaces the dot in a name ("right.c1") by an underscore; columns stay the same.
std::string undotted(std::string_view text) {
    std::string plain(text);
    bool in_word = false; // a name or a number
    bool in_name = false;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        if (is_name(plain[i])) {
            in_name = in_word ? in_name : is_name_start(plain[i]);
            in_word = true;
        } else if (plain[i] == '.' && in_name && i + 1 < plain.size() &&
                   is_name_start(plain[i + 1])) {
            plain[i] = '_';
        } else {
            in_word = in_name = false;
        }
    }
    return plain;
}

/// Returns the definition of a name or function; nullptr if it has none.
const Vocabulary::Definition* definition_of(const Expr& e, const Vocabulary& vocabulary) {
    const bool call = e.kind() == Expr::Kind::call;
    if (!call && e.kind() != Expr::Kind::symbol) {
        return nullptr;
    }
    const auto it = std::ranges::find_if(vocabulary.definitions, [&](const auto& d) {
        return d.argument.has_value() == call && d.name == e.name();
    });
    return it == vocabulary.definitions.end() ? nullptr : &*it;
}

/// Replaces every defined name by its body, recursively. `replacing`: the names being replaced.
Expr expanded(const Expr& e, const Vocabulary& vocabulary, std::vector<std::string>& replacing) {
    std::vector<Expr> parts;
    parts.reserve(e.args().size());
    for (const Expr& part : e.args()) {
        parts.push_back(expanded(part, vocabulary, replacing));
    }
    if (const auto* d = definition_of(e, vocabulary)) {
        const formula::Replacing now(replacing, d->name);
        return expanded(d->argument ? substitute(d->body, *d->argument, parts.at(0)) : d->body,
                        vocabulary, replacing);
    }
    return parts.empty() ? e : Expr::with_args(e, std::move(parts));
}

struct Operator {
    std::string_view sign;
    Relation::Op op;
};
constexpr std::array operators{
    Operator{"<=", Relation::Op::less_equal}, Operator{">=", Relation::Op::greater_equal},
    Operator{"<", Relation::Op::less}, Operator{">", Relation::Op::greater},
    Operator{"=", Relation::Op::equal}};

} // namespace

Expr parse_formula(std::string_view text, const Vocabulary& vocabulary) {
    return parse(undotted(text), vocabulary.symbols);
}

std::string plain_formula(const std::string& text, const Vocabulary& vocabulary) {
    if (!formula::is_tex(text)) {
        return formula::with_products(text, undotted(text), vocabulary.symbols);
    }
    const std::string plain = formula::plain_from_tex(text, vocabulary.symbols);
    try {
        static_cast<void>(parse_formula(plain, vocabulary));
    } catch (const InputError& error) {
        throw InputError(error.problem() + " of '" + shortened(plain, most_shown_reading) +
                             "', as the formula is read",
                         error.instead());
    }
    return plain;
}

Condition parse_condition(std::string_view text,
                          const std::function<Expr(std::string_view)>& read_side) {
    Condition condition;
    constexpr std::string_view conjunction = " and ";
    while (true) {
        const std::size_t end = text.find(conjunction);
        std::string_view part = text.substr(0, end);
        std::vector<Expr> sides;
        std::vector<Relation::Op> ops;
        std::size_t from = 0;
        int depth = 0; // given(f, name = value) is no relation
        for (std::size_t i = 0; i < part.size();) {
            const auto* found = std::ranges::find_if(
                operators, [&](const Operator& o) { return part.substr(i).starts_with(o.sign); });
            depth += part[i] == '(' ? 1 : part[i] == ')' ? -1 : 0;
            if (found == operators.end() || depth > 0) {
                ++i;
                continue;
            }
            sides.push_back(read_side(part.substr(from, i - from)));
            ops.push_back(found->op);
            i += found->sign.size();
            from = i;
        }
        if (ops.empty()) {
            throw formula::FormulaError("'" + std::string(part) + "' contains no comparison",
                                        "write a condition such as x > 0 and x < a");
        }
        sides.push_back(read_side(part.substr(from)));
        for (std::size_t k = 0; k < ops.size(); ++k) {
            condition.push_back({sides[k], ops[k], sides[k + 1]});
        }
        if (end == std::string_view::npos) {
            return condition;
        }
        text.remove_prefix(end + conjunction.size());
    }
}

Expr expand_definitions(const Expr& e, const Vocabulary& vocabulary) {
    std::vector<std::string> replacing;
    Expr result = expanded(e, vocabulary, replacing);
    const std::set<std::string> names = free_symbols(result);
    for (const auto& [name, refusal] : vocabulary.refused) {
        if (names.contains(name) || holds_call(result, name)) {
            throw InputError(refusal.problem, refusal.instead);
        }
    }
    return result;
}

Field::List Field::texts() const {
    List all;
    if (const auto* one = std::get_if<std::string>(&value)) {
        all = {*one};
    } else if (const auto* list = std::get_if<List>(&value)) {
        all = *list;
    } else {
        for (const auto& [name, of_name] : std::get<Table>(value)) {
            all.insert(all.end(), of_name.begin(), of_name.end());
        }
    }
    return all;
}

const Field* Claim::find(std::string_view key) const {
    const auto it = fields.find(key);
    return it == fields.end() ? nullptr : &it->second;
}

void Claim::reject(std::string_view key, const std::string& problem,
                   const std::string& instead) const {
    const Field* field = find(key);
    throw InputError(problem, instead).at(file, field != nullptr ? field->line : line);
}

const std::string& Claim::text(std::string_view key) const {
    const Field* field = find(key);
    if (field == nullptr) {
        reject(key, "claim " + id + " has no " + std::string(key),
               "add " + std::string(key) + " = \"...\"");
    }
    if (const auto* value = std::get_if<std::string>(&field->value)) {
        return *value;
    }
    reject(key, std::string(key) + " of claim " + id + " is not a text",
           "write " + std::string(key) + " = \"...\"");
}

std::string Claim::text_or(std::string_view key, std::string_view otherwise) const {
    return has(key) ? text(key) : std::string(otherwise);
}

Edge Claim::edge() const { return text_or("edge", "right") == "right" ? Edge::right : Edge::left; }

long Claim::integer_or(std::string_view key, long otherwise) const {
    if (!has(key)) {
        return otherwise;
    }
    const std::string& value = text(key);
    long n = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), n);
    if (error != std::errc{} || end != value.data() + value.size()) {
        reject(key, std::string(key) + " = " + value + " is not an integer",
               "write " + std::string(key) + " = 1, for instance");
    }
    return n;
}

template <class Value>
const Value& Claim::value(std::string_view key, const std::string& what,
                          const std::string& example) const {
    const Field* field = find(key);
    const auto* value = field == nullptr ? nullptr : std::get_if<Value>(&field->value);
    if (value == nullptr) {
        reject(key, "claim " + id + " has no " + what + " " + std::string(key),
               "write " + std::string(key) + " = " + example);
    }
    return *value;
}

const Field::List& Claim::list(std::string_view key) const {
    return value<Field::List>(key, "list", "[\"...\", \"...\"]");
}

const Field::Table& Claim::table(std::string_view key) const {
    return value<Field::Table>(key, "table", "{ name = \"...\" }");
}

void Claim::read(const KeySpec& key) {
    using Type = KeySpec::Type;
    const std::string_view name = key.name;
    Parsed p;
    const auto add = [&](const std::string& text) {
        p.written.push_back(parse_formula(text, vocabulary));
        p.formulas.push_back(expand_definitions(p.written.back(), vocabulary));
    };
    try {
        switch (key.type) {
        case Type::figures:
            if (auto& value = fields.find(name)->second.value;
                std::holds_alternative<Field::List>(value)) {
                value = boost::algorithm::join(std::get<Field::List>(value), ", ");
            }
            [[fallthrough]];
        case Type::text:
            static_cast<void>(text(name));
            return;
        case Type::integer:
            static_cast<void>(integer_or(name, 0));
            return;
        case Type::number:
            static_cast<void>(Exact::parse(text(name)));
            return;
        case Type::list:
            static_cast<void>(list(name));
            return;
        case Type::table:
            static_cast<void>(table(name));
            return;
        case Type::choice:
            if (const std::string& chosen = text(name);
                std::ranges::find(key.choices, chosen) == key.choices.end()) {
                reject(name, std::string(name) + " = \"" + chosen + "\" is not known",
                       one_of(chosen, key.choices));
            }
            return;
        case Type::formula: {
            const std::string typed = text(name);
            const std::string plain = plain_formula(typed, vocabulary);
            add(plain);
            if (plain != typed) {
                fields.find(name)->second.value = plain;
                typed_.insert_or_assign(std::string(name), typed);
            }
            break;
        }
        case Type::formulas:
            std::ranges::for_each(list(name), add);
            break;
        case Type::formula_table:
            for (const auto& [of, values] : table(name)) {
                if (values.size() != 1) {
                    reject(name, of + " has " + std::to_string(values.size()) + " formulas",
                           "write " + std::string(name) + " = { \"" + of + "\" = \"...\" }");
                }
                add(values.front());
            }
            break;
        case Type::condition:
            p.condition = parse_condition(text(name), [&](std::string_view side) {
                return expand_definitions(parse_formula(side, vocabulary), vocabulary);
            });
            break;
        }
    } catch (const InputError& error) {
        reject(name, error.problem(), error.instead());
    }
    parsed_.insert_or_assign(std::string(name), std::move(p));
}

const std::string* Claim::typed(std::string_view key) const {
    const auto it = typed_.find(key);
    return it == typed_.end() ? nullptr : &it->second;
}

const Claim::Parsed& Claim::parsed(std::string_view key) const {
    const auto it = parsed_.find(key);
    if (it == parsed_.end()) {
        static_cast<void>(text(key)); // throws if the field is missing
        throw Error(std::string(key) + " of claim " + id + " is not a formula");
    }
    return it->second;
}

const Expr& Claim::formula(std::string_view key) const { return parsed(key).formulas.at(0); }

const Expr& Claim::written(std::string_view key) const { return parsed(key).written.at(0); }

const Expr* Claim::find_written(std::string_view key) const {
    const auto it = parsed_.find(key);
    return it == parsed_.end() || it->second.written.empty() ? nullptr
                                                             : &it->second.written.front();
}

const Condition& Claim::condition(std::string_view key) const { return parsed(key).condition; }

const std::vector<Expr>& Claim::formulas(std::string_view key) const {
    return parsed(key).formulas;
}

} // namespace edgeproof::audit
