// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/answers/answers.hpp"

#include "edgeproof/io/process.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

namespace edgeproof::conformance {
namespace {

constexpr std::size_t hopeless_questions = 3;
// Limits of the output of a run: large enough for long answers, but bounded.
constexpr std::size_t bytes_of_a_run = 1'000'000;
constexpr std::size_t bytes_an_answer = 128'000;
constexpr std::size_t most_bytes = 200'000'000;
constexpr std::size_t rows_of_a_run = 1000;
// Limits, in characters, of the standard error that is kept and shown if a program answers nothing.
constexpr std::size_t most_kept = 4000;
constexpr std::size_t most_shown = 500;
const std::string program_name = "the program";

using Batch = std::vector<std::size_t>;

class ProgramDriver {
public:
    ProgramDriver(const Questions& asked, const ProgramDriverOptions& options)
        : asked_(asked), options_(options) {
        answers_.questions = asked;
        answers_.questions.file = program_name;
        answers_.given.resize(asked.list.size());
        for (std::size_t at = 0; at < asked.list.size(); at += options.batch) {
            Batch batch(std::min(options.batch, asked.list.size() - at));
            std::iota(batch.begin(), batch.end(), at);
            open_.push_back(std::move(batch));
        }
        several_ = open_.size() > 1;
    }

    Answers run() {
        while (!open_.empty() && !given_up()) {
            const Batch batch = std::move(open_.front());
            open_.pop_front();
            ask(batch);
            if (options_.progress) {
                options_.progress(asked_.list.size() - left(), asked_.list.size());
            }
        }
        if (!answered_ && !messages_.empty()) {
            answers_.faults.push_back(
                program_name +
                " answers nothing; its standard error begins: " + shortened(messages_, most_shown));
        }
        return std::move(answers_);
    }

private:
    [[nodiscard]] std::size_t left() const {
        return std::transform_reduce(open_.begin(), open_.end(), std::size_t{0}, std::plus{},
                                     [](const Batch& batch) { return batch.size(); });
    }
    bool given_up() {
        const bool hopeless = !answered_ && ended_by_ >= hopeless_questions;
        if (!hopeless && runs_ < options_.runs) {
            return false;
        }
        answers_.faults.push_back(program_name + " is given up after " + std::to_string(runs_) +
                                  (hopeless ? " runs that answered nothing, the last of which "
                                            : " runs (--runs), the last failed one of which ") +
                                  (last_ending_.empty() ? "ended well" : last_ending_) + "; " +
                                  std::to_string(left()) + " questions are not asked again");
        return true;
    }

    void ask(const Batch& batch) {
        Questions part;
        part.file = asked_.file;
        part.contacts = asked_.contacts;
        for (const std::size_t i : batch) {
            part.list.push_back(asked_.list[i]);
        }
        io::ProgramCall call = io::shell_call(options_.command);
        call.input = options_.write_csv(part);
        call.seconds = options_.seconds;
        call.most_output = std::min(bytes_of_a_run + bytes_an_answer * batch.size(), most_bytes);
        messages_.clear();
        call.said = [&](std::string_view text) {
            messages_ += text.substr(0, std::min(text.size(), most_kept - messages_.size()));
            if (options_.said) {
                options_.said(text);
            }
        };
        ++runs_;
        io::ProgramRun run = run_program(call);
        const std::string name =
            several_ || runs_ > 1 ? program_name + ", run " + std::to_string(runs_) : program_name;
        const std::string ending = run.ending();
        Answers answers;
        answers.given.resize(batch.size());
        try {
            std::string output = io::utf8_text(std::move(run.output), name);
            if (!ending.empty()) {
                // It may have ended within a number; an incomplete number would be wrong.
                output.resize(output.rfind('\n') + 1); // npos + 1 is 0
            }
            const std::size_t most_rows = rows_of_a_run + 2 * batch.size();
            const io::Csv rows = io::parse_csv(output, name, {true, most_rows});
            answers = answers_to(part, rows);
            if (rows.cut) {
                answers.faults.push_back(name + ": more than " + std::to_string(most_rows) +
                                         " rows to " + std::to_string(batch.size()) +
                                         " questions; the rest is not read");
            }
        } catch (const InputError& error) {
            if (ending.empty()) {
                answers.faults.emplace_back(error.what());
            }
        }
        Batch left;
        for (std::size_t k = 0; k < batch.size(); ++k) {
            if (answers.given[k].line == 0) {
                left.push_back(batch[k]);
            } else {
                answers_.given[batch[k]] = answers.given[k];
            }
        }
        answers_.out_of_order += answers.out_of_order;
        std::move(answers.faults.begin(), answers.faults.end(),
                  std::back_inserter(answers_.faults));
        const bool some = left.size() < batch.size();
        answered_ = answered_ || some;
        if (ending.empty()) {
            return; // the remaining answers are missing
        }
        last_ending_ = ending;
        if (left.empty()) {
            answers_.faults.push_back(program_name + " " + ending + ", all answered");
        } else if (batch.size() == 1) {
            ++ended_by_;
            Answer& answer = answers_.given[left.front()];
            answer.state = Answer::State::died;
            answer.text = ending;
        } else {
            divide(left, some);
        }
    }

    /// Asks the questions left by a failed run again, in smaller batches.
    void divide(const Batch& left, bool some) {
        if (!answered_ && ended_by_ == 0 && left.size() > hopeless_questions) {
            // The first, the last and the middle question show if the program answers anything at
            // all.
            const auto middle = left.begin() + static_cast<long>(left.size() / 2);
            halve(Batch(left.begin() + 1, middle), Batch(middle + 1, left.end() - 1));
            for (const std::size_t i : {*middle, left.back(), left.front()}) {
                open_.push_front({i});
            }
            return;
        }
        // A program that writes each answer immediately was crashed by the first question left.
        const std::size_t first = some ? 1 : (left.size() + 1) / 2;
        const auto middle = left.begin() + static_cast<long>(first);
        halve(Batch(left.begin(), middle), Batch(middle, left.end()));
    }
    void halve(Batch first, Batch second) {
        for (Batch* half : {&second, &first}) {
            if (!half->empty()) {
                open_.push_front(std::move(*half));
            }
        }
    }

    const Questions& asked_;
    const ProgramDriverOptions& options_;
    Answers answers_;
    std::deque<Batch> open_;
    bool several_ = false;
    bool answered_ = false;
    std::size_t runs_ = 0;
    std::size_t ended_by_ = 0; ///< questions that crashed it, asked alone
    std::string last_ending_;
    std::string messages_; ///< the begin of the standard error of the last run
};

} // namespace

Answers ask_program_in_batches(const Questions& asked, const ProgramDriverOptions& options) {
    return ProgramDriver(asked, options).run();
}

} // namespace edgeproof::conformance
