// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <string>

namespace edgeproof::parallel {

/// Processes that were started together to share one piece of work, as one of them sees it. How
/// messages travel is not told here: by MPI in the program (src/edgeproof/mpi), through memory in a
/// test. To be used from the thread that made it.
class Processes {
public:
    struct Message {
        std::size_t from = 0;
        std::string text;
    };

    Processes() = default;
    virtual ~Processes() = default;
    Processes(const Processes&) = delete;
    Processes& operator=(const Processes&) = delete;

    /// Of this one: 0, ..., count() - 1. The first leads.
    [[nodiscard]] virtual std::size_t number() const = 0;
    [[nodiscard]] virtual std::size_t count() const = 0;
    /// May return before it has arrived. What one process sends another arrives in that order.
    virtual void send(std::size_t to, const std::string& text) = 0;
    /// A message that has come in, from whomever; nothing where there is none now.
    [[nodiscard]] virtual std::optional<Message> receive() = 0;
};

} // namespace edgeproof::parallel
