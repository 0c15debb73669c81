// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/recipe_grid.hpp"

#include "edgeproof/conformance/questions/reference.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

namespace edgeproof::conformance {
namespace {

constexpr std::size_t most_at_once = 1'000'000;
constexpr std::size_t small_contacts = 16; ///< rows of contacts that share a piece
constexpr std::size_t most_rows_of_a_grid = 10'000'000'000;

/// Returns the indices of the values of contact number `contact` on each axis; the last axis varies
/// fastest.
std::vector<std::size_t> at_contact(const std::vector<GridAxis>& axes, std::size_t contact) {
    std::vector<std::size_t> at(axes.size());
    for (std::size_t i = axes.size(); i-- > 0;) {
        at[i] = contact % axes[i].values.size();
        contact /= axes[i].values.size();
    }
    return at;
}

std::string id_of(const GridScene& scene, const std::vector<std::size_t>& at) {
    std::string id = scene.name;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const GridAxis& axis = scene.axes[i];
        id += axis.grid ? ":" + axis.key + "=" + axis.values[at[i]] : "";
    }
    return id;
}

AskedContact contact_of(const GridScene& scene, const std::vector<std::size_t>& at,
                        const std::string& file) {
    std::vector<Parameter> parameters;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const GridAxis& axis = scene.axes[i];
        parameters.push_back({axis.key, axis.values[at[i]], axis.line});
    }
    return make_asked_contact(std::move(parameters), file, scene.line);
}

[[noreturn]] void asked_twice(const std::string& id, const std::string& file, std::size_t line) {
    throw InputError("the question " + id + " is asked twice",
                     "leave one out, or give the second scene another name")
        .at(file, line);
}

} // namespace

RecipeGrid RecipeGrid::read(const std::filesystem::path& file) {
    return parse(io::read_text(file, "recipe (TOML)", io::most_toml_bytes), io::input_name(file));
}

void RecipeGrid::add(GridScene scene) {
    check_names(scene);
    check_values(scene);
    Part part;
    part.first_row = rows_;
    part.first_piece = pieces_;
    part.contacts = 1;
    const std::size_t each = scene.asked.size();
    for (const GridAxis& axis : scene.axes) {
        if (axis.values.size() > most_rows_of_a_grid / each / part.contacts) {
            throw InputError("more than 10^10 questions", "split the recipe")
                .at(file_, scene.asked.at(0).line);
        }
        part.contacts *= axis.values.size();
    }
    part.scene = std::move(scene);
    part.cut = pieces_of(part.scene.asked);
    part.piece_of.resize(each);
    for (std::size_t p = 0; p < part.cut.size(); ++p) {
        for (const std::size_t i : part.cut[p]) {
            part.piece_of[i] = p;
        }
    }
    // Small contacts share a piece, so that the work per piece does not dominate.
    part.contacts_in_a_piece =
        each > most_in_a_piece ? 0 : std::max<std::size_t>(1, small_contacts / each);
    rows_ += part.contacts * each;
    pieces_ += part.contacts_in_a_piece == 0 ? part.contacts * part.cut.size()
                                             : (part.contacts - 1) / part.contacts_in_a_piece + 1;
    parts_.push_back(std::move(part));
}

/// The ids consist of the scene's name, the values of its axes and a contact's own part, so that
/// these must be distinct.
void RecipeGrid::check_names(const GridScene& scene) const {
    for (const Part& part : parts_) {
        if (scene.name.starts_with(part.scene.name + ":") ||
            part.scene.name.starts_with(scene.name + ":")) {
            throw InputError("the ids of " + scene.name + " may coincide with those of " +
                                 part.scene.name,
                             "give the second scene another name")
                .at(file_, scene.line);
        }
    }
    const std::vector<std::size_t> first(scene.axes.size(), 0);
    std::set<std::string_view> seen;
    const std::vector<Question> asked = scene.asked.sample();
    for (const Question& q : asked) {
        if (!seen.insert(q.id).second) {
            asked_twice(id_of(scene, first) + q.id, file_, q.line);
        }
    }
    for (std::size_t i = scene.axes.size(); i-- > 0;) {
        std::set<std::string_view> values;
        for (std::size_t k = 0; k < scene.axes[i].values.size(); ++k) {
            if (!values.insert(scene.axes[i].values[k]).second) {
                std::vector<std::size_t> at = first;
                at[i] = k;
                asked_twice(id_of(scene, at) + asked.front().id, file_, asked.front().line);
            }
        }
    }
}

void RecipeGrid::check_values(const GridScene& scene) const {
    const std::vector<std::size_t> first(scene.axes.size(), 0);
    const AskedContact contact = contact_of(scene, first, file_);
    for (const Question& q : scene.asked.sample()) {
        check_askable(contact, q, file_, scene.asked_line);
    }
    for (std::size_t i = 0; i < scene.axes.size(); ++i) {
        for (std::size_t k = 1; k < scene.axes[i].values.size(); ++k) {
            std::vector<std::size_t> at = first;
            at[i] = k;
            (void)contact_of(scene, at, file_);
        }
    }
}

std::shared_ptr<const AskedContact> RecipeGrid::contact(const Part& part,
                                                        std::size_t number) const {
    const std::size_t row = part.first_row + number * part.scene.asked.size();
    {
        const std::lock_guard lock(last_->mutex);
        if (last_->contact && last_->row == row) {
            return last_->contact;
        }
    }
    auto made = std::make_shared<const AskedContact>(
        contact_of(part.scene, at_contact(part.scene.axes, number), file_));
    const std::lock_guard lock(last_->mutex);
    last_->row = row;
    last_->contact = made;
    return made;
}

void RecipeGrid::ask(const Part& part, std::size_t contact, const std::vector<std::size_t>& which,
                     Questions& to) const {
    const auto at = at_contact(part.scene.axes, contact);
    const std::string id = id_of(part.scene, at);
    to.contacts.push_back(*this->contact(part, contact));
    for (const std::size_t i : which) {
        Question q = part.scene.asked.at(i);
        q.id = id + q.id;
        q.contact = to.contacts.size() - 1;
        to.list.push_back(std::move(q));
    }
}

RecipeGrid::Piece RecipeGrid::piece(std::size_t number) const {
    const Part& part = *std::prev(std::ranges::upper_bound(parts_, number, {}, &Part::first_piece));
    const std::size_t local = number - part.first_piece;
    const std::size_t each = part.scene.asked.size();
    Piece piece;
    piece.questions.file = file_;
    const auto take = [&](std::size_t contact, const std::vector<std::size_t>& which) {
        ask(part, contact, which, piece.questions);
        for (const std::size_t i : which) {
            piece.rows.push_back(part.first_row + contact * each + i);
        }
    };
    if (part.contacts_in_a_piece == 0) {
        take(local / part.cut.size(), part.cut[local % part.cut.size()]);
        return piece;
    }
    std::vector<std::size_t> all(each);
    std::iota(all.begin(), all.end(), std::size_t{0});
    const std::size_t from = local * part.contacts_in_a_piece;
    for (std::size_t c = from; c < std::min(from + part.contacts_in_a_piece, part.contacts); ++c) {
        take(c, all);
    }
    return piece;
}

std::size_t RecipeGrid::piece_of(std::size_t row) const {
    const Part& part = *std::prev(std::ranges::upper_bound(parts_, row, {}, &Part::first_row));
    const std::size_t each = part.scene.asked.size();
    const std::size_t contact = (row - part.first_row) / each;
    return part.first_piece +
           (part.contacts_in_a_piece == 0
                ? contact * part.cut.size() + part.piece_of[(row - part.first_row) % each]
                : contact / part.contacts_in_a_piece);
}

Questions RecipeGrid::questions() const {
    if (rows_ > most_at_once) {
        throw InputError("more than a million questions",
                         "split the recipe, or make the table with --out FILE")
            .at(file_, parts_.back().scene.asked.at(0).line);
    }
    Questions all;
    all.file = file_;
    for (const Part& part : parts_) {
        std::vector<std::size_t> which(part.scene.asked.size());
        std::iota(which.begin(), which.end(), std::size_t{0});
        for (std::size_t c = 0; c < part.contacts; ++c) {
            ask(part, c, which, all);
        }
    }
    return all;
}

Recipe RecipeGrid::sample() const {
    Recipe sample{file_, title_, digits_, {file_, {}, {}}};
    for (const Part& part : parts_) {
        sample.questions.contacts.push_back(*contact(part, 0));
        std::ranges::move(part.scene.asked.sample(), std::back_inserter(sample.questions.list));
    }
    return sample;
}

std::uint64_t RecipeGrid::fingerprint() const {
    std::uint64_t hash = io::fnv1a("recipe\n");
    const auto add = [&](const std::string& text) { hash = io::fnv1a(text + "\n", hash); };
    add(title_);
    add(std::to_string(digits_.count));
    add(std::to_string(static_cast<int>(digits_.rounding)));
    for (const Part& part : parts_) {
        add(part.scene.name);
        for (const GridAxis& axis : part.scene.axes) {
            add((axis.grid ? "grid " : "fixed ") + axis.key);
            for (const std::string& value : axis.values) {
                add(value);
            }
        }
        if (const auto& range = part.scene.asked.points().range) {
            add("range " + range->text());
        }
        for (const Question& q : part.scene.asked.sample()) {
            add(q.id + " " + symbol_of(q) + " " + scene::edge_name(q.edge));
            add((q.u ? q.u->text() : "") + " " + (q.tolerance ? q.tolerance->text() : ""));
            if (q.in_body) {
                add(q.in_body->x.text() + " " + q.in_body->z.text());
            }
        }
    }
    return hash;
}

} // namespace edgeproof::conformance
