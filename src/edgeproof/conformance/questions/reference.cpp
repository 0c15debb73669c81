// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/questions/question.hpp"

#include "edgeproof/io/text_file.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace edgeproof::conformance {
namespace {

/// Questions (by index) of one contact that are answered together. The division into pieces does
/// not depend on the number of threads, and an answer depends on nothing outside its piece.
using Piece = std::vector<std::size_t>;

/// The solved contact of a piece.
std::unique_ptr<scene::SceneValues> solved(const Questions& questions, const Piece& piece,
                                           const scene::Digits& digits) {
    scene::Scene scene = questions.contacts[questions.list[piece.front()].contact].scene;
    scene.file = questions.file;
    std::vector<scene::AskedValue> values;
    for (const std::size_t i : piece) {
        values.push_back(questions.list[i]);
    }
    return std::make_unique<scene::SceneValues>(scene, values, digits);
}

Reference answer(scene::SceneValues& values, const Question& q, const std::string& file) {
    if (q.at_point()) {
        try {
            scene::BoundedValue x = values.x(q);
            return {values.value(q), std::move(x)};
        } catch (const DomainError& error) {
            throw InputError("u = " + q.u->text() + " from the " + scene::edge_name(q.edge) +
                                 " edge: " + error.what(),
                             "give distances from the edge, 0 < u < a + b, off every corner")
                .at(file, q.line);
        }
    }
    if (q.quantity == scene::Quantity::extent && !values.searched(q).reached) {
        throw InputError("there is no first exit: n = " + std::to_string(q.k) +
                             " terms stay within the tolerance all over the contact",
                         "ask for measure_" + std::to_string(q.k) + ", or give a smaller tolerance")
            .at(file, q.line);
    }
    return {values.value(q), {}};
}

std::vector<Piece> pieces_of(const Questions& questions) {
    constexpr std::size_t most_in_a_piece = 128;
    std::vector<Piece> pieces;
    std::map<std::tuple<std::size_t, int, std::string>, std::size_t> open;
    for (std::size_t i = 0; i < questions.list.size(); ++i) {
        const Question& q = questions.list[i];
        const int kind = q.at_point() ? 1 : q.to_a_tolerance() ? 2 : 0;
        const auto [found, first] =
            open.try_emplace({q.contact, kind, q.tolerance ? q.tolerance->text() : ""}, 0);
        if (first || pieces[found->second].size() >= most_in_a_piece) {
            found->second = pieces.size();
            pieces.emplace_back();
        }
        pieces[found->second].push_back(i);
    }
    return pieces;
}

/// Calls `handle(i, contact)` for each question, in several threads; contact() is the solved
/// contact of its piece.
template <class Handle>
void answer_all(const Questions& questions, const ReferenceOptions& options, const Handle& handle) {
    const std::vector<Piece> pieces = pieces_of(questions);
    std::atomic<std::size_t> done{0};
    parallel::parallel_for(pieces.size(), options.threads, [&](std::size_t p) {
        std::unique_ptr<scene::SceneValues> values;
        const auto contact = [&]() -> scene::SceneValues& {
            values = values ? std::move(values) : solved(questions, pieces[p], options.digits);
            return *values;
        };
        for (const std::size_t i : pieces[p]) {
            check_interruption();
            handle(i, contact);
            const std::size_t n = ++done;
            if (options.progress) {
                options.progress(n, questions.list.size());
            }
        }
    });
}

} // namespace

std::vector<Reference> references(const Questions& questions, const ReferenceOptions& options) {
    std::vector<Reference> results(questions.list.size());
    answer_all(questions, options, [&](std::size_t i, const auto& contact) {
        const Question& q = questions.list[i];
        results[i] = io::at_place(questions.file, q.line,
                                  [&] { return answer(contact(), q, questions.file); });
    });
    return results;
}

std::vector<ReferenceOrWhy> references_or_why(const Questions& questions,
                                              const ReferenceOptions& options, bool strict) {
    std::vector<ReferenceOrWhy> results(questions.list.size());
    answer_all(questions, options, [&](std::size_t i, const auto& contact) {
        const Question& q = questions.list[i];
        if (strict) {
            (void)contact(); // throws for an invalid contact
        } else if (lack_of(questions.contacts[q.contact].scene, q)) {
            return; // the approach of a plane contact, q without shear
        }
        try {
            results[i].reference = answer(contact(), q, questions.file);
        } catch (const InputError& error) {
            if (strict && !q.at_point()) {
                throw;
            }
            results[i].why = error.problem();
        } catch (const BudgetError& error) {
            results[i].why = error.what();
        } catch (const Error&) {
            if (strict) {
                throw;
            }
        }
    });
    return results;
}

std::map<Way, Ball>
values_otherwise(const Questions& questions, const std::vector<Way>& ways,
                 const std::function<bool(const Way&, AskedContact&)>& change,
                 const std::function<bool(const Way&, Question&, const scene::Scene&)>& place,
                 const ReferenceOptions& options) {
    Questions asked{questions.file, {}, {}};
    std::vector<Way> asked_ways;
    std::map<Way, std::optional<std::size_t>> contacts; // by contact and way
    for (const Way& way : ways) {
        Question q = questions.list[way.first];
        try {
            const auto [known, is_new] = contacts.try_emplace({q.contact, way.second});
            if (is_new) {
                AskedContact contact = questions.contacts[q.contact];
                if (change(way, contact)) {
                    known->second = asked.contacts.size();
                    asked.contacts.push_back(std::move(contact));
                }
            }
            if (known->second && place(way, q, asked.contacts[*known->second].scene)) {
                q.contact = *known->second;
                asked.list.push_back(std::move(q));
                asked_ways.push_back(way);
            }
        } catch (const Error&) { // no valid contact
        }
    }
    const auto found = references_or_why(asked, options, false);
    std::map<Way, Ball> values;
    for (std::size_t k = 0; k < found.size(); ++k) {
        if (found[k].reference) {
            values.emplace(asked_ways[k], found[k].reference->value.value);
        }
    }
    return values;
}

namespace {

constexpr unsigned neighbour_digits = 34;

/// Returns x plus or minus half a unit in the last place of its binary64; nothing for zero.
std::optional<formula::Exact> neighbour(const formula::Exact& x, int side) {
    const double near = std::abs(x.to<Real>().convert_to<double>());
    if (near == 0 || !std::isfinite(near)) {
        return {};
    }
    const double ulp = std::nextafter(near, std::numeric_limits<double>::infinity()) - near;
    if (!std::isfinite(ulp)) {
        return {};
    }
    const Rational half = exact_rational(ulp) * side / 2;
    if (x.is_rational()) {
        return formula::Exact::of(Rational(x.rational() + half));
    }
    return formula::Exact(x.expr() + formula::Expr::number(half));
}

/// One number of a contact.
struct Number {
    std::size_t parameter; ///< index
    std::size_t item;      ///< index into the items of the parameter
    formula::Exact value;
};

std::vector<Number> numbers_of(const AskedContact& contact) {
    std::vector<Number> numbers;
    for (std::size_t i = 0; i < contact.parameters.size(); ++i) {
        const Parameter& p = contact.parameters[i];
        if (!p.is_word()) {
            for (std::size_t k = 0; const std::string& item : p.items()) {
                numbers.push_back({i, k++, formula::Exact::parse(item)});
            }
        }
    }
    return numbers;
}

} // namespace

std::vector<std::optional<Conditioning>> conditioning(const Questions& questions,
                                                      const std::vector<Reference>& references,
                                                      const std::vector<std::size_t>& which,
                                                      ReferenceOptions options) {
    options.digits = {neighbour_digits, Rounding::nearest, false};
    const PrecisionScope scope(neighbour_digits + 10);
    std::map<std::size_t, std::vector<Number>> numbers; // by contact
    std::vector<Way> ways; // a question, and the number that changes: of the contact, then u or the
                           // tolerance
    const auto numbers_in = [&](std::size_t i) -> const std::vector<Number>& {
        const auto [found, is_new] = numbers.try_emplace(questions.list[i].contact);
        if (is_new) {
            found->second = numbers_of(questions.contacts[found->first]);
        }
        return found->second;
    };
    for (const std::size_t i : which) {
        const Question& q = questions.list[i];
        for (std::size_t n = 0; n < numbers_in(i).size() + (q.u || q.tolerance ? 1 : 0); ++n) {
            ways.emplace_back(i, n);
        }
    }
    std::map<Way, Ball> values;
    for (const int side : {1, -1}) {
        std::vector<Way> unknown;
        std::ranges::copy_if(ways, std::back_inserter(unknown),
                             [&](const Way& way) { return !values.contains(way); });
        const auto is_of_contact = [&](const Way& way) {
            return way.second < numbers_in(way.first).size();
        };
        const auto move = [&](const Way& way, AskedContact& contact) {
            if (!is_of_contact(way)) {
                return true;
            }
            const Number& number = numbers_in(way.first)[way.second];
            const auto value = neighbour(number.value, side);
            if (value) {
                std::vector<std::string> items = contact.parameters[number.parameter].items();
                items[number.item] = value->text();
                contact.parameters[number.parameter].set_items(items);
                contact = make_asked_contact(std::move(contact.parameters), questions.file,
                                             questions.list[way.first].line);
            }
            return value.has_value();
        };
        const auto move_place = [&](const Way& way, Question& q, const scene::Scene&) {
            auto& place = q.u ? q.u : q.tolerance;
            place = is_of_contact(way) ? place : neighbour(*place, side);
            return is_of_contact(way) || place; // else it is beyond a double's range
        };
        values.merge(values_otherwise(questions, unknown, move, move_place, options));
    }
    std::vector<std::optional<Conditioning>> result(questions.list.size());
    for (const std::size_t i : which) {
        if (!contains_zero(references[i].value.value)) {
            result[i].emplace();
        }
    }
    for (const auto& [i, n] : ways) {
        const auto found = values.find({i, n});
        const auto& of = numbers_in(i);
        if (result[i] && found != values.end()) {
            const Real exact = references[i].value.value.midpoint();
            const Real moved = found->second.midpoint();
            result[i]->moved += Real(abs(Real(moved / exact - 1))).convert_to<double>();
        } else if (n >= of.size() || of[n].value.sign() != 0) {
            result[i].reset(); // a number other than 0 has no neighbour with a value
        }
    }
    return result;
}

} // namespace edgeproof::conformance
