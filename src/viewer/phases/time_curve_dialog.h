// Shows how values change over the phases of a study.
#pragma once

#include <QDialog>

#include "scene/slices/time_curve.h"
#include "viewer/context/window_context.h"

namespace macula::viewer {

// Deletes itself when it is closed.
class TimeCurveDialog : public QDialog {
    Q_OBJECT

  public:
    TimeCurveDialog(const scene::TimeCurves& curves, const WindowContext& context);

  private:
    void save(const std::string& csv);

    WindowContext context_;
};

}  // namespace macula::viewer
