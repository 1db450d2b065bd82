// What somebody points at in 3D, looked for while the window goes on.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "scene/drawing/first_matter.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// One at a time; a new one takes the place of the one before. Lives on the UI thread, and so do its signals.
class AnatomyPick : public QObject {
    Q_OBJECT

  public:
    explicit AnatomyPick(QObject* parent = nullptr);

    // See app::firstMatterMm. Nothing is told where there is nothing.
    void start(std::shared_ptr<const Volume> volume, app::Drawing drawing, const Camera& camera,
               const glm::dvec2& place, double aspectWidthOverHeight);
    void cancel() { job_.cancel(); }

  signals:
    void found(const glm::dvec3& mm);

  private:
    BackgroundJob<std::optional<glm::dvec3>> job_;
};

}  // namespace macula::viewer
