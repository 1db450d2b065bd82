// Finds what a new model begins with.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/frames.h"
#include "base/result.h"
#include "pipeline/hybrid/model/model_start.h"
#include "pipeline/trace/path_tracer.h"
#include "pipeline/trace/surface_points.h"

namespace macula::hybrid {

// Used by one thread at a time, the one that uses the device.
class ModelSearch {
  public:
    // Begins with the splats of another model instead of points. `isOfThis`: it was learnt from this matter
    // (ModelStart::isTaught), and not from matter that has moved since.
    void startWith(std::shared_ptr<const splat::Splats> splats, bool isOfThis = true) {
        startWith_ = std::move(splats);
        isOfThis_ = isOfThis;
    }
    void forget();
    void forgetStart();  // keeps only seenMm()

    // Finds the box of visible matter in the scene of `tracer`, then points on it, in slices: the next call
    // continues where `goesOn` said no. Leaves the tracer with another view.
    enum class Found { notYet, nothing, all };
    Result<Found> findSome(trace::PathTracer& tracer, const trace::SurfacePointOptions& options,
                           const std::function<bool()>& goesOn);

    // After Found::all.
    const Box& seenMm() const { return *seenMm_; }
    ModelStart start(const std::string& key) const;

  private:
    Result<void> findBox(trace::PathTracer& tracer);

    std::optional<Box> seenMm_;
    std::optional<trace::SurfacePoints> points_;
    std::shared_ptr<const splat::Splats> startWith_;
    bool isOfThis_ = false;  // startWith_
};

}  // namespace macula::hybrid
