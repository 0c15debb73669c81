// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/binary64_values.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace edgeproof::python {

using Texts = std::vector<std::string>;
/// A value of a key of a scene's file, as Python gives it.
using KeyValue = std::variant<bool, std::string, Texts>;

/// Returns the entries of a section: an empty text removes a key.
template <class Keys> std::vector<io::TomlEntry> entries_of(const Keys& keys) {
    std::vector<io::TomlEntry> entries;
    for (const auto& [key, value] : keys) {
        std::visit([&, &name = key](const auto& v) { entries.push_back({name, v}); }, value);
    }
    return entries;
}

/// A scene with the text from which it was read. Several threads may use one.
class NativeScene {
public:
    NativeScene(std::string text, scene::Scene scene);

    [[nodiscard]] const std::string& text() const noexcept { return text_; }
    [[nodiscard]] const scene::Scene& scene() const noexcept { return scene_; }
    /// Returns the scene with these keys of [ask] in place of its own; `points_x`, `points_z` and
    /// `body` are the points of a body. Throws InputError for questions that make no sense.
    [[nodiscard]] scene::Scene asking(std::map<std::string, KeyValue> asked) const;
    /// Computes a quantity at each place (Binary64Values); both arrays have the same size. Solved
    /// contacts are kept for the next call, one for each thread that calls at the same time.
    void binary64(const scene::Binary64Question& question, contact::Edge edge,
                  std::span<const double> places, std::span<double> values) const;

private:
    using Contacts = std::vector<std::unique_ptr<scene::Binary64Values>>;
    struct Pool {
        std::mutex mutex;
        std::map<std::tuple<scene::Quantity, std::size_t, bool>, Contacts> free;
    };

    std::string text_;
    scene::Scene scene_;
    io::TomlSection profile_;
    std::shared_ptr<Pool> pool_;
};

} // namespace edgeproof::python
