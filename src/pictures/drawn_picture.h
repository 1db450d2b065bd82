// Draws whole pictures without a window.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pictures/picture_request.h"

namespace macula::pictures {

// A finished picture in host memory: the loss of its device does not affect it.
struct DrawnPicture {
    std::string device;
    Camera camera;  // as requested or fitted; a parallel one moved by standingBefore
    double seconds = 0.0;
    double exposure = 1.0;  // as requested, or metered
    double focusMm = 0.0;   // focus distance from `camera`, as requested or found; 0 without a lens
    trace::Statistics statistics;
    // Row 0 on top. Either `rgba`, display-encoded over the background, or straight colours with coverage as
    // alpha for a transparent request, 4 bytes a pixel; or `traced`, linear.
    std::vector<std::uint8_t> rgba;
    std::optional<trace::TracedImage> traced;
};

Error stopped();  // the error of a cancelled picture

// Draws several pictures that differ only in the camera, and uploads the scene once. Each picture is the same
// as if it were drawn alone.
class PictureDrawer {
  public:
    // Fails as trace::PathTracer, and with `cancelled`.
    static Result<PictureDrawer> create(const std::shared_ptr<gpu::Device>& device,
                                        const PictureRequest& request, const Progress& progress);
    // Changes `kept` to that device and request, and uploads only the parts of the scene that differ. Resets
    // `kept` if it fails, as create does.
    static Result<void> adapt(std::optional<PictureDrawer>& kept, const std::shared_ptr<gpu::Device>& device,
                              const PictureRequest& request, const Progress& progress);
    // As drawPicture. Without a camera, fits one to what is visible (fittedCamera).
    Result<DrawnPicture> draw(const std::optional<Camera>& camera, Progress& progress);
    // Measures the exposure for PictureRequest::metersExposure with that camera; 1 if nothing is visible.
    // Ignores grey cut faces, because exposure does not change them.
    Result<double> meterExposure(const Camera& camera, const Progress& progress);

  private:
    // The lens of the effects. `standing` is `asked`, moved back if it is parallel.
    Result<trace::Lens> lensFor(const Camera& asked, const Camera& standing);
    // Reads the picture back as requested; adds fog if `distancesMm`, one per pixel, is not empty.
    Result<void> read(DrawnPicture& drawn, const std::vector<float>& distancesMm);
    PictureDrawer(std::shared_ptr<gpu::Device> device, PictureRequest request, trace::PathTracer tracer)
        : device_(std::move(device)), request_(std::move(request)), tracer_(std::move(tracer)) {}
    Result<double> meter(const Camera& camera, const Progress& progress);  // with the clip of the tracer
    // Changes to a request with the same volume and memory limits.
    Result<void> change(const PictureRequest& request, const Progress& progress);

    std::shared_ptr<gpu::Device> device_;
    PictureRequest request_;
    trace::PathTracer tracer_;
};

// Fails as trace::PathTracer, and with `cancelled` when it is stopped, unless keepUnfinished applies and
// there is at least one sample.
Result<DrawnPicture> drawPicture(const std::shared_ptr<gpu::Device>& device, const PictureRequest& request,
                                 Progress& progress);

// Whether the picture shows nothing: every pixel is the background, or transparent.
bool isEmpty(const DrawnPicture& picture, const PictureRequest& request);

// A note to the user about a picture, without patient data.
struct PictureNote {
    Text sentence;
    Text action = {};        // the advised action; may be empty
    bool isWarning = false;  // the user must check it before relying on the picture
};
std::vector<PictureNote> notesOf(const DrawnPicture& picture, const PictureRequest& request);

}  // namespace macula::pictures
