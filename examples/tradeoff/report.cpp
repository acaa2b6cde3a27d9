// SPDX-License-Identifier: MIT
// report.html: one chart per problem as inline SVG, both axes logarithmic; a few lines of script show what a mark is. Nothing is loaded from outside.
#include "front.hpp"
#include "output.hpp"

#include "bolide/observe/whole_file.hpp"

#include <cmath>
#include <cstdio>
#include <map>

namespace tradeoff {
namespace {

constexpr int width = 620, height = 400, left = 62, right = 14, top = 12, bottom = 46;
constexpr const char* colours[] = {"#1f77b4", "#d95f02", "#2a9d4a", "#b5179e", "#8c6d31", "#7b61c9", "#c1121f", "#0f8b8d"};

std::string number(double x, const char* format = "%.3g") {
  char text[40];
  std::snprintf(text, sizeof text, format, x);
  return text;
}
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') out += "&lt;";
    else if (c == '&') out += "&amp;";
    else if (c == '"') out += "&quot;";
    else out += c;
  }
  return out;
}

/// A logarithmic axis from `low` to `high` over the pixels `from` to `to`.
struct axis {
  double low, high, from, to;
  double at(double x) const { return from + (std::log(x / low)) / std::log(high / low) * (to - from); }
};
axis axis_of(double low, double high, double from, double to) { return {low / 1.3, high * 1.3, from, to}; }
/// 1, 2 and 5 of every decade.
template <class F> void each_tick(const axis& a, F&& f) {
  for (int decade = static_cast<int>(std::floor(std::log10(a.low))); decade <= std::ceil(std::log10(a.high)); ++decade)
    for (const int digit : {1, 2, 5})
      if (const double x = digit * std::pow(10.0, decade); x >= a.low && x <= a.high) f(x, digit == 1);
}

std::string chart(const rows& all, const std::map<std::string, std::size_t>& colour_of) {
  double cost_low = 1e300, cost_high = 0, error_low = 1e300, error_high = 0;
  for (const auto* r : all) {
    cost_low = std::min(cost_low, r->cost), cost_high = std::max(cost_high, r->cost);
    error_low = std::min(error_low, r->error), error_high = std::max(error_high, r->error);
  }
  const axis x = axis_of(cost_low, cost_high, left, width - right), y = axis_of(100 * error_low, 100 * error_high, height - bottom, top);
  std::string svg = "<svg viewBox=\"0 0 " + std::to_string(width) + " " + std::to_string(height) + "\" role=\"img\">\n";
  const auto line = [&](double x0, double y0, double x1, double y1) {
    svg += "<path class=\"grid\" d=\"M" + number(x0, "%.1f") + " " + number(y0, "%.1f") + "L" + number(x1, "%.1f") + " " + number(y1, "%.1f") + "\"/>";
  };
  const auto text = [&](double at_x, double at_y, const char* anchor, const std::string& what) {
    svg += "<text x=\"" + number(at_x, "%.1f") + "\" y=\"" + number(at_y, "%.1f") + "\" text-anchor=\"" + anchor + "\">" + what + "</text>\n";
  };
  each_tick(x, [&](double v, bool) { line(x.at(v), top, x.at(v), height - bottom), text(x.at(v), height - bottom + 16, "middle", number(v)); });
  each_tick(y, [&](double v, bool) { line(left, y.at(v), width - right, y.at(v)), text(left - 6, y.at(v) + 4, "end", number(v)); });
  text((left + width - right) / 2.0, height - 8, "middle", "CPU time (s)");
  svg += "<text transform=\"translate(14 " + std::to_string((top + height - bottom) / 2) + ") rotate(-90)\" text-anchor=\"middle\">error (%)</text>\n";
  std::string way;
  for (const auto* r : front_of(all)) way += std::string(way.empty() ? "M" : "L") + number(x.at(r->cost), "%.1f") + " " + number(y.at(100 * r->error), "%.1f");
  svg += "<path class=\"front\" d=\"" + way + "\"/>\n";
  for (const auto* r : all) {
    const auto c = colour_of.at(r->how.shape + " " + r->how.transfer);
    svg += "<circle class=\"m\" tabindex=\"0\" cx=\"" + number(x.at(r->cost), "%.1f") + "\" cy=\"" + number(y.at(100 * r->error), "%.1f") + "\" r=\"4.5\" fill=\"" + colours[c % std::size(colours)] +
           "\" data-n=\"" + escaped(name_of(*r)) + "\" data-d=\"" + number(r->cells) + " cells: error " + number(100 * r->error) + " %, " + number(r->cost) + " s, " +
           number(static_cast<double>(r->steps), "%.0f") + " steps, " + number(r->particles, "%.0f") + " particles, " + number(1e9 * r->cost / r->particle_steps, "%.0f") + " ns per particle and step\"/>\n";
  }
  return svg + "</svg>\n";
}

constexpr const char* head = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>bolide: error against cost</title>
<style>
body{font:15px/1.45 system-ui,sans-serif;margin:24px auto;max-width:1320px;padding:0 16px;color:#1b2733;background:#fff}
h1{font-size:22px}h2{font-size:16px;margin:0 0 2px}p{margin:2px 0 8px;max-width:80ch}
.charts{display:grid;grid-template-columns:repeat(auto-fit,minmax(420px,1fr));gap:22px}
svg{width:100%;height:auto;font:11px system-ui,sans-serif}text{fill:#33424f}.grid{stroke:#e3e8ed;fill:none}
.front{stroke:#1b2733;stroke-width:1.6;fill:none;stroke-dasharray:5 3}
.m{fill-opacity:.75;stroke:#fff;stroke-width:.7;cursor:pointer}.m.same{stroke:#000;stroke-width:1.8;fill-opacity:1}.m:focus{outline:none}.dim .m:not(.same){fill-opacity:.12}
#tip{position:fixed;display:none;background:#1b2733;color:#fff;padding:7px 10px;border-radius:5px;font-size:13px;max-width:340px;pointer-events:none;z-index:2}
.key span{display:inline-block;margin-right:16px}.key i{display:inline-block;width:11px;height:11px;border-radius:50%;margin-right:5px}
small{color:#5a6b7b}
</style></head><body>
<h1>Error against cost</h1>
)";
constexpr const char* tail = R"(<div id="tip"></div>
<script>
const tip=document.getElementById("tip"),marks=[...document.querySelectorAll(".m")];
function show(m){tip.innerHTML="";const b=document.createElement("b");b.textContent=m.dataset.n;tip.append(b,document.createElement("br"),m.dataset.d);tip.style.display="block";
const r=m.getBoundingClientRect();tip.style.left=Math.min(r.right+10,innerWidth-360)+"px";tip.style.top=Math.max(8,r.top-tip.offsetHeight-6)+"px";
document.body.classList.add("dim");for(const o of marks)o.classList.toggle("same",o.dataset.n===m.dataset.n)}
function hide(){tip.style.display="none";document.body.classList.remove("dim");for(const o of marks)o.classList.remove("same")}
for(const m of marks){m.addEventListener("pointerenter",()=>show(m));m.addEventListener("pointerleave",hide);m.addEventListener("focus",()=>show(m));m.addEventListener("blur",hide)}
</script></body></html>
)";

} // namespace

void write_report(const std::filesystem::path& path, const bolide::advise::table& t, const std::string& measured_on) {
  std::map<std::string, std::size_t> colour_of;
  for (const auto& r : t.rows) colour_of.try_emplace(r.how.shape + " " + r.how.transfer, colour_of.size());
  std::string page = head;
  page += "<p>" + std::to_string(t.rows.size()) + " compositions and resolutions, measured on " + escaped(measured_on) +
          ". Point at a mark: it names its composition, and its other resolutions stand out in every chart. Dashed: the front, which no other point beats in both.</p>\n<p class=\"key\">";
  for (const auto& [name, c] : colour_of) page += "<span><i style=\"background:" + std::string(colours[c % std::size(colours)]) + "\"></i>" + escaped(name) + "</span>";
  page += "</p>\n<div class=\"charts\">\n";
  for (const auto& problem : problem_names(t)) {
    const rows all = rows_of(t, problem);
    page += "<section><h2>" + escaped(problem) + "</h2><small>" + std::to_string(all.size()) + " runs, kind: " + escaped(all.front()->kind) + "</small>\n" + chart(all, colour_of) + "</section>\n";
  }
  page += "</div>\n";
  bolide::observe::write_whole_file(path, page + tail);
}

} // namespace tradeoff
