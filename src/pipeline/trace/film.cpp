#include "pipeline/trace/film.h"

#include <glm/glm.hpp>

#include "pipeline/gpu/transfer.h"

namespace macula::trace {

Film::Film(int width, int height, gpu::Buffer sums, gpu::Buffer lost, gpu::Buffer counts, gpu::Buffer faults,
           gpu::Buffer squares, gpu::Image picture)
    : width_(width),
      height_(height),
      sums_(std::move(sums)),
      lost_(std::move(lost)),
      counts_(std::move(counts)),
      faults_(std::move(faults)),
      squares_(std::move(squares)),
      picture_(std::move(picture)) {}

Result<Film> Film::create(const std::shared_ptr<gpu::Device>& device, int width, int height) {
    const std::uint64_t pixels = std::uint64_t(width) * std::uint64_t(height);
    const auto make = [&](const char* label, std::uint64_t bytes) {
        return gpu::Buffer::create(device, {.label = label, .bytes = bytes});
    };
    MACULA_TRY(gpu::Buffer sums, make("sums", pixels * sizeof(glm::vec4)));
    MACULA_TRY(gpu::Buffer lost, make("lost", pixels * sizeof(glm::vec4)));
    MACULA_TRY(gpu::Buffer counts, make("counts", pixels * sizeof(std::uint32_t)));
    MACULA_TRY(gpu::Buffer faults, make("faults", sizeof(Faults)));
    MACULA_TRY(gpu::Buffer squares, make("squares", pixels * sizeof(glm::vec2)));
    MACULA_TRY(gpu::Image picture, gpu::Image::create(device, {.label = "picture",
                                                               .width = static_cast<std::uint32_t>(width),
                                                               .height = static_cast<std::uint32_t>(height),
                                                               .format = VK_FORMAT_R8G8B8A8_UNORM}));
    return Film(width, height, std::move(sums), std::move(lost), std::move(counts), std::move(faults),
                std::move(squares), std::move(picture));
}

void Film::clear(gpu::Recorder& recorder) const {
    for (const gpu::Buffer* buffer : {&sums_, &lost_, &counts_, &faults_, &squares_})
        recorder.fill(*buffer, 0);
}

void Film::appendTo(std::vector<gpu::Binding>& bindings) const {
    for (const gpu::Buffer* buffer : {&sums_, &lost_, &counts_, &faults_, &squares_})
        bindings.emplace_back(*buffer);
}

Result<Film::Faults> Film::faults() const {
    MACULA_TRY(const auto seen, gpu::read<Faults>(faults_));
    return seen.front();
}

}  // namespace macula::trace
