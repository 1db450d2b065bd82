// Draws small pictures of the open volume in the background, one preset at a time.
#pragma once

#include <QImage>
#include <QObject>
#include <memory>

#include "pictures/preset_thumbnail.h"
#include "viewer/jobs/background_job.h"
#include "viewer/presets/preset_library.h"

namespace macula::viewer {

// Draws on the CPU, from a coarse copy of the volume. Lives on the UI thread.
class PresetPictures : public QObject {
    Q_OBJECT

  public:
    PresetPictures();

    // Starts over with another volume; null: none. Cancels the picture that is being drawn.
    void begin(std::shared_ptr<const Volume> volume);
    bool isDrawing() const { return drawing_ != nullptr; }
    bool hasNone() const { return hasNone_; }  // there are no pictures of this volume
    bool canDraw() const { return volume_ && !isDrawing() && !hasNone_; }
    void draw(const LibraryPreset& preset);

  Q_SIGNALS:
    // A null image: this preset has none.
    void drawn(std::shared_ptr<const macula::TransferFunction> function, const QImage& picture);
    void failed(const macula::Error& error);  // then hasNone()

  private:
    struct Drawn {
        std::shared_ptr<const pictures::CoarseVolume> coarse;  // reused for the next pictures
        QImage picture;
    };
    void take(const Result<Drawn>& made);

    std::shared_ptr<const Volume> volume_;
    std::shared_ptr<const pictures::CoarseVolume> coarse_;
    bool hasNone_ = false;
    std::shared_ptr<const TransferFunction> drawing_;
    BackgroundJob<Drawn> job_;
};

}  // namespace macula::viewer
