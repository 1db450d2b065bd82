#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/documents/key_images_controller.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <utility>

#include "viewer/browser/study_browser.h"
#include "viewer/documents/documents_controller.h"
#include "viewer/keys/keys.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

KeyImagesController::KeyImagesController(const WindowContext& context, const Uses& uses)
    : QObject(&context.window),
      context_(context),
      uses_(uses),
      finding_(this, {.ended = [this](const Result<Found>& keys) { take(keys); }}) {
    connect(&uses_.browser, &StudyBrowser::listed, this, &KeyImagesController::onListed);
}

void KeyImagesController::addActions(QMenu& view) {
    next_ = view.addAction(tr("Next &Key Image"), this, [this] { step(1); });
    next_->setShortcut(keyOf(KeyAction::nextKeyImage));
    describe(*next_, "next-key-image", tr("The next image that a selection of key images names"));
    previous_ = view.addAction(tr("Previous Key Image"), this, [this] { step(-1); });
    describe(*previous_, "previous-key-image", tr("The key image before"));
    for (QAction* action : {next_, previous_}) action->setEnabled(false);
}

void KeyImagesController::onListed() {
    finding_.cancel();
    keys_.reset();
    shown_.reset();
    for (QAction* action : {next_, previous_})
        if (action != nullptr) action->setEnabled(false);
    found_ = uses_.browser.found();
    if (!found_ || !found_->isWhole()) return;
    finding_.start([found = found_](Progress& progress) -> Result<Found> {
        MACULA_TRY(study::KeyImages keys, study::findKeyImages(*found, progress));
        return std::make_shared<const study::KeyImages>(std::move(keys));
    });
}

void KeyImagesController::take(const Result<Found>& keys) {
    if (!keys || (*keys)->images().empty() || found_ != uses_.browser.found()) return;
    keys_ = *keys;
    const bool canStep = !keys_->inOrder().empty();
    for (QAction* action : {next_, previous_})
        if (action != nullptr) action->setEnabled(canStep);
    uses_.browser.setKeyImages(keys_);
}

void KeyImagesController::step(int by) {
    if (!keys_) return;
    const std::vector<std::size_t> places = keys_->inOrder();
    if (places.empty()) return;
    const std::size_t count = places.size();
    shown_ = shown_ ? (*shown_ + count + std::size_t(by < 0 ? count - 1 : 1)) % count
                    : std::size_t(by < 0 ? count - 1 : 0);
    const study::KeyImage& image = keys_->images()[places[*shown_]];
    uses_.documents.goTo(found_, image.place);
    context_.notifications.showNote(tr("Key image %1 of %2: %3")
                                        .arg(*shown_ + 1)
                                        .arg(count)
                                        .arg(harmless(inWindowsLanguage(nameOf(image.place)))));
}

}  // namespace macula::viewer
