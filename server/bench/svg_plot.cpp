#include "bench/svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace cloudscape::bench {
namespace {

// Pixels of the picture and of the frame in it.
constexpr double width_px = 960, height_px = 540, left_px = 84, right_px = 24, bottom_px = 60;
constexpr double title_y_px = 30, legend_y_px = 54, legend_row_px = 20, legend_sample_px = 24;
constexpr double letter_px = 7.4;  // tuned: mean width of a letter of 13 px, a little more than most fonts have

// Okabe and Ito 2008 (Color Universal Design) without black and yellow: told apart by every kind of colour vision.
constexpr std::array<const char*, 6> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
constexpr const char* text_colour = "#222222";
constexpr const char* grid_colour = "#dddddd";
constexpr const char* mark_colour = "#888888";
constexpr const char* faint_grid_colour = "#f0f0f0";

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value == 0 ? 0.0 : value);
  return text;
}

std::string pixels(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (static_cast<unsigned char>(c) >= ' ' || c == '\t')  // XML 1.0 has no other control characters
      out += c;
  }
  return out;
}

// "10" and the exponent as raised digits.
std::string power_of_ten(int exponent) {
  static constexpr std::array<const char*, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += raised[static_cast<std::size_t>(digit - '0')];
  return text;
}

struct Tick {
  double place;  // on the axis: the value, or its decadic logarithm
  std::string label;
};

struct Axis {
  double from = 0, to = 1;  // as Tick::place
  bool logarithmic = false;
  std::vector<Tick> ticks;
  std::vector<double> faint;  // lines without a label

  bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }
  double share(double value) const { return ((logarithmic ? std::log10(value) : value) - from) / (to - from); }
};

struct Range {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  void add(double value) { least = std::min(least, value), greatest = std::max(greatest, value); }
  bool empty() const { return least > greatest; }
};

// 1, 2 or 5 times a power of ten, so that about `parts` of them fill the length.
double round_step(double length, double parts) {
  const double rough = length / parts, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (rough <= factor * power * (1 + 1e-9)) return factor * power;
  return 10 * power;
}

// `whole` widens the axis to whole steps.
Axis linear_axis(Range range, double parts, bool whole) {
  if (range.empty()) range = {0, 1};
  if (range.least == range.greatest) range.greatest += range.greatest == 0 ? 1 : std::abs(range.greatest);
  const double step = round_step(range.greatest - range.least, parts), slack = 1e-6;
  Axis axis{range.least, range.greatest, false, {}, {}};
  if (whole) {
    axis.from = step * std::floor(range.least / step + slack);
    axis.to = step * std::ceil(range.greatest / step - slack);
  }
  for (double i = std::ceil(axis.from / step - slack); i <= axis.to / step + slack; ++i)
    axis.ticks.push_back({i * step, number(i * step)});
  return axis;
}

// Whole decades; with few of them, twos and fives have labels too.
Axis logarithmic_axis(const Range& range) {
  Axis axis{0, 1, true, {}, {}};
  if (!range.empty()) {
    axis.from = std::floor(std::log10(range.least)), axis.to = std::ceil(std::log10(range.greatest));
    if (axis.from == axis.to) ++axis.to;
  }
  const int decades = static_cast<int>(axis.to - axis.from), step = 1 + (decades - 1) / 10;
  for (int i = 0; i <= decades; ++i) {
    const int exponent = static_cast<int>(axis.from) + i;
    const bool plain = std::abs(exponent) <= 3;
    if (i % step == 0)
      axis.ticks.push_back({double(exponent), plain ? number(std::pow(10.0, exponent)) : power_of_ten(exponent)});
    for (int digit = 2; digit < 10 && i < decades && step == 1; ++digit) {
      const double place = exponent + std::log10(digit);
      if (decades <= 2 && plain && (digit == 2 || digit == 5))
        axis.ticks.push_back({place, number(digit * std::pow(10.0, exponent))});
      else
        axis.faint.push_back(place);
    }
  }
  return axis;
}

void check(const LinePlot& plot) {
  if (plot.lines.size() > palette.size()) throw std::invalid_argument("a plot has at most 6 lines");
  for (const PlotLine& line : plot.lines)
    if (line.x.size() != line.y.size()) throw std::invalid_argument("a line has as many x as y: " + line.name);
}

// What is drawn, and where: the frame's edges, px, and the axes.
struct Layout {
  Axis x, y;
  double top = 0;
  double px(double share) const { return left_px + share * (width_px - right_px - left_px); }
  double py(double share) const { return height_px - bottom_px - share * (height_px - bottom_px - top); }
};

std::string text_at(double x, double y, const char* attributes, const std::string& text) {
  return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" " + attributes + ">" + escaped(text) + "</text>\n";
}

std::string line_between(double x0, double y0, double x1, double y1, const std::string& colour) {
  return "<path d=\"M" + pixels(x0) + " " + pixels(y0) + "L" + pixels(x1) + " " + pixels(y1) + "\" stroke=\"" + colour +
         "\"/>\n";
}

// Colour and name of each line, in rows above the frame. `top`: where the next row would stand.
std::string legend_of(const LinePlot& plot, double& top) {
  std::string svg;
  double x = left_px, y = legend_y_px;
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    const double length = legend_sample_px + 8 + letter_px * static_cast<double>(plot.lines[i].name.size()) + 20;
    if (x > left_px && x + length > width_px - right_px) x = left_px, y += legend_row_px;
    svg += "<path d=\"M" + pixels(x) + " " + pixels(y) + "h" + pixels(legend_sample_px) + "\" stroke=\"" + palette[i] +
           "\" stroke-width=\"3\"/>\n";
    svg += text_at(x + legend_sample_px + 8, y + 4.5, "", plot.lines[i].name);
    x += length;
  }
  top = y + legend_row_px;
  return svg;
}

std::string grid_of(const Layout& layout) {
  std::string svg;
  const double left = layout.px(0), right = layout.px(1), bottom = layout.py(0), top = layout.py(1);
  const auto up = [&](double place) { return layout.py((place - layout.y.from) / (layout.y.to - layout.y.from)); };
  const auto along = [&](double place) { return layout.px((place - layout.x.from) / (layout.x.to - layout.x.from)); };
  for (const double place : layout.y.faint) svg += line_between(left, up(place), right, up(place), faint_grid_colour);
  for (const Tick& tick : layout.y.ticks)
    svg += line_between(left, up(tick.place), right, up(tick.place), grid_colour) +
           text_at(left - 8, up(tick.place) + 4.5, "text-anchor=\"end\"", tick.label);
  for (const Tick& tick : layout.x.ticks)
    svg += line_between(along(tick.place), bottom, along(tick.place), top, grid_colour) +
           text_at(along(tick.place), bottom + 20, "text-anchor=\"middle\"", tick.label);
  return svg + line_between(left, bottom, right, bottom, text_colour) +
         line_between(left, bottom, left, top, text_colour);
}

std::string marks_of(const LinePlot& plot, const Layout& layout) {
  std::string svg;
  for (const PlotMark& mark : plot.marks) {
    const double share = layout.x.share(mark.x);
    if (!(share >= 0 && share <= 1)) continue;
    const std::string x = pixels(layout.px(share));
    svg += "<path d=\"M" + x + " " + pixels(layout.py(0)) + "V" + pixels(layout.py(1)) + "\" stroke=\"" + mark_colour +
           "\" stroke-dasharray=\"4 4\"/>\n" +
           text_at(layout.px(share) + 6, layout.py(1) + 16, "font-style=\"italic\"", mark.name);
  }
  return svg;
}

// A point that stands alone between two gaps is a dot.
std::string curve_of(const PlotLine& line, const Layout& layout, const std::string& colour) {
  std::string points;
  bool drawing = false;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    const bool shown = layout.x.shows(line.x[i]) && layout.y.shows(line.y[i]);
    if (shown) {
      const std::string at =
          pixels(layout.px(layout.x.share(line.x[i]))) + " " + pixels(layout.py(layout.y.share(line.y[i])));
      points += drawing ? "L" + at : "M" + at + "h0";
    }
    drawing = shown;
  }
  if (points.empty()) return "";
  return "<path d=\"" + points + "\" stroke=\"" + colour +
         "\" stroke-width=\"1.8\" stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n";
}

Layout layout_of(const LinePlot& plot) {
  Range x, y;
  for (const PlotLine& line : plot.lines)
    for (std::size_t i = 0; i < line.x.size(); ++i)
      if (std::isfinite(line.x[i]) && std::isfinite(line.y[i]) && (!plot.logarithmic_y || line.y[i] > 0))
        x.add(line.x[i]), y.add(line.y[i]);
  if (!plot.logarithmic_y && !y.empty()) y.add(0);
  return {linear_axis(x, 10, false), plot.logarithmic_y ? logarithmic_axis(y) : linear_axis(y, 8, true), 0};
}

}  // namespace

std::string svg_of(const LinePlot& plot) {
  check(plot);
  Layout layout = layout_of(plot);
  const std::string legend = legend_of(plot, layout.top);
  const double middle_px = (left_px + width_px - right_px) / 2, middle_py = (layout.py(0) + layout.py(1)) / 2;
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(width_px) + " " +
                    number(height_px) + "\" width=\"" + number(width_px) + "\" height=\"" + number(height_px) +
                    "\" role=\"img\">\n<title>" + escaped(plot.title) + "</title>\n" +
                    "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" +
                    "<g font-family=\"sans-serif\" font-size=\"13\" fill=\"" + text_colour + "\">\n";
  svg += text_at(left_px, title_y_px, "font-size=\"17\" font-weight=\"bold\"", plot.title);
  svg += grid_of(layout) + marks_of(plot, layout) + legend;
  svg += text_at(middle_px, height_px - 14, "text-anchor=\"middle\"", plot.x_label);
  svg += "<g transform=\"translate(20 " + pixels(middle_py) + ") rotate(-90)\">" +
         text_at(0, 4.5, "text-anchor=\"middle\"", plot.y_label) + "</g>\n</g>\n<g fill=\"none\">\n";
  for (std::size_t i = 0; i < plot.lines.size(); ++i) svg += curve_of(plot.lines[i], layout, palette[i]);
  return svg + "</g>\n</svg>\n";
}

}  // namespace cloudscape::bench
