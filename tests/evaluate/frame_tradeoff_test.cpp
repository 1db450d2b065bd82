// The parts of macula-bench evaluate tradeoff that need no device: what is varied, what a frame costs, and
// what is told of it.
#include "evaluate/frame_tradeoff.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <tuple>

namespace macula::evaluate {
namespace {

TEST(FrameRecipes, AreEachWithEach) {
    const FrameLevels levels;
    std::set<std::tuple<double, std::uint32_t, int, bool, int, bool>> all;
    for (const TracedFovea& fovea : foveaeOf(levels)) {
        for (const FrameRecipe& recipe : recipesOf(fovea, levels))
            all.insert({recipe.fovea.fieldDeg, recipe.fovea.samplesPerPixel, recipe.fovea.bounces,
                        recipe.fovea.isDenoised, recipe.framesPerFovea, recipe.isWarped});
    }
    EXPECT_EQ(foveaeOf(levels).size(), 3u * 3u * 3u * 2u);
    EXPECT_EQ(all.size(), 54u * 3u * 2u);
    EXPECT_EQ(foveaeOf({.fieldsDeg = {20.0}, .samplesPerPixel = {1, 2}, .bounces = {4}}).size(), 4u);
}

TEST(FrameRecipes, StandForAllAgesOfAFovea) {
    EXPECT_EQ(agesOf(1), (std::vector<int>{0}));
    EXPECT_EQ(agesOf(2), (std::vector<int>{0, 1}));
    EXPECT_EQ(agesOf(4), (std::vector<int>{0, 3}));
    EXPECT_EQ(agesOf(16), (std::vector<int>{0, 8, 15}));
    EXPECT_EQ(agesOf(FrameLevels{}), (std::vector<int>{0, 3, 8, 15}));
}

TEST(ModelRecipes, DifferFromTheUsualOneInOneThing) {
    hybrid::FirstModelOptions usual;
    usual.views = 12;
    usual.iterations = 600;
    const std::vector<ModelRecipe> recipes = modelRecipesOf(usual, {});
    ASSERT_EQ(recipes.size(), 7u) << "twelve views are the usual ones";
    EXPECT_EQ(recipes.front().varied, kNothingVaried);
    std::set<std::size_t> views;
    std::set<std::uint64_t> iterations;
    std::set<std::uint32_t> points;
    for (const ModelRecipe& recipe : recipes) {
        const hybrid::FirstModelOptions& options = recipe.options;
        views.insert(options.views);
        iterations.insert(options.iterations);
        points.insert(options.points.count);
        EXPECT_EQ(options.views != usual.views, recipe.varied == "views");
        EXPECT_EQ(options.iterations != usual.iterations, recipe.varied == "iterations");
        EXPECT_EQ(options.points.count != usual.points.count, recipe.varied == "splats");
        EXPECT_EQ(options.capacity != usual.capacity, recipe.varied == "splats");
        EXPECT_GE(options.capacity, options.points.count);
    }
    EXPECT_EQ(views, (std::set<std::size_t>{6, 12, 24}));
    EXPECT_EQ(iterations, (std::set<std::uint64_t>{200, 600, 1800}));
    EXPECT_EQ(points,
              (std::set<std::uint32_t>{usual.points.count / 2, usual.points.count, 2 * usual.points.count}));
    usual.iterations = 1;
    for (const ModelRecipe& recipe : modelRecipesOf(usual, {})) EXPECT_GE(recipe.options.iterations, 1u);
}

TEST(FrameTradeoff, AFramePaysItsShareOfTheFovea) {
    FramePoint point{.drawMs = 10.0};
    EXPECT_EQ(point.ms(), 10.0);
    point.foveaMs = 80.0;
    point.recipe = FrameRecipe{.framesPerFovea = 1};
    EXPECT_EQ(point.ms(), 90.0);
    point.recipe->framesPerFovea = 16;
    EXPECT_EQ(point.ms(), 15.0);
}

TEST(FrameTradeoff, MeansLeaveOutWhatHasNoPsnr) {
    const std::vector<FrameErrors> errors{{0.1, 0.2, 20.0}, {0.3, 0.6, std::nullopt}, {0.2, 0.4, 30.0}};
    const FrameErrors mean = meanOf(errors);
    EXPECT_NEAR(mean.flip, 0.2, 1e-12);
    EXPECT_NEAR(mean.fovealFlip, 0.4, 1e-12);
    EXPECT_EQ(mean.maskedPsnrDb, 25.0);
    EXPECT_FALSE(meanOf(std::vector<FrameErrors>{{0.1, 0.2, std::nullopt}}).maskedPsnrDb);
}

FramePoint frameOf(double fieldDeg, double foveaMs, double flip, double fovealFlip) {
    return {.recipe = FrameRecipe{.fovea = {.fieldDeg = fieldDeg}},
            .drawMs = 10.0,
            .foveaMs = foveaMs,
            .errors = {flip, fovealFlip, 20.0}};
}

// Splats alone; two fields, each with a picture that is worth its time; and one that is not.
FrameTradeoff someTradeoff() {
    FrameTradeoff tradeoff;
    tradeoff.frames = {{.drawMs = 10.0, .errors = {0.3, 0.3, 15.0}},
                       frameOf(20.0, 20.0, 0.25, 0.1),
                       frameOf(40.0, 80.0, 0.1, 0.1),
                       frameOf(20.0, 90.0, 0.24, 0.09)};
    const hybrid::FirstModelOptions usual;
    for (const ModelRecipe& recipe : modelRecipesOf(usual, {.views = {6}, .iterations = {}, .splats = {2.0}}))
        tradeoff.models.push_back({.recipe = recipe, .splats = 7, .drawMs = 10.0});
    const std::vector<std::pair<double, double>> secondsAndFlips{{20.0, 0.3}, {15.0, 0.35}, {30.0, 0.31}};
    for (std::size_t i = 0; i < secondsAndFlips.size(); ++i) {
        tradeoff.models[i].preparationSeconds = secondsAndFlips[i].first;
        tradeoff.models[i].errors.flip = secondsAndFlips[i].second;
    }
    markFronts(tradeoff);
    return tradeoff;
}

TEST(FrameTradeoff, HasAFrontByEachError) {
    const FrameTradeoff tradeoff = someTradeoff();
    std::vector<bool> whole;
    std::vector<bool> foveal;
    std::vector<bool> models;
    for (const FramePoint& frame : tradeoff.frames) {
        whole.push_back(frame.onFront);
        foveal.push_back(frame.onFovealFront);
    }
    for (const ModelPoint& model : tradeoff.models) models.push_back(model.onFront);
    EXPECT_EQ(whole, (std::vector<bool>{true, true, true, false}));
    EXPECT_EQ(foveal, (std::vector<bool>{true, true, false, true}));
    EXPECT_EQ(models, (std::vector<bool>{true, true, false}));
}

std::vector<std::string> keysOf(const nlohmann::ordered_json& json) {
    std::vector<std::string> keys;
    for (const auto& item : json.items()) keys.push_back(item.key());
    return keys;
}

TEST(FrameTradeoffReport, TellsOfEachPointHowItWasMade) {
    const FrameTradeoff tradeoff = someTradeoff();
    const auto frame = toJson(tradeoff.frames[1]);
    EXPECT_EQ(keysOf(frame), (std::vector<std::string>{"recipe", "ms", "drawMs", "foveaMs", "errors",
                                                       "onFront", "onFovealFront"}));
    EXPECT_EQ(keysOf(frame["recipe"]), (std::vector<std::string>{"fieldDeg", "samplesPerPixel", "bounces",
                                                                 "denoised", "framesPerFovea", "warped"}));
    EXPECT_EQ(frame["ms"], 30.0);
    EXPECT_EQ(frame["recipe"]["fieldDeg"], 20.0);
    EXPECT_EQ(frame["errors"]["fovealFlip"], 0.1);
    EXPECT_EQ(frame["onFront"], true);
    const auto splats = toJson(tradeoff.frames[0]);
    EXPECT_TRUE(splats["recipe"].is_null());
    EXPECT_TRUE(splats["foveaMs"].is_null());
    const auto model = toJson(tradeoff.models[1]);
    EXPECT_EQ(keysOf(model), (std::vector<std::string>{"recipe", "splats", "preparationSeconds", "drawMs",
                                                       "errors", "onFront"}));
    EXPECT_EQ(keysOf(model["recipe"]), (std::vector<std::string>{"varied", "views", "samplesPerPixel",
                                                                 "iterations", "points", "capacity"}));
    EXPECT_EQ(model["recipe"]["varied"], "views");
    EXPECT_EQ(model["recipe"]["views"], 6);
    EXPECT_TRUE(model["errors"]["maskedPsnrDb"].is_null());
}

TEST(FrameTradeoffReport, DrawsTheFrontOfEachFieldAndOfAll) {
    const std::vector<Plot> plots = plotsOf(someTradeoff());
    ASSERT_EQ(plots.size(), 3u);
    const auto curve = [&](std::size_t plot, std::string_view name) -> Curve {
        for (const Curve& found : plots[plot].curves) {
            if (found.name == name) return found;
        }
        ADD_FAILURE() << name;
        return {};
    };
    using Values = std::vector<double>;
    EXPECT_EQ(plots[0].curves.size(), 4u);
    EXPECT_EQ(curve(0, "splats alone").x, (Values{10.0}));
    EXPECT_EQ(curve(0, "fovea of 20 degrees").x, (Values{30.0, 100.0}));
    EXPECT_EQ(curve(0, "fovea of 40 degrees").y, (Values{0.1}));
    EXPECT_EQ(curve(0, "front").x, (Values{10.0, 30.0, 90.0}));
    EXPECT_TRUE(curve(0, "front").dashed);
    EXPECT_EQ(curve(1, "front").y, (Values{0.3, 0.1, 0.09}));
    EXPECT_EQ(plots[2].curves.size(), 3u);
    EXPECT_EQ(curve(2, "other views").x, (Values{15.0, 20.0}));
    EXPECT_EQ(curve(2, "other splats").x, (Values{20.0, 30.0}));
    EXPECT_EQ(curve(2, "front").y, (Values{0.35, 0.3}));
}

using Points = std::vector<CostAndError>;
using Front = std::vector<std::size_t>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ParetoFront, HasWhatNothingElseBeats) {
    // By cost: 3 is the cheapest, 0 costs more and is better, 4 is the best; 1 and 2 are beaten by 0.
    EXPECT_EQ(paretoFront(Points{{2, 0.5}, {3, 0.6}, {2.5, 0.5}, {1, 0.9}, {5, 0.1}}), (Front{3, 0, 4}));
    EXPECT_EQ(paretoFront(Points{{1, 3}, {2, 2}, {3, 1}}), (Front{0, 1, 2})) << "all of a trade";
    EXPECT_EQ(paretoFront(Points{{3, 3}, {2, 2}, {1, 1}}), (Front{2})) << "one beats all";
}

TEST(ParetoFront, OfNothingIsNothingAndOfOneThatOne) {
    EXPECT_TRUE(paretoFront({}).empty());
    EXPECT_EQ(paretoFront(Points{{7, 7}}), (Front{0}));
    EXPECT_EQ(paretoFront(Points{{0, -1}}), (Front{0}));
}

TEST(ParetoFront, OfTiesHasTheBetterAndOfEqualsTheFirst) {
    EXPECT_EQ(paretoFront(Points{{1, 2}, {1, 1}, {1, 3}}), (Front{1})) << "of equal cost";
    EXPECT_EQ(paretoFront(Points{{3, 1}, {1, 1}, {2, 1}}), (Front{1})) << "of equal error";
    EXPECT_EQ(paretoFront(Points{{2, 2}, {1, 3}, {1, 3}, {2, 2}}), (Front{1, 0})) << "of both";
}

TEST(ParetoFront, LeavesOutWhatIsNotFinite) {
    EXPECT_EQ(
        paretoFront(Points{
            {kNan, 0}, {0, kNan}, {1, 1}, {-kInfinity, 0}, {0, -kInfinity}, {kInfinity, 0}, {0, kInfinity}}),
        (Front{2}));
    EXPECT_TRUE(paretoFront(Points{{kNan, kNan}}).empty());
}

}  // namespace
}  // namespace macula::evaluate
