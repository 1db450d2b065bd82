// lister FOLDER: the series of a folder, a line each, and the volume that would be shown. What a patient is
// called stays out of it.
#include <cstdio>

#include "dicom/best_volume.h"
#include "dicom/scan.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("lister FOLDER\n", stderr);
        return 2;
    }
    macula::Progress progress;
    const auto scan = macula::dicom::scanFolder(argv[1], progress);
    if (!scan) {
        std::fprintf(stderr, "lister: %s %s\n", scan.error().message.english().c_str(),
                     scan.error().hint.english().c_str());
        return 1;
    }
    std::size_t volumes = 0;
    for (const macula::dicom::Study& study : scan->studies) {
        for (const macula::dicom::Series& series : study.series) {
            std::printf("patient %d, %s: %zu images in %zu stacks%s\n", study.patient + 1,
                        series.modality.empty() ? "no modality" : series.modality.c_str(), series.instances,
                        series.stacks.size(), series.canBeVolume() ? ", a volume" : "");
            volumes += series.canBeVolume() ? 1 : 0;
            for (const macula::Message& message : series.messages)
                std::printf("  %s\n", message.sentence.english().c_str());
        }
    }
    for (const macula::dicom::SkippedFile& skipped : scan->skipped)
        std::printf("left out: %s\n", skipped.message.sentence.english().c_str());
    const macula::dicom::ChosenStack best = macula::dicom::bestVolume(*scan);
    std::printf("%s\n", best.why.english().c_str());
    return volumes > 0 && best ? 0 : 1;
}
