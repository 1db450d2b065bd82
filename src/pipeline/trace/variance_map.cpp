#include "pipeline/trace/variance_map.h"

#include <cstdint>

#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "shaders/trace.h"
#include "shared/trace_params.h"

namespace macula::trace {

Result<const gpu::Buffer*> VarianceMap::of(const Film& film) {
    const std::uint64_t bytes = std::uint64_t(film.width()) * std::uint64_t(film.height()) * sizeof(float);
    if (!variances_ || variances_->bytes() < bytes) {
        variances_.reset();
        MACULA_TRY(variances_, gpu::Buffer::create(device_, {.label = "variances of light", .bytes = bytes}));
    }
    // Cheap: the device caches compiled kernels.
    MACULA_TRY(const gpu::Kernel kernel, gpu::Kernel::create(device_, shaders::trace_variance_comp));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "variances"));
    recorder.dispatch(kernel,
                      {static_cast<std::uint32_t>(film.width()), static_cast<std::uint32_t>(film.height())},
                      shared::VariancePush{.imageSize = {film.width(), film.height()}},
                      {film.sums(), film.counts(), film.squares(), *variances_});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return &*variances_;
}

}  // namespace macula::trace
