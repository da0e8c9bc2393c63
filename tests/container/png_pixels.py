"""Reads PNG pixels with the standard library alone: 8 bits a channel, RGB or RGBA, not interlaced, which is what a still is."""
import struct
import zlib

CHANNELS = {2: 3, 6: 4}  # PNG colour type: channels (PNG specification, table 11.1)


def chunks(data):
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError(f"not a PNG: it begins with {data[:8]!r}")
    at = 8
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        yield kind, data[at + 8:at + 8 + length]
        at += 12 + length


def paeth(left, up, up_left):
    distances = [(abs(up - up_left), left), (abs(left - up_left), up), (abs(left + up - 2 * up_left), up_left)]
    return min(distances, key=lambda distance: distance[0])[1]


def unfilter(kind, row, above, channels):
    """Undoes one of the five row filters of PNG (section 9.2) in place."""
    for i in range(len(row)):
        left, up = (row[i - channels] if i >= channels else 0), above[i]
        up_left = above[i - channels] if i >= channels else 0
        row[i] = (row[i] + (0, left, up, (left + up) // 2, paeth(left, up, up_left))[kind]) & 255


def read_png(data):
    """(width, height, rows of (r, g, b))"""
    header, pixels = None, b""
    for kind, body in chunks(data):
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            pixels += body
    width, height, depth, colour, _, _, interlace = header
    if depth != 8 or colour not in CHANNELS or interlace:
        raise ValueError(f"a PNG of {depth} bits, colour type {colour}, interlace {interlace}")
    channels, raw = CHANNELS[colour], zlib.decompress(pixels)
    stride, above, rows = width * channels, bytearray(width * channels), []
    for y in range(height):
        start = y * (stride + 1)
        row = bytearray(raw[start + 1:start + 1 + stride])
        unfilter(raw[start], row, above, channels)
        rows.append([tuple(row[x:x + 3]) for x in range(0, stride, channels)])
        above = row
    return width, height, rows
