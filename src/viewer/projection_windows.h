// Which of the values projections show, from black to white.
#pragma once

#include <QPointF>
#include <QString>
#include <array>
#include <optional>

#include "base/volume.h"
#include "pipeline/trace/look.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::viewer {

// One window for each look, as the largest value along a ray and the mean have little to do with each other:
// the one set by hand; else the range of the preset, where somebody chose one; else that of the series.
class ProjectionWindows {
  public:
    DisplayWindow of(trace::Look look, const Volume& volume, const TransferFunction* chosen) const;

    // `from`, changed by a hand that moved by so much of the picture's height: wider to the right, brighter
    // up.
    void drag(trace::Look look, const DisplayWindow& from, QPointF byHeights);
    void forget(trace::Look look);  // what was set by hand
    void forgetAll() { byHand_ = {}; }

  private:
    std::array<std::optional<DisplayWindow>, trace::kLooks.size()> byHand_;
};

// Width and level, as radiologists have them: "W 400 L 40 HU".
QString windowText(const DisplayWindow& window, const std::string& unit);

}  // namespace macula::viewer
