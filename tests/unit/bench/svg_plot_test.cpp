// Plots: round ticks, a curve where its numbers say, gaps, escaped text.
#include "bench/svg_plot.h"

#include <gmock/gmock.h>

#include <cmath>
#include <regex>
#include <set>
#include <stdexcept>

namespace cloudscape::bench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> all(const std::string& text, const std::string& pattern) {
  std::vector<std::string> found;
  const std::regex regex(pattern);
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

std::vector<std::string> x_labels(const std::string& svg) {
  return all(svg, R"(<text x="[0-9.]+" y="500.0" text-anchor="middle">([^<]*)<)");
}
std::vector<std::string> y_labels(const std::string& svg) { return all(svg, R"(text-anchor="end">([^<]*)<)"); }
std::vector<std::string> curves(const std::string& svg) { return all(svg, R"re(<path d="([^"]*)"[^>]*linejoin)re"); }

LinePlot plot_of(std::vector<double> x, std::vector<double> y, bool logarithmic_y = false) {
  return {"title", "time, s", "frame time, ms", logarithmic_y, {{"on", std::move(x), std::move(y)}}};
}

TEST(SvgPlot, TicksAreRoundAndTheAxisBeginsAtZero) {
  const std::string svg = svg_of(plot_of({0, 80}, {11, 73}));
  EXPECT_THAT(x_labels(svg), ElementsAre("0", "10", "20", "30", "40", "50", "60", "70", "80"));
  EXPECT_THAT(y_labels(svg), ElementsAre("0", "10", "20", "30", "40", "50", "60", "70", "80"));
  EXPECT_THAT(y_labels(svg_of(plot_of({0, 1}, {-0.3, 0.5}))),
              ElementsAre("-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3", "0.4", "0.5"));
}

TEST(SvgPlot, TheCurveRunsFromCornerToCorner) {
  EXPECT_THAT(curves(svg_of(plot_of({0, 5, 10}, {0, 50, 100}))), ElementsAre("M84.0 480.0h0L510.0 277.0L936.0 74.0"));
}

TEST(SvgPlot, ALogarithmicAxisHasDecades) {
  const std::string svg = svg_of(plot_of({0, 90, 180}, {1e-4, 1, 1e3}, true));
  EXPECT_THAT(y_labels(svg), ElementsAre("10⁻⁴", "0.001", "0.01", "0.1", "1", "10", "100", "1000"));
  EXPECT_THAT(curves(svg), ElementsAre("M84.0 480.0h0L510.0 248.0L936.0 74.0"));
  EXPECT_THAT(y_labels(svg_of(plot_of({0, 1}, {2, 30}, true))),
              testing::UnorderedElementsAre("1", "2", "5", "10", "20", "50", "100"));
  EXPECT_THAT(y_labels(svg_of(plot_of({0, 1}, {1e-30, 1}, true))).size(), testing::Le(12u));
}

TEST(SvgPlot, WhatCannotBeShownLeavesAGap) {
  EXPECT_THAT(curves(svg_of(plot_of({0, 1, 2, 3, 4}, {1, 1, NAN, 1, 1}))),
              ElementsAre("M84.0 74.0h0L297.0 74.0M723.0 74.0h0L936.0 74.0"));
  EXPECT_THAT(curves(svg_of(plot_of({0, 1, 2}, {10, 0, 10}, true))),
              ElementsAre(testing::ContainsRegex("^M[^L]*M[^L]*$")));
  EXPECT_THAT(curves(svg_of(plot_of({0, 1}, {-1, -1}, true))), ElementsAre());
}

TEST(SvgPlot, EveryLineHasAColourAndALegendEntry) {
  LinePlot plot = plot_of({0, 1}, {1, 2});
  for (const char* name : {"b", "c", "d", "e", "f"}) plot.lines.push_back({name, {0, 1}, {2, 3}});
  const std::string svg = svg_of(plot);
  const auto colours = all(svg, R"re(stroke="(#[0-9a-f]{6})" stroke-width="3")re");
  EXPECT_EQ(std::set<std::string>(colours.begin(), colours.end()).size(), 6u);
  EXPECT_EQ(all(svg, R"re(stroke="(#[0-9a-f]{6})" stroke-width="1.8")re"), colours);
  plot.lines.push_back({"g", {}, {}});
  EXPECT_THROW(svg_of(plot), std::invalid_argument);
}

TEST(SvgPlot, ALongLegendWrapsAboveTheFrame) {
  LinePlot plot = plot_of({0, 1}, {1, 2});
  plot.lines[0].name = std::string(80, 'a');
  plot.lines.push_back({std::string(80, 'b'), {0, 1}, {0, 1}});
  EXPECT_THAT(all(svg_of(plot), R"re(y="([0-9.]+)" >[ab]{80})re"), ElementsAre("58.5", "78.5"));
  EXPECT_THAT(curves(svg_of(plot))[0], HasSubstr("L936.0 94.0"));
}

TEST(SvgPlot, MarksStandWhereTheyBelong) {
  LinePlot plot = plot_of({0, 10}, {1, 2});
  plot.marks = {{5, "inside"}, {11, "beyond"}};
  const std::string svg = svg_of(plot);
  EXPECT_THAT(svg, HasSubstr("<path d=\"M510.0 480.0V74.0\""));
  EXPECT_THAT(svg, HasSubstr(">inside<"));
  EXPECT_THAT(svg, Not(HasSubstr("beyond")));
}

TEST(SvgPlot, TextIsEscaped) {
  LinePlot plot = plot_of({0, 1}, {1, 2});
  plot.title = "a < b & \"c\" > d\x01";
  const std::string svg = svg_of(plot);
  EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; &quot;c&quot; &gt; d<"));
  EXPECT_THAT(svg, Not(HasSubstr("a < b")));
  EXPECT_THAT(svg, HasSubstr("<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>"));
}

TEST(SvgPlot, NothingOrOnePointIsAPlotToo) {
  for (const std::string& svg :
       {svg_of({"t", "x", "y", false, {}}), svg_of({"t", "x", "y", true, {}}), svg_of(plot_of({3}, {0})),
        svg_of(plot_of({3}, {7})), svg_of(plot_of({3}, {1}, true))}) {
    EXPECT_THAT(svg, HasSubstr("</svg>"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
    EXPECT_GE(y_labels(svg).size(), 2u);
  }
  EXPECT_THROW(svg_of(plot_of({1, 2}, {1})), std::invalid_argument);
}

}  // namespace
}  // namespace cloudscape::bench
