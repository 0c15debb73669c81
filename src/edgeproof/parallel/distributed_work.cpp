// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/parallel/distributed_work.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <tbb/concurrent_queue.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace edgeproof::parallel {
namespace {

// Messages, by their first letter. From the others: s SIGN (the first message), w NUMBER (pieces
// wanted), r PIECE TEXT (made), f PIECE KIND TEXT (failed), b (bye, the last message). From the
// first process: p PIECE PIECE ..., e (end; answers a w).
constexpr std::size_t most_in_a_block = 64; // MPI may send short messages before they are received
constexpr std::chrono::microseconds shortest_nap{50};
constexpr std::chrono::microseconds longest_nap{1000};

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

/// The part of one process in the work. Other threads make pieces; the thread that calls run()
/// handles the messages meanwhile.
class Part {
public:
    explicit Part(Processes& processes) : processes_(processes) {}
    virtual ~Part() = default;
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

    // For the threads that make pieces: the next piece, and its result.
    virtual std::optional<std::size_t> next() = 0;
    virtual void keep(std::size_t piece, const std::string& text) = 0;
    virtual void fail(const Failure& f) = 0;

    /// Calls loop() in a thread of its own, and returns when it has returned and the messages have
    /// ended.
    void run(const std::function<void()>& loop) {
        std::atomic<bool> done{false};
        std::jthread working([&] {
            loop();
            done = true;
        });
        std::chrono::microseconds nap = shortest_nap;
        try {
            while (!done || !over()) {
                if (exchange()) {
                    nap = shortest_nap;
                } else {
                    std::this_thread::sleep_for(nap);
                    nap = std::min(2 * nap, longest_nap);
                }
            }
        } catch (const std::exception& e) { // its own threads must end as well
            stop(e.what());
            throw;
        }
    }
    /// The same with a loop that makes the pieces.
    void run(unsigned threads, const MakePiece& make) {
        run([&] {
            work_through([&] { return next(); }, threads,
                         [&](std::size_t p) {
                             std::string text;
                             if (const auto failure = failure_of(p, [&] { text = make(p); })) {
                                 fail(*failure);
                             } else {
                                 keep(p, text);
                             }
                         });
        });
    }

protected:
    /// Sends and receives messages; returns true if there were any.
    virtual bool exchange() = 0;
    /// True if no more messages are expected.
    [[nodiscard]] virtual bool over() const = 0;
    /// Ends next(), since messages cannot be handled any longer.
    virtual void stop(const std::string& why) = 0;

    [[nodiscard]] Processes& processes() const { return processes_; }

private:
    Processes& processes_;
};

/// The first process: has the state of the whole work.
class Lead : public Part {
public:
    Lead(Processes& processes, std::string sign, const PieceSource& next, const KeepPiece& keep)
        : Part(processes), sign_(std::move(sign)), next_(next), keep_(keep) {}

    std::optional<std::size_t> next() override {
        const std::lock_guard lock(mutex_);
        return failure_ ? std::nullopt : next_();
    }
    void keep(std::size_t piece, const std::string& text) override {
        const std::lock_guard lock(mutex_);
        if (const auto failure = failure_of(piece, [&] { keep_(piece, text); })) {
            fail_locked(*failure);
        }
    }
    void fail(const Failure& f) override {
        const std::lock_guard lock(mutex_);
        fail_locked(f);
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
    bool exchange() override {
        const auto message = processes().receive();
        if (message) {
            hear(*message);
        }
        return message.has_value();
    }
    [[nodiscard]] bool over() const override { return gone_ + 1 >= processes().count(); }
    void stop(const std::string& why) override { fail(Failure::of_process(why)); }

    void hear(const Processes::Message& message) {
        std::string_view text = message.text;
        const char letter = text.empty() ? '?' : text.front();
        text.remove_prefix(text.empty() ? 0 : 1);
        if (letter == 's' && text != sign_) {
            fail(Failure::of_process("process " + std::to_string(message.from) +
                                     " is another program or reads another recipe; start the same "
                                     "everywhere"));
        } else if (letter == 'w') {
            processes().send(message.from, block(take_number(text)));
        } else if (letter == 'r') {
            const std::size_t piece = take_number(text);
            keep(piece, std::string(text));
        } else if (letter == 'f') {
            const std::size_t piece = take_number(text);
            const char kind = text.empty() ? 'e' : text.front();
            text.remove_prefix(text.empty() ? 0 : 1);
            fail({piece, static_cast<Failure::Kind>(kind), std::string(text)});
        } else if (letter == 'b') {
            ++gone_;
        }
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

    std::string sign_;
    const PieceSource& next_;
    const KeepPiece& keep_;
    std::size_t gone_ = 0; ///< the processes that have sent bye
    std::mutex mutex_;
    std::optional<Failure> failure_;
};

/// Another process: the pieces that it has to make, and its messages not yet sent.
class Follow : public Part {
public:
    Follow(Processes& processes, std::size_t threads, const std::string& first_message)
        : Part(processes), want_(2 * threads) {
        to_report_.push(first_message);
    }

    std::optional<std::size_t> next() override {
        std::optional<std::size_t> p;
        pieces_.pop(p); // waits for one
        if (!p) {
            pieces_.push(p); // for the other threads
        }
        return p;
    }
    void keep(std::size_t piece, const std::string& text) override {
        to_report_.push("r" + std::to_string(piece) + " " + text);
    }
    void fail(const Failure& f) override { to_report_.push(message_of(f)); }

private:
    bool exchange() override {
        bool any = false;
        for (std::string text; to_report_.try_pop(text); any = true) {
            processes().send(0, text);
        }
        if (!asked_ && !ended_ && pieces_.size() < static_cast<std::ptrdiff_t>(want_ / 2 + 1)) {
            asked_ = any = true;
            processes().send(0, "w" + std::to_string(want_));
        }
        if (const auto message = processes().receive()) {
            any = true;
            hear(message->text);
        }
        return any;
    }
    [[nodiscard]] bool over() const override { return ended_ && to_report_.empty(); }
    void stop(const std::string&) override {
        for (std::optional<std::size_t> p; pieces_.try_pop(p);) {
        }
        pieces_.push({});
    }
    void hear(std::string_view text) {
        asked_ = false;
        ended_ = text == "e";
        if (ended_) {
            pieces_.push({});
        }
        text.remove_prefix(1);
        while (!text.empty()) {
            pieces_.push(take_number(text));
        }
    }

    std::size_t want_;
    tbb::concurrent_bounded_queue<std::optional<std::size_t>> pieces_; ///< empty: the end
    tbb::concurrent_queue<std::string> to_report_;
    bool asked_ = false;
    bool ended_ = false;
};

constexpr const char* bye = "b";

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
    lead.run(threads, make);
    lead.throw_if_failed();
}

void follow_work(Processes& processes, const std::string& sign, unsigned threads,
                 const MakePiece& make) {
    Follow(processes, threads, "s" + sign).run(threads, make);
    processes.send(0, bye);
}

void dismiss(Processes& processes) {
    const PieceSource none = [] { return std::optional<std::size_t>{}; };
    const KeepPiece no_keep = [](std::size_t, const std::string&) {};
    Lead(processes, "", none, no_keep).run([] {});
}

void follow_failed(Processes& processes, const std::string& why) {
    Follow mine(processes, 1, message_of(Failure::of_process(why)));
    mine.run([&] {
        while (mine.next()) { // pieces that were handed over meanwhile
        }
    });
    processes.send(0, bye);
}

} // namespace edgeproof::parallel
