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
#include <variant>
#include <vector>

namespace edgeproof::python {

using Texts = std::vector<std::string>;

/// The questions for a scene by their names in [ask]: exact texts and whole numbers. A missing one
/// keeps the scene's value; the empty text means none.
using AskedByName =
    std::map<std::string, std::variant<long, std::string, std::vector<long>, Texts>>;

/// A scene with the text from which it was read. Several threads may use one.
class NativeScene {
public:
    NativeScene(std::string text, scene::Scene scene);

    [[nodiscard]] const std::string& text() const noexcept { return text_; }
    [[nodiscard]] const scene::Scene& scene() const noexcept { return scene_; }
    /// Returns the scene with other questions. Throws InputError for questions that make no sense.
    [[nodiscard]] scene::Scene asking(const AskedByName& asked) const;
    /// Computes p at each distance u from an edge (Binary64Values); `p` and `u` have the same size.
    /// Solved contacts are kept for the next call, one for each thread that calls at the same time.
    void pressures(contact::Edge edge, std::span<const double> u, std::span<double> p);

private:
    struct Pool {
        std::mutex mutex;
        std::vector<std::unique_ptr<scene::Binary64Values>> free;
    };

    std::string text_;
    scene::Scene scene_;
    std::shared_ptr<Pool> pool_;
};

/// Returns n as a number of terms. Throws InputError outside 1 ... 400.
[[nodiscard]] std::size_t number_of_terms(long n);

/// Returns the edge "right" or "left". Throws InputError for other names.
[[nodiscard]] contact::Edge edge_named(const std::string& name);

/// Returns the body "A" or "B". Throws InputError for other names.
[[nodiscard]] scene::Body body_named(const std::string& name);

} // namespace edgeproof::python
