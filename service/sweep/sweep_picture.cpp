#include "service/sweep/sweep_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "service/http/problem.h"

namespace rouleau::service {

namespace {

using Points = std::vector<std::pair<double, double>>;

// px
constexpr double width = 420, height = 320, left = 70, right = 20, top = 34, bottom = 48;

const char* const colours[] = {"#0b6e99", "#c8553d", "#588157", "#7b5ea7", "#b08900", "#5c677d"};

std::ptrdiff_t column_named(const SweepTable& table, const std::string& name) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& column) { return column.name == name; });
  return found == table.columns.end() ? -1 : found - table.columns.begin();
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    safe += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return safe;
}

struct Range {
  double from, to;

  double at(double value, double first, double last) const {
    return first + (value - from) / (to - from) * (last - first);
  }
};

/// From 1, 2 or 5 times a power of ten below the values to one above.
double step_of(double span) {
  const double power = std::pow(10, std::floor(std::log10(span / 4)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power * 5 >= span) return factor * power;
  }
  return 10 * power;
}

Range range_of(const std::map<std::string, Points>& lines, bool of_y) {
  Range range{HUGE_VAL, -HUGE_VAL};
  for (const auto& [label, points] : lines) {
    for (const auto& [x, y] : points) {
      range = {std::min(range.from, of_y ? y : x), std::max(range.to, of_y ? y : x)};
    }
  }
  const double largest = std::max(std::abs(range.from), std::abs(range.to));
  if (range.to - range.from <= 1e-9 * largest) {
    const double margin = range.from == 0 ? 1 : 0.1 * std::abs(range.from);
    range = {range.from - margin, range.to + margin};
  }
  const double step = step_of(range.to - range.from);
  return {std::floor(range.from / step) * step, std::ceil(range.to / step) * step};
}

std::string draw_ticks(const Range& x, const Range& y) {
  std::string svg;
  const double x_step = step_of(x.to - x.from), y_step = step_of(y.to - y.from);
  for (int k = 0; k <= std::lround((x.to - x.from) / x_step); ++k) {
    const double v = x.from + k * x_step;
    const double at = x.at(v, left, width - right);
    svg += fmt::format(
        "<path stroke=\"#444\" d=\"M{0:.1f},{1}v5\"/><text x=\"{0:.1f}\" y=\"{2}\" "
        "text-anchor=\"middle\">{3:.4g}</text>\n",
        at, height - bottom, height - bottom + 18, std::abs(v) < x_step / 2 ? 0 : v);
  }
  for (int k = 0; k <= std::lround((y.to - y.from) / y_step); ++k) {
    const double v = y.from + k * y_step;
    const double at = y.at(v, height - bottom, top);
    svg += fmt::format(
        "<path stroke=\"#444\" d=\"M{0},{1:.1f}h-5\"/><text x=\"{2}\" y=\"{3:.1f}\" "
        "text-anchor=\"end\">{4:.4g}</text>\n",
        left, at, left - 9, at + 4, std::abs(v) < y_step / 2 ? 0 : v);
  }
  return svg;
}

std::string draw_lines(const std::map<std::string, Points>& lines, const Range& x, const Range& y) {
  std::string svg;
  std::size_t k = 0;
  for (const auto& [label, points] : lines) {
    const char* const colour = colours[k % std::size(colours)];
    std::string path, dots;
    for (const auto& [px, py] : points) {
      const double cx = x.at(px, left, width - right), cy = y.at(py, height - bottom, top);
      path += fmt::format("{}{:.1f},{:.1f}", path.empty() ? 'M' : 'L', cx, cy);
      dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/>", cx, cy);
    }
    svg += fmt::format("<g stroke=\"{0}\" fill=\"{0}\"><path d=\"{1}\" fill=\"none\"/>{2}</g>\n", colour,
                       path, dots);
    if (lines.size() > 1 && k < 12) {
      svg += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\" fill=\"{}\">{}</text>\n",
                         width - right, top + 12 + 14 * static_cast<double>(k), colour, escaped(label));
    }
    ++k;
  }
  return svg;
}

std::string draw_panel(const std::map<std::string, Points>& lines, const std::string& title,
                       const std::string& x_label, double offset) {
  const Range x = range_of(lines, false), y = range_of(lines, true);
  return fmt::format(
             "<g transform=\"translate({0},0)\"><text x=\"{1}\" y=\"20\" font-weight=\"bold\">{2}</text>\n"
             "<g stroke=\"#444\" stroke-width=\"0.8\"><path d=\"M{1},{3}V{4}H{5}\" fill=\"none\"/></g>\n"
             "<text x=\"{6}\" y=\"{7}\" text-anchor=\"middle\">{8}</text>\n<g stroke=\"none\" "
             "fill=\"#222\">",
             offset, left, escaped(title), top, height - bottom, width - right, (left + width - right) / 2,
             height - 8, escaped(x_label)) +
         draw_ticks(x, y) + "</g>\n" + draw_lines(lines, x, y) + "</g>\n";
}

/// A column against the first axis, by the values of the second.
std::map<std::string, Points> lines_of(const SweepTable& table, std::size_t first_axis, bool two_axes,
                                       const std::string& name) {
  std::map<std::string, Points> lines;
  const auto column = column_named(table, name);
  if (column < 0) return lines;
  for (const auto& row : table.rows) {
    const auto& x = row[first_axis];
    const auto& y = row[static_cast<std::size_t>(column)];
    if (!x.is_number() || !y.is_number()) continue;
    const std::string label =
        two_axes ? table.columns[first_axis + 1].name + " = " + dump(row[first_axis + 1]) : "";
    lines[label].emplace_back(x.get<double>(), y.get<double>());
  }
  for (auto& [label, points] : lines) std::sort(points.begin(), points.end());
  return lines;
}

bool shows_something(const std::map<std::string, Points>& lines) {
  return std::any_of(lines.begin(), lines.end(), [](const auto& line) { return line.second.size() > 1; });
}

}  // namespace

std::string draw_sweep(const SweepTable& table, std::size_t axes) {
  if (axes < 1 || axes > 2) return "";
  const auto state = column_named(table, "state");
  const auto first_axis = static_cast<std::size_t>(state) - axes;
  const auto tau = lines_of(table, first_axis, axes == 2, "cell0.peak_tau");
  const auto velocity = lines_of(table, first_axis, axes == 2, "cell0.peak_velocity");
  if (!shows_something(tau) || !shows_something(velocity)) return "";
  const std::string& x_label = table.columns[first_axis].name;
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
             "font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"{0}\" height=\"{1}\" "
             "fill=\"#fff\"/>\n",
             2 * width, height) +
         draw_panel(tau, "peak tau of cell 0", x_label, 0) +
         draw_panel(velocity, "peak velocity of cell 0, m/s", x_label, width) + "</svg>\n";
}

}  // namespace rouleau::service
