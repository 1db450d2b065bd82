// Curved planes in the window: the panel, and the way of a vessel.
#pragma once

#include <QObject>
#include <glm/glm.hpp>
#include <vector>

#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

class CurvePanel;

// Lives on the UI thread.
class CurveController : public QObject {
    Q_OBJECT

  public:
    explicit CurveController(const WindowContext& context);

    CurvePanel& panel() const { return *panel_; }

  private:
    void follow();
    void use(const Result<std::vector<glm::dvec3>>& wayMm);

    WindowContext context_;
    CurvePanel* panel_;
    BackgroundJob<std::vector<glm::dvec3>> following_;
};

}  // namespace macula::viewer
