// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/interview.hpp"

#include "edgeproof/conformance/program.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <deque>
#include <numeric>
#include <utility>

namespace edgeproof {
namespace {

constexpr std::size_t hopeless_runs = 3;
const std::string program_name = "the program";

using Batch = std::vector<std::size_t>;

Csv rows_of(const std::string& output, Lines lines, const std::string& name) {
    if (lines == Lines::json) {
        return parse_json_lines(output, name);
    }
    Csv csv = parse_csv(output, name);
    const auto id = csv.column("id");
    const auto value = csv.column("value");
    if (id && value) {
        const std::size_t cells = csv.header.cells.size();
        csv.header.cells = {"id", "value"};
        for (Csv::Row& row : csv.rows) {
            // A row that is not whole must not look as if it were.
            row.cells = row.cells.size() == cells ? std::vector{row.cells[*id], row.cells[*value]}
                                                  : std::vector{row.cells.front()};
        }
    }
    return csv;
}

class Interview {
public:
    Interview(const Questions& asked, const InterviewOptions& options)
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
                std::size_t left = 0;
                for (const Batch& b : open_) {
                    left += b.size();
                }
                options_.progress(asked_.list.size() - left, asked_.list.size());
            }
        }
        return std::move(answers_);
    }

private:
    bool given_up() {
        const bool hopeless = !answered_ && bad_runs_ >= hopeless_runs;
        if (!hopeless && runs_ < options_.runs) {
            return false;
        }
        std::size_t left = 0;
        for (const Batch& batch : open_) {
            left += batch.size();
        }
        answers_.faults.push_back(program_name + " is given up after " + std::to_string(runs_) +
                                  (hopeless ? " runs that answered nothing, the last of which "
                                            : " runs (--runs), the last bad one of which ") +
                                  (last_ending_.empty() ? "ended well" : last_ending_) + "; " +
                                  std::to_string(left) + " questions are not asked again");
        return true;
    }

    void ask(const Batch& batch) {
        Questions part;
        part.file = asked_.file;
        part.contacts = asked_.contacts;
        for (const std::size_t i : batch) {
            part.list.push_back(asked_.list[i]);
        }
        const std::string text =
            options_.lines == Lines::json ? json_lines(part) : options_.write_csv(part);
        ++runs_;
        const ProgramRun run = run_program(options_.command, text, options_.seconds, options_.stop);
        const std::string name =
            several_ || runs_ > 1 ? program_name + ", run " + std::to_string(runs_) : program_name;
        const std::string ending = run.ending();
        Answers answers;
        answers.given.resize(batch.size());
        try {
            answers = answers_to(part, rows_of(run.output, options_.lines, name));
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
        std::move(answers.faults.begin(), answers.faults.end(),
                  std::back_inserter(answers_.faults));
        const bool some = left.size() < batch.size();
        answered_ = answered_ || some;
        if (ending.empty()) {
            return; // what is left is missing
        }
        ++bad_runs_;
        last_ending_ = ending;
        if (left.empty()) {
            answers_.faults.push_back(program_name + " " + ending + ", all answered");
        } else if (batch.size() == 1) {
            Answer& answer = answers_.given[left.front()];
            answer.state = Answer::State::died;
            answer.text = ending;
        } else {
            // It wrote as it went: then the first without an answer ended it. Or it did not.
            const std::size_t first = some ? 1 : (left.size() + 1) / 2;
            const auto middle = left.begin() + static_cast<long>(first);
            if (middle != left.end()) {
                open_.push_front(Batch(middle, left.end()));
            }
            open_.push_front(Batch(left.begin(), middle));
        }
    }

    const Questions& asked_;
    const InterviewOptions& options_;
    Answers answers_;
    std::deque<Batch> open_;
    bool several_ = false;
    bool answered_ = false;
    std::size_t runs_ = 0;
    std::size_t bad_runs_ = 0;
    std::string last_ending_;
};

} // namespace

Answers interview(const Questions& asked, const InterviewOptions& options) {
    return Interview(asked, options).run();
}

} // namespace edgeproof
