// A picture that is drawn whole, without a window.
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

namespace macula::app {

// What the device has made of a request, brought to the host: a lost device takes nothing of it along.
struct DrawnPicture {
    std::string device;
    Camera camera;  // the one that was asked for, or found
    double seconds = 0.0;
    double exposure = 1.0;  // that of the request, or what was metered
    double focusMm = 0.0;   // of the lens, from `camera`: asked for, or found; 0 without one
    trace::Statistics statistics;
    // One of both, row 0 on top: display-encoded over the background of the request, or with coverage as
    // alpha and straight colours where it is transparent, 4 bytes a pixel; or linear.
    std::vector<std::uint8_t> rgba;
    std::optional<trace::TracedImage> traced;
};

Error stopped();  // what a picture ends with that was cancelled

// Several pictures of one request, of which only the camera differs: the scene is brought to the device once.
// Each is as if it were drawn alone.
class PictureDrawer {
  public:
    // Fails as trace::PathTracer, and with `cancelled`.
    static Result<PictureDrawer> create(const std::shared_ptr<gpu::Device>& device,
                                        const PictureRequest& request, const Progress& progress);
    // Makes `kept` one for that device and request: what it has of the scene on the device stays there, only
    // the rest is brought to it. Nothing is kept where it fails, as create does.
    static Result<void> adapt(std::optional<PictureDrawer>& kept, const std::shared_ptr<gpu::Device>& device,
                              const PictureRequest& request, const Progress& progress);
    // As drawPicture; nothing: a camera that what can be seen fills.
    Result<DrawnPicture> draw(const std::optional<Camera>& camera, Progress& progress);
    // The exposure that PictureRequest::metersExposure means, of that camera; 1 where nothing is seen. Grey
    // cut faces do not count: no exposure changes them.
    Result<double> meterExposure(const Camera& camera, const Progress& progress);

  private:
    // As the effects say, for a picture by `standing`, which may stand farther back than was `asked` for.
    Result<trace::Lens> lensFor(const Camera& asked, const Camera& standing);
    // What is drawn, as the request wants it; with fog where there are distances of what each pixel shows.
    Result<void> read(DrawnPicture& drawn, const std::vector<float>& distancesMm);
    PictureDrawer(std::shared_ptr<gpu::Device> device, PictureRequest request, trace::PathTracer tracer)
        : device_(std::move(device)), request_(std::move(request)), tracer_(std::move(tracer)) {}
    Result<double> meter(const Camera& camera, const Progress& progress);  // of the clip that is set
    // Of the same volume, with the same room for it.
    Result<void> change(const PictureRequest& request, const Progress& progress);

    std::shared_ptr<gpu::Device> device_;
    PictureRequest request_;
    trace::PathTracer tracer_;
};

// Fails as trace::PathTracer; with `cancelled` when it is stopped, unless what is unfinished is kept and
// there is some of it.
Result<DrawnPicture> drawPicture(const std::shared_ptr<gpu::Device>& device, const PictureRequest& request,
                                 Progress& progress);

// Whether nothing is seen in a picture of the request: all of it is the background, or clear.
bool isEmpty(const DrawnPicture& picture, const PictureRequest& request);

// What a person has to know of a picture, without patient data.
struct PictureNote {
    std::string sentence;
    std::string action = {};  // what to do about it; may be empty
    bool isWarning = false;   // look before you rely on it
};
std::vector<PictureNote> notesOf(const DrawnPicture& picture, const PictureRequest& request);

}  // namespace macula::app
