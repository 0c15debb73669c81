// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/commands/compute.hpp"

namespace edgeproof::cli {
namespace {

using scene::Quantity;
using scene::QuantityGroup;

/// Refuses a quantity that needs a Poisson's ratio which the scene does not have.
bool is_known(const scene::Scene& scene, Quantity quantity, scene::Body body) {
    return row_of(quantity).needs != scene::QuantityRow::Needs::poisson || scene.poisson(body);
}

int greatest(Computing& c) {
    const Quantity quantity = scene::greatest_of(c.o["--greatest"]);
    const scene::Body body = scene::body_named(c.body);
    require(c.o.list("--point").empty(), "--greatest and --point exclude each other",
            "leave out one of them");
    c.scene.ask.in_bodies.clear();
    c.run(QuantityGroup::stress);
    const scene::GreatestValue found = io::at_place(
        c.scene.file, c.scene.load_line,
        [&] { return scene::greatest_value(c.scene, quantity, body); },
        "give --point X,Z for the stress at points");
    const std::string name(row_of(quantity).name);
    c.note("the greatest " + name +
           (quantity == Quantity::sxx               ? " on the surface of body "
            : c.scene.round && !c.scene.is_sphere() ? " on the axis of body "
                                                    : " in body ") +
           c.body);
    c.table.asked = c.table.notes.front() + ", and its place";
    c.table.notes.insert(c.table.notes.end(), found.notes.begin(), found.notes.end());
    c.add_slip_facts();
    c.add_rows({Line{}}, [&](Row& row, const Line&) {
        row.text("body", c.body, "body {}");
        row.value("x", "", found.x).unit = unit_of(c.scene, Quantity::x);
        row.value("z", "", found.z).unit = unit_of(c.scene, Quantity::x);
        row.value(name, "route", found.value).unit = unit_of(c.scene, quantity);
    });
    return c.write();
}

/// Returns a length in decimals.
std::string text_of(const Computing& c, const scene::Coordinate& x) {
    if (x.number()) {
        return decimal_text(*x.number(), c.scene.ask.digits);
    }
    const Ball& a = c.result.at(Quantity::a).value;
    const Ball& b = c.result.at(Quantity::b).value;
    return printed({x.enclosure(a, b, a.bits()), true, "", {}}, c.scene.ask.digits).text;
}

formula::Exact angle_of(const std::string& text) {
    try {
        return scene::parse_angle(text);
    } catch (const InputError& error) {
        throw InputError("--angle " + text + ": " + error.problem(), error.instead());
    }
}

} // namespace

int stress(Options& o) {
    refuse_words(o, {"edges", "terms", "process_zone", "u", "x"},
                 "stresses are asked for at points of a body (--point X,Z)");
    Computing c(o);
    const scene::Body body = scene::body_named(c.body);
    std::vector<scene::BodyPoint>& points = c.scene.ask.in_bodies;
    if (!o["--greatest"].empty()) {
        return greatest(c);
    }
    if (!o.list("--point").empty()) {
        points.clear();
        for (const std::string& text : o.list("--point")) {
            const std::vector<std::string> parts = parts_of(text);
            require(parts.size() == 2, "--point " + text + " is no point",
                    "write X,Z, such as --point 0,1/2");
            points.push_back(scene::body_point(parts[0], parts[1], body, names_of(c.scene)));
        }
    }
    if (points.empty()) {
        c.reject("no points are asked for",
                 "add points = [[\"0\", \"1/2\"]] (x, z) to [ask], or give --point 0,1/2",
                 c.scene.ask_line);
    }
    for (scene::BodyPoint& point : points) {
        point.body = body;
    }
    c.run(QuantityGroup::stress);
    c.note("sxx, szz, sxz: stresses at the depth z in body " + c.body +
           ", tension positive; tau_max: the greatest shear stress" +
           (c.scene.round ? "" : " in the plane"));
    c.note(c.scene.round ? "x is the radius: sxx is the radial stress, syy the hoop stress"
           : c.scene.poisson(body)
               ? "in plane strain: mises, tresca: equivalent stresses; syy: the stress across the "
                 "plane; s1 >= s2 >= s3: the principal stresses"
               : "mises, syy, s1, s2, s3 and tresca are left out: the scene has no Poisson's ratio "
                 "(nu in [load])");
    c.add_slip_facts();
    c.table.asked = "stresses at the place x and the depth z of a body";
    const std::string length = unit_of(c.scene, Quantity::x);
    c.add_rows(lines_of(c.result.at_places(scene::QuantityRow::Place::body)),
               [&](Row& row, const Line& line) {
                   using Kind = report::Column::Kind;
                   const scene::BodyPoint& point = points[line.at.point()];
                   row.text("body", c.body, "body {}");
                   row.add("x", Kind::number, text_of(c, point.x)).unit = length;
                   row.add("z", Kind::number, text_of(c, point.z)).unit = length;
                   for (const scene::QuantityRow& def : scene::quantity_rows()) {
                       if (def.group == QuantityGroup::stress &&
                           is_known(c.scene, def.quantity, body)) {
                           row.value(std::string(def.name), "", def.quantity);
                       }
                   }
                   row.route(line.at.row(Quantity::sxx).value->how());
               });
    return c.write();
}

int displacement(Options& o) {
    refuse_words(o, {"edges", "terms", "process_zone", "u"},
                 "displacements are asked for at places (x=X)");
    Computing c(o);
    scene::Ask& ask = c.scene.ask;
    for (const scene::AskedPoint& point : ask.u) {
        if (!point.place || point.place->from() != scene::Place::From::origin) {
            c.reject("displacements are asked for at distances u from an edge",
                     "give places x, from the origin", c.scene.ask_line);
        }
    }
    if (ask.u.empty()) {
        c.reject("no places are asked for", "add x=0,2, or x = [\"0\", \"2\"] to [ask]",
                 c.scene.ask_line);
    }
    ask.edges = {contact::Edge::right};
    ask_for(c.scene, o, QuantityGroup::displacement, {QuantityGroup::contact});
    if (!o["--reference"].empty()) {
        ask.reference =
            scene::Place::parse(o["--reference"], scene::Place::From::origin, names_of(c.scene))
                .distance(contact::Edge::right);
    }
    ask.surface_of = scene::body_named(c.body);
    if (ask.reference) {
        ask.quantities.insert(QuantityGroup::surface);
    }
    c.run();
    c.note(std::string("gap: the distance between the surfaces outside the contact; slip: "
                       "u_A - u_B along the surface inside, ") +
           (c.scene.round ? "the mean over the circle of radius |x|, " : "") +
           (c.scene.history ? "since the place last came into contact"
                            : "0 where the contact sticks"));
    c.add_slip_facts();
    c.table.asked = "gap between the surfaces outside the contact, slip inside";
    if (ask.reference) {
        c.note("ux, uz: the displacement of the surface of body " + c.body +
               " along x and into the body, less that of the reference; slope: duz/dx; "
               "dissipation: the energy that friction takes, per area, in a cycle from -Q to Q and "
               "back, P held");
    }
    c.add_rows(lines_of(c.result.at_places(scene::QuantityRow::Place::surface)),
               [&](Row& row, const Line& line) {
                   row.add("x", report::Column::Kind::number,
                           text_of(c, scene::Coordinate(*ask.u[line.at.point()].place)))
                       .unit = unit_of(c.scene, Quantity::x);
                   for (const Quantity quantity :
                        {Quantity::gap, Quantity::slip_displacement, Quantity::ux, Quantity::uz,
                         Quantity::slope, Quantity::dissipation}) {
                       if (ask.reference || row_of(quantity).group == QuantityGroup::displacement) {
                           row.value(std::string(row_of(quantity).name), "", quantity);
                       }
                   }
                   row.route(line.at.begin()->value->how());
               });
    return c.write();
}

int expand_stresses(const Options& o) {
    refuse_words(o, {"quantities"}, "with --angle only the stresses are computed");
    require(o["--figure"].empty(),
            "--figure " + o["--figure"] +
                " has no effect: with --angle only the stresses are computed",
            "leave --figure out");
    const formula::Exact angle = angle_of(o["--angle"]);
    Computing c(o);
    ask_at_edges(c.scene);
    ask_terms(c.scene);
    const std::vector<scene::RayTerm> terms = io::at_place(c.scene.file, c.scene.load_line, [&] {
        return scene::ray_terms(c.scene, scene::body_named(c.body), angle,
                                c.scene.ask.most_terms());
    });
    c.scene.ask.quantities = {QuantityGroup::contact};
    c.run();
    c.table.facts.push_back({"body", c.body});
    c.table.facts.push_back({"angle", angle.text()});
    c.note("stresses in body " + c.body +
           ", tension positive, along the ray at this angle (degrees) to the surface of the "
           "contact: x = a - r cos(angle) or -b + r cos(angle), z = r sin(angle)");
    c.note("each stress is the sum of its coefficients times r^power; |value - exact| <= bound");
    c.bounds = "bounds are proved, and every digit printed is right";
    c.table.asked = "coefficients of the stresses near the edges";
    std::vector<Line> lines(terms.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        lines[i].n = i;
    }
    c.add_rows(lines, [&](Row& row, const Line& line) {
        const scene::RayTerm& term = terms[line.n];
        row.text("edge", scene::edge_name(term.edge), "{} edge");
        row.text("power", std::to_string(term.halves) + "/2", "r^({}):");
        for (std::size_t i = 0; i < scene::ray_stresses.size(); ++i) {
            row.value(std::string(row_of(scene::ray_stresses[i]).name),
                      i + 1 == scene::ray_stresses.size() ? "route" : "", term.values[i]);
        }
    });
    return c.write();
}

} // namespace edgeproof::cli
