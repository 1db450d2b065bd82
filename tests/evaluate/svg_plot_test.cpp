#include "evaluate/svg_plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

namespace macula::evaluate {
namespace {

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

// Places of the marks of points, in their order.
std::vector<std::pair<double, double>> circlesOf(const std::string& svg) {
    static const std::regex circle("<circle cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\"");
    std::vector<std::pair<double, double>> places;
    for (std::sregex_iterator it(svg.begin(), svg.end(), circle), end; it != end; ++it)
        places.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
    return places;
}

TEST(SvgPlot, PutsEqualStepsAtEqualPlaces) {
    const auto places = circlesOf(toSvg({{.curves = {{.name = "a", .x = {0, 1, 2}, .y = {0, 10, 20}}}}}));
    ASSERT_EQ(places.size(), 3u);
    EXPECT_NEAR(places[2].first - places[1].first, places[1].first - places[0].first, 0.11);
    EXPECT_NEAR(places[2].second - places[1].second, places[1].second - places[0].second, 0.11);
    EXPECT_GT(places[1].first, places[0].first);
    EXPECT_LT(places[1].second, places[0].second);  // up is more
}

TEST(SvgPlot, PutsEqualRatiosAtEqualPlacesOfALogarithmicAxis) {
    const auto places = circlesOf(toSvg({{.logarithmicX = true,
                                          .logarithmicY = true,
                                          .curves = {{.name = "a", .x = {1, 10, 100}, .y = {0.1, 1, 10}}}}}));
    ASSERT_EQ(places.size(), 3u);
    EXPECT_NEAR(places[2].first - places[1].first, places[1].first - places[0].first, 0.11);
    EXPECT_NEAR(places[2].second - places[1].second, places[1].second - places[0].second, 0.11);
}

TEST(SvgPlot, LeavesOutWhatHasNoPlace) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const std::string svg =
        toSvg({{.logarithmicX = true,
                .curves = {{.name = "a", .x = {0, -1, 1, 2, 3}, .y = {1, 1, nan, infinity, 4}}}}});
    EXPECT_EQ(circlesOf(svg).size(), 1u);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    // Of nothing, no axes either.
    EXPECT_EQ(countOf(toSvg({{.title = "Empty", .curves = {{.name = "a", .x = {nan}, .y = {1}}}}}), "<text"),
              0u);
}

TEST(SvgPlot, IsXmlWhateverNamesSay) {
    const std::string svg =
        toSvg({{.title = "a < b & c", .curves = {{.name = "<x>", .x = {1}, .y = {1}, .dashed = true}}},
               {.title = "second", .curves = {{.name = "b", .x = {1}, .y = {1}}}}});
    EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
    EXPECT_NE(svg.find("&lt;x&gt;"), std::string::npos);
    EXPECT_EQ(countOf(svg, "<svg"), 1u);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_EQ(countOf(svg, "<text"), countOf(svg, "</text>"));
    EXPECT_EQ(countOf(svg, "stroke-dasharray"), 2u);  // the curve and its name's line
    // The second lies below the first.
    const auto places = circlesOf(svg);
    ASSERT_EQ(places.size(), 2u);
    EXPECT_GT(places[1].second, places[0].second);
}

}  // namespace
}  // namespace macula::evaluate
