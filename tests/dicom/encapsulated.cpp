#include "encapsulated.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <gtest/gtest.h>
#include <openjpeg.h>

#include <cstring>
#include <mutex>

#include "bytes.h"
#include "dicom/read/dataset.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::dicom::test {

namespace {

void registerEncoders() {
    static std::once_flag once;
    std::call_once(once, [] {
        silenceToolkit();
        DcmRLEEncoderRegistration::registerCodecs();
        DJEncoderRegistration::registerCodecs();
        DJLSEncoderRegistration::registerCodecs();
    });
}

}  // namespace

std::string encodeJpeg2000(int columns, int rows, int bits, const std::vector<std::uint16_t>& cells,
                           int tileSize) {
    opj_cparameters_t parameters;
    opj_set_default_encoder_parameters(&parameters);
    parameters.tcp_numlayers = 1;
    parameters.cp_disto_alloc = 1;
    parameters.numresolution = 3;
    if (tileSize > 0) {
        parameters.tile_size_on = OPJ_TRUE;
        parameters.cp_tdx = parameters.cp_tdy = tileSize;
    }
    opj_image_cmptparm_t component{};
    component.dx = component.dy = 1;
    component.w = static_cast<OPJ_UINT32>(columns);
    component.h = static_cast<OPJ_UINT32>(rows);
    component.prec = static_cast<OPJ_UINT32>(bits);
    opj_image_t* image = opj_image_create(1, &component, OPJ_CLRSPC_GRAY);
    image->x1 = component.w;
    image->y1 = component.h;
    std::copy(cells.begin(), cells.end(), image->comps[0].data);
    opj_codec_t* codec = opj_create_compress(OPJ_CODEC_J2K);
    opj_stream_t* stream = opj_stream_default_create(OPJ_FALSE);
    struct Sink {
        std::string bytes;
        std::size_t at = 0;
    } sink;
    opj_stream_set_user_data(stream, &sink, nullptr);
    opj_stream_set_write_function(stream, [](void* data, OPJ_SIZE_T count, void* user) -> OPJ_SIZE_T {
        Sink& s = *static_cast<Sink*>(user);
        s.bytes.resize(std::max(s.bytes.size(), s.at + count));
        std::memcpy(s.bytes.data() + s.at, data, count);
        s.at += count;
        return count;
    });
    opj_stream_set_seek_function(stream, [](OPJ_OFF_T to, void* user) -> OPJ_BOOL {
        static_cast<Sink*>(user)->at = static_cast<std::size_t>(to);
        return OPJ_TRUE;
    });
    EXPECT_TRUE(opj_setup_encoder(codec, &parameters, image) && opj_start_compress(codec, image, stream) &&
                opj_encode(codec, stream) && opj_end_compress(codec, stream));
    opj_stream_destroy(stream);
    opj_destroy_codec(codec);
    opj_image_destroy(image);
    return sink.bytes;
}

std::string encode(const char* transferSyntaxUid, int columns, int rows, int bits,
                   const std::vector<std::uint16_t>& cells) {
    if (std::string_view(transferSyntaxUid) == kJpeg2000) return encodeJpeg2000(columns, rows, bits, cells);
    registerEncoders();
    DcmDataset dataset;
    const auto put = [&](const DcmTagKey& key, int value) {
        EXPECT_TRUE(dataset.putAndInsertUint16(key, static_cast<Uint16>(value)).good());
    };
    put(DCM_Rows, rows);
    put(DCM_Columns, columns);
    put(DCM_SamplesPerPixel, 1);
    put(DCM_BitsAllocated, bits <= 8 ? 8 : 16);
    put(DCM_BitsStored, bits);
    put(DCM_HighBit, bits - 1);
    put(DCM_PixelRepresentation, 0);
    dataset.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME2");
    dataset.putAndInsertString(DCM_SOPClassUID, UID_CTImageStorage);
    dataset.putAndInsertString(DCM_SOPInstanceUID, "1.2.3");
    if (bits <= 8) {
        const std::vector<Uint8> bytes(cells.begin(), cells.end());
        EXPECT_TRUE(dataset.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size()).good());
    } else {
        EXPECT_TRUE(dataset.putAndInsertUint16Array(DCM_PixelData, cells.data(), cells.size()).good());
    }
    const E_TransferSyntax syntax = DcmXfer(transferSyntaxUid).getXfer();
    EXPECT_TRUE(dataset.chooseRepresentation(syntax, nullptr).good());
    DcmElement* element = nullptr;
    DcmPixelSequence* items = nullptr;
    DcmPixelItem* item = nullptr;
    Uint8* bytes = nullptr;
    EXPECT_TRUE(dataset.findAndGetElement(DCM_PixelData, element).good());
    EXPECT_TRUE(
        dynamic_cast<DcmPixelData&>(*element).getEncapsulatedRepresentation(syntax, nullptr, items).good());
    EXPECT_EQ(items->card(), 2u);
    EXPECT_TRUE(items->getItem(item, 1).good() && item->getUint8Array(bytes).good());
    return {reinterpret_cast<const char*>(bytes), item->getLength()};
}

std::string imageHeader(const PixelLayout& layout) {
    const auto word = [](Tag tag, int value) {
        return shortElement(tag, "US", bytesOf(static_cast<std::uint64_t>(value), 2));
    };
    std::string bytes = preamble(layout.transferSyntaxUid) + sopClass() + word(tag::kSamplesPerPixel, 1) +
                        shortElement(tag::kNumberOfFrames, "IS", std::to_string(layout.frames)) +
                        word(tag::kRows, layout.rows) + word(tag::kColumns, layout.columns) +
                        word(tag::kBitsAllocated, layout.format.bitsAllocated);
    if (layout.format.kind == CellKind::integer) {
        bytes += word(tag::kBitsStored, layout.format.bitsStored) +
                 word(tag::kHighBit, layout.format.highBit) +
                 word(tag::kPixelRepresentation, layout.format.isSigned ? 1 : 0);
    }
    return bytes;
}

Fragments cut(const std::vector<std::string>& streams, std::size_t fragmentsEach) {
    Fragments result;
    std::uint64_t offset = 0;
    for (std::string stream : streams) {
        if (stream.size() % 2) stream += '\0';
        const std::size_t step = stream.size() / fragmentsEach / 2 * 2;
        result.offsets.push_back(offset);
        for (std::size_t i = 0; i < fragmentsEach; ++i) {
            const std::size_t end = i + 1 < fragmentsEach ? (i + 1) * step : stream.size();
            result.fragments.push_back(stream.substr(i * step, end - i * step));
            offset += 8 + result.fragments.back().size();
        }
    }
    return result;
}

std::string encapsulated(const std::vector<std::string>& fragments, const std::string& offsetTable) {
    std::string bytes =
        longElement(tag::kPixelData, "OB", kUndefined) + kItem + bytesOf(offsetTable.size(), 4) + offsetTable;
    for (const std::string& fragment : fragments) bytes += kItem + bytesOf(fragment.size(), 4) + fragment;
    return bytes + kSequenceEnd;
}

std::string basicOffsets(const Fragments& fragments) {
    std::string table;
    for (const std::uint64_t offset : fragments.offsets) table += bytesOf(offset, 4);
    return table;
}

}  // namespace macula::dicom::test
