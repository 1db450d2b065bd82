#include "pictures/view_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "live/device/open_device.h"
#include "pictures/drawn_picture.h"
#include "pictures/output_files.h"
#include "pictures/picture_file.h"
#include "pictures/view_request.h"

namespace macula::pictures {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "frame-";

Result<void> check(const ViewSequence& sequence) {
    if (sequence.frames < 1 || sequence.frames > kMostFrames)
        return Error{ErrorCode::usage, Text("A sequence cannot have that many pictures."),
                     std::to_string(sequence.frames), Text("Take 1 to {}.", kMostFrames)};
    if (sequence.path.stops.empty())
        return Error{
            ErrorCode::usage, Text("The way of the camera has no view."), {}, Text("Add one first.")};
    return {};
}

// Pictures of two sequences in one folder could not be told apart.
Result<void> prepareFolder(const fs::path& folder) {
    MACULA_TRY_VOID(makePictureFolder(folder));
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with(kPrefix) && entry->path().extension() == ".png")
            return Error{ErrorCode::usage, Text("The folder holds pictures of another sequence."),
                         folder.string(), Text("Choose an empty folder, or make a new one.")};
    }
    return {};
}

// Removes the written files again, unless keep() is called once all are complete.
class Files {
  public:
    explicit Files(const fs::path& folder) : folder_(folder) {
        std::error_code error;
        wasThere_ = fs::exists(folder, error);
    }
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;
    ~Files() {
        std::error_code ignored;
        for (const fs::path& file : written) fs::remove(file, ignored);
        if (!wasThere_) fs::remove(folder_, ignored);  // removed only if it is empty
    }
    std::vector<fs::path> keep() { return std::exchange(written, {}); }

    std::vector<fs::path> written;

  private:
    fs::path folder_;
    bool wasThere_ = true;
};

// Draws the pictures that are left, on a device that may replace a lost one.
struct Course {
    const ViewSequence& sequence;
    const PictureRequest& request;
    Progress& progress;
    Files& files;
    std::vector<Text>& sentences;

    Result<void> drawOn(const std::shared_ptr<gpu::Device>& device) {
        MACULA_TRY(PictureDrawer drawer, PictureDrawer::create(device, request, progress));
        Progress quiet({}, progress.token());  // the progress of each picture is not shown
        while (int(files.written.size()) < sequence.frames) {
            const int index = int(files.written.size());
            const Camera camera = cameraOf(sequence, index);
            MACULA_TRY(DrawnPicture drawn, drawer.draw(camera, quiet));
            MACULA_TRY_VOID(write(drawn, camera, index));
            progress.advance();
        }
        return {};
    }

  private:
    Result<void> write(DrawnPicture& drawn, const Camera& camera, int index) {
        if (sequence.stampsFor) {
            for (const Stamp& stamp : sequence.stampsFor(camera)) putOver(drawn.rgba, request.sizePx, stamp);
        }
        const fs::path file = sequence.folder / frameName(index, sequence.frames);
        MACULA_TRY_VOID(
            writePicture(file, drawn, request.sizePx, metadata(recordOf(sequence.picture, request, drawn))));
        files.written.push_back(file);
        for (Text& sentence : sentencesOf(drawn, request)) {
            if (std::ranges::find(sentences, sentence) == sentences.end())
                sentences.push_back(std::move(sentence));
        }
        return {};
    }
};

}  // namespace

Camera cameraOf(const ViewSequence& sequence, int index) {
    const int pieces = sequence.isClosed ? sequence.frames : sequence.frames - 1;
    const double share = pieces > 0 ? double(index) / pieces : 0.0;
    return scene::cameraAt(sequence.path, share * sequence.path.seconds());
}

std::string frameName(int index, int frames) {
    const std::size_t digits = std::max<std::size_t>(4, std::to_string(frames).size());
    return fmt::format("{}{:0{}}.png", kPrefix, index + 1, digits);
}

Result<WrittenSequence> writeViewSequence(const ViewSequence& sequence, const std::string& preferredDevice,
                                          Progress& progress) {
    MACULA_TRY_VOID(check(sequence));
    MACULA_TRY(const PictureRequest request, requestOf(sequence.picture, false));
    Files files(sequence.folder);
    MACULA_TRY_VOID(prepareFolder(sequence.folder));
    WrittenSequence result;
    MACULA_TRY(gpu::LastingDevice device, live::openDevice(preferredDevice, [&](const Text& sentence) {
                   result.sentences.push_back(sentence);
               }));
    progress.beginStage(Text("Drawing pictures"), std::size_t(sequence.frames));
    Course course{.sequence = sequence,
                  .request = request,
                  .progress = progress,
                  .files = files,
                  .sentences = result.sentences};
    MACULA_TRY_VOID(device.run([&](const std::shared_ptr<gpu::Device>& on) { return course.drawOn(on); }));
    result.files = files.keep();
    return result;
}

}  // namespace macula::pictures
