// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/reference.hpp"
#include "edgeproof/parallel/distributed_work.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace {

/// Processes that are threads of this one; queues carry the messages.
struct Wires {
    explicit Wires(std::size_t count) : boxes(count) {}
    std::mutex mutex;
    std::vector<std::deque<Processes::Message>> boxes;
};

class FakeProcesses : public Processes {
public:
    FakeProcesses(Wires& wires, std::size_t number) : wires_(wires), number_(number) {}
    [[nodiscard]] std::size_t number() const override { return number_; }
    [[nodiscard]] std::size_t count() const override { return wires_.boxes.size(); }
    void send(std::size_t to, const std::string& text) override {
        const std::lock_guard lock(wires_.mutex);
        wires_.boxes[to].push_back({number_, text});
    }
    std::optional<Message> receive() override {
        const std::lock_guard lock(wires_.mutex);
        auto& box = wires_.boxes[number_];
        if (box.empty()) {
            return {};
        }
        Message message = box.front();
        box.pop_front();
        return message;
    }

private:
    Wires& wires_;
    std::size_t number_;
};

/// The result of work that several processes shared.
struct Outcome {
    std::map<std::size_t, std::string> kept;
    std::set<std::size_t> makers; ///< the processes that made a piece
    std::string error;
    bool left_over = false; ///< there is an unread message
};

using Make = std::function<std::string(std::size_t process, std::size_t piece)>;
using Follower = std::function<void(Processes&, const MakePiece&)>;

void follow_as_usual(Processes& processes, const MakePiece& make) {
    follow_work(processes, "sign", 2, make);
}

Outcome share(std::size_t processes, std::size_t pieces, const Make& make, const KeepPiece& also,
              const Follower& follower = follow_as_usual) {
    Wires wires(processes);
    Outcome outcome;
    std::mutex making;
    const auto make_in = [&](std::size_t process) {
        return [&, process](std::size_t p) {
            {
                const std::lock_guard lock(making);
                outcome.makers.insert(process);
            }
            return make(process, p);
        };
    };
    {
        std::vector<std::jthread> others;
        for (std::size_t n = 1; n < processes; ++n) {
            others.emplace_back([&, n] {
                FakeProcesses mine(wires, n);
                follower(mine, make_in(n));
            });
        }
        FakeProcesses first(wires, 0);
        try {
            lead_work(first, "sign", all_pieces(pieces), 2, make_in(0),
                      [&](std::size_t p, const std::string& text) {
                          also(p, text);
                          outcome.kept[p] += text;
                      });
        } catch (const Interrupted& e) {
            outcome.error = std::string("interrupted: ") + e.what();
        } catch (const ProcessFailure& e) {
            outcome.error = std::string("process: ") + e.what();
        } catch (const Error& e) {
            outcome.error = e.what();
        }
    }
    for (const auto& box : wires.boxes) {
        outcome.left_over = outcome.left_over || !box.empty();
    }
    return outcome;
}

void keep_nothing_else(std::size_t, const std::string&) {}

/// The work takes long enough that every process gets some.
std::string slowly(std::size_t, std::size_t p) {
    std::this_thread::sleep_for(std::chrono::microseconds(300));
    return "piece " + std::to_string(p);
}

} // namespace

TEST_CASE("work shared by several processes is done once, all of it, by all of them") {
    for (const std::size_t processes : {1U, 2U, 4U}) {
        const Outcome o = share(processes, 500, slowly, keep_nothing_else);
        CAPTURE(processes);
        CHECK(o.error.empty());
        CHECK(o.kept.size() == 500);
        CHECK(o.kept.at(0) == "piece 0");
        CHECK(o.kept.at(499) == "piece 499"); // a second copy would be appended
        CHECK(o.makers.size() == processes);
        CHECK_FALSE(o.left_over);
    }
    CHECK(share(3, 0, slowly, keep_nothing_else).kept.empty());
}

TEST_CASE("of several pieces that fail, the first one is reported, from any process") {
    const auto make = [](std::size_t, std::size_t p) {
        if (p % 100 == 37) {
            throw InputError("piece " + std::to_string(p) + " is bad", "correct it");
        }
        return slowly(0, p);
    };
    for (const std::size_t processes : {1U, 2U, 4U}) {
        const Outcome o = share(processes, 1000, make, keep_nothing_else);
        CAPTURE(processes);
        CHECK(o.error == "piece 37 is bad; correct it");
        CHECK(o.kept.size() >= 37); // all before it, and a few that were already distributed
        CHECK(o.kept.size() < 200);
        CHECK_FALSE(o.left_over);
    }
}

TEST_CASE("a stop in any process ends all of them, and so does a result that cannot be kept") {
    const auto stops = [](std::size_t process, std::size_t p) -> std::string {
        if (process == 1 && p > 20) {
            throw Interrupted("interrupted");
        }
        return slowly(process, p);
    };
    const Outcome stopped = share(3, 100'000, stops, keep_nothing_else);
    CHECK(stopped.error == "interrupted: interrupted");
    CHECK(stopped.kept.size() < 50'000);

    const Outcome full = share(3, 100'000, slowly, [](std::size_t, const std::string&) {
        throw InputError("no space", "free some");
    });
    CHECK(full.error == "no space; free some");
    CHECK(full.kept.empty());
}

TEST_CASE("a process that cannot take part ends the others and is reported") {
    const Outcome other_recipe = share(
        3, 100'000, slowly, keep_nothing_else, [](Processes& processes, const MakePiece& make) {
            follow_work(processes, processes.number() == 2 ? "other" : "sign", 1, make);
        });
    CHECK(other_recipe.error.rfind("process: process 2 is another program or reads another recipe",
                                   0) == 0);
    const Outcome no_recipe = share(
        3, 100'000, slowly, keep_nothing_else, [](Processes& processes, const MakePiece& make) {
            if (processes.number() == 1) {
                follow_failed(processes, "r.toml: there is no such file");
            } else {
                follow_as_usual(processes, make);
            }
        });
    CHECK(no_recipe.error == "process: r.toml: there is no such file");
    CHECK_FALSE(no_recipe.left_over);
}

TEST_CASE("a first process that cannot begin dismisses the others") {
    Wires wires(3);
    std::size_t dismissed = 0;
    {
        std::vector<std::jthread> others;
        std::mutex counting;
        for (std::size_t n = 1; n < 3; ++n) {
            others.emplace_back([&, n] {
                FakeProcesses mine(wires, n);
                follow_work(mine, "sign", 2, [](std::size_t) { return std::string(); });
                const std::lock_guard lock(counting);
                ++dismissed;
            });
        }
        FakeProcesses first(wires, 0);
        dismiss(first);
    }
    CHECK(dismissed == 2);
}
