#include "edit.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>
#include "toolkit/quiet_toolkit.h"

namespace macula::dicom::test {

namespace {

void edit(const std::filesystem::path& file, const std::function<OFCondition(DcmDataset&)>& change) {
    silenceToolkit();
    DcmFileFormat format;
    ASSERT_TRUE(format.loadFile(file.c_str()).good());
    ASSERT_TRUE(format.loadAllDataIntoMemory().good());
    ASSERT_TRUE(change(*format.getDataset()).good());
    ASSERT_TRUE(format.saveFile(file.c_str(), format.getDataset()->getOriginalXfer()).good());
}

DcmTagKey keyOf(Tag tag) {
    return DcmTagKey(tag.group, tag.element);
}

}  // namespace

void setText(const std::filesystem::path& file, Tag tag, const std::string& value) {
    edit(file, [&](DcmDataset& dataset) { return dataset.putAndInsertString(keyOf(tag), value.c_str()); });
}

void setWord(const std::filesystem::path& file, Tag tag, std::uint16_t value) {
    edit(file,
         [&](DcmDataset& dataset) { return dataset.putAndInsertUint16(DcmTag(keyOf(tag), EVR_US), value); });
}

void remove(const std::filesystem::path& file, Tag tag) {
    edit(file, [&](DcmDataset& dataset) { return dataset.findAndDeleteElement(keyOf(tag)); });
}

void setPixels(const std::filesystem::path& file, const std::vector<std::uint16_t>& cells) {
    edit(file, [&](DcmDataset& dataset) {
        return dataset.putAndInsertUint16Array(DCM_PixelData, cells.data(),
                                               static_cast<unsigned long>(cells.size()));
    });
}

void saveWithEightBits(const std::filesystem::path& file, int bitsAllocated,
                       const std::vector<std::uint8_t>& values, WriteSyntax syntax) {
    silenceToolkit();
    DcmFileFormat format;
    ASSERT_TRUE(format.loadFile(file.c_str()).good());
    ASSERT_TRUE(format.loadAllDataIntoMemory().good());
    DcmDataset& dataset = *format.getDataset();
    ASSERT_TRUE(dataset.putAndInsertUint16(DCM_BitsStored, 8).good());
    ASSERT_TRUE(dataset.putAndInsertUint16(DCM_HighBit, 7).good());
    const bool compressed = syntax == WriteSyntax::jpegLossless || syntax == WriteSyntax::jpegLs;
    const bool encodeBytes = bitsAllocated == 8 || compressed;
    ASSERT_TRUE(dataset.putAndInsertUint16(DCM_BitsAllocated, encodeBytes ? 8 : 16).good());
    if (encodeBytes) {
        ASSERT_TRUE(dataset.putAndInsertUint8Array(DCM_PixelData, values.data(), values.size()).good());
    } else {
        const std::vector<Uint16> cells(values.begin(), values.end());
        ASSERT_TRUE(dataset.putAndInsertUint16Array(DCM_PixelData, cells.data(), cells.size()).good());
    }
    const E_TransferSyntax xfer = syntax == WriteSyntax::jpegLossless ? EXS_JPEGProcess14SV1
                                  : syntax == WriteSyntax::jpegLs     ? EXS_JPEGLSLossless
                                  : syntax == WriteSyntax::rle        ? EXS_RLELossless
                                                                      : EXS_LittleEndianExplicit;
    ASSERT_TRUE(dataset.chooseRepresentation(xfer, nullptr).good());
    // What some encoders make, and DCMTK's does not: cells of 16 bits with a stream of 8-bit samples.
    ASSERT_TRUE(dataset.putAndInsertUint16(DCM_BitsAllocated, static_cast<Uint16>(bitsAllocated)).good());
    ASSERT_TRUE(format.saveFile(file.c_str(), xfer).good());
}

void saveBare(const std::filesystem::path& file) {
    silenceToolkit();
    DcmFileFormat format;
    ASSERT_TRUE(format.loadFile(file.c_str()).good());
    ASSERT_TRUE(format.loadAllDataIntoMemory().good());
    ASSERT_TRUE(format
                    .saveFile(file.c_str(), EXS_LittleEndianImplicit, EET_ExplicitLength, EGL_recalcGL,
                              EPD_noChange, 0, 0, EWM_dataset)
                    .good());
}

void truncate(const std::filesystem::path& file, std::size_t bytesLess) {
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - bytesLess);
}

}  // namespace macula::dicom::test
