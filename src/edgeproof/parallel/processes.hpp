// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <string>

namespace edgeproof::parallel {

/// Processes that were started together to share one piece of work, from the view of one of them.
/// Derived classes transport the messages: by MPI in the program (src/edgeproof/mpi), through
/// memory in a test. For use in the thread that made it only.
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

    /// The number of this process: 0, ..., count() - 1. The first leads.
    [[nodiscard]] virtual std::size_t number() const = 0;
    [[nodiscard]] virtual std::size_t count() const = 0;
    /// May return before the message has arrived. Messages between two processes arrive in order.
    virtual void send(std::size_t to, const std::string& text) = 0;
    /// Returns a message that has arrived, from any process; nothing if there is none now.
    [[nodiscard]] virtual std::optional<Message> receive() = 0;
};

} // namespace edgeproof::parallel
