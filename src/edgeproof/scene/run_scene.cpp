// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/run_scene.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace edgeproof::scene {
namespace {

/// Copies the values that do not change in a mirror (all but x).
void copy_pressure(const PointValues& from, PointValues& to, bool shear_too) {
    to.p = from.p;
    to.p_local = from.p_local;
    if (shear_too) {
        to.q = from.q;
        to.q_local = from.q_local;
    }
}

class Run {
public:
    Run(const Scene& scene, const RunOptions& options, SceneResult& result)
        : scene_(scene), options_(options), plan_(result.plan), result_(result),
          route_(plan_.proved ? make_ball_route(scene, plan_, result.work)
                              : make_real_route(scene, plan_, result.work)),
          similar_(scene.shear && scene.shear->path == contact::LoadingPath::together) {}

    void all() {
        try {
            result_.contact = route_->contact();
        } catch (const DomainError& error) { // from the peak
            throw InputError(error.what(), "leave peak out of the quantities")
                .at(scene_.file, scene_.ask_line);
        }
        if (plan_.partial_slip) {
            result_.stick = route_->stick();
        }
        for (const contact::Edge edge : plan_.edges) {
            if (plan_.points > 0) {
                points(edge);
            }
        }
        if (scene_.ask.wants(QuantityGroup::coefficients)) {
            for (const contact::Edge edge : plan_.edges) {
                coefficients(edge);
            }
        }
        if (plan_.extents) {
            for (const contact::Edge edge : plan_.edges) {
                extents(edge);
            }
        }
        if (plan_.slip) {
            for (const contact::Edge edge : plan_.edges) {
                step();
                result_.slips.push_back(route_->slip(edge));
            }
        }
    }

private:
    void points(contact::Edge edge) {
        const bool computes_p = plan_.computes(edge);
        for (std::size_t i = 0; i < plan_.points; ++i) {
            step();
            const AskedPoint& asked = scene_.ask.u[i];
            try {
                const Distance u = asked.distance(edge);
                // The mirror image of a place given by x is another place.
                const bool copied =
                    !computes_p && !(asked.place && asked.place->from() == Place::From::origin);
                PointRow row{edge, u.number().value_or(formula::Exact()), asked.text(),
                             route_->at(edge, u, plan_.print_pressure && !copied,
                                        plan_.shear && !(copied && similar_))};
                if (copied) {
                    copy_pressure(result_.points[i].values, row.values, similar_);
                }
                result_.points.push_back(std::move(row));
            } catch (const DomainError& error) {
                const bool by_x = asked.place && asked.place->from() == Place::From::origin;
                throw InputError(
                    (by_x ? asked.text()
                          : "u = " + asked.text() + " from the " + edge_name(edge) + " edge") +
                        ": " + error.what(),
                    by_x ? "give places of the contact, -b < x < a, off every corner"
                         : "give distances from the edge, 0 < u < a + b, off every corner")
                    .at(scene_.file, asked.line != 0 ? asked.line : scene_.ask_line);
            }
        }
    }
    void coefficients(contact::Edge edge) {
        step();
        const bool computes_p = plan_.computes(edge);
        EdgeValues values = route_->expansion(edge, plan_.expand_pressure && computes_p,
                                              plan_.expand_shear && (computes_p || !similar_));
        if (!computes_p) {
            values.c = result_.coefficients.front().c;
            if (similar_) {
                values.s = result_.coefficients.front().s;
            }
        }
        result_.coefficients.push_back(std::move(values));
    }
    void extents(contact::Edge edge) {
        if (!plan_.computes(edge)) {
            const auto computed = result_.extents;
            for (ExtentValues values : computed) {
                values.edge = edge;
                result_.extents.push_back(std::move(values));
            }
            return;
        }
        for (const std::size_t n : scene_.ask.terms) {
            step();
            result_.extents.push_back(route_->extent(edge, n));
        }
    }

    void step() {
        check_interruption();
        if (options_.progress) {
            const std::size_t extents = plan_.extents ? scene_.ask.terms.size() : 0;
            const std::size_t coefficients = scene_.ask.wants(QuantityGroup::coefficients) ? 1 : 0;
            const std::size_t slips = plan_.slip ? 1 : 0;
            options_.progress(done_,
                              plan_.edges.size() * (plan_.points + coefficients + extents + slips));
        }
        ++done_;
    }

    const Scene& scene_;
    const RunOptions& options_;
    const Plan& plan_;
    SceneResult& result_;
    std::unique_ptr<ValueRoute> route_;
    bool similar_;
    std::size_t done_ = 0;
};

} // namespace

SceneResult run_scene(const Scene& scene, const RunOptions& options) {
    SceneResult result;
    result.plan = make_plan(scene);
    Run(scene, options, result).all();
    return result;
}

Scene asking(const Scene& scene, const std::vector<AskedValue>& values, const Digits& digits) {
    Scene s = scene;
    s.ask = Ask{};
    s.ask.edges = {contact::Edge::right, contact::Edge::left};
    s.ask.digits = digits;
    bool shear = false;
    std::size_t orders = 0;
    std::set<std::size_t> numbers_of_terms;
    for (const AskedValue& v : values) {
        const QuantityRow& row = row_of(v.quantity);
        s.ask.quantities.insert(row.group);
        shear = shear || row.of_shear();
        if (v.u) {
            s.ask.u.push_back({*v.u, 0});
        }
        if (v.tolerance) {
            s.ask.tolerance = v.tolerance;
        }
        if (row.index == QuantityRow::Index::order) {
            orders = std::max(orders, v.k + 1);
        } else if (row.index == QuantityRow::Index::terms) {
            numbers_of_terms.insert(v.k);
        }
    }
    if (!shear) {
        s.shear.reset();
    }
    if (orders > 0) {
        numbers_of_terms.insert(orders);
    }
    s.ask.terms.assign(numbers_of_terms.begin(), numbers_of_terms.end());
    return s;
}

SceneValues::SceneValues(const Scene& scene, const std::vector<AskedValue>& values,
                         const Digits& digits)
    : scene_(asking(scene, values, digits)), plan_(make_plan(scene_)),
      route_(plan_.proved ? make_ball_route(scene_, plan_, work_)
                          : make_real_route(scene_, plan_, work_)) {}

BoundedValue SceneValues::value(const AskedValue& asked) {
    const QuantityRow& row = row_of(asked.quantity);
    if (row.searched == nullptr) {
        return route_->value(asked);
    }
    const ExtentValues& found = extent(asked);
    if (row.searched == &ExtentValues::first_exit && !found.leaves) {
        throw DomainError("there is no first exit: the terms stay within the tolerance");
    }
    return found.*row.searched;
}

BoundedValue SceneValues::x(const AskedValue& asked) {
    if (asked.u->sign() <= 0) {
        throw DomainError("the point lies outside the contact");
    }
    return route_->place(asked.edge, asked.distance());
}

const ExtentValues& SceneValues::extent(const AskedValue& asked) {
    const std::pair key{asked.edge, asked.k};
    const auto known = extents_.find(key);
    return known != extents_.end()
               ? known->second
               : extents_.emplace(key, route_->extent(asked.edge, asked.k)).first->second;
}

} // namespace edgeproof::scene
