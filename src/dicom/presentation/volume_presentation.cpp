#include "dicom/presentation/volume_presentation.h"

#include <fmt/format.h>

#include <span>

#include "base/sha256.h"

namespace macula::dicom {

namespace {

// Writes a line for each value, so that neighbours cannot run together; numbers as they will be read back.
class Digested {
  public:
    void add(std::string_view word) { text_ += fmt::format("{}:{}\n", word.size(), word); }
    void add(double number) { text_ += fmt::format("{}\n", number == 0.0 ? 0.0 : number); }
    void add(const glm::dvec3& v) {
        for (int axis = 0; axis < 3; ++axis) add(v[axis]);
    }
    void add(const std::vector<std::uint16_t>& words) { add(sha256Hex(std::as_bytes(std::span(words)))); }
    void add(const Palette& palette) {
        add(palette.values.low);
        add(palette.values.high);
        for (const auto* table : {&palette.red, &palette.green, &palette.blue, &palette.alpha}) add(*table);
    }
    void add(const Cropping& cropping) {
        for (const Box& box : cropping.boxes) {
            add("box");
            add(box.low);
            add(box.high);
        }
        for (const CroppingPlane& plane : cropping.planes) {
            add("plane");
            add(plane.outward);
            add(plane.offsetMm);
        }
    }
    void add(const PresentedView& view) {
        add(view.projection == Projection::perspective ? "perspective" : "orthographic");
        add(view.positionMm);
        add(view.lookAtMm);
        add(view.up);
        const FieldOfView& f = view.field;
        for (const double mm : {f.leftMm, f.rightMm, f.topMm, f.bottomMm, f.nearMm, f.farMm}) add(mm);
    }
    void add(const PresentedShading& shading) {
        add(shading.isDoubleSided ? "both sides" : "one side");
        for (const double part : {shading.ambient, shading.diffuse, shading.specular}) add(part);
        add(shading.shininess.value_or(-1.0));
        add(shading.lightDirection);
    }
    std::string hex() const { return sha256Hex(text_); }

  private:
    std::string text_;
};

}  // namespace

bool Cropping::operator==(const Cropping& b) const {
    if (planes != b.planes || boxes.size() != b.boxes.size()) return false;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].low != b.boxes[i].low || boxes[i].high != b.boxes[i].high) return false;
    }
    return true;
}

std::string digestOf(const VolumePresentation& presentation) {
    Digested all;
    all.add(presentation.series.seriesInstanceUid);
    all.add(presentation.series.frameOfReferenceUid);
    for (const ReferencedImage& image : presentation.series.images) {
        all.add(image.sopClassUid);
        all.add(image.sopInstanceUid);
        for (const int frame : image.frames) all.add(double(frame));
    }
    all.add(double(presentation.method));
    all.add(presentation.palette);
    all.add(presentation.samplingStepMm.value_or(-1.0));
    all.add(presentation.cropping);
    all.add(presentation.view);
    if (presentation.shading) all.add(*presentation.shading);
    return all.hex();
}

}  // namespace macula::dicom
