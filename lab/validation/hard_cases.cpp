// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/validation/hard_cases.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "lab/validation/axisymmetric_formula.hpp"
#include "lab/validation/textbook_formula.hpp"
#include "lab/validation/value_routes.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <utility>

namespace edgeproof::validation {
namespace {

/// Divided differences, the second route to a coefficient, take digits and points with its order.
constexpr long most_asked_terms = 20;

scene::Scene read_case_scene(const io::TomlSection& section) {
    (void)section.section("profile"); // a missing profile is reported first
    try {
        return scene::read_contact(section);
    } catch (const InputError& error) {
        throw InputError(error.problem(), error.instead()).at(section.file(), section.line());
    }
}

const scene::QuantityRow& quantity_of(const io::TomlSection& section, bool axisymmetric) {
    const std::string name = section.text("quantity");
    std::vector<std::string_view> names;
    for (const scene::Quantity quantity : second_route_quantities(axisymmetric)) {
        const scene::QuantityRow& row = row_of(quantity);
        if (row.name == name) {
            return row;
        }
        names.push_back(row.name);
    }
    const std::string near(near_name(name, names));
    std::string advice = near.empty() ? "" : "did you mean " + near + "? ";
    for (std::size_t i = 0; i < names.size(); ++i) {
        advice += (i == 0                  ? "write "
                   : i + 1 == names.size() ? " or "
                                           : ", ") +
                  std::string(names[i]);
    }
    section.reject("quantity", "unknown quantity '" + name + "'", advice);
}

scene::AskedValue read_asked(const io::TomlSection& section, const scene::Scene& scene) {
    using Index = scene::QuantityRow::Index;
    scene::AskedValue asked;
    const scene::QuantityRow& row = quantity_of(section, scene.round.has_value());
    asked.quantity = row.quantity;
    if (section.has("edge")) {
        const std::string name = section.text("edge");
        const auto edge = scene::edge_named(name);
        if (!edge) {
            section.reject("edge", "there is no edge '" + name + "'", "write right or left");
        }
        asked.edge = *edge;
    }
    if (row.at_point()) {
        asked.u = section.exact("u");
    }
    if (row.of_bodies()) {
        if (scene.slips() && scene.shear->bulk_tension.sign() != 0) {
            section.reject("shear", "partial slip with a bulk tension has no second routes",
                           "leave bulk_tension out");
        }
        if (scene.slips() && scene.load.kind != contact::Load::Kind::force) {
            section.reject("load", "stresses in partial slip are hard cases of a given force",
                           "give P instead of a");
        }
        asked.in_body = {section.exact("x"), section.exact("z"), scene::Body::A};
        if (asked.in_body->z.sign() <= 0) {
            section.reject("z", "the depth is not positive", "give z > 0: on the surface szz = -p");
        }
    }
    if (row.tolerance) {
        asked.tolerance = scene::parse_tolerance(section.text("tolerance"));
    }
    if (row.index != Index::none) {
        asked.k = section.count("n", row.index == Index::terms ? 1 : 0, most_asked_terms);
    }
    if (row.of_shear() && !scene.shear) {
        section.reject(section.line(), "a quantity of the shear is requested and there is no shear",
                       "add shear = { Q = \"...\" }");
    }
    if (!scene.profile) {
        section.reject("load", "the tilt is not given",
                       "give alpha: a tilt that is found as an estimate proves nothing");
    }
    return asked;
}

} // namespace

std::vector<HardCase> parse_hard_cases(std::string_view text, const std::string& file) {
    const io::TomlSection top = io::TomlSection::parse(text, file);
    expect_file_kind(top, scene::FileKind::hard_cases);
    top.allow({"cases"});
    std::vector<HardCase> cases;
    const io::TomlSection all = top.section("cases");
    if (all.keys().empty()) {
        all.reject(all.line(), "the file has no cases",
                   "add a case, such as [cases.hertz-40] with class, reason and quantity");
    }
    for (const std::string& name : all.keys()) {
        const io::TomlSection section = all.section(name);
        section.allow({"class", "reason", "undecided", "quantity", "edge", "u", "x", "z", "n",
                       "tolerance", "profile", "load", "shear"});
        HardCase c;
        c.line = section.line();
        c.family = section.text("class");
        c.reason = section.text("reason");
        c.undecided = section.has("undecided") ? section.text("undecided") : "";
        c.name = name;
        c.scene = read_case_scene(section);
        c.asked = io::at_place(file, c.line, [&] { return read_asked(section, c.scene); });
        cases.push_back(std::move(c));
    }
    return cases;
}

namespace {

constexpr unsigned plain_digits = 50;

Real as_real(double x) { return Real(x); }
Real as_real(long double x) { return Real(x); }
Real as_real(const Float128& x) { return Real(x); }
Real as_real(const Real& x) { return x; }

/// Correct digits of the textbook formula in T; 0 if it fails.
template <Arithmetic T> unsigned plain(const HardCase& c, const Ball& exact) {
    try {
        // Converting Float128 to Real needs the precision for all its digits; T = Real uses exactly
        // these.
        const PrecisionScope scope(plain_digits);
        return digits_right(as_real(c.scene.round ? AxisymmetricFormula<T>(c.scene).value(c.asked)
                                                  : TextbookFormula<T>(c.scene).value(c.asked)),
                            exact);
    } catch (const std::exception&) {
        return 0;
    }
}

/// Compares a second route (docs/independence.md) with the enclosure: it agrees if every number of
/// the ball is within 1 unit of the last digit requested of its value.
CaseSecondRoute held(const SecondRoute& o, const Ball& exact, unsigned digits) {
    const unsigned right = digits_right(o.value, exact);
    return {o.route, to_decimal(o.value, digits), std::min(right, digits_proved(exact)),
            right + 1 >= digits};
}

std::string fault_of(const HardCase& c, const CaseOutcome& outcome, unsigned digits) {
    if (!c.undecided.empty() && outcome.proved) {
        return "there is an enclosure: remove the key `undecided`";
    }
    if (!outcome.proved && c.undecided.empty()) {
        return "no enclosure: " + outcome.route;
    }
    if (!outcome.complete) {
        return "the enclosure determines " + std::to_string(outcome.digits) + " digits of " +
               std::to_string(digits);
    }
    for (const CaseSecondRoute& o : outcome.second_routes) {
        if (!o.agrees) {
            return o.route + " has " + std::to_string(o.digits) + " digits of " +
                   std::to_string(digits) + ": " + o.value;
        }
    }
    return outcome.second_routes.size() < 2 ? "fewer than two routes" : "";
}

unsigned median(std::vector<unsigned> x) {
    std::sort(x.begin(), x.end());
    return x[(x.size() - 1) / 2];
}

} // namespace

CaseOutcome run_case(const HardCase& c, unsigned digits) {
    CaseOutcome outcome;
    try {
        // The enclosure has more digits than requested, so that the other values can be compared
        // with it.
        const scene::Digits asked{digits, Rounding::nearest, false};
        const scene::BoundedValue ours = enclosed_value(c.scene, c.asked, digits);
        const scene::PrintedValue text = printed(ours, asked);
        outcome.value = text.text;
        outcome.bound = text.bound;
        outcome.route = ours.how();
        outcome.proved = ours.proved;
        outcome.complete = text.complete;
        outcome.digits = ours.exactly ? most_digits_right : digits_proved(ours.value);
        outcome.plain = {plain<double>(c, ours.value), plain<long double>(c, ours.value),
                         plain<Float128>(c, ours.value), plain<Real>(c, ours.value)};
        for (unsigned& d : outcome.plain) {
            d = std::min(d, digits);
        }
        for (const SecondRoute& o : second_routes(c.scene, c.asked, digits)) {
            outcome.second_routes.push_back(held(o, ours.value, digits));
        }
        outcome.fault = fault_of(c, outcome, digits);
        outcome.undecided = !outcome.proved && outcome.fault.empty();
    } catch (const std::exception& error) {
        outcome.fault = error.what();
    }
    return outcome;
}

std::vector<CaseOutcome> run_cases(const std::vector<HardCase>& cases, const CaseOptions& options) {
    std::vector<CaseOutcome> outcomes(cases.size());
    std::atomic<std::size_t> done{0};
    parallel::work_through(parallel::all_pieces(cases.size()), options.threads, [&](std::size_t i) {
        check_interruption();
        outcomes[i] = run_case(cases[i], options.digits);
        const std::size_t n = ++done;
        if (options.progress) {
            options.progress(n, cases.size());
        }
    });
    return outcomes;
}

std::vector<FamilySummary> summary(const std::vector<HardCase>& cases,
                                   const std::vector<CaseOutcome>& outcomes) {
    std::vector<FamilySummary> list;
    for (const HardCase& c : cases) {
        if (std::ranges::find(list, c.family, &FamilySummary::family) == list.end()) {
            list.emplace_back().family = c.family;
        }
    }
    for (FamilySummary& s : list) {
        std::array<std::vector<unsigned>, plain_arithmetics.size()> plain;
        std::vector<unsigned> proved;
        for (std::size_t i = 0; i < cases.size(); ++i) {
            if (cases[i].family != s.family) {
                continue;
            }
            ++s.cases;
            s.agree += outcomes[i].fault.empty() && !outcomes[i].undecided ? 1 : 0;
            proved.push_back(outcomes[i].proved ? outcomes[i].digits : 0);
            for (std::size_t j = 0; j < plain.size(); ++j) {
                plain[j].push_back(outcomes[i].plain[j]);
            }
        }
        for (std::size_t j = 0; j < plain.size(); ++j) {
            s.worst[j] = std::ranges::min(plain[j]);
            s.median[j] = median(plain[j]);
        }
        s.worst_proved = std::ranges::min(proved);
        s.median_proved = median(proved);
    }
    return list;
}

} // namespace edgeproof::validation
