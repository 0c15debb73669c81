// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/error.hpp"

#include <cstddef>
#include <functional>
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

/// Makes piece p. Called from several threads.
using MakePiece = std::function<std::string(std::size_t)>;
/// Stores a piece; one call at a time. Called in the leading process only.
using KeepPiece = std::function<void(std::size_t, const std::string&)>;

/// Thrown if a process cannot take part in the work, although the work itself is correct.
class ProcessFailure : public Error {
public:
    using Error::Error;
};

/// Work in pieces by a single process: work_through(), and the pieces are stored.
void work_alone(const PieceSource& next, unsigned threads, const MakePiece& make,
                const KeepPiece& keep);

/// The same by several processes: the first hands out the pieces in small blocks, works as well,
/// and stores all pieces. `sign` must be the same in all processes: it shows that they do the same
/// work. Returns when all of them have ended. If pieces fail, throws Error with the text of the
/// lowest one (Interrupted if that was the reason), as a single process would; ProcessFailure.
///
/// The death of a process is not detected here: the launcher of the processes then ends the others.
/// Stored pieces are kept.
void lead_work(Processes& processes, const std::string& sign, const PieceSource& next,
               unsigned threads, const MakePiece& make, const KeepPiece& keep);
/// The work of the other processes until the first ends it. Failures are reported to the first.
void follow_work(Processes& processes, const std::string& sign, unsigned threads,
                 const MakePiece& make);

/// For a process that cannot begin: the first dismisses the others; any other reports the reason to
/// the first.
void dismiss(Processes& processes);
void follow_failed(Processes& processes, const std::string& why);

} // namespace edgeproof::parallel
