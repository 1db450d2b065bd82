#include "live/quality/quality_front.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "pipeline/volume/json_reader.h"
#include "scene/choice/built_in_choice.h"

namespace macula::live {

namespace {

constexpr double kLongestMs = 1e6;
constexpr double kLeastBetweenFramesMs = 1.0;
constexpr double kEnoughTime = 1e12;  // budget / time per sample that never makes a fovea smaller

double whole(const JsonNode& node, double low, double high) {
    const double number = node.number({low, high});
    if (number != std::floor(number)) node.fail(Text("a whole number"));
    return number;
}

FrontPoint pointFrom(const JsonNode& node) {
    node.allowOnly({"fovea", "ms", "flip", "fovealFlip"});
    FrontPoint point;
    if (const auto fovea = node.find("fovea")) {
        fovea->allowOnly({"fieldDeg", "samplesPerPixel", "denoise", "framesPerFovea"});
        FrontPoint::Fovea is;
        is.request.fieldDeg = (*fovea)["fieldDeg"].number({1.0, 120.0});
        is.request.samplesPerPixel = static_cast<std::uint32_t>(whole((*fovea)["samplesPerPixel"], 1, 1024));
        is.request.denoising = (*fovea)["denoise"].boolean() ? trace::Denoising::on : trace::Denoising::off;
        is.framesPerFovea = static_cast<int>(whole((*fovea)["framesPerFovea"], 1, 1000));
        point.fovea = is;
    }
    point.ms = node["ms"].number({1e-3, kLongestMs});
    point.flip = node["flip"].number({0.0, 1.0});
    point.fovealFlip = node["fovealFlip"].number({0.0, 1.0});
    return point;
}

std::vector<FrontPoint> stopsOf(std::vector<FrontPoint> points) {
    std::ranges::stable_sort(points, [](const FrontPoint& a, const FrontPoint& b) {
        return a.ms != b.ms ? a.ms < b.ms : a.fovealFlip < b.fovealFlip;
    });
    std::vector<FrontPoint> stops;
    for (const FrontPoint& point : points) {
        if (stops.empty() || point.fovealFlip < stops.back().fovealFlip) stops.push_back(point);
    }
    return stops;
}

double drawMs(const QualityFront& front, double pixels) {
    const auto& drawn = front.drawing;
    auto after = std::ranges::find_if(drawn, [&](const auto& d) { return d.pixels > pixels; });
    after = std::clamp(after, drawn.begin() + 1, drawn.end() - 1);  // beyond an end: its slope goes on
    const auto& a = *std::prev(after);
    const double slope = (after->ms - a.ms) / (after->pixels - a.pixels);
    return std::max(a.ms + slope * (pixels - a.pixels), 0.1 * drawn.front().ms);
}

double foveaPixels(const WindowView& view, const hybrid::FoveaOptions& request) {
    const trace::View whole{.camera = {.verticalFovDeg = view.verticalFovDeg},
                            .width = std::max(view.sizePx.x, 1),
                            .height = std::max(view.sizePx.y, 1)};
    const double side = hybrid::affordableFovea(whole, glm::dvec2(0.0), 1.0, kEnoughTime, request).sidePx;
    return side * side;
}

}  // namespace

Result<QualityFront> qualityFrontFromJson(std::string_view text, const std::string& where) {
    const JsonDocument document(text, where);
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    root.allowOnly({"version", "name", "title", "source", "sizePx", "verticalFovDeg", "bounces",
                    "calibrationMs", "drawing", "points"});
    if (root["version"].number() != 1.0)
        root["version"].fail(Text("version 1; newer ones need a newer Macula"));
    QualityFront front;
    front.title = root["title"].text();
    front.source = root["source"].text();
    const std::vector<double> size = root["sizePx"].numbers(2, {1.0, trace::kMaxPictureSide});
    front.sizePx = {int(size[0]), int(size[1])};
    front.verticalFovDeg = root["verticalFovDeg"].number({1.0, 170.0});
    front.bounces = static_cast<int>(whole(root["bounces"], 1, trace::kMaxBounces));
    front.calibrationMs = root["calibrationMs"].number({1e-3, kLongestMs});
    for (const JsonNode& node : root["drawing"].items(2, 100)) {
        node.allowOnly({"pixels", "ms"});
        const QualityFront::Drawn drawn{.pixels = whole(node["pixels"], 1, 1e9),
                                        .ms = node["ms"].number({1e-3, kLongestMs})};
        if (!front.drawing.empty() && !(drawn.pixels > front.drawing.back().pixels))
            node["pixels"].fail(Text("more pixels than those before"));
        front.drawing.push_back(drawn);
    }
    for (const JsonNode& node : root["points"].items(2, 1000)) front.points.push_back(pointFrom(node));
    MACULA_TRY_VOID(document.status());
    front.stops = stopsOf(front.points);
    if (front.stops.size() < 2) root["points"].fail(Text("a slower point with less error"));
    MACULA_TRY_VOID(document.status());
    return front;
}

Result<QualityFront> builtInQualityFront() {
    const presets::EmbeddedFile* file = scene::findBuiltIn(presets::frontFiles(), "live-frame");
    MACULA_CHECK(file != nullptr);
    return qualityFrontFromJson(file->text, std::string(file->name));
}

FrameCost costOf(const QualityFront& front, const FrontPoint& stop, const WindowView& view, double slowness) {
    FrameCost cost{.drawMs = slowness * drawMs(front, double(view.sizePx.x) * view.sizePx.y)};
    if (!stop.fovea) return cost;
    const WindowView measured{.sizePx = front.sizePx, .verticalFovDeg = front.verticalFovDeg};
    const double measuredMs =
        std::max(stop.ms - drawMs(front, double(front.sizePx.x) * front.sizePx.y), 0.0) *
        stop.fovea->framesPerFovea;
    cost.foveaMs = slowness * measuredMs * foveaPixels(view, stop.fovea->request) /
                   foveaPixels(measured, stop.fovea->request);
    cost.betweenMs =
        std::clamp(cost.foveaMs / stop.fovea->framesPerFovea, kLeastBetweenFramesMs, kMostBetweenFramesMs);
    return cost;
}

LiveQuality liveQualityOf(const FrontPoint& stop, const FrameCost& cost) {
    LiveQuality quality{.hasFovea = stop.fovea.has_value()};
    if (!stop.fovea) return quality;
    quality.fovea = stop.fovea->request;
    quality.betweenFramesMs = cost.betweenMs;
    // A fovea that takes longer gets smaller. At least the usual budget, which a fast machine never needs.
    quality.foveaMs = std::max(hybrid::kFoveaBudgetMs, cost.betweenMs * stop.fovea->framesPerFovea);
    return quality;
}

std::size_t stopOf(const QualityFront& front, const WindowView& view, double slowness, double ms) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < front.stops.size(); ++i) {
        if (costOf(front, front.stops[i], view, slowness).ms() <= ms) found = i;
    }
    return found;
}

}  // namespace macula::live
