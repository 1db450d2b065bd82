// Widgets of Macula in a window of this program.
#include <viewer/volume/viewer_widget.h>  // before Qt

#include <viewer/slices/slice_view.h>

#include <QApplication>

#include "ends.h"

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    auto catalogue = macula::scene::builtInCatalogue();
    if (!catalogue) return fail(catalogue.error());
    macula::viewer::StudyEditor session(*std::move(catalogue));
    macula::viewer::SliceView axial(session, macula::slices::Orientation::axial);
    axial.resize(320, 240);
    return expect(!axial.grab().isNull(), "an empty slice view");
}
