// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/parallel/distributed_work.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace edgeproof::parallel {
namespace {

// Messages, by their first letter. From the others: s SIGN (the first message), w NUMBER (pieces
// wanted), r PIECE TEXT (made), f PIECE KIND TEXT (failed), b (bye, the last message). From the
// first process: p PIECE PIECE ..., e (end; answers a w).
constexpr std::size_t most_in_a_block = 64; // MPI may send short messages before they are received
constexpr std::chrono::microseconds shortest_nap{50};
constexpr std::chrono::microseconds longest_nap{1000};

/// Sleeps longer as long as nothing happens.
class Nap {
public:
    void none() { nap_ = shortest_nap; }
    void take() {
        std::this_thread::sleep_for(nap_);
        nap_ = std::min(2 * nap_, longest_nap);
    }

private:
    std::chrono::microseconds nap_ = shortest_nap;
};

/// Removes a number, followed by a blank or the end, from the front of the text and returns it.
std::size_t take_number(std::string_view& text) {
    std::size_t n = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    if (error != std::errc{}) {
        throw Error("a message between processes is garbled");
    }
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    text.remove_prefix(text.empty() ? 0 : 1);
    return n;
}

/// The failure of a piece, or of a process that cannot take part (no piece).
struct Failure {
    enum class Kind : char { error = 'e', interrupted = 's', process = 'p' };
    std::size_t piece = 0;
    Kind kind = Kind::error;
    std::string why;

    static Failure of_process(std::string why) { return {0, Kind::process, std::move(why)}; }
    [[nodiscard]] bool comes_before(const Failure& other) const {
        return other.kind != Kind::process && (kind == Kind::process || piece < other.piece);
    }
};
std::string message_of(const Failure& f) {
    return "f" + std::to_string(f.piece) + " " + static_cast<char>(f.kind) + f.why;
}

/// Calls f and returns what it throws as a Failure.
template <class F> std::optional<Failure> failure_of(std::size_t piece, const F& f) {
    try {
        f();
        return {};
    } catch (const Interrupted& e) {
        return Failure{piece, Failure::Kind::interrupted, e.what()};
    } catch (const std::exception& e) {
        return Failure{piece, Failure::Kind::error, e.what()};
    }
}

/// The state of the whole work in the first process.
class Lead {
public:
    Lead(Processes& processes, std::string sign, const PieceSource& next, const KeepPiece& keep)
        : processes_(processes), sign_(std::move(sign)), next_(next), keep_(keep) {}

    /// For the threads of this process.
    std::optional<std::size_t> next() {
        const std::lock_guard lock(mutex_);
        return failure_ ? std::nullopt : next_();
    }
    void keep(std::size_t piece, const std::string& text) {
        const std::lock_guard lock(mutex_);
        if (const auto failure = failure_of(piece, [&] { keep_(piece, text); })) {
            fail_locked(*failure);
        }
    }
    void fail(const Failure& f) {
        const std::lock_guard lock(mutex_);
        fail_locked(f);
    }

    /// Answers the others until all have sent bye and `done` returns true for this process.
    template <class Done> void serve(const Done& done) {
        Nap nap;
        std::size_t gone = 0;
        while (gone + 1 < processes_.count() || !done()) {
            const auto message = processes_.receive();
            if (!message) {
                nap.take();
                continue;
            }
            nap.none();
            gone += hear(*message) ? 1 : 0;
        }
    }
    void throw_if_failed() const {
        if (!failure_) {
            return;
        }
        switch (failure_->kind) {
        case Failure::Kind::interrupted:
            throw Interrupted(failure_->why);
        case Failure::Kind::process:
            throw ProcessFailure(failure_->why);
        case Failure::Kind::error:
            break;
        }
        throw Error(failure_->why);
    }

private:
    /// Returns true for a bye.
    bool hear(const Processes::Message& message) {
        std::string_view text = message.text;
        const char letter = text.empty() ? '?' : text.front();
        text.remove_prefix(text.empty() ? 0 : 1);
        if (letter == 's' && text != sign_) {
            fail(Failure::of_process("process " + std::to_string(message.from) +
                                     " is another program or reads another recipe; start the same "
                                     "everywhere"));
        } else if (letter == 'w') {
            processes_.send(message.from, block(take_number(text)));
        } else if (letter == 'r') {
            const std::size_t piece = take_number(text);
            keep(piece, std::string(text));
        } else if (letter == 'f') {
            const std::size_t piece = take_number(text);
            const char kind = text.empty() ? 'e' : text.front();
            text.remove_prefix(text.empty() ? 0 : 1);
            fail({piece, static_cast<Failure::Kind>(kind), std::string(text)});
        }
        return letter == 'b';
    }
    std::string block(std::size_t wanted) {
        std::string text;
        for (std::size_t i = 0; i < std::min(wanted, most_in_a_block); ++i) {
            const auto p = next();
            if (!p) {
                break;
            }
            text += (text.empty() ? "p" : " ") + std::to_string(*p);
        }
        return text.empty() ? "e" : text;
    }
    void fail_locked(const Failure& f) {
        if (!failure_ || f.comes_before(*failure_)) {
            failure_ = f;
        }
    }

    Processes& processes_;
    std::string sign_;
    const PieceSource& next_;
    const KeepPiece& keep_;
    std::mutex mutex_;
    std::optional<Failure> failure_;
};

/// The pieces that another process has to make, and its results not yet sent.
class Follow {
public:
    explicit Follow(std::size_t threads) : want_(2 * threads) {}

    /// For the threads that make pieces: waits for one.
    std::optional<std::size_t> next() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return !pieces_.empty() || ended_; });
        if (pieces_.empty()) {
            return {};
        }
        const std::size_t p = pieces_.front();
        pieces_.pop_front();
        return p;
    }
    void report(std::string text) {
        const std::lock_guard lock(mutex_);
        to_report_.push_back(std::move(text));
    }

    /// For the thread that handles the messages. Returns true if anything happened.
    bool exchange(Processes& processes) {
        std::deque<std::string> out;
        bool wants = false;
        {
            const std::lock_guard lock(mutex_);
            out.swap(to_report_);
            wants = !asked_ && !ended_ && pieces_.size() < want_ / 2 + 1;
        }
        for (const std::string& text : out) {
            processes.send(0, text);
        }
        if (wants) {
            asked_ = true;
            processes.send(0, "w" + std::to_string(want_));
        }
        const auto message = processes.receive();
        if (message) {
            hear(message->text);
        }
        return message || wants || !out.empty();
    }
    void end() {
        const std::lock_guard lock(mutex_);
        pieces_.clear();
        ended_ = true;
        changed_.notify_all();
    }
    [[nodiscard]] bool ended() {
        const std::lock_guard lock(mutex_);
        return ended_ && to_report_.empty();
    }

private:
    void hear(std::string_view text) {
        const std::lock_guard lock(mutex_);
        ended_ = text == "e";
        asked_ = false;
        text.remove_prefix(1);
        while (!text.empty()) {
            pieces_.push_back(take_number(text));
        }
        changed_.notify_all();
    }

    std::size_t want_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::size_t> pieces_;
    std::deque<std::string> to_report_;
    bool asked_ = false; ///< used only by the thread that handles the messages
    bool ended_ = false;
};

/// Reports an exception of `loop` to the first process, then sends bye.
template <class Loop> void follow(Processes& processes, Follow& mine, const Loop& loop) {
    std::atomic<bool> done{false};
    std::jthread working([&] {
        loop();
        done = true;
    });
    Nap nap;
    try {
        while (!done || !mine.ended()) {
            if (mine.exchange(processes)) {
                nap.none();
            } else {
                nap.take();
            }
        }
        processes.send(0, "b");
    } catch (...) { // its own threads must end as well
        mine.end();
        throw;
    }
}

} // namespace

void work_alone(const PieceSource& next, unsigned threads, const MakePiece& make,
                const KeepPiece& keep) {
    std::mutex keeping;
    work_through(next, threads, [&](std::size_t p) {
        const std::string text = make(p);
        const std::lock_guard lock(keeping);
        keep(p, text);
    });
}

void lead_work(Processes& processes, const std::string& sign, const PieceSource& next,
               unsigned threads, const MakePiece& make, const KeepPiece& keep) {
    Lead lead(processes, sign, next, keep);
    std::atomic<bool> done{false};
    {
        std::jthread working([&] {
            work_through([&] { return lead.next(); }, threads,
                         [&](std::size_t p) {
                             std::string text;
                             if (const auto failure = failure_of(p, [&] { text = make(p); })) {
                                 lead.fail(*failure);
                             } else {
                                 lead.keep(p, text);
                             }
                         });
            done = true;
        });
        try {
            lead.serve([&] { return done.load(); });
        } catch (const std::exception& e) { // its own threads must end as well
            lead.fail(Failure::of_process(e.what()));
            throw;
        }
    }
    lead.throw_if_failed();
}

void follow_work(Processes& processes, const std::string& sign, unsigned threads,
                 const MakePiece& make) {
    Follow mine(threads);
    mine.report("s" + sign);
    follow(processes, mine, [&] {
        work_through([&] { return mine.next(); }, threads,
                     [&](std::size_t p) {
                         std::string text;
                         if (const auto failure = failure_of(p, [&] { text = make(p); })) {
                             mine.report(message_of(*failure));
                         } else {
                             mine.report("r" + std::to_string(p) + " " + text);
                         }
                     });
    });
}

void dismiss(Processes& processes) {
    const PieceSource none = [] { return std::optional<std::size_t>{}; };
    const KeepPiece no_keep = [](std::size_t, const std::string&) {};
    Lead(processes, "", none, no_keep).serve([] { return true; });
}

void follow_failed(Processes& processes, const std::string& why) {
    Follow mine(1);
    mine.report(message_of(Failure::of_process(why)));
    follow(processes, mine, [&] {
        while (mine.next()) { // pieces that were handed over meanwhile
        }
    });
}

} // namespace edgeproof::parallel
