// The picture of a slice that a pane shows, and the one that it has requested.
#pragma once

#include <QObject>
#include <cstdint>
#include <memory>
#include <optional>

#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

// Another thread makes the pictures: the old one stays until the next. Lives on the UI thread.
class PanePicture : public QObject {
    Q_OBJECT

  public:
    PanePicture();
    ~PanePicture() override;

    // Removes the picture and releases its volume; pictures requested before no longer arrive.
    void forget();
    // Requests a picture, and sets its `study`. If only the cross-hair differs from the last request, makes
    // no new picture: the cross-hair is drawn over it.
    void ask(SliceRequest request);

    // The picture on screen; null: none.
    const SlicePicture* shown() const { return shown_ ? &*shown_ : nullptr; }
    // The request of that picture; null: none.
    const SliceRequest* shownRequest() const { return shown_ ? &shown_->of : nullptr; }
    const SliceRequest* wanted() const { return wanted_ ? &*wanted_ : nullptr; }
    bool isUpToDate() const;

  Q_SIGNALS:
    void arrived();  // shown() is a new picture

  private:
    void take(SlicePicture picture);

    std::uint64_t study_ = 0;  // counts forget(): pictures of an earlier count are dropped
    std::optional<SliceRequest> wanted_;
    std::optional<SlicePicture> shown_;
    std::unique_ptr<SliceSampler> sampler_;
};

}  // namespace macula::viewer
