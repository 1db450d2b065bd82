"""PNG files of 8-bit RGBA, without other packages."""

import os
import struct
import tempfile
import zlib


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write(path, width, height, rgba, texts):
    """Written whole or not at all. `texts`: what the picture says of itself, by keyword."""
    row = 4 * width
    lines = b"".join(b"\0" + bytes(rgba[y * row:(y + 1) * row]) for y in range(height))
    told = [_chunk(b"iTXt", key.encode("latin-1") + b"\0\0\0\0\0" + text.encode()) for key, text in texts.items()]
    data = b"\x89PNG\r\n\x1a\n" + b"".join([
        _chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)), _chunk(b"sRGB", b"\0"), *told,
        _chunk(b"IDAT", zlib.compress(lines)), _chunk(b"IEND", b"")])
    path = os.fspath(path)
    handle, draft = tempfile.mkstemp(dir=os.path.dirname(path) or ".", prefix=".macula-")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        os.replace(draft, path)
    except BaseException:
        os.unlink(draft)
        raise
