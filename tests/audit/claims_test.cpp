// SPDX-License-Identifier: BSD-3-Clause
// The claims of the tables claims/*.txt. Their lines are (\ continues a line):
//     ledger NAME                         begins the families and the rows of a ledger
//     family NAME | KEY = VALUE, ... | ...     a family: keys and lists of parameters
//     define NAME = FORMULA
//     rows [at N digits] | COLUMN | KEY = VALUE | ... [-> EXPECTED]
//     CELL | ... | KEY = VALUE [-> EXPECTED]
// A row is a claim: a cell for each COLUMN, then further keys; the KEY = VALUE of `rows` are added,
// with $COLUMN in them replaced. A cell with // between two values makes a claim of each value, and
// EXPECTED with // has the result of each. The keys `family` (KEY = VALUE; -KEY) and `with` (TOML)
// change the ledger of one row: the first adds or removes keys of the family `over`.
//     EXPECTED: VERDICT & KEY = TEXT & KEY ~ PART & KEY > NUMBER & "PART OF THE NOTE"
// VERDICT is a verdict, !VERDICT, `holds`, `open` (undecided or underspecified) or `refused` (then
// "PART" is of the message). KEY is a path in the evidence (a/b/0), or correct, computed, typed,
// read, rounded, basis.
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/run.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace {

using Cells = std::vector<std::string>;
using Fields = std::vector<std::pair<std::string, std::string>>;

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(' ');
    return begin == std::string::npos ? ""
                                      : text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

Cells split(const std::string& text, const std::string& by) {
    Cells cells = test::parts(text, by);
    std::ranges::transform(cells, cells.begin(), trimmed);
    return cells;
}

std::pair<std::string, std::string> assignment(const std::string& cell) {
    const std::size_t at = cell.find('=');
    REQUIRE_MESSAGE(at != std::string::npos, cell);
    return {trimmed(cell.substr(0, at)), trimmed(cell.substr(at + 1))};
}

void set(Fields& fields, const std::string& key, const std::string& value) {
    const auto found = std::ranges::find(fields, key, &Fields::value_type::first);
    (found == fields.end() ? fields.emplace_back(key, "") : *found).second = value;
}

const std::string& get(const Fields& fields, const std::string& key) {
    static const std::string none;
    const auto found = std::ranges::find(fields, key, &Fields::value_type::first);
    return found == fields.end() ? none : found->second;
}

/// "a, f(b, c)" as a list of two texts in TOML.
std::string list_of(const std::string& text) {
    std::string out;
    int depth = 0;
    for (const char c : text) {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c != ' ' || !out.ends_with("', '")) {
            out += c == ',' && depth == 0 ? "', '" : std::string(1, c);
        }
    }
    return text.empty() ? "[]" : "['" + out + "']";
}

std::string toml_of(const std::string& key, const std::string& value) {
    const bool whole = key == "terms" || key == "over_terms" || key == "order";
    const bool list = value.starts_with('[') && value.find_first_of("\"'") == std::string::npos;
    const bool raw = value.starts_with('{') || value.starts_with('[') || whole;
    return key + " = " +
           (list  ? list_of(value.substr(1, value.size() - 2))
            : raw ? value
                  : "'" + value + "'") +
           '\n';
}

struct TabledLedger {
    std::string name;
    std::vector<std::pair<std::string, Fields>> families;
    std::string definitions;

    [[nodiscard]] std::string text(const std::string& over, const std::string& change) const {
        std::string all = "[ledger]\nname = \"" + name + "\"\n" + definitions;
        for (auto [family, fields] : families) {
            if (family == over && !change.empty()) {
                for (const std::string& each : split(change, ";")) {
                    if (each.starts_with('-')) {
                        std::erase_if(fields,
                                      [&](const auto& f) { return f.first == each.substr(1); });
                    } else {
                        const auto [key, value] = assignment(each);
                        set(fields, key, value);
                    }
                }
            }
            std::string own;
            all += "[[family]]\nname = \"" + family + "\"\n";
            for (const auto& [key, value] : fields) {
                const bool is_list =
                    key == "u" || key == "knots" || key == "slopes" || key == "union";
                (key == "profile" || key == "geometry"
                     ? all += toml_of(key, value)
                     : (key == "count" ? all
                        : is_list      ? all
                                       : own) +=
                       key + " = " + (key == "count" ? value : list_of(value)) + '\n');
            }
            all += own.empty() ? "" : "[family.parameters]\n" + own;
        }
        return all;
    }
};

struct TabledClaim {
    std::string place; ///< the file and the line of the row
    Fields fields;
    std::string expected;
};

/// The claims that are judged together, by the families, what follows the claims, and the digits.
using Bundle = std::tuple<std::string, std::string, unsigned>;
using Bundles = std::map<Bundle, std::vector<TabledClaim>>;

/// Returns the fields for each combination of the values that // separates.
std::vector<Fields> each_value(const Fields& fields) {
    std::vector<Fields> all{{}};
    for (const auto& [key, values] : fields) {
        std::vector<Fields> longer;
        for (const Fields& begun : all) {
            for (const std::string& value : split(values, " // ")) {
                longer.push_back(begun);
                longer.back().emplace_back(key, value);
            }
        }
        all = std::move(longer);
    }
    return all;
}

/// Puts the columns into the constants that name them, and adds the other columns.
Fields put_in(const Fields& columns, Fields constants) {
    Fields all;
    for (const auto& [column, text] : columns) {
        const std::string name = "$" + column;
        bool named = text.empty();
        for (auto& [key, value] : constants) {
            for (std::size_t at = 0; (at = value.find(name, at)) != std::string::npos;
                 at += text.size()) {
                value.replace(at, name.size(), text);
                named = true;
            }
        }
        if (!named) {
            all.emplace_back(column, text);
        }
    }
    std::ranges::copy(constants, std::back_inserter(all));
    return all;
}

class Table {
public:
    explicit Table(const std::string& name) {
        for (const auto& [place, line] : test::table_lines("audit/claims/" + name + ".txt")) {
            place_ = place;
            read(line);
        }
    }
    Bundles bundles;

private:
    void read(const std::string& line) {
        CAPTURE(place_);
        if (line.starts_with("ledger ")) {
            ledger_ = {line.substr(7), {}, ""};
        } else if (line.starts_with("define ")) {
            const auto [name, formula] = assignment(line.substr(7));
            ledger_.definitions += (ledger_.definitions.empty() ? "[define]\n" : "") +
                                   ('"' + name) + "\" = '" + formula + "'\n";
        } else if (line.starts_with("family ")) {
            const Cells cells = split(line.substr(7), "|");
            ledger_.families.emplace_back(cells[0], Fields());
            for (std::size_t k = 1; k < cells.size(); ++k) {
                ledger_.families.back().second.push_back(assignment(cells[k]));
            }
        } else if (line.starts_with("rows")) {
            std::tie(head_, head_expected_) = halves(line.substr(4));
            digits_ = head_[0].empty() ? 34 : static_cast<unsigned>(std::stoul(head_[0].substr(3)));
        } else {
            add_row(line);
        }
    }

    /// The cells of a line, and the result after the arrow.
    static std::pair<Cells, std::string> halves(const std::string& line) {
        const std::size_t arrow = line.find(" -> ");
        return {split(line.substr(0, arrow), " |"),
                arrow == std::string::npos ? "" : line.substr(arrow + 4)};
    }

    void add_row(const std::string& line) {
        const auto [cells, expected] = halves(line);
        Fields row;
        Fields constants;
        std::size_t used = 0;
        for (std::size_t k = 1; k < head_.size(); ++k) {
            const std::string& cell = head_[k];
            if (cell.find('=') != std::string::npos) {
                constants.push_back(assignment(cell));
            } else {
                row.emplace_back(cell, used < cells.size() ? cells[used] : "");
                ++used;
            }
        }
        for (; used < cells.size(); ++used) {
            const auto field = assignment(cells[used]);
            std::erase_if(constants, [&](const auto& f) { return f.first == field.first; });
            set(row, field.first, field.second);
        }
        std::vector<Fields> claims;
        for (const Fields& one : each_value(row)) {
            std::ranges::copy(each_value(put_in(one, constants)), std::back_inserter(claims));
        }
        const Cells results = split(expected.empty() ? head_expected_ : expected, " // ");
        REQUIRE_MESSAGE(claims.size() % results.size() == 0, place_);
        for (std::size_t i = 0; i < claims.size(); ++i) {
            const Fields& fields = claims[i];
            std::string with = get(fields, "with");
            with.replace(std::min(with.find("\\n"), with.size()), 2, "\n");
            bundles[{ledger_.text(get(fields, "over"), get(fields, "family")), with, digits_}]
                .push_back({place_, fields, results[i % results.size()]});
        }
    }

    std::string place_;
    TabledLedger ledger_;
    Cells head_;
    std::string head_expected_;
    unsigned digits_ = 34;
};

/// The text of an item of the evidence; those of a list are separated by commas.
std::string item_text(const Evidence& item) {
    std::string text;
    for (const Evidence& part : item.is_array() ? item : Evidence::array()) {
        text += (text.empty() ? "" : ", ") + item_text(part);
    }
    return item.is_array()     ? text
           : item.is_boolean() ? (item.get<bool>() ? "yes" : "no")
           : item.is_string()  ? item.get<std::string>()
                               : item.dump();
}

std::string evidence_text(const Evidence& evidence, const std::string& path) {
    const Evidence::json_pointer pointer("/" + path);
    return evidence.contains(pointer) ? item_text(evidence.at(pointer)) : "missing";
}

std::string value_of(const ClaimResult& r, const std::string& key) {
    const Outcome& o = r.outcome;
    const std::string* typed = r.claim.typed("says");
    return key == "correct"    ? o.correct.value_or("none")
           : key == "computed" ? o.computed.value_or("none")
           : key == "typed"    ? (typed == nullptr ? "no" : *typed)
           : key == "read"     ? r.claim.text("says")
           : key == "rounded"  ? (is_rounded(o) ? "yes" : "no")
           : key == "basis"    ? (basis_of(r) == Basis::enclosures ? "enclosures" : "other")
                               : evidence_text(o.evidence, key);
}

/// The result of a claim: the verdict with the note, or the refusal.
struct Found {
    const ClaimResult* result = nullptr;
    std::string verdict = "missing";
    std::string note;
};

bool is_met(const Found& found, const std::string& part) {
    if (part.starts_with('"')) {
        return found.note.find(part.substr(1, part.size() - 2)) != std::string::npos;
    }
    const std::size_t at =
        std::min({part.find(" = "), part.find(" ~ "), part.find(" !~ "), part.find(" > ")});
    if (at != std::string::npos) {
        const std::size_t end = part.find(' ', at + 1);
        const std::string sign = part.substr(at + 1, end - at - 1);
        const std::string wanted = part.substr(end + 1);
        const std::string value =
            found.result == nullptr ? "missing" : value_of(*found.result, part.substr(0, at));
        const bool has = value.find(wanted) != std::string::npos;
        return sign == "="    ? value == wanted
               : sign == "~"  ? has
               : sign == "!~" ? !has
                              : value != "missing" && std::stod(value) > std::stod(wanted);
    }
    const std::string& v = found.verdict;
    return part.starts_with('!')
               ? v != "missing" && !is_met(found, part.substr(1)) && v != "refused"
           : part == "holds" ? v == "proved" || v == "confirmed"
           : part == "open"  ? v == "undecided" || v == "underspecified"
                             : v == part;
}

void check_bundle(const Bundle& bundle, std::vector<TabledClaim>& claims) {
    auto [text, with, digits] = bundle;
    for (std::size_t i = 0; i < claims.size(); ++i) {
        if (get(claims[i].fields, "id").empty()) {
            set(claims[i].fields, "id", "C" + std::to_string(i));
        }
        text += "[[claim]]\n";
        for (const auto& [key, value] : claims[i].fields) {
            text += key == "family" || key == "with" ? "" : toml_of(key, value);
        }
    }
    std::map<std::string, Found> found;
    AuditOptions options;
    options.digits = digits;
    options.errors = ClaimErrors::kept;
    AuditResult result;
    try {
        const Ledger read = parse_ledger(text + with, "L", ClaimErrors::kept);
        for (const ClaimError& e : read.errors) {
            found[e.id] = {nullptr, "refused", e.error.what()};
        }
        result = read.claims.empty() ? AuditResult() : run_audit(read, options);
        for (const ClaimResult& r : result.claims) {
            found[r.claim.id] = {&r, std::string(name_of(r.outcome.verdict)), r.outcome.note};
        }
        for (const ClaimError& e : result.errors) {
            found[e.id] = {nullptr, "refused", e.error.what()};
        }
    } catch (const InputError& error) {
        for (const TabledClaim& claim : claims) {
            found[get(claim.fields, "id")] = {nullptr, "refused", error.what()};
        }
    }
    for (const TabledClaim& claim : claims) {
        const Found& f = found[get(claim.fields, "id")];
        for (const std::string& part : split(claim.expected, " & ")) {
            CHECK_MESSAGE(is_met(f, part),
                          claim.place
                              << ": " << get(claim.fields, "of") << " ... "
                              << get(claim.fields, "says") << "\n  is not " << part << " but "
                              << f.verdict << ": " << f.note
                              << (f.result ? "; correct: " + value_of(*f.result, "correct") : ""));
        }
        const bool at_line =
            f.verdict != "refused" || (f.note.starts_with("L:") && f.note.find(": ") > 2);
        CHECK_MESSAGE(at_line, claim.place << ": no line in: " << f.note);
    }
}

void check_table(const std::string& name) {
    Table table(name);
    REQUIRE(!table.bundles.empty());
    for (auto& [bundle, claims] : table.bundles) {
        check_bundle(bundle, claims);
    }
}

} // namespace

TEST_CASE("claims: bodies") { check_table("bodies"); }
TEST_CASE("claims: figures") { check_table("figures"); }
TEST_CASE("claims: formulas") { check_table("formulas"); }
TEST_CASE("claims: integrals") { check_table("integrals"); }
TEST_CASE("claims: loads") { check_table("loads"); }
TEST_CASE("claims: parameters") { check_table("parameters"); }
TEST_CASE("claims: relations") { check_table("relations"); }
TEST_CASE("claims: sizes") { check_table("sizes"); }
TEST_CASE("claims: slip") { check_table("slip"); }
TEST_CASE("claims: sweeps") { check_table("sweeps"); }
TEST_CASE("claims: symbols") { check_table("symbols"); }
TEST_CASE("claims: two-edges") { check_table("two-edges"); }

TEST_CASE("claims: each table has a test case") {
    using Files = std::filesystem::directory_iterator;
    CHECK(std::distance(Files(test::source_dir() / "tests/audit/claims"), Files()) == 12);
}
