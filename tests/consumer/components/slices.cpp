// The marker is at the left of the patient, which is the right of an axial picture.
#include <base/phantom.h>
#include <slices/sampled_slice.h>
#include <slices/slice_plane.h>

#include "ends.h"

int main() {
    using namespace macula::slices;
    const macula::Volume volume = macula::phantom::make({.size = {64, 56, 40}, .spacingMm = {4.8, 4.8, 7.5}});
    const glm::dvec3 marker = macula::phantom::markerCentreMm();
    SliceFrame frame;
    frame.plane = planeOf(Orientation::axial, {0.0, 0.0, marker.z});
    frame.sizePx = {128, 128};
    frame.mmPerPixel = fittedMmPerPixel(volume, frame.plane, frame.sizePx);
    const SampledSlice slice = sampleSlice(volume, frame, {}, Filter::linear);
    const glm::dvec2 px = frame.pictureFromWorld(marker);
    const float value = slice.values.at(std::size_t(px.y) * 128 + std::size_t(px.x));
    return expect(px.x > 64.0 && value > 500.0f, "the marker is where it belongs");
}
