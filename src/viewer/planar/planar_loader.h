// Decodes the images of a series in the background, and keeps those that fit.
#pragma once

#include <QObject>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "dicom/planar/planar_frame.h"
#include "dicom/planar/planar_header.h"
#include "study/planar/planar_images.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

struct LoadedImage {
    std::size_t place = 0;  // in Stack::frames
    std::shared_ptr<const dicom::PlanarHeader> header;
    std::shared_ptr<const dicom::PlanarFrame> pixels;
};

// One image at a time. Lives on the UI thread.
class PlanarLoader : public QObject {
    Q_OBJECT

  public:
    explicit PlanarLoader(QObject* parent = nullptr);

    // Forgets what it has. Null: nothing.
    void setSeries(std::shared_ptr<const study::FoundVolumes> found, const dicom::Stack* stack);
    // `loaded` or `failed` follows, later or at once; a newer demand replaces one that waits.
    void ask(std::size_t place);
    // Also decodes these, as far as memory goes, while nothing is asked for.
    void readAhead(const study::PlanarLoop& loop);
    // Decoded images beyond are let go, the farthest from the newest first; it is kept.
    void setMostBytes(std::size_t bytes) { mostBytes_ = bytes; }
    bool has(std::size_t place) const { return images_.contains(place); }

  Q_SIGNALS:
    void loaded(const macula::viewer::LoadedImage& image);
    void failed(std::size_t place, const macula::Error& error);

  private:
    std::shared_ptr<const dicom::PlanarHeader> headerOf(
        const dicom::Frame& frame) const;  // null: not read yet
    void startNext();
    std::optional<std::size_t> nextAhead() const;
    void take(const Result<LoadedImage>& image);
    void keep(const LoadedImage& image);

    std::shared_ptr<const study::FoundVolumes> found_;
    const dicom::Stack* stack_ = nullptr;
    // Of a file, or of each of its frames (PlanarHeader::isOfFrame).
    std::map<std::pair<const dicom::Instance*, int>, std::shared_ptr<const dicom::PlanarHeader>> headers_;
    std::map<std::size_t, LoadedImage> images_;
    std::size_t bytes_ = 0;
    std::size_t mostBytes_ = std::size_t{1} << 30;
    std::optional<std::size_t> asked_;
    std::optional<std::size_t> loading_;
    study::PlanarLoop ahead_;
    std::optional<std::size_t> failedAhead_;
    BackgroundJob<LoadedImage> job_;
};

}  // namespace macula::viewer
