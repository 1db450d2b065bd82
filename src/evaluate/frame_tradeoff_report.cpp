#include "evaluate/frame_tradeoff.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

namespace macula::evaluate {

namespace {

using Json = nlohmann::ordered_json;

Json toJson(const FrameErrors& errors) {
    return {{"flip", errors.flip},
            {"fovealFlip", errors.fovealFlip},
            {"maskedPsnrDb", orNull(errors.maskedPsnrDb)}};
}

Json toJson(const FrameRecipe& recipe) {
    return {{"fieldDeg", recipe.fovea.fieldDeg},       {"samplesPerPixel", recipe.fovea.samplesPerPixel},
            {"bounces", recipe.fovea.bounces},         {"denoised", recipe.fovea.isDenoised},
            {"framesPerFovea", recipe.framesPerFovea}, {"warped", recipe.isWarped}};
}

Json toJson(const ModelRecipe& recipe) {
    return {{"varied", recipe.varied},
            {"views", recipe.options.views},
            {"samplesPerPixel", recipe.options.samplesPerPixel},
            {"iterations", recipe.options.iterations},
            {"points", recipe.options.points.count},
            {"capacity", recipe.options.capacity}};
}

Curve curveOf(std::string name, const std::vector<CostAndError>& points) {
    Curve curve{.name = std::move(name), .x = {}, .y = {}};
    for (const CostAndError& point : points) {
        curve.x.push_back(point.cost);
        curve.y.push_back(point.error);
    }
    return curve;
}

// Draws only the Pareto front of the points: a line through all of them would run back and forth.
Curve frontOf(std::string name, const std::vector<CostAndError>& points) {
    std::vector<CostAndError> front;
    for (const std::size_t i : paretoFront(points)) front.push_back(points[i]);
    return curveOf(std::move(name), front);
}

// Called last, so that the front is drawn over the other curves.
void addFront(Plot& plot, const std::vector<CostAndError>& points) {
    plot.curves.push_back(frontOf("front", points));
    plot.curves.back().dashed = true;
}

Plot framesPlot(const FrameTradeoff& tradeoff, double FrameErrors::*error, std::string title) {
    Plot plot{.title = std::move(title),
              .xTitle = "ms for a frame",
              .yTitle = "FLIP to the traced picture",
              .logarithmicX = true,
              .curves = {}};
    std::set<double> fieldsDeg;
    for (const FramePoint& frame : tradeoff.frames) {
        if (frame.recipe) fieldsDeg.insert(frame.recipe->fovea.fieldDeg);
    }
    const auto those = [&](const auto& belongs) {
        std::vector<FramePoint> frames;
        std::copy_if(tradeoff.frames.begin(), tradeoff.frames.end(), std::back_inserter(frames), belongs);
        return costsOf(frames, error);
    };
    plot.curves.push_back(
        curveOf("splats alone", those([](const FramePoint& frame) { return !frame.recipe; })));
    for (const double fieldDeg : fieldsDeg) {
        plot.curves.push_back(
            frontOf(fmt::format("fovea of {:g} degrees", fieldDeg), those([&](const FramePoint& frame) {
                        return frame.recipe && frame.recipe->fovea.fieldDeg == fieldDeg;
                    })));
    }
    addFront(plot, costsOf(tradeoff.frames, error));
    return plot;
}

Plot modelsPlot(const FrameTradeoff& tradeoff) {
    Plot plot{.title = "Models: error against preparation",
              .xTitle = "s for points, views and training",
              .yTitle = "FLIP to the traced picture",
              .curves = {}};
    std::set<std::string_view> varied;
    for (const ModelPoint& model : tradeoff.models) varied.insert(model.recipe.varied);
    varied.erase(kNothingVaried);
    for (const std::string_view name : varied) {
        std::vector<ModelPoint> models;
        std::copy_if(tradeoff.models.begin(), tradeoff.models.end(), std::back_inserter(models),
                     [&](const ModelPoint& model) {
                         return model.recipe.varied == name || model.recipe.varied == kNothingVaried;
                     });
        std::vector<CostAndError> points = costsOf(models);
        std::sort(points.begin(), points.end(),
                  [](const CostAndError& a, const CostAndError& b) { return a.cost < b.cost; });
        plot.curves.push_back(curveOf(fmt::format("other {}", name), points));
    }
    addFront(plot, costsOf(tradeoff.models));
    return plot;
}

}  // namespace

Json toJson(const ModelPoint& point) {
    return {{"recipe", toJson(point.recipe)},
            {"splats", point.splats},
            {"preparationSeconds", point.preparationSeconds},
            {"drawMs", point.drawMs},
            {"errors", toJson(point.errors)},
            {"onFront", point.onFront}};
}

Json toJson(const FramePoint& point) {
    return {{"recipe", point.recipe ? toJson(*point.recipe) : Json()},
            {"ms", point.ms()},
            {"drawMs", point.drawMs},
            {"foveaMs", point.recipe ? Json(point.foveaMs) : Json()},
            {"errors", toJson(point.errors)},
            {"onFront", point.onFront},
            {"onFovealFront", point.onFovealFront}};
}

Json reportOf(const BenchStudy& study, const FrameTradeoffOptions& options, const FrameTradeoff& result) {
    Json json = describe("tradeoff", study);
    json["picture"] = {options.sizePx.x, options.sizePx.y};
    json["verticalFovDeg"] = options.verticalFovDeg;
    json["foveaFieldDeg"] = trace::kFovealFieldDeg;
    json["degreesPerFrame"] = options.degreesPerFrame;
    json["truthSamplesPerPixel"] = options.truthSamples;
    json["truthBounces"] = options.truthBounces;
    json["modelBounces"] = options.model.bounces;
    json["models"] = Json::array();
    for (const ModelPoint& point : result.models) json["models"].push_back(toJson(point));
    json["frames"] = Json::array();
    for (const FramePoint& point : result.frames) json["frames"].push_back(toJson(point));
    return json;
}

std::vector<Plot> plotsOf(const FrameTradeoff& tradeoff) {
    return {framesPlot(tradeoff, &FrameErrors::flip, "Whole frames: error against time"),
            framesPlot(tradeoff, &FrameErrors::fovealFlip, "Where the eye looks: error against time"),
            modelsPlot(tradeoff)};
}

}  // namespace macula::evaluate
