// Finds in the background the anatomy at a place in the 3D picture.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "scene/drawing/first_matter.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// One search at a time; a new one replaces the one before. Lives on the UI thread, and so do its signals.
class AnatomyPick : public QObject {
    Q_OBJECT

  public:
    explicit AnatomyPick(QObject* parent = nullptr);

    // See scene::firstMatterMm. Emits nothing if there is no matter.
    void start(std::shared_ptr<const Volume> volume, scene::Drawing drawing, const Camera& camera,
               const glm::dvec2& place, double aspectWidthOverHeight);
    void cancel() { job_.cancel(); }

  Q_SIGNALS:
    void found(const glm::dvec3& mm);

  private:
    BackgroundJob<std::optional<glm::dvec3>> job_;
};

}  // namespace macula::viewer
