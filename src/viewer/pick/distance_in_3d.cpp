#include "viewer/pick/distance_in_3d.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/camera/picture_rays.h"

namespace macula::viewer {

namespace {

constexpr double kDotsEveryPx = 7.0;  // logical
constexpr std::size_t kMostDots = 60;
constexpr std::size_t kMostLines = 6;  // the latest: the picture holds kMostToolMarks

// The normal of a plane that holds the line and is as level as such a plane can be: slices turned into it
// show all of the line.
glm::dvec3 normalBeside(const glm::dvec3& line) {
    const glm::dvec3 along = glm::normalize(line);
    const glm::dvec3 up = std::abs(along.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::normalize(up - glm::dot(up, along) * along);
}

void addLine(std::vector<ToolMark>& marks, const glm::dvec2& from, const glm::dvec2& to,
             const glm::dvec2& sizePx) {
    const double lengthPx = glm::length(0.5 * (to - from) * sizePx);
    if (!std::isfinite(lengthPx)) return;
    const auto dots = std::size_t(std::clamp(lengthPx / kDotsEveryPx, 1.0, double(kMostDots)));
    for (std::size_t i = 1; i < dots; ++i)
        marks.push_back({.kind = MarkKind::drawnDot, .place = glm::mix(from, to, double(i) / double(dots))});
}

}  // namespace

DistanceIn3d::DistanceIn3d(StudyEditor& session, QObject* parent) : QObject(parent), session_(session) {
    connect(&session_, &StudyEditor::studyShown, this, [this] {
        beginMm_.reset();
        if (isOut_) Q_EMIT drawn();
    });
    connect(&session_, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        if (isOut_ && before.measurements != session_.state().measurements) Q_EMIT drawn();
    });
}

void DistanceIn3d::setOut(bool out) {
    if (std::exchange(isOut_, out) == out) return;
    beginMm_.reset();
    Q_EMIT drawn();
}

std::optional<slices::Measurement> DistanceIn3d::add(const glm::dvec3& mm) {
    if (!beginMm_) {
        beginMm_ = mm;
        Q_EMIT drawn();
        return std::nullopt;
    }
    const slices::Distance distance{{*beginMm_, mm}};
    if (!(slices::lengthMm(distance) > 0.0)) return std::nullopt;
    beginMm_.reset();
    const slices::Measurement measurement{.shape = distance,
                                          .normal = normalBeside(distance.endsMm[1] - distance.endsMm[0])};
    session_.change(tr("Measurement"),
                    [&](scene::StudyState& next) { next.measurements.push_back(measurement); });
    return measurement;
}

std::vector<ToolMark> DistanceIn3d::marks(const PictureGeometry& picture) const {
    const auto rays = scene::PictureRays::of(picture.camera, picture.aspect);
    if (!isOut_ || !session_.hasStudy() || !rays) return {};
    std::vector<ToolMark> marks;
    std::size_t lines = 0;
    const auto& measurements = session_.state().measurements;
    for (auto at = measurements.rbegin(); at != measurements.rend() && lines < kMostLines; ++at) {
        const auto* distance = std::get_if<slices::Distance>(&at->shape);
        if (distance == nullptr) continue;
        const auto from = rays->placeOf(distance->endsMm[0]);
        const auto to = rays->placeOf(distance->endsMm[1]);
        if (!from || !to) continue;
        ++lines;
        addLine(marks, *from, *to, picture.sizePx);
        for (const glm::dvec2& end : {*from, *to})
            marks.push_back({.kind = MarkKind::freeHandle, .place = end});
    }
    if (beginMm_)
        if (const auto place = rays->placeOf(*beginMm_))
            marks.push_back({.kind = MarkKind::heldHandle, .place = *place});
    return marks;
}

}  // namespace macula::viewer
