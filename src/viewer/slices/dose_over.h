// A radiotherapy dose over the picture of a slice: its scale, isodose lines and texts.
#pragma once

#include <QColor>
#include <QPainter>
#include <QPainterPath>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "scene/second/dose_lines.h"
#include "slices/sampled_slice.h"
#include "viewer/overlay/slice_overlay.h"

namespace macula::viewer {

struct DoseOver {
    std::optional<study::DoseReference> reference = {};  // what 100 percent are
    std::vector<scene::DoseLine> lines = {};             // from the highest; none: no lines

    bool operator==(const DoseOver&) const = default;
};

struct IsodosePath {
    QPainterPath path;  // in pixels of the frame
    QColor ink;
};

// Those that the slice has, in the order of `lines`. May throw std::bad_alloc.
std::vector<IsodosePath> isodosePaths(const slices::SampledSlice& dose,
                                      const std::vector<scene::DoseLine>& lines,
                                      const std::function<bool()>& cancelled);
// In the painter's logical pixels, `pixelRatio` pixels of the frame to each; antialiased, with a dark edge.
void paintIsodoses(QPainter& painter, const std::vector<IsodosePath>& paths, double pixelRatio);

// "60 Gy prescribed", "62.4 Gy, the highest dose", "50 Gy, as chosen".
QString referenceText(const study::DoseReference& reference, const QString& unit);
// "95 % · 57 Gy", or "57 Gy · 95 %"; without a reference only the dose.
QString levelText(const scene::DoseLine& line, bool isInPercent, const QString& unit);

// What the colours of the lines mean; empty without lines.
std::vector<LegendLine> legendOf(const DoseOver& over, const QString& unit);

// "44.31 Gy, 73.9 % of 60 Gy prescribed": interpolated between the points of the grid.
QString doseText(const DoseOver& over, const std::shared_ptr<const Volume>& dose, const glm::dvec3& mm);

}  // namespace macula::viewer
