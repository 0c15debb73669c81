// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/scene/input/readers.hpp"

namespace edgeproof::cli {
namespace {

using scene::Quantity;
using scene::RowsAt;

struct StressOptions : SceneOptions {
    std::string body = "A";
    std::vector<std::string> points; ///< "X,Z"
    std::string greatest;            ///< the quantity whose greatest value is asked for
};

struct DisplacementOptions : SceneOptions {
    std::string reference; ///< empty: the scene's
    std::string body = "A";
};

/// Refuses the options for points and edges of the contact, except places x if `by_x`.
void refuse_others(const SceneOptions& o, const std::string& why, bool by_x) {
    std::vector<std::pair<std::string, std::string>> given{{"--edge", o.edges},
                                                           {"--terms", o.terms}};
    for (const auto& [key, text] : o.stated) {
        if (key == "u" || key == "process_zone" || (key == "x" && !by_x)) {
            given.emplace_back("--" + (key == "process_zone" ? "process-zone" : key), text);
        }
    }
    refuse_options(given, why);
}

Quantity greatest_of(const std::string& name) {
    for (const Quantity quantity : {Quantity::mises, Quantity::tau_max, Quantity::sxx}) {
        if (name == row_of(quantity).name) {
            return quantity;
        }
    }
    throw InputError("--greatest " + name + " is not searched for",
                     "write mises, tau_max (for z >= 0) or sxx (on the surface)");
}

int greatest(const StressOptions& o, scene::Scene scene) {
    const Quantity quantity = greatest_of(o.greatest);
    const scene::Body body = body_of(o.body);
    if (!o.points.empty()) {
        throw InputError("--greatest and --point exclude each other", "leave out one of them");
    }
    if (row_of(quantity).needs == scene::QuantityRow::Needs::poisson && !scene.poisson(body)) {
        throw InputError(o.greatest + " needs Poisson's ratio", "add nu = \"0.3\" to [load]")
            .at(scene.file, scene.load_line);
    }
    scene.ask.in_bodies.clear();
    ask_for(scene, o, scene::QuantityGroup::stress, {scene::QuantityGroup::contact});
    const scene::SceneResult result = done(scene, o);
    const scene::GreatestValue found = io::at_place(
        scene.file, scene.load_line, [&] { return scene::greatest_value(scene, quantity, body); },
        "give --point X,Z for the stress at points");
    report::Table table = values_table(scene, result);
    const std::string name(row_of(quantity).name);
    table.notes = {"the greatest " + name +
                   (quantity == Quantity::sxx ? " on the surface of body " : " in body ") + o.body};
    table.notes.insert(table.notes.end(), found.notes.begin(), found.notes.end());
    if (result.plan.partial_slip) {
        add_slip_facts(table.facts, scene, result);
    }
    table.notes.push_back(bound_note());
    using Kind = report::Column::Kind;
    Columns<scene::GreatestValue> columns(scene);
    table.asked = table.notes.front() + ", and its place";
    const std::string length = unit_of(scene, Quantity::x);
    columns.add("body", Kind::text, [&o](const auto&) { return o.body; }).phrase = "body {}";
    columns.add_value("x", "", [](const auto& value) { return value.x; }).unit = length;
    columns.add_value("z", "", [](const auto& value) { return value.z; }).unit = length;
    columns.add_value(name, "route", [](const auto& value) { return value.value; }).unit =
        unit_of(scene, quantity);
    columns.write(table, {found});
    emit(table, o);
    return 0;
}

int stress(const StressOptions& o) {
    const scene::Body body = body_of(o.body);
    refuse_others(o, "stresses are asked for at points of a body (--point X,Z)", false);
    scene::Scene scene = asked_scene(o);
    if (!o.greatest.empty()) {
        return greatest(o, std::move(scene));
    }
    if (!o.points.empty()) {
        scene.ask.in_bodies.clear();
        for (const std::string& text : o.points) {
            scene.ask.in_bodies.push_back(point_of("--point", text, exact_names_of(scene)));
        }
    }
    if (scene.ask.in_bodies.empty()) {
        throw InputError("no points are asked for",
                         o.by_quantities ? "give --point 0,1/2 (x, z)"
                                         : "add points = [[\"0\", \"1/2\"]] (x, z) to [ask], or "
                                           "give --point 0,1/2")
            .at(scene.file, scene.ask_line);
    }
    for (scene::BodyPoint& point : scene.ask.in_bodies) {
        point.body = body;
    }
    ask_for(scene, o, scene::QuantityGroup::stress, {scene::QuantityGroup::contact});
    const scene::SceneResult result = done(scene, o);
    report::Table table = values_table(scene, result);
    table.notes = {"sxx, szz, sxz: stresses at the depth z in body " + o.body +
                       ", tension positive; tau_max: the greatest shear stress" +
                       (scene.round ? "" : " in the plane"),
                   scene.round ? "x is the radius: sxx is the radial stress, syy the hoop stress"
                   : scene.poisson(body)
                       ? "in plane strain: mises, tresca: equivalent stresses; syy: the stress "
                         "across the plane; s1 >= s2 >= s3: the principal stresses"
                       : "mises, syy, s1, s2, s3 and tresca are left out: the scene has no "
                         "Poisson's ratio (nu in [load])"};
    if (result.plan.partial_slip) {
        add_slip_facts(table.facts, scene, result);
    }
    table.asked = "stresses at the place x and the depth z of a body";
    table.remarks.push_back(bound_note());
    using Kind = report::Column::Kind;
    Columns<RowsAt> columns(scene);
    const auto point = [&scene](const RowsAt& at) -> const scene::BodyPoint& {
        return scene.ask.in_bodies[at.point()];
    };
    const std::string length = unit_of(scene, Quantity::x);
    columns.add("body", Kind::text, [&o](const RowsAt&) { return o.body; }).phrase = "body {}";
    columns
        .add("x", Kind::number,
             [point, &scene](const RowsAt& at) {
                 return decimal_text(point(at).x, scene.ask.digits);
             })
        .unit = length;
    columns
        .add("z", Kind::number,
             [point, &scene](const RowsAt& at) {
                 return decimal_text(point(at).z, scene.ask.digits);
             })
        .unit = length;
    for (const scene::QuantityRow& row : scene::quantity_rows()) {
        const bool known = row.needs != scene::QuantityRow::Needs::poisson || scene.poisson(body);
        if (row.group == scene::QuantityGroup::stress && known) {
            columns
                .add_value(std::string(row.name), "",
                           [&row](const RowsAt& at) { return at.row(row.quantity).value; })
                .unit = unit_of(scene, row.quantity);
        }
    }
    columns
        .add("route", Kind::text,
             [](const RowsAt& at) { return at.row(Quantity::sxx).value->how(); })
        .role = report::Column::Role::route;
    columns.write(table, result.at_places(scene::QuantityRow::Place::body));
    emit(table, o);
    return 0;
}

/// Returns x of a place that depends on a or b.
std::string x_of(const scene::Scene& scene, const scene::SceneResult& result,
                 const scene::AskedPoint& point) {
    const Ball& a = result.at(Quantity::a).value;
    const Ball& b = result.at(Quantity::b).value;
    const Ball x = point.distance(contact::Edge::right).x_enclosure(a, b, a.bits());
    return printed({x, true, "", {}}, scene.ask.digits).text;
}

/// Returns the cell of a quantity that exists on one side of the edge only.
std::optional<scene::BoundedValue> value_of(const RowsAt& at, Quantity quantity) {
    const scene::Row* row = at.find(quantity);
    return row != nullptr ? row->value : std::nullopt;
}

int displacement(const DisplacementOptions& o) {
    refuse_others(o, "displacements are asked for at places (--x X)", true);
    scene::Scene scene = asked_scene(o);
    for (const scene::AskedPoint& point : scene.ask.u) {
        if (!point.place || point.place->from() != scene::Place::From::origin) {
            throw InputError("displacements are asked for at distances u from an edge",
                             "give places x, from the origin")
                .at(scene.file, scene.ask_line);
        }
    }
    if (scene.ask.u.empty()) {
        throw InputError("no places are asked for",
                         o.by_quantities ? "give --x 0 2"
                                         : "add x = [\"0\", \"2\"] to [ask], or give --x 0,2")
            .at(scene.file, scene.ask_line);
    }
    scene.ask.edges = {contact::Edge::right};
    ask_for(scene, o, scene::QuantityGroup::displacement, {scene::QuantityGroup::contact});
    if (!o.reference.empty()) {
        scene.ask.reference =
            scene::Place::parse(o.reference, scene::Place::From::origin, names_of(scene))
                .distance(contact::Edge::right);
    }
    scene.ask.surface_of = body_of(o.body);
    if (scene.ask.reference) {
        scene.ask.quantities.insert(scene::QuantityGroup::surface);
    }
    const scene::SceneResult result = done(scene, o);
    report::Table table = values_table(scene, result);
    table.notes = {
        std::string("gap: the distance between the surfaces outside the contact; slip: "
                    "u_A - u_B along the surface inside, ") +
        (scene.round ? "the mean over the circle of radius |x|, " : "") +
        (scene.history ? "since the place last came into contact" : "0 where the contact sticks")};
    if (result.plan.partial_slip) {
        add_slip_facts(table.facts, scene, result);
    }
    table.asked = "gap between the surfaces outside the contact, slip inside";
    table.remarks.push_back(bound_note());
    using Kind = report::Column::Kind;
    Columns<RowsAt> columns(scene);
    columns
        .add("x", Kind::number,
             [&scene, &result](const RowsAt& at) {
                 const scene::AskedPoint& point = scene.ask.u[at.point()];
                 const auto number = point.place->number();
                 return number ? decimal_text(*number, scene.ask.digits)
                               : x_of(scene, result, point);
             })
        .unit = unit_of(scene, Quantity::x);
    columns.add_value("gap", "", [](const RowsAt& at) { return value_of(at, Quantity::gap); })
        .unit = unit_of(scene, Quantity::gap);
    columns
        .add_value("slip", "",
                   [](const RowsAt& at) { return value_of(at, Quantity::slip_displacement); })
        .unit = unit_of(scene, Quantity::slip_displacement);
    if (scene.ask.reference) {
        table.notes.push_back("ux, uz: the displacement of the surface of body " + o.body +
                              " along x and into the body, less that of the reference; slope: "
                              "duz/dx; dissipation: the energy that friction takes, per area, in "
                              "a cycle from -Q to Q and back, P held");
        for (const Quantity q :
             {Quantity::ux, Quantity::uz, Quantity::slope, Quantity::dissipation}) {
            columns
                .add_value(std::string(row_of(q).name), "",
                           [q](const RowsAt& at) { return value_of(at, q); })
                .unit = unit_of(scene, q);
        }
    }
    columns.add("route", Kind::text, [](const RowsAt& at) { return at.begin()->value->how(); })
        .role = report::Column::Role::route;
    columns.write(table, result.at_places(scene::QuantityRow::Place::surface));
    emit(table, o);
    return 0;
}

} // namespace

scene::Body body_of(const std::string& name) {
    if (name != "A" && name != "B") {
        throw InputError("--body " + name + ": there is no such body",
                         "write A (on which Q acts) or B");
    }
    return name == "A" ? scene::Body::A : scene::Body::B;
}

scene::BodyPoint point_of(const std::string& option, const std::string& text,
                          const scene::Place::Names& names) {
    const std::vector<std::string> parts = parts_of(text);
    if (parts.size() != 2) {
        throw InputError(option + " " + text + " is no point",
                         "write X,Z, such as " + option + " 0,1/2");
    }
    const auto number = [&](const std::string& part) {
        try {
            return scene::exact_in(part, names);
        } catch (const InputError& error) {
            throw InputError(option + " " + text + ": " + error.problem(), error.instead());
        }
    };
    scene::BodyPoint point{number(parts[0]), number(parts[1])};
    if (point.z.sign() < 0) {
        throw InputError(option + " " + text + ": the depth is negative",
                         "give z >= 0, the depth into the body");
    }
    return point;
}

void add_stress(CLI::App& app, int& code) {
    auto [sub, o] = add_command<StressOptions>(
        app, code, "stress", "stresses at points of a body, each with a bound", stress);
    add_scene_options(sub, o);
    sub.add_option("--body", o.body, "the body: Q acts on A")
        ->capture_default_str()
        ->type_name("A|B");
    sub.add_option("--point", o.points,
                   "X,Z: place and depth (default: points of [ask]); repeatable");
    sub.add_option("--greatest", o.greatest,
                   "mises, tresca, s1, tau_max (for z >= 0) or sxx (at z = 0): one row, the "
                   "greatest value and its place, proved; of an axisymmetric contact tau_max on "
                   "the axis");
    sub.footer(
        "z is the depth into the body. [shear] bulk_A is the bulk stress of body A, and B has\n"
        "bulk_A + bulk_tension. See docs/stress.md.");
}

void add_displacement(CLI::App& app, int& code) {
    auto [sub, o] = add_command<DisplacementOptions>(
        app, code, "displacement",
        "the gap outside the contact and the slip inside, each with a bound", displacement);
    add_scene_options(sub, o);
    sub.add_option("--reference", o.reference,
                   "the place x whose displacement is 0: adds ux, uz, slope and dissipation of the "
                   "surface of a body (default: the scene's)");
    sub.add_option("--body", o.body, "the body of that surface: Q acts on A")
        ->capture_default_str()
        ->type_name("A|B");
    sub.footer("See docs/stress.md.");
}

} // namespace edgeproof::cli
