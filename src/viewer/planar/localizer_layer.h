// The lines of the slices of the open volume on its localizer.
#pragma once

#include <optional>
#include <vector>

#include "dicom/stack/instance.h"
#include "study/open/opened_study.h"
#include "study/planar/localizer_lines.h"
#include "viewer/planar/planar_layer.h"

namespace macula::viewer {

class LocalizerLayer : public PlanarLayer {
  public:
    // Nothing unless the frame lies in the frame of reference of the open volume, which slices lie across.
    // `crosshairMm` says which slice is looked at.
    void show(const dicom::Frame& frame, const study::OpenedStudy& open,
              const std::optional<glm::dvec3>& crosshairMm);
    void hide() { slices_.clear(); }
    bool isEmpty() const { return slices_.empty(); }

    void paint(QPainter& painter, const QTransform& paneFromPicture, const QRectF& area) override;

  private:
    std::vector<study::SliceOnLocalizer> slices_;
    std::optional<int> lookedAt_;
};

}  // namespace macula::viewer
