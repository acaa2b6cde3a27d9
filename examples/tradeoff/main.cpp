// SPDX-License-Identifier: MIT
// What does accuracy cost? Compositions of the solver on problems with known answers: error against CPU time, and the advisor that reads the table.
//
//   bash examples/run.sh tradeoff                     the matrix (some 25 minutes on one core) to tradeoff_out/: CSV, JSON, pictures, report.html
//   bash examples/run.sh tradeoff --judge --docs .    and: is the advice good on other problems? and docs/tradeoff.md, include/bolide/advise/measured.hpp
//   --minutes N     no run is begun after that, the finest are left out (default 60)      --out DIR     results
//   --from FILE     rows of an earlier tradeoff.csv are not measured again                --judged FILE nor those of an earlier judge.csv or fresh.csv
//   --fresh         the judge asks about problems on which nothing was tuned (with --judge: about both)
//   --quick         two kinds of problems, coarse
// The units: settings and compositions (what is composed), problem_* (what is computed, and its error), matrix (which runs, how often), tables, picture,
// report, docs (files), judge.
#include "front.hpp"
#include "judge.hpp"
#include "output.hpp"

#include "bolide/observe/whole_file.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <iterator>

using namespace tradeoff;
namespace advise = bolide::advise;

namespace {

struct request {
  bool quick = false, judge = false, fresh = false;
  double minutes = 60;
  std::string out = "tradeoff_out", docs, from, judged;
};

request read(int argc, char** argv) {
  request r;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    const auto value = [&]() -> std::string {
      if (i + 1 >= argc) throw bolide::bad_parameter(name + ": wants a value");
      return argv[++i];
    };
    if (name == "--quick") r.quick = true;
    else if (name == "--judge") r.judge = true;
    else if (name == "--fresh") r.fresh = true;
    else if (name == "--out") r.out = value();
    else if (name == "--docs") r.docs = value();
    else if (name == "--from") r.from = value();
    else if (name == "--judged") r.judged = value();
    else if (name == "--minutes") {
      const std::string text = value();
      if (!bolide::text::parse_number(text, r.minutes) || !(r.minutes > 0)) throw bolide::bad_parameter("--minutes = '" + text + "': must be a positive number");
    } else throw bolide::bad_parameter("'" + name + "': no such option; there are --quick, --judge, --fresh, --minutes N, --out DIR, --docs ROOT, --from FILE, --judged FILE");
  }
  return r;
}

/// A name for a file: letters and digits of the problem's name.
std::string slug(const std::string& name) {
  std::string text;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c))) text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!text.empty() && text.back() != '_') text += '_';
  return text;
}

/// Runs those of the tasks that `known` has no row of; the rows so far, and those known of the problems, are in `file`, should the program be stopped.
advise::table measure_all(const std::vector<problem>& problems, const std::vector<task>& tasks, double minutes, const std::filesystem::path& file, const advise::table& known) {
  const auto with_known = [&](std::vector<advise::row> rows) {
    std::copy_if(known.rows.begin(), known.rows.end(), std::inserter(rows, rows.begin()),
                 [&](const advise::row& r) { return std::any_of(problems.begin(), problems.end(), [&](const problem& p) { return p.name == r.problem; }); });
    return advise::table{std::move(rows), "this run"};
  };
  const measured all = run(problems, missing(problems, tasks, known), minutes, [&](const measured& so_far) { write_csv(file, with_known(so_far.rows)); });
  std::printf("%zu rows in %.0f s of CPU time; %zu runs came to no end, %zu left out for lack of time\n", all.rows.size(), all.seconds, all.failures.size(), all.left_out);
  for (const auto& f : all.failures) std::printf("  no end: %s\n", f.c_str());
  return with_known(all.rows);
}

/// What must hold of any run of the matrix: the default composition gains by refinement, and somewhere a choice pays.
int check(const advise::table& t) {
  int wrong = 0;
  for (const auto& problem : problem_names(t)) {
    const rows all = rows_of(t, problem);
    const advise::row *coarse = nullptr, *fine = nullptr;
    for (const auto* r : all)
      if (r->how == advise::method{"bspline", "apic", "usf", "double"} && r->skip) {
        if (!coarse || r->cells < coarse->cells) coarse = r;
        if (!fine || r->cells > fine->cells) fine = r;
      }
    const auto front = front_of(all);
    std::printf("%-30s %3zu rows, %2zu on the front: %s, %g cells, %.2f %%, %.3g s  to  %s, %g cells, %.2f %%, %.3g s\n", problem.c_str(), all.size(), front.size(), name_of(*front.front()).c_str(),
                front.front()->cells, 100 * front.front()->error, front.front()->cost, name_of(*front.back()).c_str(), front.back()->cells, 100 * front.back()->error, front.back()->cost);
    if (coarse && fine->cells > coarse->cells && !(fine->error < coarse->error)) ++wrong, std::printf("  the default composition gains nothing by refinement\n");
  }
  return wrong;
}

int work(const request& r) {
  const std::filesystem::path out = r.out;
  const auto problems = matrix_problems();
  const auto read_or_none = [](const std::string& file) { return file.empty() ? advise::table{} : advise::read_table(file); };
  const advise::table t = measure_all(problems, r.quick ? quick_tasks(problems) : all_tasks(problems), r.minutes, out / "tradeoff.csv", read_or_none(r.from));
  const std::string on = machine();
  write_csv(out / "tradeoff.csv", t);
  write_json(out / "tradeoff.json", t, on);
  for (const auto& problem : problem_names(t)) write_picture(out / (slug(problem) + ".png"), t, problem);
  write_report(out / "report.html", t, on);
  const int wrong = check(t);

  // the table as a user reads it
  const advise::advisor ask(advise::read_table(out / "tradeoff.csv"));
  for (const auto& problem : problem_names(t)) {
    const auto& one = *rows_of(t, problem).front();
    const auto a = ask.for_accuracy({one.kind, one.extent, one.duration, one.strength, one.tube}, 0.02);
    std::printf("2 %% in %s: %s on %g cells, %.2g s, %.0f %% sure; %s\n", problem.c_str(), name(a.how).c_str(), a.cells, a.cost, 100 * a.sure, a.why.c_str());
  }
  const auto verdict_on = [&](const std::vector<problem>& others, const std::filesystem::path& file) {
    advise::table others_rows = measure_all(others, judge_tasks(others), r.minutes, file, read_or_none(r.judged));
    write_csv(file, others_rows);
    const auto verdicts = judge(ask, others, others_rows);
    write_csv(file, others_rows);
    const std::string text = section(verdicts);
    std::printf("%s", text.c_str());
    return text;
  };
  const std::string judged = r.judge ? verdict_on(judge_problems(), out / "judge.csv") : "", fresh = r.fresh ? verdict_on(fresh_problems(), out / "fresh.csv") : "";
  if (!r.docs.empty()) write_docs(r.docs, t, on, judged, fresh);
  std::printf("results in %s\n", r.out.c_str());
  return wrong == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
  try {
    return work(read(argc, argv));
  } catch (const bolide::bad_parameter& e) {
    std::fprintf(stderr, "tradeoff: %s\n", e.what());
    return 2;
  } catch (const failed_run& e) {
    std::fprintf(stderr, "tradeoff: %s\n", e.why.c_str());
    return 1;
  } catch (const std::exception& e) { // a file that cannot be written
    std::fprintf(stderr, "tradeoff: %s\n", e.what());
    return 1;
  }
}
