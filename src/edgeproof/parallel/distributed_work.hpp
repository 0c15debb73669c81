// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/parallel/processes.hpp"
#include "edgeproof/precision/error.hpp"

#include <cstddef>
#include <functional>
#include <string>

namespace edgeproof::parallel {

/// Makes the piece p. Called from several threads.
using MakePiece = std::function<std::string(std::size_t)>;
/// Keeps a piece that was made; one call at a time. Called in the leading process only.
using KeepPiece = std::function<void(std::size_t, const std::string&)>;

/// Thrown where it is not the work that is at fault, but that a process cannot take part in it.
class ProcessFailure : public Error {
public:
    using Error::Error;
};

/// Work in pieces, done by one process alone: work_through(), and what is made is kept.
void work_alone(const PieceSource& next, unsigned threads, const MakePiece& make,
                const KeepPiece& keep);

/// The same by several processes: the first hands out the pieces in small blocks, works as well,
/// and keeps what all make. `sign` must be the same in all: it tells that they are at the same
/// work. Returns when all of them have ended. Where pieces fail, throws Error with the text of the
/// least one (Interrupted where that was the reason), as a process alone would; ProcessFailure.
///
/// A process that dies is not noticed here: whoever started the processes ends the others then, and
/// what was kept is kept.
void lead_work(Processes& processes, const std::string& sign, const PieceSource& next,
               unsigned threads, const MakePiece& make, const KeepPiece& keep);
/// What the others do until they are told to end. Failures are told to the first.
void follow_work(Processes& processes, const std::string& sign, unsigned threads,
                 const MakePiece& make);

/// For a process that cannot even begin: the first dismisses the others; any other tells the
/// first why.
void dismiss(Processes& processes);
void follow_failed(Processes& processes, const std::string& why);

} // namespace edgeproof::parallel
