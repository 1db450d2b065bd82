// A double click in 3D moves the slices to the anatomy there, and makes the camera turn around it; or sets an
// end of a distance.
#pragma once

#include <QObject>
#include <glm/glm.hpp>
#include <optional>

#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QMenu;

namespace macula::viewer {

class DistanceIn3d;
class ScissorTool;

// Searches in the background, one place at a time; a new search replaces the one before. Lives on the UI
// thread.
class PickController : public QObject {
    Q_OBJECT

  public:
    // `scissors` outlives it, and takes clicks while the scissors are out.
    PickController(const WindowContext& context, const ScissorTool& scissors);

    void cancel() { pick_.cancel(); }
    void addAction(QMenu& edit);
    DistanceIn3d& distance() const { return *distance_; }

  private:
    void start(const glm::dvec2& place);
    void show(const glm::dvec3& mm);

    void measureTo(const glm::dvec3& mm);

    WindowContext context_;
    DistanceIn3d* distance_;
    BackgroundJob<std::optional<glm::dvec3>> pick_;
};

}  // namespace macula::viewer
