// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/design/design_file.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/readers.hpp"
#include "edgeproof/scene/route/scene_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <regex>

namespace edgeproof::scene {
namespace {

constexpr long most_design_terms = 12;

Rational rational_at(const io::TomlSection& section, std::string_view key) {
    const Exact x = section.exact(key);
    section.require(x.is_rational(), key, std::string(key) + " = " + x.text() + " is not rational",
                    "give a decimal or a quotient");
    return x.rational();
}

contact::ParameterRange range_at(const io::TomlSection& section, std::string_view key) {
    const io::TomlSection range = section.section(key);
    range.allow({"from", "to"});
    const contact::ParameterRange r{rational_at(range, "from"), rational_at(range, "to")};
    section.require(r.from < r.to, key, "the range of " + std::string(key) + " is empty",
                    "write { from = \"0\", to = \"3\" }, from < to");
    return r;
}

void read_parameter(const io::TomlSection& top, std::size_t line, DesignScene& design) {
    std::size_t ranges = 0;
    const auto add = [&](const io::TomlSection& section, const std::string& name) {
        ++ranges;
        design.parameter = name;
        design.range = range_at(section, name);
    };
    for (const char* where : {"profile", "load", "shear"}) {
        if (!top.has(where)) {
            continue;
        }
        const io::TomlSection section = top.section(where);
        for (const std::string& key : section.keys()) {
            if (section.is_table(key)) {
                add(section, key);
            }
        }
    }
    if (top.has("parameters")) {
        const io::TomlSection section = top.section("parameters");
        for (const std::string& key : section.keys()) {
            section.require(key != "x" && key != "pi" && key != "Pi", key,
                            "no parameter may be called " + key, "take another name");
            add(section, key);
        }
    }
    top.require(ranges == 1, line, std::to_string(ranges) + " numbers of the scene are ranges",
                "write one as { from = \"0\", to = \"3\" }");
}

std::vector<Edge> edges_named(const std::string& edge) {
    require(edge == "both" || edge == "right" || edge == "left", "there is no edge '" + edge + "'",
            "write right, left or both");
    return edge == "both" ? std::vector{Edge::right, Edge::left} : std::vector{edge_of(edge)};
}

DesignObjective objective_named(const std::string& maximise) {
    // In the order of DesignObjective.
    static constexpr std::array<std::string_view, 2> names{"first_exit", "measure"};
    const auto* const name = std::ranges::find(names, maximise);
    require(name != names.end(), "unknown objective '" + maximise + "'", one_of(maximise, names));
    return static_cast<DesignObjective>(name - names.begin());
}

Exact tolerance_below_1(const std::string& text) {
    Exact tolerance = parse_tolerance(text);
    require(tolerance.is_rational() && tolerance.rational() < 1,
            "the tolerance is not a rational number below 1", "write 1%, 0.01 or 1/100");
    return tolerance;
}

/// Interprets the value of a key; errors get its file and line.
template <class Meaning>
auto meaning_at(const io::TomlSection& section, std::string_view key, const Meaning& meaning) {
    return io::at_place(section.file(), section.line(key),
                        [&] { return meaning(section.written(key)); });
}

void read_design_section(const io::TomlSection& section, DesignScene& design) {
    if (section.has("maximise")) {
        design.objective = meaning_at(section, "maximise", objective_named);
    }
    design.tolerance = meaning_at(section, "tolerance", tolerance_below_1);
    if (section.has("terms")) {
        design.terms = section.count("terms", 1, most_design_terms);
    }
    if (section.has("edge")) {
        design.edges = meaning_at(section, "edge", edges_named);
    }
    if (section.has("of")) {
        const std::string of = section.text("of");
        section.require(of == "pressure" || of == "shear", "of",
                        "there is no traction '" + of + "'", "write pressure or shear");
        design.shear = of == "shear";
    }
    if (section.has("unit")) {
        const std::string unit = section.text("unit");
        section.require(unit == "fraction" || unit == "distance", "unit",
                        "unknown unit '" + unit + "'", "write fraction (of a + b) or distance");
        design.unit =
            unit == "distance" ? contact::ReachUnit::distance : contact::ReachUnit::fraction;
    }
    if (section.has("part")) {
        design.part = rational_at(section, "part");
        section.require(design.part > 0 && design.part <= 1, "part",
                        "the part looked at is not in 0 ... 1",
                        "write part = \"1/2\", a fraction of a + b from the edge");
    }
    if (section.has("printed")) {
        const io::TomlSection printed = section.section("printed");
        for (const std::string& key : printed.keys()) {
            section.require(key == design.parameter, "printed", "there is no parameter " + key,
                            "write " + design.parameter);
            design.printed = rational_at(printed, key);
        }
    }
}

} // namespace

std::string with_name_replaced(std::string_view formula, std::string_view name,
                               std::string_view value) {
    // Names are words of regular expressions.
    return std::regex_replace(std::string(formula), std::regex(fmt::format("\\b{}\\b", name)),
                              fmt::format("({})", value));
}

Scene DesignScene::at(const Rational& value) const {
    const std::string number = exact_text(value);
    const auto change = [&](std::string_view, std::string_view key,
                            const std::string* text) -> std::optional<std::string> {
        if (text != nullptr) {
            return key == "kind" || key == "path" ? *text
                                                  : with_name_replaced(*text, parameter, number);
        }
        return key == parameter ? std::optional(number) : std::nullopt;
    };
    Scene scene = scene_of(top_->changed({"profile", "load", "shear"}, change));
    if (scene.round && scene.round->law && !scene.shear &&
        scene.round->load.kind == Load::Kind::right_edge) {
        scene.round.reset(); // the plane contact has the same pressure (docs/axisymmetric.md)
    }
    if (scene.round) {
        throw InputError("design computes plane contacts only",
                         "leave geometry out of [profile], or use edgeproof pressure, expand or "
                         "extent")
            .at(scene.file, scene.profile_line);
    }
    if (!scene.steps.empty()) {
        throw InputError("design computes no load histories",
                         "give P and Q in [load] and [shear] instead of steps")
            .at(scene.file, scene.steps.front().line);
    }
    scene.ask = {};
    scene.ask.edges = edges;
    scene.ask.terms = {terms};
    scene.ask.tolerance = tolerance;
    scene.ask.part = {Exact(), Exact::of(part)};
    scene.ask.quantities = {QuantityGroup::extent};
    return scene;
}

DesignScene parse_design(std::string_view text, const std::string& file,
                         const std::vector<io::TomlTable>& instead) {
    const io::TomlSection top = io::TomlSection::parse(text, file, instead);
    top.require(top.has("design"), top.line(), "there is no [design]",
                "add [design] with a tolerance (docs/design.md)");
    const io::TomlSection section = top.section("design");
    section.allow({"maximise", "of", "terms", "tolerance", "edge", "unit", "part", "printed"});
    top.allow({"title", "profile", "load", "shear", "ask", "parameters", "design"});
    DesignScene design;
    design.file = file;
    design.title = top.has("title") ? top.text("title") : std::string();
    design.top_ = top;
    read_parameter(top, section.line(), design);
    read_design_section(section, design);
    // Both ends must make valid scenes. Values between them are convex if the ends are, or are
    // refused when they are tried.
    const Scene one = design.at(design.range.from);
    (void)design.at(design.range.to);
    if (top.has("ask")) { // it is not used, but an error in it is reported
        const io::TomlSection ask = top.section("ask");
        Scene asking = one;
        io::at_place(ask.file(), ask.line(),
                     [&] { read_ask(ask, top.section("profile"), asking); });
    }
    section.require(!design.shear || one.shear, section.line(),
                    "shear is requested, but there is no [shear]",
                    "add [shear] with Q or bulk_tension");
    return design;
}

namespace {

constexpr unsigned estimate_digits = 12;
constexpr long printed_bits = 256;
/// For reaches without a closed form.
constexpr contact::SampleGrid coarse_grid{16, 6, 4};

/// Searches for a first exit near the edge before the whole part: most exits lie there, and the
/// rest of the contact takes long.
std::vector<Row> extent_at(const DesignScene& design, SceneValues& values, Edge edge) {
    const AskedValue asked{Quantity::extent, design.terms, edge};
    const contact::ExtentRange whole{Exact(), Exact::of(design.part)};
    for (const long share : {8L, 2L}) {
        if (design.objective == DesignObjective::first_exit && Rational(1, share) < design.part) {
            values.look_at({whole.from, Exact::of(Rational(1, share))});
            std::vector<Row> rows = values.search(asked);
            values.look_at(whole);
            if (rows.front().reached) {
                return rows;
            }
        }
    }
    return values.search(asked);
}

/// The reach or measure at a single value as a scene of its own, if no closed form is known; NaN
/// where there is none.
double score_of_scene(const DesignScene& design, double parameter) {
    check_interruption();
    try {
        Scene scene = design.at(contact::exact_value(Real(parameter))).without_shear();
        if (!scene.profile || design.shear) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        scene.ask.digits.count = estimate_digits;
        SceneValues values(std::move(scene));
        double least = std::numeric_limits<double>::infinity();
        const bool fraction = design.unit == contact::ReachUnit::fraction;
        const Quantity quantity = design.objective == DesignObjective::measure
                                      ? (fraction ? Quantity::measure_fraction : Quantity::measure)
                                      : (fraction ? Quantity::extent_fraction : Quantity::extent);
        for (const Edge edge : design.edges) {
            const std::vector<Row> rows = extent_at(design, values, edge);
            const BoundedValue& value = RowsAt(rows).at(quantity, design.terms);
            least = std::min(least, value.value.midpoint().convert_to<double>());
        }
        return least;
    } catch (const Error&) { // no contact, or no profile, for these values
        return std::numeric_limits<double>::quiet_NaN();
    }
}

} // namespace

DesignResult run_design(const DesignScene& design, const contact::DesignOptions& options) {
    DesignResult result;
    std::string why_not;
    const auto errors = design.errors(why_not);
    contact::ReachProblem problem;
    problem.tolerance = design.tolerance.rational();
    problem.part = design.part;
    problem.edges = errors;
    const bool measure = design.objective == DesignObjective::measure;
    const auto score = [&](double x) {
        if (errors.empty()) {
            return score_of_scene(design, x);
        }
        if (measure) {
            return sampled_measure(problem, x);
        }
        const auto at = reach_near(problem, x);
        return at ? contact::approximate(at->reach) : std::numeric_limits<double>::quiet_NaN();
    };
    if (errors.empty() || measure) {
        if (errors.empty() && design.shear) {
            throw InputError("nothing is known of the shear traction over this range: " + why_not,
                             "write of = \"pressure\", or change the scene")
                .at(design.file, 0);
        }
        const contact::SampleGrid samples = errors.empty() ? coarse_grid : contact::SampleGrid{};
        const auto total = static_cast<std::size_t>(samples.count());
        std::size_t done = 0;
        const auto counted = [&](double x) {
            const double s = score(x);
            if (options.progress) {
                options.progress(++done * 1000 / total, 1000);
            }
            return s;
        };
        const contact::SampledBest found = contact::sampled_best(counted, design.range, samples);
        if (!found.value) {
            throw BudgetError("no reach is found anywhere in the range");
        }
        result.best.value = Ball::around(Real(*found.value), Real(2 * found.width), 64);
        result.best.reach =
            Ball::around(Real(found.score), Real(std::fabs(found.score) * 1e-9), 64);
        result.missing =
            errors.empty() ? why_not
                           : "the measure is found by samples: branch and bound is for first_exit";
    } else {
        result.best = best_reach(problem, design.range, options);
        result.missing = result.best.missing;
    }
    if (design.printed) {
        if (result.missing.empty()) {
            result.printed_reach = proved_reach(problem, Ball(*design.printed, printed_bits)).reach;
        } else {
            result.printed_reach = Ball(Real(score(design.printed->convert_to<double>())), 64);
        }
        result.falls_short = 1 - *result.printed_reach / result.best.reach;
    }
    return result;
}

} // namespace edgeproof::scene
