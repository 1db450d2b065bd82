// Paints the graphics and texts of a presentation state over an image (PS3.3 C.10.5).
#pragma once

#include <vector>

#include "dicom/presentation/softcopy_annotations.h"
#include "viewer/planar/planar_layer.h"

namespace macula::viewer {

// A circle in pixels of the image is as round as these are.
class AnnotationLayer : public PlanarLayer {
  public:
    void show(std::vector<dicom::SoftcopyAnnotation> annotations) { annotations_ = std::move(annotations); }
    bool isEmpty() const { return annotations_.empty(); }

    void paint(QPainter& painter, const QTransform& paneFromPicture, const QRectF& area) override;

  private:
    std::vector<dicom::SoftcopyAnnotation> annotations_;  // from below to above
};

}  // namespace macula::viewer
