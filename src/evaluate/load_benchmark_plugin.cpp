#include "evaluate/load_benchmark.h"

#include "base/itk_for_clang.h"

// DCMTK is included before ITK, because both define macros for the platform.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <gdcmTrace.h>
#include <itkGDCMImageIO.h>
#include <itkImage.h>
#include <itkImageSeriesReader.h>
#include <itkMultiThreaderBase.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <thread>

#include "dicom/read/dataset.h"
#include "evaluate/measurement.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::evaluate {

namespace {

namespace fs = std::filesystem;
using FloatImage = itk::Image<float, 3>;
using ShortImage = itk::Image<short, 3>;

// Reads a line of /proc/self/status that is in kB; returns bytes, 0 without such a line.
std::uint64_t ownMemory(std::string_view name) {
    std::ifstream stream("/proc/self/status");
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with(name)) return std::stoull(line.substr(name.size() + 1)) * 1024;
    }
    return 0;
}

// Resets VmHWM, the peak of resident memory.
void forgetPeak() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
}

struct Timed {
    Contender spent;
    std::uint64_t peakBytes = 0;
    bool works = true;

    template <class Work>
    void run(bool counts, const Work& work) {
        if (!works) return;
        forgetPeak();
        Watch watch;
        try {
            works = work();
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception&) {  // ITK throws if it cannot read a file
            works = false;
        }
        const Spent taken = watch.lap();
        if (!counts) return;
        spent.turns.push_back(taken);
        peakBytes = std::max(peakBytes, ownMemory("VmHWM:"));
    }
};

Loading summarise(const Timed& timed, const Timed& ours) {
    return {.seconds = timed.spent.medians().wallMs / 1e3,
            .peakBytes = timed.peakBytes,
            .secondsOverOurs = timed.spent.ratioTo(ours.spent).wall};
}

template <class Image>
typename Image::Pointer readWithItk(const std::vector<std::string>& files) {
    auto reader = itk::ImageSeriesReader<Image>::New();
    reader->SetImageIO(itk::GDCMImageIO::New());
    reader->SetFileNames(files);
    reader->Update();
    return reader->GetOutput();
}

// Whether a user of ITK would read integers: if the file has them.
bool hasShorts(const std::string& file) {
    auto io = itk::GDCMImageIO::New();
    io->SetFileName(file);
    io->ReadImageInformation();
    const auto type = io->GetComponentType();
    return type == itk::IOComponentEnum::SHORT || type == itk::IOComponentEnum::UCHAR ||
           type == itk::IOComponentEnum::CHAR;
}

template <class Image>
std::size_t differing(const Image& image, const Volume& volume) {
    const auto size = image.GetLargestPossibleRegion().GetSize();
    const glm::ivec3 ours = volume.size();
    const std::size_t count = volume.voxelCount();
    if (int(size[0]) != ours.x || int(size[1]) != ours.y || int(size[2]) != ours.z) return count;
    const auto* values = image.GetBufferPointer();
    std::size_t different = 0;
    std::size_t n = 0;
    for (int k = 0; k < ours.z; ++k) {
        for (int j = 0; j < ours.y; ++j) {
            for (int i = 0; i < ours.x; ++i, ++n) {
                // Ignores the last bits of float32.
                const double value = volume.value(i, j, k);
                const bool same = std::abs(double(values[n]) - value) <= 1e-6 * std::abs(value);
                different += same ? 0 : 1;
            }
        }
    }
    return different;
}

bool decodeWithDcmtk(const fs::path& file, std::uint16_t* cells, std::size_t count) {
    DcmFileFormat format;
    if (format.loadFile(file.c_str()).bad()) return false;
    DcmDataset* dataset = format.getDataset();
    if (dataset->chooseRepresentation(EXS_LittleEndianExplicit, nullptr).bad()) return false;
    const Uint16* values = nullptr;
    unsigned long length = 0;
    if (dataset->findAndGetUint16Array(DCM_PixelData, values, &length).bad() || length < count) return false;
    std::copy_n(values, count, cells);
    return true;
}

bool readWithDcmtk(const std::vector<fs::path>& files, std::size_t threads,
                   std::vector<std::uint16_t>& cells) {
    const std::size_t sliceCells = cells.size() / files.size();
    std::atomic<std::size_t> next{0};
    std::atomic<bool> works{true};
    {
        std::vector<std::jthread> workers;
        for (std::size_t t = 0; t < threads; ++t) {
            workers.emplace_back([&] {
                for (std::size_t n = next++; n < files.size() && works; n = next++) {
                    if (!decodeWithDcmtk(files[n], cells.data() + n * sliceCells, sliceCells)) works = false;
                }
            });
        }
    }
    return works;
}

}  // namespace

namespace {

Result<LoadBenchmark> measure(const LoadBenchmarkOptions& options, Progress& progress) try {
    silenceToolkit();
    itk::Object::GlobalWarningDisplayOff();
    DcmRLEDecoderRegistration::registerCodecs();
    DJDecoderRegistration::registerCodecs();
    DJLSDecoderRegistration::registerCodecs();
    gdcm::Trace::WarningOff();  // it prints values from headers
    gdcm::Trace::ErrorOff();
    const auto threads = static_cast<unsigned>(std::max<std::size_t>(options.threads, 1));
    itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(threads);
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
    std::vector<std::string> names;
    for (const fs::path& file : options.files) names.push_back(file.string());

    LoadBenchmark result;
    Timed ours, itks, dcmtks;
    bool shorts = true;
    progress.beginStage(Text("Loading in turns"), 3 * static_cast<std::size_t>(options.rounds + 1));
    for (int round = 0; round <= options.rounds; ++round) {
        const bool counts = round > 0;
        malloc_trim(0);
        result.bytesBefore = ownMemory("VmRSS:");
        std::optional<Error> failure;
        std::shared_ptr<const Volume> volume;
        ours.run(counts, [&] {
            Progress quiet({}, progress.token());
            auto loaded = options.load(quiet);
            if (!loaded)
                failure = loaded.error();
            else
                volume = *loaded;
            return loaded.ok();
        });
        if (failure) return *failure;
        result.voxels = volume->voxelCount();
        progress.advance();
        if (round == 0) {  // values are compared once, and then the volume is freed
            try {
                shorts = hasShorts(names.at(0));
                if (shorts)
                    result.differingVoxels = differing(*readWithItk<ShortImage>(names), *volume);
                else
                    result.differingVoxels = differing(*readWithItk<FloatImage>(names), *volume);
            } catch (const std::exception&) {
                itks.works = false;
            }
        }
        volume.reset();
        if (counts) {
            itks.run(counts, [&] {
                if (shorts) return readWithItk<ShortImage>(names).IsNotNull();
                return readWithItk<FloatImage>(names).IsNotNull();
            });
        }
        progress.advance();
        dcmtks.run(counts, [&] {
            std::vector<std::uint16_t> cells(result.voxels);
            return !options.files.empty() && readWithDcmtk(options.files, threads, cells);
        });
        progress.advance();
        if (progress.cancelled())
            return Error{ErrorCode::cancelled, Text("Measuring was cancelled."), {}, {}};
    }
    result.ours = summarise(ours, ours);
    if (itks.works) result.itk = summarise(itks, ours);
    if (dcmtks.works) result.dcmtk = summarise(dcmtks, ours);
    return result;
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory,
                 Text("There is not enough memory to measure."),
                 {},
                 Text("Choose a smaller series.")};
} catch (const std::exception&) {
    return Error{ErrorCode::inputNotUsable,
                 Text("The series cannot be read by all contenders."),
                 {},
                 Text("Choose another series.")};
}

}  // namespace

}  // namespace macula::evaluate

void maculaBenchmarkLoading(const macula::evaluate::LoadBenchmarkOptions& options, macula::Progress& progress,
                            macula::Result<macula::evaluate::LoadBenchmark>& result) {
    result = macula::evaluate::measure(options, progress);
}
