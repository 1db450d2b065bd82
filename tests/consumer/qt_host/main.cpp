// A window of another program that shows a study: qt_host [FOLDER]
#include "viewer/volume/viewer_widget.h"  // before Qt

#include <QApplication>
#include <QSplitter>

#include "viewer/slices/slice_view.h"
#include "viewer/transfer/transfer_function_editor.h"
#include "viewer/volume/study_loader.h"

using namespace macula;

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    const auto fail = [](const Error& error) {
        qWarning("%s %s", error.message.english().c_str(), error.hint.english().c_str());
        QCoreApplication::exit(1);
        return 1;
    };
    auto catalogue = scene::builtInCatalogue();
    if (!catalogue) return fail(catalogue.error());
    auto instance = viewer::createInstanceForWindows();
    if (!instance) return fail(instance.error());

    viewer::StudyEditor session(*std::move(catalogue));
    QSplitter window;
    window.addWidget(new viewer::SliceView(session, slices::Orientation::axial));
    window.addWidget(new viewer::ViewerWidget(session, *std::move(instance)));
    window.addWidget(new viewer::TransferFunctionEditor(session));
    viewer::StudyLoader loader;
    QObject::connect(&loader, &viewer::StudyLoader::loaded,
                     [&](const study::OpenedStudy& study) { session.show(study); });
    QObject::connect(&loader, &viewer::StudyLoader::failed, fail);
    loader.open(argc > 1 ? study::StudySource(argv[1]) : std::nullopt);
    window.resize(1200, 500);
    window.show();
    return application.exec();
}
